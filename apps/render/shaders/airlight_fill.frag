// SPDX-License-Identifier: Apache-2.0
// The airlight of all lights from a grid of every so many pixels, where that is good enough: where neither what is seen
// nor the airlight changes much between four texels of the grid. Other pixels are left for lights one by one.

#include "cookie.glsl"
#include "litfog/shaders/fog.glsl"
#include "seen_range.glsl"

uniform sampler2D grid;  // rgb airlight
uniform int pixel_step;

out vec4 color;

const float most_opacity_change = 0.1;  // the airlight bends by less than an eighth of its square
const float most_change = 1.5 / 255.0;  // of the airlight as a display shows it, if nothing else is there

// Slope of sRGB (IEC 61966-2-1) at a linear value below 1.
vec3 display_slope(vec3 linear) { return min(vec3(12.92), 0.4396 * pow(max(linear, vec3(1.0e-4)), vec3(-0.5833))); }

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 texel = pixel / pixel_step;
  SeenRanges own = seen_ranges(pixel, pixel_direction(pixel));
  float nearest = own.nearest;
  float farthest = own.farthest;
  vec3 corners[4];
  vec3 least = vec3(3.4e38);
  vec3 most = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = texel + ivec2(i & 1, i >> 1);
    corners[i] = texelFetch(grid, corner, 0).rgb;
    least = min(least, corners[i]);
    most = max(most, corners[i]);
    SeenRanges there = seen_ranges(corner * pixel_step, pixel_direction(corner * pixel_step));
    nearest = min(nearest, there.nearest);
    farthest = max(farthest, there.farthest);
  }
  vec3 change = (most - least) * display_slope(least);
  float opacity_change = litfog_fog_opacity(farthest, 1.0) - litfog_fog_opacity(nearest, 1.0);
  if (opacity_change > most_opacity_change || max(max(change.r, change.g), change.b) > most_change) discard;
  vec2 part = vec2(pixel - texel * pixel_step) / float(pixel_step);
  color = vec4(mix(mix(corners[0], corners[1], part.x), mix(corners[2], corners[3], part.x), part.y), 0.0);
}
