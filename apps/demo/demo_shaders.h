// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/gl/shader_library.h"

namespace litfog::demo {

/// The files of apps/demo/shaders, embedded.
std::span<const gl::ShaderSource> demo_shaders();

}  // namespace litfog::demo
