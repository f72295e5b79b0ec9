// SPDX-License-Identifier: Apache-2.0
// Rotates a vector by the rotation that makes a plane with a unit normal parallel to z = 0 (Ronald Frazier 2000,
// "Real-Time Per-Pixel Point Lights and Spot Lights in OpenGL", prepareLightForPlane).
vec3 rotate_plane(vec3 v, vec3 normal) {
  const vec3 forward = vec3(0.0, 0.0, -1.0);
  vec3 axis = cross(normal, forward);
  float sin_angle = length(axis);
  if (sin_angle <= 0.00001) return v;
  axis /= sin_angle;
  // The angle is asin(length of the axis), or 180 deg minus that if the normal points forward.
  float cos_angle = -dot(normal, forward);
  // glRotatef(-angle, axis)
  return v * cos_angle - cross(axis, v) * sin_angle + axis * (dot(axis, v) * (1.0 - cos_angle));
}
