// SPDX-License-Identifier: Apache-2.0
#include "render/light/hidden_range.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reference/double_limits.h"
#include "reference/random_airlight.h"
#include "reference/srgb.h"
#include "render/display.h"

namespace litfog::test {
using namespace render;

namespace {

TEST(VisibleStep, LessLightChangesNoDisplayByAStep) {
  Random random(21);
  double largest = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double exposure = random.uniform(-8, 8);
    const double step = visible_step(exposure);
    const double gain = std::exp2(exposure);
    const auto draw = [&] { return random.chance(0.1) ? 0 : random.log_uniform(1e-6, 10) / gain; };
    const glm::dvec3 before{draw(), draw(), draw()};
    const glm::dvec3 after =
        before + step * glm::dvec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    for (const ToneCurve tone : {ToneCurve::neutral, ToneCurve::clip}) {
      const glm::vec3 a = toned(tone, glm::vec3(before * gain));
      const glm::vec3 b = toned(tone, glm::vec3(after * gain));
      for (int c = 0; c < 3; ++c) {
        largest = std::max(largest, 255 * std::abs(srgb_from_linear(double(a[c])) - srgb_from_linear(double(b[c]))));
      }
    }
  }
  EXPECT_LE(largest, 1 + 1e-3);  // floats round up to 2^-24 of white, and sRGB multiplies that
  EXPECT_GT(largest, 0.9);
}

TEST(HiddenRange, FogLeavesTheBudgetThereAndMoreBefore) {
  Random random(22);
  for (int i = 0; i < 1000; ++i) {
    const Fog fog{random.pick(kModes), random.log_uniform(1e-5, 10)};
    const double budget = random.log_uniform(1e-8, 1e-3);
    const double brightness = budget * random.log_uniform(1.01, 1e8);
    const double range = hidden_range(fog, brightness, budget);
    EXPECT_LE(brightness * fog_factor_at(fog, range), budget);
    EXPECT_GT(brightness * fog_factor_at(fog, range * (1 - 1e-5)), budget);
  }
  EXPECT_EQ(hidden_range({FogMode::exp, 0.1}, 1e-5, 1e-4), 0);
  EXPECT_EQ(hidden_range({FogMode::exp, 0}, 1, 1e-4), kInfinity);
  EXPECT_EQ(hidden_range({FogMode::exp2, kInfinity}, 1, 1e-4), 0);
}

TEST(LargestIrradiance, NoPointOfTheBoxGetsMore) {
  Random random(24);
  for (int i = 0; i < 1000; ++i) {
    const AirlightCase c = draw_airlight_case(random, random.pick(kModes), LampLeg::fogged);
    const double extent = compute_extent(c.light.light.attenuation, c.light.light.threshold);
    const double size = std::min(extent, 1e4);
    const glm::vec3 low = glm::vec3(c.light.position + draw_direction(random) * random.uniform(0, 1.5) * size);
    const scene::Bounds box{low, low + glm::vec3(float(random.uniform(0, 1) * size))};
    for (const FogLighting lighting : {FogLighting::peak, FogLighting::airlight}) {
      for (const char* name : {"unified", "lookup-3d", "radial"}) {
        const LightingPath& path = *find_lighting_path(name);
        const double most =
            largest_irradiance(c.light.light, c.light.position, extent, c.atmosphere.fog, lighting, path, box);
        for (int j = 0; j < 5; ++j) {
          const glm::dvec3 t(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
          const glm::dvec3 point = j == 0 ? glm::clamp(c.light.position, glm::dvec3(box.low), glm::dvec3(box.high))
                                          : glm::mix(glm::dvec3(box.low), glm::dvec3(box.high), t);
          const double range = glm::distance(c.light.position, point);
          if (range > extent) continue;
          double light = path.range == RangeLaw::radial && !std::isinf(extent)
                             ? 1 - range * range / (extent * extent)
                             : attenuation_at(c.light.light.attenuation, range);
          if (path.range == RangeLaw::radial && std::isinf(extent)) light = 1;
          if (lighting == FogLighting::airlight) {
            light *= fog_factor_at(scaled(c.atmosphere.fog, c.light.light.density_scale), range);
          }
          EXPECT_LE(light, most * (1 + 1e-12)) << name << to_string(c);
          if (j == 0 && path.evaluation == Evaluation::fragment) {
            EXPECT_GE(light, most * (1 - 1e-12)) << name << to_string(c);
          }
        }
      }
    }
  }
}

TEST(CanLightFrom, NoPointOfARayThroughTheBoxIsLitWhereTheAnswerIsNo) {
  Random random(26);
  int dark = 0;
  int lit = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 eye = draw_direction(random) * random.uniform(0, 20);
    const double size = random.log_uniform(0.1, 30);
    const glm::vec3 low(eye + draw_direction(random) * random.log_uniform(1, 200));
    const scene::Bounds box{low, low + glm::vec3(float(random.uniform(0, size)), float(random.uniform(0, size)),
                                                 float(random.uniform(0, size)))};
    PlacedLight light;
    light.position = eye + draw_direction(random) * random.log_uniform(0.01, 30);
    const double half_angle = random.log_uniform(0.01, 3);
    const glm::dvec3 through(box.low + box.high);
    light.direction = random.chance(0.5) ? draw_direction(random)
                                         : glm::normalize(glm::normalize(through / 2.0 - eye) +
                                                          half_angle * random.uniform(0, 3) * draw_direction(random));
    const double range = nearest_distance(eye, box) * random.uniform(0.2, 1);
    if (can_light_from(light, half_angle, eye, box, range)) {
      ++lit;
      continue;
    }
    ++dark;
    for (int j = 0; j < 20; ++j) {
      const glm::dvec3 t(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
      const glm::dvec3 point = glm::mix(glm::dvec3(box.low), glm::dvec3(box.high), glm::step(0.5, t));
      const glm::dvec3 direction = glm::normalize(point - eye);
      const glm::dvec3 seen = eye + direction * (range * (j % 2 == 0 ? 1 : random.log_uniform(1, 100)));
      const double angle = std::acos(glm::dot(glm::normalize(seen - light.position), light.direction));
      EXPECT_GT(angle, half_angle);
    }
  }
  EXPECT_GT(dark, 500);
  EXPECT_GT(lit, 500);
}

}  // namespace
}  // namespace litfog::test
