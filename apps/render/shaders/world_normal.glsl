// SPDX-License-Identifier: Apache-2.0
// The normal map's normal in world space by the interpolated basis, normalised (Jason Lacroix 2005, "Let There Be
// Light!: A Unified Lighting Technique for a New Generation of Games", listing 2.3).
//
// Differences: vertices, not fragments, transform the basis into the world. The product is N_W = N_T T^-1 W, as in his
// equation. The listing multiplies by T: float3x3(tangent, binormal, normal), with these vectors as rows, is T^-1
// already, and the listing transposes it. His binormal, cross(tangent, normal), is that of w = -1; mirrored textures
// need the other, too.

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
