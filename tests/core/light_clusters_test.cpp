// SPDX-License-Identifier: Apache-2.0
#include "litfog/light_clusters.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <new>
#include <thread>

#include "core/allocation_count.h"
#include "core/cluster_lists.h"
#include "core/simd_targets.h"
#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/random_bounds.h"

namespace litfog::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Street lamps, windows' glow and headlights over a square kilometre, seen from the height of a head.
struct City {
  std::vector<LightBounds> lights;
  View view{
      .eye = {0, 1.7, 0}, .left = -0.8, .right = 0.8, .bottom = -0.45, .top = 0.45, .nearest = 0.1, .farthest = 4000};

  explicit City(std::size_t count) {
    Random random(73);
    for (std::size_t i = 0; i < count; ++i) {
      LightBounds light{.position = {random.uniform(-500, 500), 8, random.uniform(-500, 500)},
                        .direction = {0, -1, 0},
                        .range = random.uniform(15, 30),
                        .half_angle = random.uniform(1.0, 1.4)};
      if (i % 3 == 1) light = {.position = light.position, .range = random.uniform(3, 10)};
      if (i % 3 == 2) {
        light.position.y = 0.7;
        const double angle = random.uniform(0, 2 * kPi);
        light.direction = glm::normalize(glm::dvec3(std::cos(angle), -0.05, std::sin(angle)));
        light.range = random.uniform(30, 60);
        light.half_angle = random.uniform(0.2, 0.6);
      }
      lights.push_back(light);
    }
  }
};

// --- completeness ---

TEST(LightClusters, NoLightIsMissingWhereItLightsAPoint) {
  for_each_simd_target([](const char*) {
    Random random(74);
    int points = 0;
    for (int i = 0; i < 150 && !testing::Test::HasFailure(); ++i) points += expect_complete(random, draw_view(random));
    EXPECT_GT(points, 50000);
  });
}

TEST(LightClusters, LampInTheEyeThatShinesThroughAClustersMiddleIsInEachAlongItsAxis) {
  const View view{.bottom = -0.5625, .top = 0.5625};  // 16 x 9 columns and rows of exact tangents
  LightClusters clusters;
  clusters.resize(1);
  for (int column = 0; column < 16; ++column) {
    for (int row = 0; row < 9; ++row) {
      const glm::dvec3 axis = glm::normalize(glm::dvec3((column - 7.5) / 8, (row - 4) / 8.0, -1));
      clusters.set_light(0, {.position = {0, 0, 0}, .direction = axis, .range = 50, .half_angle = 0.5});
      clusters.update(view);
      for (int metres = 1; metres < 50; ++metres) {
        const auto cluster = clusters.cluster_at(double(metres) * axis);
        if (!cluster) continue;  // before the nearest plane
        EXPECT_TRUE(has_light(clusters, *cluster, 0)) << metres << " m, column " << column << ", row " << row;
      }
    }
  }
}

TEST(LightClusters, LightsAlongARayAreThoseOfTheClustersThatItPasses) {
  Random random(79);
  std::size_t listed = 0;
  for (int i = 0; i < 30; ++i) {
    const View view = draw_view(random);
    LightClusters clusters(draw_grid(random, view));
    EXPECT_EQ(clusters.lights_along(0).size(), 0u);
    std::vector<LightBounds> lights;
    for (int k = 0; k < 100; ++k) lights.push_back(draw_bounds(random, view));
    set_lights(clusters, lights);
    clusters.update(view);
    const std::size_t tiles = std::size_t(clusters.grid().columns) * clusters.grid().rows;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
      std::vector<std::uint32_t> expected;
      for (std::size_t cluster = tile; cluster < clusters.clusters().size(); cluster += tiles) {
        for (const std::uint32_t light : lights_of(clusters, cluster)) {
          if (std::ranges::find(expected, light) == expected.end()) expected.push_back(light);
        }
        ASSERT_TRUE(std::ranges::equal(clusters.lights_along(cluster), expected)) << cluster;
        ASSERT_TRUE(std::ranges::equal(list_of_table(clusters, cluster, 0), lights_of(clusters, cluster))) << cluster;
        ASSERT_TRUE(std::ranges::equal(list_of_table(clusters, cluster, 2), expected)) << cluster;
      }
      listed += expected.size();
    }
  }
  EXPECT_GT(listed, 10000u);
}

