// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include "litfog/gl/gl_name.h"

namespace litfog::render {

/// The texture units of what many passes of a frame read.
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
  kShadowMapUnit,
  kShadowCasterUnit,
  kCasterOfLightUnit,
  kEmissionUnit,
  kSecondUnit,
  kUploadUnit,  // no picture's sampler has it: textures are filled there, so that none that is bound is lost
  kPassUnit,    // the first of those whose textures each pass binds for itself (PassTextures)
};

inline constexpr unsigned kFogLightBinding = 0;  ///< of the FogLightBlock

/// Makes a unit the active one and binds a texture to it.
inline void bind_texture(unsigned unit, const gl::TextureName& texture, GLenum target = GL_TEXTURE_2D) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, texture.id());
}

}  // namespace litfog::render
