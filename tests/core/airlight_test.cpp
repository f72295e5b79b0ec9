// SPDX-License-Identifier: Apache-2.0
// tanh_sinh asserts that no node rounds to an end of its interval. Here an end is as good as its neighbour.
#define BOOST_DISABLE_ASSERTS

#include "litfog/airlight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/expint.hpp>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "airlight/airlight_quadrature.h"
#include "airlight/airlight_text.h"
#include "core/value_errors.h"
#include "litfog/solve.h"
#include "reference/double_limits.h"
#include "reference/near_numbers.h"
#include "reference/random_airlight.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

constexpr double kStep = 1 / 255.;

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
        density_(Real(c.atmosphere.fog.density) * Real(c.light.light.density_scale)) {}

  /// agreement  of two rules on a stretch, relative
  Real integral(Real agreement = 1e-11L) const {
    const Real approach = glm::dot(Vector(c_.light.position) - Vector(c_.ray.origin), direction_);
    const Real end = std::min(Real(c_.ray.length), (c_.atmosphere.fog.mode == FogMode::exp ? 200 : 14) / density_);
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
    for (const DensityKnot& knot : c_.atmosphere.profile.used()) {
      const Real s = (Real(knot.height) - Real(c_.ray.origin.y)) / direction_.y;
      if (s > 0 && s < end) cuts.push_back(s);
    }
    std::sort(cuts.begin(), cuts.end());
    Real sum = 0;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (!(cuts[i + 1] > cuts[i])) continue;
      sum += boost::math::quadrature::gauss_kronrod<Real, 31>::integrate([&](Real s) { return integrand(s); }, cuts[i],
                                                                         cuts[i + 1], 10, agreement);
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
  Real optical_depth(Real r) const {
    return c_.atmosphere.fog.mode == FogMode::exp ? density_ * r : density_ * r * density_ * r;
  }
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
    Real value =
        density_ * (c_.atmosphere.fog.mode == FogMode::exp ? 1 : 2 * density_ * s) * std::exp(-optical_depth(s));
    if (c_.lamp_leg == LampLeg::fogged) value *= std::exp(-optical_depth(r));
    if (c_.atmosphere.profile.count > 0) {
      const Real eye = c_.ray.origin.y, lamp = c_.light.position.y, height = eye + s * direction_.y;
      const Real lit = c_.lamp_leg == LampLeg::fogged ? layered_depth(lamp, height, r) : 0;
      value = density_at(height) * std::exp(-layered_depth(eye, height, s) - lit);
    }
    value *= phase(r > 0 ? -glm::dot(from_light(s), direction_) / r : Real(-1));
    return value * beam(s) / std::max(Real(1), denominator(r));
  }
  Real density_at(Real height) const {
    const auto knots = c_.atmosphere.profile.used();
    Real density = knots.front().density;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const Real from = knots[i].height, to = knots[i + 1].height;
      if (height >= to) density = knots[i + 1].density;
      if (height > from && height < to) {
        const Real part = (height - from) / (to - from);
        density = (1 - part) * Real(knots[i].density) + part * Real(knots[i + 1].density);
      }
    }
    return density_ + Real(c_.light.light.density_scale) * density;
  }
  /// The density in the middle of each part between knots is its mean there.
  Real layered_depth(Real height_a, Real height_b, Real length) const {
    std::vector<Real> heights{std::min(height_a, height_b), std::max(height_a, height_b)};
    if (!(heights[1] > heights[0])) return density_at(height_a) * length;
    for (const DensityKnot& knot : c_.atmosphere.profile.used()) {
      if (knot.height > heights[0] && knot.height < heights[1]) heights.push_back(knot.height);
    }
    std::sort(heights.begin(), heights.end());
    Real sum = 0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
      sum += (heights[i + 1] - heights[i]) * density_at((heights[i] + heights[i + 1]) / 2);
    }
    return sum / (heights.back() - heights.front()) * length;
  }
  Real phase(Real mu) const {
    const auto [first, second, weight] = c_.atmosphere.phase;
    const auto lobe = [mu](const PhaseLobe& of) {
      const Real g = of.asymmetry, alpha = of.alpha;
      const Real square = 1 + g * g - 2 * g * mu;
      return (1 - g * g) / (square * std::sqrt(square)) * (1 + alpha * mu * mu) / (1 + alpha * (1 + 2 * g * g) / 3);
    };
    return Real(weight) * lobe(first) + (1 - Real(weight)) * lobe(second);
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

double airlight_of(const AirlightCase& c) { return airlight(c.light, c.atmosphere, c.ray, c.lamp_leg); }
double reference_of(const AirlightCase& c) { return reference_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg); }

/// The axial airlight of L or Q > 0 and 0 < density < infinity, by 50 digits.
Digits50 axial_reference(const SolveCase& c) {
  // Nothing happens at the ends: nodes nearer to them than this fraction would be most of its work.
  static boost::math::quadrature::tanh_sinh<Digits50> quadrature(9, Digits50("1e-50"));
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

RC_GTEST_PROP(Airlight, BoundsHoldOfAxialAirlightAtKneesAndExtents, ()) {
  const double constant = *near_one_of({0, 0.5, 1, 2, 19.9}), linear = *near_one_of({0, 1e-6, 0.1, 10});
  const Attenuation a{constant, linear, *near_one_of({0, 1e-9, 0.01, 1})};
  const double threshold = *near_one_of({0.05, 0.5, 1 / std::max(constant, 1.0), 1 - 1e-9});
  RC_PRE(!find_error(a) && !find_threshold_error(threshold) && linear + a.quadratic > 1e-30);
  const double knee = compute_knee(a), extent = compute_extent(a, threshold);
  RC_PRE(extent > 0 && Digits50(constant) * threshold < 1);
  const double density = *near_one_of({1 / std::max(knee, 1e-3), 1 / extent, 30 / extent, 1e-3});
  const SolveCase c{a, {*rc::gen::element(FogMode::exp, FogMode::exp2), density}, threshold};
  RC_LOG() << to_string(c);
  RC_ASSERT(ulp_error(axial_airlight(a, c.fog, threshold), axial_reference(c)) <= kAxialAirlightMaxUlp);
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
  // The plateau alone: a light that ends within an ulp of its knee.
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
          if (i % 2 == 0) c.atmosphere.phase = draw_phase(random);
          const double expected = double(Definition(c).integral());
          // A spot's 1e-13 may be rounding at the edge of a cone; dimmer points than 1e-60 lie beyond the integral's
          // end.
          if (expected < (is_spot ? 1e-13 : 1e-60)) continue;
          error.add(relative_error(reference_of(c), expected), [&] { return to_string(c); });
        }
        error.check();
      }
    }
  }
}

/// A case as the shared text sees it, with its geometry in 50 digits.
template <typename Text>
typename Text::LitfogAirlight seen_exactly(const AirlightCase& c) {
  using Vector = std::array<Digits50, 3>;
  const auto vector = [](const glm::dvec3& v) { return Vector{v.x, v.y, v.z}; };
  const auto dot = [](const Vector& a, const Vector& b) { return Digits50(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]); };
  const Vector ray = vector(c.ray.direction), axis = vector(c.light.direction);
  const Vector position = vector(c.light.position), eye = vector(c.ray.origin);
  Vector to_light, offset;
  for (std::size_t i = 0; i < 3; ++i) to_light[i] = position[i] - eye[i];
  const Digits50 along = dot(to_light, ray) / dot(ray, ray);
  for (std::size_t i = 0; i < 3; ++i) offset[i] = along * ray[i] - to_light[i];
  const Digits50 ray_length = sqrt(dot(ray, ray)), axis_length = sqrt(dot(axis, axis));
  const auto real = [](const Digits50& x) { return x.convert_to<long double>(); };
  const Light& light = c.light.light;
  const long double extent = real(reference_extent(light.attenuation, light.threshold));
  auto air = Text{airlight_text::NoCookie{}}.seen_along(c.light, extent, c.atmosphere.fog, c.ray, c.lamp_leg,
                                                        phase_text::pack<long double>(c.atmosphere.phase));
  air.approach = real(along * ray_length);
  air.offset = real(sqrt(dot(offset, offset)));
  air.axis_offset = real(dot(offset, axis) / axis_length);
  air.axis_slope = real(dot(ray, axis) / (ray_length * axis_length));
  return air;
}

