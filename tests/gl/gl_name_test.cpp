// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/gl_name.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

#include "gl/gl_test.h"

namespace litfog::test {
namespace {

using gl::BufferName;

static_assert(!std::is_copy_constructible_v<BufferName> && !std::is_copy_assignable_v<BufferName>);
static_assert(std::is_nothrow_move_constructible_v<BufferName> && std::is_nothrow_move_assignable_v<BufferName>);

class GlNameTest : public GlTest {
 protected:
  /// A buffer's name becomes an object when it is first bound.
  static bool is_object(const BufferName& buffer) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    return glIsBuffer(buffer.id()) == GL_TRUE;
  }
};

TEST_F(GlNameTest, ObjectEndsWithItsOwner) {
  GLuint id = 0;
  {
    const BufferName buffer;
    ASSERT_TRUE(is_object(buffer));
    id = buffer.id();
  }
  EXPECT_FALSE(glIsBuffer(id));
}

TEST_F(GlNameTest, MovedObjectEndsWithItsNewOwner) {
  GLuint first_id = 0;
  GLuint second_id = 0;
  {
    BufferName first;
    BufferName second;
    ASSERT_TRUE(is_object(first) && is_object(second));
    first_id = first.id();
    second_id = second.id();
    BufferName third(std::move(first));
    EXPECT_EQ(first.id(), 0u);
    EXPECT_EQ(third.id(), first_id);
    third = std::move(second);
    EXPECT_EQ(third.id(), second_id);
    EXPECT_TRUE(glIsBuffer(second_id));
  }
  EXPECT_FALSE(glIsBuffer(first_id));
  EXPECT_FALSE(glIsBuffer(second_id));
}

TEST_F(GlNameTest, EachKindIsDeletedAsItWasCreated) {
  GLuint framebuffer_id = 0;
  GLuint program_id = 0;
  GLuint renderbuffer_id = 0;
  GLuint texture_id = 0;
  GLuint vertex_array_id = 0;
  {
    const gl::FramebufferName framebuffer;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_id = framebuffer.id());
    const gl::ProgramName program;
    program_id = program.id();
    const gl::RenderbufferName renderbuffer;
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer_id = renderbuffer.id());
    const gl::TextureName texture;
    glBindTexture(GL_TEXTURE_2D, texture_id = texture.id());
    const gl::VertexArrayName vertex_array;
    glBindVertexArray(vertex_array_id = vertex_array.id());
    EXPECT_TRUE(glIsFramebuffer(framebuffer_id) && glIsProgram(program_id) && glIsRenderbuffer(renderbuffer_id) &&
                glIsTexture(texture_id) && glIsVertexArray(vertex_array_id));
  }
  EXPECT_FALSE(glIsFramebuffer(framebuffer_id));
  EXPECT_FALSE(glIsProgram(program_id));
  EXPECT_FALSE(glIsRenderbuffer(renderbuffer_id));
  EXPECT_FALSE(glIsTexture(texture_id));
  EXPECT_FALSE(glIsVertexArray(vertex_array_id));
}

}  // namespace
}  // namespace litfog::test
