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
  std::vector<double> endless, ending, far;
  for (const Case& c : kCases) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = c.phase};
    const ScatteringTable table = make_scattering_table(air);
    const auto glow = nodes.solve(c.phase);
    std::vector<double> errors;
    std::string worst;
    for (int i = 0; i < 400; ++i) {
      const double depth = random.chance(0.75) ? random.log_uniform(0.02, 10) : random.uniform(10, 30);
      const double angle = random.log_uniform(0.2, 180) * pi / 180;
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
      (depth > 10 ? far : ends ? ending : endless).push_back(error);
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
  std::printf("beyond a depth of 10: median %.4f, of 9 in 10 %.4f, largest %.4f\n", measure::quantile(far, 0.5),
              measure::quantile(far, 0.9), measure::quantile(far, 1));
  EXPECT_LE(measure::quantile(far, 0.5), kFarScatteringMedianError);
  EXPECT_LE(measure::quantile(far, 0.9), kFarScatteringTypicalError);
  EXPECT_LE(measure::quantile(far, 1), kScatteringMaxError);
}

/// A lamp whose law leaves 1 / r^2 within some range, in depths: by a constant and a linear term, or at a knee.
Attenuation soft_law(Random& random) {
  const double range = random.log_uniform(0.01, 30);
  if (random.chance(0.3)) return {.constant = 0, .linear = 0, .quadratic = 1 / (range * range)};
  const double linear = random.chance(0.5) ? 0 : random.log_uniform(0.05, 5) / range;
  return {.constant = random.chance(0.7) ? 1 : random.uniform(0, 1), .linear = linear, .quadratic = 1 / (range * range)};
}

PlacedLight soft_lamp_ahead(const Attenuation& law, double depth) {
  PlacedLight lamp = lamp_ahead(depth);
  lamp.light.attenuation = law;
  lamp.light.threshold = 1e-9;
  return lamp;
}