TEST(Airlight, ReferenceHoldsItsErrorForRaysThroughALampAndAlongItsExtent) {
  using Exact = airlight_text::Text<long double, airlight_text::NoCookie>;
  Random random(84);
  WorstError through("reference_airlight", "rays 1e-15 to 1e-9 m from a spot", kReferenceAirlightMaxError, "relative");
  WorstError along("reference_airlight", "rays that graze an extent", 1, "of the stated error");
  for (int i = 0; i < 4000; ++i) {
    AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    const Light& light = c.light.light;
    const double extent = compute_extent(light.attenuation, light.threshold);
    if (!(extent > 0 && extent < 1e5)) continue;
    const bool grazes = i % 2 == 0;
    if (grazes) c.light.light.cone = {};
    const double offset = grazes ? extent * (1 - random.log_uniform(1e-14, 1e-5)) : random.log_uniform(1e-15, 1e-9);
    const double approach = glm::dot(c.light.position - c.ray.origin, c.ray.direction);
    c.light.position = c.ray.origin + approach * c.ray.direction + offset * draw_perpendicular(random, c.ray.direction);
    const auto air = seen_exactly<Exact>(c);
    const double expected = double(airlight_text::integrate_airlight(Exact{airlight_text::NoCookie{}}, air));
    if (expected < 1e-13) continue;
    const double error = relative_error(reference_of(c), expected);
    if (!grazes) through.add(error, [&] { return to_string(c); });
    if (!grazes) continue;
    const double stated =
        std::max(kReferenceAirlightMaxError, kGrazingReferenceAirlightError / double(1 - air.offset / air.extent));
    along.add(error / stated, [&] { return to_string(c); });
  }
  through.check();
  along.check();
}

/// The eye at a light, or anywhere else, looking along -z.
AirlightCase looking(const Attenuation& attenuation, const Fog& fog, LampLeg lamp_leg,
                     const glm::dvec3& light_position = {0, 0, 0}, double length = kInfinity) {
  AirlightCase c;
  c.light.light.attenuation = attenuation;
  c.light.light.threshold = 1e-9;
  c.light.position = light_position;
  c.atmosphere.fog = fog;
  c.ray.length = length;
  c.lamp_leg = lamp_leg;
  return c;
}

TEST(Airlight, ReferenceEndsForARayAlongTheEdgeOfACone) {
  constexpr double kHalfAngle = 0.002491032925258008;  // rounding puts some points of the edge inside, some outside
  PlacedLight lamp;
  lamp.direction = {std::sin(kHalfAngle), 0, -std::cos(kHalfAngle)};
  lamp.light.attenuation = {.constant = 1, .linear = 0, .quadratic = 0.1};
  const Atmosphere air{.fog = {FogMode::exp, 0.1}};
  const EyeRay ray{.origin = {0, 0, -0.01}, .direction = {0, 0, -1}, .length = 1};
  const double most = reference_airlight(lamp, air, ray);
  lamp.light.cone = Cone::cosine(kHalfAngle, 600);
  const double found = reference_airlight(lamp, air, ray);
  EXPECT_TRUE(found >= 0 && found <= most) << found;
}

TEST(Airlight, ReferenceOfConstantAttenuationIsItsClosedForm) {
  for (const double density : {1e-6, 0.01, 3.0, 1e6}) {
    for (const double length : {1e-3, 1.0, 200.0, kInfinity}) {
      for (const FogMode mode : kModes) {
        const Fog fog{mode, density};
        const double doubled = opacity_at({mode, density * (mode == FogMode::exp ? 2 : std::sqrt(2.0))}, length);
        EXPECT_LE(relative_error(reference_of(looking({2, 0, 0}, fog, LampLeg::clear, {5, 7, 9}, length)),
                                 opacity_at(fog, length) / 2),
                  kReferenceAirlightMaxError);
        EXPECT_LE(relative_error(reference_of(looking({0.5, 0, 0}, fog, LampLeg::fogged, {}, length)), doubled / 2),
                  kReferenceAirlightMaxError);
      }
    }
  }
}

TEST(Airlight, ReferenceWithTheEyeAtAnInverseLightIsExponentialIntegrals) {
  using boost::math::expint;
  for (const double q : {1e-4, 0.01, 1.0, 50.0}) {
    for (const double density : {1e-4, 0.02, 0.5, 20.0}) {
      for (const LampLeg leg : kLampLegs) {
        const double legs = leg == LampLeg::fogged ? 2 : 1;
        const auto e = [&](unsigned n, double range) { return expint(n, legs * density * range); };
        const auto plateau = [&](double knee) { return -std::expm1(-legs * density * knee) / legs; };
        const Fog fog{FogMode::exp, density};
        const double knee_2 = compute_knee({0, 0, q}), extent_2 = compute_extent({0, 0, q}, 1e-9);
        EXPECT_LE(relative_error(reference_of(looking({0, 0, q}, fog, leg)),
                                 plateau(knee_2) + density / q * (e(2, knee_2) / knee_2 - e(2, extent_2) / extent_2)),
                  kReferenceAirlightMaxError);
        const double knee_1 = compute_knee({0, q, 0}), extent_1 = compute_extent({0, q, 0}, 1e-9);
        EXPECT_LE(relative_error(reference_of(looking({0, q, 0}, fog, leg)),
                                 plateau(knee_1) + density / q * (e(1, knee_1) - e(1, extent_1))),
                  kReferenceAirlightMaxError);
      }
    }
  }
}

/// The airlight of an inverse-square light 1 / (q r^2) along a ray to a surface, both legs fogged, in the variables of
/// Bo Sun, Ravi Ramamoorthi, Srinivasa Narasimhan and Shree Nayar 2005, "A Practical Analytic Single Scattering Model
/// for Real Time Rendering", equation 9, with the intensity 4 pi / q.
double sun_airlight(double density, double q, double distance, double angle, double length) {
  const double t_sv = density * distance;
  const double a_1 = t_sv * std::sin(angle);
  const double a_0 = 2 * density * density / q * std::exp(-t_sv * std::cos(angle)) / a_1;
  const auto f = [&](double from, double to) {
    return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
        [&](double xi) { return std::exp(-a_1 * std::tan(xi)); }, from, to, 8, 1e-12);
  };
  const double to =
      std::numbers::pi / 4 + std::atan((length - distance * std::cos(angle)) / (distance * std::sin(angle))) / 2;
  return a_0 * f(angle / 2, to);
}

TEST(Airlight, AirlightOfAnInverseSquareLightIsSuns) {
  Random random(64);
  for (int i = 0; i < 300; ++i) {
    const double q = random.log_uniform(1, 1e3);
    const double distance = random.log_uniform(2, 200);
    const double angle = random.uniform(0.55, 3.1 - 1.2 / distance);
    const double density = random.log_uniform(1e-4, 0.1);
    const double length = random.log_uniform(1, 500);
    const glm::dvec3 light = distance * glm::dvec3(std::sin(angle), 0, -std::cos(angle));
    if (angle < 1.57 && light.x < 1) continue;  // the ray must miss the knee
    const AirlightCase c = looking({0, 0, q}, {FogMode::exp, density}, LampLeg::fogged, light, length);
    const double expected = sun_airlight(density, q, distance, angle, length);
    EXPECT_LE(relative_error(reference_of(c), expected), 1e-9) << to_string(c);
    EXPECT_NEAR(airlight_of(c), expected, kAirlightMaxError);
  }
}

