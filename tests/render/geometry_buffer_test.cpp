// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/geometry_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "gl/gl_test.h"
#include "reference/random_light.h"
#include "render/renderer.h"

namespace litfog::test {
using namespace render;
using namespace scene;

namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 60;
constexpr int kMapSize = 64;    // texels
constexpr float kTileSize = 4;  // metres

class GeometryBufferTest : public test::GlTest {};

/// A floor at height 0 whose normal map is noise, a random byte a channel. uv is (x, -z).
Scene noisy_floor() {
  Scene scene;
  scene.camera = {.position = {0.3f, 1.5f, 9}, .target = {0, 0, 3}, .field_of_view = 0.9f};
  Random random(7);
  Texels noise{kMapSize, kMapSize, {}};
  for (int i = 0; i < 4 * kMapSize * kMapSize; ++i) noise.rgba.push_back(std::uint8_t(random.uniform(0, 256)));
  scene.materials.push_back({.name = "noise",
                             .size_m = kTileSize,
                             .albedo = std::make_shared<const Texels>(Texels{1, 1, {255, 255, 255, 51}}),
                             .normal = std::make_shared<const Texels>(noise),
                             .specular = glm::vec3(0.5f),
                             .shininess = 20,
                             .emissive = {}});
  Mesh mesh;
  for (const glm::vec2 corner : {glm::vec2(-20, 20), glm::vec2(20, 20), glm::vec2(20, -20), glm::vec2(-20, -20)}) {
    mesh.vertices.push_back({{corner.x, 0, corner.y}, {0, 1, 0}, {1, 0, 0, 1}, {corner.x, -corner.y}});
  }
  mesh.indices = {0, 1, 2, 0, 2, 3};
  scene.models.push_back({Part{"noise", mesh}});
  scene.instances.push_back({0, glm::mat4(1)});
  return scene;
}

/// A square map and its mipmaps, in double.
class MipChain {
 public:
  explicit MipChain(const Texels& texels) {
    levels_.emplace_back();
    for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
      const std::uint8_t* texel = &texels.rgba[i];
      levels_[0].push_back(glm::dvec4(texel[0], texel[1], texel[2], texel[3]) / 255.0);
    }
    for (int size = texels.width / 2; size >= 1; size /= 2) {
      std::vector<glm::dvec4> level;
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          const auto above = [&](int dx, int dy) { return texel(levels_.back(), 2 * size, 2 * x + dx, 2 * y + dy); };
          level.push_back((above(0, 0) + above(1, 0) + above(0, 1) + above(1, 1)) / 4.0);
        }
      }
      levels_.push_back(std::move(level));
    }
  }

  /// OpenGL 3.3, 3.8.11: trilinear, repeating, at a level of detail.
  glm::dvec4 at(const glm::dvec2& uv, double level_of_detail) const {
    const double level = std::clamp(level_of_detail, 0.0, double(levels_.size() - 1));
    const auto below = std::size_t(level);
    const std::size_t above = std::min(below + 1, levels_.size() - 1);
    return glm::mix(bilinear(below, uv), bilinear(above, uv), level - double(below));
  }

 private:
  static const glm::dvec4& texel(const std::vector<glm::dvec4>& level, int size, int x, int y) {
    const auto wrapped = [size](int i) { return std::size_t(((i % size) + size) % size); };
    return level[wrapped(y) * std::size_t(size) + wrapped(x)];
  }
  glm::dvec4 bilinear(std::size_t number, const glm::dvec2& uv) const {
    const int size = kMapSize >> number;
    const glm::dvec2 position = uv * double(size) - 0.5;
    const glm::dvec2 corner = glm::floor(position);
    const glm::dvec2 fraction = position - corner;
    const auto row = [&](int dy) {
      const auto& level = levels_[number];
      return glm::mix(texel(level, size, int(corner.x), int(corner.y) + dy),
                      texel(level, size, int(corner.x) + 1, int(corner.y) + dy), fraction.x);
    };
    return glm::mix(row(0), row(1), fraction.y);
  }

  std::vector<std::vector<glm::dvec4>> levels_;
};

