// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/gl/shader_library.h"

namespace litfog::papers {

/// The files of apps/papers/shaders, embedded.
std::span<const gl::ShaderSource> paper_shaders();

}  // namespace litfog::papers