/// Errors of the fast form over random rays.
struct FastErrors {
  double worst =
      0;  ///< relative to the lamp's colour, or to the airlight where that is brighter; NaN counts as infinite
  std::string worst_case;
  std::vector<double> relative;  ///< for rays that show more than the dimmest
};

template <typename Draw>
FastErrors find_errors(int rays, double dimmest, const Draw& draw) {
  FastErrors errors;
  for (int i = 0; i < scaled_count(rays); ++i) {
    const AirlightCase c = draw();
    const double expected = reference_of(c);
    const double error = std::abs(airlight_of(c) - expected);
    const double share = error / std::max(expected, 1.0);
    if (!(share <= errors.worst)) {
      errors.worst = std::isnan(share) ? kInfinity : share;
      errors.worst_case = to_string(c);
    }
    if (expected > dimmest) errors.relative.push_back(error / expected);
  }
  std::sort(errors.relative.begin(), errors.relative.end());
  return errors;
}

/// most  of the worst error
void expect_small(const FastErrors& errors, double most_typical, const std::string& what,
                  double most = kAirlightMaxError) {
  ASSERT_GT(errors.relative.size(), 500u);
  const double p99 = errors.relative[errors.relative.size() * 99 / 100];
  std::printf("airlight, %-50s worst %.3f/255, 99th percentile %.2f %% of %zu rays\n", what.c_str(),
              errors.worst / kStep, 100 * p99, errors.relative.size());
  EXPECT_LE(errors.worst, most) << errors.worst_case;
  EXPECT_LE(p99, most_typical) << what;
}

TEST(Airlight, FastFormHasItsStatedErrors) {
  constexpr int kRays = 5000;
  Random random(65);
  for (const FogMode mode : kModes) {
    for (const LampLeg leg : kLampLegs) {
      const std::string what = std::string(name_of(mode)) + (leg == LampLeg::fogged ? ", lamp's leg fogged" : "");
      expect_small(find_errors(kRays, 0, [&] { return draw_airlight_case(random, mode, leg); }), kAirlightTypicalError,
                   what + ", points");
      expect_small(find_errors(kRays, 0, [&] { return draw_inverse_square_airlight_case(random, mode, leg); }),
                   kAirlightTypicalError, what + ", inverse-square points");
      expect_small(find_errors(kRays, kDimAirlight, [&] { return draw_spot_airlight_case(random, mode, leg); }),
                   kAirlightTypicalError, what + ", spots");
    }
  }
}

TEST(Airlight, FastFormHasItsStatedErrorsForPhotometricLamps) {
  constexpr int kRays = 6000;
  Random random(40);
  for (const Phase& phase : {Phase{}, Phase::henyey_greenstein(0.5), Phase::henyey_greenstein(0.95),
                             Phase::droplets(10), Phase::droplets(20)}) {
    for (const FogMode mode : kModes) {
      for (const bool is_spot : {false, true}) {
        char what[128];
        std::snprintf(what, sizeof what, "photometric %s, %s, g = %g, %g", is_spot ? "spots" : "points", name_of(mode),
                      phase.first.asymmetry, phase.second.asymmetry);
        WorstError error("airlight", what, kPhotometricAirlightMaxError, "of the airlight");
        std::vector<double> relative;
        for (int i = 0; i < scaled_count(kRays); ++i) {
          AirlightCase c = draw_photometric_airlight_case(random, mode, random.pick(kLampLegs));
          if (is_spot) turn_into_spot(random, c);
          c.atmosphere.phase = phase;
          const double expected = reference_of(c);
          if (expected * c.light.light.color.r < kDimPhotometricAirlight) continue;
          relative.push_back(relative_error(airlight_of(c), expected));
          error.add(relative.back(), [&] { return to_string(c); });
        }
        error.check();
        ASSERT_GT(relative.size(), 500u);
        std::ranges::sort(relative);
        EXPECT_LE(relative[relative.size() * 99 / 100], kAirlightTypicalError) << what;
      }
    }
  }
}

/// The regions between neighbouring angles, at every distance up to 4 fog scales.
std::vector<LampRegion> regions_between(std::span<const double> angles_deg) {
  constexpr std::array kRanges{0.02, 0.3, 1.0, 2.0, 3.0, 4.0};
  std::vector<LampRegion> regions;
  for (std::size_t i = 0; i + 1 < kRanges.size(); ++i) {
    for (std::size_t j = 0; j + 1 < angles_deg.size(); ++j) {
      regions.push_back({kRanges[i], kRanges[i + 1], angles_deg[j], angles_deg[j + 1]});
    }
  }
  return regions;
}

std::string to_string(const LampRegion& region, FogMode mode, LampLeg leg) {
  char text[128];
  std::snprintf(text, sizeof text, "%s, k = %d, %g to %g fog scales, %g to %g deg", name_of(mode),
                leg == LampLeg::fogged, region.nearest, region.farthest, region.smallest_deg, region.largest_deg);
  return text;
}

TEST(Airlight, FastFormHasItsStatedErrorsForPointsInEveryRegion) {
  constexpr int kRays = 1500;
  Random random(78);
  for (const FogMode mode : kModes) {
    for (const LampLeg leg : kLampLegs) {
      for (const LampRegion& region : regions_between(std::array{0.1, 3.0, 15.0, 45.0, 90.0, 179.0})) {
        expect_small(find_errors(kRays, 1e-12, [&] { return draw_region_airlight_case(random, region, mode, leg); }),
                     kAirlightTypicalError, to_string(region, mode, leg));
      }
    }
  }
}

TEST(Airlight, FastFormHasItsStatedErrorsForSpotsInEveryRegion) {
  constexpr int kRays = 4000;
  Random random(79);
  for (const FogMode mode : kModes) {
    for (const LampLeg leg : kLampLegs) {
      for (const LampRegion& region : regions_between(std::array{0.1, 15.0, 179.0})) {
        const auto draw = [&] {
          AirlightCase c = draw_region_airlight_case(random, region, mode, leg);
          turn_into_spot(random, c);
          return c;
        };
        expect_small(find_errors(kRays, kDimAirlight, draw), kAirlightTypicalError, to_string(region, mode, leg));
      }
    }
  }
}

TEST(Airlight, FastFormHasItsStatedErrorsByEveryPhaseFunction) {
  constexpr int kRays = 2000;
  const std::pair<const char*, Phase> kPhases[]{
      {"g = -0.9", Phase::henyey_greenstein(-0.9)}, {"g = -0.5", Phase::henyey_greenstein(-0.5)},
      {"g = 0.5", Phase::henyey_greenstein(0.5)},   {"g = 0.85", Phase::henyey_greenstein(0.85)},
      {"g = 0.95", Phase::henyey_greenstein(0.95)}, {"g = 0.99", Phase::henyey_greenstein(0.99)},
      {"Rayleigh", {.first = {.alpha = 1}}},        {"forwards and backwards", {{0.9, 1}, {-0.8, 0}, 0.7}},
      {"droplets of 5", Phase::droplets(5)},        {"droplets of 10", Phase::droplets(10)},
      {"droplets of 20", Phase::droplets(20)},      {"droplets of 50", Phase::droplets(50)}};
  Random random(66);
  for (const auto& [name, phase] : kPhases) {
    for (const FogMode mode : kModes) {
      for (const bool is_spot : {false, true}) {
        const auto draw = [&, &of = phase] {
          const LampLeg leg = random.pick(kLampLegs);
          AirlightCase c = is_spot               ? draw_spot_airlight_case(random, mode, leg)
                           : random.chance(0.33) ? draw_inverse_square_airlight_case(random, mode, leg)
                                                 : draw_airlight_case(random, mode, leg);
          c.atmosphere.phase = of;
          return c;
        };
        const std::string what = std::string(name_of(mode)) + (is_spot ? " spots, " : " points, ") + name;
        const bool is_shaped = mode == FogMode::exp && !is_spot;
        expect_small(find_errors(kRays, kDimAirlight, draw), kAirlightTypicalError, what,
                     is_shaped ? kShapedAirlightMaxError : kAirlightMaxError);
      }
    }
  }
}

