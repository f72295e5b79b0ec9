// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include "litfog/gl/gl_name.h"

namespace litfog::render {

/// The units of textures that several passes of a frame read.
enum TextureUnit : unsigned {
  kAlbedoUnit,
  kNormalUnit,
  kKindBufferUnit,
  kInstanceBufferUnit,
  kLightListUnit,
  kRangeMapUnit,     // attenuation, or x^2 + y^2
  kDistanceMapUnit,  // q of the 2-D pair, or z^2
  kConeMapUnit,
  kCookieUnit,
  kCookieConeUnit,
  kShadowMapUnit,
  kShadowCasterUnit,
  kCasterOfLightUnit,
  kEmissionUnit,
  kSecondUnit,
  kScatteredAllUnit,
  kScatteredFlowUnit,
  kUploadUnit,  // no sampler reads it: textures are filled here, so that no other binding is lost
  kPassUnit,    // the first unit of textures that only one pass reads (PassTextures)
};

inline constexpr unsigned kFogLightBinding = 0;  ///< uniform buffer binding of FogLightBlock

/// Makes a unit the active one and binds a texture to it.
inline void bind_texture(unsigned unit, const gl::TextureName& texture, GLenum target = GL_TEXTURE_2D) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, texture.id());
}

}  // namespace litfog::render
