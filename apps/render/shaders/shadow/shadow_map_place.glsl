// SPDX-License-Identifier: Apache-2.0
// The shadow maps of a lamp: ahead, right, left, up, down, behind (render::ShadowCaster).

// From the lamp's frame, in which it looks along -z, to a map's frame: x to its right, y up, z away from the lamp.
vec3 map_from_frame(vec3 d, int map) {
  if (map == 0) return vec3(d.x, d.y, -d.z);
  if (map == 1) return vec3(d.z, d.y, d.x);
  if (map == 2) return vec3(-d.z, d.y, -d.x);
  if (map == 3) return vec3(d.x, d.z, d.y);
  if (map == 4) return vec3(d.x, -d.z, -d.y);
  return vec3(-d.x, d.y, d.z);
}

// The map of a cube that a direction meets.
int map_of_direction(vec3 d) {
  vec3 a = abs(d);
  if (a.z >= a.x && a.z >= a.y) return d.z <= 0.0 ? 0 : 5;
  if (a.x >= a.y) return d.x > 0.0 ? 1 : 2;
  return d.y > 0.0 ? 3 : 4;
}
