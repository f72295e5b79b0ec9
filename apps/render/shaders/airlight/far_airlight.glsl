// SPDX-License-Identifier: Apache-2.0
// The airlight of lights beyond their extents changes slowly over a picture and along a ray, so it is summed over all
// lights at every far_step-th pixel only, in slabs along the ray.

const int far_slabs = 32;
const int slabs_at_once = 8;  // per fragment of far_airlight.frag

uniform float far_depth;  // metres along a ray that all slabs cover; 0: there is no such airlight
uniform int far_step;     // pixels between texels

// Slabs grow with the distance from the eye.
float slab_begin(int slab) {
  float part = float(slab) / float(far_slabs);
  return far_depth * part * part;
}
