// SPDX-License-Identifier: Apache-2.0
// The night sky: a gradient, stars and the moon, far behind all fog.

#include "litfog/fog.glsl"

in vec3 seen_position;

uniform vec3 eye;
uniform vec3 sky_zenith;
uniform vec3 sky_horizon;
uniform float star_brightness;
uniform vec3 moon_direction;
uniform vec3 moon_color;
uniform float sky_distance;  // metres

out vec4 color;

float hash(vec3 cell) {
  vec3 p = fract(cell * vec3(0.1031, 0.1030, 0.0973));
  p += dot(p, p.yxz + 33.33);
  return fract((p.x + p.y) * p.z);
}

// At most one star in each cell of a grid on the direction's cube.
float star(vec3 direction) {
  vec3 a = abs(direction);
  float largest = max(a.x, max(a.y, a.z));
  vec3 on_cube = direction / largest * 90.0;
  vec3 cell = floor(on_cube);
  vec3 center = cell + 0.3 + 0.4 * vec3(hash(cell + 1.0), hash(cell + 2.0), hash(cell + 3.0));
  center = normalize(center);
  float presence = hash(cell);
  if (presence < 0.94) return 0.0;  // most cells are empty, and most stars faint
  float angle = distance(center, direction);
  float size = (presence - 0.94) / 0.06;
  return size * size * exp(-angle * angle * 3.0e6);
}

void main() {
  vec3 direction = normalize(seen_position - eye);
  float height = max(direction.y, 0.0);
  vec3 sky = mix(sky_horizon, sky_zenith, 1.0 - pow(1.0 - height, 4.0));
  sky += star_brightness * star(direction) * smoothstep(0.0, 0.25, height);
  if (moon_color != vec3(0.0)) {
    float off = distance(direction, moon_direction);
    sky += normalize(moon_color) * (smoothstep(0.0053, 0.0045, off) + 0.05 * exp(-off * 40.0));
  }
  color = vec4(litfog_apply_fog(sky, eye + direction * sky_distance, eye), 1.0);
}
