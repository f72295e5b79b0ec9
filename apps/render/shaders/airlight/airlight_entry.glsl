// SPDX-License-Identifier: Apache-2.0
// The lights whose airlight is drawn: render::AirlightEntry.

#include "cookie.glsl"
#include "litfog/shaders/light_airlight.glsl"
#include "litfog/shaders/light_buffer.glsl"

uniform samplerBuffer airlight_entries;  // light, reach, width; bend_ranges
uniform int pixel_step;                  // pixels between the target's texels, half as many as in the coarser grid

struct AirlightEntry {
  int light;
  float reach;
  float width;
  vec3 bend_ranges;
};

AirlightEntry airlight_entry(int i) {
  vec4 first = texelFetch(airlight_entries, 2 * i);
  return AirlightEntry(int(first.x), first.y, first.z, texelFetch(airlight_entries, 2 * i + 1).xyz);
}

// Range from a light within which a grid leaves out part of its airlight, which bends too much for lines between
// texels; 0 where the airlight is flat there.
float left_out_range(AirlightEntry entry, int grid_step) {
  float range = grid_step > 4 ? entry.bend_ranges.z : grid_step > 2 ? entry.bend_ranges.y : entry.bend_ranges.x;
  return range > entry.width ? range : 0.0;
}
