// SPDX-License-Identifier: Apache-2.0
#include "litfog/multiple_scattering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
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
using std::numbers::pi;

/// A lamp of 1 / r^2 from 0.1 mm on.
PlacedLight inverse_square_lamp(const dvec3& position) {
  Light light;
  light.attenuation = {.constant = 0, .linear = 0, .quadratic = 1e8};
  return {.light = light, .position = position};
}

EyeRay ray_at(double angle, double length = kInfinity) {
  return {.direction = {std::sin(angle), 0, -std::cos(angle)}, .length = length};
}

Atmosphere uniform_fog(double density, const Phase& phase = {}) {
  return {.fog = {FogMode::exp, density}, .phase = phase};
}

double scattering_of(const PlacedLight& light, const Atmosphere& air, const EyeRay& ray) {
  return multiple_scattering(light, air, make_scattering_table(air), ray);
}

std::string describe(const Attenuation& a, double density) {
  return "C " + std::to_string(a.constant) + ", L " + std::to_string(a.linear) + ", Q " + std::to_string(a.quadratic) +
         ", density " + std::to_string(density);
}

/// The definition's integral over the logarithm of the depth, times a power of the depth, cut at the knee and where the
/// law changes its power, in 64 bits of mantissa.
long double integrated_intensity(const Attenuation& a, double density, long double power = 0) {
  using Real = long double;
  std::vector<Real> cuts{-60, -1, 0, 1, 2, 3, 4.5};
  const auto cut_at = [&](double range) {
    const Real place = std::log(Real(range) * density);
    if (place > cuts.front() && place < 4.5) cuts.push_back(place);
  };
  cut_at(compute_knee(a));
  cut_at(a.constant / a.linear);
  cut_at(a.linear / a.quadratic);
  cut_at(std::sqrt(a.constant / a.quadratic));
  std::ranges::sort(cuts);
  Real sum = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (!(cuts[i] > cuts[i - 1])) continue;
    sum += boost::math::quadrature::gauss_kronrod<Real, 31>::integrate(
        [&](Real t) {
          const Real depth = std::exp(t), range = depth / density;
          const Real law = 1 / (a.constant + range * (a.linear + range * a.quadratic));
          return std::pow(depth, 1 + power) * std::exp(-depth) * range * range * std::min(law, Real(1));
        },
        cuts[i - 1], cuts[i], 12, Real(1e-13));
  }
  return sum;
}

/// soft_range() times the density, in isotropic fog.
double integrated_soft_depth(const Attenuation& a, double density) {
  const long double mean = integrated_intensity(a, density, -0.5L) / integrated_intensity(a, density);
  const double x = double(std::sqrt(std::numbers::pi_v<long double>) / mean) - 1;
  return x > 0 ? x * x / std::sqrt(0.3 + 1.3 * x) : 0;
}

TEST(EffectiveIntensity, IsTheIntegral) {
  Random random(4201);
  WorstError error("effective_intensity", "C, L, Q 0 or 1e-9..1e12, d 1e-9..1e6", kEffectiveIntensityMaxError,
                   "relative");
  WorstError soft_error("soft_range", "C, L, Q 0 or 1e-9..1e12, d 1e-9..1e6", kSoftRangeMaxError, "mean free paths");
  for (int i = 0; i < 3000; ++i) {
    const auto draw = [&] { return random.chance(0.2) ? 0 : random.log_uniform(1e-9, 1e12); };
    Attenuation attenuation{draw(), draw(), draw()};
    const double density = random.log_uniform(1e-9, 1e6);
    if (i % 2 == 0) {  // the law changes where most light is scattered
      const double range = random.log_uniform(1e-3, 30) / density;
      attenuation.constant = random.log_uniform(1e-3, 1e3);
      attenuation.quadratic = attenuation.constant / (range * range);
      attenuation.linear = random.chance(0.5) ? 0 : attenuation.constant / range * random.log_uniform(1e-3, 10);
    }
    if (find_error(attenuation)) continue;
    error.add(
        double(std::abs(effective_intensity(attenuation, density) / integrated_intensity(attenuation, density) - 1)),
        [&] { return describe(attenuation, density); });
    soft_error.add(std::abs(density * soft_range(attenuation, density) - integrated_soft_depth(attenuation, density)),
                   [&] { return describe(attenuation, density); });
  }
  error.check();
  soft_error.check();
}

TEST(SoftRange, RisesWithTheMeanCosine) {
  const Attenuation law{1, 0.1, 0.01};
  EXPECT_NEAR(soft_range(law, 0.1, Phase::henyey_greenstein(0.8)) / soft_range(law, 0.1), 1.8, 1e-12);
}

TEST(SoftRange, IsNoneOfAPointAndFourMeanFreePathsAtMost) {
  for (const Phase& phase : {Phase{}, Phase::droplets(10), Phase::henyey_greenstein(0.95)}) {
    EXPECT_LE(soft_range({0, 0, 1e12}, 1, phase), 1e-5);
    EXPECT_LE(soft_range({0, 0, 1e40}, 1, phase), 1e-7);
    EXPECT_GE(soft_range({1, 0, 0}, 0.5, phase), 2 * soft_range({1, 0, 1}, 1, phase));
    EXPECT_LE(soft_range({1, 0, 0}, 0.5, phase), 2 * 4);
  }
  EXPECT_EQ(error_of([] { soft_range({}, 0); }), "density = 0: must be finite and > 0");
}

RC_GTEST_PROP(EffectiveIntensity, BoundsHoldAtKneesAndWhereTheLawChangesItsPower, ()) {
  const double constant = *near_one_of({0, 1e-9, 0.5, 1, 2}), linear = *near_one_of({0, 1e-3, 1});
  const Attenuation a{constant, linear, *near_one_of({0, 1e-6, 1, linear * linear / 4 / std::max(constant, 1e-9)})};
  RC_PRE(!find_error(a) && (linear == 0 || linear > 1e-9) && (a.quadratic == 0 || a.quadratic > 1e-13));
  const double knee = compute_knee(a);
  const double density = *near_one_of({1e-4, 1, knee > 0 && knee < kInfinity ? 1 / knee : 30});
  RC_ASSERT(std::abs(effective_intensity(a, density) / double(integrated_intensity(a, density)) - 1) <=
            kEffectiveIntensityMaxError);
}