TEST(LightClusters, TableChangesWithTheLookUpAlone) {
  LightClusters clusters;
  View view;
  clusters.update(view);
  EXPECT_FALSE(clusters.update(view));
  view.farthest /= 2;
  EXPECT_TRUE(clusters.update(view));
  const float bias = clusters.lookup().slice_bias;
  EXPECT_EQ(clusters.table()[4], std::bit_cast<std::uint32_t>(bias));
}

TEST(LightClusters, NoLightIsMissingInTheSmallestViews) {
  for_each_simd_target([](const char*) {
    Random random(75);
    int points = 0;
    for (int i = 0; i < 50 && !testing::Test::HasFailure(); ++i) {
      View view = draw_view(random);
      view.eye = {};
      view.nearest *= 1e-11 / view.farthest;
      view.farthest = 1e-11;
      points += expect_complete(random, view);
    }
    EXPECT_GT(points, 10000);
  });
}

TEST(LightClusters, LightIsInEveryClusterThatTheExactTestSeesIn) {
  Random random(75);
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    const View view = draw_view(random);
    ClusterGrid grid = draw_grid(random, view);
    grid.columns = std::min(grid.columns, 6u);
    grid.rows = std::min(grid.rows, 6u);
    grid.slices = std::min(grid.slices, 6u);
    LightClusters clusters(grid);
    std::vector<LightBounds> lights;
    for (int k = 0; k < 20; ++k) {
      lights.push_back(draw_bounds(random, view));
      // the exact test's answers for wider lights may be true where nothing is lit
      if (lights.back().half_angle > kPi / 2) lights.back().half_angle = kPi;
    }
    set_lights(clusters, lights);
    clusters.update(view);
    for (std::size_t cluster = 0; cluster < clusters.clusters().size(); ++cluster) {
      const ViewFrustum part(clusters.part_of_view(cluster));
      for (std::size_t light = 0; light < lights.size(); ++light) {
        if (!part.can_see(lights[light])) continue;
        ++seen;
        ASSERT_TRUE(has_light(clusters, cluster, light)) << to_string(clusters.part_of_view(cluster), lights[light]);
      }
    }
  }
  std::printf("%d clusters with a light\n", seen);
  EXPECT_GT(seen, 1000);
}

TEST(LightClusters, LightThatOnlyTouchesAClusterIsInIt) {
  Random random(78);
  for (int i = 0; i < 200; ++i) {
    const View view = draw_view(random);
    LightClusters clusters(draw_grid(random, view));
    clusters.update(view);
    std::vector<LightBounds> lights;
    std::vector<std::size_t> touched;
    for (int k = 0; k < 100; ++k) {
      touched.push_back(std::size_t(random.below(int(clusters.clusters().size()))));
      const View part = clusters.part_of_view(touched.back());
      // A point of a face and the face's normal.
      const glm::dmat3 axes = axes_of(view);
      glm::dvec3 tangents{random.uniform(part.left, part.right), random.uniform(part.bottom, part.top), 1};
      double depth = random.uniform(part.nearest, part.farthest);
      const double sign = random.chance(0.5) ? 1 : -1;
      const int face = random.below(3);
      glm::dvec3 normal{0};
      if (face == 0) tangents.x = sign > 0 ? part.right : part.left;
      if (face == 1) tangents.y = sign > 0 ? part.top : part.bottom;
      if (face == 2) depth = sign > 0 ? part.farthest : part.nearest;
      normal[face] = sign;
      if (face < 2) normal.z = -sign * tangents[face];
      const glm::dvec3 outward = axes * glm::normalize(normal);
      const glm::dvec3 point = view.eye + axes * (depth * tangents);
      LightBounds light{.range = depth * random.log_uniform(1e-3, 1)};
      light.position = point + light.range * outward;
      light.range = glm::distance(light.position, point);
      if (random.chance(0.5)) {  // the point is on the rim
        light.half_angle = random.uniform(0.1, 2);
        light.direction = glm::normalize(std::sin(light.half_angle) * draw_perpendicular(random, outward) -
                                         std::cos(light.half_angle) * outward);
      }
      if (random.chance(0.5) && light.half_angle < kPi / 2) light.range = 3 * light.range;  // touches beside the cone
      lights.push_back(light);
    }
    set_lights(clusters, lights);
    clusters.update(view);
    for (std::size_t light = 0; light < lights.size(); ++light) {
      ASSERT_TRUE(has_light(clusters, touched[light], light)) << to_string(view, lights[light]);
    }
  }
}