AirlightCase draw_layered_airlight_case(Random& random, bool is_spot) {
  const LampLeg leg = random.pick(kLampLegs);
  AirlightCase c = random.chance(0.5) ? draw_photometric_airlight_case(random, FogMode::exp, leg)
                                      : draw_airlight_case(random, FogMode::exp, leg);
  if (is_spot) turn_into_spot(random, c);
  if (random.chance(0.5)) c.atmosphere.phase = draw_phase(random);
  draw_layers(random, c);
  return c;
}

TEST(Airlight, ReferenceInLayersIsTheDefinitionByAnotherQuadrature) {
  Random random(95);
  WorstError error("reference_airlight", "in layers of fog", kReferenceAirlightMaxError, "relative");
  for (int i = 0; i < 150; ++i) {
    AirlightCase c = draw_layered_airlight_case(random, i % 3 == 0);
    if (std::isinf(c.ray.length)) c.ray.length = 5000;
    const double expected = double(Definition(c).integral());
    if (expected < 1e-9) continue;
    error.add(relative_error(reference_of(c), expected), [&] { return to_string(c); });
  }
  error.check();
}

TEST(Airlight, FormForPicturesHasItsStatedErrorBesideTheReference) {
  Random random(103);
  for (const bool is_spot : {false, true}) {
    WorstError error("picture_airlight", is_spot ? "spots" : "points", 1, "of the stated error");
    for (int i = 0; i < scaled_count(4000); ++i) {
      const FogMode mode = random.pick(kModes);
      const LampLeg leg = random.pick(kLampLegs);
      AirlightCase c = i % 4 == 0   ? draw_layered_airlight_case(random, is_spot)
                       : i % 4 == 1 ? draw_photometric_airlight_case(random, mode, leg)
                                    : draw_airlight_case(random, mode, leg);
      if (is_spot && i % 4 != 0) turn_into_spot(random, c);
      if (random.chance(0.5)) c.atmosphere.phase = draw_phase(random);
      AirlightCase without_cone = c;
      without_cone.light.light.cone = {};
      const double expected = reference_of(c);
      const double stated = kPictureAirlightMaxError * std::max(expected, 1e-10 * reference_of(without_cone)) +
                            std::numeric_limits<double>::min();  // below which doubles have few digits
      const double found = picture_airlight(c.light, c.atmosphere, c.ray, c.lamp_leg);
      error.add(std::abs(found - expected) / stated, [&] { return to_string(c); });
    }
    error.check();
  }
}

TEST(Airlight, FastFormHasItsStatedErrorsInLayers) {
  Random random(96);
  for (const bool is_spot : {false, true}) {
    expect_small(find_errors(8000, kDimAirlight, [&] { return draw_layered_airlight_case(random, is_spot); }),
                 kAirlightTypicalError, std::string("in layers, ") + (is_spot ? "spots" : "points"),
                 is_spot ? kLayeredAirlightMaxError : kShapedAirlightMaxError);
  }
}

TEST(Airlight, FastFormHasItsStatedErrorsForNearlyLevelRaysInLayers) {
  Random random(101);
  for (const bool is_spot : {false, true}) {
    WorstError error("airlight", is_spot ? "spots, nearly level rays" : "points, nearly level rays",
                     is_spot ? kLayeredAirlightMaxError : kShapedAirlightMaxError, "of the colour");
    for (int i = 0; i < scaled_count(3000); ++i) {
      AirlightCase c = draw_layered_airlight_case(random, is_spot);
      const glm::dvec3 to_light = c.light.position - c.ray.origin;
      const double approach = glm::dot(to_light, c.ray.direction);
      const double offset = glm::length(to_light - approach * c.ray.direction);
      const double rise = (random.chance(0.5) ? 1 : -1) * random.log_uniform(1e-18, 1e-3);
      c.ray.direction = glm::normalize(glm::dvec3(c.ray.direction.x, 0, c.ray.direction.z));
      c.ray.direction = glm::normalize(c.ray.direction + glm::dvec3(0, rise, 0));
      c.light.position =
          c.ray.origin + approach * c.ray.direction + offset * draw_perpendicular(random, c.ray.direction);
      if (random.chance(0.5)) c.ray.length = kInfinity;
      const double expected = reference_of(c);
      error.add(std::abs(airlight_of(c) - expected) / std::max(expected, 1.0), [&] { return to_string(c); });
    }
    error.check();
  }
}

TEST(Airlight, LayerFarAwayShowsItsLampWholeUnlessTheRayIsLevel) {
  AirlightCase c = looking({1, 0, 0}, Fog{FogMode::exp, 0}, LampLeg::clear, {0, -2000, -6000});
  const std::array<DensityKnot, 2> knots{{{-3000, 50}, {-2700, 0}}};
  c.atmosphere.profile = make_density_profile(std::span<const DensityKnot>(knots));
  for (const double rise : {-1e-3, -1e-6, -1e-9, -2 * kLevelRise, -0.5 * kLevelRise, -1e-23}) {
    c.ray.direction = glm::normalize(glm::dvec3(0, rise, -1));
    const double expected = rise < -kLevelRise ? 1 : 0;
    EXPECT_NEAR(airlight_of(c), expected, kLayeredAirlightMaxError) << rise;
    EXPECT_NEAR(reference_of(c), expected, 1e-9) << rise;
  }
}

/// A lamp in a layer or up to a tenth of its depth outside, seen from anywhere: fog all around it is up to 1000 times
/// thinner, so that the lamp's leg through the layer is shortest far from the closest approach.
AirlightCase draw_lamp_in_layer(Random& random, bool is_photometric, LampLeg leg) {
  AirlightCase c = is_photometric ? draw_photometric_airlight_case(random, FogMode::exp, leg)
                                  : draw_airlight_case(random, FogMode::exp, leg);
  const double depth = random.log_uniform(0.1, 10) / c.atmosphere.fog.density;
  const double base = c.light.position.y - depth * random.uniform(-0.1, 1.1);
  const FogLayer layer{.base = base,
                       .top = base + depth,
                       .transition = random.chance(0.5) ? 0 : depth * random.log_uniform(0.01, 1),
                       .visibility = -std::log(kContrastMor) / c.atmosphere.fog.density};
  c.atmosphere.profile = make_density_profile(std::span<const FogLayer>(&layer, 1));
  c.atmosphere.fog.density *= random.chance(0.5) ? 0 : random.log_uniform(1e-3, 0.1);
  return c;
}

TEST(Airlight, FastFormHasItsStatedErrorsForLampsInLayers) {
  Random random(98);
  for (const ConeProfileFacts& facts : kConeProfiles) {
    const bool is_point = facts.first == Cone{};
    for (const bool is_isotropic : {false, true}) {
      const double bound = is_point && !is_isotropic ? kShapedAirlightMaxError : kLayeredAirlightMaxError;
      WorstError error("airlight", std::string(facts.name) + (is_isotropic ? " in isotropic layers" : " in layers"),
                       bound, "of the colour");
      for (int i = 0; i < scaled_count(3000); ++i) {
        AirlightCase c = draw_lamp_in_layer(random, random.chance(0.3), random.pick(kLampLegs));
        turn_into_spot(random, c);
        if (is_point || random.chance(0.5)) c.light.light.cone = facts.first;
        if (c.light.light.cone.profile != facts.first.profile) continue;
        if (!is_isotropic) c.atmosphere.phase = draw_phase(random);
        const double expected = reference_of(c);
        error.add(std::abs(airlight_of(c) - expected) / std::max(expected, 1.0), [&] { return to_string(c); });
      }
      error.check();
    }
  }
}

