// SPDX-License-Identifier: Apache-2.0
// The sum of the lights' airlight, to be added to the picture.

#include "far_airlight_at.glsl"
#include "seen.glsl"

uniform sampler2D airlight;  // within the lights' extents

out vec4 color;

// That of lights beyond their extents, before what the pixel's samples see.
vec3 far_airlight_before(vec4 seen) {
  const float most_equal = 1.02;  // ranges that share a look-up
  vec2 place = gl_FragCoord.xy;
  if (seen.w <= most_equal * seen.x) return far_airlight_at(place, dot(seen, vec4(0.25)));
  return 0.25 * (far_airlight_at(place, seen.x) + far_airlight_at(place, seen.y) + far_airlight_at(place, seen.z) +
                 far_airlight_at(place, seen.w));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 sum = texelFetch(airlight, pixel, 0).rgb;
  if (far_depth > 0.0) sum += far_airlight_before(seen_at(pixel));
  color = vec4(sum, 0.0);
}
