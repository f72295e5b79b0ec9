// SPDX-License-Identifier: Apache-2.0
#include "scene/file/scene_file.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "command/exit_status.h"
#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "litfog/fog_light_block.h"
#include "litfog/input_error.h"
#include "litfog/photometry/cookie_file.h"

namespace litfog::test {
using namespace scene;
using namespace command;

namespace {

using litfog::PlacedLight;
using scene::bundled_scene_path;
using scene::bundled_scenes;
using scene::read_scene;
using scene::Scene;

class SceneFile : public testing::Test {
 protected:
  /// A scene of which some members are given; the rest is the least that a scene needs.
  Scene read(const std::string& members) const {
    return read_scene(directory_.write("scene.json",
                                       "{\"litfog\": \"scene\", \"version\": 1,\n"
                                       " \"camera\": {\"position\": [0, 1, 5], \"target\": [0, 1, 0]},\n" +
                                           members + "}"));
  }
  /// The sentence without the file's name.
  std::string error_of(const std::string& members) const {
    try {
      read(members);
    } catch (const InputError& bad) {
      const std::string sentence = bad.what();
      return sentence.starts_with(path()) ? sentence.substr(path().size()) : sentence;
    }
    return "no error";
  }
  std::string path() const { return (directory_.path() / "scene.json").string(); }

  litfog::test::TemporaryDirectory directory_;
};

constexpr const char* kLamp = R"("attenuation": {"constant": 1, "quadratic": 0.1})";

TEST_F(SceneFile, BundledScenesAreThere) {
  const auto names = bundled_scenes();
  for (const char* name : {"approach", "breakout", "city", "cookies", "headlights", "lighthouse", "room", "street",
                           "tessellation", "village"}) {
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
  }
}

TEST_F(SceneFile, EveryBundledSceneLoadsWithGeometryLightsAndLayersOrThreeVisibilities) {
  for (const std::string& name : bundled_scenes()) {
    const Scene scene = read_scene(bundled_scene_path(name));
    EXPECT_EQ(scene.name, name);
    EXPECT_FALSE(scene.description.empty()) << name;
    EXPECT_GE(scene.lights.size(), 2u) << name;
    EXPECT_GE(scene.visibilities.size(), scene.atmosphere.profile.count > 0 ? 0u : 3u) << name;
    // The others' lamps stand in the scene: those of `tessellation` are to light what is before them, and no fog.
    if (name == "approach" || name == "cookies" || name == "headlights" || name == "room") {
      EXPECT_TRUE(std::ranges::any_of(scene.lights, &PlacedLight::carried)) << name;
    }
    if (scene.environment.star_brightness > 0 && scene.atmosphere.profile.count == 0) {
      EXPECT_TRUE(std::isfinite(scene.atmosphere.top)) << name;
      EXPECT_GT(scene.atmosphere.top, double(scene.camera.position.y)) << name;
    }
    EXPECT_FALSE(scene.instances.empty()) << name;
    for (const PlacedLight& light : scene.lights) EXPECT_FALSE(find_error(light)) << name << ": " << light.light.name;
  }
}

TEST_F(SceneFile, TheApproachHasOverAThousandLightsAtTheirRealSpacings) {
  const Scene scene = read_scene(bundled_scene_path("approach"));
  EXPECT_GT(scene.lights.size(), 1000u);
  std::vector<double> edges;  // along the right-hand edge of the runway
  for (const PlacedLight& light : scene.lights) {
    if (light.light.name.starts_with("runway edge") && light.position.x > 0) edges.push_back(light.position.z);
  }
  std::ranges::sort(edges);
  ASSERT_GT(edges.size(), 20u);
  for (std::size_t i = 1; i < edges.size(); ++i) EXPECT_NEAR(edges[i] - edges[i - 1], 60, 1e-9);
}

TEST_F(SceneFile, ACookieTakesTheConesPlaceAndIsReadOnceForAllItsLights) {
  const std::string light = std::string("{\"light\": {") + kLamp +
                            R"(, "cone": {"profile": "smoothstep", "inner_deg": 5, "outer_deg": 20}}, "position": )";
  Scene scene = read("\"lights\": [" + light + "[0, 0, 0]}, " + light +
                     R"([1, 0, 0], "cookie": {"pattern": "disco", "roll_deg": 90, "spin_deg_per_s": -180},
                        "repeat": [{"count": 2, "step": [0, 0, 1]}]}, )" +
                     light + R"([2, 0, 0], "cookie": {"pattern": "disco"}}, )" + light +
                     R"([3, 0, 0], "cookie": {"pattern": "beacon"}}], "objects": [])");
  ASSERT_EQ(scene.lights.size(), 5u);
  EXPECT_EQ(scene.lights[0].light.cone.profile, litfog::ConeProfile::smoothstep);
  EXPECT_EQ(scene.cookies.size(), 2u);
  EXPECT_FALSE(scene.cookie_uses.contains(0));
  for (const std::size_t i : {1u, 2u, 3u, 4u}) {
    EXPECT_EQ(scene.lights[i].light.cone.profile, litfog::ConeProfile::none) << i;
    EXPECT_EQ(scene.cookie_uses.at(i).cookie, i == 4 ? 1u : 0u) << i;
  }
  scene::move_to_time(scene, 0.75);
  EXPECT_DOUBLE_EQ(scene.cookie_uses.at(2).roll, glm::radians(90 - 0.75 * 180));
  EXPECT_EQ(scene.cookie_uses.at(3).roll, 0);
  EXPECT_THROW(scene::move_to_time(scene, 1e308), std::invalid_argument);
}