TEST(EffectiveIntensity, InThinFogIsTheLampsOwn) {
  for (const double quadratic : {1e-4, 1.0, 300.0}) {
    EXPECT_NEAR(quadratic * effective_intensity({1, 0, quadratic}, 1e-9), 1, 1e-6);
    EXPECT_NEAR(quadratic * effective_intensity({0, 0, quadratic}, 1e-9), 1, 1e-6);
  }
}

TEST(MultipleScattering, SourceIsAsIntenseAsItsLightInTheFogThatItsClassSees) {
  Light light;
  light.attenuation = {1, 0.1, 0.01};
  light.density_scale = 0.5;
  Atmosphere air;
  air.fog = {FogMode::exp, 0.04};
  EXPECT_EQ(source_intensity(light, air), effective_intensity(light.attenuation, 0.02));
  air.fog.density = 0;
  EXPECT_EQ(source_intensity(light, air), 0);
}

TEST(EffectiveIntensity, InDenseFogIsThatOfTheNearLight) {
  // The integral of d e^(-d r) r^2 is 2 / d^2.
  for (const Attenuation& attenuation : {Attenuation{4, 0.1, 0.2}, Attenuation{0.5, 0, 0.01}}) {
    const double density = 1e7;
    const double expected = 2 / (density * density) * attenuation_at(attenuation, 0);
    EXPECT_NEAR(effective_intensity(attenuation, density) / expected, 1, 2e-6);
  }
}

TEST(EffectiveIntensity, FogTooThinOrTooThickForDoublesCountsAsTheLimit) {
  for (const Attenuation& attenuation : {Attenuation{0.23, 0.52, 0}, Attenuation{1, 0.1, 0.01}, Attenuation{1, 0, 0}}) {
    for (const double density : {1e-101, 1e-160, 1e-308}) {
      const double found = effective_intensity(attenuation, density);
      EXPECT_EQ(found, effective_intensity(attenuation, 1e-100));
      EXPECT_TRUE(std::isfinite(found) && found > 0) << found;
      PlacedLight lamp = inverse_square_lamp({0, 0, -30});
      lamp.light.attenuation = attenuation;
      EXPECT_EQ(scattering_of(lamp, uniform_fog(density), ray_at(0.2)), 0);
    }
    PlacedLight lamp = inverse_square_lamp({});
    lamp.light.attenuation = attenuation;
    const double in_lamp = scattering_of(lamp, uniform_fog(1e304), ray_at(0.2, 1));
    EXPECT_TRUE(std::isfinite(in_lamp) && in_lamp >= 0) << in_lamp;
    // Beside a beam, where the closest approach is behind the eye by a rounding.
    lamp.light.cone = Cone::cosine(0.25, 118);
    EyeRay beside = ray_at(pi / 2, 0);
    beside.origin = {2.4e-15, 0.47, 0};
    EXPECT_EQ(scattering_of(lamp, uniform_fog(1e272), beside), 0);
  }
}

TEST(EffectiveIntensity, BadArgumentIsNamed) {
  EXPECT_EQ(error_of([] { effective_intensity({}, 0); }), "density = 0: must be finite and > 0");
  EXPECT_EQ(error_of([] { effective_intensity({}, kInfinity); }), "density = inf: must be finite and > 0");
  EXPECT_EQ(error_of([] { effective_intensity({}, kNan); }), "density = nan: must be finite and > 0");
  EXPECT_EQ(error_of([] { effective_intensity({-1, 0, 0}, 1); }), error_of([] { compute_knee({-1, 0, 0}); }));
}

TEST(ScatteredLight, PositionThatIsNoneIsNamed) {
  const auto refused = [](const dvec3& position) {
    return error_of([&] { scattered_light(inverse_square_lamp({}), {}, uniform_fog(0.1), position); });
  };
  EXPECT_EQ(refused({0, kNan, 0}).find("position.y = nan: "), 0u);
  EXPECT_EQ(refused({0, 0, kInfinity}).find("position.z = inf: "), 0u);
}

TEST(ScatteredLight, SourceWithoutABeamIsRefused) {
  const PlacedLight lamp = inverse_square_lamp({});
  const Atmosphere air = uniform_fog(0.1);
  EXPECT_EQ(error_of([&] { scattered_light(lamp, scattering_source(lamp.light, air), air, dvec3(1, 0, 0)); }),
            "source.beam = 0: must be the light's, made with ThinBeams");
}

TEST(ScatteredLight, LightOrSurfaceThatIsNoneIsNamed) {
  EXPECT_EQ(error_of([] { irradiance({.all = -1}, {0, 1, 0}); }), "all = -1: must be in [0, 1e100]");
  EXPECT_EQ(error_of([] {
              irradiance({.all = 1, .flow = {0, 2e100, 0}}, {0, 1, 0});
            }),
            "flow.y = 2e+100: must be at most 1e100 in magnitude");
  EXPECT_EQ(error_of([] { irradiance({.all = 1}, {0, 2, 0}); }), "normal = 2: length must be 1 within 1e-6");
}

// The flow through a sphere around a point lamp is what has been scattered within it. What the two sides of a surface
// receive differs by the flow through it, and is a fourth of all light in the mean over surfaces.
TEST(ScatteredLight, NoneIsLost) {
  const PlacedLight lamp = inverse_square_lamp({1, 2, 3});
  for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.8), Phase::droplets(10)}) {
    const Atmosphere air = uniform_fog(0.1, phase);
    const ScatteringSource source =
        scattering_source(lamp.light, air, make_thin_beams(air, make_scattering_table(air)));
    for (const double range : {0.5, 10.0, 80.0}) {
      const dvec3 away = glm::normalize(dvec3(2, -1, 0.5));
      const DiffuseLight light = scattered_light(lamp, source, air, lamp.position + range * away);
      EXPECT_NEAR(glm::dot(light.flow, away) * 1e8 * range * range / -std::expm1(-0.1 * range), 1, 1e-5) << range;
      EXPECT_NEAR(glm::length(light.flow - glm::dot(light.flow, away) * away), 0, 1e-5 * light.all) << range;
      const dvec3 across = glm::normalize(glm::cross(away, dvec3(1, 0, 0)));
      double sum = 0;
      for (int i = 0; i < 1000; ++i) {
        const double cosine = (i + 0.5) / 500 - 1;
        const dvec3 normal = cosine * away + std::sqrt(1 - cosine * cosine) * across;
        const double received = irradiance(light, normal);
        EXPECT_NEAR(received - irradiance(light, -normal), -glm::dot(light.flow, normal), 1e-9 * light.all) << cosine;
        sum += received / 1000;
      }
      EXPECT_NEAR(sum / light.all, 0.25, 1e-5) << range;
    }
  }
}

