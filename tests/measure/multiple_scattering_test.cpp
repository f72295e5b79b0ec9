// SPDX-License-Identifier: Apache-2.0
#include "litfog/multiple_scattering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "measure/inverse_square_lamp.h"
#include "litfog/airlight.h"
#include "measure/quantile.h"
#include "measure/radial_scattering.h"
#include "measure/scattering_walk.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

/// What comes from endless fog without what comes from beyond the ray's end.
double true_scattering(const measure::RadialScattering::Glow& glow, double depth, double angle, double length) {
  const double whole = glow.at(depth, angle);
  if (std::isinf(length)) return whole;
  const double beside = depth * std::sin(angle), ahead = depth * std::cos(angle) - length;
  return whole - std::exp(-length) * glow.at(std::hypot(beside, ahead), std::atan2(beside, ahead));
}

struct Case {
  const char* name;
  Phase phase;
};

/// Of those in the table and of those far from them.
const Case kCases[] = {{"isotropic", {}},
                       {"g 0.79", Phase::henyey_greenstein(0.79)},
                       {"g 0.93", Phase::henyey_greenstein(0.93)},
                       {"droplets of 8.4", Phase::droplets(8.4)},
                       {"droplets of 17", Phase::droplets(17)}};

TEST(MultipleScattering, WholeGlowOfAPointLampIsTheTrueOne) {
  const measure::RadialScattering nodes(0.6);
  Random random(4203);
  std::vector<double> endless, ending;
  for (const Case& c : kCases) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = c.phase};
    const ScatteringTable table = make_scattering_table(air);
    const auto glow = nodes.solve(c.phase);
    std::vector<double> errors;
    std::string worst;
    for (int i = 0; i < 400; ++i) {
      const double depth = random.log_uniform(0.02, 10), angle = random.log_uniform(0.2, 180) * pi / 180;
      // Every other ray ends: at any distance, or at up to twice that of the closest approach.
      const bool ends = i % 2 == 1;
      const double approach = depth * std::cos(angle);
      const double length = !ends                                ? kInfinity
                            : approach > 0 && random.chance(0.5) ? std::max(0.02, approach * random.uniform(0.05, 2))
                                                                 : random.log_uniform(0.02, 20);
      const PlacedLight lamp = lamp_ahead(depth);
      const EyeRay ray = ray_beside(angle, length);
      const double truth = true_scattering(glow, depth, angle, length);
      const double single = kQuadratic * reference_airlight(lamp, air, ray);
      const double off = std::abs(kQuadratic * multiple_scattering(lamp, air, table, ray) - truth);
      const double error = off / (single + truth);
      (ends ? ending : endless).push_back(error);
      if (errors.empty() || error > measure::quantile(errors, 1)) {
        char text[200];
        std::snprintf(text, sizeof text, "depth %.3g, %.3g degrees, length %.3g", depth, angle * 180 / pi, length);
        worst = text;
      }
      errors.push_back(error);
    }
    std::printf("%-16s median %.4f, of 9 in 10 %.4f, largest %.4f at %s\n", c.name, measure::quantile(errors, 0.5),
                measure::quantile(errors, 0.9), measure::quantile(errors, 1), worst.c_str());
  }
  for (const auto* errors : {&endless, &ending}) {
    EXPECT_LE(measure::quantile(*errors, 0.5), kScatteringMedianError);
    EXPECT_LE(measure::quantile(*errors, 0.9), kScatteringTypicalError);
    const double largest = measure::quantile(*errors, 1);
    EXPECT_LE(largest, kScatteringMaxError);
    std::printf("%s rays: median %.4f, of 9 in 10 %.4f, largest %.4f\n", errors == &endless ? "endless" : "ending",
                measure::quantile(*errors, 0.5), measure::quantile(*errors, 0.9), largest);
  }
}

TEST(MultipleScattering, PointLampIsThatOfTheRandomWalk) {
  for (const Case& c : {kCases[0], kCases[1], kCases[4]}) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = c.phase};
    const ScatteringTable table = make_scattering_table(air);
    for (const auto& [depth, degrees, length] :
         {std::array{0.3, 2.0, kInfinity}, {1.0, 20.0, 0.5}, {1.0, 60.0, kInfinity}, {3.0, 5.0, 2.0}}) {
      const PlacedLight lamp = lamp_ahead(depth);
      const EyeRay ray = ray_beside(degrees * pi / 180, length);
      measure::ScatteringWalk walk;
      walk.paths = 4096;
      const auto chance = measure::walk_scattering(lamp, air, ray, walk);
      const double found = multiple_scattering(lamp, air, table, ray);
      EXPECT_NEAR(found, chance.higher.value,
                  4 * chance.higher.error + kScatteringTypicalError * (chance.first.value + chance.higher.value))
          << c.name << ", " << depth << ", " << degrees << ", " << length;
    }
  }
}

