// SPDX-License-Identifier: Apache-2.0
// A surface of the Basic model lit by every lamp, behind the fog. Alpha is 1 over its distance from the eye, in which
// half floats are as exact near as far, and whose mean over a pixel's samples is that of something between them. (The
// depth buffer of one sample would do, but SwiftShader's is wrong where a sliver of a long triangle begins at the eye.)

#define LITFOG_FOG_LIGHTS
#include "carried_fog.glsl"
#include "litfog/shaders/surface.glsl"
#include "world_normal.glsl"

uniform vec3 ambient_light;
uniform bool has_airlight;  // the fog dims lamps on their way to the surface, too

out vec4 color;

void main() {
  vec3 position = fragment_position();
  vec4 albedo = base_texture();
  LitfogSurface surface = LitfogSurface(position, mapped_world_normal(), normalize(eye - position), emissive,
                                        albedo.rgb, albedo.rgb, specular * albedo.a, shininess);
  vec3 lit = litfog_ambient(surface, ambient_light);
  for (int i = 0; i < int(litfog_fog.z); ++i) {
    LitfogLight light = light_at(i);
    vec4 ray = litfog_ray(light.position_extent.xyz, position);
    if (ray.w > light.position_extent.w) continue;
    float through = has_airlight ? litfog_lamp_factor(light, position.y, ray.w) : 1.0;
    lit += litfog_reflect(surface, -ray.xyz, litfog_light_along(light, ray) * through);
  }
  color = vec4(litfog_apply_fog(lit, position, eye), 1.0 / distance(position, eye));
}
