// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/headless_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "command/no_more_threads.h"
#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/fog_light_tables.h"
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
  const GlesContext application;
  const EGLContext current = eglGetCurrentContext();
  {
    const gl::HeadlessContext headless;
    EXPECT_NE(eglGetCurrentContext(), current);
    EXPECT_TRUE(can_draw());
  }
  EXPECT_EQ(eglQueryAPI(), EGLenum(EGL_OPENGL_ES_API));
  EXPECT_EQ(eglGetCurrentContext(), current);
  EXPECT_TRUE(can_draw());
}

TEST_F(HeadlessContextTest, DisplayThatAnApplicationTerminatesTakesNoOtherContext) {
  const EGLDisplay display = eglGetCurrentDisplay();
  for (const bool releases : {false, true}) {
    const gl::HeadlessContext lost;
    eglTerminate(display);
    if (releases) eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    const gl::HeadlessContext next;
    EXPECT_TRUE(can_draw());
  }
  // The test's own context is lost, too.
  const gl::HeadlessContext next;
  EXPECT_TRUE(can_draw());
}

/// A member of /proc/self/status.
long status_of_process(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    if (word == name + ":") {
      long value = 0;
      file >> value;
      return value;
    }
  }
  return -1;
}

// LITFOG_TEST_CONTEXTS=1000 in the environment makes as many.
TEST_F(HeadlessContextTest, ContextsThatAreDroppedLeaveNothing) {
  const char* const asked = std::getenv("LITFOG_TEST_CONTEXTS");
  const int count = asked ? std::atoi(asked) : 50;
  const EGLContext outer = eglGetCurrentContext();
  const auto use_context = [] {
    const gl::HeadlessContext context;
    const gl::FogLightTables tables;
    const gl::FogLightBuffer buffer;
    EXPECT_TRUE(can_draw());
  };
  const auto count_descriptors = [] {
    using Iterator = std::filesystem::directory_iterator;
    return std::distance(Iterator("/proc/self/fd"), Iterator());
  };
  for (int i = 0; i < 20; ++i) use_context();
  const auto descriptors = count_descriptors();
  const long threads = status_of_process("Threads"), kibibytes = status_of_process("VmRSS");
  for (int i = 0; i < count; ++i) use_context();
  EXPECT_EQ(count_descriptors(), descriptors);
  EXPECT_EQ(status_of_process("Threads"), threads);
  const long grown = status_of_process("VmRSS") - kibibytes;
  std::printf("%d contexts, %ld KiB more\n", count, grown);
  EXPECT_LE(grown, 1024);
  EXPECT_EQ(eglGetCurrentContext(), outer);
  EXPECT_TRUE(can_draw());
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

TEST_F(HeadlessContextTest, ThreadsWithAContextEachDrawTheSame) {
  const auto draw = [] {
    const gl::Program program = FormulaPixels::program(
        "#include \"litfog/shaders/formulas.glsl\"\n#include \"test/input.glsl\"\n"
        "void main() { result = vec4(litfog_attenuation(given(0).x, given(0).y, given(0).z, given(0).w)); }\n");
    std::vector<glm::vec4> points;
    for (int i = 0; i < 8192; ++i) points.emplace_back(0.1f * float(i), 1.0f, 0.3f, 1e-3f * float(i));
    return FormulaPixels().draw(program, {points});
  };
  const auto expected = draw();
  std::array<std::thread, 2> threads;
  for (std::thread& thread : threads) {
    thread = std::thread([&] {
      const gl::HeadlessContext own;
      for (int i = 0; i < 20; ++i) EXPECT_EQ(draw(), expected) << i;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(draw(), expected);
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

#ifndef LITFOG_SANITIZED  // sanitizers' own memory would count
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
