// SPDX-License-Identifier: Apache-2.0
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "gl/formula_pixels.h"
#include "gl/gl_test.h"
#include "litfog/airlight.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/fog_light_tables.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/light_cluster_tables.h"
#include "litfog/updater.h"
#include "reference/random_bounds.h"

namespace litfog::test {
namespace {

using glm::dvec3;
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
  const gl::Program any = program("");
  any.use();
  tables.bind_texture(any, 1);
  FormulaPixels pixels;
  const auto counts = [&](float x, float y, float depth) {
    return glm::vec2(pixels.draw(any, {{vec4(x, y, depth, 0)}})[0]);
  };
  for (const float depth : {0.0f, 1e-30f, 0.05f}) EXPECT_EQ(counts(0.1f, 0.1f, depth), counts(0.1f, 0.1f, 0.2f));
  for (const float depth : {600.0f, 1e30f}) EXPECT_EQ(counts(0.1f, 0.1f, depth), counts(0.1f, 0.1f, 499));
  EXPECT_EQ(counts(-0.5f, 2, 50), counts(0.01f, 0.99f, 50));
}

TEST_F(LightClustersShader, SumsOverAListAreThoseOfTheLibraryOverAllLights) {
  Random random(82);
  const Atmosphere air{.fog = {FogMode::exp, 0.01}};
  FogUpdater updater;
  std::vector<PlacedLight> lamps;
  for (int i = 0; i < 60; ++i) {
    PlacedLight& lamp = lamps.emplace_back();
    lamp.light.color = {1, 2, 3};
    lamp.light.attenuation = {1, 0, 0.05};
    if (i % 2 == 0) lamp.light.cone = Cone::smoothstep(0.6, 1.2);
    lamp.position = {random.uniform(-40, 40), random.uniform(2, 6), random.uniform(-90, -5)};
    lamp.direction = {0, -1, 0};
    updater.add(lamp);
  }
  const FogLightChanges changes = updater.set_fog(air.fog);
  const double step = 1e-5;
  updater.bound_lights(clusters_, air, step);
  clusters_.update(view_);
  gl::LightClusterTables cluster_tables;
  cluster_tables.upload(clusters_);
  gl::FogLightTables tables;
  tables.upload(updater.kinds(), updater.instances(), changes);
  gl::FogLightBuffer fog_block;
  fog_block.upload(pack_fog_header(air, 0));
  const gl::Program sums = FormulaPixels::program(R"(
#include "litfog/shaders/light_clusters.glsl"
#include "test/input.glsl"
void main() {
  vec2 place = given(1).xy;
  vec4 ray = litfog_ray(vec3(0.0), given(0).xyz);
  result.rg = litfog_listed_surface_light(litfog_lights_at(place, -given(0).z), given(0).xyz, vec3(0.0, 1.0, 0.0)).rb;
  result.ba = litfog_listed_airlight(litfog_lights_along(place, -given(0).z), vec3(0.0), ray.xyz, ray.w).rb;
}
)");
  sums.use();
  cluster_tables.bind_texture(sums, 1);
  tables.bind_textures(sums, 2, 3);
  fog_block.bind(sums, 0);
  std::vector<vec4> points;
  std::vector<vec4> places;
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(0.01, 0.99), y = random.uniform(0.01, 0.99), depth = random.uniform(2, 100);
    points.emplace_back(depth * std::lerp(view_.left, view_.right, x), depth * std::lerp(view_.bottom, view_.top, y),
                        -depth, 0);
    places.emplace_back(x, y, 0, 0);
  }
  const std::vector<vec4> results = FormulaPixels().draw(sums, {points, places});
  double brightest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3 point(points[i]);
    const EyeRay ray{{0, 0, 0}, glm::normalize(point), glm::length(point)};
    double surface = 0;
    double fog = 0;
    for (const PlacedLight& lamp : lamps) {
      const double range = glm::distance(lamp.position, point);
      const dvec3 to_point = (point - lamp.position) / range;
      const bool reaches = range <= compute_extent(lamp.light.attenuation, lamp.light.threshold);
      surface += reaches ? attenuation_at(lamp.light.attenuation, range) * fog_factor_at(air.fog, range) *
                               cone_at(lamp.light.cone, glm::dot(to_point, lamp.direction)) * std::max(-to_point.y, 0.)
                         : 0;
      fog += kAirlightUnit * airlight(lamp, air, ray);
    }
    // The lists leave out less than the step; the shader's sums are the library's but for the rounding of floats.
    const vec4 sums_of_library(surface, 3 * surface, fog, 3 * fog);
    for (int k = 0; k < 4; ++k) {
      EXPECT_NEAR(results[i][k], sums_of_library[k], 3 * step + 1e-4 * double(sums_of_library[k])) << i << ", " << k;
    }
    brightest = std::max(brightest, surface);
  }
  EXPECT_GT(brightest, 0.1) << "no point is lit";
}

}  // namespace
}  // namespace litfog::test
