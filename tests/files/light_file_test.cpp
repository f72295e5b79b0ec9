// SPDX-License-Identifier: Apache-2.0
#include "litfog/files/light_file.h"

#include <gtest/gtest.h>

#include <set>

#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "files/angle_deg.h"
#include "files/json_document.h"
#include "files/light_json.h"
#include "litfog/attenuation.h"
#include "litfog/color_temperature.h"
#include "reference/random_light.h"

namespace litfog::test {
using namespace files;

namespace {

using std::numbers::pi;

Light parse(const std::string& text) { return parse_light(parse_json(text, "f")); }

std::string light_file_error(const std::string& text) {
  return sentence_of<InputError>([&] { parse(text); });
}

TEST(LightFile, EveryMemberIsRead) {
  const Light light =
      parse(R"({"litfog": "light", "version": 1, "name": "lamp", "source": ["a", "b"], "color": [1, 0.5, 2],
    "attenuation": {"constant": 0.5, "linear": 0.25, "quadratic": 0.125}, "threshold": 0.01, "density_scale": 0.4,
    "cone": {"profile": "cosine", "half_angle_deg": 45, "exponent": 16}, "fit": {"rms": 0}})");
  EXPECT_EQ(light.name, "lamp");
  EXPECT_EQ(light.color, glm::dvec3(1, 0.5, 2));
  EXPECT_EQ(light.attenuation, (Attenuation{0.5, 0.25, 0.125}));
  EXPECT_EQ(light.threshold, 0.01);
  EXPECT_EQ(light.density_scale, 0.4);
  EXPECT_EQ(light.cone, Cone::cosine(pi / 4, 16));
}

TEST(LightFile, MissingMembersHaveTheModelsDefaults) {
  const Light light = parse(R"({"attenuation": {"linear": 1}})");
  EXPECT_EQ(light.name, "");
  EXPECT_EQ(light.color, glm::dvec3(1));
  EXPECT_EQ(light.attenuation, (Attenuation{0, 1, 0})) << "a coefficient that is not given is 0, the constant too";
  EXPECT_EQ(light.threshold, 0.05);
  EXPECT_EQ(light.density_scale, 1);
  EXPECT_EQ(light.cone.profile, ConeProfile::none);
}

TEST(LightFile, WidestAnglesAreExact) {
  const auto cone_of = [](const std::string& cone) {
    return parse(R"({"attenuation": {"linear": 1}, "cone": )" + cone + "}").cone;
  };
  EXPECT_EQ(cone_of(R"({"profile": "cosine", "half_angle_deg": 90, "exponent": 0})"), Cone::cosine(pi / 2, 0));
  EXPECT_EQ(cone_of(R"({"profile": "smoothstep", "inner_deg": 0, "outer_deg": 180})"), Cone::smoothstep(0, pi));
}

TEST(LightFile, AngleThatFloatsRoundBeyondALimitIsTheLimit) {
  const auto cone_of = [](const std::string& cone) {
    return parse(R"({"attenuation": {"linear": 1}, "cone": )" + cone + "}").cone;
  };
  EXPECT_EQ(cone_of(R"({"profile": "cosine", "half_angle_deg": 90.0000025, "exponent": 0})"), Cone::cosine(pi / 2, 0));
  EXPECT_EQ(cone_of(R"({"profile": "smoothstep", "inner_deg": 0, "outer_deg": 180.00001})"), Cone::smoothstep(0, pi));
  EXPECT_EQ(light_file_error("{\"attenuation\": {\"linear\": 1},\n\"cone\": "
                             R"({"profile": "cosine", "half_angle_deg": 90.00002, "exponent": 0}})"),
            "f:2:49: cone.half_angle_deg = 90.00002: must be in (0, 90]");
}

TEST(LightFile, WrongMemberIsAnErrorAtItsLocationInTheFilesTerms) {
  const auto with = [](const std::string& members) {
    return light_file_error("{\"attenuation\": {\"linear\": 1},\n" + members + "}");
  };
  EXPECT_EQ(light_file_error("{}"), "f:1:1: attenuation: must be given");
  EXPECT_EQ(light_file_error(R"({"attenuation": 1})"), "f:1:17: attenuation = 1: must be an object");
  EXPECT_EQ(light_file_error(R"({"attenuation": {}})"),
            "f:1:17: attenuation.constant = 0: must be > 0 where linear and quadratic are 0");
  EXPECT_EQ(light_file_error(R"({"attenuation": {"constant": 0}})"),
            "f:1:30: attenuation.constant = 0: must be > 0 where linear and quadratic are 0");
  EXPECT_EQ(light_file_error(R"({"attenuation": {"linear": -1}})"),
            "f:1:28: attenuation.linear = -1: must be finite and >= 0");
  EXPECT_EQ(light_file_error(R"({"attenuation": {"square": 1}})"),
            "f:1:18: \"square\": must be one of constant, linear, quadratic");
  EXPECT_EQ(with(R"("threshold": 1)"), "f:2:14: threshold = 1: must be in (0, 1)");
  EXPECT_EQ(with(R"("threshold": null)"), "f:2:14: threshold = null: must be a number");
  EXPECT_EQ(with(R"("color": [1, -0.5, 1])"), "f:2:14: color[1] = -0.5: must be finite and >= 0");
  EXPECT_EQ(with(R"("color": [1, 1])"), "f:2:10: color = an array: must be an array of three numbers");
  EXPECT_EQ(with(R"("density_scale": -1)"), "f:2:18: density_scale = -1: must be finite and >= 0");
  EXPECT_EQ(with(R"("source_radius_m": 1)"), "f:2:20: source_radius_m = 1: must be 0 where attenuation.quadratic is 0");
  const auto with_flash = [&](const std::string& flashes) {
    return with(R"("flash": {"period_s": 2, "flashes": [)" + flashes + "]}");
  };
  EXPECT_EQ(with(R"("flash": {"period_s": 4000, "flashes": [{"start_s": 0, "duration_s": 1}]})"),
            "f:2:23: flash.period_s = 4000: must be in (0, 3600]");
  EXPECT_EQ(with_flash(""), "f:2:37: flash.flashes = an array: must hold 1 to 8 flashes");
  EXPECT_EQ(with_flash(R"({"start_s": 0, "duration_s": 1}, {"start_s": 0.5, "duration_s": 1})"),
            "f:2:83: flash.flashes[1].start_s = 0.5: must be >= 0 and not before the end of the flash before it");
  EXPECT_EQ(with_flash(R"({"start_s": 1.5, "duration_s": 0.6})"),
            "f:2:69: flash.flashes[0].duration_s = 0.6: must end within the period");
  EXPECT_EQ(with_flash(R"({"start_s": 0, "duration_s": 1, "intensity": 0})"),
            "f:2:83: flash.flashes[0].intensity = 0: must be in (0, 1e6]");
  EXPECT_EQ(with_flash(R"({"start_s": 0})"), "f:2:38: flash.flashes[0].duration_s: must be given");
  EXPECT_EQ(with(R"("source": [1])"), "f:2:12: source[0] = 1: must be a string");
  EXPECT_EQ(with(R"("name": 1)"), "f:2:9: name = 1: must be a string");
  EXPECT_TRUE(with(R"("light_point_only": true)").starts_with("f:2:1: \"light_point_only\": must be one of litfog, "));
  EXPECT_EQ(with(R"("litfog": "scene", "version": 1)"), "f:2:11: litfog = \"scene\": must be \"light\"");
  EXPECT_EQ(with(R"("version": 1)"), "f:1:1: litfog: must be given");
}

TEST(LightFile, WrongConeIsAnErrorInDegrees) {
  const auto with = [](const std::string& cone) {
    return light_file_error("{\"attenuation\": {\"linear\": 1},\n\"cone\": " + cone + "}");
  };
  EXPECT_EQ(with("{}"), "f:2:9: cone.profile: must be given");
  EXPECT_EQ(with(R"({"profile": "best"})"), R"(f:2:21: cone.profile = "best": must be one of cosine, smoothstep)");
  EXPECT_EQ(with(R"({"profile": "cosine", "exponent": 1})"), "f:2:9: cone.half_angle_deg: must be given");
  EXPECT_EQ(with(R"({"profile": "cosine", "half_angle_deg": 90.5, "exponent": 1})"),
            "f:2:49: cone.half_angle_deg = 90.5: must be in (0, 90]");
  EXPECT_EQ(with(R"({"profile": "cosine", "half_angle_deg": 9, "exponent": -1})"),
            "f:2:64: cone.exponent = -1: must be finite and >= 0");
  EXPECT_EQ(with(R"({"profile": "smoothstep", "inner_deg": 9, "outer_deg": 9})"),
            "f:2:48: cone.inner_deg = 9: must be in [0, outer_deg)");
  EXPECT_EQ(with(R"({"profile": "smoothstep", "inner_deg": 9, "outer_deg": 181})"),
            "f:2:64: cone.outer_deg = 181: must be in (0, 180]");
  EXPECT_EQ(with(R"({"profile": "cosine", "outer_deg": 9})"),
            "f:2:31: \"outer_deg\": must be one of profile, half_angle_deg, exponent");
}

TEST(LightFile, WrittenLightIsReadBackToTheDigit) {
  Random random(31);
  for (int i = 0; i < 300; ++i) {
    Light light;
    light.name = "lamp \"5\"\n";
    light.color = {random.uniform(0, 1), random.log_uniform(1e-9, 1e9), 1. / 3};
    light.attenuation = {random.uniform(0, 1), random.log_uniform(1e-300, 1e300), random.any_positive<double>()};
    light.threshold = random.uniform(0.001, 0.999);
    light.density_scale = random.chance(0.5) ? 1 : random.uniform(0, 2);
    light.source_radius = random.chance(0.5) ? 0 : random.log_uniform(1e-3, 2);
    if (random.chance(0.5)) light.flash = {2, 2, {{{random.uniform(0, 0.5), 1. / 3, 7}, {1, random.uniform(0.1, 1)}}}};
    const double outer = pi / 180 * random.uniform(0.1, 180);
    if (random.chance(0.4)) light.cone = Cone::smoothstep(random.uniform(0, 0.9) * outer, outer);
    if (random.chance(0.4)) light.cone = Cone::cosine(outer / 2, random.log_uniform(1e-3, 1e5));
    if (find_error(light)) light.source_radius = 0;
    const std::string text = format_light(light, {"a", "\xC3\xA4\\"}, "{\"rms\": 0}");
    Light back = parse(text);
    // A degree is 57 radians: some angles have no double of degrees.
    EXPECT_DOUBLE_EQ(back.cone.half_angle, light.cone.half_angle);
    EXPECT_DOUBLE_EQ(back.cone.inner, light.cone.inner);
    EXPECT_DOUBLE_EQ(back.cone.outer, light.cone.outer);
    back.cone.half_angle = light.cone.half_angle;
    back.cone.inner = light.cone.inner;
    back.cone.outer = light.cone.outer;
    EXPECT_EQ(back.name, light.name);
    EXPECT_EQ(back.color, light.color);
    EXPECT_EQ(back.attenuation, light.attenuation);
    EXPECT_EQ(back.threshold, light.threshold);
    EXPECT_EQ(back.density_scale, light.density_scale);
    EXPECT_EQ(back.source_radius, light.source_radius);
    EXPECT_EQ(back.flash, light.flash);
    EXPECT_EQ(back.cone, light.cone);
    const JsonValue source = parse_json(text, "f").member("source");
    EXPECT_EQ(source.items()[1].string(), "\xC3\xA4\\");
  }
}

TEST(LightFile, WrittenFileIsReadAndAWrongLightLeavesTheEarlierOne) {
  const TemporaryDirectory directory;
  const std::string path = (directory.path() / "lamp.json").string();
  Light light{.name = "lamp", .attenuation = {1, 0, 0.1}, .cone = Cone::cosine(radians(12), 7)};
  write_light(path, light, {"a test"});
  EXPECT_EQ(read_light(path).cone, light.cone);
  EXPECT_EQ(read_json(path).member("source").items()[0].string(), "a test");
  light.threshold = 7;
  EXPECT_THROW(write_light(path, light), std::invalid_argument);
  EXPECT_EQ(read_light(path).threshold, 0.05);
  EXPECT_THROW(write_light((directory.path() / "none/lamp.json").string(), Light{}), OutputError);
}

TEST(LightFile, AnglesAreWrittenInDegreesAsTheyWereGiven) {
  for (const double angle : {5.0, 8.75, 10.5, 17.7, 90.0, 180.0, 0.1, 1e-3}) EXPECT_EQ(degrees(radians(angle)), angle);
  const double between = 0.21029293707130359;  // no double is read back as it
  EXPECT_NE(radians(degrees(between)), between);
  EXPECT_DOUBLE_EQ(radians(degrees(between)), between);
  EXPECT_EQ(shown_degrees(radians(10.6262345)), "10.6262345");  // the quotient is 10.626234500000002
}

TEST(LightFile, FileNeedsItsHeaderAndLendsItsName) {
  const TemporaryDirectory directory;
  const std::string path =
      directory.write("a.lamp.json", R"({"litfog": "light", "version": 1, "attenuation": {"linear": 1}})");
  EXPECT_EQ(read_light(path).name, "a.lamp");
  directory.write("a.lamp.json", R"({"attenuation": {"linear": 1}})");
  EXPECT_EQ(sentence_of<InputError>([&] { read_light(path); }), path + ":1:1: litfog: must be given");
}

// The lights that come with litfog, by the rule that their sources state.
class ShippedLights : public testing::Test {
 protected:
  ShippedLights() {
    for (const auto& entry : std::filesystem::directory_iterator(LITFOG_DATA_DIR "/lights")) {
      if (entry.path().extension() == ".json") paths_.insert(entry.path());
    }
  }
  std::set<std::filesystem::path> paths_;
};

TEST_F(ShippedLights, ShippedLightsAreMany) { EXPECT_GE(paths_.size(), 12u); }

TEST_F(ShippedLights, ShippedLightsHaveUniqueNamesSourcesAndSaneColors) {
  std::set<std::string> names;
  for (const auto& path : paths_) {
    const Light light = read_light(path.string());
    EXPECT_TRUE(names.insert(light.name).second) << path;
    if (light.source_radius > 0) {
      EXPECT_NEAR(luminance(light.color), 1, 2e-4) << path;
    } else {
      EXPECT_EQ(std::max({light.color.r, light.color.g, light.color.b}), 1) << path << ": a published law, not a lamp";
    }
    EXPECT_GE(read_json(path.string()).member("source").items().size(), 3u) << path << ": figure, cone, extent";
  }
}

TEST_F(ShippedLights, QuadraticLightsEndWhereTheirSourceStates) {
  int found = 0;
  for (const auto& path : paths_) {
    const Light light = read_light(path.string());
    if (light.attenuation.linear != 0) continue;
    const std::string rule = read_json(path.string()).member("source").items().back().string();
    const std::string before = "1 lx) = ";
    ASSERT_NE(rule.find(before), std::string::npos) << path;
    const double stated_extent = std::stod(rule.substr(rule.find(before) + before.size()));
    EXPECT_NEAR(compute_extent(light.attenuation, light.threshold), stated_extent, stated_extent * 1e-5) << path;
    ++found;
  }
  EXPECT_GE(found, 12);
}

TEST_F(ShippedLights, ShippedLightsHaveEveryProfileAndALightClampedNearby) {
  std::set<ConeProfile> profiles;
  double least_constant = 1;
  for (const auto& path : paths_) {
    const Light light = read_light(path.string());
    profiles.insert(light.cone.profile);
    least_constant = std::min(least_constant, light.attenuation.constant);
  }
  EXPECT_EQ(profiles.size(), 3u);
  EXPECT_LT(least_constant, 1);
}

}  // namespace

}  // namespace litfog::test
