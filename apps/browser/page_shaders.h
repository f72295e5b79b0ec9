// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "litfog/gl/shader_library.h"

namespace litfog::browser {

/// The page's shader files, and those of the demo that it shares, by names without folders.
std::span<const gl::ShaderSource> page_shaders();

}  // namespace litfog::browser
