// SPDX-License-Identifier: Apache-2.0
// The normal map's normal in world space by the interpolated basis, normalised (Jason Lacroix 2005, "Let There Be
// Light!: A Unified Lighting Technique for a New Generation of Games", listing 2.3).

#include "rasterised.glsl"

in vec3 normal;
in vec4 tangent;

// Tangent, binormal and normal.
mat3 world_from_tangent() {
  vec3 n = normalize(normal);
  vec3 t = normalize(tangent.xyz);
  return mat3(t, normalize(cross(n, t)) * tangent.w, n);
}

vec3 mapped_world_normal() {
  vec3 bump = mapped_normal();
  mat3 basis = world_from_tangent();
  return normalize(basis[0] * bump.x + basis[1] * bump.y + basis[2] * bump.z);
}
