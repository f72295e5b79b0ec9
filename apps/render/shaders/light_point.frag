// SPDX-License-Identifier: Apache-2.0
// A bright core and, where the point has grown, a faint halo (glare in the eye).
flat in vec3 point_color;
flat in float core_fraction;
out vec4 color;

void main() {
  vec2 offset = (gl_PointCoord - 0.5) * 5.0;  // in radii
  float square = dot(offset, offset);
  float core = exp(-square / (core_fraction * core_fraction + 0.02));
  float halo = exp(-square * 0.8) * 0.25 * (1.0 - core_fraction);
  color = vec4(point_color * (core + halo), 1.0);
}
