// SPDX-License-Identifier: Apache-2.0
#include "litfog/view_frustum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/random_bounds.h"

namespace litfog::test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(View, AxesAreOrthonormalWhereTheViewIsSoWithinItsTolerance) {
  const View view{.forward = {0, 0, -1 - 0.9e-6}, .up = {0.9e-6, 1 - 0.9e-6, 0.9e-6}};
  ASSERT_FALSE(find_error(view));
  const glm::dmat3 axes = axes_of(view);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(glm::dot(axes[i], axes[j]), i == j ? 1 : 0, 1e-15) << i << j;
  }
  EXPECT_EQ(axes[2], glm::dvec3(0, 0, -1));
  EXPECT_NEAR(axes[0].x, 1, 1e-6);
  EXPECT_NEAR(axes[1].y, 1, 1e-6);
}

TEST(ViewFrustum, LightThatLightsAPointInViewIsSeen) {
  Random random(71);
  int common = 0;
  for (int i = 0; i < 100000; ++i) {
    const View view = draw_view(random);
    const LightBounds light = draw_bounds(random, view);
    bool has_common_point = false;
    for (int k = 0; k < 20 && !has_common_point; ++k) {
      has_common_point = is_in(view, draw_point_in(random, light, 3 * view.farthest));
    }
    if (!has_common_point) continue;
    ++common;
    ASSERT_TRUE(ViewFrustum(view).can_see(light)) << to_string(view, light);
    ASSERT_TRUE(ViewFrustum(view).can_see(light.position, light.range)) << to_string(view, light);
  }
  EXPECT_GT(common, 20000);
}

TEST(ViewFrustum, LightApartFromTheViewIsNotSeen) {
  Random random(72);
  int proved = 0;
  int seen = 0;
  for (int i = 0; i < 10000; ++i) {
    const View view = draw_view(random);
    const LightBounds light = draw_bounds(random, view);
    if (light.half_angle > kPi / 2 && light.half_angle < kPi) continue;
    const GapSearch search(view, light);
    const bool is_seen = ViewFrustum(view).can_see(light);
    const double gap = search.largest(random);
    if (gap > kCullSlack * search.size()) {
      ++proved;
      ASSERT_FALSE(is_seen) << to_string(view, light) << ", gap " << gap;
    }
    seen += is_seen;
  }
  std::printf("seen %d, apart %d\n", seen, proved);
  EXPECT_GT(proved, 2000);
  EXPECT_GT(seen, 2000);
}

/// A light at the eye's height, so that what a view holds of it is plain.
View plain_view() { return {.nearest = 1, .farthest = 100}; }
bool can_see(const View& view, const glm::dvec3& position, double range, double half_angle = kPi,
             const glm::dvec3& direction = {0, 0, -1}) {
  return ViewFrustum(view).can_see({position, direction, range, half_angle});
}

TEST(ViewFrustum, BallIsMeasuredToFacesEdgesAndCorners) {
  const ViewFrustum frustum(plain_view());
  const double diagonal = std::sqrt(2);
  for (const double aside : {0.1, 1.0, 1e3}) {
    const auto is_just_out_of_reach = [&](const glm::dvec3& centre, double distance) {
      return !frustum.can_see(centre, distance * (1 - 1e-8)) && frustum.can_see(centre, distance * (1 + 1e-8));
    };
    EXPECT_TRUE(is_just_out_of_reach({0, 0, -100 - aside}, aside));                                     // far face
    EXPECT_TRUE(is_just_out_of_reach({50 + aside, 0, -50 + aside}, aside * diagonal));                  // right face
    EXPECT_TRUE(is_just_out_of_reach({-100 - aside, 0, -100 - aside}, aside * diagonal));               // far left edge
    EXPECT_TRUE(is_just_out_of_reach({100 + aside, 100 + aside, -100 - aside}, aside * std::sqrt(3)));  // far corner
  }
  EXPECT_TRUE(frustum.can_see({0, 0, -50}, 0));  // a point inside
  EXPECT_FALSE(frustum.can_see({0, 0, 0}, 0));
  EXPECT_FALSE(frustum.can_see({0, 0, 0}, 1 - 1e-9));  // the nearest plane is 1 m away
  EXPECT_TRUE(frustum.can_see({0, 0, 0}, 1));
  EXPECT_TRUE(frustum.can_see({0, 1e6, 0}, kInfinity));
}

TEST(ViewFrustum, LightWithoutRangeLightsNothing) {
  EXPECT_FALSE(can_see(plain_view(), {0, 0, -50}, 0));
  EXPECT_TRUE(can_see(plain_view(), {0, 0, -50}, 1e-300));
}

TEST(ViewFrustum, LightAtTheEyeIsSeenWhereItShinesIntoTheView) {
  for (const double range : {2.0, 1e6, kInfinity}) {
    EXPECT_TRUE(can_see(plain_view(), {0, 0, 0}, range, 0.01));
    EXPECT_FALSE(can_see(plain_view(), {0, 0, 0}, range, 0.01, {0, 0, 1}));
    EXPECT_FALSE(can_see(plain_view(), {0, 0, 0}, range, kPi / 4 - 1e-6, {1, 0, 0}));
    EXPECT_TRUE(can_see(plain_view(), {0, 0, 0}, range, kPi / 4 + 1e-6, {1, 0, 0}));
  }
  EXPECT_FALSE(can_see(plain_view(), {0, 0, 0}, 0.9));
}

