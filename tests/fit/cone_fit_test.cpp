// SPDX-License-Identifier: Apache-2.0
#include "litfog/fit/cone_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/value_errors.h"
#include "fit/cosine_profile.h"
#include "fit/random_target.h"
#include "fit/smoothstep_profile.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

constexpr double radians(double degrees) { return degrees / 180 * pi; }

ConeTarget target_of(std::optional<ConeProfile> profile, std::vector<ConeSample> samples) {
  return {.profile = profile, .samples = std::move(samples)};
}

std::vector<ConeSample> sampled(const Cone& cone, double last, int count) {
  std::vector<ConeSample> samples;
  for (int i = 0; i < count; ++i) {
    const double angle = last * i / (count - 1);
    samples.push_back({angle, cone_at(cone, std::cos(angle))});
  }
  return samples;
}

std::string to_string(const Cone& cone) {
  char text[200];
  std::snprintf(text, sizeof text, "half angle %.17g, exponent %.17g, inner %.17g, outer %.17g", cone.half_angle,
                cone.exponent, cone.inner, cone.outer);
  return text;
}

double objective_of(const Cone& cone, const std::vector<ConeSample>& samples) {
  double peak = 0;
  for (const ConeSample& sample : samples) peak = std::max(peak, sample.intensity);
  double sum = 0;
  for (const auto& [angle, intensity, weight] : samples) {
    const double error = cone_at(cone, std::cos(angle)) - intensity / peak;
    sum += weight * error * error;
  }
  return sum;
}

// ---- the best cone by another way: every cut or a fine grid, the most promising refined by Brent's method ----

double best_cosine_objective(const std::vector<ConeSample>& samples) {
  double best = kInfinity;
  std::vector<double> cuts{samples.front().angle / 2};
  for (std::size_t i = 1; i < samples.size(); ++i) cuts.push_back((samples[i - 1].angle + samples[i].angle) / 2);
  cuts.push_back(pi / 2);
  for (const double cut : cuts) {
    if (!(cut > 0 && cut <= pi / 2)) continue;
    const auto loss = [&](double log_exponent) {
      return objective_of(Cone::cosine(cut, std::exp(log_exponent)), samples);
    };
    best = std::min(best, objective_of(Cone::cosine(cut, 0), samples));
    constexpr int kSteps = 120;
    const auto at = [](int i) { return -8 + 24. * i / kSteps; };
    for (int i = 1; i < kSteps; ++i) {
      if (loss(at(i)) > loss(at(i - 1)) || loss(at(i)) > loss(at(i + 1))) continue;
      best = std::min(best, boost::math::tools::brent_find_minima(loss, at(i - 1), at(i + 1), 40).second);
    }
  }
  return best;
}

double best_smoothstep_objective(const std::vector<ConeSample>& samples) {
  constexpr int kSteps = 80;
  const double last = samples.back().angle;
  std::vector<std::pair<double, Cone>> seeds;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = i + 1; j <= 2 * kSteps; ++j) {
      const double outer = j <= kSteps ? last * j / kSteps : last + (pi - last) * (j - kSteps) / kSteps;
      const Cone cone = Cone::smoothstep(last * i / kSteps, outer);
      if (cone.inner < cone.outer) seeds.emplace_back(objective_of(cone, samples), cone);
    }
  }
  const std::size_t count = std::min<std::size_t>(seeds.size(), 12);
  std::partial_sort(seeds.begin(), seeds.begin() + std::ptrdiff_t(count), seeds.end(),
                    [](const auto& a, const auto& b) { return a.first < b.first; });
  double best = kInfinity;
  for (std::size_t i = 0; i < count; ++i) {
    auto [objective, cone] = seeds[i];
    double reach = last / kSteps;  // pattern search
    while (reach > 1e-10) {
      bool is_better = false;
      for (const auto& [x, y] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
        const Cone next = Cone::smoothstep(std::max(0.0, cone.inner + x * reach), std::min(pi, cone.outer + y * reach));
        if (find_error(next)) continue;
        const double value = objective_of(next, samples);
        if (value < objective) {
          objective = value;
          cone = next;
          is_better = true;
        }
      }
      reach *= is_better ? 1.5 : 0.5;
    }
    best = std::min(best, objective);
  }
  return best;
}

