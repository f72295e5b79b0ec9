// SPDX-License-Identifier: Apache-2.0
#include "window/range_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace litfog::test {
using namespace window;

namespace {

const Fog kFog = Fog::from_visibility(FogMode::exp, 1500.0);

Light lamp(const Attenuation& attenuation) {
  Light light;
  light.attenuation = attenuation;
  return light;
}

TEST(RangeCurve, LargestSampleIsTheSolvedIntensity) {
  for (const Attenuation& attenuation : {Attenuation{1, 0, 9.5e-5}, Attenuation{0.2, 0.05, 0.001}}) {
    const RangeCurve curve = make_range_curve(lamp(attenuation), kFog, 2001);
    const auto largest = std::ranges::max_element(curve.samples, {}, &RangeCurve::Sample::product);
    EXPECT_LE(largest->product, curve.solved.intensity);
    EXPECT_NEAR(largest->product, curve.solved.intensity, 1e-3 * curve.solved.intensity);
    const double range = curve.end * double(largest - curve.samples.begin()) / 2000;
    EXPECT_NEAR(range, curve.solved.peak_range, 0.05 * curve.end);
  }
}

TEST(RangeCurve, SamplesAreThePlainFormulasAndEndAtTheExtent) {
  const Attenuation attenuation{0.2, 0.05, 0.001};
  const RangeCurve curve = make_range_curve(lamp(attenuation), kFog, 101);
  EXPECT_GT(curve.knee, 0);
  EXPECT_GT(curve.end, curve.solved.extent);
  for (std::size_t i = 0; i < curve.samples.size(); ++i) {
    const double range = curve.end * double(i) / 100;
    const double opacity = 1 - std::exp(-kFog.density * range);
    const double denominator = 0.2 + 0.05 * range + 0.001 * range * range;
    const double seen = range <= curve.solved.extent ? std::min(1.0, 1 / denominator) : 0;
    EXPECT_NEAR(curve.samples[i].opacity, opacity, 1e-12);
    EXPECT_NEAR(curve.samples[i].attenuation, seen, 1e-12);
    EXPECT_NEAR(curve.samples[i].product, opacity * seen, 1e-12);
  }
}

TEST(RangeCurve, LightSeesTheDensityOfItsClass) {
  Light light = lamp({1, 0, 9.5e-5});
  light.density_scale = 0.4;
  const RangeCurve curve = make_range_curve(light, kFog, 11);
  const Fog thinner{kFog.mode, kFog.density * 0.4};
  EXPECT_EQ(curve.solved.intensity, solve_fog_intensity(light.attenuation, thinner).intensity);
  EXPECT_NEAR(curve.samples[5].opacity, 1 - std::exp(-0.4 * kFog.density * curve.end / 2), 1e-12);
}

TEST(RangeCurve, PlotEndsWhereverTheLightOrTheFogHasNoEnd) {
  for (const Attenuation& attenuation : {Attenuation{1, 0, 0}, Attenuation{30, 0, 1}, Attenuation{1, 0, 0.01}}) {
    for (const double visibility : {0.0, 100.0, double(INFINITY)}) {
      const RangeCurve curve = make_range_curve(lamp(attenuation), Fog::from_visibility(FogMode::exp, visibility), 21);
      EXPECT_TRUE(std::isfinite(curve.end) && curve.end > 0);
      for (const RangeCurve::Sample& sample : curve.samples) EXPECT_TRUE(std::isfinite(sample.product));
    }
  }
}

}  // namespace

}  // namespace litfog::test
