// SPDX-License-Identifier: Apache-2.0
// Parallax mapping, which Jason Lacroix 2005, "Let There Be Light!: A Unified Lighting Technique for a New Generation
// of Games", names beside normal maps: "encodes an additional height map value into the normal texture in order to
// simulate the parallax effect". He prints no line of it. This is Terry Welsh 2004, "Parallax Mapping with Offset
// Limiting: A Per-Pixel Approximation of Uneven Surfaces", T_n = T_o + h V_xy, with V the unit vector to the eye in
// tangent space. (Before him it was h V_xy / V_z, which is unbounded at grazing views.) The lighting is that of
// unified.frag.
//
// Heights are true to scale, and the surface is half-way between the lowest and the highest. Parallax mapping shows no
// occlusion, shadows or uneven outline.

#include "depth_test.glsl"
#define texture_uv shifted_uv
vec2 shifted_uv(vec2 coordinates);
#include "path/unified.frag"

vec2 shifted_uv(vec2 coordinates) {
  vec3 to_eye = normalize(vector_to_viewer(fragment_position())) * world_from_tangent();
  float height = (texture(normal_map, map_uvs.xy).a * (255.0 / 254.0) - 0.5) * relief;
  return coordinates + height * to_eye.xy;
}
