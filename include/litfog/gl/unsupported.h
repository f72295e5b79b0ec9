// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace litfog::gl {

/// Thrown if the machine lacks EGL, an OpenGL 3.3 context or an extension, or a limit is too low. what() is one
/// sentence.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace litfog::gl
