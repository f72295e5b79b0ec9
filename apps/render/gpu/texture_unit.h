// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include "litfog/gl/gl_name.h"

namespace litfog::render {

/// The texture units of the shaders, one for each sampler.
enum TextureUnit : unsigned {
  kAlbedoUnit,
  kNormalUnit,
  kKindBufferUnit,
  kInstanceBufferUnit,
  kLightListUnit,
  kRangeMapUnit,     // a light's attenuation, or the squares of x and y
  kDistanceMapUnit,  // q of the pair, or the square of z
  kConeMapUnit,
  kCookieUnit,
  kCookieConeUnit,
  kDepthUnit,     // the depths of a picture's samples
  kSeenUnit,      // how far each pixel sees
  kAirlightUnit,  // airlight at the texels of a grid
  kEntryUnit,     // the lights whose airlight is drawn
  kTileUnit,      // of them, those of each tile of the picture
  kGainUnit,      // of airlight, per opacity of the fog
  kMarkUnit,      // texels that a coarser grid is not good enough for
  kPlaceUnit,     // of packed texels in their grid
  kShadowMapUnit,
  kShadowCasterUnit,
  kCasterOfLightUnit,
  kEmissionUnit,
  kSecondUnit,
  kFarLightUnit,     // the lights whose airlight beyond their extents is drawn
  kFarSlabUnit,      // of it: sums in groups of slabs
  kFarAirlightUnit,  // before each slab
  kUploadUnit,       // of no picture's sampler: textures are filled there, so that none that is bound is lost
};

inline constexpr unsigned kFogLightBinding = 0;  ///< of the FogLightBlock

/// Makes a unit the active one and binds a texture to it.
inline void bind_texture(unsigned unit, const gl::TextureName& texture, GLenum target = GL_TEXTURE_2D) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, texture.id());
}

}  // namespace litfog::render