// In fog that scatters forwards, almost all light of a narrow beam flows one way, and the flow is as long as the whole.
// The two count a soft lamp as farther off by different ranges.
TEST(ScatteredLight, FlowsNoMoreThanThereIs) {
  Random random(4207);
  for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.95), Phase::droplets(10)}) {
    const Atmosphere air = uniform_fog(0.1, phase);
    const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
    for (int i = 0; i < 300; ++i) {
      PlacedLight lamp = inverse_square_lamp({});
      lamp.light.attenuation = {1, 0, random.chance(0.5) ? 0 : random.log_uniform(1e-5, 1)};
      lamp.light.cone = Cone::smoothstep(0, random.log_uniform(0.05, 1.5));
      lamp.direction = draw_direction(random);
      const ScatteringSource source = scattering_source(lamp.light, air, beams);
      const dvec3 place = random.log_uniform(0.1, 300) * draw_direction(random);
      const DiffuseLight light = scattered_light(lamp, source, air, place);
      EXPECT_LE(glm::length(light.flow), light.all * (1 + 1e-12)) << glm::length(place);
    }
  }
}

TEST(MultipleScattering, FogOfOneDensityAtAllHeightsIsUniform) {
  for (const Phase& phase : {Phase{}, Phase::droplets(10)}) {
    const Atmosphere uniform = uniform_fog(0.05, phase);
    Atmosphere layered = uniform_fog(0.02, phase);
    layered.profile = make_density_profile(std::array<DensityKnot, 2>{{{-3, 0.03}, {4, 0.03}}});
    PlacedLight lamp = inverse_square_lamp({3, 8, -20});
    for (const Cone& cone : {Cone{}, Cone::smoothstep(0.2, 0.6)}) {
      lamp.light.cone = cone;
      for (const double angle : {0.02, 0.5, 2.0}) {
        for (const double length : {5.0, 30.0, kInfinity}) {
          const double expected = scattering_of(lamp, uniform, ray_at(angle, length));
          EXPECT_NEAR(scattering_of(lamp, layered, ray_at(angle, length)) / expected, 1, cone == Cone{} ? 1e-4 : 0.02)
              << angle << ", " << length;
        }
      }
    }
  }
}

TEST(MultipleScattering, LayersUpsideDownScatterTheSame) {
  Random random(4208);
  const std::vector<DensityKnot> knots{{-4, 0.001}, {-3, 0.08}, {1, 0.02}, {6, 0.05}, {7, 0.012}};
  std::vector<DensityKnot> turned;
  for (const DensityKnot& knot : knots) turned.insert(turned.begin(), {-knot.height, knot.density});
  Atmosphere air = uniform_fog(0.0005, Phase::droplets(12)), turned_air = air;
  air.profile = make_density_profile(knots);
  turned_air.profile = make_density_profile(turned);
  const ScatteringTable table = make_scattering_table(air);
  const ThinBeams beams = make_thin_beams(air, table);
  const auto mirrored = [](const dvec3& v) { return dvec3{v.x, -v.y, v.z}; };
  WorstError error("multiple_scattering", "in layers and in them upside down", 1e-9, "relative");
  WorstError light_error("scattered_light", "in layers and in them upside down", 1e-9, "relative");
  for (int i = 0; i < 200; ++i) {
    PlacedLight lamp = inverse_square_lamp({random.uniform(-20, 20), random.uniform(-6, 10), -random.uniform(5, 40)});
    lamp.direction = draw_direction(random);
    if (i % 2 == 0) lamp.light.cone = Cone::smoothstep(0.3, 0.8);
    const EyeRay ray{.origin = {0, random.uniform(-6, 10), 0}, .direction = draw_direction(random), .length = 90};
    PlacedLight other = lamp;
    other.position = mirrored(lamp.position);
    other.direction = mirrored(lamp.direction);
    const EyeRay other_ray{.origin = mirrored(ray.origin), .direction = mirrored(ray.direction), .length = 90};
    const ScatteringSource source = scattering_source(lamp.light, air, beams);
    const double expected = multiple_scattering(lamp, source, air, table, ray);
    if (expected > 1e-20) {
      error.add(relative_error(multiple_scattering(other, source, turned_air, table, other_ray), expected),
                [&] { return "ray " + std::to_string(i); });
    }
    const DiffuseLight light = scattered_light(lamp, source, air, ray.origin);
    const DiffuseLight other_light = scattered_light(other, source, turned_air, other_ray.origin);
    light_error.add(relative_error(other_light.all, light.all), [&] { return "place " + std::to_string(i); });
    light_error.add(glm::length(mirrored(other_light.flow) - light.flow) / light.all,
                    [&] { return "place " + std::to_string(i); });
  }
  error.check();
  light_error.check();
}

TEST(ScatteredLight, OfAClassIsThatInTheThinnerFogItSees) {
  const auto layered = [](double scale) {
    Atmosphere air = uniform_fog(0.02 * scale);
    air.profile = make_density_profile(std::array<DensityKnot, 2>{{{0, 0.08 * scale}, {9, 0}}});
    return air;
  };
  PlacedLight lamp = inverse_square_lamp({1, 2, 3}), seen = lamp;
  lamp.light.density_scale = 0.25;
  const ThinBeams beams = make_thin_beams(uniform_fog(1), make_scattering_table(uniform_fog(1)));
  for (const auto& [air, thinner] :
       {std::pair(uniform_fog(0.08), uniform_fog(0.02)), std::pair(layered(1), layered(0.25))}) {
    const DiffuseLight found = scattered_light(lamp, scattering_source(lamp.light, air, beams), air, {9, 4, 8});
    const DiffuseLight expected =
        scattered_light(seen, scattering_source(seen.light, thinner, beams), thinner, {9, 4, 8});
    EXPECT_NEAR(found.all / expected.all, 1, 1e-12);
    EXPECT_NEAR(glm::length(found.flow - expected.flow) / expected.all, 0, 1e-12);
  }
}

