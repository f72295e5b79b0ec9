// SPDX-License-Identifier: Apache-2.0
#include "litfog/airlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "litfog/solve.h"
#include "reference/double_limits.h"
#include "reference/random_airlight.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

constexpr double kStep = 1 / 255.;
constexpr std::array kLampLegs{LampLeg::clear, LampLeg::fogged};

/// The airlight by its definition, from vectors and without the library's formulas. Where the integrand is not smooth
/// is found by its changes of side on a grid.
class Definition {
 public:
  using Real = long double;
  using Vector = glm::vec<3, Real>;

  explicit Definition(const AirlightCase& c)
      : c_(c),
        direction_(glm::normalize(Vector(c.ray.direction))),
        axis_(glm::normalize(Vector(c.light.direction))),
        density_(Real(c.fog.density) * Real(c.light.light.density_scale)) {}

  Real integral() const {
    const Real approach = glm::dot(Vector(c_.light.position) - Vector(c_.ray.origin), direction_);
    const Real end = std::min(Real(c_.ray.length), (c_.fog.mode == FogMode::exp ? 200 : 14) / density_);
    std::vector<Real> grid{0, end};
    std::vector<Real> cuts{0, end};
    const auto add_towards = [&](Real centre) {
      const auto add = [end](std::vector<Real>& places, Real s) {
        if (s > 0 && s < end) places.push_back(s);
      };
      add(cuts, centre);
      int i = 0;
      for (Real size = 1e-6L; size < 1e7L; size *= 1.3L, ++i) {
        for (const Real place : {centre - size, centre + size}) {
          add(grid, place);
          if (i % 8 == 0) add(cuts, place);
        }
      }
    };
    for (const Real centre : {Real(0), approach, approach / 2}) add_towards(centre);
    add_towards(find_smallest_angle(grid));
    std::sort(grid.begin(), grid.end());
    const Cone& cone = c_.light.light.cone;
    const auto add_changes = [&](const auto& side) {
      for (std::size_t i = 0; i + 1 < grid.size(); ++i) {
        Real low = grid[i], high = grid[i + 1];
        const bool is_above = side(low) > 0;
        if (is_above == (side(high) > 0)) continue;
        for (int j = 0; j < 100; ++j) {
          const Real middle = (low + high) / 2;
          ((side(middle) > 0) == is_above ? low : high) = middle;
        }
        cuts.push_back(low);
      }
    };
    add_changes([&](Real s) { return denominator(range(s)) - 1; });
    add_changes([&](Real s) { return denominator(range(s)) * Real(c_.light.light.threshold) - 1; });
    if (cone.profile == ConeProfile::cosine) {
      add_changes([&](Real s) { return cosine(s) - std::cos(Real(cone.half_angle)); });
    } else if (cone.profile == ConeProfile::smoothstep) {
      add_changes([&](Real s) { return cosine(s) - std::cos(Real(cone.inner)); });
      add_changes([&](Real s) { return cosine(s) - std::cos(Real(cone.outer)); });
    }
    std::sort(cuts.begin(), cuts.end());
    Real sum = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (!(cuts[i + 1] > cuts[i])) continue;
      sum += boost::math::quadrature::gauss_kronrod<Real, 31>::integrate([&](Real s) { return integrand(s); }, cuts[i],
                                                                         cuts[i + 1], 10, 1e-11L);
    }
    return sum;
  }

 private:
  Vector from_light(Real s) const { return Vector(c_.ray.origin) + s * direction_ - Vector(c_.light.position); }
  Real range(Real s) const { return glm::length(from_light(s)); }
  Real cosine(Real s) const { return range(s) > 0 ? glm::dot(from_light(s), axis_) / range(s) : Real(1); }
  Real denominator(Real r) const {
    const auto [constant, linear, quadratic] = c_.light.light.attenuation;
    return Real(constant) + Real(linear) * r + Real(quadratic) * r * r;
  }
  Real optical_depth(Real r) const { return c_.fog.mode == FogMode::exp ? density_ * r : density_ * r * density_ * r; }
  Real beam(Real s) const {
    const Cone& cone = c_.light.light.cone;
    if (cone.profile == ConeProfile::none) return 1;
    if (cone.profile == ConeProfile::cosine) {
      return cosine(s) > std::cos(Real(cone.half_angle)) ? std::pow(cosine(s), Real(cone.exponent)) : 0;
    }
    const Real outer = std::cos(Real(cone.outer));
    const Real t = std::clamp((cosine(s) - outer) / (std::cos(Real(cone.inner)) - outer), Real(0), Real(1));
    return t * t * (3 - 2 * t);
  }
  Real integrand(Real s) const {
    const Real r = range(s);
    if (denominator(r) * Real(c_.light.light.threshold) > 1) return 0;
    Real value = density_ * (c_.fog.mode == FogMode::exp ? 1 : 2 * density_ * s) * std::exp(-optical_depth(s));
    if (c_.scattering.lamp_leg == LampLeg::fogged) value *= std::exp(-optical_depth(r));
    const Real g = c_.scattering.asymmetry;
    const Real cos_scattering = r > 0 ? -glm::dot(from_light(s), direction_) / r : Real(-1);
    value *= (1 - g * g) / std::pow(1 + g * g - 2 * g * cos_scattering, 1.5L);
    return value * beam(s) / std::max(Real(1), denominator(r));
  }
  Real find_smallest_angle(const std::vector<Real>& grid) const {
    const auto best = std::max_element(grid.begin(), grid.end(), [&](Real a, Real b) { return cosine(a) < cosine(b); });
    Real low = *best / 1.4L, high = *best * 1.4L + 1e-7L;
    for (int i = 0; i < 80; ++i) {
      const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
      (cosine(a) < cosine(b) ? low : high) = cosine(a) < cosine(b) ? a : b;
    }
    return (low + high) / 2;
  }

  const AirlightCase& c_;
  Vector direction_;
  Vector axis_;
  Real density_;
};

