// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/texture.h"

namespace litfog::render {

/// Gives each sampler of fragment shaders a fixed state. Mesa does not set the sampler state of buffer textures, so an
/// earlier draw's state remains, and llvmpipe recompiles a shader for each state that it meets. Without these states a
/// scene's first picture took 6 to 25 % more processor time on llvmpipe (room, headlights with shafts, street). Needs a
/// current GL context.
class SamplerStates {
 public:
  SamplerStates();

  /// Sets all states by a draw call that changes nothing in the bound framebuffer. Needs depth and stencil tests that
  /// write nothing. Changes bindings.
  void set() const;

 private:
  gl::Program program_;
  gl::VertexArrayName no_vertices_;
  Texture texture_;
};

}  // namespace litfog::render
