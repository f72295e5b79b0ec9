// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace litfog::gl {

/// An OpenGL 3.3 core context through EGL without a display or window, current on the creating thread.
/// Takes the first EGL device that gives one (a GPU before a software rasteriser), else Mesa's surfaceless platform.
class HeadlessContext {
 public:
  /// throws Unsupported saying what is missing
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  std::string renderer() const;  ///< GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version() const;   ///< GL_VERSION

 private:
  void* display_ = nullptr;  // EGLDisplay and EGLContext, kept out of this header
  void* context_ = nullptr;
};

/// Refuses a pending GL error: one is our own bug.
/// throws std::logic_error naming the error and the place
void check_errors(const char* place);

}  // namespace litfog::gl
