// SPDX-License-Identifier: Apache-2.0
// How far the eye sees through a pixel, as computed by airlight_seen.frag.

#include "litfog/shaders/fog.glsl"
#include "airlight/texel.glsl"

uniform sampler2DRect seen_ranges;

// Metres to surfaces or to the end of the fog, from near to far, each for a quarter of a pixel's samples. A pixel
// beyond the edge takes the edge's.
vec4 seen_at(ivec2 pixel) { return texel_at(seen_ranges, pixel); }

// Mean over a pixel's quarters.
float mean_of(vec4 quarters) { return dot(quarters, vec4(0.25)); }

// Opacity of the fog up to the ranges `seen` of a ray in a unit direction, for a light class of that density scale.
vec4 seen_opacities(vec3 eye, vec3 direction, vec4 seen, float density_scale) {
  vec4 heights = eye.y + direction.y * seen;
  return vec4(litfog_fog_opacity(eye.y, heights.x, seen.x, density_scale),
              litfog_fog_opacity(eye.y, heights.y, seen.y, density_scale),
              litfog_fog_opacity(eye.y, heights.z, seen.z, density_scale),
              litfog_fog_opacity(eye.y, heights.w, seen.w, density_scale));
}
