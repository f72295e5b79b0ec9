// SPDX-License-Identifier: Apache-2.0
#include "render/airlight/airlight_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "reference/random_light.h"

namespace litfog::test {
using namespace render;

namespace {

constexpr int kBeyond = 8;  // pixels

/// Lights around a camera, some with cones, in ranges of several kinds.
AirlightList draw_airlights(Random& random, const scene::Camera& camera, unsigned count) {
  AirlightList list;
  for (unsigned i = 0; i < count; ++i) {
    LightBounds bounds{.position = glm::dvec3(camera.position) + random.log_uniform(0.1, 1000) * draw_direction(random),
                       .direction = draw_direction(random),
                       .range = random.log_uniform(0.01, 300)};
    if (random.chance(0.5)) bounds.half_angle = random.uniform(0.01, std::numbers::pi);
    list.entries.push_back({.light = float(i), .reach = float(bounds.range), .bend_range = 0, .width = 0});
    list.bounds.push_back(bounds);
  }
  for (unsigned first = 0; first < count; first += count / 4) {
    list.ranges.push_back(
        {.kind = {.profile = int(first)}, .first = first, .count = std::min(count / 4, count - first)});
  }
  return list;
}

/// The direction through the middle of a pixel.
glm::dvec3 ray_through(const scene::Camera& camera, glm::ivec2 picture_size, glm::ivec2 pixel) {
  const scene::CameraAxes axes = scene::axes_of(camera);
  const double slope = 2 * std::tan(double(camera.field_of_view) / 2) / picture_size.y;
  const glm::dvec2 place = slope * (glm::dvec2(pixel) + 0.5 - 0.5 * glm::dvec2(picture_size));
  return glm::normalize(axes.forward + place.x * axes.right + place.y * axes.up);
}

/// Whether one of many points of a ray is lit.
bool is_lit_on(const LightBounds& light, const glm::dvec3& eye, const glm::dvec3& direction) {
  const glm::dvec3 to_light = light.position - eye;
  const double approach = glm::dot(to_light, direction);
  const double square = glm::dot(to_light, to_light) - approach * approach;
  if (square >= light.range * light.range) return false;
  const double chord = std::sqrt(light.range * light.range - square);
  for (int i = 1; i < 200; ++i) {
    const double along = approach + chord * (i / 100.0 - 1);
    if (along <= 0) continue;
    const glm::dvec3 from_light = eye + along * direction - light.position;
    const double cosine = glm::dot(from_light, light.direction) / glm::length(from_light);
    if (std::acos(std::clamp(cosine, -1.0, 1.0)) < light.half_angle) return true;
  }
  return false;
}

/// The entries of a range that a pixel's tile has, found as the shader finds them.
std::span<const std::int32_t> entries_at(const AirlightTiles& tiles, std::size_t range, glm::ivec2 pixel) {
  const glm::vec2 size = glm::vec2(tiles.size) / glm::vec2(tiles.count);
  const glm::ivec2 tile = glm::min(glm::ivec2((glm::vec2(pixel) + 0.5f) / size), tiles.count - 1);
  const std::size_t place =
      2 * (range * std::size_t(tiles.count.x * tiles.count.y) + std::size_t(tile.y * tiles.count.x + tile.x));
  return std::span(tiles.lists)
      .subspan(std::size_t(tiles.lists[place]), std::size_t(tiles.lists[place + 1] - tiles.lists[place]));
}

TEST(AirlightTiles, EveryLightOnAPixelsRayIsInItsTile) {
  Random random(41);
  int lit = 0;
  std::size_t listed = 0;
  for (int i = 0; i < 60; ++i) {
    const scene::Camera camera{.position = glm::vec3(100. * draw_direction(random)),
                               .target = glm::vec3(glm::dvec3(random.uniform(-300, 300), random.uniform(-40, 40), 500)),
                               .field_of_view = float(random.uniform(0.05, 2.98))};
    const glm::ivec2 picture_size(random.log_uniform(4, 2500), random.log_uniform(4, 1500));
    const AirlightList list = draw_airlights(random, camera, 100);
    const AirlightTiles tiles = list_airlight_tiles(list, camera, picture_size, kBeyond);
    for (int ray = 0; ray < 60; ++ray) {
      const glm::ivec2 pixel(random.uniform(0, picture_size.x + kBeyond), random.uniform(0, picture_size.y + kBeyond));
      const glm::dvec3 direction = ray_through(camera, picture_size, pixel);
      for (std::size_t range = 0; range < list.ranges.size(); ++range) {
        const auto [kind, first, count] = list.ranges[range];
        const auto entries = entries_at(tiles, range, pixel);
        EXPECT_TRUE(std::ranges::is_sorted(entries));
        listed += entries.size();
        for (unsigned entry = first; entry < first + count; ++entry) {
          const bool is_lit = is_lit_on(list.bounds[entry], camera.position, direction);
          lit += int(is_lit);
          if (!is_lit) continue;
          EXPECT_TRUE(std::ranges::binary_search(entries, std::int32_t(entry))) << i << ' ' << entry;
        }
        for (const std::int32_t entry : entries) {
          EXPECT_TRUE(unsigned(entry) >= first && unsigned(entry) < first + count) << entry;
        }
      }
    }
  }
  EXPECT_GT(lit, 5000);
  EXPECT_LT(double(listed), 4 * double(lit)) << "tiles list what they do not need";
}

TEST(AirlightTiles, ViewWiderThanClustersTakeIsOneTileOfAllLights) {
  Random random(42);
  const scene::Camera camera{.field_of_view = 2.98f};
  const AirlightList list = draw_airlights(random, camera, 40);
  const AirlightTiles tiles = list_airlight_tiles(list, camera, {1600, 900}, kBeyond);
  EXPECT_EQ(tiles.count, glm::ivec2(1));
  for (std::size_t range = 0; range < list.ranges.size(); ++range) {
    EXPECT_EQ(entries_at(tiles, range, {3, 3}).size(), list.ranges[range].count);
  }
}

}  // namespace
}  // namespace litfog::test