TEST_F(SceneFile, TurningLightTurnsToTheLeftAboutTheVerticalWithTime) {
  Scene scene = read(std::string("\"lights\": [{\"light\": {") + kLamp +
                     R"(}, "position": [0, 9, 0], "direction": [0, -3, -4], "turn_deg_per_s": 30,
                         "repeat": [{"count": 2, "step": [0, 0, 5]}]}, {"light": {)" +
                     kLamp + R"(}, "position": [0, 9, 0], "direction": [0, 0, -1]}], "objects": [])");
  move_to_time(scene, 3);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_NEAR(glm::distance(scene.lights[i].direction, glm::dvec3(-0.8, -0.6, 0)), 0, 1e-15) << i;
  }
  EXPECT_EQ(scene.lights[2].direction, glm::dvec3(0, 0, -1));
  move_to_time(scene, kMaxSeconds);
  EXPECT_FALSE(find_error(scene.lights[0]));
  EXPECT_NE(error_of(std::string("\"lights\": [{\"light\": {") + kLamp +
                     R"(}, "position": [0, 9, 0], "turn_deg_per_s": 3601}], "objects": [])")
                .find("lights[0].turn_deg_per_s = 3601: must be in [-3600, 3600]"),
            std::string::npos);
}

TEST_F(SceneFile, FlashingLightHasTheColourOfTheTime) {
  const std::string text =
      std::string("\"lights\": [{\"light\": {") + kLamp +
      R"(, "flash": {"period_s": 2, "flashes": [{"start_s": 0.5, "duration_s": 0.5, "intensity": 5}]}},
                              "color": [1, 2, 0], "position": [0, 9, 0]}], "objects": [])";
  for (const auto& [seconds, factor] : {std::pair{0.0, 0.0}, {0.75, 5}, {1, 0}, {8.5, 5}}) {
    Scene scene = read(text);
    move_to_time(scene, seconds);
    EXPECT_EQ(lit_light(scene, 0).light.color, factor * glm::dvec3(1, 2, 0)) << seconds;
  }
}

TEST_F(SceneFile, FogHasNoTopAndNoAsymmetryWhereNoneIsStated) {
  const Scene plain = read("\"objects\": []");
  EXPECT_EQ(plain.atmosphere.top, std::numeric_limits<double>::infinity());
  EXPECT_EQ(plain.atmosphere.phase, Phase::droplets(10));
  EXPECT_FALSE(plain.states_phase);
  const Scene stated = read("\"fog_top_m\": -12.5, \"phase_g\": -0.75, \"objects\": []");
  EXPECT_EQ(stated.atmosphere.top, -12.5);
  EXPECT_EQ(stated.atmosphere.phase.first.asymmetry, -0.75);
  EXPECT_EQ(read("\"fog_top_m\": 1e308, \"objects\": []").atmosphere.top, 1e308);
}