TEST(ConeFit, BothProfilesHaveTheirGlobalOptimum) {
  Random random(21);
  WorstError cosine_excess("cosine objective", "above that of cuts and Brent's method", 1e-3, "relative");
  WorstError smoothstep_excess("smoothstep objective", "above that of a grid and pattern search", 1e-3, "relative");
  WorstError kkt("KKT residual", "60 beams, both profiles", 1e-5, "");
  WorstError boxes("boxes", "examined for a proof", 1000, "");
  for (int i = 0; i < scaled_count(60); ++i) {
    const auto samples = draw_cone_samples(random);
    if (samples.size() < 2) continue;
    SCOPED_TRACE(i);
    const auto name = [i] { return std::to_string(i); };
    const ConeFit fit = fit_cone(target_of(std::nullopt, samples));
    for (const ConeProfileFit& found : fit.profiles) {
      EXPECT_EQ(found.status, ConeFitStatus::optimal);
      EXPECT_FALSE(find_error(found.cone));
      EXPECT_NEAR(found.objective, objective_of(found.cone, samples), 1e-14 + 1e-12 * found.objective);
      EXPECT_LE(found.lower_bound, found.objective);
      kkt.add(found.kkt_residual, name);
      boxes.add(double(found.boxes), name);
    }
    const double cosine = best_cosine_objective(samples);
    const double smoothstep = best_smoothstep_objective(samples);
    EXPECT_LE(fit.profiles.front().lower_bound, cosine * (1 + 1e-12));
    EXPECT_LE(fit.profiles.back().lower_bound, smoothstep * (1 + 1e-12));
    cosine_excess.add((fit.profiles.front().objective - 1e-20) / cosine - 1, name);
    smoothstep_excess.add((fit.profiles.back().objective - 1e-20) / smoothstep - 1, name);
    EXPECT_EQ(fit.best().objective, std::min(fit.profiles.front().objective, fit.profiles.back().objective));
  }
  cosine_excess.check();
  smoothstep_excess.check();
  kkt.check();
  boxes.check();
}

/// Compares bounds of random boxes with the objectives of cones in them.
template <typename Profile>
void expect_bounds_hold(const Profile& profile, Random& random) {
  const ConeBox root = profile.root();
  for (int i = 0; i < 60; ++i) {
    ConeBox box;
    for (std::size_t j = 0; j < 2; ++j) {
      const double size = (root.most[j] - root.least[j]) * random.log_uniform(1e-3, 1);
      box.least[j] = random.uniform(root.least[j], root.most[j] - size);
      box.most[j] = box.least[j] + size;
    }
    const auto start = profile.start(box);
    if (!start) continue;
    const double bound = profile.bound(box, profile.objective(*start));
    for (int k = 0; k < 12; ++k) {
      ConeParameters inside;
      for (std::size_t j = 0; j < 2; ++j) {
        const double at = k < 4 ? k >> j & 1 : random.uniform(0, 1);  // corners first
        inside[j] = at == 1 ? box.most[j] : box.least[j] + at * (box.most[j] - box.least[j]);
      }
      const auto cone = profile.start({inside, inside});
      if (cone) {
        EXPECT_LE(bound, profile.objective(*cone) * (1 + 1e-9) + 1e-15) << inside[0] << ", " << inside[1];
      }
    }
  }
}

TEST(ConeFit, BoundOfABoxIsAboveNoConeInIt) {
  Random random(24);
  for (int i = 0; i < 30; ++i) {
    const auto samples = draw_cone_samples(random);
    if (samples.size() < 2) continue;
    SCOPED_TRACE(i);
    const std::vector<ConePoint> points = points_of({.samples = samples});
    expect_bounds_hold(CosineProfile(points, std::nullopt), random);
    expect_bounds_hold(SmoothstepProfile(points, std::nullopt), random);
  }
}