double reference_of(const AirlightCase& c) { return reference_airlight(c.light, c.fog, c.ray, c.scattering); }

/// The axial airlight of L or Q > 0 and 0 < density < infinity, by 50 digits.
Digits50 axial_reference(const SolveCase& c) {
  static boost::math::quadrature::tanh_sinh<Digits50> quadrature(9);
  const Attenuation& a = c.attenuation;
  const Digits50 extent = reference_extent(a, c.threshold);
  if (extent == 0) return 0;
  const Digits50 density = c.fog.density;
  const bool is_exp = c.fog.mode == FogMode::exp;
  const Digits50 knee = std::min(reference_knee(a), extent);
  const Digits50 end = std::min(extent, Digits50((is_exp ? 150 : 13) / density));
  const Digits50 doubled = reference_level_range(a, 0.5 / std::max(1.0, a.constant));
  Digits50 sum = reference_opacity(c.fog.mode, density, knee);
  Digits50 size = std::min(Digits50(1 / density), Digits50(doubled - knee));
  for (Digits50 low = knee; low < end; size *= 4) {
    const Digits50 high = std::min(end, Digits50(low + size));
    sum += quadrature.integrate(
        [&](const Digits50& range) -> Digits50 {
          const Digits50 depth = density * range;
          const Digits50 scattered = is_exp ? Digits50(exp(-depth)) : Digits50(2 * depth * exp(-depth * depth));
          return density * scattered * reference_attenuation(a, range);
        },
        low, high, Digits50(1e-25));
    low = high;
  }
  return sum;
}

TEST(Airlight, AxialAirlightHasItsStatedErrorAgainst50Digits) {
  constexpr int kLights = 300;
  Random random(62);
  for (const FogMode mode : kModes) {
    WorstError ordinary("axial_airlight", std::string(name_of(mode)) + ", ordinary lights", kAxialAirlightMaxUlp);
    WorstError wide("axial_airlight", std::string(name_of(mode)) + ", 1e-30 to 1e30", kAxialAirlightMaxUlp);
    for (int i = 0; i < 2 * kLights; ++i) {
      SolveCase c = draw_ordinary_case(random, mode);
      if (i % 2 != 0) {
        const auto draw = [&] { return random.log_uniform(1e-30, 1e30); };
        c = {{random.chance(0.3) ? 0 : draw(), draw(), draw()}, {mode, draw()}, random.log_uniform(1e-9, 0.99)};
      }
      if (compute_extent(c.attenuation, c.threshold) == 0) continue;
      (i % 2 != 0 ? wide : ordinary)
          .add(ulp_error(axial_airlight(c.attenuation, c.fog, c.threshold), axial_reference(c)),
               [&] { return to_string(c); });
    }
    ordinary.check();
    wide.check();
  }
}

TEST(Airlight, AxialAirlightIsNeverBelowTheIntensityNorAboveItsLimits) {
  Random random(63);
  for (int i = 0; i < 20000; ++i) {
    SolveCase c = draw_ordinary_case(random, random.pick(kModes));
    if (i % 2 != 0) {
      c.attenuation = {random.any_positive<double>(), random.any_positive<double>(), random.any_positive<double>()};
      c.fog.density = random.any_positive<double>();
    }
    const double axial = axial_airlight(c.attenuation, c.fog, c.threshold);
    const auto solution = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
    ASSERT_GE(axial, solution.intensity * (1 - 1e-15)) << to_string(c);
    ASSERT_LE(axial, opacity_at(c.fog, solution.extent) * (1 + 1e-15)) << to_string(c);
  }
}

