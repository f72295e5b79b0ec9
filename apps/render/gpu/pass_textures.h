// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"

namespace litfog::render {

/// Assigns the units from kPassUnit on to textures that only one pass reads, and sets the samplers of the pass's
/// program, which must be in use. Samplers that the compiler dropped also take a unit.
class PassTextures {
 public:
  explicit PassTextures(const gl::Program& program) : program_(program) {}

  /// The unit of a sampler, to which the caller binds its texture.
  unsigned unit(const char* sampler) {
    set_uniform(program_, sampler, unit_);
    return unit_++;
  }
  void bind(const char* sampler, const gl::TextureName& texture, GLenum target) {
    bind_texture(unit(sampler), texture, target);
  }

 private:
  const gl::Program& program_;
  unsigned unit_ = kPassUnit;
};

}  // namespace litfog::render