TEST(Airlight, FastFormHasItsStatedErrorsForPhotometricLampsInLayers) {
  Random random(99);
  for (const bool is_spot : {false, true}) {
    WorstError error("airlight", is_spot ? "photometric spots in layers" : "photometric points in layers",
                     kPhotometricAirlightMaxError, "of the airlight");
    for (int i = 0; i < scaled_count(6000); ++i) {
      AirlightCase c = draw_lamp_in_layer(random, true, LampLeg::fogged);
      if (is_spot) turn_into_spot(random, c);
      if (random.chance(0.7)) {
        c.atmosphere.phase = Phase::droplets(random.log_uniform(kSmallestDroplets, kLargestDroplets));
      }
      const double expected = reference_of(c);
      if (expected * c.light.light.color.r < kDimPhotometricAirlight) continue;
      error.add(relative_error(airlight_of(c), expected), [&] { return to_string(c); });
    }
    error.check();
  }
}

TEST(Airlight, LongerRayOverGroundFogIsNoDarker) {
  Random random(101);
  for (int i = 0; i < 3000; ++i) {
    // From above 5 m of ground fog past a lamp in it to the ground and beyond, through haze.
    const double eye = random.log_uniform(6, 100), distance = random.log_uniform(100, 3000);
    AirlightCase c = looking({0, 0, 1600}, Fog{FogMode::exp, 1.4e-4}, LampLeg::fogged,
                             {random.uniform(-30, 30), random.uniform(3, 5), -distance});
    c.light.light.threshold = 1e-11;
    c.atmosphere.phase = random.chance(0.5) ? Phase{} : Phase::droplets(20);
    const std::array<DensityKnot, 2> knots{{{5, random.log_uniform(0.003, 0.1)}, {5.01, 0}}};
    c.atmosphere.profile = make_density_profile(std::span<const DensityKnot>(knots));
    c.ray.origin = {0, eye, 0};
    const double end = distance * random.uniform(0.3, 1.5);
    c.ray.direction = glm::normalize(glm::dvec3(random.uniform(-3, 3), -eye, -end));
    double before = 0;
    for (const double part : {0.1, 0.5, 0.9, 0.96, 1.0, 1.1, 2.0, 10.0, kInfinity}) {
      c.ray.length = part * std::hypot(end, eye);
      const double value = airlight_of(c);
      ASSERT_GE(value, before * (1 - 2 * kPhotometricAirlightMaxError)) << part << ": " << to_string(c);
      before = value;
    }
    ASSERT_LE(relative_error(before, reference_of(c)), kPhotometricAirlightMaxError) << to_string(c);
  }
}

TEST(Airlight, LayersOfAnyDensityHaveAnAirlight) {
  for (const double density : {1e19, 1e21, 1e155, 1e300}) {
    AirlightCase c = looking({0, 0, 1}, Fog{FogMode::exp, 0}, LampLeg::fogged, {0, 0.5, -5});
    const std::array<DensityKnot, 2> knots{{{0, density}, {1, density}}};
    c.atmosphere.profile = make_density_profile(std::span<const DensityKnot>(knots));
    for (const double eye : {0.5, 3.0}) {
      c.ray.origin = {0, eye, 0};
      for (const double rise : {1e-9, 0.0, -0.5}) {
        c.ray.direction = glm::normalize(glm::dvec3(0, rise, -1));
        const double value = airlight_of(c);
        EXPECT_TRUE(value >= 0 && value < 1e-6) << value << " in " << density;
      }
    }
  }
}

TEST(Airlight, AirlightWhereEyeLampAndEndAreAtKnotsIsThatBesideThem) {
  const std::array<DensityKnot, 4> knots{{{-3, 0.02}, {0, 0.3}, {2, 0}, {5, 0.1}}};
  Random random(97);
  for (int i = 0; i < 2000; ++i) {
    AirlightCase c = looking({1, 0, 0.1}, Fog{FogMode::exp, random.pick(std::array{0.0, 0.01})}, LampLeg::fogged,
                             {random.uniform(-3, 3), random.pick(knots).height, -4});
    c.atmosphere.profile = make_density_profile(std::span<const DensityKnot>(knots));
    c.ray.origin.y = random.pick(knots).height;
    const glm::dvec3 end{random.uniform(-2, 2), random.pick(knots).height, -9};
    c.ray.direction = glm::normalize(end - c.ray.origin);
    c.ray.length = glm::distance(end, c.ray.origin);
    const double value = airlight_of(c);
    AirlightCase beside = c;
    beside.ray.origin.y = std::nextafter(c.ray.origin.y, random.chance(0.5) ? -9 : 9);
    beside.light.position.y = std::nextafter(c.light.position.y, random.chance(0.5) ? -9 : 9);
    ASSERT_TRUE(std::isfinite(value)) << to_string(c);
    ASSERT_NEAR(airlight_of(beside), value, 1e-7 * std::max(value, 1e-3)) << to_string(c);
    ASSERT_NEAR(value, reference_of(c), 0.01 * value) << to_string(c);
  }
}

TEST(Airlight, FastFormHasItsStatedErrorForEveryProfile) {
  Random random(73);
  for (const ConeProfileFacts& facts : kConeProfiles) {
    WorstError error("airlight", facts.name, kAirlightMaxError, "of the colour");
    for (int i = 0; i < scaled_count(500); ++i) {
      AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
      c.light.light.cone = facts.first;
      error.add(std::abs(airlight_of(c) - reference_of(c)), [&] { return to_string(c); });
    }
    error.check();
  }
}

TEST(Airlight, FastFormHasItsStatedErrorWhereRaysMeetLampsByCoincidence) {
  constexpr int kRays = 20000;
  Random random(83);
  int rays = 0;
  for (int i = 0; i < scaled_count(kRays); ++i) {
    const AirlightCase c = draw_coincident_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    if (runs_along_edge(c)) continue;
    ++rays;
    const double expected = reference_of(c);
    ASSERT_NEAR(airlight_of(c), expected, kAirlightMaxError * std::max(expected, 1.0)) << to_string(c);
  }
  EXPECT_GT(rays, kRays * 9 / 10);
}

TEST(Airlight, BeamIsSeenFromAnEyeOnItsCone) {
  // A cone of 45 degrees, 2 m up and 2 m ahead, shines down: the eye lies on it, and looks along its axis.
  AirlightCase c = looking({1, 0, 0.05}, Fog::from_visibility(FogMode::exp, 30), LampLeg::fogged, {0, 2, -2});
  c.light.light.cone = Cone::smoothstep(0, std::numbers::pi / 4);
  c.light.direction = {0, -1, 0};
  EXPECT_GT(airlight_of(c), 0.03);
  EXPECT_NEAR(airlight_of(c), reference_of(c), kAirlightMaxError);
}

TEST(Airlight, AirlightIsNoMoreThanTheFogTakesFromTheRay) {
  AirlightCase c = looking({1, 0, 0}, {FogMode::exp2, 0x1.a6f66b263ff03p-2}, LampLeg::clear,
                           {26.317985430029484 - 12.724058667137239, -57.537597905887424 + 56.712276006525862,
                            82.651173563558103 - 81.374541972258612},
                           18.727117651244203);
  c.light.light.threshold = 0x1.025640112fed4p-15;
  c.ray.direction = {0.99771345359071451, -0.0042314154265179231, 0.067453388703440753};
  EXPECT_LE(airlight_of(c), 1);
}

