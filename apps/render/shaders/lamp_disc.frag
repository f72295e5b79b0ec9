// SPDX-License-Identifier: Apache-2.0
// A lamp's disc. With an edge of kDiscEdge its pixels add up to the same sum within 0.6 % at any subpixel position.

uniform float disc_edge;

flat in vec3 disc_color;
flat in float disc_radius;
flat in float point_size;
out vec4 color;

void main() {
  float distance_from_middle = length(gl_PointCoord - 0.5) * point_size;
  color = vec4(disc_color * (1.0 - smoothstep(disc_radius - disc_edge, disc_radius + disc_edge, distance_from_middle)),
               1.0);
}
