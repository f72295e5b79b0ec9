// SPDX-License-Identifier: Apache-2.0
// Fills texels from a grid of half as many rows and columns where interpolation errs little: by a polynomial through
// six texels or a straight line through two, each corrected to the depth that the pixel sees. At other texels the
// lights are drawn one by one.

#extension GL_ARB_derivative_control : enable  // core in OpenGL 4.5

#include "airlight/display_slope.glsl"
#include "airlight/seen.glsl"
#include "pixel_direction.glsl"

uniform sampler2DRect grid;       // airlight; alpha: mean opacity of the fog before the surfaces that a texel sees
uniform sampler2DRect grid_gain;  // derivative of airlight by that opacity
uniform int pixel_step;       // pixels between the target's texels; the grid's are twice as far apart
uniform vec3 eye;

layout(location = 0) out vec4 airlight;  // alpha as in grid
layout(location = 1) out vec4 gain;

// Limits. Changes are of opacity, at 0 EV; all others are of the display's range, where a step is about 0.004.
const float max_opacity_change = 0.03;        // within the pixel, or between the pixel and a texel of the grid
const float max_extrapolated_change = 0.003;  // from both texels, where their opacities do not enclose the pixel's
const float max_error = 0.0005;               // by interpolation: an eighth of a step
const float max_correction = 0.004;           // from a straight line to the polynomial
const float max_depth_correction = 0.016;     // from a texel's depth to the pixel's

// Scales both limits of the opacity's change above 0 EV: the error grows with the square of a change.
float change_scale() { return inversesqrt(max(exposure_gain, 1.0)); }

float largest(vec3 values) { return max(max(values.r, values.g), values.b); }

struct Texel {
  vec3 airlight;
  vec3 gain;
  float opacity_change;  // from the texel to the pixel
};

// A texel of the grid, corrected to the depth that the pixel sees.
Texel grid_texel(ivec2 place, float opacity) {
  vec4 airlight_opacity = texel_at(grid, place);
  Texel texel;
  texel.gain = texel_at(grid_gain, place).rgb;
  texel.opacity_change = opacity - airlight_opacity.a;
  texel.airlight = max(airlight_opacity.rgb + texel.gain * texel.opacity_change, vec3(0.0));
  return texel;
}

bool is_inside(ivec2 place) {
  return all(greaterThanEqual(place, ivec2(0))) && all(lessThan(place, textureSize(grid)));
}

// The airlight in the middle of six texels in a row.
struct Middle {
  vec3 airlight;
  vec3 gain;
  float error;  // estimate, in the display's range
};

