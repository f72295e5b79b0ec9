// SPDX-License-Identifier: Apache-2.0
// Adds the part of a light's airlight that the coarser grid leaves out, at texels filled from that grid.

#include "generated/airlight_constants.glsl"
#include "airlight/airlight_light.glsl"
#include "pixel_direction.glsl"

flat in vec4 entry;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) * pixel_step;
  vec3 direction = pixel_direction(pixel);
  vec3 position = litfog_buffered_position_extent(int(entry.x)).xyz;
  float square = squared_passing_distance(position, direction);
  float fraction = kept_fraction(entry, square, pixel_step) - kept_fraction(entry, square, 2 * pixel_step);
  airlight = vec4(0.0);
  gain = vec4(0.0);
  if (fraction <= 0.0) return;  // no discard, which would end the early stencil test
  vec4 seen = seen_at(pixel);
  add_light(int(entry.x), fraction, direction, seen, shown_exposure_at(direction, seen));
}