/// A layer of fog that begins at a height of 0, with sharp edges or with ramps.
Atmosphere layer_of(double thickness, bool has_ramps, const Phase& phase) {
  Atmosphere air{.fog = {FogMode::exp, 0}, .phase = phase};
  const double ramp = has_ramps ? 0.4 * thickness : 1e-4;
  air.profile = make_density_profile(
      std::array<DensityKnot, 4>{{{-ramp, 0}, {0, 1}, {thickness, 1}, {thickness + ramp, 0}}});
  return air;
}

// Lamps and eyes in layers, above and below them.
TEST(MultipleScattering, WholeGlowOfAPointLampInLayersIsNearTheTrueOne) {
  Random random(4208);
  std::vector<double> errors, once;
  for (int i = 0; i < 400; ++i) {
    const Case& c = kCases[std::size_t(i) % std::size(kCases)];
    const double thickness = random.log_uniform(0.1, 10);
    const Atmosphere air = layer_of(thickness, i % 2 == 1, c.phase);
    const double beside = random.log_uniform(0.05, 6);
    PlacedLight lamp = lamp_ahead(beside);
    EyeRay ray;
    lamp.position.y = random.uniform(-0.3, 1.5) * thickness;
    ray.origin.y = random.uniform(-0.3, 1.5) * thickness;
    const glm::dvec3 ahead = glm::normalize(lamp.position - ray.origin);
    const double angle = random.log_uniform(1, 120) * pi / 180, turn = random.uniform(0, 2 * pi);
    const glm::dvec3 right(1, 0, 0), up = glm::cross(right, ahead);
    ray.direction = std::cos(angle) * ahead + std::sin(angle) * (std::cos(turn) * right + std::sin(turn) * up);
    if (random.chance(0.5)) ray.length = glm::distance(lamp.position, ray.origin) * random.log_uniform(0.3, 3);
    measure::ScatteringWalk walk;
    walk.paths = 2048;
    walk.seed = std::uint64_t(i);
    const auto chance = measure::walk_scattering(lamp, air, ray, walk);
    const double single = airlight(lamp, air, ray), truth = single + chance.higher.value;
    if (!(chance.higher.error < 0.05 * truth)) continue;  // of few paths, or of no fog
    const double found = single + multiple_scattering(lamp, air, make_scattering_table(air), ray);
    errors.push_back(std::abs(found / truth - 1));
    once.push_back(1 - single / truth);
  }
  std::printf("%zu rays in layers: %.3f and %.3f of the glow, scattered once %.3f and %.3f too dark\n", errors.size(),
              measure::quantile(errors, 0.5), measure::quantile(errors, 0.9), measure::quantile(once, 0.5), measure::quantile(once, 0.9));
  ASSERT_GT(errors.size(), 200u);
  EXPECT_LE(measure::quantile(errors, 0.5), kLayeredScatteringMedianError);
  EXPECT_LE(measure::quantile(errors, 0.9), kLayeredScatteringTypicalError);
  EXPECT_GT(measure::quantile(once, 0.5), 0.3);
}

// On the ground below a layer. The truth is the radiance of all directions above, by a walk each.
TEST(ScatteredIrradiance, InLayersIsThatOfItsGlowWithinAFactor) {
  Random random(4209);
  std::vector<double> factors;
  for (int i = 0; i < 24; ++i) {
    const double thickness = random.log_uniform(0.3, 6);
    const Atmosphere air = layer_of(thickness, false, kCases[std::size_t(i) % std::size(kCases)].phase);
    PlacedLight lamp = lamp_ahead(random.log_uniform(0.2, 4));
    lamp.position.y = random.uniform(0.05, 1) * thickness;
    constexpr int kDirections = 192;
    double truth = 0;
    for (int k = 0; k < kDirections; ++k) {  // a spiral, as many directions as their cosines weigh
      const double cosine = std::sqrt((k + 0.5) / kDirections), sine = std::sqrt(1 - cosine * cosine), turn = 2.4 * k;
      measure::ScatteringWalk walk;
      walk.paths = 128;
      walk.seed = std::uint64_t(1000 * i + k);
      const auto chance = measure::walk_scattering(
          lamp, air, {.direction = {sine * std::cos(turn), cosine, sine * std::sin(turn)}}, walk);
      truth += (chance.first.value + chance.higher.value) / (4 * kDirections);
    }
    const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
    const ScatteringSource source = scattering_source(lamp.light, air, beams);
    const double found = irradiance(scattered_light(lamp, source, air, glm::dvec3(0.0)), {0, 1, 0});
    factors.push_back(std::max(found / truth, truth / found));
  }
  std::printf("irradiance below layers: within factors of %.2f and %.2f\n", measure::quantile(factors, 0.5), measure::quantile(factors, 0.9));
  EXPECT_LE(measure::quantile(factors, 0.5), kLayeredIrradianceMedianFactor);
  EXPECT_LE(measure::quantile(factors, 0.9), kLayeredIrradianceTypicalFactor);
}