TEST_F(SceneFile, LayersAreReadAndChecked) {
  const Scene plain = read("\"objects\": []");
  EXPECT_EQ(plain.atmosphere.profile.count, 0u);
  EXPECT_EQ(suggested_visibility(plain), 200);
  const auto layers = [](const std::string& text) {
    return "\"atmosphere\": {\"layers\": " + text + "}, \"objects\": []";
  };
  const Scene layered = read(layers(
      R"([{"top_m": 60, "visibility_m": 150}, {"base_m": 200, "top_m": 300, "transition_m": 40, "visibility_m": 90}])"));
  ASSERT_EQ(layered.layers.size(), 2u);
  EXPECT_EQ(layered.layers[0], (FogLayer{.top = 60, .visibility = 150}));
  EXPECT_EQ(layered.layers[1], (FogLayer{.base = 200, .top = 300, .transition = 40, .visibility = 90}));
  EXPECT_EQ(layered.atmosphere.profile, make_density_profile(layered.layers));
  EXPECT_EQ(suggested_visibility(layered), std::numeric_limits<double>::infinity());

  EXPECT_EQ(error_of("\"atmosphere\": {\"layer\": []}, \"objects\": []").substr(0, 6), ":3:16:");
  EXPECT_EQ(error_of(layers(R"([{"base_m": 9, "top_m": 9, "visibility_m": 90}])")),
            ":3:50: atmosphere.layers[0].top_m = 9: must be above the base");
  EXPECT_EQ(error_of(layers(R"([{"visibility_m": 0}])")), ":3:44: atmosphere.layers[0].visibility_m = 0: must be > 0");
  EXPECT_EQ(error_of(layers(R"([{"top_m": 9, "transition_m": -1, "visibility_m": 5}])")),
            ":3:56: atmosphere.layers[0].transition_m = -1: must be finite and >= 0");
  EXPECT_NE(error_of(layers(R"([{"top_m": 9}])")).find("visibility_m"), std::string::npos);
  std::string many;
  for (int i = 0; i < 3; ++i) {
    many += std::string(i > 0 ? "," : "") + "{\"base_m\": " + std::to_string(10 * i) +
            ", \"top_m\": " + std::to_string(10 * i + 1) + ", \"visibility_m\": 9}";
  }
  EXPECT_EQ(error_of(layers("[" + many + "]")).substr(0, 6), ":3:26:");
}

TEST_F(SceneFile, DisplayIsReadAndChecked) {
  EXPECT_EQ(read("\"objects\": []").display, SceneDisplay{});
  EXPECT_EQ(read("\"display\": {\"exposure\": -3.5}, \"objects\": []").display, SceneDisplay{.exposure = -3.5});
  const SceneDisplay automatic =
      read("\"display\": {\"exposure\": \"auto\", \"tone\": \"clip\"}, \"objects\": []").display;
  EXPECT_FALSE(automatic.exposure);
  EXPECT_TRUE(automatic.is_clipped);
  EXPECT_EQ(error_of("\"display\": {\"exposure\": 40}, \"objects\": []"),
            ":3:25: display.exposure = 40: must be in [-32, 32]");
  EXPECT_EQ(error_of("\"display\": {\"exposure\": \"bright\"}, \"objects\": []"),
            ":3:25: display.exposure = \"bright\": must be auto or a number in [-32, 32]");
  EXPECT_EQ(error_of("\"display\": {\"tone\": \"soft\"}, \"objects\": []"),
            ":3:21: display.tone = \"soft\": must be one of neutral, clip");
}

TEST_F(SceneFile, FogTopIsAFiniteNumberAndAsymmetryLiesBetweenMinusOneAndOne) {
  EXPECT_EQ(error_of("\"phase_g\": 1, \"objects\": []"), ":3:12: phase_g = 1: must be in (-1, 1)");
  EXPECT_EQ(error_of("\"phase_g\": -1.0, \"objects\": []"), ":3:12: phase_g = -1.0: must be in (-1, 1)");
  EXPECT_EQ(error_of("\"phase_g\": 0.5, \"atmosphere\": {\"phase\": \"rayleigh\"}, \"objects\": []"),
            ":3:41: atmosphere.phase = \"rayleigh\": must not stand beside phase_g");
  EXPECT_EQ(error_of("\"fog_top_m\": \"high\", \"objects\": []"), ":3:14: fog_top_m = \"high\": must be a number");
  EXPECT_TRUE(error_of("\"fog_top_m\": 1e999, \"objects\": []").starts_with(":3:14: "));
  EXPECT_NE(error_of("\"fog_top_m\": null, \"objects\": []"), "no error");
}

TEST_F(SceneFile, CookieThatIsNoneIsAnError) {
  const auto cookie_error = [&](const std::string& cookie) {
    return error_of(std::string("\"objects\": [], \"lights\": [{\"light\": {") + kLamp +
                    "}, \"position\": [0, 0, 0],\n\"cookie\": " + cookie + "}]");
  };
  EXPECT_EQ(cookie_error(R"({"pattern": "stars"})"),
            ":4:23: lights[0].cookie.pattern = \"stars\": must be disco or beacon");
  EXPECT_EQ(cookie_error(R"({"pattern": "disco", "image": "a.exr"})"),
            ":4:23: lights[0].cookie.pattern = \"disco\": must not stand beside image");
  EXPECT_NE(
      cookie_error(R"({"pattern": "disco", "spin": 3})").find("\"spin\": must be one of image, pattern, roll_deg"),
      std::string::npos);
  EXPECT_NE(cookie_error(R"({"image": "none.exr"})").find("lights[0].cookie.image = \"none.exr\": must be a cookie: "),
            std::string::npos);
  EXPECT_NE(cookie_error(R"({"roll_deg": 3})").find("image"), std::string::npos);
}

