// SPDX-License-Identifier: Apache-2.0
#include "litfog/directional_airlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "reference/double_limits.h"
#include "reference/near_numbers.h"
#include "reference/random_light.h"
#include "reference/ulp.h"
#include "value_errors.h"

namespace litfog::test {
namespace {

using glm::dvec3;

/// Fog, layers, or layers in haze, with a top or without. Some layers go on upwards.
Atmosphere draw_air(Random& random) {
  Atmosphere air;
  const bool has_layers = random.chance(0.7);
  if (!has_layers || random.chance(0.5)) air.fog.density = random.log_uniform(1e-5, has_layers ? 1e-2 : 1);
  if (random.chance(0.7)) air.top = random.uniform(-50, 300);
  if (!has_layers) return air;
  std::vector<DensityKnot> knots;
  double height = random.uniform(-50, 200);
  for (int count = random.below(int(kMaxDensityKnots)); count > 0; --count) {
    knots.push_back({height, random.chance(0.3) ? 0 : random.log_uniform(1e-5, 1)});
    height += random.log_uniform(1e-2, 200);
  }
  knots.push_back({height, random.chance(0.2) ? random.log_uniform(1e-5, 1e-2) : 0});
  air.profile = make_density_profile(knots);
  return air;
}

dvec3 draw_slanted(Random& random) {
  const double rise = random.chance(0.1) ? 0 : random.chance(0.5) ? random.log_uniform(1e-4, 1) : random.uniform(-1, 1);
  const double angle = random.uniform(0, 6.28);
  const double across = std::sqrt(1 - rise * rise);
  return {across * std::cos(angle), rise, across * std::sin(angle)};
}

/// Where the light enters.
double top_of(const Atmosphere& air) {
  const double haze_top = std::isinf(air.top) ? 1200 : air.top;
  if (air.profile.count == 0) return haze_top;
  const auto [height, density] = air.profile.used().back();
  return density > 0 ? height + 1200 : std::max(haze_top, height);
}

/// The depth from a height to the light.
double depth_to_light(const Atmosphere& air, double height, double slope) {
  if (slope < 0) return air.fog.density > 0 ? kInfinity : optical_depth_to_sky(air.profile, height, slope);
  const double climb = top_of(air) - height;
  if (!(climb > 0)) return 0;
  const double column = air.fog.density * climb + optical_depth(air.profile, height, top_of(air), climb);
  return column > 0 ? column / slope : 0;
}

/// The definition's integral, cut where the density over height is not smooth.
double integrated_airlight(const Atmosphere& air, const dvec3& to_light, const EyeRay& ray) {
  const double height = ray.origin.y, rise = ray.direction.y;
  const auto integrand = [&](double s) {
    const double here = height + s * rise;
    const double depth = air.fog_between(height, here).density * s + depth_to_light(air, here, to_light.y);
    return air.fog_at(here).density * std::exp(-depth);
  };
  std::vector<double> cuts{0, ray.length};
  const auto cut_at = [&](double edge) {
    const double s = (edge - height) / rise;
    if (s > 0 && s < ray.length) cuts.push_back(s);
  };
  if (rise != 0) {
    cut_at(top_of(air));
    for (const DensityKnot& knot : air.profile.used()) cut_at(knot.height);
  }
  std::sort(cuts.begin(), cuts.end());
  double sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (!(cuts[i] > cuts[i - 1])) continue;
    sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, cuts[i - 1], cuts[i], 12, 1e-11);
  }
  return sum * phase_at(air.phase, glm::dot(ray.direction, to_light));
}

std::string describe(const Atmosphere& air, const dvec3& to_light, const EyeRay& ray) {
  std::string text = "density " + std::to_string(air.fog.density) + ", top " + std::to_string(air.top) + ", light " +
                     std::to_string(to_light.y) + ", ray " + std::to_string(ray.origin.y) + " + " +
                     std::to_string(ray.direction.y) + " s up to " + std::to_string(ray.length) + ", knots";
  for (const auto& [height, density] : air.profile.used()) {
    text += " " + std::to_string(height) + ":" + std::to_string(density);
  }
  return text;
}

TEST(DirectionalAirlight, ClosedFormIsTheIntegralInAnyFog) {
  Random random(4141);
  WorstError error("directional_airlight", "haze, tops and up to 8 knots", kDirectionalAirlightMaxError, "relative");
  for (int i = 0; i < 20000; ++i) {
    const Atmosphere air = draw_air(random);
    const dvec3 to_light = draw_slanted(random);
    const EyeRay ray{{0, random.uniform(-100, 500), 0}, draw_slanted(random), random.log_uniform(1e-2, 1e4)};
    const double expected = integrated_airlight(air, to_light, ray);
    const double found = directional_airlight(air, to_light, ray);
    if (expected < 1e-80) {
      ASSERT_LT(found, 2e-80) << describe(air, to_light, ray);
    } else {
      error.add(std::abs(found / expected - 1), [&] { return describe(air, to_light, ray); });
    }
    ASSERT_NEAR(directional_fog_factor(air, to_light, ray.origin.y),
                std::exp(-depth_to_light(air, ray.origin.y, to_light.y)), 1e-13);
  }
  error.check();
}

