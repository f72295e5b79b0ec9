// SPDX-License-Identifier: Apache-2.0
#include "fit/light_target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "command/temporary_directory.h"
#include "fit/light_fit.h"
#include "litfog/color_temperature.h"
#include "litfog/input_error.h"

namespace litfog::test {
using namespace fit;

namespace {

using std::numbers::pi;

/// A round beam of 100 cd on the axis.
constexpr const char* kIes = R"(IESNA:LM-63-2002
[LUMINAIRE] spot
[MANUFAC] maker
TILT=NONE
1 -1 1 4 1 1 2 0 0 0
1 1 10
0 5 10 90
0
100 80 20 0
)";

class LightTargetFile : public testing::Test {
 protected:
  /// The target of a spec with these members from its second line on.
  LightTarget read(const std::string& members) const {
    return read_spec(directory_.write("f.json", "{\"litfog\": \"light-spec\", \"version\": 1,\n" + members + "}"));
  }

  /// The sentence of a call's error, minus the folder.
  template <typename Call>
  std::string error_by(const Call& call) const {
    try {
      call();
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string folder = directory_.path().string() + "/";
      for (auto at = message.find(folder); at != std::string::npos; at = message.find(folder)) {
        message.erase(at, folder.size());
      }
      return message;
    }
    return "(accepted)";
  }

  std::string error_of(const std::string& text) const {
    return error_by([&] { read_spec(directory_.write("f.json", text)); });
  }
  std::string error_with(const std::string& members) const {
    return error_by([&] { read(members); });
  }