class SceneCookieFile : public SceneFile {
 protected:
  /// Texels of six faces in a column as an image of the ending's format.
  void write(const std::string& name, int size) const {
    const std::string path = (directory_.path() / name).string();
    const auto output = OIIO::ImageOutput::create(path);
    const std::vector<float> texels(std::size_t(6 * size * size), 0.25f);
    ASSERT_TRUE(output && output->open(path, OIIO::ImageSpec(size, 6 * size, 1, OIIO::TypeDesc::FLOAT)));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, texels.data()) && output->close());
  }

  /// The members of a scene with a light for each cookie.
  static std::string members(const std::vector<std::string>& files) {
    std::string lights;
    for (const std::string& file : files) {
      lights += (lights.empty() ? "" : ",\n") + std::string("{\"light\": {") + kLamp +
                "}, \"position\": [0, 0, 0], \"cookie\": {\"image\": \"" + file + "\"}}";
    }
    return "\"objects\": [], \"lights\": [" + lights + "]";
  }
};

TEST_F(SceneCookieFile, CookieOfAnotherWriterIsRead) {
  write("a.exr", 5);
  const Scene scene = read(members({"a.exr"}));
  EXPECT_EQ(scene.cookies[0].size, 5);
  EXPECT_EQ(scene.cookies[0].texels, std::vector<float>(150, 0.25f));
}

TEST_F(SceneCookieFile, FormatOtherThanOpenExrIsAnError) {
  write("a.tif", 5);
  EXPECT_NE(error_of(members({"a.tif"})).find("a.tif: cannot be read as OpenEXR: "), std::string::npos);
}

TEST_F(SceneCookieFile, OneFileIsOneCookieHoweverItIsSpelled) {
  write("a.exr", 5);
  std::filesystem::create_symlink("a.exr", directory_.path() / "link.exr");
  const Scene scene = read(members({"a.exr", "./a.exr", "././a.exr", "link.exr"}));
  EXPECT_EQ(scene.lights.size(), 4u);
  EXPECT_EQ(scene.cookies.size(), 1u);
}

TEST_F(SceneCookieFile, CookiesMayHave268435456TexelsTogether) {
  directory_.write("large.exr", format_cookie({.size = 1700, .texels = std::vector<float>(6 * 1700 * 1700, 1.0f)}));
  std::vector<std::string> files{"large.exr"};
  for (int i = 1; i < 16; ++i) write(files.emplace_back("small" + std::to_string(i) + ".exr"), 1);
  EXPECT_EQ(error_of(members(files)),
            ":18:106: lights[15].cookie.image = \"small15.exr\": must leave the scene's cookies, all as large as the "
            "largest, at most 268435456 texels");
}