TEST(MultipleScattering, WholeGlowOfASoftLampIsNearTheTrueOne) {
  const measure::RadialScattering nodes(0.5);
  Random random(4210);
  std::vector<double> endless, ending, as_point;
  for (const Case& c : kCases) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = c.phase};
    const ScatteringTable table = make_scattering_table(air);
    std::vector<double> errors;
    for (int lamps = 0; lamps < 4; ++lamps) {
      const Attenuation law = soft_law(random);
      const auto glow = nodes.solve(c.phase, [&](double r) { return r * r * attenuation_at(law, r); });
      ScatteringSource point = scattering_source(soft_lamp_ahead(law, 1).light, air);
      const ScatteringSource source = point;
      point.soft_range = 0;
      for (int i = 0; i < 100; ++i) {
        const double depth = random.log_uniform(0.02, 10), angle = random.log_uniform(0.2, 180) * pi / 180;
        const bool ends = i % 2 == 1;
        const double length = ends ? random.log_uniform(0.1, 20) : kInfinity;
        const PlacedLight lamp = soft_lamp_ahead(law, depth);
        const EyeRay ray = ray_beside(angle, length);
        const double truth = true_scattering(glow, depth, angle, length);
        const double whole = reference_airlight(lamp, air, ray) + truth;
        const double error = std::abs(multiple_scattering(lamp, source, air, table, ray) - truth) / whole;
        (ends ? ending : endless).push_back(error);
        errors.push_back(error);
        as_point.push_back(std::abs(multiple_scattering(lamp, point, air, table, ray) - truth) / whole);
      }
    }
    std::printf("soft lamps, %-16s median %.3f, of 9 in 10 %.3f, largest %.3f\n", c.name, measure::quantile(errors, 0.5),
                measure::quantile(errors, 0.9), measure::quantile(errors, 1));
  }
  std::printf("as point lamps: median %.3f, of 9 in 10 %.3f\n", measure::quantile(as_point, 0.5),
              measure::quantile(as_point, 0.9));
  for (const auto* errors : {&endless, &ending}) {
    std::printf("%s rays: median %.3f, of 9 in 10 %.3f, largest %.3f\n", errors == &endless ? "endless" : "ending",
                measure::quantile(*errors, 0.5), measure::quantile(*errors, 0.9), measure::quantile(*errors, 1));
    EXPECT_LE(measure::quantile(*errors, 0.5), kSoftScatteringMedianError);
    EXPECT_LE(measure::quantile(*errors, 0.9), kSoftScatteringTypicalError);
    EXPECT_LE(measure::quantile(*errors, 1), kSoftScatteringMaxError);
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

Cone draw_cone(Random& random, int kind) {
  const double half = random.log_uniform(3, 90) * pi / 180;
  if (kind == 0) return Cone::cosine(half, 0);
  if (kind == 1) return Cone::cosine(half, random.log_uniform(1, 100));
  return Cone::smoothstep(random.uniform(0, 0.9) * half, half);
}

struct LayeredErrors {
  std::vector<double> all, once;  // of the whole glow, and of what is scattered once
};

/// Lamps and eyes in layers, above and below them.
LayeredErrors layered_errors(bool is_cone, bool is_soft, int count) {
  Random random(4208);
  LayeredErrors errors;
  for (int i = 0; i < count; ++i) {
    const Case& c = kCases[std::size_t(i) % std::size(kCases)];
    const double thickness = random.log_uniform(0.1, 10);
    const Atmosphere air = layer_of(thickness, i % 2 == 1, c.phase);
    const double beside = random.log_uniform(0.05, 6);
    PlacedLight lamp = is_soft ? soft_lamp_ahead(soft_law(random), beside) : lamp_ahead(beside);
    EyeRay ray;
    lamp.position.y = random.uniform(-0.3, 1.5) * thickness;
    ray.origin.y = random.uniform(-0.3, 1.5) * thickness;
    if (is_cone) {
      lamp.light.cone = draw_cone(random, i % 3);
      lamp.direction = draw_direction(random);
    }
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
    errors.all.push_back(std::abs(found / truth - 1));
    errors.once.push_back(1 - single / truth);
  }
  return errors;
}

TEST(MultipleScattering, WholeGlowOfALampInLayersIsNearTheTrueOne) {
  struct LampCase {
    const char* name;
    bool is_cone, is_soft;
    int rays;  // the walk is sure of every other one, but of few of cones
    std::size_t sure_rays;
    double once;  // how much too dark single scattering is at least, in half of them
    double median, typical;
  };
  for (const LampCase& c :
       {LampCase{"points", false, false, 400, 200, 0.3, kLayeredScatteringMedianError, kLayeredScatteringTypicalError},
        {"soft points", false, true, 400, 100, 0.2, kSoftLayeredScatteringMedianError, kSoftLayeredScatteringTypicalError},
        {"cones", true, false, 1200, 100, 0, kLayeredConeScatteringMedianError, kLayeredConeScatteringTypicalError}}) {
    const LayeredErrors errors = layered_errors(c.is_cone, c.is_soft, c.rays);
    std::printf("%zu rays of %s in layers: %.3f and %.3f of the glow, scattered once %.3f and %.3f too dark\n",
                errors.all.size(), c.name, measure::quantile(errors.all, 0.5), measure::quantile(errors.all, 0.9),
                measure::quantile(errors.once, 0.5), measure::quantile(errors.once, 0.9));
    ASSERT_GT(errors.all.size(), c.sure_rays);
    EXPECT_LE(measure::quantile(errors.all, 0.5), c.median) << c.name;
    EXPECT_LE(measure::quantile(errors.all, 0.9), c.typical) << c.name;
    EXPECT_GT(measure::quantile(errors.once, 0.5), c.once) << c.name;
  }
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

/// Turns of a surface away from facing the lamp.
constexpr std::array kTurns{0.0, 0.8, pi / 2, pi - 0.8, pi};

/// What surfaces at a depth from a lamp receive: the radiance of all directions before them, summed.
std::array<double, kTurns.size()> summed_irradiances(const PlacedLight& lamp, const Atmosphere& air,
                                                     const measure::RadialScattering::Glow& glow, double unit) {
  constexpr int kAngles = 300, kAround = 64;
  std::array<double, kTurns.size()> sums{};
  for (int i = 0; i < kAngles; ++i) {
    const double from = 1e-5 * std::pow(pi / 1e-5, double(i) / kAngles);
    const double to = 1e-5 * std::pow(pi / 1e-5, (i + 1.) / kAngles);
    const double angle = (from + to) / 2;
    const double single = unit * reference_airlight(lamp, air, ray_beside(angle));
    const double light = (single + glow.at(-lamp.position.z, angle)) * std::sin(angle) * (to - from) / 2;
    for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
      for (int k = 0; k < kAround; ++k) {
        const double cosine = std::cos(kTurns[turn]) * std::cos(angle) +
                              std::sin(kTurns[turn]) * std::sin(angle) * std::cos(pi * (k + 0.5) / kAround);
        sums[turn] += light * std::max(cosine, 0.0) / kAround;
      }
    }
  }
  return sums;
}

glm::dvec3 normal_at(double turn) { return {std::sin(turn), 0, -std::cos(turn)}; }

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
      const auto truths = summed_irradiances(lamp, air, glow, kQuadratic);
      const DiffuseLight one = kQuadratic * scattered_light(lamp, source, air, glm::dvec3(0.0));
      DiffuseLight two{.all = one.all, .flow = -one.flow};  // and of a lamp behind
      two += one;
      const double unit = -std::expm1(-depth) / (depth * depth);
      for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
        const glm::dvec3 normal = normal_at(kTurns[turn]);
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

TEST(ScatteredIrradiance, OfASoftLampIsNearTheSumOfItsGlow) {
  const measure::RadialScattering nodes(0.4);
  Random random(4211);
  std::vector<double> errors;
  for (const Case& c : kCases) {
    const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = c.phase};
    const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
    for (int lamps = 0; lamps < 3; ++lamps) {
      const Attenuation law = soft_law(random);
      const auto glow = nodes.solve(c.phase, [&](double r) { return r * r * attenuation_at(law, r); });
      const ScatteringSource source = scattering_source(soft_lamp_ahead(law, 1).light, air, beams);
      for (const double depth : {0.1, 0.5, 2.0}) {
        const PlacedLight lamp = soft_lamp_ahead(law, depth);
        const auto truths = summed_irradiances(lamp, air, glow, 1);
        const DiffuseLight found = scattered_light(lamp, source, air, glm::dvec3(0.0));
        for (std::size_t turn = 0; turn < kTurns.size(); ++turn) {
          errors.push_back(std::abs(irradiance(found, normal_at(kTurns[turn])) - truths[turn]) / truths[0]);
        }
      }
    }
  }
  std::printf("irradiance of soft lamps: median error %.2f, of 9 in 10 %.2f, largest %.2f\n",
              measure::quantile(errors, 0.5), measure::quantile(errors, 0.9), measure::quantile(errors, 1));
  EXPECT_LE(measure::quantile(errors, 0.5), kSoftIrradianceMedianError);
  EXPECT_LE(measure::quantile(errors, 0.9), kSoftIrradianceTypicalError);
}

