// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/light_cluster_tables.h"
#include "reference/random_bounds.h"

namespace litfog::test {
namespace {

using glm::vec4;

constexpr int kListed = 40;     // of a list, that are read
constexpr int kRowTexels = 37;  // texels of a 2-D texture, whose rows split the words of a cluster

class LightClustersShader : public GlTest {
 protected:
  LightClustersShader() {
    Random random(80);
    clusters_.resize(200);
    for (std::size_t i = 0; i < clusters_.size(); ++i) clusters_.set_light(i, draw_bounds(random, view_));
    clusters_.update(view_);
  }

  static gl::Program program(const std::string& form) {
    return FormulaPixels::program(form + R"(
#include "litfog/shaders/light_clusters.glsl"
#include "test/input.glsl"
void main() {
  LitfogLightList at = litfog_lights_at(given(0).xy, given(0).z);
  LitfogLightList along = litfog_lights_along(given(0).xy, given(0).z);
  int i = int(given(0).w);
  result = vec4(at.count, along.count, i < at.count ? litfog_listed_light(at, i) : -1,
                i < along.count ? litfog_listed_light(along, i) : -1);
}
)");
  }

  /// The lists of a point in each cluster, read from a texture of unit 1 or a storage buffer that is bound.
  void expect_every_list(const gl::Program& program) const {
    program.use();
    glUniform1i(program.uniform("litfog_cluster_buffer"), 1);
    FormulaPixels pixels;
    Random random(81);
    std::size_t entries = 0;
    for (std::size_t cluster = 0; cluster < clusters_.clusters().size(); ++cluster) {
      const View part = clusters_.part_of_view(cluster);
      const auto inside = [&] { return random.uniform(0.001, 0.999); };
      const auto place = [&](double low, double high, double from, double to) {
        return float((std::lerp(low, high, inside()) - from) / (to - from));
      };
      const float x = place(part.left, part.right, view_.left, view_.right);
      const float y = place(part.bottom, part.top, view_.bottom, view_.top);
      const auto depth = float(std::lerp(part.nearest, part.farthest, inside()));
      std::vector<vec4> inputs;
      for (int i = 0; i < kListed; ++i) inputs.emplace_back(x, y, depth, i);
      const std::vector<vec4> results = pixels.draw(program, {inputs});
      const Cluster& list = clusters_.clusters()[cluster];
      const auto at = clusters_.light_list().subspan(list.first, list.count);
      const auto along = clusters_.lights_along(cluster);
      const auto entry = [](std::span<const std::uint32_t> lights, std::size_t i) {
        return i < lights.size() ? float(lights[i]) : -1;
      };
      for (std::size_t i = 0; i < kListed; ++i) {
        ASSERT_EQ(results[i], vec4(at.size(), along.size(), entry(at, i), entry(along, i))) << cluster << ", " << i;
      }
      entries += along.size();
    }
    EXPECT_GT(entries, 1000u);
  }

  const View view_{.left = -0.8, .right = 0.6, .bottom = -0.4, .top = 0.5, .nearest = 0.1, .farthest = 500};
  LightClusters clusters_{ClusterGrid{.columns = 7, .rows = 5, .slices = 6, .first_depth = 3}};
};

TEST_F(LightClustersShader, EveryListOfABufferTextureIsRead) {
  gl::LightClusterTables tables;
  tables.upload(clusters_);
  tables.bind_texture(1);
  expect_every_list(program(""));
}

TEST_F(LightClustersShader, EveryListOfAStorageBufferIsRead) {
  gl::LightClusterTables tables;
  tables.upload(clusters_);
  tables.bind_storage(3);
  expect_every_list(program(R"(
#extension GL_ARB_shader_storage_buffer_object : require
#extension GL_ARB_shading_language_420pack : require
#define LITFOG_LIGHT_STORAGE
#define LITFOG_CLUSTER_BINDING 3
)"));
}

TEST_F(LightClustersShader, EveryListOfATextureWhoseRowsSplitClustersIsRead) {
  const gl::TextureName texture;
  std::vector<std::uint32_t> texels(clusters_.table().begin(), clusters_.table().end());
  texels.resize((texels.size() + kRowTexels - 1) / kRowTexels * kRowTexels);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, kRowTexels, GLsizei(texels.size() / kRowTexels), 0, GL_RED_INTEGER,
               GL_UNSIGNED_INT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  expect_every_list(program("#define LITFOG_LIGHT_TEXTURE\n"));
}

TEST_F(LightClustersShader, PointsOutsideTheViewHaveTheListsOfTheNearestClusters) {
  gl::LightClusterTables tables;
  tables.upload(clusters_);
  tables.bind_texture(1);
  const gl::Program any = program("");
  any.use();
  glUniform1i(any.uniform("litfog_cluster_buffer"), 1);
  FormulaPixels pixels;
  const auto counts = [&](float x, float y, float depth) {
    return glm::vec2(pixels.draw(any, {{vec4(x, y, depth, 0)}})[0]);
  };
  for (const float depth : {0.0f, 1e-30f, 0.05f}) EXPECT_EQ(counts(0.1f, 0.1f, depth), counts(0.1f, 0.1f, 0.2f));
  for (const float depth : {600.0f, 1e30f}) EXPECT_EQ(counts(0.1f, 0.1f, depth), counts(0.1f, 0.1f, 499));
  EXPECT_EQ(counts(-0.5f, 2, 50), counts(0.01f, 0.99f, 50));
}

}  // namespace
}  // namespace litfog::test
