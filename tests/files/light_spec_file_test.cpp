// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/light_spec_file.h"

#include <gtest/gtest.h>

#include <numbers>

#include "command/temporary_directory.h"
#include "litfog/color_temperature.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

class LightSpecFile : public testing::Test {
 protected:
  /// The spec of a file whose second line holds these members.
  LightSpec read(const std::string& members) const {
    return read_light_spec(
        directory_.write("f.json", "{\"litfog\": \"light-spec\", \"version\": 1,\n" + members + "}"));
  }

  /// Without the folder.
  std::string error_of(const std::string& members) const {
    try {
      read(members);
    } catch (const InputError& error) {
      return without_folder(error);
    }
    return "(accepted)";
  }

  std::string without_folder(const InputError& error) const {
    return std::string(error.what()).substr(directory_.path().string().size() + 1);
  }

  TemporaryDirectory directory_;
};

TEST_F(LightSpecFile, EveryMemberIsReadInSiUnits) {
  const LightSpec spec = read(R"("name": "lamp", "source": ["a", "b"], "color": [1, 0.5, 0.25], "density_scale": 0.4,
    "source_radius_m": 0.08, "range": {"threshold": 0.1, "extent_m": 120, "constant": 1,
              "samples": [{"range_m": 10, "attenuation": 0.8}, {"range_m": 20, "attenuation": 0.5, "weight": 3}]},
    "cone": {"profile": "smoothstep", "half_angle_deg": 45, "beam_angle_deg": 90, "field_angle_deg": 180,
             "samples": [{"angle_deg": 0, "intensity": 7}, {"angle_deg": 18, "intensity": 2, "weight": 2}]})");
  EXPECT_EQ(spec.file, (directory_.path() / "f.json").string());
  EXPECT_EQ(spec.name, "lamp");
  EXPECT_EQ(spec.source, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(spec.color, glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(spec.density_scale, 0.4);
  EXPECT_EQ(spec.source_radius, 0.08);
  ASSERT_TRUE(spec.range);
  EXPECT_EQ(spec.range->threshold, 0.1);
  EXPECT_EQ(spec.range->extent, 120);
  EXPECT_EQ(spec.range->constant, 1);
  ASSERT_EQ(spec.range->samples.size(), 2u);
  EXPECT_EQ(spec.range->samples[0].weight, 1);
  EXPECT_EQ(spec.range->samples[1].range, 20);
  EXPECT_EQ(spec.range->samples[1].attenuation, 0.5);
  EXPECT_EQ(spec.range->samples[1].weight, 3);
  ASSERT_TRUE(spec.cone);
  EXPECT_EQ(spec.cone->profile, ConeProfile::smoothstep);
  EXPECT_EQ(spec.cone->half_angle, pi / 4);
  EXPECT_EQ(spec.cone->beam_angle, pi / 2);
  EXPECT_EQ(spec.cone->field_angle, pi);
  ASSERT_EQ(spec.cone->samples.size(), 2u);
  EXPECT_DOUBLE_EQ(spec.cone->samples[1].angle, pi / 10);
  EXPECT_EQ(spec.cone->samples[1].intensity, 2);
  EXPECT_EQ(spec.cone->samples[1].weight, 2);
  EXPECT_FALSE(spec.cone->photometry);
}

TEST_F(LightSpecFile, MissingMembersHaveTheirDefaults) {
  const LightSpec spec = read(R"("range": {"extent_m": 9})");
  EXPECT_EQ(spec.name, "f");
  EXPECT_TRUE(spec.source.empty());
  EXPECT_EQ(spec.color, glm::dvec3(1));
  EXPECT_EQ(spec.density_scale, 1);
  EXPECT_EQ(spec.source_radius, std::nullopt);
  EXPECT_EQ(spec.range->threshold, 0.05);
  EXPECT_EQ(spec.range->family, RangeSpec::Family::quadratic);
  EXPECT_FALSE(spec.cone);
  EXPECT_EQ(read(R"("cone": {})").cone->profile, std::nullopt);
}

TEST_F(LightSpecFile, PhotometryIsRelativeToTheFile) {
  EXPECT_EQ(read(R"("cone": {"photometry": "a/lamp.ies"})").cone->photometry,
            (directory_.path() / "a/lamp.ies").string());
  EXPECT_EQ(read(R"("cone": {"photometry": "/a/lamp.ies"})").cone->photometry, "/a/lamp.ies");
}

TEST_F(LightSpecFile, UnitsOfDataSheetsAreRead) {
  const LightSpec spec = read(R"("color_temperature_k": 3200,
    "range": {"end_lx": "night", "illuminance": {"range_m": 10, "lx": 120}})");
  EXPECT_EQ(spec.color_temperature, 3200);
  EXPECT_NEAR(luminance(spec.color), 1, 1e-15);
  EXPECT_EQ(spec.color, color_of_temperature(3200) / luminance(color_of_temperature(3200)));
  EXPECT_EQ(spec.range->end_illuminance, 8e-7);
  EXPECT_EQ(spec.range->illuminance, (std::vector{RangeSpec::Illuminance{.range = 10, .lux = 120}}));
  EXPECT_EQ(error_of(R"("color_temperature_k": 900, "range": {"extent_m": 1})"),
            "f.json:2:24: color_temperature_k = 900: must be in [1000, 25000]");
  EXPECT_EQ(error_of(R"("color": [1, 1, 1], "color_temperature_k": 3000, "range": {"extent_m": 1})"),
            "f.json:2:44: color_temperature_k = 3000: must not be given beside color");
  EXPECT_EQ(error_of(R"("range": {"end_lx": "dusk", "peak_cd": 1})"),
            "f.json:2:21: range.end_lx = \"dusk\": must be one of dark night, night, twilight, day, bright day");
  EXPECT_EQ(
      error_of(R"("range": {"end_lx": "nigth", "peak_cd": 1})"),
      "f.json:2:21: range.end_lx = \"nigth\": must be one of dark night, night, twilight, day, bright day; did you "
      "mean night?");
  EXPECT_EQ(error_of(R"("range": {"end_lx": 0, "peak_cd": 1})"), "f.json:2:21: range.end_lx = 0: must be > 0");
  EXPECT_EQ(error_of(R"("range": {"peak_cd": -1})"), "f.json:2:22: range.peak_cd = -1: must be > 0");
  EXPECT_EQ(error_of(R"("range": {"extent_m": 9, "peak_cd": 1})"),
            "f.json:2:23: range.extent_m = 9: must not be given beside end_lx, peak_cd, illuminance or flux_lm");
  EXPECT_EQ(error_of(R"("range": {"peak_cd": 1, "illuminance": {"range_m": 1, "lx": 1}})"),
            "f.json:2:40: range.illuminance = an object: must not be given beside peak_cd");
  EXPECT_EQ(error_of(R"("range": {"illuminance": {"range_m": 1, "lx": 1}, "flux_lm": 9})"),
            "f.json:2:62: range.flux_lm = 9: must not be given beside illuminance");
  EXPECT_EQ(error_of(R"("range": {"flux_lm": 0})"), "f.json:2:22: range.flux_lm = 0: must be > 0");
}

TEST_F(LightSpecFile, IlluminanceMayBeATable) {
  const LightSpec spec = read(R"("range": {"illuminance": [{"range_m": 10, "lx": 9}, {"range_m": 20, "lx": 2}]})");
  EXPECT_EQ(spec.range->illuminance, (std::vector<RangeSpec::Illuminance>{{10, 9}, {20, 2}}));
  for (const char* value : {"[]", "9"}) {
    EXPECT_NE(error_of(R"("range": {"illuminance": )" + std::string(value) + "}")
                  .find("must be an object of range_m and lx, or an array of them, the rows of a table"),
              std::string::npos);
  }
  EXPECT_EQ(error_of(R"("range": {"illuminance": [{"range_m": 10, "lx": 100}, {"range_m": 10, "lx": 25}]})"),
            "f.json:2:67: range.illuminance[1].range_m = 10: must not be the range of a row before it");
}

TEST_F(LightSpecFile, FamilyOfARangeIsChosen) {
  const std::string extent = R"("range": {"extent_m": 9, "family": )";
  EXPECT_EQ(read(extent + R"("linear"})").range->family, RangeSpec::Family::linear);
  EXPECT_EQ(read(extent + R"("mixed"})").range->family, RangeSpec::Family::mixed);
  EXPECT_EQ(error_of(extent + R"("cubic"})"),
            "f.json:2:36: range.family = \"cubic\": must be one of quadratic, linear, mixed");
  EXPECT_EQ(error_of(extent + R"("linear", "samples": [{"range_m": 1, "attenuation": 1}]})"),
            "f.json:2:36: range.family = \"linear\": must not be given beside samples, which choose for themselves");
}

TEST_F(LightSpecFile, ErrorsOfACallerAreInTheFilesTerms) {
  const LightSpec spec = read(R"("range": {"extent_m": 9e0, "samples": [{"range_m": 1, "attenuation": 1}]},
"cone": {"beam_angle_deg": 361, "photometry": "lamp.ies"})");
  const auto error_at = [&](std::string_view field, std::string_view value, std::string_view rule) {
    return without_folder(spec.error_at(field, value, rule));
  };
  EXPECT_EQ(error_at("range.extent", "9", "must be odd"), "f.json:2:23: range.extent_m = 9e0: must be odd");
  EXPECT_EQ(error_at("range.samples[0].range", "1", "must be 0"),
            "f.json:2:52: range.samples[0].range_m = 1: must be 0");
  EXPECT_EQ(error_at("range.samples[0].weight", "1", "must be 2"),
            "f.json:2:40: range.samples[0].weight = 1: must be 2");
  EXPECT_EQ(error_at("range.samples", "1", "must be two"), "f.json:2:39: range.samples = 1: must be two");
  EXPECT_EQ(error_at("range.samples.weight", "0", "must be > 0"), "f.json:2:39: range.samples.weight = 0: must be > 0");
  EXPECT_EQ(error_at("range.constant", "0", "must be 1"), "f.json:2:39: range.constant = 0: must be 1")
      << "at the samples that lack it";
  EXPECT_EQ(error_at("cone.beam_angle", "6.3", "must be in (0, 2 pi]"),
            "f.json:3:28: cone.beam_angle_deg = 361: must be in (0, 360]");
  EXPECT_EQ(error_at("cone.half_angle", "4", "must be in (0, pi/2]"),
            "f.json:3:9: cone.half_angle_deg = 4: must be in (0, 90]");
  EXPECT_EQ(error_at("cone.photometry", "", "must be round"),
            "f.json:3:47: cone.photometry = \"lamp.ies\": must be round");
}

TEST_F(LightSpecFile, ErrorsOfACallerNameEachFieldOfTheRangeAsTheFileDoes) {
  const LightSpec spec = read(R"("range": {"end_lx": 2, "peak_cd": 3e0})");
  EXPECT_EQ(without_folder(spec.error_at("range.end_illuminance", "2", "must be 1")),
            "f.json:2:21: range.end_lx = 2: must be 1");
  EXPECT_EQ(without_folder(spec.error_at("range.peak", "3", "must be 1")),
            "f.json:2:35: range.peak_cd = 3e0: must be 1");
  EXPECT_EQ(without_folder(spec.error_at("range.flux", "4", "must be 1")), "f.json:2:10: range.flux_lm = 4: must be 1");
}

TEST_F(LightSpecFile, AnglesOfAnEllipticalBeamAreTwo) {
  const LightSpec spec =
      read(R"("range": {"flux_lm": 900}, "cone": {"beam_angle_deg": [90, 45], "field_angle_deg": 180})");
  EXPECT_EQ(spec.range->flux, 900);
  EXPECT_EQ(spec.cone->beam_angle, FullAngles(pi / 2, pi / 4));
  EXPECT_EQ(spec.cone->field_angle, FullAngles(pi, pi));
  EXPECT_EQ(
      error_of(R"("cone": {"beam_angle_deg": [1, 2, 3]})"),
      "f.json:2:28: cone.beam_angle_deg = an array: must be a number, or an array of two: horizontal and vertical");
  EXPECT_EQ(error_of(R"("cone": {"beam_angle_deg": [1, "2"]})"),
            "f.json:2:32: cone.beam_angle_deg[1] = \"2\": must be a number; write 2, without quotation marks");
  EXPECT_EQ(error_of(R"("cone": {"field_angle_deg": [9, 8], "photometry": "a.ies"})"),
            "f.json:2:29: cone.field_angle_deg = an array: must be one number beside photometry");
}

}  // namespace
}  // namespace litfog::test