TEST(ConeFit, FitOfExactSamplesIsTheConeThatTheyWereDrawnFrom) {
  Random random(22);
  WorstError exponent_error("exponent", "from 25 exact samples", 1e-8, "relative");
  WorstError angle_error("inner and outer", "from 25 exact samples", 1e-8, "of outer");
  for (int i = 0; i < 200; ++i) {
    const double half_angle = random.log_uniform(radians(1), radians(89));
    const double fall = -std::log(std::cos(half_angle));
    const Cone cosine = Cone::cosine(half_angle, random.log_uniform(0.01, 6) / fall);
    const auto cosine_fit = fit_cone(target_of(std::nullopt, sampled(cosine, 1.23 * half_angle, 25)));
    EXPECT_EQ(cosine_fit.best().cone.profile, ConeProfile::cosine);
    EXPECT_LT(cosine_fit.best().rms, 1e-9);
    exponent_error.add(std::abs(cosine_fit.best().cone.exponent / cosine.exponent - 1),
                       [&] { return to_string(cosine); });
    EXPECT_LT(cosine_fit.best().cutoff_range[0], half_angle);
    EXPECT_GE(cosine_fit.best().cutoff_range[1], half_angle);

    const double outer = random.log_uniform(radians(1), radians(150));
    const Cone dual = Cone::smoothstep(random.uniform(0, 0.8) * outer, outer);
    const auto dual_fit = fit_cone(target_of(std::nullopt, sampled(dual, 1.2 * outer, 25)));
    EXPECT_EQ(dual_fit.best().cone.profile, ConeProfile::smoothstep);
    EXPECT_LT(dual_fit.best().rms, 1e-9);
    for (const double error : {dual_fit.best().cone.inner - dual.inner, dual_fit.best().cone.outer - dual.outer}) {
      angle_error.add(std::abs(error) / outer, [&] { return to_string(dual); });
    }
  }
  exponent_error.check();
  angle_error.check();
}

TEST(ConeFit, ResidualsThatAreRoundingHaveNoKktResidual) {
  // Their direction is chance. No cone has residuals of exactly 0 here.
  const ConeFit fit = fit_cone(target_of(ConeProfile::smoothstep, {{0, 1, 1}, {pi / 2, 1.522997974e-8, 1}}));
  EXPECT_LT(fit.best().rms, 1e-15);
  EXPECT_EQ(fit.best().kkt_residual, 0);
}

TEST(ConeFit, BeamAngleAloneIsMetInClosedForm) {
  const ConeTarget target{.beam_angle = radians(20)};
  const ConeFit fit = fit_cone(target);
  EXPECT_EQ(fit.best().cone.profile, ConeProfile::cosine) << "both are exact";
  const Cone& cosine = fit.profiles.front().cone;
  EXPECT_NEAR(cosine.exponent, std::log(0.5) / std::log(std::cos(radians(10))), 1e-9);
  EXPECT_NEAR(cone_at(Cone::cosine(pi / 2, cosine.exponent), std::cos(cosine.half_angle)), 5e-4, 1e-12);
  EXPECT_EQ(fit.profiles.back().cone.inner, 0) << "the softest edge";
  EXPECT_NEAR(std::cos(fit.profiles.back().cone.outer), 2 * std::cos(radians(10)) - 1, 1e-15);
  EXPECT_NEAR(*fit.profiles.back().beam_angle_error, 0, 1e-12);
  EXPECT_FALSE(fit.profiles.back().covariance);
  EXPECT_FALSE(fit.profiles.front().covariance) << "nothing left to estimate it from";
  EXPECT_FALSE(fit.profiles.back().field_angle_error);
  EXPECT_FALSE(fit.profiles.back().flux_error);
}

