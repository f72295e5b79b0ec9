// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/texture.h"

namespace litfog::render {

/// Gives each sampler of fragment shaders a fixed state. Mesa does not set the state of a buffer texture's sampler but
/// leaves that of an earlier draw, and its software rasteriser compiles a shader anew for each state that it meets.
/// Without these states a scene's first picture took 6 to 25 % more of the processor's time on llvmpipe (room,
/// headlights with shafts, street). Needs a current GL context.
class SamplerStates {
 public:
  SamplerStates();

  /// Sets all states by a draw that changes nothing in the bound framebuffer. Needs a depth test and a stencil test that
  /// write nothing. Changes bindings.
  void set() const;

 private:
  gl::Program program_;
  gl::VertexArrayName no_vertices_;
  Texture texture_;
};

}  // namespace litfog::render
