// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/check_errors.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

#include "core/value_errors.h"
#include "gl/gl_test.h"
#include "litfog/gl/gl_name.h"

namespace litfog::test {
namespace {

using CheckErrors = GlTest;

TEST_F(CheckErrors, PendingErrorIsNamedOnceWithItsLocation) {
  glEnable(GLenum(0xffff));
  EXPECT_EQ(sentence_of<std::logic_error>([&] { gl::check_errors("an unknown capability"); }),
            "OpenGL error 1280 after an unknown capability");
  EXPECT_NO_THROW(gl::check_errors("it"));
}

TEST_F(CheckErrors, ShortMemoryIsNoBug) {
  const gl::BufferName buffer;
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr{1} << 46, nullptr, GL_STATIC_DRAW);
  EXPECT_THROW(gl::check_errors("making a buffer"), std::bad_alloc);
}

}  // namespace
}  // namespace litfog::test
