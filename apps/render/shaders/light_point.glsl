// SPDX-License-Identifier: Apache-2.0
// Shared by light_point.vert and lamp_disc.vert.

uniform float near_plane;  // metres
uniform bool has_clip_control;

const float lens_radius = 0.1;  // metres: a light is in or on its lens; a runway edge light's is 0.08
const float most_lifted = 0.4;  // metres

// The distance by which a point is moved towards the eye. If it were less, the lamp's own lens or the depth buffer's
// rounding (gpu/depth.h) would hide the point. A wall closer than this before the lamp does not hide it. With clip
// control it is 0.1 m nearby and 3 mm more at 10 km; else 0.4 m from 355 m on, where farther lamps show through walls.
float lift(float range) {
  float rounding = 4.0 * 5.960464e-8 * range * (has_clip_control ? 1.0 : range / near_plane);
  return min(min(lens_radius + rounding, most_lifted), 0.5 * range);
}