// At the depths and angles of a beam's numbers. What a point lamp's light of intensity 1 flows is (1 - e^-depth) / r^2.
TEST(ScatteredLight, HasItsBeamsShareAndFlow) {
  const Atmosphere air = uniform_fog(0.1, Phase::droplets(10));
  const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
  PlacedLight lamp = inverse_square_lamp({1, 2, 3});
  lamp.light.cone = Cone::smoothstep(0.3, 0.8);
  lamp.direction = glm::normalize(dvec3{2, -1, 2});
  const dvec3 beside = glm::normalize(glm::cross(lamp.direction, dvec3{0, 1, 0}));
  for (const double law : {1e8, 0.01}) {
    if (law < 1) lamp.light.attenuation = {.constant = 1, .linear = 0, .quadratic = law};
    const ScatteringSource source = scattering_source(lamp.light, air, beams);
    for (std::size_t row = 0; row < kBeamDepths; ++row) {
      const double depth = 0.02 * std::pow(600, double(row) / (kBeamDepths - 1));
      const double range = std::sqrt(std::pow(depth / 0.1, 2) - std::pow(source.soft_range, 2));
      if (!(range > 0)) continue;
      for (std::size_t column = 1; column < kBeamAngles - 1; ++column) {
        const double angle = pi * double(column) / (kBeamAngles - 1);
        const dvec3 away = std::cos(angle) * lamp.direction + std::sin(angle) * beside;
        const dvec3 aside = std::cos(angle) * beside - std::sin(angle) * lamp.direction;
        const auto& [share, radial, turned, forward] = source.beam.texels[row][column];
        const double flow = source.intensity * -std::expm1(-depth) / std::pow(depth / 0.1, 2);
        const DiffuseLight light = scattered_light(lamp, source, air, lamp.position + range * away);
        const double all = std::max(flow * double(share) / double(forward), glm::length(light.flow));
        EXPECT_NEAR(light.all / all, 1, 1e-4) << row << ", " << column;
        const dvec3 direction = glm::normalize(double(radial) * away + double(turned) * aside);
        EXPECT_NEAR(glm::length(glm::normalize(light.flow) - direction), 0, 1e-4) << row << ", " << column;
        if (law > 1) {
          EXPECT_NEAR(glm::length(light.flow) / (flow * std::hypot(double(radial), double(turned))), 1, 1e-4);
        }
      }
    }
  }
}

// What layers keep of it is one part of all light and of the flow.
TEST(ScatteredLight, InLayersIsAPartOfThatInFogOfTheirMeanDensity) {
  Random random(4209);
  Atmosphere air = uniform_fog(0.002);
  air.profile = make_density_profile(std::array<DensityKnot, 3>{{{0, 0.02}, {5, 0.05}, {30, 0}}});
  const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
  for (int i = 0; i < 100; ++i) {
    PlacedLight lamp = inverse_square_lamp({0, random.uniform(0, 20), 0});
    lamp.light.cone = Cone::smoothstep(0.2, random.uniform(0.3, 1.5));
    lamp.direction = draw_direction(random);
    const ScatteringSource source = scattering_source(lamp.light, air, beams);
    const dvec3 place = lamp.position + random.log_uniform(1, 50) * draw_direction(random);
    const DiffuseLight light = scattered_light(lamp, source, air, place);
    const double mean = 0.002 + mean_density(air.profile, lamp.position.y, place.y);
    const DiffuseLight endless = scattered_light(lamp, source, uniform_fog(mean), place);
    const double part = light.all / endless.all;
    EXPECT_GT(part, 0) << i;
    EXPECT_LT(part, 1) << i;
    EXPECT_NEAR(glm::length(light.flow - part * endless.flow) / light.all, 0, 1e-9) << i;
  }
}

// Rays that are all but level, haze that all but vanishes, eyes a rounding beside the outermost knots.
TEST(MultipleScattering, InLayersNothingJumps) {
  const auto layer = [](double haze) {
    Atmosphere air = uniform_fog(haze);
    air.profile = make_density_profile(std::array<DensityKnot, 4>{{{-1, 0}, {0, 0.05}, {8, 0.05}, {9, 0}}});
    return air;
  };
  PlacedLight lamp = inverse_square_lamp({3, 4, -30});
  const auto along = [&](const Atmosphere& air, double height, double rise) {
    return scattering_of(lamp, air, {.origin = {0, height, 0}, .direction = {0, rise, -std::sqrt(1 - rise * rise)}});
  };
  for (const double rise : {1e-12, 1e-8, 1e-6, 1e-5, -1e-7}) {
    EXPECT_NEAR(along(layer(0), 4, rise) / along(layer(0), 4, 0), 1, 0.01) << rise;
  }
  for (const double haze : {1e-12, 1e-9, 1e-7, 1e-6}) {
    EXPECT_NEAR(along(layer(haze), 4, 0.01) / along(layer(0), 4, 0.01), 1, 0.01) << haze;
  }
  for (const double edge : {-1.0, 9.0}) {
    const double rise = edge < 0 ? 0.1 : -0.1;
    for (const double beside : {-1e-6, 1e-6}) {
      EXPECT_NEAR(along(layer(0), edge + beside, rise) / along(layer(0), edge, rise), 1, 0.001) << edge + beside;
    }
  }
}

