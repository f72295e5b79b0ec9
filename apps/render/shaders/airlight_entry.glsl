// SPDX-License-Identifier: Apache-2.0
// The lights whose airlight is drawn: render::AirlightEntry.

#include "cookie.glsl"
#include "litfog/shaders/glow.glsl"
#include "litfog/shaders/light_buffer.glsl"

uniform samplerBuffer airlight_entries;  // light, reach, bend_range, width
uniform int pixel_step;                  // pixels between the target's texels, half of those of the grid before
uniform bool is_filled;                  // only what the grid before lacks: these texels take the mean of its texels

// Range from a light within which a grid leaves out a part of its airlight, because it bends too much for straight
// lines between texels; 0 where it is flat there.
float left_out_range(float bend_range, float width, int grid_step) {
  float range = bend_range * pow(float(grid_step), 2.0 / 3.0);
  return range > width ? range : 0.0;
}
