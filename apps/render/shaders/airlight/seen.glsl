// SPDX-License-Identifier: Apache-2.0
// How far the eye sees through a pixel, as airlight_seen.frag summed it up.

#include "litfog/shaders/fog.glsl"
#include "texel.glsl"

uniform sampler2DRect seen_ranges;

// Metres to surfaces or to the end of the fog, from near to far: each stands for a quarter of a pixel's samples. Of a
// pixel beyond the edge: what the edge sees.
vec4 seen_at(ivec2 pixel) { return texel_at(seen_ranges, pixel); }

// Of a pixel's quarters.
float mean_of(vec4 quarters) { return dot(quarters, vec4(0.25)); }

// Opacity of the fog before them, as a light class of that density scale sees it.
vec4 seen_opacities(vec4 seen, float density_scale) {
  return vec4(litfog_fog_opacity(seen.x, density_scale), litfog_fog_opacity(seen.y, density_scale),
              litfog_fog_opacity(seen.z, density_scale), litfog_fog_opacity(seen.w, density_scale));
}