TEST(Airlight, AxialAirlightHasItsLimits) {
  for (const FogMode mode : kModes) {
    EXPECT_EQ(axial_airlight({1, 0.1, 0.01}, {mode, 0}), 0);
    EXPECT_EQ(axial_airlight({1, 0, 0}, {mode, 0}), 0);
    EXPECT_EQ(axial_airlight({2, 0.1, 0.01}, {mode, kInfinity}), 0.5);
    EXPECT_EQ(axial_airlight({0, 0.1, 0.01}, {mode, kInfinity}), 1);
    EXPECT_EQ(axial_airlight({4, 0, 0}, {mode, 1e-3}), 0.25);
    EXPECT_EQ(axial_airlight({0.5, 0, 0}, {mode, 1e-3}), 1);
    EXPECT_EQ(axial_airlight({20, 0.1, 0.01}, {mode, 1e-3}, 0.05), 0);
    EXPECT_EQ(axial_airlight({20, 0.1, 0.01}, {mode, kInfinity}, 0.05), 0);
  }
  // The plateau alone: a light that ends at its knee but for the last ulp.
  EXPECT_NEAR(axial_airlight({0, 1, 0}, {FogMode::exp, 2}, 1 - 1e-15), opacity_at({FogMode::exp, 2}, 1), 1e-15);
}

TEST(Airlight, AxialAirlightOfALightIsThatOfItsFog) {
  Light light;
  light.attenuation = {1, 0.1, 0.01};
  light.threshold = 0.1;
  light.density_scale = 0.4;
  EXPECT_EQ(axial_airlight(light, {FogMode::exp2, 0.1}),
            axial_airlight({1, 0.1, 0.01}, {FogMode::exp2, 0.4 * 0.1}, 0.1));
}

TEST(Airlight, AxialAirlightsAreThoseOfEachLight) {
  const std::vector<double> constant{1, 0, 2, -1}, linear{0.1, 0.2, 0, 1}, quadratic{0, 0.01, 0.02, 1};
  const std::vector<double> threshold{0.05, 0.1, 0.2, 0.3}, density{0.01, 0.1, kInfinity, 1};
  for (const FogMode mode : kModes) {
    std::vector<double> each(4), same(4);
    EXPECT_EQ(axial_airlights(mode, {constant, linear, quadratic, threshold, density}, each), 1u);
    EXPECT_EQ(axial_airlights(mode, {constant, linear, quadratic, {threshold.data(), 1}, {density.data(), 1}}, same),
              1u);
    for (std::size_t i = 0; i < 3; ++i) {
      const Attenuation attenuation{constant[i], linear[i], quadratic[i]};
      EXPECT_EQ(each[i], axial_airlight(attenuation, {mode, density[i]}, threshold[i])) << i;
      EXPECT_EQ(same[i], axial_airlight(attenuation, {mode, 0.01}, 0.05)) << i;
    }
    EXPECT_EQ(each[3], 0);
  }
}

TEST(Airlight, WrongArgumentsOfAxialAirlightAreErrors) {
  EXPECT_EQ(error_of([] { axial_airlight({-1, 0, 0}, {}); }), "attenuation.constant = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([] { axial_airlight({1, 0, 0}, {FogMode::exp, -1}); }), "fog.density = -1: must be >= 0");
  EXPECT_EQ(error_of([] { axial_airlight({1, 0, 0}, {}, 1); }), "threshold = 1: must be in (0, 1)");
}

TEST(Airlight, ReferenceIsTheDefinitionByAnotherQuadrature) {
  constexpr int kRays = 12;
  Random random(61);
  for (const FogMode mode : kModes) {
    for (const LampLeg leg : kLampLegs) {
      for (const bool is_spot : {false, true}) {
        WorstError error("reference_airlight", std::string(name_of(mode)) + (is_spot ? ", spots" : ", points"),
                         kReferenceAirlightMaxError, "relative");
        for (int i = 0; i < kRays; ++i) {
          AirlightCase c = is_spot ? draw_spot_airlight_case(random, mode, leg) : draw_airlight_case(random, mode, leg);
          if (i % 2 == 0) c.scattering.asymmetry = random.uniform(-0.95, 0.95);
          const double expected = double(Definition(c).integral());
          if (expected < 1e-13) continue;  // of rays that meet the light, rounding alone
          error.add(relative_error(reference_of(c), expected), [&] { return to_string(c); });
        }
        error.check();
      }
    }
  }
}

}  // namespace
}  // namespace litfog::test