TEST(ConeFit, BeamAndFieldAngleAreMetByTheDualCone) {
  const ConeFit fit = fit_cone({.beam_angle = radians(11), .field_angle = radians(13)});
  EXPECT_EQ(fit.best().cone.profile, ConeProfile::smoothstep);
  EXPECT_NEAR(cone_at(fit.best().cone, std::cos(radians(5.5))), 0.5, 1e-12);
  EXPECT_NEAR(cone_at(fit.best().cone, std::cos(radians(6.5))), 0.1, 1e-12);
  EXPECT_NEAR(*fit.best().beam_angle_error, 0, 1e-12);
  EXPECT_NEAR(*fit.best().field_angle_error, 0, 1e-12);
  EXPECT_FALSE(fit.best().covariance) << "as many angles as parameters: no scatter to estimate it from";
  const ConeProfileFit& cosine = fit.profiles.front();
  const double at_beam = cone_at(cosine.cone, std::cos(radians(5.5))) - 0.5;
  EXPECT_NEAR(cosine.objective, std::pow(at_beam, 2) + std::pow(cone_at(cosine.cone, std::cos(radians(6.5))) - 0.1, 2),
              1e-15);
}

TEST(ConeFit, CosineConeOfALambertianPatchHasExponentOneAndItsGivenEdge) {
  const ConeFit fit =
      fit_cone({.profile = ConeProfile::cosine, .half_angle = radians(80), .beam_angle = radians(120), .samples = {}});
  EXPECT_NEAR(fit.best().cone.exponent, 1, 1e-12);
  EXPECT_EQ(fit.best().cone.half_angle, radians(80));
  EXPECT_EQ(fit.best().cutoff_range, (std::array{radians(80), radians(80)}));
  EXPECT_EQ(fit.profiles.size(), 1u);
}

TEST(ConeFit, GivenHalfAngleIsWhereEitherProfileEnds) {
  const auto samples = sampled(Cone::cosine(radians(40), 20), radians(60), 31);
  ConeTarget target = target_of(std::nullopt, samples);
  target.half_angle = radians(50);
  const ConeFit fit = fit_cone(target);
  EXPECT_EQ(fit.profiles.front().cone.half_angle, radians(50));
  EXPECT_EQ(fit.profiles.back().cone.outer, radians(50));
  EXPECT_EQ(fit.profiles.front().status, ConeFitStatus::optimal);
  EXPECT_EQ(fit.profiles.back().status, ConeFitStatus::optimal);
}

TEST(ConeFit, EdgeBetweenSamplesIsAsSoftAsTheyAllow) {
  const ConeFit fit = fit_cone(target_of(ConeProfile::smoothstep, {{0, 1}, {radians(5), 1}, {radians(8.75), 0}}));
  EXPECT_EQ(fit.best().cone, Cone::smoothstep(radians(5), radians(8.75)));
  EXPECT_EQ(fit.best().objective, 0);
  const ConeFit through =
      fit_cone(target_of(ConeProfile::smoothstep, {{0, 1}, {radians(5), 1}, {radians(6), 0.5}, {radians(20), 0}}));
  EXPECT_DOUBLE_EQ(through.best().cone.inner, radians(5));
  EXPECT_NEAR(std::cos(through.best().cone.outer), 2 * std::cos(radians(6)) - std::cos(radians(5)), 1e-15);
  EXPECT_FALSE(through.best().covariance) << "the rule made the choice";
  ConeTarget target =
      target_of(ConeProfile::smoothstep, {{0, 1}, {radians(5), 1}, {radians(12), 0.9}, {radians(25), 0}});
  target.half_angle = radians(20);
  EXPECT_TRUE(fit_cone(target).best().covariance) << "one sample in the edge, one free angle";
}

