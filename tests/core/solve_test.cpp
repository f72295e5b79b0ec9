// SPDX-License-Identifier: Apache-2.0
#include "litfog/solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "core/value_errors.h"
#include "reference/double_limits.h"
#include "reference/random_light.h"
#include "reference/reference_solver.h"
#include "reference/ulp.h"

namespace litfog::test {
namespace {

/// The bounds of solve.h for one family of cases.
class SolveErrors {
 public:
  SolveErrors(const std::string& function, const std::string& range)
      : intensity_("intensity" + function, range, kIntensityMaxUlp<double>),
        peak_range_("peak_range" + function, range, kPeakRangeMaxError, "relative"),
        extent_("extent" + function, range, kExtentMaxUlp<double>) {}

  void add(const SolveCase& c, const ReferencePeak& reference) {
    const FogIntensity solved = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
    const auto text = [&] { return to_string(c); };
    intensity_.add(ulp_error(solved.intensity, reference.intensity), text);
    extent_.add(ulp_error(solved.extent, reference.extent), text);
    // A range that a double holds to few bits or not at all is as good as its rounding.
    const double rounding = ulp_error(solved.peak_range, reference.peak_range);
    peak_range_.add(rounding <= 1 ? 0 : relative_error(solved.peak_range, reference.peak_range), text);
    EXPECT_EQ(solved.status, SolveStatus::ok) << text();
  }

  void check() const {
    intensity_.check();
    peak_range_.check();
    extent_.check();
  }