RC_GTEST_PROP(DirectionalAirlight, ClosedFormIsTheIntegralOfRaysFromAndToKnotsAndAlongAxes, ()) {
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  const Atmosphere air = draw_air(random);
  std::vector<double> edges{0, top_of(air)};
  for (const DensityKnot& knot : air.profile.used()) edges.push_back(knot.height);
  const auto draw_axis = [&] {
    const double rise = *near_one_of({0, 1, -1, 0.5, 0.05, -0.05});
    if (std::abs(rise) > 1) return dvec3(0, std::copysign(1.0, rise), 0);
    return dvec3(std::sqrt((1 - rise) * (1 + rise)), rise, 0);
  };
  const dvec3 to_light = draw_axis();
  EyeRay ray{{0, *near_one_of(edges), 0}, *rc::gen::arbitrary<bool>() ? draw_axis() : to_light, 100};
  const double end = (*near_one_of(edges) - ray.origin.y) / ray.direction.y;
  if (end > 1e-3 && end < 1e5) ray.length = end;
  const double expected = integrated_airlight(air, to_light, ray);
  const double found = directional_airlight(air, to_light, ray);
  RC_LOG() << describe(air, to_light, ray) << ": " << found << " instead of " << expected;
  const double crossing = 4e-16 * ray.length * std::max(air.fog.density, largest_density(air.profile));  // of an edge
  RC_ASSERT(std::abs(found - expected) <= kDirectionalAirlightMaxError * expected + crossing);
}

TEST(DirectionalAirlight, AnglesHaveThePhaseFunctionsValue) {
  Random random(4142);
  for (int i = 0; i < 1000; ++i) {
    Atmosphere air{.fog = {FogMode::exp, 0.01}, .top = 100};
    const dvec3 to_light = draw_slanted(random);
    const EyeRay ray{{0, 1, 0}, draw_slanted(random), 50};
    const double isotropic = directional_airlight(air, to_light, ray);
    air.phase = Phase::droplets(10);
    const double expected = isotropic * phase_at(air.phase, glm::dot(ray.direction, to_light));
    EXPECT_NEAR(directional_airlight(air, to_light, ray), expected, 1e-9 * expected);
  }
}

TEST(DirectionalAirlight, EndlessRayIsTheLimitOfLongOnes) {
  Random random(4143);
  for (int i = 0; i < 2000; ++i) {
    const Atmosphere air = draw_air(random);
    const dvec3 to_light = draw_slanted(random);
    EyeRay ray{{0, random.uniform(-100, 500), 0}, draw_slanted(random), 1e9};
    const double expected = directional_airlight(air, to_light, ray);
    ray.length = kInfinity;
    EXPECT_NEAR(directional_airlight(air, to_light, ray), expected, 1e-9 * expected + 1e-100)
        << describe(air, to_light, ray);
  }
}

/// Air whose haze, last density or layers all but vanish, beside the same air without them.
struct VanishingFog {
  const char* name;
  Atmosphere vanishing, without;
};

std::vector<VanishingFog> vanishing_fogs() {
  const auto with_knots = [](double haze, double ground, double above, double top) {
    const std::array<DensityKnot, 3> knots{{{0, ground}, {20, ground}, {30, above}}};
    return Atmosphere{.fog = {FogMode::exp, haze}, .top = top, .profile = make_density_profile(knots)};
  };
  constexpr double kTrace = 1e-12;
  std::vector<VanishingFog> fogs;
  for (const double top : {kInfinity, 1e300, 100.0, 10.0}) {
    const double trace = top == 1e300 ? 1e-310 : kTrace;
    fogs.push_back({"haze over ground fog", with_knots(trace, 0.01, 0, top), with_knots(0, 0.01, 0, top)});
    fogs.push_back({"haze", {.fog = {FogMode::exp, trace}, .top = top}, {.top = top}});
    if (top > 30) {  // a lower one is raised to the last knot
      fogs.push_back({"layers", with_knots(1e-4, kTrace, 0, top), {.fog = {FogMode::exp, 1e-4}, .top = top}});
    }
    fogs.push_back({"fog that goes on upwards", with_knots(0, 0.01, kTrace, top), with_knots(0, 0.01, 0, top)});
  }
  return fogs;
}

TEST(DirectionalAirlight, LongestRayIsTheEndlessOne) {
  const std::vector<DensityKnot> knots{{0, 0.004}, {2.5, 0}};
  const Atmosphere air{.top = kMax, .profile = make_density_profile(knots)};
  EyeRay ray{{0, 255, 0}, glm::normalize(glm::dvec3(0, -0.3, 1)), kMax};
  const double longest = directional_airlight(air, {0, 1, 0}, ray);
  ray.length = kInfinity;
  EXPECT_NEAR(longest, directional_airlight(air, {0, 1, 0}, ray), 1e-12);
}

