// SPDX-License-Identifier: Apache-2.0
// The airlight of all lights from a grid of half as many rows and columns, where that is good enough: where, brought to
// what the pixel sees, it is nearly straight between texels. Other pixels are left for lights one by one.

#include "seen.glsl"

uniform sampler2D grid;       // airlight
uniform sampler2D grid_gain;  // what is gained of it where the fog before what is seen gains opacity
uniform int pixel_step;       // pixels between the target's texels; the grid's are twice as far apart

layout(location = 0) out vec4 airlight;
layout(location = 1) out vec4 gain;

const float most_own_change = 0.01;        // of opacity, within the pixel
const float most_opacity_change = 0.03;    // of opacity, from a texel of the grid
const float most_error = 0.0005;           // of the display: an eighth of a step
const float most_bend = 8.0 * most_error;  // of the display

// Slope of sRGB (IEC 61966-2-1) at a linear value below 1: what the display makes of errors of airlight that nothing
// else outshines.
vec3 display_slope(vec3 linear) { return min(vec3(12.92), 0.4396 * pow(max(linear, vec3(1.0e-4)), vec3(-0.5833))); }

float largest(vec3 values) { return max(max(values.r, values.g), values.b); }

struct Texel {
  vec3 airlight;
  vec3 gain;
  float opacity_change;  // from the texel to what the pixel sees
};

float mean_opacity(vec4 seen) { return dot(seen_opacities(seen, 1.0), vec4(0.25)); }

// A texel of the grid, brought to what the pixel sees.
Texel grid_texel(ivec2 place, float opacity) {
  place = clamp(place, ivec2(0), textureSize(grid, 0) - 1);
  Texel texel;
  texel.gain = texelFetch(grid_gain, place, 0).rgb;
  texel.opacity_change = opacity - mean_opacity(seen_at(place * 2 * pixel_step));
  texel.airlight = max(texelFetch(grid, place, 0).rgb + texel.gain * texel.opacity_change, vec3(0.0));
  return texel;
}

// Whether the mean of two neighbouring texels errs more than allowed. The bend of the values at the two is eight times
// the error of the straight line between them.
bool errs_between(ivec2 place, ivec2 step, Texel first, Texel second, float opacity) {
  vec3 before = grid_texel(place - step, opacity).airlight;
  vec3 behind = grid_texel(place + 2 * step, opacity).airlight;
  vec3 bend = max(abs(before - 2.0 * first.airlight + second.airlight),
                  abs(first.airlight - 2.0 * second.airlight + behind));
  float most_change = max(abs(first.opacity_change), abs(second.opacity_change));
  vec3 slope = display_slope(min(first.airlight, second.airlight));
  return most_change > most_opacity_change || largest(bend * slope) > most_bend ||
         largest(abs(first.gain - second.gain) * slope) * most_change > 4.0 * most_error;
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  ivec2 corner = place / 2;
  ivec2 part = place - 2 * corner;
  vec4 seen = seen_at(place * pixel_step);
  vec4 opacities = seen_opacities(seen, 1.0);
  float opacity = dot(opacities, vec4(0.25));
  Texel low = grid_texel(corner, opacity);
  vec3 sum = low.airlight;
  vec3 gains = low.gain;
  if (part != ivec2(0) && opacities.w - opacities.x > most_own_change) discard;
  if (part.x + part.y == 1) {  // between two texels
    Texel next = grid_texel(corner + part, opacity);
    if (errs_between(corner, part, low, next, opacity)) discard;
    sum = 0.5 * (low.airlight + next.airlight);
    gains = 0.5 * (low.gain + next.gain);
  } else if (part == ivec2(1)) {  // between four
    Texel right = grid_texel(corner + ivec2(1, 0), opacity);
    Texel above = grid_texel(corner + ivec2(0, 1), opacity);
    Texel far = grid_texel(corner + 1, opacity);
    if (errs_between(corner, ivec2(1, 0), low, right, opacity) ||
        errs_between(corner, ivec2(0, 1), low, above, opacity) ||
        errs_between(corner + ivec2(0, 1), ivec2(1, 0), above, far, opacity) ||
        errs_between(corner + ivec2(1, 0), ivec2(0, 1), right, far, opacity)) {
      discard;
    }
    sum = 0.25 * (low.airlight + right.airlight + above.airlight + far.airlight);
    gains = 0.25 * (low.gain + right.gain + above.gain + far.gain);
  }
  airlight = vec4(sum, 0.0);
  gain = vec4(gains, 0.0);
}
