// SPDX-License-Identifier: Apache-2.0
// litfog: the Basic model of Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial", section 5.2: emissive + ambient
// + sum over lights of diffuse + specular. Specular is 0 where diffuse is. Lights are attenuated by range (5.5.1) and
// cone (5.5.2).

#ifndef LITFOG_SURFACE_GLSL
#define LITFOG_SURFACE_GLSL

#include "litfog/shaders/light.glsl"

struct LitfogSurface {
  vec3 position;
  vec3 normal;  // unit
  vec3 to_eye;  // unit
  vec3 emissive;
  vec3 ambient;  // reflectance of ambient light, usually the diffuse one
  vec3 diffuse;
  vec3 specular;
  float shininess;
};

vec3 litfog_ambient(LitfogSurface surface, vec3 ambient_light) {
  return surface.emissive + surface.ambient * ambient_light;
}

// Diffuse and specular factors of a light in a unit direction (C5E5_computeLighting).
vec2 litfog_reflection_factors(vec3 normal, vec3 to_eye, float shininess, vec3 to_light) {
  float diffuse = dot(normal, to_light);
  if (diffuse <= 0.0) return vec2(0.0);
  vec3 half_vector = to_light + to_eye;  // 0 if they are opposite: no highlight
  float facing = dot(normal, half_vector) * inversesqrt(max(dot(half_vector, half_vector), 1.0e-30));
  return vec2(diffuse, pow(clamp(facing, 0.0, 1.0), shininess));
}

// Reflection of light with a colour from a unit direction.
vec3 litfog_reflect(LitfogSurface surface, vec3 to_light, vec3 color) {
  vec2 factors = litfog_reflection_factors(surface.normal, surface.to_eye, surface.shininess, to_light);
  return color * (surface.diffuse * factors.x + surface.specular * factors.y);
}

// Reflection of a light, without ambient and emissive.
vec3 litfog_light_surface(LitfogSurface surface, LitfogLight light) {
  vec4 ray = litfog_ray(light.position_extent.xyz, surface.position);
  return litfog_reflect(surface, -ray.xyz, litfog_light_along(light, ray));
}

#endif