// Along a ray that enters the layers from clear air, M depends neither on where the eye is nor on where the ray ends.
TEST(MultipleScattering, ClearAirOnEitherSideOfLayersChangesNothing) {
  Random random(4205);
  Atmosphere air = uniform_fog(0);
  air.profile = make_density_profile(std::array<DensityKnot, 4>{{{0, 0}, {1, 0.08}, {6, 0.03}, {9, 0}}});
  const ScatteringTable table = make_scattering_table(air);
  WorstError error("multiple_scattering", "eye and end of the ray in clear air", 1e-12, "relative");
  for (int i = 0; i < 300; ++i) {
    PlacedLight lamp = inverse_square_lamp({random.uniform(-20, 20), random.uniform(-3, 15), random.uniform(-40, 10)});
    if (i % 3 == 0) lamp.light.cone = Cone::smoothstep(0.3, 0.8);
    const dvec3 direction = glm::normalize(dvec3{0, random.chance(0.5) ? -1 : 1, -random.log_uniform(0.1, 10)});
    const auto along = [&](double before, double after) {
      const double entry = direction.y < 0 ? 9 : 0;
      const dvec3 origin = dvec3{0, entry, 0} - before * direction;
      return multiple_scattering(
          lamp, air, table,
          {.origin = origin, .direction = direction, .length = before + 9 / std::abs(direction.y) + after});
    };
    error.add(relative_error(along(random.log_uniform(0.1, 100), random.log_uniform(0.1, 100)), along(0, 0)),
              [&] { return "light " + std::to_string(i); });
  }
  error.check();
}

// Eyes, lamps and surfaces on knots, layers of no fog and of all, rays along them.
TEST(MultipleScattering, IsFiniteOnTheEdgesOfLayers) {
  for (const double density : {0.0, 1e-300, 0.1, 1e9, 1e300}) {
    for (const double base : {0.0, 1e-6}) {
      Atmosphere air = uniform_fog(base);
      air.profile = make_density_profile(std::array<DensityKnot, 3>{{{-2, 0}, {0, density}, {5, 0}}});
      const ScatteringTable table = make_scattering_table(air);
      for (const double lamp_height : {-2.0, 0.0, 3.0, 5.0, 1e6}) {
        PlacedLight lamp = inverse_square_lamp({0, lamp_height, -1});
        for (const double height : {-2.0, 0.0, 5.0, 9.0}) {
          for (const double rise : {-1.0, -1e-9, 0.0, 0.5, 1.0}) {
            const EyeRay ray{.origin = {0, height, 0}, .direction = {0, rise, -std::sqrt(1 - rise * rise)}};
            const double found = multiple_scattering(lamp, air, table, ray);
            EXPECT_TRUE(std::isfinite(found) && found >= 0)
                << density << ", " << base << ", " << lamp_height << ", " << height << ", " << rise << ": " << found;
          }
          const ScatteringSource source = scattering_source(lamp.light, air, make_thin_beams(air, table));
          const DiffuseLight light = scattered_light(lamp, source, air, {0, height, 0});
          EXPECT_TRUE(std::isfinite(light.all) && light.all >= 0) << density << ", " << lamp_height << ", " << height;
        }
      }
    }
  }
}

TEST(ScatteringTable, AtmosphereWithoutOneIsNamed) {
  const auto refused = [](const Atmosphere& air) {
    EXPECT_TRUE(find_scattering_error(air));
    const EyeRay ray;
    const ScatteringTable table{};
    const std::string sentence = error_of([&] { make_scattering_table(air); });
    EXPECT_EQ(error_of([&] { multiple_scattering(inverse_square_lamp({}), air, table, ray); }), sentence);
    return sentence;
  };
  EXPECT_EQ(refused({.fog = {FogMode::exp2, 0.1}}), "fog.mode = 1: must be exp for all orders of scattering");
  Atmosphere air = uniform_fog(0.1);
  air.albedo = 0.5;
  EXPECT_EQ(refused(air), "albedo = 0.5: must be 1 for all orders of scattering");
  const std::string rule =
      ": must be of one lobe with alpha 0 and g in [0, 0.95], or of droplets, for all orders of scattering";
  for (const double g : {-0.2, 0.97}) {
    EXPECT_EQ(refused(uniform_fog(0.1, Phase::henyey_greenstein(g))),
              "phase.first.asymmetry = " + std::string(g < 0 ? "-0.2" : "0.97") + rule);
  }
  EXPECT_EQ(refused(uniform_fog(0.1, {.first = {.asymmetry = 0, .alpha = 1}})), "phase.first.asymmetry = 0" + rule);
  Phase mixed = Phase::droplets(10);
  mixed.weight *= 0.9;
  EXPECT_NE(refused(uniform_fog(0.1, mixed)), "no error");
}

TEST(ScatteringTable, TableOfAnotherPhaseFunctionIsRefused) {
  const Phase phases[] = {
      {}, Phase::henyey_greenstein(0.01), Phase::henyey_greenstein(0.85), Phase::droplets(10), Phase::droplets(10.5)};
  for (const Phase& given : phases) {
    const ScatteringTable table = make_scattering_table(uniform_fog(1, given));
    for (const Phase& phase : phases) {
      const Atmosphere air = uniform_fog(0.1, phase);
      const std::string scattering =
          error_of([&] { multiple_scattering(inverse_square_lamp({}), air, table, EyeRay{}); });
      EXPECT_EQ(error_of([&] { make_thin_beams(air, table); }), scattering);
      if (&given == &phase)
        EXPECT_EQ(scattering, "no error");
      else
        EXPECT_TRUE(scattering.ends_with("must be of make_scattering_table for the atmosphere's phase function"));
    }
  }
}

TEST(ScatteringTable, AtmosphereThatIsNoneIsNamed) {
  const auto air = uniform_fog(-1);
  EXPECT_EQ(error_of([&] { make_scattering_table(air); }), "fog.density = -1: " + std::string(find_error(air)->rule));
}

/// The x of which ln x + x / scale is a part of the way from that of `first` to that of `last`.
double place_between(double first, double last, double scale, double part) {
  const auto of = [scale](double x) { return std::log(x) + x / scale; };
  double low = first, high = last;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (of(middle) < std::lerp(of(first), of(last), part) ? low : high) = middle;
  }
  return high;
}

// Depths of 0.02 to 30 go by equal steps of ln x + x / 5, angles of 0.2 to 180 degrees by equal steps of ln x + x / 2.
TEST(ScatteringTable, IsReadAtTheDepthsAndAnglesOfItsNumbers) {
  const ScatteringTable table = make_scattering_table(uniform_fog(1, Phase::droplets(10)));
  for (std::size_t i = 0; i < kScatteringDepths; i += 5) {
    const double depth = place_between(0.02, 30, 5, double(i) / (kScatteringDepths - 1));
    for (std::size_t j = 0; j < kScatteringAngles; j += 4) {
      const double angle = place_between(0.2 / 180 * pi, pi, 2, double(j) / (kScatteringAngles - 1));
      EXPECT_NEAR(scattered_at(table, depth, angle) / std::exp(double(table.logs[i][j])), 1, 1e-6) << i << ", " << j;
    }
  }
  EXPECT_EQ(scattered_at(table, 0.001, 1), scattered_at(table, 0.02, 1));
  EXPECT_EQ(scattered_at(table, 1, 0), scattered_at(table, 1, 0.2 / 180 * pi));
  EXPECT_NEAR(scattered_at(table, 90, 1), scattered_at(table, 30, 1) / 3, 1e-12 * scattered_at(table, 30, 1));
}

