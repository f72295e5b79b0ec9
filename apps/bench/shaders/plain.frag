// SPDX-License-Identifier: Apache-2.0
// A surface lit by all lights, in fog that carried lights light.

#include "plain_lights.glsl"

in vec3 position;
in vec3 normal;
in vec4 tangent;
in vec2 uv;

uniform sampler2D albedo_map;
uniform sampler2D normal_map;
uniform vec3 eye;
uniform vec3 ambient_light;
uniform vec3 moon_direction;
uniform vec3 moon_color;
uniform vec3 specular;
uniform vec3 emissive;
uniform float shininess;

out vec4 color;

vec3 mapped_normal() {
  vec4 texel = texture(normal_map, uv);
  vec3 bump = texel.xyz * 2.0 - (256.0 - floor(texel.a + 0.5 / 255.0)) / 255.0;
  vec3 n = normalize(normal);
  vec3 t = normalize(tangent.xyz);
  vec3 b = normalize(cross(n, t)) * tangent.w;
  return normalize(mat3(t, b, n) * bump);
}

void main() {
  vec4 albedo = texture(albedo_map, uv);
  vec3 n = mapped_normal();
  vec3 to_eye = normalize(eye - position);
  vec3 shine = specular * albedo.a;
  vec3 lit = emissive + albedo.rgb * ambient_light;
  float moon = dot(n, moon_direction);
  if (moon > 0.0) {
    float facing = max(dot(n, normalize(moon_direction + to_eye)), 0.0);
    lit += moon_color * (albedo.rgb * moon + shine * pow(facing, shininess));
  }
  vec3 fog = ambient_fog_color;
  for (int i = 0; i < LIGHT_COUNT; ++i) {
    LitfogLight light = light_at(i);
    vec3 to_light = light.position_extent.xyz - position;
    float range = length(to_light);
    to_light /= range;
    vec3 sent = light.color_intensity.rgb * litfog_cone(light, -to_light);
    fog += sent * light.color_intensity.w;
    float diffuse = dot(n, to_light);
    if (diffuse > 0.0 && range <= light.position_extent.w) {
      vec3 falloff = light.attenuation.xyz;
      float attenuation = 1.0 / max(falloff.x + range * (falloff.y + range * falloff.z), 1.0);
      float facing = max(dot(n, normalize(to_light + to_eye)), 0.0);
      lit += sent * attenuation * (albedo.rgb * diffuse + shine * pow(facing, shininess));
    }
  }
  color = vec4(mix(fog, lit, fog_factor(distance(position, eye))), 1.0);
}