Middle middle_of(ivec2 place, ivec2 step, float opacity) {
  Texel first = grid_texel(place, opacity);
  Texel second = grid_texel(place + step, opacity);
  vec3 a = first.airlight;
  vec3 b = second.airlight;
  vec3 before = grid_texel(place - step, opacity).airlight;
  vec3 behind = grid_texel(place + 2 * step, opacity).airlight;
  // At the grid's border some of these are unknown. Then there is no polynomial, and an unknown inner bend is
  // extrapolated from the next two texels.
  bool knows_first = is_inside(place - step);
  bool knows_second = is_inside(place + 2 * step);
  bool knows_all = is_inside(place - 2 * step) && is_inside(place + 3 * step);
  bool knows_bends = knows_first ? knows_second || is_inside(place - 2 * step)
                                 : knows_second && is_inside(place + 3 * step);
  vec3 bend_before = grid_texel(place - 2 * step, opacity).airlight - 2.0 * before + a;
  vec3 bend_behind = b - 2.0 * behind + grid_texel(place + 3 * step, opacity).airlight;
  vec3 first_bend = before - 2.0 * a + b;
  vec3 second_bend = a - 2.0 * b + behind;
  if (!knows_first) first_bend = 2.0 * second_bend - bend_behind;
  if (!knows_second) second_bend = 2.0 * first_bend - bend_before;
  // The bends' own bends.
  vec3 first_turn = bend_before - 2.0 * first_bend + second_bend;
  vec3 second_turn = first_bend - 2.0 * second_bend + bend_behind;
  // Where the airlight is smooth, the straight line errs by an eighth of the bend, and the polynomial by less than the
  // 3/128 of the turn that a cubic would miss. At the edge of a beam, where the slope is continuous and the bend is
  // not, the polynomial errs by at most 1/19 of the turn.
  vec3 slope = display_slope(min(a, b) + litfog_ambient_fog_color.rgb * opacity);  // over the fog's own light
  float fraction = knows_first && knows_second ? 0.25 : 0.5;  // with a margin
  // Both inner bends may be 0 by chance; beside a beam's edge the outer ones are not.
  vec3 most_bend = max(max(abs(first_bend), abs(second_bend)), 0.25 * max(abs(bend_before), abs(bend_behind)));
  float line_error = largest(most_bend * slope) * fraction;
  if (!knows_bends) line_error = 1.0;
  float polynomial_error = largest(max(abs(first_turn), abs(second_turn)) * slope) / 19.0;
  if (!knows_all || line_error > max_correction) polynomial_error = 1.0;
  float most_change = max(abs(first.opacity_change), abs(second.opacity_change));
  float gain_error = largest(abs(first.gain - second.gain) * slope) * most_change / 4.0;
  Middle middle;
  middle.airlight = 0.5 * (a + b);
  if (polynomial_error < max_error) {
    middle.airlight += (first_turn + second_turn) * (3.0 / 256.0) - (first_bend + second_bend) / 16.0;
  }
  middle.gain = 0.5 * (first.gain + second.gain);
  float depth_correction = largest(max(first.gain, second.gain) * slope) * most_change;
  bool is_far = most_change > max_opacity_change * change_scale() || depth_correction > max_depth_correction;
  // The pixel sees nearer or farther than both texels, whose gains say nothing of a beam in between.
  float least_change = min(abs(first.opacity_change), abs(second.opacity_change));
  bool is_extrapolated = first.opacity_change * second.opacity_change > 0.0 &&
                         least_change > max_extrapolated_change * change_scale();
  middle.error = is_far || is_extrapolated ? 1.0 : max(min(line_error, polynomial_error), gain_error);
  return middle;
}

Middle mean_of(Middle first, Middle second) {
  return Middle(0.5 * (first.airlight + second.airlight), 0.5 * (first.gain + second.gain),
                max(first.error, second.error));
}

// The middle of four texels lies on two diagonals. Its own fragment interpolates along the first. The fragment of the
// corner texel has nothing to interpolate for itself, so it takes the second diagonal, if drivers can exchange values
// between fragments.
#ifdef GL_ARB_derivative_control
const bool is_shared = true;

// Passes values from the first to the last fragment of a block of 2 x 2.
vec4 from_corner(vec4 values, bool is_corner) { return dFdyFine(dFdxFine(is_corner ? values : vec4(0.0))); }
#else
const bool is_shared = false;

vec4 from_corner(vec4 values, bool is_corner) { return vec4(0.0); }
#endif

Middle from_corner(Middle middle, bool is_corner) {
  vec4 airlight_error = from_corner(vec4(middle.airlight, middle.error), is_corner);
  return Middle(airlight_error.rgb, from_corner(vec4(middle.gain, 0.0), is_corner).rgb, airlight_error.a);
}

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy);
  ivec2 corner = place / 2;
  ivec2 part = place - 2 * corner;
  bool is_corner = part == ivec2(0);
  ivec2 second_corner = corner + ivec2(1, 0);
  const ivec2 second_diagonal = ivec2(-1, 1);
  // Opacities of the pixel for which the fragment interpolates.
  ivec2 pixel = (is_corner ? place + 1 : place) * pixel_step;
  vec4 opacities = seen_opacities(eye, pixel_direction(pixel), seen_at(pixel), 1.0);
  float opacity = mean_of(opacities);
  // Between two texels of the grid, or across both diagonals between four.
  Middle middle = middle_of(is_corner ? second_corner : corner, is_corner ? second_diagonal : part, opacity);
  Middle other = is_shared ? from_corner(middle, is_corner) : middle_of(second_corner, second_diagonal, opacity);
  if (part == ivec2(1)) middle = mean_of(middle, other);
  bool is_torn = opacities.w - opacities.x > max_opacity_change * change_scale();
  if (!is_corner && (is_torn || middle.error > max_error)) discard;
  // The corner's pixel is that of the grid's texel.
  airlight = is_corner ? texel_at(grid, corner) : vec4(max(middle.airlight, vec3(0.0)), opacity);
  gain = vec4(is_corner ? texel_at(grid_gain, corner).rgb : middle.gain, 0.0);
}