TEST(Airlight, AirlightIsBelowTheOpacityAndRisesWithTheLength) {
  Random random(67);
  for (int i = 0; i < 2000; ++i) {
    AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    c.ray.length = random.log_uniform(0.1, 1000);
    const double reference = reference_of(c);
    ASSERT_LE(reference, opacity_at(c.atmosphere.fog, c.ray.length) * (1 + kReferenceAirlightMaxError)) << to_string(c);
    ASSERT_LE(airlight_of(c), opacity_at(c.atmosphere.fog, c.ray.length) + kAirlightMaxError) << to_string(c);
    c.ray.length *= 1.5;
    ASSERT_GE(reference_of(c), reference * (1 - kReferenceAirlightMaxError) - 1e-19) << to_string(c);
  }
}

TEST(Airlight, AxialAirlightIsThatOfTheEyeAtTheLight) {
  Random random(68);
  for (int i = 0; i < 300; ++i) {
    const SolveCase solve = draw_ordinary_case(random, random.pick(kModes));
    AirlightCase c = looking(solve.attenuation, solve.fog, LampLeg::clear);
    c.light.light.threshold = solve.threshold;
    c.light.light.cone = Cone::cosine(0.5, 20);
    const double axial = axial_airlight(solve.attenuation, solve.fog, solve.threshold);
    EXPECT_LE(relative_error(reference_of(c), axial), kReferenceAirlightMaxError) << to_string(c);
    EXPECT_NEAR(airlight_of(c), axial, kAirlightMaxError) << to_string(c);
  }
}

TEST(Airlight, ErrorOfTheFastFormHasNoSeams) {
  constexpr double kSeam = 0.75 * kStep;
  // Where the closest approach passes the eye, 1.04 steps over 20,000 lamps: one that never falls off, in exp2 fog
  // without the lamp's leg. At g = 0, 0.84.
  constexpr double kWideSeam = 1.1 * kStep;
  Random random(69);
  const auto error_of_fast = [](const AirlightCase& c) { return airlight_of(c) - reference_of(c); };
  for (int i = 0; i < 2000; ++i) {
    AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    if (i % 2 == 0) c.light.light.cone = {};
    const Light& light = c.light.light;
    const double extent = compute_extent(light.attenuation, light.threshold);
    const double knee = compute_knee(light.attenuation);
    const glm::dvec3 side = draw_perpendicular(random, c.ray.direction);
    const double approach = glm::dot(c.light.position - c.ray.origin, c.ray.direction);
    const auto at = [&](double along, double offset) {
      AirlightCase moved = c;
      moved.light.position = c.ray.origin + along * c.ray.direction + offset * side;
      return error_of_fast(moved);
    };
    const double offset = random.log_uniform(1e-3, 1) * std::min(extent, 1e5);
    for (const double split : {extent, knee}) {
      if (!(split > 0 && split < 1e5)) continue;
      ASSERT_NEAR(at(approach, split * (1 - 1e-9)), at(approach, split * (1 + 1e-9)), kSeam) << to_string(c);
    }
    ASSERT_NEAR(at(-1e-9 * offset, offset), at(1e-9 * offset, offset), kWideSeam) << to_string(c);
    for (const double length : {approach, approach + knee, approach + extent}) {
      if (!(length > 0 && length < 1e5)) continue;
      AirlightCase shorter = c, longer = c;
      shorter.ray.length = length * (1 - 1e-9);
      longer.ray.length = length * (1 + 1e-9);
      ASSERT_NEAR(error_of_fast(shorter), error_of_fast(longer), kSeam) << to_string(c);
    }
    AirlightCase uneven = c;
    uneven.atmosphere.phase.first.asymmetry = random.pick(std::array{-1e-9, 1e-9});
    ASSERT_NEAR(error_of_fast(uneven), error_of_fast(c), kWideSeam) << to_string(c);
    AirlightCase with_knee = c, without_knee = c;
    with_knee.light.light.attenuation.constant = 1 - 1e-9;
    without_knee.light.light.attenuation.constant = 1;
    ASSERT_NEAR(error_of_fast(with_knee), error_of_fast(without_knee), kSeam) << to_string(c);
    AirlightCase narrow = c, wide = c;
    narrow.light.light.cone = Cone::smoothstep(0.5, std::numbers::pi / 2 * (1 - 1e-9));
    wide.light.light.cone = Cone::smoothstep(0.5, std::numbers::pi / 2 * (1 + 1e-9));
    ASSERT_NEAR(error_of_fast(narrow), error_of_fast(wide), kSeam) << to_string(c);
    if (light.cone.profile == ConeProfile::none) continue;
    for (const double tilt : {-1e-9, 1e-9}) {  // the edge of the cone at the closest approach
      const double angle = cutoff_angle(light.cone) * (1 + tilt);
      AirlightCase turned = c;
      turned.light.position = c.ray.origin + approach * c.ray.direction - offset * side;
      turned.light.direction = std::cos(angle) * side + std::sin(angle) * glm::cross(side, c.ray.direction);
      ASSERT_LE(std::abs(error_of_fast(turned)), kSeam) << to_string(turned);
    }
  }
}

TEST(Airlight, LightSeesTheFogThroughItsDensityScale) {
  Random random(75);
  for (int i = 0; i < 50; ++i) {
    AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    c.light.light.density_scale = random.pick(std::array{0.0, 0.4, 2.5});
    AirlightCase seen = c;
    seen.light.light.density_scale = 1;
    seen.atmosphere.fog.density = c.atmosphere.fog.density * c.light.light.density_scale;
    EXPECT_EQ(airlight_of(c), airlight_of(seen)) << to_string(c);
    EXPECT_EQ(reference_of(c), reference_of(seen)) << to_string(c);
    const auto bound = [](const AirlightCase& of) {
      return bound_airlight(of.light, of.atmosphere, of.ray.origin, of.ray.direction, 0.1, of.lamp_leg);
    };
    EXPECT_EQ(bound(c), bound(seen)) << to_string(c);
    EXPECT_EQ(light_reach(c.light.light, c.atmosphere.fog, 0.01),
              light_reach(seen.light.light, seen.atmosphere.fog, 0.01))
        << to_string(c);
  }
}

TEST(Airlight, TotalFogScattersInTheEyeAlone) {
  for (const FogMode mode : kModes) {
    const Fog total{mode, kInfinity};
    AirlightCase c = looking({1, 0, 0.25}, total, LampLeg::clear, {0, 0, -2});
    c.light.direction = {0, 0, 1};
    c.light.light.cone = Cone::cosine(0.5, 3);
    EXPECT_EQ(airlight_of(c), 0.5);
    EXPECT_EQ(reference_of(c), 0.5);
    c.atmosphere.phase.first.asymmetry = 0.5;  // straight ahead (1 + g) / (1 - g)^2
    EXPECT_DOUBLE_EQ(airlight_of(c), 0.5 * 6);
    c.light.direction = {1, 0, 0};
    EXPECT_EQ(airlight_of(c), 0);
    c.light.direction = {0, 0, 1};
    c.lamp_leg = LampLeg::fogged;
    EXPECT_EQ(airlight_of(c), 0);
    c = looking({4, 0, 0.25}, total, LampLeg::fogged);  // the eye at the light
    EXPECT_EQ(airlight_of(c), 0.125);                   // the limit: the integral of -f' f is 1/2
    c.ray.length = 0;
    EXPECT_EQ(airlight_of(c), 0);
  }
}

TEST(Airlight, ClearAirOrARayWithoutLengthHasNoAirlight) {
  for (const FogMode mode : kModes) {
    for (const LampLeg leg : kLampLegs) {
      EXPECT_EQ(airlight_of(looking({1, 0, 0.25}, {mode, 0}, leg, {1, 0, -2})), 0);
      EXPECT_EQ(reference_of(looking({1, 0, 0.25}, {mode, 0}, leg, {1, 0, -2})), 0);
      EXPECT_EQ(airlight_of(looking({1, 0, 0.25}, {mode, 0.1}, leg, {1, 0, -2}, 0)), 0);
      EXPECT_EQ(reference_of(looking({1, 0, 0.25}, {mode, 0.1}, leg, {1, 0, -2}, 0)), 0);
    }
  }
}

