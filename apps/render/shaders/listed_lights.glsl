// SPDX-License-Identifier: Apache-2.0
// The lights of a surface with too many for uniforms, read through the light list.

#include "light_batch.glsl"
#include "light_list.glsl"

uniform ivec2 light_list_range;  // first, count

#ifndef is_hidden  // depth_test.glsl defines it for fragments
#define is_hidden() false
#endif

// A loop over a surface's lights, not unrolled like EACH_LIGHT. Shaders without listed lights lack it, because
// compilers may keep a loop that never runs, and drivers without branches run its body once.
#define EACH_LISTED_LIGHT(DO) \
  if (has_listed_lights) { \
    int listed = is_hidden() ? 0 : light_list_range.y; \
    for (int i = 0; i < listed; ++i) { DO(i) } \
  }

int listed_entry(int i) { return light_entry(light_list_range.x + i); }
LitfogLight listed_light(int i) { return litfog_buffered_light(listed_entry(i)); }

// Whether a surface faces away from a light or is beyond `reach` times its extent. Tested before the rest of the light
// is fetched.
bool is_out_of_reach(int i, vec3 position, vec3 normal, float reach) {
  vec4 position_extent = litfog_buffered_position_extent(listed_entry(i));
  vec3 to_light = position_extent.xyz - position;
  return dot(normal, to_light) <= 0.0 || length(to_light) > position_extent.w * reach;
}