TEST_F(SceneFile, RepeatMakesACopyOfEachCopyAtEachStep) {
  const Scene scene = read(std::string("\"lights\": [{\"light\": {") + kLamp +
                           "}, \"position\": [1, 2, 3], \"repeat\": [{\"count\": 3, \"step\": [10, 0, 0]},"
                           " {\"count\": 2, \"step\": [0, 0, 5]}]}], \"objects\": []");
  ASSERT_EQ(scene.lights.size(), 6u);
  EXPECT_EQ(scene.lights[0].position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(scene.lights[2].position, glm::dvec3(21, 2, 3));
  EXPECT_EQ(scene.lights[5].position, glm::dvec3(21, 2, 8));
}

TEST_F(SceneFile, AimTurnsIntoAUnitDirection) {
  const Scene scene = read(std::string("\"lights\": [{\"light\": {") + kLamp +
                           "}, \"position\": [0, 3, 0], \"aim\": [0, 0, -4], \"carried\": true}], \"objects\": []");
  EXPECT_NEAR(glm::distance(scene.lights[0].direction, glm::dvec3(0, -0.6, -0.8)), 0, 1e-15);
  EXPECT_TRUE(scene.lights[0].carried);
}

// An aircraft that flies east, nose up, right wing down; its lamp, on the left wing, looks down to the right of the
// nose.
TEST_F(SceneFile, MountedLightStandsAndPointsAsItsVehicleDoes) {
  const Scene scene = read(std::string(R"("vehicle": {"position": [10, 30, -5], "heading_deg": 90, "pitch_deg": 10,
    "roll_deg": 90}, "lights": [{"light": {)") +
                           kLamp + R"(}, "position": [-4, 0, -1],
    "mount": {"azimuth_deg": 90, "elevation_deg": -30}, "carried": true}], "objects": [])");
  const double s = std::sin(glm::radians(10.0)), c = std::cos(glm::radians(10.0));
  const glm::dvec3 nose(c, s, 0), right(s, -c, 0), up(0, 0, 1);  // with the right wing straight down
  const PlacedLight& light = scene.lights[0];
  EXPECT_LT(glm::distance(light.position, glm::dvec3(10, 30, -5) + nose - 4.0 * right), 1e-12);
  const glm::dvec3 expected = std::cos(glm::radians(30.0)) * right - 0.5 * up;
  EXPECT_LT(glm::distance(light.direction, expected), 1e-12);
  EXPECT_EQ(scene.mounts.at(0).vehicle.heading, glm::radians(90.0));
  EXPECT_EQ(scene.mounts.at(0).light.elevation, glm::radians(-30.0));
}

TEST_F(SceneFile, AttitudesThatMakeNoSenseAreErrorsAtTheirMembers) {
  const auto vehicle = [&](const std::string& members) {
    return error_of(R"("objects": [], "vehicle": {"position": [0, 0, 0], )" + members + "}");
  };
  EXPECT_EQ(vehicle(R"("pitch_deg": 91)"), ":3:64: vehicle.pitch_deg = 91: must be in [-90, 90]");
  EXPECT_EQ(vehicle(R"("roll_deg": -181)"), ":3:63: vehicle.roll_deg = -181: must be in [-180, 180]");
  EXPECT_EQ(vehicle(R"("heading_deg": 1e3)"), ":3:66: vehicle.heading_deg = 1e3: must be in [-360, 360]");
  const auto mount = [&](const std::string& before, const std::string& members) {
    return error_of(before + "\n\"lights\": [{\"light\": {" + kLamp + "}, \"position\": [0, 0, 0],\n" + members +
                    "}], \"objects\": []");
  };
  const std::string there = R"("vehicle": {"position": [0, 0, 0]},)";
  EXPECT_EQ(mount(there, R"("mount": {"elevation_deg": 90.5})"),
            ":5:28: lights[0].mount.elevation_deg = 90.5: must be in [-90, 90]");
  EXPECT_EQ(mount(there, R"("mount": {}, "aim": [0, 0, 0])"),
            ":5:21: lights[0].aim = an array: must not stand beside mount");
  EXPECT_EQ(mount("", R"("mount": {})"), ":5:10: lights[0].mount = an object: must be in a scene with a vehicle");
  // Both within the limit, but not the lamp in the world.
  EXPECT_EQ(error_of(R"("vehicle": {"position": [1e7, 0, 0]}, "objects": [], "lights": [{"light": {)" +
                     std::string(kLamp) + "},\n\"mount\": {}, \"position\": [1, 0, 0]}]"),
            ":4:26: lights[0].position = an array: must have coordinates in [-10000000, 10000000] in the world, too");
}

TEST_F(SceneFile, EveryLightIsOneThatTheLibraryTakes) {
  const auto light = [](const std::string& members) { return std::string("{\"light\": {") + kLamp + "}, " + members; };
  const Scene scene = read("\"lights\": [" + light(R"("position": [1e7, -1e7, 1e7], "direction": [1e8, 2e8, 3e8]}, )") +
                           light(R"("position": [0, 0, 0], "direction": [-2e-9, 1e-9, 3e-9], "carried": true}, )") +
                           light(R"("position": [-1e7, -1e7, -1e7], "aim": [1e7, 1e7, 1e7], "color": [0, 1e4, 0]}, )") +
                           light(R"("position": [1, 1, 1], "aim": [1, 1, 1.00000001], "carried": true}, )") +
                           light(R"("position": [0, 0, 0], "cookie": {"pattern": "disco"},
                    "repeat": [{"count": 2, "step": [1e7, 0, 0]}]}], "objects": [])"));
  ASSERT_EQ(scene.lights.size(), 6u);
  for (const PlacedLight& placed : scene.lights) EXPECT_FALSE(find_error(placed)) << to_string(*find_error(placed));
  EXPECT_EQ(error_of("\"lights\": [" + light("\"position\": [0, 0, 0],\n\"direction\": [0, 0, 0]}], \"objects\": []")),
            ":4:14: lights[0].direction = an array: must have a length in (1e-9, 1e9)");
  EXPECT_EQ(error_of("\"lights\": [" + light("\"position\": [4, 5, 6],\n\"aim\": [4, 5, 6]}], \"objects\": []")),
            ":4:8: lights[0].aim = an array: must not be at the light's position");
}

TEST_F(SceneFile, EqualModelsAreMadeOnce) {
  const Scene scene = read(
      "\"objects\": [{\"model\": \"crate\"}, {\"model\": \"crate\", \"position\": [3, 0, 0]},"
      " {\"model\": \"crate\", \"size_m\": 0.5}]");
  EXPECT_EQ(scene.models.size(), 2u);
  EXPECT_EQ(scene.instances.size(), 3u);
}