TEST(ConeFit, CutOffOfABeamWithAFaintSpillIsNearTheBeam) {
  std::vector<ConeSample> samples;  // 7.4 degrees wide, with a spill of 0.1 % out to 75 degrees
  const double exponent = std::log(0.5) / std::log(std::cos(radians(3.7)));
  for (int angle = 0; angle <= 90; ++angle) {
    const double beam = std::pow(std::cos(radians(angle)), exponent);
    samples.push_back({radians(angle), angle <= 75 ? std::max(beam, 0.001) : 0});
  }
  const ConeFit fit = fit_cone(target_of(ConeProfile::cosine, samples));
  const Cone& cone = fit.best().cone;
  EXPECT_LT(cone.half_angle, radians(15)) << "whoever culls by it pays for more";
  EXPECT_LE(cone_at(cone, std::cos(cone.half_angle - 1e-9)), 5e-4 * (1 + 1e-6)) << "without a visible edge";
  EXPECT_LE(fit.best().objective, fit.best().lower_bound * 1.001);
  EXPECT_EQ(fit.best().status, ConeFitStatus::optimal);
}

TEST(ConeFit, CutOffOfTheCosineConeIsBetweenTheLastLitAndTheFirstDarkSample) {
  const ConeFit flat = fit_cone(
      target_of(ConeProfile::cosine, {{0, 1}, {radians(10), 1}, {radians(20), 1}, {radians(30), 0}, {radians(40), 0}}));
  EXPECT_EQ(flat.best().cone.exponent, 0);
  EXPECT_EQ(flat.best().cutoff_range, (std::array{radians(20), radians(30)}));
  EXPECT_DOUBLE_EQ(flat.best().cone.half_angle, radians(25));
  EXPECT_EQ(flat.best().objective, 0);
  const ConeFit axis_only = fit_cone(target_of(ConeProfile::cosine, {{0, 1}, {radians(10), 0}}));
  EXPECT_EQ(axis_only.best().cone, Cone::cosine(radians(5), 0));
  const ConeFit wide = fit_cone(target_of(ConeProfile::cosine, {{0, 1}, {radians(60), 0.5}, {radians(120), 0}}));
  EXPECT_EQ(wide.best().cutoff_range, (std::array{radians(60), pi / 2}));
  ConeTarget dark = target_of(ConeProfile::cosine, {{radians(10), 1}, {radians(20), 0.5}});
  dark.half_angle = radians(5);
  EXPECT_EQ(fit_cone(dark).best().cone, Cone::cosine(radians(5), 0)) << "without a lit sample";
  EXPECT_FALSE(axis_only.best().covariance);
}

TEST(ConeFit, CutOffDoesNotPartASampleFromTheStatedAngleThatItStandsAt) {
  ConeTarget target{.profile = ConeProfile::cosine, .beam_angle = radians(20)};
  target.samples = {{0, 1}, {radians(10), 0}, {radians(20), 0}};
  const ConeFit fit = fit_cone(target);
  EXPECT_NEAR(fit.best().objective, 2 * 0.25 * 0.25, 1e-3) << "half-way between 0.5 and 0";
  EXPECT_NEAR(cone_at(fit.best().cone, std::cos(radians(10))), 0.25, 0.02);
}

TEST(ConeFit, WeightedFitOfAFlatBeamIsItsWeightedMean) {
  // One free value: the samples inside the edge of a cosine cone that all stand at one angle but for rounding.
  const double angle = radians(30);
  ConeTarget target{.profile = ConeProfile::cosine, .half_angle = radians(60), .beam_angle = 2 * angle};
  target.samples = {{0, 1}, {angle, 0.8, 3}};
  const ConeFit fit = fit_cone(target);
  const double mean = (0.5 * 1 + 0.8 * 3) / 4;
  EXPECT_NEAR(fit.best().cone.exponent, std::log(mean) / std::log(std::cos(angle)), 1e-10);
  EXPECT_NEAR(fit.best().objective, std::pow(mean - 0.5, 2) + 3 * std::pow(mean - 0.8, 2), 1e-15);
  EXPECT_NEAR(fit.best().rms, std::sqrt(fit.best().objective / 6), 1e-15);
  EXPECT_NEAR(fit.best().largest_error, mean - 0.5, 1e-9);
  EXPECT_EQ(fit.best().largest_error_angle, angle);
  EXPECT_LE(fit.best().kkt_residual, 1e-6);
  const double slope = mean * std::log(std::cos(angle));  // of the cone by the exponent, at four of weight
  ASSERT_TRUE(fit.best().covariance);
  const double variance = fit.best().objective / 3 / (4 * slope * slope);
  EXPECT_NEAR((*fit.best().covariance)[0][0] / variance, 1, 1e-8);
}