/// How far a sample's normal texel is outside what the map gives at the levels of detail that OpenGL leaves open.
///
/// right, down  the derivatives of uv, a pixel each
double outside_map(const MipChain& map, const GeometrySample& sample, const glm::dvec2& uv, const glm::dvec2& right,
                   const glm::dvec2& down) {
  // OpenGL 3.3, 3.8.11: a scale factor from max(m_u, m_v) to m_u + m_v. A quad of pixels has one derivative, which the
  // driver takes on either side, and a logarithm of its own: a tenth of a level.
  const glm::dvec2 m = glm::max(glm::abs(right), glm::abs(down)) * double(kMapSize);
  const double lowest = std::log2(std::max(m.x, m.y)) - 0.1;
  const double highest = std::log2(m.x + m.y) + 0.1;
  glm::dvec4 least = glm::min(map.at(uv, lowest), map.at(uv, highest));
  glm::dvec4 most = glm::max(map.at(uv, lowest), map.at(uv, highest));
  for (double level = std::ceil(lowest); level < highest; ++level) {  // linear between whole levels
    least = glm::min(least, map.at(uv, level));
    most = glm::max(most, map.at(uv, level));
  }
  const glm::dvec4 texel = sample.normal_texel;
  const glm::dvec4 outside = glm::max(glm::max(least - texel, texel - most), glm::dvec4(0.0));
  return std::max({outside.r, outside.g, outside.b, outside.a});
}

TEST_F(GeometryBufferTest, NormalTexelIsTheMapsAtALevelOfDetailThatOpenGlAllows) {
  const Scene scene = noisy_floor();
  Renderer renderer(scene, kWidth, kHeight, {});
  const GeometryBuffer geometry(kWidth, kHeight, 4);
  renderer.draw_geometry(geometry);
  const std::vector<GeometrySample> samples = geometry.read_rows(0, kHeight);
  const MipChain map(*scene.materials[0].normal);
  const auto sample_at = [&](int x, int y) -> const GeometrySample& {
    return samples[std::size_t(y * kWidth + x) * std::size_t(geometry.samples())];
  };
  const auto uv_at = [&](int x, int y) {
    const glm::dvec3 position = sample_at(x, y).position;
    return glm::dvec2(position.x, -position.z) / double(kTileSize);
  };
  // Filter weights and mipmaps of eight bits: a level for each of three directions, and one for the mipmaps' rounding.
  constexpr double kTolerance = 4.0 / 255;
  int compared = 0;
  for (int y = 1; y + 1 < kHeight; ++y) {
    for (int x = 1; x + 1 < kWidth; ++x) {
      const auto is_inside = [&](int dx, int dy) {
        const GeometrySample& sample = sample_at(x + dx, y + dy);
        return sample.material == 0 && std::abs(sample.position.x) < 19 && std::abs(sample.position.z) < 19;
      };
      if (!is_inside(0, 0) || !is_inside(1, 0) || !is_inside(-1, 0) || !is_inside(0, 1) || !is_inside(0, -1)) continue;
      const GeometrySample& sample = sample_at(x, y);
      EXPECT_LT(glm::distance(sample.tangent, glm::vec4(1, 0, 0, 1)), 1e-6f);
      EXPECT_LT(glm::distance(sample.normal, glm::vec3(0, 1, 0)), 1e-6f);
      EXPECT_NEAR(sample.gloss, 0.2f, 1e-6f);
      EXPECT_LE(outside_map(map, sample, uv_at(x, y), (uv_at(x + 1, y) - uv_at(x - 1, y)) / 2.0,
                            (uv_at(x, y + 1) - uv_at(x, y - 1)) / 2.0),
                kTolerance)
          << x << ", " << y;
      ++compared;
    }
  }
  EXPECT_GT(compared, kWidth * kHeight / 2);
}

}  // namespace

}  // namespace litfog::test
