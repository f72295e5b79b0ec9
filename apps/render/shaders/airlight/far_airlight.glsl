// SPDX-License-Identifier: Apache-2.0
// The airlight of lights beyond their extents. It changes slowly over a picture and along a ray, so that it is summed
// over all lights at every far_step-th pixel, in slabs along its ray.

const int far_slabs = 32;
const int slabs_at_once = 8;  // in a fragment of far_airlight.frag

uniform float far_depth;  // metres along a ray, of all slabs; 0: there is no such airlight
uniform int far_step;     // pixels between texels

// Slabs grow with the distance from the eye, as what is seen in them does.
float slab_begin(int slab) {
  float part = float(slab) / float(far_slabs);
  return far_depth * part * part;
}
