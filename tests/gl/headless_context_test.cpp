// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/headless_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

#include "command/no_more_threads.h"
#include "gl/gl_test.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/unsupported.h"

namespace litfog::test {
namespace {

using HeadlessContextTest = GlTest;

/// Whether the current context draws.
bool can_draw() {
  const gl::TextureName texture;
  const gl::FramebufferName framebuffer;
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
  glClearColor(1, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  std::array<GLubyte, 4> pixel{};
  glReadPixels(3, 4, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return pixel == std::array<GLubyte, 4>{255, 0, 0, 255};
}

TEST_F(HeadlessContextTest, ContextNamesItsRendererAndIsThreeThreeCore) {
  std::printf("%s, %s\n", context().renderer().c_str(), context().version().c_str());
  EXPECT_FALSE(context().renderer().empty());
  EXPECT_GE(epoxy_gl_version(), 33);
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
}

TEST_F(HeadlessContextTest, OuterContextIsCurrentAgainAfterANestedOne) {
  const EGLContext outer = eglGetCurrentContext();
  {
    const gl::HeadlessContext nested;
    EXPECT_NE(eglGetCurrentContext(), outer);
    EXPECT_TRUE(can_draw());
  }
  EXPECT_EQ(eglGetCurrentContext(), outer);
  EXPECT_TRUE(can_draw());
}

TEST_F(HeadlessContextTest, DestroyingAContextThatIsNotCurrentLeavesTheCurrentOneAlone) {
  auto first = std::make_unique<gl::HeadlessContext>();
  const gl::HeadlessContext second;
  const EGLContext current = eglGetCurrentContext();
  first.reset();
  EXPECT_EQ(eglGetCurrentContext(), current);
  EXPECT_TRUE(can_draw());
}

TEST_F(HeadlessContextTest, ContextAndApiOfAnApplicationSurvive) {
  const EGLDisplay display = eglGetCurrentDisplay();
  const EGLContext outer = eglGetCurrentContext();
  ASSERT_TRUE(eglBindAPI(EGL_OPENGL_ES_API));
  constexpr std::array<EGLint, 3> kAttributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  const EGLContext application = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
  ASSERT_NE(application, EGL_NO_CONTEXT);
  ASSERT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, application));
  {
    const gl::HeadlessContext headless;
    EXPECT_NE(eglGetCurrentContext(), application);
    EXPECT_TRUE(can_draw());
  }
  EXPECT_EQ(eglQueryAPI(), EGLenum(EGL_OPENGL_ES_API));
  EXPECT_EQ(eglGetCurrentContext(), application);
  EXPECT_TRUE(can_draw());
  eglBindAPI(EGL_OPENGL_API);
  EXPECT_TRUE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, outer));
  EXPECT_TRUE(eglDestroyContext(display, application));
}

TEST_F(HeadlessContextTest, ThreadsMakeAndDestroyContextsAtOnce) {
  std::atomic<int> drawn = 0;
  std::array<std::thread, 4> threads;
  for (std::thread& thread : threads) {
    thread = std::thread([&] {
      for (int i = 0; i < 25; ++i) {
        const gl::HeadlessContext own;
        drawn += can_draw();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(drawn, 100);
  EXPECT_TRUE(can_draw());
}

/// What context_probe prints, run by a shell after what comes before it there.
std::string output_of_probe(const std::string& before) {
  const std::string command = before + " " LITFOG_CONTEXT_PROBE " 2>&1";
  std::FILE* const pipe = popen(command.c_str(), "r");
  if (!pipe) return "no process";
  std::array<char, 512> text{};
  const std::size_t length = std::fread(text.data(), 1, text.size(), pipe);
  pclose(pipe);
  return {text.data(), length};
}

TEST(HeadlessContext, MachineWhereNoThreadCanStartIsUnsupported) {
  const NoMoreThreads limit;
  EXPECT_THROW(gl::HeadlessContext(), gl::Unsupported);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // whose own memory would count
// Mesa's software rasteriser would wait for the others for ever: 16 stacks of 64 MiB do not fit into 800 MiB.
TEST(HeadlessContext, MachineWhereTooFewThreadsCanStartIsUnsupported) {
  const std::string output = output_of_probe("ulimit -s 65536; ulimit -v 800000; LP_NUM_THREADS=16");
  EXPECT_TRUE(output.starts_with("OpenGL needs 16 threads, and only ")) << output;
  EXPECT_NE(output.find(" can start: "), output.npos) << output;
}

TEST(HeadlessContext, TooLittleMemoryIsNamedAsTheReason) {
  for (const char* kibibytes : {"100000", "200000", "300000"}) {  // with these Mesa does not start, or crashes
    EXPECT_EQ(output_of_probe(std::string("ulimit -v ") + kibibytes + ";"),
              "OpenGL needs 320 MiB of memory to start, and this process cannot get them: Cannot allocate memory\n");
  }
}
#endif

TEST(HeadlessContext, LibraryWithoutItsFunctionsIsUnsupported) {
  const auto output_without = [](const std::string& library) {
    return output_of_probe("LD_LIBRARY_PATH=" LITFOG_EMPTY_LIBRARIES "/empty_" + library);
  };
  EXPECT_EQ(output_without("EGL"), "libEGL.so.1 is unusable: it lacks eglBindAPI\n");
  EXPECT_EQ(output_without("OpenGL"), "libOpenGL.so.0 is unusable: it lacks glGetError\n");
}

}  // namespace
}  // namespace litfog::test