TEST_F(SceneFile, ErrorNamesLocationValueAndRule) {
  EXPECT_EQ(error_of("\"objects\": [{\"model\": \"crate\", \"size_m\": 99}]"),
            ":3:42: objects[0].size_m = 99: must be in [0.2, 3]");
  EXPECT_EQ(error_of("\"visibilities_m\": [100, -5], \"objects\": []"), ":3:25: visibilities_m[1] = -5: must be > 0");
  EXPECT_EQ(error_of("\"environment\": {\"ambient\": [0, -1, 0]}, \"objects\": []"),
            ":3:28: environment.ambient = an array: must be a colour of numbers in [0, 10000]");
  EXPECT_EQ(error_of("\"objects\": [{\"model\": \"crate\", \"repeat\": [{\"count\": 1e9, \"step\": [1, 0, 0]}]}]"),
            ":3:53: objects[0].repeat[0].count = 1e9: must be in [1, 20000]");
}

TEST_F(SceneFile, UnknownMemberOrModelIsAnError) {
  EXPECT_NE(error_of("\"colour\": 1, \"objects\": []").find(":3:1: \"colour\""), std::string::npos);
  EXPECT_NE(error_of("\"objects\": [{\"model\": \"dragon\"}]").find(":3:23: objects[0].model"), std::string::npos);
  EXPECT_NE(error_of("\"objects\": [{\"model\": \"crate\", \"wings\": 2}]").find("wings"), std::string::npos);
  EXPECT_NE(
      error_of("\"lights\": [{\"light\": \"none.json\", \"position\": [0, 0, 0]}], \"objects\": []").find("none.json"),
      std::string::npos);
}

TEST_F(SceneFile, WhatFloatsCannotDrawIsAnError) {
  const auto error_of_light = [this](const std::string& members) {
    return error_of(std::string("\"objects\": [], \"lights\": [{\"light\": {") + kLamp + members + "}]");
  };
  EXPECT_EQ(error_of_light("}, \"position\": [0, 1e8, 0]").substr(8),
            "lights[0].position = an array: must have coordinates in [-10000000, 10000000]");
  EXPECT_NE(error_of_light("}, \"position\": [0, 0, 0], \"aim\": [1e308, 0, 0]").find("lights[0].aim"),
            std::string::npos);
  EXPECT_NE(error_of_light("}, \"position\": [0, 0, 0], \"direction\": [1e308, 1e308, 0]").find("must have a length"),
            std::string::npos);
  EXPECT_NE(error_of_light("}, \"position\": [0, 0, 0], \"color\": [0, 0, 1e5]").find("must be a colour"),
            std::string::npos);
  EXPECT_NE(error_of_light(", \"color\": [0, 0, 1e300]}, \"position\": [0, 0, 0]").find("lights[0].light.color"),
            std::string::npos);
  EXPECT_NE(error_of_light(", \"density_scale\": 1e300}, \"position\": [0, 0, 0]").find("must be at most 1000000"),
            std::string::npos);
  EXPECT_NE(error_of_light("}, \"position\": [0, 0, 0], \"repeat\": [{\"count\": 9, \"step\": [1e307, 0, 0]}]")
                .find("repeat[0].step"),
            std::string::npos);
  EXPECT_NE(error_of("\"objects\": [{\"model\": \"crate\", \"scatter\": {\"count\": 2, \"area\": [0, 0, 1e300, 1]}}]")
                .find("objects[0].scatter.area[2]"),
            std::string::npos);
}

TEST_F(SceneFile, MoreCarriedLightsThanTheBlockHoldsAreAnError) {
  const auto carried = [this](std::size_t count) {
    return error_of(std::string("\"objects\": [],\n\"lights\": [{\"light\": {") + kLamp +
                    "}, \"position\": [0, 0, 0], \"carried\": true, \"repeat\": [{\"count\": " + std::to_string(count) +
                    ", \"step\": [1, 0, 0]}]}]");
  };
  EXPECT_EQ(carried(litfog::kMaxFogLights), "no error");
  EXPECT_EQ(carried(litfog::kMaxFogLights + 1), ":4:12: lights: must be at most 200 that are carried");
}

TEST_F(SceneFile, MoreObjectsThanTheRendererCanListAreAnError) {
  std::string objects;
  for (int i = 0; i < 3; ++i) {
    objects +=
        std::string(i > 0 ? "," : "") + "{\"model\": \"box\", \"repeat\": [{\"count\": 20000, \"step\": [1, 0, 0]}]}";
  }
  EXPECT_NE(error_of("\"objects\": [" + objects + "]").find("objects: must be at most 50000 with all copies"),
            std::string::npos);
}

TEST_F(SceneFile, MissingLightFileIsAnErrorAtItsLocation) {
  const std::string sentence =
      error_of("\"lights\": [{\"light\": \"none.json\", \"position\": [0, 0, 0]}], \"objects\": []");
  EXPECT_EQ(sentence.find(":3:22: lights[0].light = \"none.json\": must be a light file: "), 0u) << sentence;
  EXPECT_NE(sentence.find("none.json: cannot be read: No such file or directory"), std::string::npos) << sentence;
}

