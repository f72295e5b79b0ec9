// SPDX-License-Identifier: Apache-2.0
// The airlight of lights beyond their extents changes slowly over a picture and along a ray, so it is summed over all
// lights at every far_step-th pixel only, in slabs along the ray.

#include "litfog/shaders/fog.glsl"

const int far_slabs = 32;
const int slabs_at_once = 8;  // per fragment of far_airlight.frag

uniform float far_depth;  // metres along a ray that all slabs cover; 0: there is no such airlight
uniform int far_step;     // pixels between texels

// Slabs grow with the distance from the eye, in layers with the opacity of the fog: where there is no fog, there is no
// airlight.
float opacity_along(float eye_height, float rise, float range) {
  return litfog_fog_opacity(eye_height, eye_height + rise * range, range, 1.0);
}

// Metres along a ray from a height to where a slab begins.
float slab_begin(int slab, float eye_height, float rise) {
  float part = float(slab) / float(far_slabs);
  float even = far_depth * part * part;
  if (litfog_knot_count() == 0) return even;
  float opacity = opacity_along(eye_height, rise, far_depth) * part * part;
  if (opacity <= 0.0) return even;
  float low = 0.0;
  float high = far_depth;
  for (int i = 0; i < 24; ++i) {
    float middle = 0.5 * (low + high);
    if (opacity_along(eye_height, rise, middle) < opacity) low = middle;
    else high = middle;
  }
  return slab < far_slabs ? high : far_depth;
}

// Of the slabs along a ray, those before a range, with a fraction of one.
float slabs_before(float range, float eye_height, float rise) {
  float part = min(range / far_depth, 1.0);
  if (litfog_knot_count() > 0) {
    float most = opacity_along(eye_height, rise, far_depth);
    if (most > 0.0) part = min(opacity_along(eye_height, rise, min(range, far_depth)) / most, 1.0);
  }
  float before = sqrt(part) * float(far_slabs);
  float slab = min(floor(before), float(far_slabs - 1));
  // Within a slab what is added grows with the range or opacity, of which this is the square root.
  return slab + clamp((before * before - slab * slab) / (2.0 * slab + 1.0), 0.0, 1.0);
}