TEST(ConeFit, CosineMatchedAtTheBeamAngleMissesTheFieldAngleOfRealBeams) {
  // Known answers of two luminaires: half angles at 50 % and 10 % of the peak.
  for (const auto& [beam, field] : {std::pair{5.00, 10.09}, {15.01, 20.87}}) {
    const Cone matched = fit_cone({.profile = ConeProfile::cosine, .beam_angle = radians(2 * beam)}).best().cone;
    const ConeFit fit = fit_cone({.beam_angle = radians(2 * beam), .field_angle = radians(2 * field)});
    EXPECT_GT(std::abs(angle_at_level(matched, 0.1) / radians(field) - 1), 0.09);
    EXPECT_LT(std::abs(*fit.best().field_angle_error), std::abs(angle_at_level(matched, 0.1) / radians(field) - 1));
  }
}

TEST(ConeFit, FluxErrorComparesWithTheSamplesFlux) {
  // Linear from 1 to 0 in a right angle: 2 pi * integral of (1 - 2 u / pi) sin u = 2 pi (1 - 2 / pi).
  const ConeFit fit = fit_cone(target_of(std::nullopt, {{0, 7}, {pi / 4, 3.5}, {pi / 2, 0}}));
  const double flux = 2 * pi * (1 - 2 / pi);
  for (const ConeProfileFit& profile : fit.profiles) {
    EXPECT_NEAR(*profile.flux_error, flux_within(profile.cone, pi) / flux - 1, 1e-13);
  }
}

TEST(ConeFit, FluxErrorIsOfTheAnglesThatTheSamplesCover) {
  const std::vector<ConeSample> samples{{0.2, 8}, {0.3, 6}, {0.5, 1}};
  double flux = 0;  // of the largest intensity
  for (double angle = 0.2005; angle < 0.5; angle += 0.001) {
    const double intensity = angle < 0.3 ? 8 - 20 * (angle - 0.2) : 6 - 25 * (angle - 0.3);
    flux += 2 * pi * std::sin(angle) * intensity / 8 * 0.001;
  }
  for (const ConeProfileFit& profile : fit_cone(target_of(std::nullopt, samples)).profiles) {
    const double covered = flux_within(profile.cone, 0.5) - flux_within(profile.cone, 0.2);
    EXPECT_NEAR(*profile.flux_error, covered / flux - 1, 1e-5);
  }
  EXPECT_TRUE(fit_cone(target_of(std::nullopt, {{0, 1}, {0.3, 0.2}})).best().flux_error) << "of two samples as well";
}

TEST(ConeFit, AnglesThatAreNotStatedAreThoseOfTheSamples) {
  // They fall to 50 % a fourth of the way from 0.2 to 0.3, and to 10 % half-way from 0.3 to 0.4.
  const ConeFit fit = fit_cone(target_of(std::nullopt, {{0, 5}, {0.1, 5}, {0.2, 3}, {0.3, 1}, {0.4, 0}}));
  for (const ConeProfileFit& profile : fit.profiles) {
    EXPECT_NEAR(*profile.beam_angle_error, angle_at_level(profile.cone, 0.5) / 0.225 - 1, 1e-12);
    EXPECT_NEAR(*profile.field_angle_error, angle_at_level(profile.cone, 0.1) / 0.35 - 1, 1e-12);
  }
  const ConeFit bright = fit_cone(target_of(std::nullopt, {{0, 1}, {0.1, 0.9}, {0.2, 0.3}}));
  EXPECT_TRUE(bright.best().beam_angle_error);
  EXPECT_FALSE(bright.best().field_angle_error) << "they do not fall to 10 %";
}

