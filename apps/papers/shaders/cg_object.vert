// SPDX-License-Identifier: Apache-2.0
// Attenuation and spots at the vertices, in object space, as in the examples: the application transforms each light and
// the eye into the space of each object. The unit of this space is the object's scale.

#include "cg_vertex.glsl"

void main() {
  place_vertex();
  mat4 object_from_world = inverse(world_from_model);
  vec3 eye_position = (object_from_world * vec4(eye, 1.0)).xyz;
  light_vertex(object_from_world, length(world_from_model[0].xyz), vertex_position, normalize(vertex_normal),
               normalize(eye_position - vertex_position));
}