/// Bart Wronski's test of a cone against the ball around a cluster ("Cull that cone!", 2017), with the distances
/// between ball and light. For comparison.
bool meets_ball_around(const View& part, const LightBounds& light) {
  glm::dvec3 low{kInfinity};
  glm::dvec3 high{-kInfinity};
  for (const glm::dvec3& corner : corners_of(part)) {
    low = glm::min(low, part.eye + corner);
    high = glm::max(high, part.eye + corner);
  }
  const double radius = glm::distance(low, high) / 2;
  const glm::dvec3 offset = (low + high) * 0.5 - light.position;
  const double along = glm::dot(offset, light.direction);
  const double across = std::sqrt(std::max(0.0, glm::dot(offset, offset) - along * along));
  const double from_cone = std::cos(light.half_angle) * across - std::sin(light.half_angle) * along;
  const bool is_beside = light.half_angle < kPi && from_cone > radius;
  return !is_beside && along <= radius + light.range && (light.half_angle > kPi / 2 || along >= -radius) &&
         glm::length(offset) <= radius + light.range;
}

TEST(LightClusters, FewEntriesOfACityAreSuperfluous) {
  const City city(3000);
  LightClusters clusters = clusters_of(city.lights, city.view);
  std::size_t superfluous = 0;
  std::size_t by_balls = 0;
  for (std::size_t cluster = 0; cluster < clusters.clusters().size(); ++cluster) {
    const View part = clusters.part_of_view(cluster);
    const ViewFrustum frustum(part);
    for (const std::uint32_t light : lights_of(clusters, cluster)) superfluous += !frustum.can_see(city.lights[light]);
    for (const LightBounds& light : city.lights) by_balls += meets_ball_around(part, light);
  }
  const double entries = double(clusters.light_list().size());
  std::printf("%.0f entries, %.2f %% superfluous; %zu by balls around clusters\n", entries,
              100 * double(superfluous) / entries, by_balls);
  EXPECT_GT(entries, 5000);
  EXPECT_LE(double(superfluous), kClusterExcess * entries);
}

/// The fraction of superfluous entries where all sorts of views and lights are drawn.
TEST(LightClusters, FewEntriesOfRandomViewsAreSuperfluous) {
  Random random(76);
  std::size_t entries = 0;
  std::size_t superfluous = 0;
  for (int i = 0; i < 100; ++i) {
    const View view = draw_view(random);
    std::vector<LightBounds> lights;
    for (int k = 0; k < 20; ++k) lights.push_back(draw_bounds(random, view));
    const LightClusters clusters = clusters_of(
        lights, view, {.columns = 8, .rows = 5, .slices = 8, .first_depth = std::sqrt(view.nearest * view.farthest)});
    entries += clusters.light_list().size();
    for (std::size_t cluster = 0; cluster < clusters.clusters().size(); ++cluster) {
      const ViewFrustum part(clusters.part_of_view(cluster));
      for (const std::uint32_t light : lights_of(clusters, cluster)) superfluous += !part.can_see(lights[light]);
    }
  }
  std::printf("%zu entries, %.2f %% superfluous\n", entries, 100 * double(superfluous) / double(entries));
  EXPECT_GT(entries, 50000u);
  EXPECT_LE(double(superfluous), kClusterExcess * double(entries));
}

