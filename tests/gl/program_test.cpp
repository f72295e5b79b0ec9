// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/program.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "gl/formula_pixels.h"
#include "gl/gl_test.h"

namespace litfog::test {
namespace {

class ProgramTest : public GlTest {
 protected:
  /// Why no program can be made of these files.
  static std::string error_of_files(const std::vector<gl::ShaderSource>& files, const char* vertex = "test/row.vert") {
    std::vector<gl::ShaderSource> all = {FormulaPixels::kVertexShader};
    all.insert(all.end(), files.begin(), files.end());
    return sentence_of<std::logic_error>([&] { gl::Program(vertex, "a.frag", all); });
  }
};

/// Mesa writes 1:2(3), NVIDIA 1(2).
bool names_location(const std::string& message, int file, int line) {
  const std::string number = std::to_string(line);
  return message.find(std::to_string(file) + ":" + number + "(") != std::string::npos ||
         message.find(std::to_string(file) + "(" + number + ")") != std::string::npos;
}

TEST_F(ProgramTest, CompileErrorInAnIncludedFileNamesFileAndLine) {
  const std::string message = error_of_files({{"a.frag", "// first\n#include \"b.glsl\"\nvoid main() {}\n"},
                                              {"b.glsl", "float one() { return 1.0; }\nfloat two() { return ); }\n"}});
  EXPECT_NE(message.find("shader a.frag does not compile:"), std::string::npos) << message;
  EXPECT_NE(message.find("0 = a.frag 1 = b.glsl"), std::string::npos) << message;
  EXPECT_TRUE(names_location(message, 1, 2)) << message;
}

TEST_F(ProgramTest, CompileErrorBehindAnIncludeNamesItsLine) {
  const std::string message =
      error_of_files({{"a.frag", "// first\n#include \"b.glsl\"\nvoid main() {\n  no_such = 1.0;\n}\n"},
                      {"b.glsl", "\n\n\n\n\n\n\n"}});
  EXPECT_TRUE(names_location(message, 0, 4)) << message;
}

TEST_F(ProgramTest, MissingIncludeIsAnError) {
  EXPECT_EQ(error_of_files({{"a.frag", "#include \"no_such.glsl\"\nvoid main() {}\n"}}), "no shader file no_such.glsl");
  EXPECT_EQ(error_of_files({{"a.frag", "void main() {}\n"}}, "no_such.vert"), "no shader file no_such.vert");
}

TEST_F(ProgramTest, ShadersThatDoNotFitAreAnError) {
  const std::string message = error_of_files(
      {{"a.vert", "uniform vec4 shared_value;\nvoid main() { gl_Position = shared_value; }\n"},
       {"a.frag", "uniform vec3 shared_value;\nout vec4 color;\nvoid main() { color = shared_value.xyzz; }\n"}},
      "a.vert");
  EXPECT_NE(message.find("shaders a.vert and a.frag do not link:"), std::string::npos) << message;
}

TEST_F(ProgramTest, FileIsIncludedOnce) {
  EXPECT_EQ(error_of_files({{"a.frag",
                             "#include \"b.glsl\"\n#include \"c.glsl\"\n#include \"b.glsl\"\nout vec4 color;\n"
                             "void main() { color = vec4(one() + two()); }\n"},
                            {"b.glsl", "float one() { return 1.0; }\n"},
                            {"c.glsl", "#include \"b.glsl\"\nfloat two() { return 2.0 * one(); }"}}),
            "no error");
}

TEST_F(ProgramTest, UniformsAreFoundByName) {
  const gl::Program program =
      FormulaPixels::program("uniform float used;\nout vec4 result;\nvoid main() { result = vec4(used); }\n");
  EXPECT_GE(program.uniform("used"), 0);
  EXPECT_EQ(program.uniform("no_such"), -1);
}

TEST_F(ProgramTest, ShadersThatDoNotCompileOrLinkLeaveNoObjects) {
  const auto count_objects = [](GLuint below) {  // drivers give out small numbers
    int count = 0;
    for (GLuint id = 1; id < below; ++id) count += glIsProgram(id) || glIsShader(id);
    return count;
  };
  const std::vector<gl::ShaderSource> bad_syntax = {{"a.frag", "void main() { nonsense }\n"}};
  const std::vector<gl::ShaderSource> bad_link = {{"a.frag", "float f();\nvoid main() { gl_FragDepth = f(); }\n"}};
  for (int i = 0; i < 20; ++i) {
    EXPECT_NE(error_of_files(bad_syntax), "no error");
    EXPECT_NE(error_of_files(bad_syntax, "a.frag"), "no error");
    EXPECT_NE(error_of_files(bad_link), "no error");
    EXPECT_NE(error_of_files({}), "no error");
  }
  EXPECT_EQ(count_objects(1000), 0);
}

}  // namespace
}  // namespace litfog::test
