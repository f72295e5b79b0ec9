// SPDX-License-Identifier: Apache-2.0
#include "litfog/formulas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/fog.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace foreign {

/// A value with its derivative: a scalar type that litfog has never heard of, as ceres::Jet is one.
struct Dual {
  explicit Dual(double v, double d = 0) : value(v), derivative(d) {}
  double value;
  double derivative;
};

Dual operator-(const Dual& a) { return Dual(-a.value, -a.derivative); }
Dual operator+(const Dual& a, const Dual& b) { return Dual(a.value + b.value, a.derivative + b.derivative); }
Dual operator-(const Dual& a, const Dual& b) { return Dual(a.value - b.value, a.derivative - b.derivative); }
Dual operator*(const Dual& a, const Dual& b) {
  return Dual(a.value * b.value, a.derivative * b.value + a.value * b.derivative);
}
Dual operator/(const Dual& a, const Dual& b) {
  const double quotient = a.value / b.value;
  return Dual(quotient, (a.derivative - quotient * b.derivative) / b.value);
}
bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
Dual expm1(const Dual& a) { return Dual(std::expm1(a.value), std::exp(a.value) * a.derivative); }
Dual pow(const Dual& a, const Dual& b) {
  const double power = std::pow(a.value, b.value);
  return Dual(power, power * (b.derivative * std::log(a.value) + b.value * a.derivative / a.value));
}

}  // namespace foreign

namespace litfog::test {
namespace {

using foreign::Dual;

TEST(Formulas, FormulasInDoubleAreTheLibrarysFunctions) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double range = random.log_uniform(1e-3, 1e5);
    const Attenuation a{random.log_uniform(1e-3, 10), random.log_uniform(1e-6, 10), random.log_uniform(1e-9, 10)};
    EXPECT_EQ(formulas::attenuation(range, a.constant, a.linear, a.quadratic), attenuation_at(a, range));
    const double density = random.log_uniform(1e-6, 1);
    EXPECT_EQ(formulas::opacity(formulas::depth_exp(range, density)), opacity_at({FogMode::exp, density}, range));
    EXPECT_EQ(formulas::opacity(formulas::depth_exp2(range, density)), opacity_at({FogMode::exp2, density}, range));
    const Cone dual = Cone::smoothstep(random.uniform(0, 0.5), random.uniform(0.5, 3));
    const Cone hard = Cone::cosine(random.uniform(0.01, 1.5), random.log_uniform(1e-2, 100));
    const double cos_angle = random.uniform(-1, 1);
    EXPECT_EQ(formulas::smoothstep_cone(cos_angle, std::cos(dual.inner), std::cos(dual.outer)),
              cone_at(dual, cos_angle));
    EXPECT_EQ(formulas::cosine_cone(cos_angle, std::cos(hard.half_angle), hard.exponent), cone_at(hard, cos_angle));
  }
}

// The bounds are the count of roundings, each half an ulp, which a result low in its binade sees twice as large.
TEST(Formulas, FormulasInFloatAreRightToTheirRoundings) {
  WorstError attenuation_error("formulas::attenuation, float", "r 1e-3..1e5, C 1e-3..10", kAttenuationMaxUlp);
  WorstError exp_error("formulas::opacity, float", "exp, d 1e-6..1, r 1e-3..1e5", 3);
  WorstError exp2_error("formulas::opacity, float", "exp2, d 1e-6..1, r 1e-3..1e5", 5);
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const auto range = float(random.log_uniform(1e-3, 1e5));
    const AttenuationF a{float(random.log_uniform(1e-3, 10)), float(random.log_uniform(1e-6, 10)),
                         float(random.log_uniform(1e-9, 10))};
    const auto density = float(random.log_uniform(1e-6, 1));
    const Attenuation wide{a.constant, a.linear, a.quadratic};
    const auto text = [&] { return to_string(SolveCase{wide, {FogMode::exp, density}, range}); };
    attenuation_error.add(
        ulp_error(formulas::attenuation(range, a.constant, a.linear, a.quadratic), reference_attenuation(wide, range)),
        text);
    exp_error.add(ulp_error(formulas::opacity(formulas::depth_exp(range, density)),
                            reference_opacity(FogMode::exp, density, range)),
                  text);
    exp2_error.add(ulp_error(formulas::opacity(formulas::depth_exp2(range, density)),
                             reference_opacity(FogMode::exp2, density, range)),
                   text);
  }
  attenuation_error.check();
  exp_error.check();
  exp2_error.check();
}

TEST(Formulas, ForeignScalarTypeYieldsTheClosedDerivatives) {
  WorstError attenuation_error("attenuation'", "r 1e-2..1e3", 4e-15, "relative");
  WorstError exp_error("opacity', exp", "d r up to 20", 1e-13, "relative");
  WorstError exp2_error("opacity', exp2", "d r up to 5", 1e-13, "relative");
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    const double r = random.log_uniform(1e-2, 1e3);
    const Dual range(r, 1);
    const Attenuation a{random.log_uniform(1, 10), random.log_uniform(1e-6, 10), random.log_uniform(1e-9, 10)};
    const auto text = [&] { return to_string(SolveCase{a, {}, r}); };

    const Dual attenuation = formulas::attenuation(range, Dual(a.constant), Dual(a.linear), Dual(a.quadratic));
    const double fraction = attenuation_at(a, r);
    EXPECT_EQ(attenuation.value, fraction);
    attenuation_error.add(
        relative_error(attenuation.derivative, -fraction * fraction * (a.linear + 2 * a.quadratic * r)), text);

    const double d = random.log_uniform(1e-3, 20) / r;
    exp_error.add(
        relative_error(formulas::opacity(formulas::depth_exp(range, Dual(d))).derivative, d * std::exp(-d * r)), text);
    const double d2 = random.log_uniform(1e-3, 5) / r;
    exp2_error.add(relative_error(formulas::opacity(formulas::depth_exp2(range, Dual(d2))).derivative,
                                  2 * d2 * d2 * r * std::exp(-d2 * r * d2 * r)),
                   text);
  }
  attenuation_error.check();
  exp_error.check();
  exp2_error.check();
}

TEST(Formulas, ForeignScalarTypeDifferentiatesCones) {
  const Dual cosine = formulas::cosine_cone(Dual(0.9, 1), Dual(0.8), Dual(3.0));
  EXPECT_DOUBLE_EQ(cosine.value, 0.9 * 0.9 * 0.9);
  EXPECT_DOUBLE_EQ(cosine.derivative, 3 * 0.9 * 0.9);
  const Dual step = formulas::smoothstep_cone(Dual(0.85, 1), Dual(0.9), Dual(0.8));
  EXPECT_NEAR(step.value, 0.5, 1e-14);
  EXPECT_NEAR(step.derivative, 1.5 / 0.1, 1e-12);
}

TEST(Formulas, AttenuationHasNoSlopeBelowTheKnee) {
  const Dual attenuation = formulas::attenuation(Dual(1, 1), Dual(0.25), Dual(0.25), Dual(0.25));
  EXPECT_EQ(attenuation.value, 1);
  EXPECT_EQ(attenuation.derivative, 0);
}

TEST(Formulas, NarrowSmoothstepConeIsAStep) {
  EXPECT_EQ(formulas::smoothstep_cone(1.0f, 1.0f, 1.0f), 1);
  EXPECT_EQ(formulas::smoothstep_cone(0.999f, 1.0f, 1.0f), 0);
}

}  // namespace
}  // namespace litfog::test
