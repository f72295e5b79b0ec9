// SPDX-License-Identifier: Apache-2.0
// The volume in the shadow of a triangle, from a bias behind it to infinity, its faces outwards.

layout(triangles) in;
layout(triangle_strip, max_vertices = 18) out;

in vec3 corner[];

uniform mat4 clip_from_world;
uniform vec3 lamp;
uniform float bias;  // metres

vec4 near_end(int i) { return clip_from_world * vec4(corner[i] + bias * normalize(corner[i] - lamp), 1.0); }
vec4 far_end(int i) { return clip_from_world * vec4(corner[i] - lamp, 0.0); }

void emit(vec4 position) {
  gl_Position = position;
  EmitVertex();
}

void main() {
  vec3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  bool is_facing = dot(normal, lamp - corner[0]) > 0.0;
  int b = is_facing ? 1 : 2;
  int c = 3 - b;
  emit(near_end(0)), emit(near_end(b)), emit(near_end(c));
  EndPrimitive();
  emit(far_end(0)), emit(far_end(c)), emit(far_end(b));
  EndPrimitive();
  int around[4] = int[](0, b, c, 0);
  for (int i = 0; i < 3; ++i) {
    emit(near_end(around[i])), emit(far_end(around[i]));
    emit(near_end(around[i + 1])), emit(far_end(around[i + 1]));
    EndPrimitive();
  }
}