/// The random walk's, with four times the paths where a first one is unsure.
double walked_scattering(const PlacedLight& lamp, const Atmosphere& air, const EyeRay& ray, double single) {
  measure::ScatteringWalk walk;
  walk.paths = 2048;
  const auto first = measure::walk_scattering(lamp, air, ray, walk).higher;
  if (first.error < 0.05 * (single + first.value)) return first.value;
  walk.paths *= 4;
  return measure::walk_scattering(lamp, air, ray, walk).higher.value;
}

/// Errors of the whole glow of cones that point anywhere, those of the walk included.
std::vector<double> cone_errors(const Phase& phase, bool is_soft, int count) {
  const Atmosphere air{.fog = {FogMode::exp, 1}, .phase = phase};
  const ScatteringTable table = make_scattering_table(air);
  const ThinBeams beams = make_thin_beams(air, table);
  Random random(4204);
  std::vector<double> errors;
  for (int i = 0; i < count; ++i) {
    const double depth = random.log_uniform(0.02, 3);
    const double aim = random.uniform(0, pi), around = random.uniform(0, 2 * pi);
    PlacedLight lamp = is_soft ? soft_lamp_ahead(soft_law(random), depth) : lamp_ahead(depth);
    lamp.light.cone = draw_cone(random, i % 3);
    lamp.direction = {std::sin(aim) * std::cos(around), std::sin(aim) * std::sin(around), std::cos(aim)};
    const EyeRay ray = ray_beside(random.log_uniform(1, 150) * pi / 180);
    const double single = reference_airlight(lamp, air, ray);
    const double truth = walked_scattering(lamp, air, ray, single);
    const double found = multiple_scattering(lamp, scattering_source(lamp.light, air, beams), air, table, ray);
    errors.push_back(std::abs(found - truth) / (single + truth));
  }
  return errors;
}

TEST(MultipleScattering, WholeGlowOfAConeIsThatOfTheRandomWalk) {
  struct ConeCase {
    const char* name;
    Phase phase;
    bool is_soft;
    double median, typical;
  };
  for (const ConeCase& c :
       {ConeCase{"isotropic", {}, false, kConeScatteringMedianError, kConeScatteringTypicalError},
        {"soft, isotropic", {}, true, kSoftConeScatteringMedianError, kSoftConeScatteringTypicalError},
        {"droplets of 5", Phase::droplets(5), false, kDropletConeScatteringMedianError,
         kDropletConeScatteringTypicalError},
        {"droplets of 10", Phase::droplets(10), false, kDropletConeScatteringMedianError,
         kDropletConeScatteringTypicalError},
        {"droplets of 30", Phase::droplets(30), false, kDropletConeScatteringMedianError,
         kDropletConeScatteringTypicalError},
        {"soft, droplets of 10", Phase::droplets(10), true, kSoftDropletConeScatteringMedianError,
         kSoftDropletConeScatteringTypicalError}}) {
    const std::vector<double> errors = cone_errors(c.phase, c.is_soft, 32);
    std::printf("%-20s median %.3f, of 9 in 10 %.3f, largest %.3f\n", c.name, measure::quantile(errors, 0.5),
                measure::quantile(errors, 0.9), measure::quantile(errors, 1));
    EXPECT_LE(measure::quantile(errors, 0.5), c.median) << c.name;
    EXPECT_LE(measure::quantile(errors, 0.9), c.typical) << c.name;
  }
}

}  // namespace
}  // namespace litfog::test
