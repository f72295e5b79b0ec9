// SPDX-License-Identifier: Apache-2.0
// The lights whose airlight is drawn: render::AirlightEntry.

#include "cookie.glsl"
#include "litfog/shaders/light_airlight.glsl"
#include "litfog/shaders/light_buffer.glsl"

uniform samplerBuffer airlight_entries;  // light, reach, bend_range, width
uniform bool is_left_out;  // what is drawn of a light is the part that the coarser grid leaves out
uniform int first_entry;   // of those drawn: of airlight_entries where is_left_out, else of each tile's list
uniform int pixel_step;    // pixels between the target's texels, half as many as in the coarser grid

// Range from a light within which a grid leaves out part of its airlight, which bends too much for lines between
// texels; 0 where the airlight is flat there.
float left_out_range(float bend_range, float width, int grid_step) {
  float range = bend_range * pow(float(grid_step), 0.8);
  return range > width ? range : 0.0;
}