 private:
  WorstError intensity_;
  WorstError peak_range_;
  WorstError extent_;
};

/// Random cases of one family, drawn by draw(random, mode), against the reference.
template <typename Draw>
void check_family(const char* range, const Draw& draw, int count = 4000) {
  for (const FogMode mode : kModes) {
    SolveErrors errors(std::string(", ") + name_of(mode), range);
    Random random(2004);
    for (int i = 0; i < scaled_count(count); ++i) {
      const SolveCase c = draw(random, mode);
      errors.add(c, solve_reference(c.attenuation, c.fog, c.threshold));
    }
    errors.check();
  }
}

double draw_ordinary_density(Random& random) { return random.log_uniform(1e-6, 10); }
double draw_ordinary_threshold(Random& random) {
  return random.chance(0.5) ? random.pick(std::array{0.05, 0.01, 1 / 255., 0.3, 0.001})
                            : random.log_uniform(1e-4, 0.99);
}

TEST(SolveFogIntensity, SolutionMeetsTheSixtyDigitReferenceToItsBounds) {
  std::ifstream file(LITFOG_TEST_DATA_DIR "/fog_intensity.json");
  std::map<std::string, SolveErrors> errors;
  for (const auto& row : nlohmann::json::parse(file)) {
    const auto text = [&](const char* key) { return Digits50(row.at(key).get<std::string>()); };
    const SolveCase c{{row.at("C"), row.at("L"), row.at("Q")},
                      {row.at("mode") == "exp" ? FogMode::exp : FogMode::exp2, row.at("density")},
                      row.at("threshold")};
    const std::string tag = row.at("tag").get<std::string>() + ", " + name_of(c.fog.mode);
    errors.try_emplace(tag, "", "60 digits: " + tag)
        .first->second.add(c, {text("intensity"), text("peak_range"), text("extent")});
  }
  for (const auto& [tag, error] : errors) error.check();
}

TEST(SolveFogIntensity, SolutionIsExactOverWideLights) {
  check_family("wide: C 1e-3..1e3, L 1e-9..1e3, Q 1e-12..1e3", [](Random& random, FogMode mode) {
    return SolveCase{{random.log_uniform(1e-3, 1e3), random.log_uniform(1e-9, 1e3), random.log_uniform(1e-12, 1e3)},
                     {mode, draw_ordinary_density(random)},
                     draw_ordinary_threshold(random)};
  });
}

TEST(SolveFogIntensity, SolutionIsExactOverOrdinaryLights) { check_family("ordinary lights", draw_ordinary_case); }

TEST(SolveFogIntensity, SolutionIsExactOverClampedLights) {
  check_family("clamped: C < 1", [](Random& random, FogMode mode) {
    const double constant = random.chance(0.3) ? 1 - random.log_uniform(1e-16, 0.1) : random.uniform(0, 1);
    return SolveCase{{constant, random.log_uniform(1e-6, 1), random.log_uniform(1e-9, 1)},
                     {mode, draw_ordinary_density(random)},
                     draw_ordinary_threshold(random)};
  });
}

TEST(SolveFogIntensity, SolutionIsExactOverLinearLights) {
  check_family("linear only", [](Random& random, FogMode mode) {
    return SolveCase{{random.chance(0.2) ? 1 : random.log_uniform(1e-6, 10), random.log_uniform(1e-9, 1e3), 0},
                     {mode, draw_ordinary_density(random)},
                     draw_ordinary_threshold(random)};
  });
}

TEST(SolveFogIntensity, SolutionIsExactOverQuadraticLights) {
  check_family("quadratic only", [](Random& random, FogMode mode) {
    return SolveCase{{random.chance(0.2) ? 1 : random.log_uniform(1e-6, 10), 0, random.log_uniform(1e-12, 1e3)},
                     {mode, draw_ordinary_density(random)},
                     draw_ordinary_threshold(random)};
  });
}

TEST(SolveFogIntensity, SolutionIsExactOverLightsWithoutConstant) {
  check_family("C = 0", [](Random& random, FogMode mode) {
    const double linear = random.chance(0.3) ? 0 : random.log_uniform(1e-9, 1e3);
    return SolveCase{{0, linear, linear > 0 && random.chance(0.3) ? 0 : random.log_uniform(1e-12, 1e3)},
                     {mode, draw_ordinary_density(random)},
                     draw_ordinary_threshold(random)};
  });
}

TEST(SolveFogIntensity, SolutionIsExactWhereThePeakIsNextToTheKneeOrTheExtent) {
  check_family("stationary point 1e-15..1e-3 from knee or extent", [](Random& random, FogMode mode) {
    SolveCase c{
        {random.uniform(0.01, 0.99), random.log_uniform(1e-4, 1), random.log_uniform(1e-8, 1)}, {mode, 1}, 0.05};
    const double border = random.chance(0.5) ? compute_knee(c.attenuation) : compute_extent(c.attenuation, c.threshold);
    // The density that puts the stationary point there: the point falls with the density.
    double thin = 1e-9 / border;
    double dense = 1e3 / border;
    while (dense > thin * (1 + 1e-15)) {
      c.fog.density = dense > 2 * thin ? std::sqrt(dense * thin) : (dense + thin) / 2;
      (is_falling<long double>(c.attenuation, c.fog, border) ? dense : thin) = c.fog.density;
    }
    c.fog.density *= 1 + (random.chance(0.5) ? 1 : -1) * random.log_uniform(1e-15, 1e-3);
    return c;
  });
}

TEST(SolveFogIntensity, SolutionIsExactOverSixtyDecades) {
  check_family("C, L, Q, d 1e-30..1e30, t 1e-30..1", [](Random& random, FogMode mode) {
    const auto draw = [&] { return random.log_uniform(1e-30, 1e30); };
    return SolveCase{{draw(), draw(), draw()}, {mode, draw()}, random.log_uniform(1e-30, 0.99)};
  });
}

TEST(SolveFogIntensity, PeakDeepInExp2FogIsExact) {
  const SolveCase by_series{{7293789572571086, 80301.553924085907, 7.4519799684275333e18},
                            {FogMode::exp2, 4785234285130380},
                            1.5195263014755174e-17};
  const SolveCase by_search{{3.5082790427105309e306, 8.2725584139776988e-178, 1.8743626333831283e-58},
                            {FogMode::exp2, 1.1177619980753588e121},
                            1.027774924829295e-308};
  SolveErrors errors(", exp2", "optical depths of 65 and 1,400");
  for (const SolveCase& c : {by_series, by_search}) {
    errors.add(c, solve_reference(c.attenuation, c.fog, c.threshold));
  }
  errors.check();
}

TEST(SolveFogIntensity, SolutionIsExactOverAllDoubles) {
  check_family("C, L, Q, d all doubles, t all below 1", [](Random& random, FogMode mode) {
    const auto draw = [&] { return random.any_positive<double>(); };
    const double linear = random.chance(0.1) ? 0 : draw();
    const double quadratic = linear > 0 && random.chance(0.1) ? 0 : draw();
    double threshold = random.chance(0.3) ? 0.05 : draw();
    while (!(threshold < 1)) threshold = draw();
    const double constant = random.chance(0.3)   ? 0
                            : random.chance(0.5) ? random.log_uniform(1e-3, 1) / threshold
                                                 : draw();
    return SolveCase{{std::min(constant, kMax), linear, quadratic}, {mode, draw()}, threshold};
  });
}

TEST(SolveFogIntensity, SolutionIsExactOverSubnormalParameters) {
  check_family("one of C, L, Q, d, t subnormal", [](Random& random, FogMode mode) {
    SolveCase c = draw_ordinary_case(random, mode);
    double* const fields[] = {&c.attenuation.constant, &c.attenuation.linear, &c.attenuation.quadratic, &c.fog.density,
                              &c.threshold};
    *random.pick(fields) = kDenormMin * std::floor(random.log_uniform(1, 0x1p52));
    return c;
  });
}

TEST(SolveFogIntensity, SolutionIsExactForThresholdsNextToZeroAndOne) {
  check_family("t next to 0 and to 1", [](Random& random, FogMode mode) {
    SolveCase c = draw_ordinary_case(random, mode);
    c.threshold = random.pick(std::array{kDenormMin, std::numeric_limits<double>::min(), 1e-300, 1e-30,
                                         std::nextafter(1.0, 0.0), 1 - 0x1p-52, 1 - 1e-9, 1 - 1e-3});
    if (random.chance(0.5)) c.attenuation.constant = random.uniform(0.9, 1);
    return c;
  });
}

// Where C nears 1/t an extent half an ulp off moves exp2 opacity by an ulp; the residual that leaves C on its side of
// the equation loses the extent's last digits there.
TEST(SolveFogIntensity, SolutionIsExactWhereTheLightIsBarelyAboveItsThreshold) {
  const auto draw = [](Random& random, FogMode mode) {
    SolveCase c = draw_ordinary_case(random, mode);
    const double limit = 1 / c.threshold;
    c.attenuation.constant =
        random.chance(0.5) ? limit * (1 - random.log_uniform(1e-16, 1e-6)) : std::nextafter(limit, 0.0);
    return c;
  };
  check_family("C a few ulp..1e-6 below 1/t", draw, 20000);
}

TEST(SolveFogIntensity, SinglePrecisionSolutionIsTheRoundedDouble) {
  WorstError intensity("intensity, float", "ordinary and all floats", kIntensityMaxUlp<float>);
  WorstError extent_error("extent, float", "ordinary and all floats", kExtentMaxUlp<float>);
  Random random(8);
  for (int i = 0; i < scaled_count(8000); ++i) {
    const FogMode mode = random.pick(kModes);
    const SolveCase drawn = draw_ordinary_case(random, mode);
    const bool is_ordinary = random.chance(0.5);
    const auto narrow = [&](double x) { return is_ordinary ? float(x) : random.any_positive<float>(); };
    const AttenuationF a{narrow(drawn.attenuation.constant), narrow(drawn.attenuation.linear),
                         is_ordinary && drawn.attenuation.linear == 0 ? 0.01f : narrow(drawn.attenuation.quadratic)};
    const FogF fog{mode, narrow(drawn.fog.density)};
    const auto threshold = float(drawn.threshold);
    const SolveCase wide{{a.constant, a.linear, a.quadratic}, {mode, fog.density}, threshold};
    const FogIntensityF solved = solve_fog_intensity(a, fog, threshold);
    const FogIntensity in_double = solve_fog_intensity(wide.attenuation, wide.fog, wide.threshold);
    EXPECT_EQ(solved.intensity, float(in_double.intensity)) << to_string(wide);
    EXPECT_EQ(solved.peak_range, float(in_double.peak_range)) << to_string(wide);
    EXPECT_EQ(solved.extent, float(in_double.extent)) << to_string(wide);
    EXPECT_EQ(solved.status, SolveStatus::ok) << to_string(wide);
    const ReferencePeak reference = solve_reference(wide.attenuation, wide.fog, wide.threshold);
    intensity.add(ulp_error(solved.intensity, reference.intensity), [&] { return to_string(wide); });
    extent_error.add(ulp_error(solved.extent, reference.extent), [&] { return to_string(wide); });
  }
  intensity.check();
  extent_error.check();
}

void expect_peak(const FogIntensity& solved, double intensity, double peak_range, double light_extent) {
  EXPECT_EQ(solved.intensity, intensity);
  EXPECT_EQ(solved.peak_range, peak_range);
  EXPECT_EQ(solved.extent, light_extent);
  EXPECT_EQ(solved.status, SolveStatus::ok);
}

TEST(SolveLimits, ClearAirDoesNotGlow) {
  for (const FogMode mode : kModes) {
    expect_peak(solve_fog_intensity({1, 0.5, 0}, Fog{mode, 0}, 0.25), 0, 0, 6);
    expect_peak(solve_fog_intensity({1, 0, 0}, Fog{mode, 0}, 0.25), 0, 0, kInfinity);
    expect_peak(solve_fog_intensity({1, 0.5, 0}, Fog{mode, -0.0}, 0.25), 0, 0, 6);
  }
}

TEST(SolveLimits, LightBelowItsThresholdEverywhereDoesNotGlow) {
  for (const FogMode mode : kModes) {
    for (const double density : {0.0, 0.01, kInfinity}) {
      expect_peak(solve_fog_intensity({4, 1, 1}, Fog{mode, density}, 0.25), 0, 0, 0);
      expect_peak(solve_fog_intensity({5, 1, 1}, Fog{mode, density}, 0.25), 0, 0, 0);
      expect_peak(solve_fog_intensity({5, 0, 0}, Fog{mode, density}, 0.25), 0, 0, 0);
    }
  }
}

TEST(SolveLimits, ConstantAttenuationPeaksAtInfinity) {
  for (const FogMode mode : kModes) {
    for (const double density : {kDenormMin, 1e-3, 1.0, kMax}) {
      expect_peak(solve_fog_intensity({1, 0, 0}, Fog{mode, density}, 0.05), 1, kInfinity, kInfinity);
      expect_peak(solve_fog_intensity({0.5, 0, 0}, Fog{mode, density}, 0.05), 1, kInfinity, kInfinity);
      expect_peak(solve_fog_intensity({4, 0, 0}, Fog{mode, density}, 0.05), 0.25, kInfinity, kInfinity);
    }
  }
}

TEST(SolveLimits, TotalFogGlowsWithTheAttenuationAtTheLight) {
  for (const FogMode mode : kModes) {
    expect_peak(solve_fog_intensity({4, 0.5, 0}, Fog{mode, kInfinity}, 0.125), 0.25, 0, 8);
    expect_peak(solve_fog_intensity({0.5, 0.25, 0}, Fog{mode, kInfinity}, 0.5), 1, 0, 6);
    expect_peak(solve_fog_intensity({0, 0, 1}, Fog{mode, kInfinity}, 0.25), 1, 0, 2);
    expect_peak(solve_fog_intensity({2, 0, 0}, Fog{mode, kInfinity}, 0.25), 0.5, 0, kInfinity);
  }
}

TEST(SolveLimits, ThinFogPeaksAtTheExtentWithTheThresholdTimesTheOpacity) {
  for (const FogMode mode : kModes) {
    const Fog fog{mode, 1e-9};
    const FogIntensity solved = solve_fog_intensity({1, 0.5, 0}, fog, 0.25);
    EXPECT_EQ(solved.peak_range, 6);
    EXPECT_DOUBLE_EQ(solved.intensity, 0.25 * opacity_at(fog, 6));
  }
}

TEST(SolveLimits, DenseFogPeaksAtTheKneeOfAClampedLight) {
  for (const FogMode mode : kModes) {
    const Fog fog{mode, 10};
    const FogIntensity solved = solve_fog_intensity({0.5, 0.25, 0}, fog, 0.05);
    EXPECT_EQ(solved.peak_range, 2);
    EXPECT_DOUBLE_EQ(solved.intensity, opacity_at(fog, 2));
  }
}

TEST(SolveLimits, PeakOfALinearLightInExpFogIsTheLambertRoot) {
  // D = 1 + L r: the stationary point is where e^x - 1 - x = d / L; here d / L = e - 2, so x = 1.
  const double e = std::exp(1.0);
  const FogIntensity solved = solve_fog_intensity({1, 1, 0}, Fog{FogMode::exp, e - 2}, 0.01);
  EXPECT_NEAR(solved.peak_range * (e - 2), 1, 1e-9);
  EXPECT_DOUBLE_EQ(solved.intensity, (1 - 1 / e) / (1 + 1 / (e - 2)));
}

TEST(SolveLimits, UnitsCancel) {
  for (const FogMode mode : kModes) {
    const FogIntensity metres = solve_fog_intensity({0.75, 0.125, 0.03125}, Fog{mode, 0.25}, 0.05);
    const FogIntensity halves = solve_fog_intensity({0.75, 0.0625, 0.0078125}, Fog{mode, 0.125}, 0.05);
    EXPECT_EQ(halves.intensity, metres.intensity);
    EXPECT_EQ(halves.extent, 2 * metres.extent);
    EXPECT_EQ(halves.peak_range, 2 * metres.peak_range);
  }
}

TEST(SolveFogIntensity, NegativeZeroIsZero) {
  for (const FogMode mode : kModes) {
    for (const double density : {0.0, 1e-40, 0.06, 1e40, kInfinity}) {  // 1e+-40: solved in long double
      for (const Attenuation& a : {Attenuation{0, 0.1, 0.01}, Attenuation{0, 0.1, 0}, Attenuation{0, 0, 0.01},
                                   Attenuation{1, 0, 0.01}, Attenuation{1, 0.1, 0}, Attenuation{0.5, 0, 0}}) {
        const auto negated = [](double x) { return x == 0 ? -0.0 : x; };
        const FogIntensity expected = solve_fog_intensity(a, Fog{mode, density});
        const FogIntensity solved = solve_fog_intensity({negated(a.constant), negated(a.linear), negated(a.quadratic)},
                                                        Fog{mode, negated(density)});
        expect_peak(solved, expected.intensity, expected.peak_range, expected.extent);
      }
    }
  }
}

TEST(SolveFogIntensity, DefaultThresholdIsFivePercent) {
  const Fog fog{FogMode::exp, 0.01};
  EXPECT_EQ(solve_fog_intensity({1, 0.1, 0}, fog).extent, solve_fog_intensity({1, 0.1, 0}, fog, 0.05).extent);
  EXPECT_EQ(solve_fog_intensity({1, 0.1f, 0}, FogF{FogMode::exp, 0.01f}).extent,
            solve_fog_intensity({1, 0.1f, 0}, FogF{FogMode::exp, 0.01f}, 0.05f).extent);
}

/// Steven Hales 2004, "Realtime Pixel Lighting Using Fragment Programs", section "Lighting in Fog", written out: N
/// samples over the extent, the largest kept.
double sample_as_published(const Attenuation& a, const Fog& fog, double light_extent, int samples) {
  double largest = 0;
  for (int i = 1; i <= samples; ++i) {
    const double r = light_extent * i / samples;
    const double depth = fog.mode == FogMode::exp ? fog.density * r : fog.density * fog.density * r * r;
    const double attenuation = std::min(1.0, 1 / (a.constant + a.linear * r + a.quadratic * r * r));
    largest = std::max(largest, -std::expm1(-depth) * attenuation);
  }
  return largest;
}

TEST(SampleFogIntensity, IntensityIsTheLargestSampleAsPublished) {
  Random random(12);
  for (int i = 0; i < 500; ++i) {
    const SolveCase c = draw_ordinary_case(random, random.pick(kModes));
    const int samples = random.pick(std::array{1, 2, 3, 16, 64, 1024});
    const FogIntensity sampled = sample_fog_intensity(c.attenuation, c.fog, c.threshold, samples);
    const double light_extent = compute_extent(c.attenuation, c.threshold);
    EXPECT_EQ(sampled.extent, light_extent);
    EXPECT_EQ(sampled.status, SolveStatus::ok);
    EXPECT_LE(relative_error(sampled.intensity, sample_as_published(c.attenuation, c.fog, light_extent, samples)),
              4e-15)
        << to_string(c) << ", " << samples << " samples";
    const double index = sampled.peak_range / light_extent * samples;
    EXPECT_NEAR(index, std::round(index), 1e-9) << "not the range of a sample";
    EXPECT_TRUE(index > 0.5 && index < samples + 0.5) << index;
    EXPECT_EQ(sampled.intensity,
              opacity_at(c.fog, sampled.peak_range) * attenuation_at(c.attenuation, sampled.peak_range));
  }
}

// The lights are those of the table that games copy (OGRE wiki, "Point Light Attenuation").
TEST(SampleFogIntensity, ErrorOf64SamplesOverGameLightsIsAsStated) {
  constexpr double kLights[][2] = {{.0014, .000007}, {.007, .0002}, {.014, .0007}, {.022, .0019},
                                   {.027, .0028},    {.045, .0075}, {.07, .017},   {.09, .032},
                                   {.14, .07},       {.22, .2},     {.35, .44},    {.7, 1.8}};
  WorstError error("sample_fog_intensity", "64 samples, game lights, V 10..20000", kSampled64MaxError, "absolute");
  for (const FogMode mode : kModes) {
    for (const auto& [linear, quadratic] : kLights) {
      for (double visibility = 10; visibility < 20000; visibility *= 1.05) {
        const SolveCase c{{1, linear, quadratic}, Fog::from_visibility(mode, visibility), kDefaultThreshold};
        const double exact = solve_fog_intensity(c.attenuation, c.fog, c.threshold).intensity;
        const double sampled = sample_fog_intensity(c.attenuation, c.fog, c.threshold, 64).intensity;
        error.add(exact - sampled, [&] { return to_string(c); });
      }
    }
  }
  error.check();
  EXPECT_GT(error.worst(), 0.02) << "it is the reference of error";
}

TEST(SampleFogIntensity, SingleSampleIsAtTheExtent) {
  const FogIntensity sampled = sample_fog_intensity({1, 0.5, 0}, Fog{FogMode::exp, 0.1}, 0.25, 1);
  EXPECT_EQ(sampled.peak_range, 6);
  EXPECT_DOUBLE_EQ(sampled.intensity, 0.25 * -std::expm1(-0.6));
}

TEST(SampleFogIntensity, LimitsAreThoseOfTheExactSolve) {
  for (const FogMode mode : kModes) {
    expect_peak(sample_fog_intensity({1, 0.5, 0}, Fog{mode, 0}, 0.25, 64), 0, 0, 6);
    expect_peak(sample_fog_intensity({4, 1, 1}, Fog{mode, 0.1}, 0.25, 64), 0, 0, 0);
    expect_peak(sample_fog_intensity({4, 0, 0}, Fog{mode, 0.1}, 0.05, 64), 0.25, kInfinity, kInfinity);
    expect_peak(sample_fog_intensity({4, 0.5, 0}, Fog{mode, kInfinity}, 0.125, 64), 0.25, 0, 8);
  }
}

TEST(SolveArguments, ErrorNamesFieldValueAndRule) {
  const auto exact = [](const Attenuation& a, const Fog& fog, double threshold) {
    return error_of([&] { solve_fog_intensity(a, fog, threshold); });
  };
  const auto sampled = [](const Attenuation& a, const Fog& fog, double threshold) {
    return error_of([&] { sample_fog_intensity(a, fog, threshold, 64); });
  };
  const Fog fog{FogMode::exp, 0.01};
  for (const auto& error : {std::function<std::string(const Attenuation&, const Fog&, double)>(exact),
                            std::function<std::string(const Attenuation&, const Fog&, double)>(sampled)}) {
    EXPECT_EQ(error({1, -1, 0}, fog, 0.05), "attenuation.linear = -1: must be finite and >= 0");
    EXPECT_EQ(error({0, 0, 0}, fog, 0.05), "attenuation.constant = 0: must be > 0 where linear and quadratic are 0");
    EXPECT_EQ(error({1, 1, 0}, {FogMode::exp2, -0.5}, 0.05), "fog.density = -0.5: must be >= 0");
    EXPECT_EQ(error({1, 1, 0}, {FogMode::exp2, kNan}, 0.05), "fog.density = nan: must be >= 0");
    EXPECT_EQ(error({1, 1, 0}, fog, 1), "threshold = 1: must be in (0, 1)");
    EXPECT_EQ(error({1, 1, 0}, fog, kNan), "threshold = nan: must be in (0, 1)");
    // A wrong argument is an error in limit cases too.
    EXPECT_EQ(error({1, 0, 0}, fog, 2), "threshold = 2: must be in (0, 1)");
    EXPECT_EQ(error({1, 1, 0}, {FogMode::exp, 0}, 0), "threshold = 0: must be in (0, 1)");
  }
}

TEST(SolveArguments, FewerThanOneSampleIsAnError) {
  const auto error = [](int samples) {
    return error_of([&] { sample_fog_intensity({1, 1, 0}, Fog{FogMode::exp, 0.01}, 0.05, samples); });
  };
  EXPECT_EQ(error(0), "samples = 0: must be >= 1");
  EXPECT_EQ(error(-3), "samples = -3: must be >= 1");
  EXPECT_EQ(error(1), "no error");
}

/// A light of a class that sees less fog than others.
Light runway_light() {
  Light light;
  light.attenuation = {1.5, 0.125, 0.0625};
  light.threshold = 0.01;
  light.density_scale = 0.4;
  return light;
}

TEST(SolveLight, LightSeesTheFogThroughItsDensityScale) {
  const Light light = runway_light();
  const Fog fog{FogMode::exp, 0.05};
  const FogIntensity solved = solve_fog_intensity(light, fog);
  const FogIntensity direct = solve_fog_intensity(light.attenuation, scaled(fog, 0.4), light.threshold);
  expect_peak(solved, direct.intensity, direct.peak_range, direct.extent);
  EXPECT_LT(solved.intensity, solve_fog_intensity(light.attenuation, fog, light.threshold).intensity);
}

TEST(SolveLight, WrongLightOrFogIsAnError) {
  const auto error_after = [](const auto& change) {
    Light light = runway_light();
    Fog fog{FogMode::exp, 1};
    change(light, fog);
    return error_of([&] { solve_fog_intensity(light, fog); });
  };
  EXPECT_EQ(error_after([](Light& light, Fog&) { light.density_scale = -1; }),
            "density_scale = -1: must be finite and >= 0");
  EXPECT_EQ(error_after([](Light& light, Fog&) { light.threshold = 1; }), "threshold = 1: must be in (0, 1)");
  EXPECT_EQ(error_after([](Light& light, Fog&) { light.color.b = -1; }), "color.b = -1: must be finite and >= 0");
  EXPECT_EQ(error_after([](Light&, Fog& fog) { fog.density = kNan; }), "fog.density = nan: must be >= 0");
}

}  // namespace
}  // namespace litfog::test