TEST_F(SceneFile, NameThatIsNoFileNameIsAnError) {
  for (const char* name : {"", ".", "..", ".hidden", "a/b", "/etc/passwd", "../up", "a\\u0000b", "a\\nb"}) {
    EXPECT_EQ(error_of(std::string("\"name\": \"") + name + "\", \"objects\": []").substr(0, 14), ":3:9: name = \"")
        << name;
  }
  EXPECT_EQ(error_of("\"name\": \"two words\", \"objects\": []"), "no error");
}

TEST_F(SceneFile, EqualVisibilitiesAreAnError) {
  EXPECT_EQ(error_of("\"visibilities_m\": [100, 50, 1e2], \"objects\": []"),
            ":3:29: visibilities_m[2] = 1e2: must not be given twice");
}

TEST_F(SceneFile, RuleAcrossParametersIsAnErrorAtTheModelsName) {
  EXPECT_EQ(error_of("\"objects\": [{\"model\": \"road\", \"length_m\": 50, \"bend_m\": 100}]").substr(0, 7),
            ":3:23: ");
}

TEST_F(SceneFile, CameraThatLooksStraightUpIsAnError) {
  directory_.write("scene.json", R"({"litfog": "scene", "version": 1,
    "camera": {"position": [0, 1, 5], "target": [0, 9, 5]}, "objects": []})");
  EXPECT_THROW(read_scene(path()), InputError);
}

/// What changes make of a scene of two entries, the first with two copies, of one light file.
class SceneChanges : public SceneFile {
 protected:
  SceneChanges() {
    directory_.write("lamp.json",
                     R"({"litfog": "light", "version": 1, "attenuation": {"constant": 1, "quadratic": 0.1}})");
    directory_.write("scene.json", R"({"litfog": "scene", "version": 1, "objects": [],
      "camera": {"position": [0, 1, 5], "target": [0, 1, 0]},
      "lights": [{"light": "lamp.json", "position": [0, 2, 0], "repeat": [{"count": 2, "step": [1, 0, 0]}]},
                 {"light": "lamp.json", "position": [0, 3, 0], "color": [1, 1, 1]}]})");
  }
  Scene changed(const std::vector<SceneChange>& changes) const { return read_scene(path(), {}, changes); }
  std::string error_of_change(const SceneChange& change) const {
    return sentence_of<InputError>([&] { changed({change}); });
  }
};

TEST_F(SceneChanges, MembersOfALightFileChangeForTheirEntryAlone) {
  const Scene before = changed({});
  const Scene scene = changed({{"lights[0].attenuation.quadratic", "0.5"}, {"lights[0].light.threshold", "0.2"}});
  ASSERT_EQ(scene.lights.size(), 3u);
  for (const std::size_t i : {0u, 1u}) {
    EXPECT_EQ(scene.lights[i].light.attenuation.quadratic, 0.5) << i;
    EXPECT_EQ(scene.lights[i].light.threshold, 0.2) << i;
    EXPECT_EQ(scene.lights[i].light.attenuation.constant, 1) << i;
  }
  EXPECT_EQ(scene.lights[0].light.name, before.lights[0].light.name);
  EXPECT_EQ(scene.lights[0].light.name, "lamp");
  EXPECT_EQ(scene.lights[2].light.attenuation.quadratic, 0.1);
  EXPECT_EQ(scene.lights[2].light.threshold, before.lights[2].light.threshold);
  EXPECT_NE(std::ranges::find(scene.files, (directory_.path() / "lamp.json").string()), scene.files.end());
  EXPECT_EQ(scene.light_members, (std::vector<std::string>{"lights[0]", "lights[1]"}));
  EXPECT_EQ(scene.light_entries, (std::vector<std::size_t>{0, 0, 1}));
}

TEST_F(SceneChanges, MembersOfTheSceneChangeInTheOrderGiven) {
  const Scene scene = changed({{"lights[1].color", "[3, 2, 1]"},
                               {"lights[1].carried", "true"},
                               {"camera.position[0]", "7"},
                               {"camera.field_of_view_deg", "60"},
                               {"environment.stars", "2"},
                               {"phase_g", "0.25"},
                               {"phase_g", "-0.5"},
                               {"name", "other"}});
  EXPECT_EQ(scene.lights[2].light.color, glm::dvec3(3, 2, 1));
  EXPECT_TRUE(scene.lights[2].carried);
  EXPECT_EQ(scene.camera.position, glm::dvec3(7, 1, 5));
  EXPECT_FLOAT_EQ(scene.camera.field_of_view, glm::radians(60.0f));
  EXPECT_EQ(scene.environment.star_brightness, 2);
  EXPECT_EQ(scene.atmosphere.phase.first.asymmetry, -0.5);
  EXPECT_EQ(scene.name, "other");
}

