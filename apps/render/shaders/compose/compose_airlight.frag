// SPDX-License-Identifier: Apache-2.0
// The airlight of all lamps, which blending adds to the picture.

#include "compose/compose.glsl"
#include "airlight/far_airlight_at.glsl"
#include "airlight/seen.glsl"
#include "pixel_direction.glsl"

uniform vec3 eye;
uniform sampler2DRect airlight;  // within the lights' extents

out vec4 color;

// The airlight beyond the lights' extents, up to the surfaces that the pixel's samples see.
vec3 far_airlight_before(vec4 seen, float rise) {
  const float most_equal = 1.02;  // largest ratio of ranges that share a look-up
  int ranges = 4;
  if (seen.w <= most_equal * seen.x) {
    ranges = 1;
    seen.x = mean_of(seen);
  }
  vec3 sum = vec3(0.0);
  int i = 0;
  do {
    sum += far_airlight_at(gl_FragCoord.xy, seen[i], eye.y, rise);
    ++i;
  } while (i < ranges);
  return sum / float(ranges);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 sum = texel_at(airlight, pixel).rgb;
  if (far_depth > 0.0) sum += far_airlight_before(seen_at(pixel), pixel_direction(pixel).y);
  color = vec4(compose(vec3(0.0), sum), 0.0);
}