// --- the lists ---

TEST(LightClusters, ListsFollowEachOtherInTheOrderOfClustersAndLights) {
  const City city(500);
  LightClusters clusters = clusters_of(city.lights, city.view);
  std::uint32_t first = 0;
  for (std::size_t cluster = 0; cluster < clusters.clusters().size(); ++cluster) {
    EXPECT_EQ(clusters.clusters()[cluster].first, first);
    first += clusters.clusters()[cluster].count;
    const auto lights = lights_of(clusters, cluster);
    EXPECT_EQ(std::ranges::adjacent_find(lights, std::ranges::greater_equal{}), lights.end());
  }
  EXPECT_EQ(clusters.light_list().size(), first);
  EXPECT_EQ(clusters.statistics().entries, first);
}

RC_GTEST_PROP(LightClusters, ListsDependOnLightsAndViewAlone, ()) {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 6));
  Random random(seed);
  City city(150);
  LightClusters clusters;
  set_lights(clusters, city.lights);
  bool has_updated = false;
  for (const int step : steps) {
    const auto some = [&] { return city.lights.empty() ? 0 : std::size_t(random.below(int(city.lights.size()))); };
    if (step == 0) city.view.eye.x += random.uniform(-50, 50);
    if (step == 1) city.lights.resize(std::size_t(random.below(300)), {.range = 0});
    if (step == 1) clusters.resize(city.lights.size());
    if (step == 2 && !city.lights.empty()) {
      const std::size_t light = some();
      city.lights[light] = draw_bounds(random, city.view);
      clusters.set_light(light, city.lights[light]);
    }
    if (step == 3 && !city.lights.empty()) {
      const std::size_t light = some();
      city.lights[light].range = 0;
      clusters.set_light(light, city.lights[light]);
    }
    if (step < 4) continue;
    const Lists before(clusters);
    const bool has_changed = clusters.update(city.view);
    RC_ASSERT(has_changed == (!has_updated || !(Lists(clusters) == before)));
    has_updated = true;
    LightClusters fresh = clusters_of(city.lights, city.view);
    RC_ASSERT(Lists(clusters) == Lists(fresh));
    RC_ASSERT(clusters.statistics().lights_in_view == fresh.statistics().lights_in_view);
  }
}

TEST(LightClusters, NothingIsTestedAgainWhileNothingChanges) {
  const City city(1000);
  LightClusters clusters;
  set_lights(clusters, city.lights);
  EXPECT_TRUE(clusters.update(city.view));
  EXPECT_EQ(clusters.statistics().lights_tested, 1000u);
  EXPECT_FALSE(clusters.update(city.view));
  EXPECT_EQ(clusters.statistics().lights_tested, 0u);
  set_lights(clusters, city.lights);  // the same
  EXPECT_FALSE(clusters.update(city.view));
  EXPECT_EQ(clusters.statistics().lights_tested, 0u);
  LightBounds changed = city.lights[500];
  changed.range = 0;
  clusters.set_light(500, changed);
  clusters.update(city.view);
  EXPECT_EQ(clusters.statistics().lights_tested, 64u);
}

TEST(LightClusters, LightThatStaysInItsClustersChangesNothing) {
  LightClusters clusters;
  clusters.resize(1);
  clusters.set_light(0, {.position = {0.1, 0.1, -100}, .range = 1});
  EXPECT_TRUE(clusters.update(View{}));
  clusters.set_light(0, {.position = {0.1, 0.1, -100}, .range = 1.001});
  EXPECT_FALSE(clusters.update(View{}));
  EXPECT_EQ(clusters.statistics().lights_tested, 1u);
}