TEST(AirlightBound, BoundIsNeverBelowTheAirlightOfARayInItsCone) {
  Random random(72);
  int dark = 0;
  for (int i = 0; i < scaled_count(20000); ++i) {
    AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    if (random.chance(0.5)) c.light.light.cone = {};
    if (random.chance(0.3)) c.atmosphere.phase = draw_phase(random);
    if (c.atmosphere.fog.mode == FogMode::exp && random.chance(0.3)) draw_layers(random, c);
    if (random.chance(0.3)) {  // far from the origin, where positions are rounded
      const glm::dvec3 offset = random.log_uniform(1e3, 1.6e7) * draw_direction(random);
      c.ray.origin += offset;
      c.light.position += offset;
      if (find_error(c.light) || find_error(c.ray)) continue;
    }
    const double half_angle = random.chance(0.1) ? std::numbers::pi : random.log_uniform(1e-6, 3);
    const double tilt =
        half_angle * (random.chance(0.5) ? 1 - 1e-9 : random.uniform(0, 1));  // angle of the ray from the axis
    const glm::dvec3 axis =
        glm::normalize(std::cos(tilt) * c.ray.direction + std::sin(tilt) * draw_perpendicular(random, c.ray.direction));
    const double bound = bound_airlight(c.light, c.atmosphere, c.ray.origin, axis, half_angle, c.lamp_leg);
    ASSERT_GE(bound, reference_of(c)) << "half angle " << half_angle << ", tilt " << tilt << ", " << to_string(c);
    if (bound < kStep / 2) ++dark;
  }
  std::printf("airlight bound: %d of 20000 cones of rays are found to show less than 0.5/255\n", dark);
  EXPECT_GT(dark, 1000);
}

TEST(AirlightBound, BoundOnAStretchOfARayIsNeverBelowItsAirlight) {
  constexpr double kLeftOut = 0.02;     // fraction of the airlight, where the stretch ends in the fog
  constexpr double kAllLeftOut = 1e-6;  // airlight of which the fog leaves so little that the stretch may be empty
  airlight_text::Text<double, airlight_text::NoCookie> text{airlight_text::NoCookie{}};
  Random random(80);
  std::vector<double> loose;  // bounds over airlights
  for (int i = 0; i < scaled_count(40000); ++i) {
    AirlightCase c = draw_spot_airlight_case(random, random.pick(kModes), random.pick(kLampLegs));
    if (random.chance(0.3)) c.light.light.cone = {};
    const Light& light = c.light.light;
    const auto air = text.seen_along(c.light, compute_extent(light.attenuation, light.threshold), c.atmosphere.fog,
                                     c.ray, c.lamp_leg, phase_text::pack<double>(c.atmosphere.phase));
    const double bound = text.litfog_airlight_bound(air, text.litfog_airlight_stretch(air));
    const double airlight = reference_of(c);
    ASSERT_GE(bound, (1 - kLeftOut) * airlight - kAllLeftOut) << to_string(c);
    if (airlight > kDimAirlight) loose.push_back(bound / airlight);
  }
  ASSERT_GT(loose.size(), 5000u);
  std::ranges::sort(loose);
  const double median = loose[loose.size() / 2];
  std::printf("airlight bound on a stretch: %.4f to %.1f times the airlight, median %.2f\n", loose.front(),
              loose.back(), median);
  EXPECT_LE(median, 4);
}

TEST(AirlightBound, BoundOnAWholeRayIsNeverBelowItsAirlight) {
  Random random(81);
  int dark = 0;
  for (int i = 0; i < scaled_count(20000); ++i) {
    const AirlightCase c = draw_airlight_case(random, random.pick(kModes), LampLeg::fogged);
    const Light& light = c.light.light;
    const auto [constant, linear, quadratic] = light.attenuation;
    const glm::dvec3 to_light = c.light.position - c.ray.origin;
    const double eye_range = glm::length(to_light);
    const Fog& fog = c.atmosphere.fog;
    const double weight = formulas::litfog_largest_fog_weight(
        double(fog.mode), fog.density, fog.density * 2 * eye_range / 3, fog.density * eye_range / 3);
    const double offset = glm::length(glm::cross(to_light, c.ray.direction)) * (1 - 1e-12);
    const double bound =
        formulas::litfog_largest_airlight(weight, formulas::denominator(offset, constant, linear, quadratic), quadratic,
                                          2 * compute_extent(light.attenuation, light.threshold));
    ASSERT_GE(bound, reference_of(c) * (1 - 1e-9)) << to_string(c);
    dark += bound < kStep / 2;
  }
  EXPECT_GT(dark, 1000);
}

/// The bound of the airlight along the ray of a case alone.
double bound_of_ray(const AirlightCase& c) {
  return bound_airlight(c.light, c.atmosphere, c.ray.origin, c.ray.direction, 0, c.lamp_leg);
}

TEST(AirlightBound, BoundHoldsToTheLastDigitWhereTheAirlightReachesIt) {
  Random random(76);
  for (int i = 0; i < 2000; ++i) {  // the eye at an endless light: A = p / C
    AirlightCase c = looking({random.uniform(1, 5), 0, 0}, {random.pick(kModes), 0.01}, LampLeg::clear);
    c.atmosphere.phase.first.asymmetry = -random.uniform(0, 0.9);
    const double airlight = largest_phase(c.atmosphere.phase) / c.light.light.attenuation.constant;
    ASSERT_GE(bound_of_ray(c), std::max(airlight, reference_of(c))) << to_string(c);
    ASSERT_LE(bound_of_ray(c), airlight * (1 + 1e-10)) << to_string(c);
  }
}

/// A ball of light, nearly as bright at its edge, 0.7 m from its middle, straight ahead.
AirlightCase ball_of_light(const Fog& fog, double distance) {
  AirlightCase c = looking({2.5, 0, 1e-6}, fog, LampLeg::clear, {0, 0, -distance});
  c.light.light.threshold = 1 / (2.5 + 0.49e-6);
  return c;
}

TEST(AirlightBound, BoundOfASmallLightIsNearItsAirlight) {
  for (const double density : {0.001, 0.01}) {
    const AirlightCase exp = ball_of_light({FogMode::exp, density}, 50);
    EXPECT_GE(bound_of_ray(exp), reference_of(exp));
    EXPECT_LE(bound_of_ray(exp), reference_of(exp) * (1 + 1e-4));
    const AirlightCase exp2 = ball_of_light({FogMode::exp2, density}, std::sqrt(0.5) / density);  // f is steepest there
    EXPECT_GE(bound_of_ray(exp2), reference_of(exp2));
    EXPECT_LE(bound_of_ray(exp2), reference_of(exp2) * (1 + 1e-3));
  }
}

TEST(AirlightBound, BoundOfARayThatGrazesALightIsAboveItsAirlight) {
  AirlightCase c = ball_of_light({FogMode::exp, 0.01}, 50);
  c.light.position.x = compute_extent(c.light.light.attenuation, c.light.light.threshold) * (1 - 1e-10);
  EXPECT_GT(reference_of(c), 0);
  EXPECT_GE(bound_of_ray(c), reference_of(c));
}

TEST(AirlightBound, BoundIsZeroInClearAirAndAboveZeroWhereItsProductsRoundToZero) {
  EXPECT_EQ(bound_of_ray(ball_of_light({FogMode::exp, 0}, 50)), 0);
  const AirlightCase faint = ball_of_light({FogMode::exp, kDenormMin}, 50);
  EXPECT_EQ(reference_of(faint), kDenormMin);  // 0.56 of it, rounded
  EXPECT_GE(bound_of_ray(faint), kDenormMin);
}

TEST(AirlightBound, WrongHalfAngleIsAnError) {
  EXPECT_EQ(error_of([] { bound_airlight({}, {}, {}, {0, 0, -1}, -1); }), "half_angle = -1: must be in [0, pi]");
}

