// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

namespace litfog::gl {

/// An OpenGL 3.3 core context through EGL without a display or window, current on the creating thread.
/// Uses the first EGL device that gives one (a GPU before a software rasteriser), else Mesa's surfaceless platform.
///
/// Other contexts are left alone: destroying this one makes the thread's previous context current again, and EGL's
/// display, which the process shares, stays initialised until the process ends.
///
/// threads  any number of threads may make, use and destroy their own contexts concurrently. A context belongs to the
///          thread that made it, which destroys it; contexts nested on a thread are destroyed in reverse order.
class HeadlessContext {
 public:
  /// throws Unsupported saying what is missing: a library, a device, memory for the driver, or enough threads; also on
  /// a thread with a current GLX context
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  std::string renderer() const;  ///< GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string version() const;   ///< GL_VERSION

 private:
  struct Egl;
  std::unique_ptr<Egl> egl_;
};

}  // namespace litfog::gl
