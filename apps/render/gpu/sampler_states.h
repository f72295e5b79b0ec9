// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/texture.h"

namespace litfog::render {

/// A state of its own for each sampler of fragment shaders. Mesa gives the sampler of a buffer texture no state, but
/// leaves that of an earlier draw, and its software rasteriser compiles a shader anew for each that it meets. Needs a
/// current GL context.
class SamplerStates {
 public:
  SamplerStates();

  /// Sets all of them, by a draw of nothing into a framebuffer; depth test and stencil test are off. Changes what is
  /// bound.
  void set(const Framebuffer& framebuffer) const;

 private:
  gl::Program program_;
  gl::VertexArrayName no_vertices_;
  Texture texture_;
};

}  // namespace litfog::render
