// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/shader_library.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"

namespace litfog::test {
namespace {

TEST(ShaderLibrary, LibraryHoldsTheInstalledFiles) {
  std::set<std::string_view> names;
  for (const gl::ShaderSource& source : gl::shader_library()) {
    names.insert(source.name);
    EXPECT_TRUE(source.text.starts_with("// SPDX-License-Identifier: Apache-2.0")) << source.name;
  }
  const std::set<std::string_view> expected = {"litfog/shaders/airlight.glsl",
                                               "litfog/shaders/airlight_bound.glsl",
                                               "litfog/shaders/cone_profile.glsl",
                                               "litfog/shaders/density_profile.glsl",
                                               "litfog/shaders/diffuse_light.glsl",
                                               "litfog/shaders/directional_airlight.glsl",
                                               "litfog/shaders/expm1.glsl",
                                               "litfog/shaders/far_airlight.glsl",
                                               "litfog/shaders/fog.glsl",
                                               "litfog/shaders/formulas.glsl",
                                               "litfog/shaders/layered_scattering.glsl",
                                               "litfog/shaders/light.glsl",
                                               "litfog/shaders/light_airlight.glsl",
                                               "litfog/shaders/light_block.glsl",
                                               "litfog/shaders/light_buffer.glsl",
                                               "litfog/shaders/light_clusters.glsl",
                                               "litfog/shaders/multiple_scattering.glsl",
                                               "litfog/shaders/phase.glsl",
                                               "litfog/shaders/surface.glsl"};
  EXPECT_EQ(names, expected);
}

// Covers each macro defined, and each type, function, block, variable and constant declared outside braces.
TEST(ShaderLibrary, EveryNameBeginsWithLitfog) {
  const std::regex declaration(
      R"((?:^|\n)(?:#define (\w+)|(?:layout\([^)]*\) )?(?!precision|layout)[a-zA-Z]\w*(?: \w+)*? (\w+) ?[({;=\[]))");
  for (const gl::ShaderSource& source : gl::shader_library()) {
    const std::string text(source.text);
    int names = 0;
    for (std::sregex_iterator found(text.begin(), text.end(), declaration), end; found != end; ++found, ++names) {
      const std::string name = (*found)[1].matched ? (*found)[1] : (*found)[2];
      EXPECT_TRUE(std::regex_search(name, std::regex("^(LITFOG_|Litfog|litfog_)"))) << source.name << ": " << name;
    }
    EXPECT_GE(names, 2) << source.name;
  }
}

using ShaderLibraryTest = GlTest;

TEST_F(ShaderLibraryTest, EachShaderCompilesAlone) {
  for (const gl::ShaderSource& source : gl::shader_library()) {
    const std::string text =
        "#include \"" + std::string(source.name) + "\"\nout vec4 result;\nvoid main() { result = vec4(1.0); }\n";
    EXPECT_NO_THROW(FormulaPixels::program(text)) << source.name;
  }
}

}  // namespace
}  // namespace litfog::test