// Every fourth number is tabulated; a cubic between two of them strays little from the line.
TEST(ScatteringTable, NumbersBetweenTabulatedOnesAreNearALine) {
  for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.9), Phase::droplets(20)}) {
    const auto logs = make_scattering_table(uniform_fog(1, phase)).logs;
    const auto expect_near_line = [](float from, float to, float between, std::size_t part) {
      EXPECT_NEAR(double(between), std::lerp(double(from), double(to), double(part) / 4), 0.12);
    };
    for (std::size_t i = 0; i + 1 < kScatteringDepths; ++i) {
      for (std::size_t j = 0; j + 1 < kScatteringAngles; ++j) {
        const std::size_t up = i / 4 * 4, left = j / 4 * 4;
        if (left == j) expect_near_line(logs[up][j], logs[up + 4][j], logs[i][j], i - up);
        if (up == i) expect_near_line(logs[i][left], logs[i][left + 4], logs[i][j], j - left);
      }
    }
  }
}

TEST(ScatteringTable, PhasesThatAreTheSameHaveTheSame) {
  const ScatteringTable isotropic = make_scattering_table(uniform_fog(1));
  EXPECT_EQ(isotropic.logs, make_scattering_table(uniform_fog(0.01, Phase::henyey_greenstein(0))).logs);
  // The weight leaves nothing to its second lobe, or both lobes are isotropic.
  EXPECT_EQ(isotropic.logs, make_scattering_table(uniform_fog(1, {{}, {0.4, 0}, 1})).logs);
  EXPECT_EQ(isotropic.logs, make_scattering_table(uniform_fog(1, {{}, {}, 0.3})).logs);
  for (const double end : {kSmallestDroplets, kLargestDroplets}) {
    EXPECT_FALSE(find_scattering_error(uniform_fog(1, Phase::droplets(end)))) << end;
  }
}

TEST(MultipleScattering, AwkwardRaysAreFiniteAndNotNegative) {
  for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.95), Phase::droplets(50)}) {
    const ScatteringTable table = make_scattering_table(uniform_fog(1, phase));
    for (const double density : {0.0, 1e-9, 1e-3, 1.0, 1e6, 1e9}) {
      const Atmosphere air = uniform_fog(density, phase);
      for (const double range : {0.0, 1e-12, 1e-3, 1.0, 1e3}) {
        for (const double angle : {0.0, 1e-9, 0.01, pi / 2, pi}) {
          for (const double length : {0.0, 1e-9, 1.0, range, 1e3, 1e12, kInfinity}) {
            const PlacedLight lamp = inverse_square_lamp({0, 0, -range});
            const double found = multiple_scattering(lamp, air, table, ray_at(angle, length));
            EXPECT_TRUE(std::isfinite(found) && found >= 0)
                << found << ": density " << density << ", range " << range << ", angle " << angle << ", " << length;
            if (density == 0 || length == 0) {
              EXPECT_EQ(found, 0);
            }
          }
        }
      }
    }
  }
}

TEST(MultipleScattering, WhatAClassSeesIsThinner) {
  PlacedLight lamp = inverse_square_lamp({0, 0, -30});
  lamp.light.density_scale = 0.25;
  const PlacedLight other = inverse_square_lamp({0, 0, -30});
  EXPECT_NEAR(scattering_of(lamp, uniform_fog(0.08), ray_at(0.2, 50)) /
                  scattering_of(other, uniform_fog(0.02), ray_at(0.2, 50)),
              1, 1e-12);
  lamp.light.density_scale = 0;
  EXPECT_EQ(scattering_of(lamp, uniform_fog(0.08), ray_at(0.2)), 0);
}

TEST(MultipleScattering, DistancesCountInFreePaths) {
  // M / (I d^2) depends on depths: twice the density at half the distances has 4 times as much.
  const double thin = scattering_of(inverse_square_lamp({0, 0, -60}), uniform_fog(0.01), ray_at(0.1, 80));
  const double thick = scattering_of(inverse_square_lamp({0, 0, -30}), uniform_fog(0.02), ray_at(0.1, 40));
  EXPECT_NEAR(thick / thin, 4, 1e-5);
}

TEST(MultipleScattering, PartsOfARayAddUp) {
  Random random(4202);
  const Atmosphere air = uniform_fog(0.03, Phase::droplets(12));
  const ScatteringTable table = make_scattering_table(air);
  for (int i = 0; i < 500; ++i) {
    PlacedLight lamp = inverse_square_lamp({0, 0, -random.log_uniform(1, 200)});
    if (i % 3 == 0) lamp.light.cone = Cone::smoothstep(0.3, 0.8);
    const double whole_length = random.chance(0.2) ? kInfinity : random.log_uniform(1, 1000);
    const double part = random.uniform(0, std::min(whole_length, 300.0));
    EyeRay whole = ray_at(i % 4 == 0 ? 0 : random.uniform(0.01, pi), whole_length), near = whole, far = whole;
    near.length = part;
    far.origin += part * far.direction;
    far.length -= part;
    const double all = multiple_scattering(lamp, air, table, whole);
    // M is a difference of two large numbers, and never below 0.
    const double endless = multiple_scattering(lamp, air, table, ray_at(std::acos(-whole.direction.z)));
    const double sum = multiple_scattering(lamp, air, table, near) +
                       std::exp(-air.fog.density * part) * multiple_scattering(lamp, air, table, far);
    EXPECT_NEAR(sum, all, 0.05 * endless + 1e-9 * all) << part << " of " << whole_length;
  }
}