TEST(LightClusters, FlightThatWasFlownBeforeAllocatesNothing) {
  City city(2000);
  LightClusters clusters;
  set_lights(clusters, city.lights);
  const auto fly = [&] {
    for (int frame = 0; frame < 100; ++frame) {
      const double angle = 0.07 * frame;
      city.view.forward = {std::sin(angle), 0, -std::cos(angle)};
      LightBounds light = city.lights[7];
      light.range = 10 + frame % 10;
      clusters.set_light(7, light);
      clusters.update(city.view);
    }
  };
  fly();
  fly();  // from the flight's last view to its first
  const std::size_t before = allocation_count();
  fly();
  EXPECT_EQ(allocation_count(), before);
}

TEST(LightClusters, CallThatRunsOutOfMemoryLeavesTheListsAndTheNextOneMakesThem) {
  Random random(71);
  LightClusters clusters({.columns = 5, .rows = 4, .slices = 6, .first_depth = 3});
  std::vector<LightBounds> lights;
  std::size_t failed = 0;
  for (int step = 0; step < 30; ++step) {
    View view = draw_view(random);
    view.nearest = 1;
    view.farthest = 500;
    const auto expect_unchanged_without_memory = [&](const auto& call) {
      const std::vector<std::uint32_t> table(clusters.table().begin(), clusters.table().end());
      const Lists lists(clusters);
      const std::size_t size = clusters.size();
      failed += fail_each_allocation(
          [&] {
            try {
              call();
            } catch (const std::bad_alloc&) {
            }
          },
          [&] {
            EXPECT_TRUE(std::ranges::equal(clusters.table(), table));
            EXPECT_TRUE(Lists(clusters) == lists);
            EXPECT_EQ(clusters.size(), size);
          });
    };
    lights.resize(std::size_t(random.below(400)), {.range = 0});
    expect_unchanged_without_memory([&] { clusters.resize(lights.size()); });
    for (std::size_t i = 0; i < lights.size(); i += 1 + std::size_t(random.below(5))) {
      lights[i] = draw_bounds(random, view);
      clusters.set_light(i, lights[i]);
    }
    expect_unchanged_without_memory([&] { clusters.update(view); });
    LightClusters fresh = clusters_of(lights, view, clusters.grid());
    EXPECT_TRUE(Lists(clusters) == Lists(fresh));
    EXPECT_TRUE(std::ranges::equal(clusters.table(), fresh.table()));
  }
  EXPECT_GT(failed, 15u);
}

TEST(LightClusters, TwoObjectsServeTwoThreads) {
  const City city(2000);
  const auto run = [&](std::vector<std::uint32_t>& list) {
    LightClusters clusters = clusters_of(city.lights, city.view);
    list.assign(clusters.light_list().begin(), clusters.light_list().end());
  };
  std::array<std::vector<std::uint32_t>, 3> lists;
  std::thread first([&] { run(lists[0]); });
  std::thread second([&] { run(lists[1]); });
  first.join();
  second.join();
  run(lists[2]);
  EXPECT_EQ(lists[0], lists[2]);
  EXPECT_EQ(lists[1], lists[2]);
}

TEST(LightClusters, MovedClustersKeepTheirLights) {
  const City city(100);
  LightClusters first = clusters_of(city.lights, city.view);
  const Lists before(first);
  LightClusters second = std::move(first);
  EXPECT_EQ(Lists(second), before);
  first = LightClusters({.columns = 1, .rows = 1, .slices = 1});
  EXPECT_EQ(first.size(), 0u);
  EXPECT_TRUE(first.update(city.view));
  EXPECT_FALSE(second.update(city.view));
}

// --- a shader's look-up ---

TEST(LightClusters, PointsAreInTheClusterWhosePartOfTheViewHoldsThem) {
  Random random(79);
  for (int i = 0; i < 200; ++i) {
    const View view = draw_view(random);
    LightClusters clusters(draw_grid(random, view));
    clusters.update(view);
    for (int k = 0; k < 20; ++k) {
      const auto cluster = std::size_t(random.below(int(clusters.clusters().size())));
      EXPECT_EQ(clusters.cluster_at(draw_point_in(random, clusters.part_of_view(cluster))), cluster);
    }
    double solid = 0;  // sum over all parts, which fill the view
    const auto size_of = [](const View& part) {
      return (part.right - part.left) * (part.top - part.bottom) *
             (std::pow(part.farthest, 3) - std::pow(part.nearest, 3));
    };
    for (std::size_t each = 0; each < clusters.clusters().size(); ++each) solid += size_of(clusters.part_of_view(each));
    EXPECT_NEAR(solid / size_of(view), 1, 1e-6);
  }
}