TEST(DirectionalAirlight, FogThatVanishesLeavesWhatItsAbsenceDoes) {
  for (const auto& [name, vanishing, without] : vanishing_fogs()) {
    for (const double slope : {1e-3, 0.6, 1.0}) {
      const dvec3 to_light{0, slope, -std::sqrt(1 - slope * slope)};
      for (const double height : {-5.0, 2.0, 25.0, 50.0, 5000.0}) {
        const auto text = [&, n = name, &w = without] {
          return std::string(n) + ", " + describe(w, to_light, {{0, height, 0}});
        };
        EXPECT_NEAR(directional_fog_factor(vanishing, to_light, height),
                    directional_fog_factor(without, to_light, height), 1e-5)
            << text();
        for (const double rise : {-0.6, 0.0, 0.6}) {
          const EyeRay ray{{0, height, 0}, {0, rise, -std::sqrt(1 - rise * rise)}, 1e4};
          EXPECT_NEAR(directional_airlight(vanishing, to_light, ray), directional_airlight(without, to_light, ray),
                      1e-5)
              << text();
        }
      }
    }
  }
}

TEST(DirectionalAirlight, HazeDimsTheLightOfGroundFogByItsDepthUpToTheTop) {
  const std::array<DensityKnot, 3> knots{{{0, 0.01}, {20, 0.01}, {30, 0}}};
  Atmosphere air{.profile = make_density_profile(knots)};
  const dvec3 to_light{0, 0.6, -0.8};
  const double clear = directional_fog_factor(air, to_light, 2);
  EXPECT_NEAR(clear, std::exp(-(0.18 + 0.05) / 0.6), 1e-14);
  air.fog.density = 1e-4;
  EXPECT_NEAR(directional_fog_factor(air, to_light, 2), clear * std::exp(-1e-4 * (kHazeHeight - 2) / 0.6), 1e-14);
  air.top = 200;
  EXPECT_NEAR(directional_fog_factor(air, to_light, 2), clear * std::exp(-1e-4 * (200 - 2) / 0.6), 1e-14);
  air.top = 10;  // below the layer's end
  EXPECT_NEAR(directional_fog_factor(air, to_light, 2), clear * std::exp(-1e-4 * (30 - 2) / 0.6), 1e-14);
}

TEST(DirectionalAirlight, LevelLightEntersNoFogBelowTheTop) {
  const std::array<DensityKnot, 2> ground{{{100, 0.1}, {120, 0}}};
  for (const Atmosphere& air :
       {Atmosphere{.fog = {FogMode::exp, 0.01}}, Atmosphere{.profile = make_density_profile(ground)},
        Atmosphere{.fog = {FogMode::exp, 1e-4}, .profile = make_density_profile(ground)}}) {
    EXPECT_EQ(directional_airlight(air, {1, 0, 0}, {{0, 90, 0}, {0.6, 0.8, 0}, 50}), 0);
    EXPECT_EQ(directional_fog_factor(air, {1, 0, 0}, 110), 0);
    EXPECT_EQ(directional_fog_factor(air, {1, 0, 0}, 1200), 1);
  }
  EXPECT_EQ(directional_fog_factor({}, {1, 0, 0}, 110), 1);
}

TEST(DirectionalAirlight, TotalFogIsLitWhereTheEyeIsAboveItsTop) {
  const Atmosphere air{.fog = {FogMode::exp, kInfinity}, .top = 100};
  for (const double length : {1e-3, 10.0, 1e4, kInfinity}) {
    EXPECT_EQ(directional_airlight(air, {0, 1, 0}, {{0, 90, 0}, {0.6, 0.8, 0}, length}), 0);
    EXPECT_NEAR(directional_airlight(air, {0, 1, 0}, {{0, 110, 0}, {0.6, -0.8, 0}, length}), 1, 1e-12);
  }
  EXPECT_EQ(directional_airlight(air, {0, 1, 0}, {{0, 110, 0}, {0.6, -0.8, 0}, 0}), 0);
}

TEST(DirectionalAirlight, BadArgumentIsNamed) {
  const Atmosphere air{.fog = {FogMode::exp, 0.01}, .top = 100};
  const Atmosphere exp2{.fog = {FogMode::exp2, 0.01}, .top = 100};
  EXPECT_EQ(error_of([&] { directional_airlight(exp2, {0, 1, 0}, {}); }), "fog.mode = 1: must be exp");
  EXPECT_EQ(error_of([&] { directional_airlight(air, {0, 2, 0}, {}); }), "to_light = 2: length must be 1 within 1e-6");
  EXPECT_EQ(error_of([&] { directional_airlight(air, {0, 1, 0}, {.length = -1}); }), "length = -1: must be >= 0");
  EXPECT_EQ(error_of([&] {
              directional_fog_factor(air, {0, 1, 0}, kNan);
            }),
            "height = nan: must be at most 16777216 in magnitude");
}

}  // namespace
}  // namespace litfog::test
