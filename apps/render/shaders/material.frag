// SPDX-License-Identifier: Apache-2.0
// Wraps a pass's shader for materials with a mask, emission or opacity, and for fragments that test their depth late.

#define main shade_surface
#include "generated/pass.frag"
#undef main
#include "rasterised.glsl"
#if defined MATERIAL_PANE && !defined WITHOUT_COLOR
#include "compose/pane.glsl"
#endif

uniform sampler2D emission_map;

void main() {
#ifdef TESTS_DEPTH_LATE
  gl_FragStencilRefARB = 0;
#endif
#ifdef MATERIAL_EMISSION_MAP
  emissive *= texture(emission_map, map_uvs.zw).rgb;
#endif
#ifdef MATERIAL_UNLIT
  emissive *= base_texel().rgb;
#endif
  shade_surface();
#if defined MATERIAL_PANE && !defined WITHOUT_COLOR
  color = over_what_is_behind(color.rgb);
#endif
#ifdef MATERIAL_MASK
  if (base_texel().a < coverage) discard;  // last, because texture filters need the neighbours' coordinates
#endif
}