TEST(LightClusters, LookupInFloatFindsTheLightsOfAFragment) {
  Random random(77);
  City city(2000);
  LightClusters clusters = clusters_of(city.lights, city.view);
  const ClusterGrid& grid = clusters.grid();
  const ClusterLookup lookup = clusters.lookup();
  int points = 0;
  for (int i = 0; i < 300000; ++i) {
    const auto light = std::size_t(random.below(2000));
    const glm::dvec3 point = draw_point_in(random, city.lights[light], 100);
    if (!is_in(city.view, point)) continue;
    const glm::dvec3 seen = glm::transpose(axes_of(city.view)) * (point - city.view.eye);
    const auto part = [](float position, std::uint32_t parts) {
      return std::size_t(std::clamp(int(std::floor(position * float(parts))), 0, int(parts) - 1));
    };
    const std::size_t column =
        part(float((seen.x / seen.z - city.view.left) / (city.view.right - city.view.left)), grid.columns);
    const std::size_t row =
        part(float((seen.y / seen.z - city.view.bottom) / (city.view.top - city.view.bottom)), grid.rows);
    const float position = std::floor(lookup.slice_scale * std::log2(float(seen.z)) + lookup.slice_bias);
    const auto slice = std::size_t(std::clamp(position, 0.0f, float(grid.slices - 1)));
    ASSERT_TRUE(has_light(clusters, (slice * grid.rows + row) * grid.columns + column, light));
    ++points;
  }
  EXPECT_GT(points, 20000);
}

// --- attacks ---

std::size_t clusters_with(const LightBounds& light, const View& view = {}, const ClusterGrid& grid = {}) {
  LightClusters clusters(grid);
  clusters.resize(1);
  clusters.set_light(0, light);
  clusters.update(view);
  return clusters.light_list().size();
}
constexpr std::size_t kAll = 16 * 9 * 24;

TEST(LightClusters, EndlessLightIsInAllClusters) {
  EXPECT_EQ(clusters_with({}), kAll);
  EXPECT_EQ(clusters_with({.position = {1e7, -1e7, 1e7}}), kAll);
  EXPECT_EQ(clusters_with({.range = 1e300}), kAll);
  EXPECT_EQ(clusters_with({.range = 20000}), kAll);
}

TEST(LightClusters, LightThatIsOffOrOutOfReachIsInNone) {
  EXPECT_EQ(clusters_with({.range = 0}), 0u);
  EXPECT_EQ(clusters_with({.position = {0, 0, 10}, .range = 10}), 0u);                          // behind
  EXPECT_EQ(clusters_with({.direction = {0, 0, 1}, .range = 100, .half_angle = kPi / 4}), 0u);  // shines backwards
  EXPECT_EQ(clusters_with({.position = {0, 0, -10100}, .range = 99}), 0u);  // beyond the farthest depth
  EXPECT_EQ(clusters_with({.position = {-100, 0, -50}, .direction = {-1, 0, 0}, .half_angle = 0}), 0u);
}

TEST(LightClusters, TinyLightIsWhereItStands) {
  EXPECT_EQ(clusters_with({.position = {0.1, 0.2, -3}, .range = 1e-300}), 1u);
  EXPECT_EQ(clusters_with({.position = {0.1, 0.2, -3}, .range = 1e-4}), 1u);
  EXPECT_EQ(clusters_with({.position = {0, 0.2, -3}, .range = 1e-4}), 2u);  // between two columns
}

