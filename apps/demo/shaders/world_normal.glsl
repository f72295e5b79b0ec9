// SPDX-License-Identifier: Apache-2.0
// The normal map's normal in world space, by the interpolated basis (Lacroix 2005, listing 2.3). Its vectors are unit at the
// vertices and not made so again between them, which is how normal maps are baked (MikkTSpace).

#include "rasterised.glsl"

in vec3 normal;
in vec4 tangent;

vec3 mapped_world_normal() {
  vec3 bump = mapped_normal();
  vec3 bitangent = cross(normal, tangent.xyz) * tangent.w;
  return normalize(tangent.xyz * bump.x + bitangent * bump.y + normal * bump.z);
}
