// SPDX-License-Identifier: Apache-2.0
// The end of the fog before the sky.

uniform float sky_distance;   // metres
uniform float fog_above_eye;  // metres, from the eye up to the fog's top; finite

// The length of a ray from the eye within the fog: measure::fog_before_sky() states the cases.
float fog_before_sky(vec3 direction) {
  if (direction.y > 0.0) return min(max(fog_above_eye, 0.0) / direction.y, sky_distance);
  return direction.y == 0.0 && fog_above_eye < 0.0 ? 0.0 : sky_distance;
}