TEST(LightClusters, ThinBeamIsInTheClustersThatItGoesThrough) {
  // through the middle column and row of an odd grid, at depths from 10 to 1010 m
  const ClusterGrid odd{.columns = 17, .rows = 9, .slices = 24};
  EXPECT_EQ(clusters_with({.position = {0, 0, -10}, .range = 1000, .half_angle = 0}, {}, odd), 15u);
  // across the view, at the depth of one slice
  EXPECT_EQ(clusters_with({.position = {-1000, 0.1, -100}, .direction = {1, 0, 0}, .half_angle = 0}, {}, odd), 17u);
}

TEST(LightClusters, DegenerateViewsHoldTheirLights) {
  const ClusterGrid single{.columns = 1, .rows = 1, .slices = 1};
  EXPECT_EQ(clusters_with({}, {}, single), 1u);
  const View thin{.nearest = 7, .farthest = std::nextafter(7.0, 8)};
  EXPECT_EQ(clusters_with({.position = {0, 0, -7}, .range = 1e-3}, thin, single), 1u);
  const View narrow{.left = 0.5, .right = 0.5 + 1e-9, .bottom = -1e-9, .top = 1e-9};
  EXPECT_EQ(clusters_with({}, narrow), kAll);
  EXPECT_GE(clusters_with({.position = {10, 0, -20}, .range = 0.01}, narrow), 16u * 9u);
  const View whole{.left = -10, .right = 10, .bottom = -10, .top = 10, .nearest = 1e-30, .farthest = kMaxPosition};
  EXPECT_EQ(clusters_with({}, whole), kAll);
}

TEST(LightClusters, WrongValueIsAnErrorAndChangesNothing) {
  const auto error_of_grid = [](const ClusterGrid& grid) { return error_of([&] { LightClusters{grid}; }); };
  EXPECT_EQ(error_of_grid({.columns = 0}), "columns = 0: must be in [1, 64]");
  EXPECT_EQ(error_of_grid({.rows = 65}), "rows = 65: must be in [1, 64]");
  EXPECT_EQ(error_of_grid({.slices = 0}), "slices = 0: must be in [1, 64]");
  EXPECT_EQ(error_of_grid({.first_depth = 0}), "first_depth = 0: must be in [1e-12, 16777216]");
  EXPECT_EQ(error_of_grid({.first_depth = 1e-24}), "first_depth = 1e-24: must be in [1e-12, 16777216]");
  EXPECT_EQ(error_of_grid({.first_depth = kNan}), "first_depth = nan: must be in [1e-12, 16777216]");

  const City city(10);
  LightClusters clusters = clusters_of(city.lights, city.view);
  const Lists before(clusters);
  EXPECT_EQ(error_of([&] { clusters.resize(621'075); }), "count = 621075: must be at most (2^31 - 2^20) / clusters");
  EXPECT_EQ(error_of([&] { clusters.resize(std::numeric_limits<std::size_t>::max()); }),
            "count = 18446744073709551615: must be at most (2^31 - 2^20) / clusters");
  EXPECT_EQ(error_of([&] { clusters.set_light(10, {}); }), "light = 10: must be below the number of lights");
  const std::size_t count = clusters.clusters().size();
  EXPECT_EQ(error_of([&] { (void)clusters.part_of_view(count); }),
            "cluster = " + std::to_string(count) + ": must be below the number of clusters");
  EXPECT_EQ(error_of([&] { clusters.set_light(0, {.range = -1}); }), "range = -1: must be >= 0");
  View view = city.view;
  view.up = view.forward;
  EXPECT_EQ(error_of([&] { clusters.update(view); }), "up = 1: must be orthogonal to forward within 1e-6");
  view = city.view;
  view.nearest = 5;
  EXPECT_EQ(error_of([&] { clusters.update(view); }), "nearest = 5: must be below the grid's first_depth");
  view.nearest = 1;
  view.farthest = 5;
  EXPECT_EQ(error_of([&] { clusters.update(view); }), "farthest = 5: must be above the grid's first_depth");
  EXPECT_FALSE(clusters.update(city.view));
  EXPECT_EQ(Lists(clusters), before);
}

}  // namespace
}  // namespace litfog::test
