// SPDX-License-Identifier: Apache-2.0
// What the points of light_point.vert and lamp_disc.vert share.

uniform float near_plane;  // metres
uniform bool has_clip_control;

const float lens_radius = 0.1;  // metres: a light is in or on its lens; that of a runway edge light has 0.08
const float most_lifted = 0.4;  // metres

// How far a point is moved towards the eye. A wall closer than that before the lamp does not hide it. Moved less, its
// own lens or the depth buffer's rounding (gpu/depth.h) would hide it. With clip control that is 0.1 m nearby and 3 mm
// more at 10 km; else 0.4 m from 355 m on, where farther lamps are seen through walls.
float lift(float range) {
  float rounding = 4.0 * 5.960464e-8 * range * (has_clip_control ? 1.0 : range / near_plane);
  return min(min(lens_radius + rounding, most_lifted), 0.5 * range);
}
