// SPDX-License-Identifier: Apache-2.0
// The airlight of all lights from a grid of every so many pixels, where that is good enough: where what is seen changes
// little between four texels of the grid and the airlight is nearly straight. Other pixels are left for lights one by one.

#include "cookie.glsl"
#include "litfog/shaders/fog.glsl"
#include "seen_range.glsl"

uniform sampler2D grid;  // rgb airlight
uniform int pixel_step;

out vec4 color;

const float most_opacity_change = 0.03;  // over a slope: the airlight bends by less than an eighth of its square
const float most_error = 0.0007;         // of the airlight, where what is seen is not on the slope: a fifth of a step
const float most_bend = 0.004;            // eight times an eighth of a step of the display

// Slope of sRGB (IEC 61966-2-1) at a linear value below 1: what the display makes of errors of airlight that nothing
// else outshines.
vec3 display_slope(vec3 linear) { return min(vec3(12.92), 0.4396 * pow(max(linear, vec3(1.0e-4)), vec3(-0.5833))); }

vec3 grid_texel(ivec2 texel) { return texelFetch(grid, clamp(texel, ivec2(0), textureSize(grid, 0) - 1), 0).rgb; }

// Second difference of the grid at a texel in a direction: eight times the error of a straight line between texels.
vec3 bend(ivec2 texel, ivec2 step) {
  return abs(grid_texel(texel - step) - 2.0 * grid_texel(texel) + grid_texel(texel + step));
}

// Opacity of the fog before the mean of a pixel's samples.
float mean_opacity(SeenRanges seen) { return litfog_fog_opacity(seen.mean, 1.0); }

float between(float values[4], vec2 part) {
  return mix(mix(values[0], values[1], part.x), mix(values[2], values[3], part.x), part.y);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 texel = pixel / pixel_step;
  vec2 part = vec2(pixel - texel * pixel_step) / float(pixel_step);
  SeenRanges own = seen_ranges(pixel, pixel_direction(pixel));
  float own_change = litfog_fog_opacity(own.farthest, 1.0) - litfog_fog_opacity(own.nearest, 1.0);
  vec3 corners[4];
  float opacities[4];
  vec3 most = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = texel + ivec2(i & 1, i >> 1);
    corners[i] = grid_texel(corner);
    most = max(most, bend(corner, ivec2(1, 0)) + bend(corner, ivec2(0, 1)));
    opacities[i] = mean_opacity(seen_ranges(corner * pixel_step, pixel_direction(corner * pixel_step)));
  }
  float change = max(max(opacities[0], opacities[1]), max(opacities[2], opacities[3])) -
                 min(min(opacities[0], opacities[1]), min(opacities[2], opacities[3]));
  vec3 filled = mix(mix(corners[0], corners[1], part.x), mix(corners[2], corners[3], part.x), part.y);
  float opacity = mean_opacity(own);
  vec3 slope = display_slope(min(min(corners[0], corners[1]), min(corners[2], corners[3])));
  vec3 seen_airlight = filled * slope;
  vec3 seen_bend = most * slope;
  float error = abs(opacity - between(opacities, part)) * max(max(seen_airlight.r, seen_airlight.g), seen_airlight.b);
  if (max(change, own_change) > most_opacity_change || error > most_error * opacity ||
      max(max(seen_bend.r, seen_bend.g), seen_bend.b) > most_bend) {
    discard;
  }
  color = vec4(filled, 0.0);
}