TEST(ViewFrustum, LightBehindIsSeenWhereItReachesTheView) {
  EXPECT_FALSE(can_see(plain_view(), {0, 0, 10}, 10.9));
  EXPECT_TRUE(can_see(plain_view(), {0, 0, 10}, 11.1));
  EXPECT_TRUE(can_see(plain_view(), {0, 0, 10}, kInfinity, 0));
  EXPECT_FALSE(can_see(plain_view(), {0, 0, 10}, kInfinity, kPi / 2, {0, 0, 1}));
  EXPECT_TRUE(can_see(plain_view(), {0, 0, 10}, kInfinity, kPi * 0.9, {0, 0, 1}));  // beside its dark cone
  View narrow = plain_view();
  narrow.left = narrow.bottom = -0.1;
  narrow.right = narrow.top = 0.1;
  EXPECT_FALSE(can_see(narrow, {0, 0, 10}, kInfinity, kPi * 0.9, {0, 0, 1}));
  EXPECT_TRUE(can_see(narrow, {0, 0, 0.5}, kInfinity, kPi * 0.9, {0, 0, -1}));
}

TEST(ViewFrustum, BeamOfNoWidthIsALine) {
  EXPECT_TRUE(can_see(plain_view(), {-100, 0, -50}, 60, 0, {1, 0, 0}));
  EXPECT_FALSE(can_see(plain_view(), {-100, 0, -50}, 49.9, 0, {1, 0, 0}));
  EXPECT_FALSE(can_see(plain_view(), {-100, 0, -50}, 1000, 0, {0, 1, 0}));
  EXPECT_FALSE(can_see(plain_view(), {-200, 100.1, -100}, 1000, 0, {1, 0, 0}));  // grazes the far edge
  EXPECT_TRUE(can_see(plain_view(), {-200, 99.9, -99.95}, 1000, 0, {1, 0, 0}));
}

TEST(ViewFrustum, WrongValueIsAnError) {
  const auto error_with = [](const auto& change) {
    View view;
    change(view);
    return error_of([&] { ViewFrustum{view}; });
  };
  EXPECT_EQ(error_with([](View& v) { v.eye.y = kNan; }), "eye.y = nan: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_with([](View& v) { v.forward = {0, 0, -2}; }), "forward = 2: length must be 1 within 1e-6");
  EXPECT_EQ(error_with([](View& v) { v.up = {0, 0, 0}; }), "up = 0: length must be 1 within 1e-6");
  EXPECT_EQ(error_with([](View& v) { v.up = v.forward; }), "up = 1: must be orthogonal to forward within 1e-6");
  EXPECT_EQ(error_with([](View& v) { v.left = -10.5; }), "left = -10.5: must be at most 10 in magnitude");
  EXPECT_EQ(error_with([](View& v) { v.top = kNan; }), "top = nan: must be at most 10 in magnitude");
  EXPECT_EQ(error_with([](View& v) { v.right = v.left; }), "right = -1: must be above left");
  EXPECT_EQ(error_with([](View& v) { v.top = -2; }), "top = -2: must be above bottom");
  EXPECT_EQ(error_with([](View& v) { v.nearest = 0; }), "nearest = 0: must be > 0");
  EXPECT_EQ(error_with([](View& v) { v.farthest = 0.1; }),
            "farthest = 0.1: must be above nearest and at most 16777216");
  EXPECT_EQ(error_with([](View& v) { v.farthest = kInfinity; }),
            "farthest = inf: must be above nearest and at most 16777216");

  const ViewFrustum frustum{View{}};
  EXPECT_EQ(error_of([&] {
              (void)frustum.can_see({kNan, 0, 0}, 1);
            }),
            "centre.x = nan: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_of([&] { (void)frustum.can_see({0, 0, 0}, -1); }), "radius = -1: must be >= 0");
  const auto error_of_light = [&](const LightBounds& light) { return error_of([&] { (void)frustum.can_see(light); }); };
  EXPECT_EQ(error_of_light({.position = {0, 0, 2e7}}), "position.z = 2e+07: must be at most 16777216 in magnitude");
  EXPECT_EQ(error_of_light({.direction = {0, 0, 0}}), "direction = 0: length must be 1 within 1e-6");
  EXPECT_EQ(error_of_light({.range = -1}), "range = -1: must be >= 0");
  EXPECT_EQ(error_of_light({.range = kNan}), "range = nan: must be >= 0");
  EXPECT_EQ(error_of_light({.half_angle = 3.2}), "half_angle = 3.2: must be in [0, pi]");
  EXPECT_EQ(error_of_light({.half_angle = kNan}), "half_angle = nan: must be in [0, pi]");
}

}  // namespace
}  // namespace litfog::test