  TemporaryDirectory directory_;
};

TEST_F(LightTargetFile, EveryMemberIsRead) {
  const LightTarget target = read(R"("name": "lamp", "source": ["a", "b"],
    "color": [1, 0.5, 0.25], "density_scale": 0.4,
    "source_radius_m": 0.08, "range": {"threshold": 0.1, "extent_m": 120, "constant": 1,
              "samples": [{"range_m": 10, "attenuation": 0.8}, {"range_m": 20, "attenuation": 0.5, "weight": 3}]},
    "cone": {"profile": "smoothstep", "half_angle_deg": 45, "beam_angle_deg": 11, "field_angle_deg": 22,
             "samples": [{"angle_deg": 0, "intensity": 7}, {"angle_deg": 18, "intensity": 2, "weight": 2}]})");
  EXPECT_EQ(target.name, "lamp");
  EXPECT_EQ(target.source, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(target.color, glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(target.density_scale, 0.4);
  EXPECT_EQ(target.source_radius, 0.08);
  EXPECT_EQ(target.source_radius_location.line, 4u);
  ASSERT_TRUE(target.range);
  EXPECT_EQ(target.range->threshold, 0.1);
  EXPECT_EQ(target.range->extent, 120);
  EXPECT_EQ(target.range->constant, 1);
  ASSERT_EQ(target.range->samples.size(), 2u);
  EXPECT_EQ(target.range->samples[0].weight, 1);
  EXPECT_EQ(target.range->samples[1].range, 20);
  EXPECT_EQ(target.range->samples[1].attenuation, 0.5);
  EXPECT_EQ(target.range->samples[1].weight, 3);
  ASSERT_TRUE(target.cone);
  EXPECT_EQ(target.cone->profile, ConeProfile::smoothstep);
  EXPECT_EQ(target.cone->half_angle, pi / 4);
  EXPECT_DOUBLE_EQ(*target.cone->beam_angle, 11 * pi / 180);
  EXPECT_DOUBLE_EQ(*target.cone->field_angle, 22 * pi / 180);
  ASSERT_EQ(target.cone->samples.size(), 2u);
  EXPECT_DOUBLE_EQ(target.cone->samples[1].angle, pi / 10);
  EXPECT_EQ(target.cone->samples[1].intensity, 2);
  EXPECT_EQ(target.cone->samples[1].weight, 2);
  EXPECT_FALSE(target.luminaire);
}

TEST_F(LightTargetFile, ProfileOfTheCallerWins) {
  const std::string path = directory_.write(
      "f.json", R"({"litfog": "light-spec", "version": 1, "cone": {"profile": "cosine", "beam_angle_deg": 9}})");
  EXPECT_EQ(read_spec(path).cone->profile, ConeProfile::cosine);
  EXPECT_EQ(read_spec(path, {.profile = std::optional<ConeProfile>()}).cone->profile, std::nullopt);
}

TEST_F(LightTargetFile, PhotometryIsRelativeToTheSpecAndGivesAnExtent) {
  directory_.write("lamp.ies", kIes);
  const LightTarget target = read(R"("cone": {"photometry": "lamp.ies"}, "color": [1, 0, 0])");
  ASSERT_TRUE(target.luminaire);
  ASSERT_EQ(target.cone->samples.size(), 5u) << "and dark at 180 degrees";
  EXPECT_DOUBLE_EQ(target.cone->samples[1].angle, pi / 36);
  EXPECT_NEAR(target.cone->samples[1].intensity, 80, 1e-12);
  EXPECT_EQ(target.cone->samples[1].weight, 1);
  EXPECT_DOUBLE_EQ(*target.range->extent, std::sqrt(95)) << "20 lx / 100 cd is Q";
  EXPECT_NE(target.derived.back().find("sqrt((1 - 0.05) * 100 cd / 1 lx) = 9.74679 m"), std::string::npos);
  const LightTarget given = read(R"("cone": {"photometry": "lamp.ies"}, "range": {"extent_m": 7})");
  EXPECT_EQ(given.range->extent, 7);
  EXPECT_TRUE(given.source.empty());
}

TEST_F(LightTargetFile, LightHasTheCandelaAndTheEndThatAreStated) {
  const auto expect_light = [this](const std::string& range, double peak, double end) {
    const LightTarget target = read(R"("color": [2, 0.5, 0], "range": {)" + range + "}");
    const Light light = fit_light(target).light;
    EXPECT_NEAR(candela(light).r / peak, 2, 2 * kLightEndMaxError) << range;
    EXPECT_NEAR(candela(light).g / peak, 0.5, kLightEndMaxError) << range;
    const double extent = compute_extent(light.attenuation, light.threshold);
    EXPECT_NEAR(kWhiteLux * light.color.r * attenuation_at(light.attenuation, extent) / end, 2, 1e-12) << range;
  };
  expect_light(R"("peak_cd": 400)", 400, 1);
  expect_light(R"("peak_cd": 400, "end_lx": 4)", 400, 4);
  expect_light(R"("peak_cd": 400, "end_lx": 4, "threshold": 0.2)", 400, 4);
  expect_light(R"("illuminance": {"range_m": 10, "lx": 4})", 400, 1);
  expect_light(R"("illuminance": [{"range_m": 1, "lx": 100}, {"range_m": 2, "lx": 400}])", 400, 1);
  expect_light(R"("peak_cd": 80, "end_lx": "night")", 80, 8e-7);
  expect_light(R"("peak_cd": 10, "end_lx": "bright day")", 10, 1e-3);
  expect_light(R"("flux_lm": 1256.6370614359173, "end_lx": 9)", 100, 9);
}

TEST_F(LightTargetFile, PeakGivesTheExtentAndTheColorInSteps) {
  directory_.write("lamp.ies", kIes);
  const LightTarget night = read(R"("cone": {"photometry": "lamp.ies"},
                                     "range": {"end_lx": 1e-4, "threshold": 0.01})");
  EXPECT_DOUBLE_EQ(*night.range->extent, std::sqrt(0.99e6));
  EXPECT_DOUBLE_EQ(night.size, 5e-4);
  ASSERT_EQ(night.derived.size(), 3u);
  EXPECT_EQ(night.derived[1],
            "Extent: sqrt((1 - 0.01) * 100 cd / 0.0001 lx) = 994.987 m, where the light gives 0.0001 lx, what a pilot "
            "sees by day, commonly given after ICAO Annex 3, attachment D.");
  EXPECT_EQ(night.derived[2], "Color: times 0.0001 lx / (20 lx * 0.01) = 0.0005, because 1 stands for 20 lx.");
  const auto of_range = [this](const char* members) { return error_with("\"range\": {" + std::string(members) + "}"); };
  EXPECT_EQ(of_range(R"("peak_cd": 1e-300)"),
            "f.json:2:22: range.peak_cd = 1e-300: the extent that follows, 9.75e-151 m, must be in [1e-30, 1e30]");
  EXPECT_EQ(of_range(R"("flux_lm": 1e305)").substr(0, 36), "f.json:2:22: range.flux_lm = 1e305: ");
  EXPECT_EQ(of_range(R"("illuminance": {"range_m": 1e200, "lx": 1})"),
            "f.json:2:26: range.illuminance = an object: the extent that follows, inf m, must be in [1e-30, 1e30]");
  EXPECT_EQ(of_range(R"("peak_cd": 1000, "end_lx": 1e-300)"),
            "f.json:2:38: range.end_lx = 1e-300: the extent that follows, 3.08e+151 m, must be in [1e-30, 1e30]");
  EXPECT_EQ(of_range(R"("peak_cd": 1e300, "end_lx": 1e300, "threshold": 1e-12)"),
            "f.json:2:39: range.end_lx = 1e300: the color that follows, times inf, must be finite");
  EXPECT_TRUE(of_range(R"("peak_cd": 1, "threshold": 1)").starts_with("f.json:2:38: range.threshold = 1: must be "));
  EXPECT_EQ(error_with(R"("range": {"end_lx": 1})"),
            "f.json:2:10: range.peak_cd: must be given, or illuminance, flux_lm or the cone's photometry, for "
            "end_lx");
}

TEST_F(LightTargetFile, FluxGivesThePeakByTheConesSolidAngle) {
  const LightTarget point = read(R"("range": {"flux_lm": 1256.6370614359173})");
  EXPECT_DOUBLE_EQ(*point.peak, 100) << "4 pi sr";
  EXPECT_EQ(point.flux, 1256.6370614359173);
  EXPECT_EQ(point.derived.front(),
            "Peak: 1256.64 lm / 12.5664 sr = 100 cd, with the flux of a point light per candela.");

  const LightTarget lamp = read(R"("range": {"flux_lm": 10000, "end_lx": 4},
                                    "cone": {"profile": "cosine", "half_angle_deg": 90, "beam_angle_deg": 120})");
  EXPECT_NEAR(*lamp.peak, 10000 / pi, 1e-6) << "a cosine's solid angle is pi";
  const Light light = fit_light(lamp).light;
  EXPECT_NEAR(flux_within(light.cone, pi) * candela(light).r, 10000, 1e-6) << "the fitted light has the flux";

  directory_.write("lamp.ies", kIes);
  const LightTarget measured = read(R"("cone": {"photometry": "lamp.ies"},
                                        "range": {"flux_lm": 1000})");
  EXPECT_NEAR(luminous_flux(measured.luminaire->distribution), 1000, 1e-9) << "the photometry is scaled";
  EXPECT_DOUBLE_EQ(find_peak(measured.luminaire->distribution).intensity, *measured.peak);
}

TEST_F(LightTargetFile, PhotometryIsScaledToAStatedPeak) {
  directory_.write("lamp.ies", kIes);
  const auto read_range = [this](const std::string& range) {
    return read(R"("cone": {"photometry": "lamp.ies"}, "range": {)" + range + "}");
  };
  for (const char* range : {R"("peak_cd": 400)", R"("illuminance": {"range_m": 2, "lx": 100})"}) {
    const LightTarget target = read_range(range);
    EXPECT_DOUBLE_EQ(find_peak(target.luminaire->distribution).intensity, 400);
    EXPECT_DOUBLE_EQ(*target.light_peak, 400);
    EXPECT_EQ(target.derived[target.derived.size() - 2], "Photometry: times 4, from its peak of 100 cd to 400 cd.");
  }
  EXPECT_EQ(read_range(R"("peak_cd": 100)").derived.size(), 2u) << "the cone's and the extent's: nothing to scale";
  EXPECT_EQ(find_peak(read_range(R"("extent_m": 7)").luminaire->distribution).intensity, 100);
  EXPECT_EQ(error_with(R"("cone": {"photometry": "lamp.ies"}, "range": {"peak_cd": 1e31})"),
            "f.json:2:58: range.peak_cd = 1e31: must have a peak in [1e-30, 1e30] cd");
}

TEST_F(LightTargetFile, EllipticalBeamIsFittedByTheConeOfItsFlux) {
  const LightTarget target = read(R"("cone": {"beam_angle_deg": [24, 6], "field_angle_deg": [48, 12]})");
  EXPECT_NEAR(*target.cone->beam_angle * 180 / pi, 12, 0.1) << "nearly the geometric mean";
  ASSERT_EQ(target.ellipses.size(), 2u);
  EXPECT_EQ(target.derived.front().substr(0, 36), "Beam angle: 24 x 6 deg is 11.9938 de");
  const LightFit fit = fit_light(target);
  ASSERT_TRUE(fit.beam());
  EXPECT_NEAR(luminous_flux(*fit.beam()) / flux_within(fit.light.cone, pi), 1, 0.005);
  EXPECT_GT(fit.target.asymmetry, 0.3);
  const auto at = [&fit](double turn, double angle_deg) {
    return intensity_at(*fit.beam(), direction_of(PhotometryType::c, turn, angle_deg * pi / 180));
  };
  const double half = cone_at(fit.light.cone, std::cos(*target.cone->beam_angle / 2));
  const double tenth = cone_at(fit.light.cone, std::cos(*target.cone->field_angle / 2));
  EXPECT_NEAR(at(0, 12), half, 0.002);
  EXPECT_NEAR(at(pi / 2, 3), half, 0.002);
  EXPECT_NEAR(at(pi, 24), tenth, 0.002);
  EXPECT_NEAR(at(-pi / 2, 6), tenth, 0.002);
}

TEST_F(LightTargetFile, AsymmetryOfAnEllipticalBeamIsThatOfItsShape) {
  const auto asymmetry_of = [this](const std::string& angles) {
    return fit_light(read(R"("cone": {"beam_angle_deg": )" + angles + "}")).target.asymmetry;
  };
  const double of_two = asymmetry_of("[2, 1]");
  EXPECT_GT(of_two, 0.2);
  EXPECT_NEAR(asymmetry_of("[0.002, 0.001]"), of_two, 1e-3);
  EXPECT_NEAR(asymmetry_of("[1, 2]"), of_two, 1e-3) << "turned by 90 degrees";
  EXPECT_NEAR(asymmetry_of("[20, 10]"), of_two, 0.01);
  EXPECT_LT(asymmetry_of("[10, 9.5]"), 0.05);
  EXPECT_LT(asymmetry_of("[360, 1]"), 1) << "as wide as an ellipse can be";
}

TEST_F(LightTargetFile, RoundPairIsARoundBeam) {
  const LightTarget target = read(R"("cone": {"beam_angle_deg": [11, 11], "field_angle_deg": 22})");
  EXPECT_TRUE(target.ellipses.empty());
  EXPECT_FALSE(fit_light(target).beam());
}

TEST_F(LightTargetFile, WrongAnglesOfAnEllipticalBeamAreErrors) {
  EXPECT_EQ(error_with(R"("cone": {"beam_angle_deg": [0, 5]})"),
            "f.json:2:29: cone.beam_angle_deg[0] = 0: must be in (0, 360]");
  EXPECT_EQ(error_with(R"("cone": {"beam_angle_deg": [20, 361]})"),
            "f.json:2:33: cone.beam_angle_deg[1] = 361: must be in (0, 360]");
  EXPECT_EQ(error_with(R"("cone": {"beam_angle_deg": [20, 5], "field_angle_deg": [30, 5]})"),
            "f.json:2:61: cone.field_angle_deg[1] = 5: must be above the beam angle, at most 360");
  EXPECT_EQ(error_with(R"("cone": {"beam_angle_deg": [20, 5], "field_angle_deg": 15})"),
            "f.json:2:56: cone.field_angle_deg = 15: must be above the beam angle, at most 360");
}

TEST_F(LightTargetFile, ColorTemperatureIsTheColor) {
  const LightTarget target = read(R"("color_temperature_k": 3200, "range": {"extent_m": 1})");
  EXPECT_DOUBLE_EQ(luminance(target.color), 1);
  ASSERT_EQ(target.derived.size(), 1u);
  EXPECT_TRUE(target.derived[0].ends_with("linear sRGB of luminance 1.")) << target.derived[0];
}

TEST_F(LightTargetFile, PhotometricFileAloneIsAWhiteLightOfItsName) {
  const LightTarget target = read_photometric_spec(directory_.write("lamp.ies", kIes));
  EXPECT_EQ(target.name, "spot");
  EXPECT_EQ(target.color, glm::dvec3(1));
  EXPECT_EQ(target.light_peak, 100);
  EXPECT_EQ(target.size, 1);
  EXPECT_EQ(target.cone->samples.size(), 5u);
  EXPECT_EQ(target.source, std::vector<std::string>{"lamp.ies: maker"});
  ASSERT_EQ(target.derived.size(), 2u);
}

TEST_F(LightTargetFile, WrongMemberIsAnErrorAtItsLocation) {
  EXPECT_EQ(error_of("{}"), "f.json:1:1: litfog: must be given");
  EXPECT_EQ(error_of(R"({"litfog": "light", "version": 1})"),
            "f.json:1:12: litfog = \"light\": must be \"light-spec\"");
  EXPECT_EQ(error_with("\"name\": \"x\""), "f.json:1:1: range or cone: must be given");
  EXPECT_EQ(error_with("\"beam\": 1"),
            "f.json:2:1: \"beam\": must be one of litfog, version, name, source, color, color_temperature_k, "
            "density_scale, source_radius_m, flash, range, cone");
  EXPECT_EQ(error_with("\"color\": [1, -1, 1], \"range\": {\"extent_m\": 1}"),
            "f.json:2:14: color[1] = -1: must be finite and >= 0");
  EXPECT_EQ(error_with("\"density_scale\": -1, \"range\": {\"extent_m\": 1}"),
            "f.json:2:18: density_scale = -1: must be finite and >= 0");
  EXPECT_EQ(error_with("\"source_radius_m\": -1, \"range\": {\"extent_m\": 1}"),
            "f.json:2:20: source_radius_m = -1: must be finite and >= 0");
  EXPECT_EQ(
      error_with("\"range\": {\"extent\": 1}"),
      "f.json:2:11: \"extent\": must be one of threshold, extent_m, end_lx, peak_cd, illuminance, flux_lm, constant, "
      "family, samples; did you mean extent_m?");
  EXPECT_EQ(error_with("\"cone\": {\"angle\": 1}"),
            "f.json:2:10: \"angle\": must be one of profile, half_angle_deg, beam_angle_deg, field_angle_deg, samples, "
            "photometry");
  EXPECT_EQ(error_with("\"range\": {\"extent_m\": NaN}").substr(0, 12), "f.json:2:23:");
}

TEST_F(LightTargetFile, SourceRadiusIsAsStatedOrOfTheOpeningOrAssumed) {
  const auto radius_of = [this](const std::string& members) { return fit_light(read(members)).light.source_radius; };
  const auto error_of_radius = [&](const std::string& members) { return error_by([&] { radius_of(members); }); };
  const std::string samples = R"("samples": [{"range_m": 1, "attenuation": 0.5}, {"range_m": 2, "attenuation": 0.2}])";
  EXPECT_EQ(radius_of(R"("source_radius_m": 0.3, "range": {"peak_cd": 100})"), 0.3);
  EXPECT_EQ(radius_of(R"("source_radius_m": 0, "range": {"peak_cd": 100})"), 0);
  EXPECT_EQ(radius_of(R"("range": {"peak_cd": 100})"), kDefaultSourceRadius);
  EXPECT_EQ(radius_of(R"("range": {"extent_m": 9})"), kDefaultSourceRadius);
  EXPECT_EQ(radius_of(R"("range": {"extent_m": 9, "family": "linear"})"), 0) << "Q is 0";
  EXPECT_EQ(radius_of(R"("cone": {"beam_angle_deg": 9})"), 0) << "no range";
  EXPECT_EQ(radius_of("\"range\": {" + samples + "}"), 0) << "the table says how bright it is near the lamp";
  EXPECT_EQ(radius_of("\"source_radius_m\": 0.1, \"range\": {" + samples + "}"), 0.1);
  EXPECT_EQ(
      error_of_radius(R"("source_radius_m": 2.5, "range": {"peak_cd": 100})"),
      "f.json:2:20: source_radius_m = 2.5: must be <= sqrt(attenuation.constant / quadratic); C is 1 and Q is 0.2 "
      "/m^2");
  EXPECT_EQ(error_of_radius(R"("source_radius_m": 0.1, "range": {"extent_m": 9, "family": "linear"})"),
            "f.json:2:20: source_radius_m = 0.1: must be 0 where attenuation.quadratic is 0; C is 1 and Q is 0 /m^2");

  std::string lamp = kIes;
  const std::string none = "1 1 2 0 0 0";
  lamp.replace(lamp.find(none), none.size(), "1 1 2 -0.2 -0.2 0");
  directory_.write("lamp.ies", lamp);
  EXPECT_DOUBLE_EQ(radius_of(R"("cone": {"photometry": "lamp.ies"})"), 0.1);
  EXPECT_EQ(radius_of(R"("cone": {"photometry": "lamp.ies"}, "source_radius_m": 0.3)"), 0.3);
  lamp.replace(lamp.find("-0.2 -0.2"), 9, "8 3");
  directory_.write("wide.ies", lamp);
  EXPECT_NEAR(radius_of(R"("cone": {"photometry": "wide.ies"})"), std::sqrt(5), 1e-14) << "100 cd: Q is 0.2";
}

TEST_F(LightTargetFile, RangesThatNoFitTakesAreAnError) {
  const auto with = [this](const std::string& members) { return error_with("\"range\": {" + members + "}"); };
  const auto with_samples = [&with](const std::string& samples) { return with("\"samples\": [" + samples + "]"); };
  const std::string first = "{\"range_m\": 10, \"attenuation\": 0.8}";
  EXPECT_EQ(with(""), "f.json:2:10: range.extent_m: must be given, or peak_cd, illuminance, flux_lm or samples");
  EXPECT_TRUE(with("\"threshold\": 1, \"extent_m\": 9").starts_with("f.json:2:24: range.threshold = 1: must be "));
  EXPECT_TRUE(with("\"extent_m\": -9").starts_with("f.json:2:23: range.extent_m = -9: must be "));
  EXPECT_TRUE(with("\"constant\": -1, \"extent_m\": 9").starts_with("f.json:2:23: range.constant = -1: must be "));
  EXPECT_TRUE(with_samples(first).starts_with("f.json:2:22: range.samples")) << with_samples(first);
  EXPECT_TRUE(with_samples(first + ", {\"range_m\": 20, \"attenuation\": 0}")
                  .starts_with("f.json:2:91: range.samples[1].attenuation = 0: must be "));
  EXPECT_TRUE(with_samples(first + ", {\"range_m\": 20, \"attenuation\": -0.5}")
                  .starts_with("f.json:2:91: range.samples[1].attenuation = -0.5: must be "));
  EXPECT_TRUE(with_samples(first + ", {\"range_m\": 5, \"attenuation\": 0.5}")
                  .starts_with("f.json:2:72: range.samples[1].range_m = 5: must be "));
  EXPECT_TRUE(with_samples(first + ", {\"range_m\": 10, \"attenuation\": 0.5}")
                  .starts_with("f.json:2:72: range.samples[1].range_m = 10: must be "));
  EXPECT_TRUE(with_samples(first + ", {\"range_m\": 20, \"attenuation\": 0.5, \"weight\": -1}")
                  .starts_with("f.json:2:106: range.samples[1].weight = -1: must be "));
  EXPECT_EQ(with_samples("{\"range_m\": 10}"), "f.json:2:23: range.samples[0].attenuation: must be given");
  EXPECT_EQ(with_samples("{\"range_m\": \"10\", \"attenuation\": 1}"),
            "f.json:2:35: range.samples[0].range_m = \"10\": must be a number; write 10, without quotation marks");
}

TEST_F(LightTargetFile, ConesThatNoFitTakesAreAnError) {
  const auto with = [this](const std::string& members) { return error_with("\"cone\": {" + members + "}"); };
  const auto with_samples = [&with](const std::string& samples) { return with("\"samples\": [" + samples + "]"); };
  const std::string first = "{\"angle_deg\": 10, \"intensity\": 1}";
  EXPECT_EQ(with("\"profile\": \"round\""),
            "f.json:2:21: cone.profile = \"round\": must be one of best, cosine, smoothstep");
  const std::string lacking = "cone.beam_angle_deg: must be given, or field_angle_deg, samples or photometry";
  EXPECT_EQ(with(""), "f.json:2:9: " + lacking);
  EXPECT_EQ(with("\"half_angle_deg\": 9"), "f.json:2:9: " + lacking);
  EXPECT_EQ(with_samples(""), "f.json:2:21: " + lacking);
  EXPECT_EQ(with_samples(first),
            "f.json:2:21: cone.samples = 1: must be at least two with weight where no beam or field angle is given");
  EXPECT_EQ(with("\"half_angle_deg\": 91, \"beam_angle_deg\": 9"),
            "f.json:2:28: cone.half_angle_deg = 91: must be in (0, 90]");
  EXPECT_EQ(with("\"profile\": \"smoothstep\", \"half_angle_deg\": 181, \"beam_angle_deg\": 9"),
            "f.json:2:53: cone.half_angle_deg = 181: must be in (0, 180]");
  EXPECT_EQ(with("\"beam_angle_deg\": 361"), "f.json:2:28: cone.beam_angle_deg = 361: must be in (0, 360]");
  EXPECT_EQ(with("\"beam_angle_deg\": 20, \"field_angle_deg\": 10"),
            "f.json:2:51: cone.field_angle_deg = 10: must be larger than the beam angle");
  EXPECT_EQ(with_samples(first + ", {\"angle_deg\": 181, \"intensity\": 1}"),
            "f.json:2:71: cone.samples[1].angle_deg = 181: must be in [0, 180]");
  EXPECT_EQ(with_samples(first + ", {\"angle_deg\": 10, \"intensity\": 1}"),
            "f.json:2:71: cone.samples[1].angle_deg = 10: must be larger than the one before");
  EXPECT_EQ(with_samples(first + ", {\"angle_deg\": 20, \"intensity\": -1}"),
            "f.json:2:88: cone.samples[1].intensity = -1: must be finite and >= 0");
  EXPECT_EQ(with_samples("{\"angle_deg\": 0, \"intensity\": 0}, {\"angle_deg\": 20, \"intensity\": 0}"),
            "f.json:2:21: cone.samples.intensity = 0: must be > 0 for one of the samples with weight");
  EXPECT_EQ(with_samples(first + ", {\"angle_deg\": 20, \"intensity\": 1, \"weight\": -1}"),
            "f.json:2:101: cone.samples[1].weight = -1: must be 0 or in [1e-100, 1e100]");
}

TEST_F(LightTargetFile, UnusablePhotometryIsAnError) {
  directory_.write("lamp.ies", kIes);
  directory_.write("broken.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 -1 x\n");
  EXPECT_EQ(error_with(R"("cone": {"photometry": "lamp.ies", "samples": []})"),
            "f.json:2:24: cone.photometry = \"lamp.ies\": must not be given beside samples");
  EXPECT_TRUE(error_with(R"("cone": {"photometry": "broken.ies"})").starts_with("broken.ies:3:6: "))
      << error_with(R"("cone": {"photometry": "broken.ies"})");
  EXPECT_TRUE(
      error_with(R"("cone": {"photometry": "absent.ies"})")
          .starts_with("f.json:2:24: cone.photometry = \"absent.ies\": must be a photometric file: absent.ies: "))
      << error_with(R"("cone": {"photometry": "absent.ies"})");
  directory_.write("tiny.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1e-300 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n100 100\n");
  EXPECT_EQ(error_with(R"("cone": {"photometry": "tiny.ies"})"),
            "tiny.ies:7:1: largest intensity = 1e-298: must give an extent: extent = 9.746794344808963e-150: must be "
            "in [1e-30, 1e30]");
  EXPECT_EQ(error_with(R"("cone": {"photometry": 1})"), "f.json:2:24: cone.photometry = 1: must be a string");
}

}  // namespace

}  // namespace litfog::test
