// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>

#include "gl/gles_context.h"
#include "litfog/gl/check_errors.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"

namespace litfog::test {

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
