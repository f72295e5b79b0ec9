// SPDX-License-Identifier: Apache-2.0
// One triangle over the whole picture, at the far plane.
uniform mat4 direction_from_clip;
uniform float far_plane;  // in clip space
out vec3 seen_direction;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec4 seen = direction_from_clip * vec4(corner, 1.0, 1.0);  // on the near plane; the far plane is at infinity
  seen_direction = seen.xyz / seen.w;
  gl_Position = vec4(corner, far_plane, 1.0);
}
