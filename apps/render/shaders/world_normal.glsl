// SPDX-License-Identifier: Apache-2.0
// The normal map's normal in world space by the interpolated basis, normalised (Jason Lacroix 2005, "Let There Be
// Light!: A Unified Lighting Technique for a New Generation of Games", listing 2.3).

#include "rasterised.glsl"

in vec3 normal;
in vec4 tangent;

vec3 mapped_world_normal() {
  vec3 bump = mapped_normal();
  vec3 n = normalize(normal);
  vec3 t = normalize(tangent.xyz);
  vec3 b = normalize(cross(n, t)) * tangent.w;
  return normalize(t * bump.x + b * bump.y + n * bump.z);
}
