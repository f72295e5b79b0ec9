// SPDX-License-Identifier: Apache-2.0
// A bright core and, if the point has grown, a faint halo (glare in the eye). The figures are chosen by eye.

flat in vec3 point_color;
flat in float core_fraction;
out vec4 color;

const float least_core = 0.02;   // fraction of the squared radius: one pixel of a point that has grown
const float halo_falloff = 0.8;  // per squared radius: 1/150 at the point's edge

// point_list.h:
uniform float halo_brightness;
uniform float point_radii;

void main() {
  vec2 offset = (gl_PointCoord - 0.5) * point_radii;
  float square = dot(offset, offset);
  float core = exp(-square / (core_fraction * core_fraction + least_core));
  float halo = exp(-square * halo_falloff) * halo_brightness * (1.0 - core_fraction);
  color = vec4(point_color * (core + halo), 1.0);
}