TEST(ConeFit, CovarianceOfAnAngleAtZeroIsZero) {
  const Cone truth = Cone::smoothstep(0, 1.2);
  ConeTarget target{.profile = ConeProfile::smoothstep};
  for (int i = 0; i < 8; ++i) target.samples.push_back({0.2 * i, cone_at(truth, std::cos(0.2 * i))});
  const auto fit = fit_cone(target).best();
  EXPECT_EQ(fit.cone.inner, 0);
  ASSERT_TRUE(fit.covariance);
  EXPECT_EQ((*fit.covariance)[0], (std::array<double, 2>{0, 0}));
  EXPECT_EQ((*fit.covariance)[1][0], 0);
  EXPECT_GE((*fit.covariance)[1][1], 0);
}

TEST(ConeFit, CovarianceHasTheScatterOfRepeatedFits) {
  Random random(23);
  const Cone truth = Cone::smoothstep(radians(6), radians(18));
  const auto normal = [&random] { return random.uniform(-1, 1) + random.uniform(-1, 1) + random.uniform(-1, 1); };
  std::vector<ConeSample> clean{{0, 1}};
  for (double angle = radians(8); angle < radians(16.5); angle += radians(0.25)) {
    clean.push_back({angle, cone_at(truth, std::cos(angle))});
  }
  constexpr int kFits = 200;
  double inner_squares = 0;
  double outer_squares = 0;
  double inner_variance = 0;
  double outer_variance = 0;
  for (int i = 0; i < kFits; ++i) {
    ConeTarget target = target_of(ConeProfile::smoothstep, clean);
    for (std::size_t k = 1; k < clean.size(); ++k) target.samples[k].intensity += 0.01 * normal();
    const auto fit = fit_cone(target).best();
    ASSERT_TRUE(fit.covariance);
    inner_squares += std::pow(fit.cone.inner - truth.inner, 2) / kFits;
    outer_squares += std::pow(fit.cone.outer - truth.outer, 2) / kFits;
    inner_variance += (*fit.covariance)[0][0] / kFits;
    outer_variance += (*fit.covariance)[1][1] / kFits;
  }
  EXPECT_NEAR(inner_variance / inner_squares, 1, 0.25);  // 200 fits: a standard error of 10 %
  EXPECT_NEAR(outer_variance / outer_squares, 1, 0.25);
}

TEST(ConeFit, SamplesWithoutWeightAreLeftOut) {
  const auto samples = sampled(Cone::smoothstep(0.1, 0.4), 0.5, 21);
  auto with_outliers = samples;
  for (const std::size_t i : {7u, 12u}) with_outliers[i] = {with_outliers[i].angle, 99, 0};
  auto without = samples;
  without.erase(without.begin() + 12);
  without.erase(without.begin() + 7);
  EXPECT_EQ(fit_cone(target_of(std::nullopt, with_outliers)).best().cone,
            fit_cone(target_of(std::nullopt, without)).best().cone);
}

TEST(ConeFit, ProfileOfABeamGivesSamplesOfOneWeight) {
  const std::vector<ConeSample> samples = cone_samples({{0, 900, 30}, {0.2, 400, 0}});
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[1].angle, 0.2);
  EXPECT_EQ(samples[1].intensity, 400);
  EXPECT_EQ(samples[0].weight, samples[1].weight);
}

TEST(ConeFit, CosineProfileLeavesItsHalfAngleOpen) {
  EXPECT_EQ(fitted_parameters(ConeProfile::cosine).size(), 1u);
  EXPECT_EQ(fitted_parameters(ConeProfile::smoothstep).size(), 2u);
}