// Some rays are aimed at the lamp, before and behind which a beam's light differs most.
TEST(MultipleScattering, PartsOfARayInLayersAddUp) {
  Random random(4206);
  Atmosphere air = uniform_fog(0.002);
  air.profile = make_density_profile(std::array<DensityKnot, 3>{{{0, 0.02}, {5, 0.05}, {30, 0}}});
  const ScatteringTable table = make_scattering_table(air);
  WorstError error("multiple_scattering", "two parts of a ray in layers, 24 stretches", 0.02, "relative");
  for (int i = 0; i < 300; ++i) {
    PlacedLight lamp = inverse_square_lamp({random.uniform(-20, 20), random.uniform(0, 20), -random.uniform(5, 60)});
    if (i % 3 == 0) lamp.light.cone = Cone::smoothstep(0.3, 0.8);
    EyeRay whole{.origin = {0, random.uniform(1, 9), 0}, .direction = draw_direction(random), .length = 200};
    if (i % 4 == 0) whole.direction = glm::normalize(lamp.position - whole.origin);
    EyeRay near = whole, far = whole;
    near.length = random.uniform(1, 100);
    far.origin += near.length * whole.direction;
    far.length -= near.length;
    const double depth = near.length * (air.fog.density + mean_density(air.profile, near.origin.y, far.origin.y));
    error.add(relative_error(multiple_scattering(lamp, air, table, near) +
                                 std::exp(-depth) * multiple_scattering(lamp, air, table, far),
                             multiple_scattering(lamp, air, table, whole)),
              [&] { return "ray " + std::to_string(i); });
  }
  error.check();
}

TEST(MultipleScattering, ManyRaysAreEachOnes) {
  const Atmosphere air = uniform_fog(0.05, Phase::henyey_greenstein(0.8));
  const ScatteringTable table = make_scattering_table(air);
  const PlacedLight lamp = inverse_square_lamp({0, 0, -30});
  std::vector<EyeRay> rays{ray_at(0.1), ray_at(2, 7), ray_at(0.3, 90)};
  std::vector<double> found(rays.size(), 7);
  multiple_scattering(lamp, air, table, rays, found);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(found[i], multiple_scattering(lamp, air, table, rays[i]));
  }
  found.assign(rays.size(), 7);
  rays.back().length = -1;
  EXPECT_EQ(error_of([&] { multiple_scattering(lamp, air, table, rays, found); }), "rays[2].length = -1: must be >= 0");
  EXPECT_EQ(found, std::vector<double>(rays.size(), 7));
}

/// The largest change between neighbours of a sweep from 0 to 1, a fraction of the larger.
template <typename Value>
double largest_step(const Value& value, int steps) {
  double largest = 0, before = value(0.0);
  for (int i = 1; i <= steps; ++i) {
    const double now = value(double(i) / steps);
    EXPECT_TRUE(std::isfinite(now)) << i << " of " << steps;
    largest = std::max(largest, std::abs(now - before) / std::max(now, before));
    before = now;
  }
  return largest;
}

TEST(MultipleScattering, NothingJumps) {
  const auto expect_smooth = [](const char* name, const auto& value) {
    // A jump is as large in finer steps.
    const double coarse = largest_step(value, 500), fine = largest_step(value, 4000);
    EXPECT_LE(fine, coarse / 4 + 1e-7) << name << ": " << coarse << ", " << fine;
  };
  const PlacedLight lamp = inverse_square_lamp({0, 0, -30});
  const EyeRay ray = ray_at(0.05, 60);
  expect_smooth("asymmetry", [&](double x) {
    return scattering_of(lamp, uniform_fog(0.05, Phase::henyey_greenstein(0.95 * x)), ray);
  });
  expect_smooth("diameter", [&](double x) {
    return scattering_of(lamp, uniform_fog(0.05, Phase::droplets(std::lerp(5., 50., x))), ray);
  });
  const Atmosphere air = uniform_fog(0.05, Phase::droplets(12));
  const ScatteringTable table = make_scattering_table(air);
  const auto along = [&](const PlacedLight& light, const EyeRay& seen) {
    return multiple_scattering(light, air, table, seen);
  };
  // Depths and angles across the table's ends.
  expect_smooth("density", [&](double x) {
    return multiple_scattering(lamp, uniform_fog(std::pow(10, 5 * x - 4), Phase::droplets(12)), table, ray_at(0.05));
  });
  expect_smooth("range", [&](double x) {
    return along(inverse_square_lamp({0, 0, -std::pow(10, 5 * x - 2)}), ray_at(0.05));
  });
  expect_smooth("angle", [&](double x) { return along(lamp, ray_at(std::pow(10, 4 * x - 4) * pi)); });
  expect_smooth("length", [&](double x) { return along(lamp, ray_at(0.05, std::pow(10, 3 * x))); });
  expect_smooth("length past the lamp", [&](double x) { return along(lamp, ray_at(0.005, 20 + 20 * x)); });
  expect_smooth("passing the lamp", [&](double x) {
    EyeRay seen = ray_at(0.3);
    seen.origin = {0.2, 0, 20 - 100 * x};
    return along(lamp, seen);
  });
}

TEST(ScatteredBeam, PointLampHasItsOwnLight) {
  const Atmosphere air = uniform_fog(1, Phase::droplets(10));
  const ScatteredBeam beam =
      make_scattered_beam(beam_moments(Cone{}), make_thin_beams(air, make_scattering_table(air)));
  for (const auto& row : beam.texels) {
    for (const ScatteredBeam::Texel& texel : row) {
      EXPECT_NEAR(texel.share, 1, 1e-6);
      EXPECT_NEAR(texel.radial, 1, 1e-6);
      EXPECT_NEAR(texel.turned, 0, 1e-6);
      EXPECT_GT(texel.forward, 0);
    }
  }
}

// A flat beam of half angle H has the mean (1 - cos H) / 2 and the mean cosine (1 + cos H) / 2.
TEST(ScatteredBeam, MomentsAreTheFluxAndTheMeanCosine) {
  for (const double half : {0.01, 0.3, 1.5}) {
    const BeamMoments moments = beam_moments(Cone::cosine(half, 0));
    EXPECT_NEAR(moments[0] / ((1 - std::cos(half)) / 2), 1, 1e-9) << half;
    EXPECT_NEAR(moments[1] / moments[0], (1 + std::cos(half)) / 2, 1e-9) << half;
  }
}

