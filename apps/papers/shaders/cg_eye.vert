// SPDX-License-Identifier: Apache-2.0
// Attenuation and spots at the vertices, in the eye's space (Randima Fernando and Mark Kilgard 2003, "The Cg Tutorial",
// chapter 5, exercise 3): position and normal are transformed into it, and the vector to the eye is the negative
// position. With the infinite viewer of exercise 4 it is (0, 0, 1). Cameras may not look straight up or down.

#include "cg_vertex.glsl"

void main() {
  vec3 position = place_vertex();
  vec3 backward = infinite_viewer;
  vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), backward));
  mat3 eye_from_world = transpose(mat3(right, cross(backward, right), backward));
  mat4 modelview = mat4(eye_from_world);
  modelview[3].xyz = -(eye_from_world * eye);
  vec3 p = (modelview * vec4(position, 1.0)).xyz;
  vec3 v = has_infinite_viewer ? vec3(0.0, 0.0, 1.0) : normalize(-p);
  light_vertex(modelview, 1.0, p, eye_from_world * world_normal(), v);
}
