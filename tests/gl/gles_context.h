// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/egl.h>

#include <array>
#include <stdexcept>

namespace litfog::test {

/// An OpenGL ES 3 context of an application, on the display of the current context, which it replaces as long as it
/// lives.
class GlesContext {
 public:
  GlesContext() {
    constexpr std::array<EGLint, 3> kAttributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    eglBindAPI(EGL_OPENGL_ES_API);
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) throw std::runtime_error("no OpenGL ES 3");
  }
  ~GlesContext() {
    eglBindAPI(EGL_OPENGL_API);
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, outer_);
    eglDestroyContext(display_, context_);
  }
  GlesContext(const GlesContext&) = delete;
  GlesContext& operator=(const GlesContext&) = delete;

 private:
  EGLDisplay display_ = eglGetCurrentDisplay();
  EGLContext outer_ = eglGetCurrentContext();
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace litfog::test
