// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/check_errors.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "gl/gl_test.h"

namespace litfog::test {
namespace {

using CheckErrors = GlTest;

TEST_F(CheckErrors, PendingErrorIsNamedOnceWithItsLocation) {
  glEnable(GLenum(0xffff));
  try {
    gl::check_errors("an unknown capability");
    ADD_FAILURE() << "no error";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "OpenGL error 1280 after an unknown capability");
  }
  EXPECT_NO_THROW(gl::check_errors("it"));
}

}  // namespace
}  // namespace litfog::test