TEST(ConeFit, ErrorNamesFieldValueAndRule) {
  const auto error = [](const ConeTarget& target) { return error_of([&] { fit_cone(target); }); };
  EXPECT_EQ(error({}), "samples = 0: must be at least two with weight where no beam or field angle is given");
  EXPECT_EQ(error({.samples = {{0, 1}, {1, 1, 0}}}),
            "samples = 1: must be at least two with weight where no beam or field angle is given");
  EXPECT_EQ(error({.half_angle = 1.6, .beam_angle = 1}), "half_angle = 1.6: must be in (0, pi/2]");
  EXPECT_EQ(error({.profile = ConeProfile::none, .beam_angle = 1}), "profile = 0: must be one that is fitted");
  EXPECT_EQ(error({.profile = ConeProfile::smoothstep, .half_angle = 3.5, .beam_angle = 1}),
            "half_angle = 3.5: must be in (0, pi]");
  EXPECT_EQ(error({.beam_angle = 0}), "beam_angle = 0: must be in (0, 2 pi]");
  EXPECT_EQ(error({.beam_angle = kNan}), "beam_angle = nan: must be in (0, 2 pi]");
  EXPECT_EQ(error({.field_angle = 7}), "field_angle = 7: must be in (0, 2 pi]");
  EXPECT_EQ(error({.beam_angle = 1, .field_angle = 1}), "field_angle = 1: must be larger than the beam angle");
  EXPECT_EQ(error({.samples = {{0, 1}, {4, 1}}}), "samples[1].angle = 4: must be in [0, pi]");
  EXPECT_EQ(error({.samples = {{-0.1, 1}, {1, 1}}}), "samples[0].angle = -0.1: must be in [0, pi]");
  EXPECT_EQ(error({.samples = {{0, 1}, {1, 1}, {1, 2}}}), "samples[2].angle = 1: must be larger than the one before");
  EXPECT_EQ(error({.samples = {{0, 1}, {kNan, 1}}}), "samples[1].angle = nan: must be in [0, pi]");
  EXPECT_EQ(error({.samples = {{0, 1}, {1, -1}}}), "samples[1].intensity = -1: must be finite and >= 0");
  EXPECT_EQ(error({.samples = {{0, kInfinity}, {1, 1}}}), "samples[0].intensity = inf: must be finite and >= 0");
  EXPECT_EQ(error({.samples = {{0, 1}, {1, 1, -1}}}), "samples[1].weight = -1: must be 0 or in [1e-100, 1e100]");
  EXPECT_EQ(error({.samples = {{0, 0}, {1, 0}}}),
            "samples.intensity = 0: must be > 0 for one of the samples with weight");
  EXPECT_EQ(error({.samples = {{0, 0}, {1, 0}, {2, 9, 0}}}),
            "samples.intensity = 0: must be > 0 for one of the samples with weight");
}

TEST(ConeFit, TargetsAtTheEndsOfTheirRangesAreFitted) {
  for (const ConeTarget& target :
       {ConeTarget{.beam_angle = 1e-6}, ConeTarget{.beam_angle = 2 * pi}, ConeTarget{.field_angle = 2 * pi},
        ConeTarget{.beam_angle = double(float(2 * pi))}, ConeTarget{.beam_angle = 1, .field_angle = 2 * pi},
        target_of(std::nullopt, {{0, 1}, {1e-300, 1}}), target_of(std::nullopt, {{0, 1}, {pi, 1}}),
        target_of(std::nullopt, {{pi / 2, 1}, {pi, 0.5}}), target_of(std::nullopt, {{0, 1e-300}, {1, 1e308}}),
        target_of(std::nullopt, {{0, 1, 1e100}, {1, 0.5}}),
        target_of(std::nullopt, {{0, 0}, {0.1, 0}, {0.2, 1}, {0.3, 0}})}) {
    const ConeFit fit = fit_cone(target);
    for (const ConeProfileFit& profile : fit.profiles) {
      EXPECT_FALSE(find_error(profile.cone)) << to_string(*find_error(profile.cone));
      EXPECT_TRUE(std::isfinite(profile.objective));
      EXPECT_EQ(profile.status, ConeFitStatus::optimal)
          << to_string(profile.cone) << profile.objective << " " << profile.lower_bound << " " << profile.boxes;
    }
  }
}

}  // namespace
}  // namespace litfog::test
