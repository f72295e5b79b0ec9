// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>

#include "litfog/gl/check_errors.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"

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

/// A test with a current OpenGL context, which has to leave no OpenGL error. Skipped where the machine gives no
/// context, unless the environment's LITFOG_REQUIRE_GL says that it has to. With LITFOG_TEST_GLES there, the context is
/// one of OpenGL ES.
class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      context_.emplace();
      if (std::getenv("LITFOG_TEST_GLES")) gles_.emplace();
    } catch (const gl::Unsupported& reason) {
      const char* const required = std::getenv("LITFOG_REQUIRE_GL");
      if (required && *required) FAIL() << reason.what();
      GTEST_SKIP() << reason.what();
    }
  }

  void TearDown() override {
    if (context_) {
      EXPECT_NO_THROW(gl::check_errors("the test"));
    }
  }

  const gl::HeadlessContext& context() const { return *context_; }

 private:
  std::optional<gl::HeadlessContext> context_;
  std::optional<GlesContext> gles_;
};

}  // namespace litfog::test