TEST(LightReach, NothingBeyondTheReachShowsTheBudget) {
  Random random(73);
  for (int i = 0; i < scaled_count(20000); ++i) {
    const AirlightCase c = draw_airlight_case(random, random.pick(kModes), LampLeg::fogged);
    const Light& light = c.light.light;
    const LampLeg leg = random.pick(kLampLegs);
    const double budget = random.log_uniform(1e-8, 0.999);
    const double reach = light_reach(light, c.atmosphere.fog, budget, leg);
    const double extent = compute_extent(light.attenuation, light.threshold);
    const auto shown_at = [&](double range) {
      return range > extent ? 0
                            : attenuation_at(light.attenuation, range) *
                                  (leg == LampLeg::fogged ? fog_factor_at(c.atmosphere.fog, range) : 1);
    };
    ASSERT_LE(reach, extent);
    if (std::isinf(reach)) continue;
    if (reach == 0) {
      ASSERT_LT(shown_at(0), budget) << to_string(c);
      continue;
    }
    for (const double factor : {1 + 1e-14, 1.01, 2.0, 1000.0})
      ASSERT_LT(shown_at(reach * factor), budget) << to_string(c);
    ASSERT_GE(shown_at(reach * (1 - 1e-9)), budget) << to_string(c);  // nor is it longer than need be
  }
}

TEST(LightReach, LightsBeyondTheirReachesAddLessThanTheStep) {
  Random random(74);
  int cut = 0;
  double largest = 0;
  for (int i = 0; i < 3000; ++i) {
    AirlightCase c = draw_airlight_case(random, random.pick(kModes), LampLeg::fogged);
    const double step = random.log_uniform(1e-4, 0.1);
    const double brightness = random.log_uniform(0.1, 1e5);
    const auto lights = std::size_t(random.log_uniform(1, 1e4));
    const double budget = reach_budget(step, lights, brightness, c.atmosphere);
    const double reach = light_reach(c.light.light, c.atmosphere.fog, budget, c.lamp_leg);
    const double whole = reference_of(c);
    const double at_end = glm::distance(c.ray.origin + c.ray.length * c.ray.direction, c.light.position);
    double surface = 0;
    if (at_end > reach && at_end <= compute_extent(c.light.light.attenuation, c.light.light.threshold)) {
      surface = attenuation_at(c.light.light.attenuation, at_end) * fog_factor_at(c.atmosphere.fog, at_end);
    }
    AirlightCase near = c;
    near.light.light.threshold = attenuation_at(c.light.light.attenuation, reach);
    if (!(near.light.light.threshold > 0 && near.light.light.threshold < 1)) continue;
    const double cut_at = compute_extent(near.light.light.attenuation, near.light.light.threshold);
    if (!(cut_at <= reach * (1 + 1e-9) && cut_at >= reach * (1 - 1e-9))) continue;
    const double beyond = whole - reference_of(near);
    cut += beyond > 1e-9 * whole || surface > 0;
    const double added =
        double(lights) * brightness * (airlight_unit(c.atmosphere) * (beyond - 2e-10 * whole) + surface);
    largest = std::max(largest, added / step);
    ASSERT_LT(added, step) << to_string(c);
  }
  std::printf("%d lights cut, up to %.2g of the step added\n", cut, largest);
  EXPECT_GT(cut, 20);
}

TEST(LightReach, BudgetHasItsLimits) {
  EXPECT_EQ(reach_budget(0.1, 0, 1, {}), 0.5);
  EXPECT_EQ(reach_budget(0.1, 1, 0, {}), 0.5);
  EXPECT_EQ(reach_budget(0.1, 1, 1, {}), 0.08) << "a quarter for isotropic fog";
  EXPECT_EQ(error_of([] { reach_budget(0, 1, 1, {}); }), "step = 0: must be finite and > 0");
  EXPECT_EQ(error_of([] { reach_budget(1, 1, -1, {}); }), "brightness = -1: must be finite and >= 0");
  EXPECT_EQ(error_of([] { reach_budget(1, 1, 1, {.albedo = 2}); }), "albedo = 2: must be in [0, 1]");
}

TEST(LightReach, ReachHasItsLimits) {
  Light light;
  light.attenuation = {1, 0, 0};
  EXPECT_EQ(light_reach(light, {FogMode::exp, 0}, 0.01), kInfinity);
  EXPECT_EQ(light_reach(light, {FogMode::exp, 1}, 0.01, LampLeg::clear), kInfinity);
  EXPECT_NEAR(light_reach(light, {FogMode::exp, 0.1}, std::exp(-3.0)), 30, 1e-7);
  light.attenuation = {4, 0, 0};
  EXPECT_EQ(light_reach(light, {FogMode::exp, 0.1}, 0.5), 0);
  EXPECT_EQ(error_of([&] { light_reach(light, {}, 1); }), "budget = 1: must be in (0, 1)");
}

TEST(LightReach, ReachBeyondAllDoublesIsInfinite) {
  Light light;
  light.attenuation = {1, 0, 0};
  for (const FogMode mode : kModes) {
    EXPECT_EQ(light_reach(light, {mode, kDenormMin}, 0.01), kInfinity);
    EXPECT_EQ(light_reach(light, {mode, 1e-309}, 1e-9), kInfinity);
    const double reach = light_reach(light, {mode, 1e-300}, 0.01);
    EXPECT_LE(fog_factor_at({mode, 1e-300}, reach), 0.01);
    EXPECT_GE(fog_factor_at({mode, 1e-300}, reach), 0.01 * (1 - 1e-8));
  }
}

TEST(LightReach, SearchEndsWhereTheReachIsNextToNothing) {
  Light light;
  light.attenuation = {0, 1e308, 1e308};  // shows in its own position alone
  EXPECT_LE(light_reach(light, {FogMode::exp, kInfinity}, 0.01), 1e-307);
}

TEST(Airlight, AirlightAlongManyRaysIsThatAlongEach) {
  Random random(71);
  const AirlightCase c = draw_spot_airlight_case(random, FogMode::exp, LampLeg::fogged);
  std::vector<EyeRay> rays(7, c.ray);
  for (EyeRay& ray : rays) ray.direction = draw_direction(random);
  std::vector<double> airlights(rays.size());
  airlight(c.light, c.atmosphere, rays, c.lamp_leg, airlights);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_EQ(airlights[i], airlight(c.light, c.atmosphere, rays[i], c.lamp_leg));
  }
  rays.back().length = kNan;
  EXPECT_EQ(error_of([&] { airlight(c.light, c.atmosphere, rays, c.lamp_leg, airlights); }),
            "rays[" + std::to_string(rays.size() - 1) + "].length = nan: must be >= 0");
}

TEST(Airlight, WrongArgumentsAreErrors) {
  AirlightCase c;
  const auto error = [&] { return error_of([&] { airlight_of(c); }); };
  c.atmosphere.phase.first.asymmetry = 1;
  EXPECT_EQ(error(), "asymmetry = 1: must be in (-1, 1)");
  c.atmosphere.phase.first.asymmetry = kNan;
  EXPECT_EQ(error(), "asymmetry = nan: must be in (-1, 1)");
  c = {};
  c.ray.length = -1;
  EXPECT_EQ(error(), "length = -1: must be >= 0");
  c = {};
  c.ray.direction = {0, 0, 2};
  EXPECT_EQ(error(), "direction = 2: length must be 1 within 1e-6");
  c = {};
  c.ray.origin.y = 1e9;
  EXPECT_EQ(error(), "origin.y = 1e+09: must be at most 16777216 in magnitude");
  c = {};
  c.atmosphere.fog.density = -1;
  EXPECT_EQ(error(), "fog.density = -1: must be >= 0");
  EXPECT_EQ(error_of([&] { reference_of(c); }), "fog.density = -1: must be >= 0");
}

}  // namespace
}  // namespace litfog::test