TEST_F(SceneChanges, WordStandsForAString) {
  directory_.write("2.json", R"({"litfog": "light", "version": 1, "attenuation": {"constant": 4}})");
  EXPECT_EQ(changed({{"lights[0].light", "./2.json"}}).lights[0].light.attenuation.constant, 4);
  EXPECT_EQ(changed({{"lights[0].light", "\"2.json\""}}).lights[0].light.attenuation.constant, 4);
  EXPECT_EQ(error_of_change({"lights[0].carried", "yes"}), "--set: lights[0].carried = \"yes\": must be true or false");
}

TEST_F(SceneChanges, PartsThatNoChangeConcernsAreKept) {
  directory_.write("scene.json", R"({"litfog": "scene", "version": 1,
    "camera": {"position": [0, 1, 5], "target": [0, 1, 0]},
    "objects": [{"model": "box", "height_m": 2}, {"model": "spruce"}],
    "lights": [{"light": "lamp.json", "position": [0, 2, 0], "cookie": {"pattern": "disco"}}]})");
  const auto quadratic_and_box = [&](const std::string& quadratic, const std::string& height) {
    return std::vector<SceneChange>{{"lights[0].attenuation.quadratic", quadratic}, {"objects[0].height_m", height}};
  };
  scene::SceneParts kept;
  const Scene first = read_scene(path(), {}, quadratic_and_box("0.2", "2"), &kept);
  const Scene second = read_scene(path(), {}, quadratic_and_box("0.3", "4"), &kept);
  const Scene alone = changed(quadratic_and_box("0.3", "4"));
  EXPECT_EQ(second.lights.at(0).light.attenuation.quadratic, 0.3);
  ASSERT_EQ(second.models.size(), alone.models.size());
  for (std::size_t i = 0; i < alone.models.size(); ++i) {
    EXPECT_EQ(scene::bounds(second.models[i]).high, scene::bounds(alone.models[i]).high) << i;
  }
  EXPECT_NE(scene::bounds(second.models[0]).high, scene::bounds(first.models[0]).high);
  ASSERT_EQ(second.materials.size(), first.materials.size());
  for (std::size_t i = 0; i < first.materials.size(); ++i) {
    EXPECT_EQ(second.materials[i].albedo, first.materials[i].albedo) << "painted again";
  }
  EXPECT_EQ(kept.models.size(), 2u);  // not those of the first reading
}

TEST_F(SceneChanges, WrongChangesNameTheOptionTheMemberAndTheRule) {
  const std::pair<SceneChange, std::string> wrong[] = {
      {{"lights[0].attenuation.quadratic", "-1"},
       "--set: lights[0].light.attenuation.quadratic = -1: must be finite and >= 0"},
      {{"camera.position[1]", "1e9"},
       "--set: camera.position = an array: must have coordinates in [-10000000, 10000000]"},
      {{"lights[2].position", "[0, 0, 0]"}, "--set: lights[2]: is not there: the last one is lights[1]"},
      {{"lights[1].colour", "[1, 1, 1]"},
       "--set: lights[1].colour: \"colour\" must be one of light, position, aim, direction, mount, color, cookie, "
       "turn_deg_per_s, carried, repeat, attenuation, threshold, cone, density_scale; did you mean color?"},
      {{"camera.positon", "[0, 0, 0]"},
       "--set: \"positon\": must be one of position, target, field_of_view_deg; did you mean position?"},
      {{std::string(100'000, 'x'), "1"},
       "--set: \"" + std::string(40, 'x') + "\"...: must be a member such as lights[0].position"},
      {{"lights[0].light", std::string(100'000, 'x')},
       "--set: lights[0].light = \"" + std::string(40, 'x') + "\"...: must be a file's name of at most 4096 bytes"},
      {{"lights[0].color", "[1, 2"}, "--set lights[0].color:1:6: end of file: must be ',' or ']'"}};
  for (const auto& [change, sentence] : wrong) EXPECT_EQ(error_of_change(change), sentence);
  EXPECT_TRUE(
      error_of_change({"lights[0].light", "no.json"}).starts_with("--set: lights[0].light = \"no.json\": must be"));
  directory_.write("lamp.json", "{\n 7}");
  const std::string sentence = error_of_change({"lights[0].threshold", "0.1"});
  EXPECT_NE(sentence.find("scene.json:3:28: lights[0].light = \"lamp.json\": must be a light file: "),
            std::string::npos)
      << sentence;
  EXPECT_THROW(read_scene("a.glb", {}, {{"name", "b"}}), InputError);
}

}  // namespace

}  // namespace litfog::test
