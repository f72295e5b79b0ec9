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
  kUploadUnit,  // textures are filled here, so that no other binding is lost; no sampler reads it
  kPassUnit,    // the first unit of textures that only one pass reads (PassTextures)
};

inline constexpr unsigned kFogLightBinding = 0;  ///< uniform buffer binding of FogLightBlock

/// Makes a unit the active one and binds a texture to it.
inline void bind_texture(unsigned unit, const gl::TextureName& texture, GLenum target = GL_TEXTURE_2D) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, texture.id());
}

/// Sets the filter of the texture that is bound to a target.
inline void set_filter(GLenum target, GLint filter) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
}

/// Lets the texture that is bound to a target be interpolated up to its edges, without repetition.
inline void interpolate_within_edges(GLenum target) {
  for (const GLenum wrap : {GLenum{GL_TEXTURE_WRAP_S}, GLenum{GL_TEXTURE_WRAP_T}, GLenum{GL_TEXTURE_WRAP_R}}) {
    glTexParameteri(target, wrap, GL_CLAMP_TO_EDGE);
  }
  set_filter(target, GL_LINEAR);
}

}  // namespace litfog::render
