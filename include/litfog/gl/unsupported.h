// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace litfog::gl {

/// The machine lacks what is needed: no EGL, no OpenGL 3.3 context, an extension or limit. One sentence.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace litfog::gl
