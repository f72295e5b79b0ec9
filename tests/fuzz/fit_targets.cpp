// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "fit/random_target.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/wild_number.h"
#include "reference/falloff_reference.h"

namespace litfog::test {
namespace {

void expect_fitted(const AttenuationTarget& target) {
  if (find_error(target)) {
    EXPECT_THROW(fit_attenuation(target), std::invalid_argument);
    return;
  }
  const AttenuationFit fit = fit_attenuation(target);
  EXPECT_FALSE(find_error(fit.attenuation));
  EXPECT_TRUE(std::isfinite(fit.objective) && fit.objective >= 0) << fit.objective;
  EXPECT_TRUE(std::isfinite(fit.rms_error) && std::isfinite(fit.largest_error));
  EXPECT_NE(fit.sentence, "");
  EXPECT_EQ(fit.residuals.size(), target.samples.size());
  if (target.extent) {
    const double extent = std::clamp(*target.extent, 1e-30, 1e30);  // it may be the float of a limit
    EXPECT_LE(std::abs(compute_extent(fit.attenuation, target.threshold) / extent - 1), 1e-12);
  }
  if (target.samples.empty() || fit.status != AttenuationFitStatus::optimal) return;
  const FalloffReferenceSearch search(target, fit.loss_scale);
  double weights = 0;
  for (const AttenuationSample& sample : target.samples) weights += sample.weight;
  const auto [constant, linear, quadratic] = fit.attenuation;
  const double objective = search.objective(std::array{constant, linear, quadratic});
  EXPECT_GE(search.least_on_grid(), objective * (1 - 1e-7) - 1e-20 * weights);
}

void fit_range(std::string_view bytes) {
  Random random(bytes);
  WildNumbers wild(random);
  AttenuationTarget target = draw_attenuation_target(random);
  if (random.chance(0.2)) target.threshold = wild.draw();
  if (random.chance(0.2)) target.extent = wild.draw();
  if (random.chance(0.2)) target.constant = wild.draw();
  for (AttenuationSample& sample : target.samples) {
    if (random.chance(0.1)) sample.range = wild.draw();
    if (random.chance(0.1)) sample.attenuation = wild.draw();
    if (random.chance(0.1)) sample.weight = wild.draw();
  }
  target.family = AttenuationFamily(random.below(3));
  expect_fitted(target);
}

void fit_beam(std::string_view bytes) {
  Random random(bytes);
  WildNumbers wild(random);
  ConeTarget target{.samples = draw_cone_samples(random)};
  if (random.chance(0.2)) target.samples.clear();
  if (random.chance(0.3)) target.profile = ConeProfile(random.below(3));
  if (random.chance(0.2)) target.half_angle = wild.draw();
  if (random.chance(0.2)) target.beam_angle = wild.draw();
  if (random.chance(0.2)) target.field_angle = wild.draw();
  for (ConeSample& sample : target.samples) {
    if (random.chance(0.1)) sample.angle = wild.draw();
    if (random.chance(0.1)) sample.intensity = wild.draw();
    if (random.chance(0.1)) sample.weight = wild.draw();
  }
  if (find_error(target)) {
    EXPECT_THROW(fit_cone(target), std::invalid_argument);
    return;
  }
  const ConeFit fit = fit_cone(target);
  ASSERT_LT(fit.best_index, fit.profiles.size());
  for (const ConeProfileFit& found : fit.profiles) {
    EXPECT_FALSE(find_error(found.cone)) << to_string(*find_error(found.cone));
    EXPECT_TRUE(std::isfinite(found.objective) && found.objective >= 0) << found.objective;
    EXPECT_LE(found.lower_bound, found.objective);
    EXPECT_TRUE(std::isfinite(found.rms) && std::isfinite(found.largest_error));
  }
}

const AddFuzzTargets kAdd{{"fit-range", fit_range, {}, random_seeds}, {"fit-beam", fit_beam, {}, random_seeds}};

}  // namespace
}  // namespace litfog::test
