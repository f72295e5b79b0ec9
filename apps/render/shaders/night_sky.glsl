// SPDX-License-Identifier: Apache-2.0
// The night sky without fog: a gradient, stars and the moon.

uniform vec3 sky_zenith;
uniform vec3 sky_horizon;
uniform float star_brightness;
uniform vec3 moon_direction;
uniform vec3 moon_color;

// Three numbers in [0, 1) for a cell, from integers, so that every device shows the same stars: pcg3d (Jarzynski and
// Olano 2020, "Hash Functions for GPU Rendering").
vec3 hash(ivec3 cell) {
  uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return vec3(v >> 8u) / 16777216.0;
}

// At most one star in each cell of a grid on the direction's cube, at the cell's centre.
float star(vec3 direction) {
  vec3 a = abs(direction);
  float largest = max(a.x, max(a.y, a.z));
  vec3 cell = round(direction / largest * 90.0);
  float presence = hash(ivec3(cell)).x;
  if (presence < 0.94) return 0.0;  // most cells are empty, and most stars faint
  vec3 centre = normalize(cell + 0.4 * hash(ivec3(cell) + 1000) - 0.2);
  float angle = distance(centre, direction);
  float size = (presence - 0.94) / 0.06;
  return size * size * exp(-angle * angle * 3.0e6);
}

// direction  unit
vec3 night_sky(vec3 direction) {
  float height = max(direction.y, 0.0);
  vec3 sky = mix(sky_horizon, sky_zenith, 1.0 - pow(1.0 - height, 4.0));
  sky += star_brightness * star(direction) * smoothstep(0.0, 0.25, height);
  if (moon_color != vec3(0.0)) {
    float off = distance(direction, moon_direction);
    sky += normalize(moon_color) * (1.0 - smoothstep(0.0045, 0.0053, off) + 0.05 * exp(-off * 40.0));
  }
  return sky;
}