// What a cone sends into the fog is not more, and not less, than its flux: light of all directions, summed over a
// sphere.
TEST(ScatteredBeam, LightOfASphereIsTheFlux) {
  const Atmosphere air = uniform_fog(1);
  const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
  for (const double half : {0.3, 1.0, 1.5}) {
    const BeamMoments moments = beam_moments(Cone::cosine(half, 0));
    for (const auto& row : make_scattered_beam(moments, beams).texels) {
      double sum = 0, whole = 0;
      for (int column = 0; column < kBeamAngles; ++column) {
        const double weight = std::sin(pi * column / (kBeamAngles - 1));
        sum += weight * double(row[std::size_t(column)].share);
        whole += weight;
      }
      EXPECT_NEAR(sum / whole / moments[0], 1, 0.02) << half;
    }
  }
}

// Beside a thin beam, whose blur counts for little there, light flows as from a point on it at kApparentStart.
TEST(ScatteredBeam, LightFlowsAwayFromItsApparentStart) {
  for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.8)}) {
    const Atmosphere air = uniform_fog(0.1, phase);
    const BeamMoments moments = beam_moments(Cone::cosine(0.1, 0));
    for (const auto& row : make_scattered_beam(moments, make_thin_beams(air, make_scattering_table(air))).texels) {
      for (int column = 7; column < kBeamAngles - 1; ++column) {
        const double angle = pi * column / (kBeamAngles - 1);
        const double away = kApparentStart * std::sin(angle), outward = 1 - kApparentStart * std::cos(angle);
        const ScatteredBeam::Texel& texel = row[std::size_t(column)];
        EXPECT_NEAR(double(texel.turned) / double(texel.radial) / (away / outward), 1, 0.03) << column;
      }
    }
  }
}

TEST(MultipleScattering, ConeOfAlmostAllDirectionsIsAlmostAPointLamp) {
  Random random(4210);
  for (const Phase& phase : {Phase{}, Phase::droplets(10), Phase::henyey_greenstein(0.8)}) {
    const Atmosphere air = uniform_fog(0.05, phase);
    const ThinBeams beams = make_thin_beams(air, make_scattering_table(air));
    const ScatteringTable table = make_scattering_table(air);
    for (int i = 0; i < 50; ++i) {
      PlacedLight lamp = inverse_square_lamp({random.uniform(-5, 5), random.uniform(-5, 5), -random.uniform(3, 40)});
      lamp.direction = draw_direction(random);
      const EyeRay ray = ray_at(random.uniform(0.05, 1), 60);
      const double point = multiple_scattering(lamp, scattering_source(lamp.light, air), air, table, ray);
      lamp.light.cone = Cone::smoothstep(3.1, pi);
      const double wide = multiple_scattering(lamp, scattering_source(lamp.light, air, beams), air, table, ray);
      EXPECT_NEAR(wide / point, 1, 0.02) << i;
      lamp.light.cone = Cone::smoothstep(0.2, 0.9);
      const double cone = multiple_scattering(lamp, scattering_source(lamp.light, air, beams), air, table, ray);
      EXPECT_LE(cone, point * (1 + 1e-9)) << i;
    }
  }
}

TEST(MultipleScattering, RaysPassASoftLampFartherOff) {  // in isotropic fog by its soft range, whatever the angle
  const double density = 0.05;
  const Atmosphere air = uniform_fog(density);
  const ScatteringTable table = make_scattering_table(air);
  PlacedLight lamp = inverse_square_lamp({0, 0, -30});
  lamp.light.attenuation = {.constant = 1, .linear = 0, .quadratic = 0.01};
  const ScatteringSource source = scattering_source(lamp.light, air);
  EXPECT_GT(source.soft_range, 5);
  for (const double angle : {0.1, 0.5, 1.0, 2.0, 3.0}) {
    const double beside = std::hypot(30 * std::sin(angle), source.soft_range);
    const double depth = density * std::hypot(30, source.soft_range);
    const double expected =
        source.intensity * density * density * scattered_at(table, depth, std::atan2(beside, 30 * std::cos(angle)));
    EXPECT_NEAR(multiple_scattering(lamp, source, air, table, ray_at(angle)) / expected, 1, 1e-12) << angle;
  }
}

TEST(MultipleScattering, NothingJumpsAsTheEyePassesASoftLamp) {
  for (const Phase& phase : {Phase{}, Phase::droplets(12), Phase::henyey_greenstein(0.9)}) {
    const Atmosphere air = uniform_fog(0.05, phase);
    const ScatteringTable table = make_scattering_table(air);
    PlacedLight lamp = inverse_square_lamp({0, 0, -30});
    lamp.light.attenuation = {.constant = 1, .linear = 0, .quadratic = 0.01};
    const ScatteringSource source = scattering_source(lamp.light, air);
    EXPECT_GT(source.soft_range, 5);
    for (const double beside : {0.0, 1e-6, 0.3}) {
      const auto passing = [&](double x) {
        EyeRay ray = ray_at(0.3);
        ray.origin = {beside, 0, -10 - 40 * x};
        return multiple_scattering(lamp, source, air, table, ray);
      };
      EXPECT_LE(largest_step(passing, 4000), largest_step(passing, 500) / 4 + 1e-7) << beside;
    }
  }
}

TEST(ScatteredBeam, NothingJumpsAsALampTurns) {
  for (const Phase& phase : {Phase{}, Phase::droplets(12)}) {
    const Atmosphere air = uniform_fog(0.05, phase);
    const ScatteringTable table = make_scattering_table(air);
    PlacedLight lamp = inverse_square_lamp({0, 0, -30});
    lamp.light.cone = Cone::smoothstep(0.1, 0.3);
    const ScatteringSource source = scattering_source(lamp.light, air, make_thin_beams(air, table));
    const auto turned = [&](double x) {
      lamp.direction = {0.8 * std::sin(2 * pi * x), 0.6, 0.8 * std::cos(2 * pi * x)};
      return multiple_scattering(lamp, source, air, table, ray_at(0.05, 60));
    };
    EXPECT_LE(largest_step(turned, 4000), largest_step(turned, 500) / 4 + 1e-7);
  }
}

}  // namespace
}  // namespace litfog::test
