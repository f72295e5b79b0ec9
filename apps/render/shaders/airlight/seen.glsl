// SPDX-License-Identifier: Apache-2.0
// How far the eye sees through a pixel, as airlight_seen.frag summed it up.

#include "litfog/shaders/fog.glsl"

uniform sampler2D seen_ranges;
uniform sampler2D mean_opacities;

// Metres to surfaces or to the end of the fog, from near to far: each stands for a quarter of a pixel's samples. Of a
// pixel beyond the edge: what the edge sees.
vec4 seen_at(ivec2 pixel) { return texelFetch(seen_ranges, min(pixel, textureSize(seen_ranges, 0) - 1), 0); }

// Mean opacity of the scene's fog before them.
float mean_opacity_at(ivec2 pixel) {
  return texelFetch(mean_opacities, min(pixel, textureSize(mean_opacities, 0) - 1), 0).r;
}

// Opacity of the fog before them, as a light class of that density scale sees it.
vec4 seen_opacities(vec4 seen, float density_scale) {
  return vec4(litfog_fog_opacity(seen.x, density_scale), litfog_fog_opacity(seen.y, density_scale),
              litfog_fog_opacity(seen.z, density_scale), litfog_fog_opacity(seen.w, density_scale));
}