// The truth is the radiance of all directions before the surface, summed.
TEST(ScatteredIrradiance, OfAPointLampIsTheSumOfItsGlow) {
  const measure::RadialScattering nodes(0.6);
  double worst = 0;
  for (const Case& c : kCases) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = c.phase};
    const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
    const auto glow = nodes.solve(c.phase);
    for (const double depth : {0.03, 0.2, 1.0, 3.0, 8.0}) {
      const PlacedLight lamp = lamp_ahead(depth);
      const ScatteringSource source = scattering_source(lamp.light, air, beams);
      constexpr int kAngles = 300, kAround = 64;
      std::vector<double> angles, lights;  // the glow's, times its solid angle over that of a sphere
      for (int i = 0; i < kAngles; ++i) {
        const double from = 1e-5 * std::pow(pi / 1e-5, double(i) / kAngles);
        const double to = 1e-5 * std::pow(pi / 1e-5, (i + 1.) / kAngles);
        const double angle = (from + to) / 2;
        const double single = kQuadratic * reference_airlight(lamp, air, ray_beside(angle));
        angles.push_back(angle);
        lights.push_back((single + glow.at(depth, angle)) * std::sin(angle) * (to - from) / 2);
      }
      constexpr std::array kTurns{0.0, 0.8, pi / 2, pi - 0.8, pi};
      std::array<double, kTurns.size()> truths{};
      for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
        for (std::size_t i = 0; i < angles.size(); ++i) {
          for (int k = 0; k < kAround; ++k) {
            const double cosine = std::cos(kTurns[turn]) * std::cos(angles[i]) +
                                  std::sin(kTurns[turn]) * std::sin(angles[i]) * std::cos(pi * (k + 0.5) / kAround);
            truths[turn] += lights[i] * std::max(cosine, 0.0) / kAround;
          }
        }
      }
      const DiffuseLight one = kQuadratic * scattered_light(lamp, source, air, glm::dvec3(0.0));
      DiffuseLight two{.all = one.all, .flow = -one.flow};  // and of a lamp behind
      two += one;
      const double unit = -std::expm1(-depth) / (depth * depth);
      for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
        const glm::dvec3 normal(std::sin(kTurns[turn]), 0, -std::cos(kTurns[turn]));
        const double error = std::abs(irradiance(one, normal) - truths[turn]) / unit;
        EXPECT_LE(error, kScatteredIrradianceMaxError)
            << c.name << ", depth " << depth << ", turned by " << kTurns[turn];
        worst = std::max(worst, error);
        const double both = truths[turn] + truths[kTurns.size() - 1 - turn];
        EXPECT_LE(std::abs(irradiance(two, normal) - both) / (2 * unit), kSummedIrradianceMaxError)
            << c.name << ", two lamps, depth " << depth << ", turned by " << kTurns[turn];
      }
    }
  }
  std::printf("largest error %.3f of what is scattered\n", worst);
}

TEST(MultipleScattering, WholeGlowOfAConeIsThatOfTheRandomWalk) {
  struct ConeCase {
    const char* name;
    Phase phase;
    double median, typical;
  };
  for (const ConeCase& c : {ConeCase{"isotropic", {}, kConeScatteringMedianError, kConeScatteringTypicalError},
                            {"droplets of 10", Phase::droplets(10), kDropletConeScatteringMedianError,
                             kDropletConeScatteringTypicalError}}) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = c.phase};
    const ScatteringTable table = make_scattering_table(air);
    const ThinBeams beams = make_thin_beams(air, table);
    Random random(4204);
    std::vector<double> errors;
    while (errors.size() < 40) {
      const double depth = random.log_uniform(0.05, 3);
      const double aim = random.uniform(0, pi), around = random.uniform(0, 2 * pi);
      PlacedLight lamp = lamp_ahead(depth);
      lamp.light.cone = Cone::cosine(random.log_uniform(3, 90) * pi / 180, 0);
      lamp.direction = {std::sin(aim) * std::cos(around), std::sin(aim) * std::sin(around), std::cos(aim)};
      const EyeRay ray = ray_beside(random.log_uniform(1, 150) * pi / 180);
      measure::ScatteringWalk walk;
      walk.paths = 4096;
      const auto chance = measure::walk_scattering(lamp, air, ray, walk);
      const double whole = reference_airlight(lamp, air, ray) + chance.higher.value;
      const double doubt = chance.higher.error / whole;
      if (doubt > 0.1) continue;  // the walk does not know
      const ScatteringSource source = scattering_source(lamp.light, air, beams);
      const double found = multiple_scattering(lamp, source, air, table, ray);
      errors.push_back(std::max(std::abs(found - chance.higher.value) / whole - doubt, 0.0));
    }
    std::printf("%-16s median %.3f, of 9 in 10 %.3f, largest %.3f\n", c.name, measure::quantile(errors, 0.5),
                measure::quantile(errors, 0.9), measure::quantile(errors, 1));
    EXPECT_LE(measure::quantile(errors, 0.5), c.median) << c.name;
    EXPECT_LE(measure::quantile(errors, 0.9), c.typical) << c.name;
  }
}

}  // namespace
}  // namespace litfog::test
