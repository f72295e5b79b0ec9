// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <set>

#include "command/command_test.h"
#include "command/exit_status.h"
#include "litfog/runway_visual_range.h"
#include "measure/frame_times.h"
#include "reference/srgb.h"
#include "render/plan/lighting_path.h"

namespace litfog::test {
using namespace command;

namespace {

/// Where an error of the arguments sends their reader.
std::string see_help(const std::string& arguments) {
  const std::string job = arguments.substr(0, arguments.find(' '));
  const bool is_job = job == "gallery" || job == "compare" || job == "sequence" || job == "papers" || job == "list";
  return "; see litfog-demo " + (is_job ? job + " " : "") + "--help\n";
}

/// Nothing but black air.
constexpr const char* kEmptyScene = R"({"litfog": "scene", "version": 1, "objects": [],
  "camera": {"position": [0, 1, 5], "target": [0, 1, 0]}})";

class DemoCommand : public CommandTest {
 protected:
  DemoCommand() : CommandTest(LITFOG_DEMO_PATH) {}
  static void SetUpTestSuite() {
    const char* const required = std::getenv("LITFOG_REQUIRE_GL");
    if (required && *required) return;  // each test that draws fails by itself
    const DemoProbe probe;
    probe.write("bare.json", kEmptyScene);
    const Outcome outcome = probe.run("bare.json --size 8x8 -o probe.png");
    missing_ = outcome.status == kMissingCapability ? outcome.err : "";
  }
  void SetUp() override {
    if (!missing_.empty()) GTEST_SKIP() << missing_;
  }

  nlohmann::json json_of(const std::string& name) const { return nlohmann::json::parse(read(name)); }
  OIIO::ImageBuf image(const std::string& name) const { return OIIO::ImageBuf((directory() / name).string()); }
  int sheet_height(const std::string& folder) const { return image(folder + "/contact-sheet.png").spec().height; }
  bool exists(const std::string& name) const { return std::filesystem::exists(directory() / name); }

  /// The picture changes from the first of three times to the second, and is the same again at the third.
  void expect_turn(const std::string& arguments, const std::array<std::string, 3>& times) const {
    std::vector<std::string> pictures;
    for (const std::string& time : times) {
      expect_done(arguments + " -o turn.png --time " + time);
      pictures.push_back(read("turn.png"));
    }
    EXPECT_NE(pictures[0], pictures[1]);
    EXPECT_EQ(pictures[0], pictures[2]);
  }

  void expect_usage(const std::string& arguments, const std::string& sentence) const {
    SCOPED_TRACE(arguments);
    EXPECT_ERROR(run(arguments), kUsage, "litfog-demo: " + sentence + see_help(arguments));
  }

 private:
  /// Runs the command outside of a test.
  class DemoProbe : public CommandTest {
   public:
    DemoProbe() : CommandTest(LITFOG_DEMO_PATH) {}
    using CommandTest::run;
    using CommandTest::write;
    void TestBody() override {}
  };
  static inline std::string missing_;  // what the machine lacks, in words
};

TEST_F(DemoCommand, PngAndExrShowTheSameLight) {
  // By clip, for neutral changes the dark too.
  for (const char* output : {"a.png --exposure 0 --tone clip --glare none", "a.exr"}) {
    expect_done(std::string("tessellation --visibility 200 --size 64x36 -o ") + output);
  }
  OIIO::ImageBuf png = image("a.png");
  OIIO::ImageBuf exr = image("a.exr");
  ASSERT_EQ(png.spec().width, 64);
  ASSERT_EQ(png.spec().height, 36);
  for (int y = 0; y < 36; ++y) {
    for (int x = 0; x < 64; ++x) {
      const double linear = double(exr.getchannel(x, y, 0, 1));
      const double shown = srgb_from_linear(std::min(1.0, linear));
      ASSERT_NEAR(double(png.getchannel(x, y, 0, 1)), shown, 1.5 / 255) << x << ", " << y;
    }
  }
}

TEST_F(DemoCommand, ExposureAndToneAreThePicturesAndNotTheLights) {
  for (const char* options : {"-o a.png", "-o b.png --exposure auto --tone neutral", "-o c.png --exposure 1",
                              "-o d.png --tone clip", "-o e.exr --stats linear.json"}) {
    expect_done(std::string("room --size 32x18 ") + options);
  }
  EXPECT_EQ(read("a.png"), read("b.png"));
  EXPECT_NE(read("a.png"), read("c.png"));
  EXPECT_NE(read("a.png"), read("d.png"));
  EXPECT_FALSE(json_of("linear.json").contains("tone"));
}

TEST_F(DemoCommand, EyesGlareIsThatOfPicturesByAirlightUnlessStated) {
  for (const char* fog_light : {"airlight", "peak"}) {
    const bool has_glare = fog_light == std::string("airlight");
    for (const char* options : {"-o own.png --stats own.json", "-o eye.png --glare eye", "-o none.png --glare none"}) {
      expect_done(fmt::format("room --size 32x18 --exposure auto --fog-light {} {}", fog_light, options));
    }
    EXPECT_EQ(read("own.png"), read(has_glare ? "eye.png" : "none.png")) << fog_light;
    EXPECT_NE(read("eye.png"), read("none.png")) << fog_light;
    EXPECT_EQ(json_of("own.json")["glare"], has_glare ? "eye" : "none");
  }
}

TEST_F(DemoCommand, LightThatHalfFloatsCutOffGlaresTheSameInASequence) {
  const std::string bulb = "--size 32x18 --set lights[0].color=[1e4,1e4,1e4]";
  const std::string in_floats = run("room --visibility 20 -o a.exr " + bulb).out;
  ASSERT_TRUE(has(in_floats, "in 32-bit floats"));
  ASSERT_EQ(run("room --visibility 20 --exposure -6 -o a.png " + bulb).status, kDone);
  ASSERT_EQ(run("sequence room --visibility 400..20 --frames 2 --exposure -6 -o frames " + bulb).status, kDone);
  EXPECT_EQ(read("frames/room-0002.png"), read("a.png"));
}

TEST_F(DemoCommand, AutomaticExposureIsToldAndGivesTheSamePictureWhenGiven) {
  const Outcome outcome = expect_done("room --size 32x18 --exposure auto --tone clip -o a.png --stats s.json");
  const auto stats = json_of("s.json");
  EXPECT_EQ(stats["exposure_auto"], true);
  EXPECT_EQ(stats["tone"], "clip");
  const std::string ev = fmt::format("{}", double(stats["exposure_ev"]));
  EXPECT_NE(ev, "0");
  EXPECT_TRUE(has(outcome.out, "(32x18, EV " + ev + " (auto), tone clip)"));
  ASSERT_EQ(run("room --size 32x18 --tone clip -o b.png --exposure " + ev).status, kDone);
  EXPECT_EQ(read("a.png"), read("b.png"));
}

TEST_F(DemoCommand, WrongExposuresTonesAndGlaresAreErrors) {
  for (const std::string ev : {"bright", "nan", "inf", "-inf", "32.1", "-33", "1e308", "''", "1x", "Auto"}) {
    const std::string shown = ev == "''" ? "\"\"" : ev;
    expect_usage("room -o a.png --exposure " + ev, "--exposure = " + shown + ": must be auto or a number in [-32, 32]");
  }
  for (const std::string job : {"gallery room -o g", "compare room -o g"}) {
    expect_usage(job + " --exposure bright", "--exposure = bright: must be auto or a number in [-32, 32]");
  }
  expect_usage("room --tone filmic", "--tone = filmic: must be one of neutral|clip");
  expect_usage("room --glare night", "--glare = night: must be one of eye|none");
  for (const std::string option : {"--exposure auto", "--tone clip", "--glare eye"}) {
    expect_usage("room -o a.exr " + option, option.substr(0, option.find(' ')) +
                                                " cannot be given with --output a.exr: it holds the scene's light");
  }
  EXPECT_FALSE(exists("g"));
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(DemoCommand, BlackSceneIsBlackAtItsAutomaticExposure) {
  write("dark.json", kEmptyScene);
  ASSERT_EQ(run("dark.json --size 8x8 --exposure auto -o a.png --stats s.json").status, kDone);
  EXPECT_EQ(json_of("s.json")["exposure_ev"], 0);
  OIIO::ImageBuf picture = image("a.png");
  for (int x = 0; x < 8; ++x) EXPECT_LE(picture.getchannel(x, x, 0, 1), 1.0f / 255);  // the dither
}

/// A floor that fills the picture of a camera 12 m above it, and a light 6 m above its middle that shines down.
std::string gltf_floor(const std::string& light) {
  return fmt::format(R"({{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0, 1, 2]}}],
    "nodes": [{{"mesh": 0}},
              {{"translation": [0, 6, -12], "rotation": [-0.70710678, 0, 0, 0.70710678],
                "extensions": {{"KHR_lights_punctual": {{"light": 0}}}}}},
              {{"camera": 0, "translation": [0, 12, 0], "rotation": [-0.38268343, 0, 0, 0.92387953]}}],
    "cameras": [{{"type": "perspective", "perspective": {{"yfov": 0.8, "znear": 0.1}}}}],
    "extensions": {{"KHR_lights_punctual": {{"lights": [{}]}}}},
    "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "material": 0}}]}}],
    "materials": [{{"pbrMetallicRoughness": {{"metallicFactor": 0}}}}],
    "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [-50, 0, -50], "max": [50, 0, 50]}}],
    "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
    "buffers": [{{"byteLength": 36, "uri":
      "data:application/octet-stream;base64,AABIwgAAAAAAAEjCAAAAAAAAAAAAAEhCAABIQgAAAAAAAEjC"}}]}})",
                     light);
}

TEST_F(DemoCommand, GltfOfBlendersLampsAndSunsIsAPictureAndNotWhite) {
  // Blender writes a lamp of 800 W and a sun of 100 W/m^2 so.
  for (const char* light :
       {R"({"type": "point", "intensity": 43481})", R"({"type": "spot", "intensity": 43481, "spot": {}})",
        R"({"type": "directional", "intensity": 68300})"}) {
    write("a.gltf", gltf_floor(light));
    const auto white_fraction = [this](const std::string& file, const std::string& options) {
      expect_done("a.gltf --size 64x36 --stats s.json -o " + file + options);
      OIIO::ImageBuf picture = image(file);
      picture.read(0, 0, true);  // now: OpenImageIO keeps files by their names
      int white = 0;
      for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 64; ++x) white += picture.getchannel(x, y, 0, 1) >= 254.0f / 255;  // less the dither
      }
      return white / (64.0 * 36);
    };
    EXPECT_LE(white_fraction("a.png", " --glare none"), 0.02) << light;  // the lamp and what is below it
    const auto stats = json_of("s.json");
    EXPECT_EQ(stats["exposure_auto"], true) << light;
    EXPECT_LT(stats["exposure_ev"], -2) << light;
    EXPECT_GE(white_fraction("b.png", " --exposure 0 --tone clip"), 0.05) << light;  // which is what it cures
  }
}

TEST_F(DemoCommand, StatisticsStateWhatWasDrawn) {
  ASSERT_EQ(
      run("approach --visibility 200 --fog exp2 --exposure 0 --size 64x36 --frames 3 -o a.png --stats s.json").status,
      kDone);
  const auto stats = json_of("s.json");
  EXPECT_EQ(stats["scene"], "approach");
  EXPECT_EQ(stats["path"], "unified");
  EXPECT_EQ(stats["fog"], "exp2");
  EXPECT_EQ(stats["scattering"], "single");
  EXPECT_EQ(stats["visibility_m"], 200);
  EXPECT_EQ(stats["frames"], 3);
  EXPECT_EQ(stats["samples"], 4);
  EXPECT_GT(stats["lights"], 1000);
  EXPECT_GT(stats["ms_per_frame"]["median"], 0);
  EXPECT_GE(stats["ms_per_frame"]["max"], stats["ms_per_frame"]["min"]);
  EXPECT_GT(stats["chunks_skipped"], 0);
  const auto sum = [&stats](const char* member) {
    std::size_t all = 0;
    for (const auto& [fate, count] : stats[member].items()) all += std::size_t(count);
    return all;
  };
  EXPECT_EQ(sum("lights_by_fate"), stats["lights"]);
  const std::size_t lit = std::size_t(stats["lights"]) - std::size_t(stats["lights_by_fate"]["off"]);
  EXPECT_EQ(sum("airlights"), lit);
  EXPECT_EQ(sum("chunks"), std::size_t(stats["chunks_drawn"]) + std::size_t(stats["chunks_skipped"]));
  EXPECT_EQ(sum("surface_lights"), std::size_t(stats["chunks"]["drawn"]) * lit);
  EXPECT_GT(stats["chunks"]["fog_alone"], 0);  // lamps glow behind them
  for (const char* member : {"lights_by_fate", "surface_lights", "points"}) {
    EXPECT_GT(stats[member]["hidden_by_fog"], 0) << member;
  }
  EXPECT_GT(stats["airlights"]["invisible"], 0);
  EXPECT_GT(stats["points"]["outside_view"], 0);
  EXPECT_EQ(stats["sky"], "drawn");
  EXPECT_GT(stats["lights_per_fragment"], 0.1);
  EXPECT_GT(stats["bytes_uploaded"]["frame"], stats["bytes_uploaded"]["fog_change"]);
  for (const char* stage : {"plan", "surfaces", "sky", "points", "resolve", "airlight"}) {
    EXPECT_GT(stats["ms_by_stage"][stage], 0) << stage;
  }
}

TEST_F(DemoCommand, RunwayVisualRangeIsDrawnAsItsVisibility) {
  const auto visibility_of = [this](const std::string& options) {
    EXPECT_EQ(run("room --size 8x8 -o a.png --stats s.json " + options).status, kDone) << read("err");
    return json_of("s.json")["visibility_m"].get<double>();
  };
  EXPECT_EQ(visibility_of("--rvr 550"), visibility(fog_from_runway_visual_range(FogMode::exp, 550)));
  EXPECT_EQ(visibility_of("--rvr 300 --lamp-cd 5000 --background-cd-m2 100 --fog exp2"),
            visibility(fog_from_runway_visual_range(FogMode::exp2, 300, {5000, illuminance_threshold(100)})));
}

TEST_F(DemoCommand, SamplesAreThoseOfThePictureOrMissing) {
  for (const int samples : {1, 2, 4, 8}) {
    const std::string option = " --samples " + std::to_string(samples);
    const Outcome outcome = run("room --size 64x36 -o a.png --stats s.json" + option);
    if (samples > 4 && outcome.status != kDone) {  // OpenGL guarantees four
      EXPECT_EQ(outcome.status, kMissingCapability);
      EXPECT_TRUE(has(outcome.err, "samples a pixel, not 8"));
      continue;
    }
    ASSERT_EQ(outcome.status, kDone) << outcome.err;
    const int drawn = json_of("s.json")["samples"];
    EXPECT_TRUE(samples == 1 ? drawn == 1 : drawn >= samples) << drawn;
  }
}

TEST_F(DemoCommand, ShadowsAreDrawnByTheLampsThatAreAskedFor) {
  for (const char* options : {"-o none.png", "-o surfaces.png --shadows surfaces --frames 2 --stats s.json",
                              "-o shafts.png --shadows shafts --shadow-lamps 1 --shadow-map-size 256 --stats f.json"}) {
    expect_done(std::string("room --visibility 20 --size 64x36 ") + options);
  }
  EXPECT_NE(read("none.png"), read("surfaces.png"));
  EXPECT_NE(read("surfaces.png"), read("shafts.png"));
  const auto surfaces = json_of("s.json");
  EXPECT_EQ(surfaces["shadow_lamps"], 2);
  EXPECT_EQ(surfaces["shadow_maps"], 7);  // the torch's beam and all around the bulb
  const auto shafts = json_of("f.json");
  EXPECT_EQ(shafts["shadow_lamps"], 1);
  EXPECT_EQ(shafts["shadow_maps"], 1);
}

TEST_F(DemoCommand, MoreShadowsThanMemoryAreAMissingCapability) {
  const Outcome outcome = run("approach --shadows surfaces --shadow-lamps 1000 --size 64x36 -o a.png");
  EXPECT_EQ(outcome.status, kMissingCapability);
  EXPECT_TRUE(has(outcome.err, "the shadows of 1000 lamps and the moon need "));
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(DemoCommand, ShadowsWithoutEffectAreErrors) {
  for (const auto& [options, reason] : std::vector<std::pair<std::string, std::string>>{
           {"--shadow-lamps 3", "--shadow-lamps cannot be given with --shadows none: no lamp casts any"},
           {"--shadow-map-size 64", "--shadow-map-size cannot be given with --shadows none: no lamp casts any"},
           {"--path vertex --shadows surfaces",
            "--shadows cannot be given with --path vertex: its lamps do not light each fragment"},
           {"--path sample --shadows surfaces",
            "--shadows cannot be given with --path sample: it is as its paper prints it"},
           {"--fog-light peak --shadows shafts",
            "--shadows cannot be given with --fog-light peak: only airlight has shafts"},
           {"--path radial --shadows shafts", "--shadows cannot be given with --path radial: only airlight has shafts"},
           {"--shadows surfaces --shadow-lamps 0", "--shadow-lamps = 0: must be an integer from 1 to 100000"},
           {"--shadows surfaces --shadow-map-size 8", "--shadow-map-size = 8: must be an integer from 16 to 8192"}}) {
    expect_usage("room -o a.png " + options, reason);
    EXPECT_FALSE(exists("a.png"));
  }
}

TEST_F(DemoCommand, CityHasTheLightsThatAreAskedFor) {
  ASSERT_EQ(run("city --lights 10 --size 64x36 -o a.png --stats s.json").status, kDone);
  EXPECT_EQ(json_of("s.json")["lights"], 10);
  expect_usage("room --lights 10 -o b.png", "--lights cannot be given with room: it has no generated city");
  EXPECT_FALSE(exists("b.png"));
}

/// A pixel's green of a file of linear light, as a display shows it.
double shown(const OIIO::ImageBuf& image, int x, int y) {
  return srgb_from_linear(std::min(1.0, double(image.getchannel(x, y, 0, 1))));
}

TEST_F(DemoCommand, ReferenceIsTheSamePictureToAStep) {
  for (const char* options : {"-o a.exr", "--reference -o b.exr --stats s.json"}) {
    const Outcome outcome = run(std::string("tessellation --visibility 200 --scattering single --size 64x36 ") +
                                options);  // no lamp in view
    ASSERT_EQ(outcome.status, kDone) << outcome.err;
  }
  OIIO::ImageBuf drawn = image("a.exr");
  OIIO::ImageBuf reference = image("b.exr");
  for (int y = 0; y < 36; ++y) {
    for (int x = 0; x < 64; ++x) ASSERT_NEAR(shown(drawn, x, y), shown(reference, x, y), 1.0 / 255) << x << ", " << y;
  }
  const auto stats = json_of("s.json");
  EXPECT_LT(stats["max_error_255"], 1);
  EXPECT_LE(stats["mean_error_255"], stats["max_error_255"]);
  EXPECT_EQ(stats["excepted_pixels"], 0);
}

// Mesa's environment variable takes the extension away.
TEST_F(DemoCommand, PictureIsTheSameToAStepWithoutClipControl) {
  for (const std::string fog_light : {"airlight", "peak"}) {
    const std::string options = "tessellation --size 64x36 --fog-light " + fog_light;
    ASSERT_EQ(run(options + " -o a.exr").status, kDone);
    ASSERT_EQ(run(options + " -o b.exr", "MESA_EXTENSION_OVERRIDE=-GL_ARB_clip_control").status, kDone);
    const OIIO::ImageBuf with = image("a.exr");
    const OIIO::ImageBuf without = image("b.exr");
    for (int y = 0; y < 36; ++y) {
      for (int x = 0; x < 64; ++x) {
        ASSERT_NEAR(shown(with, x, y), shown(without, x, y), 1.0 / 255) << fog_light << ", " << x << ", " << y;
      }
    }
  }
}

TEST_F(DemoCommand, PictureIsTheSameWithoutDerivativeControl) {
  for (const std::string scene : {"headlights", "street"}) {
    const std::string options = scene + " --visibility 100 --size 161x91";
    ASSERT_EQ(run(options + " -o a.exr").status, kDone);
    ASSERT_EQ(run(options + " -o b.exr", "MESA_EXTENSION_OVERRIDE=-GL_ARB_derivative_control").status, kDone);
    EXPECT_EQ(read("a.exr"), read("b.exr")) << scene;
  }
}

TEST_F(DemoCommand, HeatMapShowsThePathsErrorBesideItsPicture) {
  const Outcome outcome = expect_done("room --path vertex --size 64x36 -o a.png --heat-map h.png --stats s.json");
  EXPECT_TRUE(has(outcome.out, "vertex: largest error "));
  EXPECT_EQ(image("a.png").spec().width, 64);
  EXPECT_EQ(image("h.png").spec().width, 640);
  EXPECT_GT(json_of("s.json")["max_error_255"], 1);
}

TEST_F(DemoCommand, PictureIsTheSameWithAHeatMapBesideIt) {
  ASSERT_EQ(run("headlights --size 64x36 -o a.png").status, kDone);
  ASSERT_EQ(run("headlights --size 64x36 -o b.png --heat-map h.png").status, kDone);
  EXPECT_EQ(read("a.png"), read("b.png"));  // the lamps' points too
}

TEST_F(DemoCommand, MedianOfTwoFramesLiesBetweenThem) {
  ASSERT_EQ(run("room --size 8x8 --frames 2 -o a.png --stats s.json").status, kDone);
  const auto times = json_of("s.json")["ms_per_frame"];
  EXPECT_DOUBLE_EQ(times["median"], (double(times["min"]) + double(times["max"])) / 2);
}

TEST_F(DemoCommand, ListJobNamesPathsAndScenes) {
  const std::string paths = run("list paths").out;
  EXPECT_EQ(paths.substr(0, 8), "unified ");
  EXPECT_EQ(std::ranges::count(paths, '\n'), std::ssize(render::all_paths()));
  for (const auto& path : render::all_paths()) {
    EXPECT_TRUE(has(('\n' + paths), fmt::format("\n{} ", path.name))) << path.name;
  }
  const std::string scenes = run("list scenes").out;
  for (const char* scene : {"approach", "cookies", "headlights", "lighthouse", "room", "street", "tessellation"})
    EXPECT_TRUE(has(scenes, scene));
}

TEST_F(DemoCommand, CookiesTurnWithTime) {
  // The last time is whole turns of the ball, 20 degrees a second, and of the beacon.
  expect_turn("cookies --fog none --size 32x18", {"0", "0.25", "18"});
  EXPECT_EQ(run("cookies --time -1").status, kUsage);
  EXPECT_EQ(run("cookies --time 1e308").status, kUsage);
  expect_usage("room --time 1", "--time cannot be given with room: none of its lights turns or flashes");
}

TEST_F(DemoCommand, BeamOfTheLighthouseTurnsWithTime) {
  expect_turn("lighthouse --fog none --size 160x90", {"0", "1.6", "10"});  // at 1.6 s the beam meets the eye
}

TEST_F(DemoCommand, ContrastGivesTheVisibilityItsMeaning) {
  const double same_fog = 40 * std::log(0.05) / std::log(0.02);
  for (const std::string& options : {std::string("40 --contrast koschmieder -o a.png"),
                                     fmt::format("{} -o b.png", same_fog), std::string("40 -o c.png")}) {
    ASSERT_EQ(run("room --size 32x18 --visibility " + options).status, kDone);
  }
  const auto pixels = [this](const char* name) {
    OIIO::ImageBuf picture = image(name);
    std::vector<float> values(std::size_t(picture.spec().image_pixels()) * 3);
    EXPECT_TRUE(picture.get_pixels(picture.roi(), OIIO::TypeDesc::FLOAT, values.data()));
    return values;
  };
  const std::vector<float> a = pixels("a.png");
  const std::vector<float> b = pixels("b.png");
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 1.5 / 255) << i;
  EXPECT_NE(read("a.png"), read("c.png"));
  EXPECT_EQ(run("room --fog none --contrast mor").status, kUsage);
  EXPECT_EQ(run("room --contrast 1").status, kUsage);
}

TEST_F(DemoCommand, PhaseAsymmetryIsANumberBetweenMinusOneAndOne) {
  ASSERT_EQ(run("room --size 8x8 --phase-g -0.9 -o a.png").status, kDone);
  for (const char* g : {"1", "-1", "nan", "inf", "half"}) {
    expect_usage(std::string("room --phase-g ") + g, std::string("--phase-g = ") + g + ": must be in (-1, 1)");
  }
  EXPECT_EQ(run("room --fog none --phase-g 0.5").status, kUsage);
  EXPECT_EQ(run("gallery room --phase-g 2").status, kUsage);
  EXPECT_EQ(run("compare room --phase-g 2").status, kUsage);
}

TEST_F(DemoCommand, LayersAreReadFromAFileOrLeftOut) {
  write("layers.json", R"([{"top_m": 1, "visibility_m": 5}])");
  write("wrong.json", R"([{"base_m": 2, "top_m": 1, "visibility_m": 5}])");
  const std::string peak = "room --size 16x9 --fog-light peak ";
  ASSERT_EQ(run(peak + "--layers layers.json -o low.exr").status, kDone);
  ASSERT_EQ(run(peak + "--visibility inf --layers none -o clear.exr").status, kDone);
  ASSERT_EQ(run(peak + "--visibility inf -o plain.exr").status, kDone);
  EXPECT_NE(read("low.exr"), read("clear.exr"));
  EXPECT_EQ(read("plain.exr"), read("clear.exr"));
  EXPECT_ERROR(run("room --layers wrong.json"), kBadInput, "wrong.json:1:25: [0].top_m = 1: must be above the base\n");
  write("dense.json", R"([{"top_m": 5, "visibility_m": 1e-300}])");
  EXPECT_ERROR(run("room --layers dense.json"), kBadInput,
               "dense.json:1:31: [0].visibility_m = 1e-300: must be >= 1e-290\n");
  write("high.json", R"([{"top_m": 16777216, "visibility_m": 9}])");
  EXPECT_ERROR(run("room --layers high.json"), kBadInput,
               "high.json:1:12: [0].top_m = 16777216: must be at most 16777216 in magnitude with its transition "
               "band\n");
  expect_usage("room --fog exp2 --layers layers.json",
               "--fog = exp2: must be exp where the air has layers: --layers none draws it without");
  expect_usage("room --rvr 550 --layers layers.json",
               "--rvr = 550: must be in air without layers, which change it: --layers none draws it without");
  expect_usage("village --rvr 550",
               "--rvr = 550: must be in air without layers, which change it: --layers none draws it without");
  EXPECT_EQ(run("room --fog none --layers layers.json").status, kUsage);
  EXPECT_EQ(run("room --layers absent.json").status, kBadInput);
}

TEST_F(DemoCommand, GalleryDrawsEachVisibilityAndASheet) {
  const Outcome outcome = expect_done("gallery room -o pictures --size 64x36 --exposure 0");
  for (const char* name : {"room-clear.png", "room-60m.png", "room-20m.png", "room-6m.png", "contact-sheet.png"}) {
    EXPECT_TRUE(exists(std::string("pictures/") + name)) << name;
  }
  EXPECT_TRUE(has(outcome.out, "intensity"));
  EXPECT_FALSE(has(outcome.out, " s, EV "));
}

TEST_F(DemoCommand, GalleryHasShadowsOnSurfacesUnlessToldOtherwise) {
  for (const std::string option : {"", "--shadows surfaces", "--shadows none"}) {
    ASSERT_EQ(run("gallery room -o 'g" + option + "' --size 64x36 " + option).status, kDone) << option;
  }
  EXPECT_EQ(read("g/room-clear.png"), read("g--shadows surfaces/room-clear.png"));
  EXPECT_NE(read("g/room-clear.png"), read("g--shadows none/room-clear.png"));
}

TEST_F(DemoCommand, GalleryShowsItsFirstSceneByPeakTooUnlessAWayIsChosen) {
  ASSERT_EQ(run("gallery room tessellation -o both --size 64x36").status, kDone);
  ASSERT_EQ(run("gallery room tessellation -o peak --size 64x36 --fog-light peak").status, kDone);
  EXPECT_EQ(read("both/room-peak-20m.png"), read("peak/room-20m.png"));
  EXPECT_NE(read("both/room-20m.png"), read("peak/room-20m.png"));
  EXPECT_EQ(2 * (sheet_height("both") - 8), 3 * (sheet_height("peak") - 8));  // 8: the margin above the first row
  EXPECT_FALSE(exists("both/tessellation-peak-20m.png"));

  for (const std::string option : {"--fog-light peak", "--fog-light airlight", "--path legacy", "--path lookup-2d"}) {
    ASSERT_EQ(run("gallery room -o chosen --size 8x8 " + option).status, kDone) << option;
    EXPECT_FALSE(exists("chosen/room-peak-20m.png")) << option;
  }
}

TEST_F(DemoCommand, GalleryOfAllScenesLeavesTessellationToThePapers) {
  write("taken", "");
  const Outcome outcome = run("gallery -o taken");  // fails before it draws
  EXPECT_EQ(outcome.status, kCannotWrite) << outcome.err;
  const std::string list = run("list scenes").out;
  const auto others = std::ranges::count(list, '\n') - 1;
  EXPECT_TRUE(has(outcome.out, fmt::format("\n{} scenes loaded", others)));
}

TEST_F(DemoCommand, GallerySheetIsTallerByTheLineThatTellsTheDisplay) {
  ASSERT_EQ(run("gallery room -o plain --size 64x36 --exposure 0").status, kDone);
  const Outcome outcome = expect_done("gallery room -o told --size 64x36 --exposure 0.5 --tone clip");
  EXPECT_TRUE(has(outcome.out, " s, EV 0.5, tone clip\n"));
  EXPECT_EQ(sheet_height("told"), sheet_height("plain") + 2 * 20);  // in the row of the room and that by peak
}

TEST_F(DemoCommand, PapersAreFourSheets) {
  const Outcome outcome = expect_done("papers --size 32x18 --frames 1 -o papers");
  for (const char* sheet : {"hales.png", "lacroix.png", "cg.png", "frazier.png"}) {
    EXPECT_TRUE(has(outcome.out, std::string("papers/") + sheet));
    EXPECT_GT(image(std::string("papers/") + sheet).spec().width, 480) << sheet;
  }
  EXPECT_EQ(run("papers --size 8 -o papers").status, kUsage);
}

TEST_F(DemoCommand, ComparisonHasAPageOfEveryPathWithItsPictures) {
  const std::string options = "room --size 64x36 --map-size 16 --fog exp2 --visibility 30 --exposure 0 ";
  expect_done("compare " + options + "-o a/b --frames 2");
  const std::string page = read("a/b/index.html");
  EXPECT_TRUE(has(page, "exp2 fog, visibility 30 m; "));
  std::set<std::string> linked{"index.html"};
  for (const std::string attribute : {" src=\"", " href=\""}) {
    for (auto at = page.find(attribute); at != page.npos; at = page.find(attribute, at + 1)) {
      const auto begin = at + attribute.size();
      const std::string link = page.substr(begin, page.find('"', begin) - begin);
      if (link.front() != '#') linked.insert(link);
    }
  }
  std::set<std::string> written;
  for (const auto& entry : std::filesystem::directory_iterator(directory() / "a/b")) {
    written.insert(entry.path().filename().string());
  }
  EXPECT_EQ(linked, written);
  EXPECT_TRUE(written.contains("room-reference.png"));
  EXPECT_TRUE(written.contains("room-paths.png"));
  for (const auto& path : render::lighting_paths()) {
    EXPECT_TRUE(has(page, fmt::format("<h3>{}</h3>", path.name))) << path.name;
    EXPECT_TRUE(written.contains(fmt::format("room-{}.png", path.name))) << path.name;
    EXPECT_TRUE(written.contains(fmt::format("room-{}-error.png", path.name))) << path.name;
  }

  ASSERT_EQ(run(options + "--path lookup-2d -o a.png --heat-map h.png --stats s.json").status, kDone);
  const auto stats = json_of("s.json");
  const auto figure = page.find("<h3>lookup-2d</h3>");
  const std::string caption = page.substr(figure, page.find("</figure>", figure) - figure);
  for (const char* error : {"max_error_255", "mean_error_255"}) {
    EXPECT_TRUE(has(caption, fmt::format("<dd>{:.3g}</dd>", double(stats[error]))));
  }
  EXPECT_EQ(read("a.png"), read("a/b/room-lookup-2d.png"));
  EXPECT_EQ(read("h.png"), read("a/b/room-lookup-2d-error.png"));
}

TEST_F(DemoCommand, ComparisonShowsAllPathsAtOneExposureAndTellsIt) {
  expect_done("compare room --size 32x18 --map-size 16 -o a --frames 1 --exposure auto --tone clip");
  const std::string page = read("a/index.html");
  const std::string before = "visibility 20 m, EV ";
  const auto at = page.find(before);
  ASSERT_NE(at, std::string::npos);
  const std::string words = page.substr(at + before.size(), page.find(';', at) - at - before.size());
  const std::string ev = words.substr(0, words.find(' '));
  EXPECT_EQ(words, ev + " (auto), tone clip");
  for (const auto& [path, picture] : {std::pair{"unified", "room-unified.png"}, {"vertex", "room-vertex.png"}}) {
    const std::string options = std::string(" --tone clip --path ") + path + " --exposure " + ev;
    ASSERT_EQ(run("room --size 32x18 -o b.png" + options).status, kDone);
    EXPECT_EQ(read("b.png"), read(std::string("a/") + picture)) << path;
    ASSERT_EQ(run("room --size 32x18 --reference -o b.png" + options).status, kDone);
    const std::string reference = std::string("a/room-") + (path == std::string("unified") ? "" : "vertex-");
    EXPECT_EQ(read("b.png"), read(reference + "reference.png")) << path;
  }
}

TEST_F(DemoCommand, WrongUsageOfCompareIsAnError) {
  for (const std::string option :
       {"--path vertex", "--flat-shading", "--set name=a", "--camera 1,2,3", "--target 1,2,3"}) {
    expect_usage("compare room -o c " + option,
                 option.substr(0, option.find(' ')) +
                     " cannot be given with a comparison of lighting paths: settings are given by --with");
  }
  for (const std::string option : {"--gallery", "--reference", "--heat-map h.png", "--stats s.json"}) {
    const Outcome outcome = run("compare room -o c " + option);
    EXPECT_EQ(outcome.status, kUsage) << option;
    const std::string rule = ": must be an option of this command";
    EXPECT_TRUE(has(outcome.err, option.substr(0, option.find(' ')) + rule + see_help("compare ")));
  }
  expect_usage("compare -o ''", "--output = \"\": must not be empty");
  expect_usage("compare room -o c --size 4000x3000",
               "--size = 4000x3000: must be at most 2500000 pixels in all for a comparison");
  EXPECT_EQ(run("compare room -o c --fog none --visibility 5").status, kUsage);
  EXPECT_EQ(run("compare room -o c --time 1").status, kUsage);
  EXPECT_FALSE(exists("c"));
}

TEST_F(DemoCommand, OptionsOfAPictureBeforeAnotherJobAreErrors) {
  for (const auto& [arguments, option] : {std::pair{"room gallery", "SCENE"},
                                          {"--fog exp2 gallery room", "--fog"},
                                          {"--size 8x8 list paths", "--size"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, kUsage) << arguments;
    EXPECT_TRUE(outcome.err.starts_with(std::string("litfog-demo: ") + option + " cannot be given before "))
        << outcome.err;
  }
}

TEST_F(DemoCommand, HelpTeachesEachJob) {
  const Outcome help = expect_done("--help");
  for (const char* part : {"litfog-demo gallery", "litfog-demo compare", "litfog-demo list",
                           "Examples:", "--visibility", "Exit status:"}) {
    EXPECT_TRUE(has(help.out, part));
  }
  std::size_t at = 0;
  for (const char* heading : {"Options:", "Output:", "Scene:", "View:", "Fog:", "Light:", "Display:", "Pixels:"}) {
    const std::size_t next = help.out.find(std::string("\n\n") + heading + "\n", at);
    ASSERT_NE(next, std::string::npos) << heading << help.out;
    at = next;
  }
  for (const auto& [job, part] :
       {std::pair{"gallery", "--path"}, {"compare", "--frames"}, {"papers", "table 1"}, {"list", "scenes|paths"}}) {
    const Outcome own = run(std::string(job) + " --help");
    EXPECT_EQ(own.status, kDone) << job;
    EXPECT_TRUE(has(own.out, part));
  }
}

TEST_F(DemoCommand, WrongUsageIsAnError) {
  for (const char* size :
       {"0x0", "0x10", "100000x100000", "100000x1", "-5x5", "10", "10x", "axb", "10x10x10", "1e3x5"}) {
    const Outcome outcome = run(std::string("room --size ") + size + " -o a.png");
    EXPECT_EQ(outcome.status, kUsage) << size;
    EXPECT_TRUE(has(outcome.err, "must be WIDTHxHEIGHT"));
  }
  expect_usage("room --path phong",
               "--path = phong: must be one of unified|lookup-3d|lookup-2d|radial|radial-plane|"
               "accumulate|vertex|mixed|tangent|legacy|sample|light-map|interpolated|nested|lacroix|parallax|cg|"
               "cook-torrance|anisotropic");
  EXPECT_EQ(run("room --bogus").status, kUsage);
  EXPECT_EQ(run("").status, kUsage);
  EXPECT_EQ(run("room --visibility -1").status, kUsage);
  EXPECT_EQ(run("room --visibility nan").status, kUsage);
  EXPECT_EQ(run("room --frames 0").status, kUsage);
  EXPECT_EQ(run("room -o a.bmp").status, kUsage);
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(DemoCommand, OptionsWithoutEffectAreErrors) {
  for (const std::string option : {"--visibility 50", "--frames 2", "--fog none", "--stats s.json", "--reference",
                                   "--heat-map h.png", "--time 1"}) {
    EXPECT_EQ(run("gallery room -o g " + option).status, kUsage) << option;
  }
  expect_usage("room --samples 3", "--samples = 3: must be one of 1|2|4|8");
  for (const std::string lights : {"0", "-1", "100001", "5.5", "x"}) {
    expect_usage("city --lights " + lights, "--lights = " + lights + ": must be an integer from 1 to 100000");
  }
  expect_usage("room --fog none --visibility 50", "--visibility cannot be given with --fog none: the air is clear");
  expect_usage("room --fog none --rvr 550", "--rvr cannot be given with --fog none: the air is clear");
  expect_usage("room --fog none --scattering all", "--scattering cannot be given with --fog none: the air is clear");
  for (const char* command : {"room", "gallery room -o out"}) {
    expect_usage(std::string(command) + " --fog exp2 --scattering all",
                 "--scattering cannot be given with --fog exp2: only exp fog has all orders");
  }
  expect_usage("room --albedo 0.9 --scattering all",
               "--scattering = all: --albedo must be 1 for all orders of scattering");
  expect_usage("room --phase hg:0.97 --scattering all",
               "--scattering = all: --phase must be of one lobe with alpha 0 and g in [0, 0.95], or of droplets, for "
               "all orders of scattering");
  expect_usage("room --rvr 550 --visibility 50",
               "--visibility cannot be given with --rvr: lamps and threshold give its meaning");
  expect_usage("room --lamp-cd 5", "--lamp-cd cannot be given with the scene's visibility: only --rvr depends on them");
  expect_usage("room --visibility 9 --threshold-lx 1e-4",
               "--threshold-lx cannot be given with --visibility: only --rvr depends on them");
  expect_usage("room --rvr 1001 --lamp-cd 100 --threshold-lx 1e-4",
               "--rvr = 1001: must be at most sqrt(candela / illuminance_threshold), where the lamps are last seen in "
               "clear air");
  expect_usage("list", "WHAT is required");
  expect_usage("list lamps", "WHAT = lamps: must be one of scenes|paths|lights");
  expect_usage("gallery -o ''", "--output = \"\": must not be empty");
  for (const std::string option : {"-o", "--heat-map", "--stats"}) {
    EXPECT_EQ(run("room --size 8x8 " + option + " ''").status, kUsage) << option;
  }
  expect_usage("room --map-size 64", "--map-size cannot be given with --path unified: it has no light maps");
  expect_usage("room --cone-maps even", "--cone-maps cannot be given with --path unified: it has no light maps");
  expect_usage("room --path lookup-3d --cone-maps wide", "--cone-maps = wide: must be one of scaled|even|one-disc");
  expect_usage("room --path lookup-3d --light-ambient 1.1",
               "--light-ambient = 1.1: must be a number in [0, 1]; 1.1 % is 0.011");
  expect_usage("room --path cg --light-ambient 0.1",
               "--light-ambient cannot be given with --path cg: only lookup-3d and lookup-2d have it");
  expect_usage("room --path sample --reference",
               "--reference cannot be given with --path sample: it is one of the papers' programs that have none");
  expect_usage(
      "room --sort-polygons",
      "--sort-polygons cannot be given with --fog-light airlight: its lamps light surfaces beyond their extents");
  expect_usage("papers -o ''", "--output = \"\": must not be empty");
  expect_usage("room --path radial --flat-shading",
               "--flat-shading cannot be given with --path radial: only lookup-3d and lookup-2d have it");
  expect_usage("room --path vertex --fog-light airlight",
               "--fog-light cannot be given with --path vertex: its lamps do not light each fragment");
  expect_usage("room --path tangent --phase-g 0.5",
               "--phase-g cannot be given with --path tangent: only airlight scatters by it");
  expect_usage("room --fog-light peak --phase-g 0.5",
               "--phase-g cannot be given with --fog-light peak: only airlight scatters by it");
  expect_usage("room --path legacy --infinite-viewer",
               "--infinite-viewer cannot be given with --path legacy: it has no highlights");
  expect_usage("gallery room --map-size 64", "--map-size cannot be given with --path unified: it has no light maps");
  expect_usage("room --path lookup-3d --flat-shading --reference",
               "--reference cannot be given with --flat-shading: references are shaded smoothly");
  expect_usage("room --heat-map h.exr", "--heat-map = h.exr: must end in .png");
  expect_usage("room --reference --size 4000x3000",
               "--size = 4000x3000: must be at most 10000000 pixels in all for a reference");
  EXPECT_FALSE(exists("g"));
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(DemoCommand, TwoOutputsOfOneFileAreAnError) {
  expect_usage("room -o a.png --stats ./a.png", "--stats = ./a.png: must not be the file of --output");
  expect_usage("room --stats room.png", "--stats = room.png: must not be the file of --output");
  expect_usage("room -o a.png --heat-map a.png", "--heat-map = a.png: must not be the file of --output");
  expect_usage("room --heat-map a.png --stats a.png", "--stats = a.png: must not be the file of --heat-map");
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(DemoCommand, InputsAreNotOverwritten) {
  const std::string light = R"({"litfog": "light", "version": 1, "attenuation": {"constant": 1, "quadratic": 0.5}})";
  write("lamp.json", light);
  const std::string scene = R"({"litfog": "scene", "version": 1, "objects": [],
    "camera": {"position": [0, 1, 5], "target": [0, 1, 0]},
    "lights": [{"position": [0, 0, 0], "light": "lamp.json"}]})";
  write("scene.json", scene);
  for (const std::string input : {"scene.json", "lamp.json"}) {
    const Outcome outcome = run("scene.json --size 8x8 --stats " + input);
    EXPECT_EQ(outcome.status, kUsage) << input;
    EXPECT_TRUE(outcome.err.starts_with("litfog-demo: --stats = " + input + ": must not be a file that is read, "))
        << outcome.err;
  }
  EXPECT_EQ(read("scene.json"), scene);
  EXPECT_EQ(read("lamp.json"), light);
  EXPECT_FALSE(exists("scene.png"));
}

TEST_F(DemoCommand, MistypedSceneIsAnsweredWithTheNamesOfAllScenes) {
  EXPECT_ERROR(
      run("rooom"), kBadInput,
      "rooom: must be a scene file or one of approach, breakout, city, cookies, flare, headlights, lighthouse, "
      "road, room, street, tessellation, village; did you mean room?\n");
}

TEST_F(DemoCommand, SceneWhoseNameIsNoUtf8HasItsStatistics) {
  write("caf\xE9.json", kEmptyScene);
  const Outcome outcome = expect_done("caf\xE9.json --size 8x8 --stats s.json");
  EXPECT_EQ(json_of("s.json")["scene"], "caf\xEF\xBF\xBD");
  EXPECT_TRUE(outcome.out.starts_with("caf\\xe9.png: ")) << outcome.out;
}

TEST_F(DemoCommand, StatisticsAndReportGoToOneFileOrPipe) {
  for (const std::string pipe : {"", " | cat"}) {
    const Outcome outcome = expect_done("room --size 8x8 -o a.png --stats /dev/stdout" + pipe);
    EXPECT_TRUE(outcome.out.starts_with("{\n  \"scene\": \"room\"")) << outcome.out;
    EXPECT_TRUE(has(outcome.out, "\na.png: room (8x8"));
  }
}

TEST_F(DemoCommand, TwoScenesOfOneNameInAGalleryAreAnError) {
  const std::string scene = R"({"litfog": "scene", "version": 1, "name": "same", "objects": [],
                                "camera": {"position": [0, 1, 5], "target": [0, 1, 0]}})";
  write("a.json", scene);
  write("b.json", scene);
  const Outcome outcome = run("gallery a.json b.json -o g --size 8x8");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.err, "b.json: name = same: must not be that of a.json too\n");
  EXPECT_FALSE(exists("g"));
}

TEST_F(DemoCommand, GallerysTableHasARowForEachSolution) {
  write("two.json", R"({"litfog": "scene", "version": 1, "objects": [], "visibilities_m": [50],
    "camera": {"position": [0, 1, 5], "target": [0, 1, 0]}, "lights": [
    {"position": [0, 0, 0], "light": {"name": "lamp", "attenuation": {"constant": 1, "quadratic": 0.5}}},
    {"position": [0, 0, 1], "light": {"name": "lamp", "attenuation": {"constant": 1, "quadratic": 0.5}}},
    {"position": [0, 0, 2], "light": {"name": "lamp", "attenuation": {"constant": 1, "quadratic": 0.25}}}]})");
  const Outcome outcome = expect_done("gallery two.json -o g --size 8x8");
  std::size_t rows = 0;
  for (auto at = outcome.out.find(" lamp "); at != std::string::npos; at = outcome.out.find(" lamp ", at + 1)) ++rows;
  EXPECT_EQ(rows, 2u) << outcome.out;
}

TEST_F(DemoCommand, BadSceneIsAnErrorAtItsLocation) {
  EXPECT_EQ(run("none.json").status, kBadInput);
  write("scene.json", "{\"litfog\": \"scene\", \"version\": 1,\n  \"camra\": 1}");
  const Outcome outcome = run("scene.json -o a.png");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_TRUE(has(outcome.err, "scene.json:2:3: \"camra\""));
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(DemoCommand, UnwritableOutputIsNamedAndAnEarlierOneStaysWhole) {
  EXPECT_EQ(run("room --size 8x8 -o none/a.png").status, kCannotWrite);
  EXPECT_EQ(run("room --size 8x8 -o a.png --stats none/s.json").status, kCannotWrite);
  write("a.exr", "earlier");
  EXPECT_EQ(run("none.json -o a.exr").status, kBadInput);
  EXPECT_EQ(read("a.exr"), "earlier");
  EXPECT_EQ(run("room --size 8x8 -o " + std::string(300, 'a') + ".png").status, kCannotWrite);
}

TEST_F(DemoCommand, FullDiskLeavesTheEarlierPicture) {
  for (const std::string name : {"a.png", "a.exr"}) {
    write(name, "earlier");
    const Outcome outcome = run("room --size 256x256 -o " + name, "ulimit -f 1;");
    EXPECT_EQ(outcome.status, kCannotWrite) << name;
    EXPECT_EQ(outcome.err, "litfog-demo: " + name + ": cannot be written: File too large\n");
    EXPECT_EQ(read(name), "earlier") << name;
  }
}

TEST_F(DemoCommand, MissingEglIsNamed) {
  // libglvnd finds no driver in an empty folder.
  const Outcome outcome = run("room --size 8x8 -o b.png", "__EGL_VENDOR_LIBRARY_DIRS=" + directory().string());
  EXPECT_EQ(outcome.status, kMissingCapability);
  EXPECT_TRUE(has(outcome.err, "EGL"));
  EXPECT_FALSE(exists("b.png"));
}

TEST_F(DemoCommand, MissingDriverIsToldInOneLine) {
  const Outcome outcome = run("room --size 8x8 -o b.png", "LIBGL_DRIVERS_PATH=" + directory().string());
  EXPECT_EQ(outcome.status, kMissingCapability);
  EXPECT_TRUE(outcome.err.starts_with("litfog-demo: ")) << outcome.err;
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
}

TEST_F(DemoCommand, MissingLibraryIsNamed) {
  const auto missing = [this](const std::string& folder, const std::vector<std::string>& libraries) {
    std::filesystem::create_directory(directory() / folder);
    for (const std::string& library : libraries) write(folder + "/" + library, "no library");
    return run("room --size 8x8 -o b.png", "LD_LIBRARY_PATH=" + folder);
  };
  EXPECT_ERROR(missing("no-egl", {"libEGL.so.1"}), kMissingCapability,
               "litfog-demo: EGL is missing: libEGL.so.1 cannot be loaded (install libegl1)\n");
  EXPECT_ERROR(
      missing("no-gl", {"libGL.so.1", "libOpenGL.so.0"}), kMissingCapability,
      "litfog-demo: OpenGL is missing: neither libOpenGL.so.0 nor libGL.so.1 can be loaded (install libgl1)\n");
}

/// OpenImageIO brings some 250 libraries, each of which takes its time to load.
TEST_F(DemoCommand, CommandStartsWithoutOpenImageIo) {
  const Outcome outcome = run("--version", "LD_TRACE_LOADED_OBJECTS=1");  // what the dynamic linker would load
  EXPECT_EQ(outcome.status, kDone) << outcome.err;
  EXPECT_TRUE(has(outcome.out, "libpng"));
  EXPECT_FALSE(has(outcome.out, "libOpenImageIO"));
}

TEST_F(DemoCommand, InstalledProgramLoadsItsOwnPluginWhereverItIs) {
  namespace fs = std::filesystem;
  const fs::path plugins = directory() / LITFOG_PLUGIN_FOLDER;
  fs::create_directories(directory() / "bin");
  fs::create_directories(plugins);
  fs::copy_file(LITFOG_DEMO_PATH, directory() / "bin/litfog-demo");
  write(LITFOG_PLUGIN_FOLDER "/litfog-openimageio.so", "no library");
  EXPECT_EQ(run("--version; bin/litfog-demo room --size 8x8 -o a.png").status, kDone);
  const Outcome outcome = run("--version; bin/litfog-demo room --size 8x8 -o a.exr");
  EXPECT_EQ(outcome.status, kMissingCapability);
  EXPECT_TRUE(has(outcome.err, "OpenImageIO cannot be loaded: "));
}

TEST_F(DemoCommand, InstalledProgramFindsItsOwnScenesWhereverItIs) {
  namespace fs = std::filesystem;
  fs::create_directories(directory() / "bin");
  fs::create_directories(directory() / "share/litfog/scenes");
  fs::copy_file(LITFOG_DEMO_PATH, directory() / "bin/litfog-demo");
  write("share/litfog/scenes/own.json", R"({"litfog": "scene", "version": 1, "description": "its own", "objects": [],
                                           "camera": {"position": [0, 1, 5], "target": [0, 1, 0]}})");
  const Outcome outcome = expect_done("--version; bin/litfog-demo list scenes");
  EXPECT_TRUE(has(outcome.out, "own          its own\n"));
  EXPECT_FALSE(has(outcome.out, "headlights"));
}

constexpr const char* kOneLamp = R"({"litfog": "scene", "version": 1, "name": "one",
  "camera": {"position": [0, 1, 5], "target": [0, 1, 0]}, "objects": [{"model": "box"}],
  "lights": [{"light": {"name": "a lamp", "attenuation": {"constant": 1, "quadratic": 0.1}}, "position": [1, 3, 1]}]})";

TEST_F(DemoCommand, ChangedMemberGivesThePictureOfTheChangedFile) {
  std::string text = kOneLamp;
  write("one.json", text);
  text.replace(text.find("0.1"), 3, "0.7");
  write("two.json", text);
  const std::string set = "--set lights[0].attenuation.quadratic=0.7 ";
  for (const std::string& arguments : {std::string("one.json -o a.png"), std::string("two.json -o b.png"),
                                       "one.json -o c.png " + set, set + "one.json -o d.png --set fog_top_m=1e9"}) {
    expect_done(arguments + " --size 32x18");
  }
  EXPECT_NE(read("a.png"), read("b.png"));
  EXPECT_EQ(read("b.png"), read("c.png"));
  EXPECT_EQ(read("b.png"), read("d.png"));
  EXPECT_ERROR(run("one.json --set lights[0].threshold=7"), kBadInput,
               "--set: lights[0].light.threshold = 7: must be in (0, 1); 7 % is 0.07\n");
  expect_usage("one.json --set fog_top_m",
               "--set = fog_top_m: must be MEMBER=VALUE, such as lights[0].attenuation.quadratic=0.002");
}

// Mesa keeps what it has compiled on disk, from where the second frame of a second run would take it.
TEST_F(DemoCommand, ShadersAreCompiledBeforeTheFrameThatIsTimed) {
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = run("room -o a.png --size 32x18 --stats times.json");
  const std::chrono::duration<double, std::milli> whole = std::chrono::steady_clock::now() - begin;
  unsetenv("MESA_SHADER_CACHE_DISABLE");
  ASSERT_EQ(outcome.status, kDone) << outcome.err;
  const auto times = json_of("times.json");
  const double drawn = times["ms_per_frame"]["median"];
  const double loaded = times["ms_to_load"];
  const double first = times["ms_to_first_frame"];
  EXPECT_LT(drawn, 0.15 * whole.count());
  EXPECT_GT(first, 0.3 * whole.count());
  EXPECT_LT(loaded + first + drawn, whole.count());
  EXPECT_GT(loaded + first + drawn, 0.7 * whole.count());
  const auto text = [](double ms) { return measure::milliseconds_text(ms) + " ms"; };
  const std::string sentence = "): loaded in " + text(loaded) + ", first drawn, with shaders compiled, in " +
                               text(first) + ", then in " + text(drawn) + " on ";
  EXPECT_TRUE(has(outcome.out, sentence));
}

TEST_F(DemoCommand, CameraIsThatOfTheSceneFileWithThoseMembers) {
  write("one.json", kOneLamp);
  for (const char* arguments : {"-o a.png", "-o b.png --camera -1,1.5,4 --target 0.5,0,-1e0 --fov-deg 70",
                                "-o c.png --set camera.position=[-1,1.5,4] --set camera.target=[0.5,0,-1] "
                                "--set camera.field_of_view_deg=70"}) {
    expect_done(std::string("one.json --size 32x18 ") + arguments);
  }
  EXPECT_NE(read("a.png"), read("b.png"));
  EXPECT_EQ(read("b.png"), read("c.png"));
  for (const std::string point : {"1,2", "1,2,3,4", "1,2,x", "1,2,", ",,", "1,2,1e8", "1, 2, 3"}) {
    expect_usage("one.json --camera '" + point + "'",
                 "--camera = " + point + ": must be three numbers in [-10000000, 10000000], X,Y,Z");
  }
  expect_usage("one.json --camera 0,9,0", "--camera = 0,9,0: must not be straight above or below the target, or at it");
  expect_usage("one.json --fov-deg 151", "--fov-deg = 151: must be a number in [1, 150]");
}

TEST_F(DemoCommand, LightsAreListedAsTheirMembersAreSet) {
  write("one.json", kOneLamp);
  const auto lights = nlohmann::json::parse(run("list lights one.json --format json").out);
  ASSERT_EQ(lights.size(), 1u);
  EXPECT_EQ(lights[0]["member"], "lights[0]");
  EXPECT_EQ(lights[0]["name"], "a lamp");
  EXPECT_EQ(lights[0]["y_m"], 3);
  EXPECT_EQ(lights[0]["quadratic"], 0.1);
  EXPECT_EQ(lights[0]["carried"], "no");
  const auto approach = nlohmann::json::parse(run("list lights approach --format json").out);
  double count = 0;
  for (std::size_t i = 0; i < approach.size(); ++i) {
    EXPECT_EQ(approach[i]["member"], fmt::format("lights[{}]", i));
    count += double(approach[i]["lights"]);
  }
  EXPECT_EQ(count, 1151);
  const auto city = nlohmann::json::parse(run("list lights city --format json").out);
  EXPECT_EQ(city.at(0)["member"], "city.street_lamp");
  EXPECT_EQ(city.at(0)["lights"], 32);
  const std::string changed = run("list lights one.json --set lights[0].carried=true --format csv").out;
  EXPECT_TRUE(has(changed, "lights[0],1,a lamp,1,3,1,1,0,0.1,0.05,"));
  EXPECT_TRUE(has(changed, ",all around,1,yes\n"));
  EXPECT_EQ(run("list lights").status, kUsage);
  EXPECT_EQ(run("list scenes one.json").status, kUsage);
}

TEST_F(DemoCommand, ListOfLightsSaysInWordsWhereTheyShine) {
  write("four.json", R"({"litfog": "scene", "version": 1, "objects": [{"model": "box"}],
    "camera": {"position": [0, 1, 5], "target": [0, 1, 0]},
    "lights": [{"light": {"name": "street lamp", "attenuation": {"constant": 1, "quadratic": 0.1},
                          "cone": {"profile": "cosine", "half_angle_deg": 80.1, "exponent": 1.5}},
                "position": [0.1, 3, 1], "repeat": [{"count": 12, "step": [0.1, 0, 0]}]},
               {"light": {"name": "torch", "attenuation": {"constant": 0, "linear": 0.3}, "threshold": 0.1,
                          "cone": {"profile": "smoothstep", "inner_deg": 4.3, "outer_deg": 14}, "density_scale": 0.4},
                "position": [-0.75, 1.35, 4.8], "carried": true},
               {"light": {"name": "stars", "attenuation": {"constant": 1}},
                "cookie": {"pattern": "disco"}, "position": [0, 1e6, 0]},
               {"light": {"name": "bulb", "attenuation": {"constant": 1, "quadratic": 0.1}}, "position": [0, 2, 0]}]})");
  EXPECT_EQ(run("list lights four.json").out,
            "member     lights  name           x_m      y_m  z_m  constant  linear  quadratic "
            " threshold  extent_m  cone                                       density_scale  carried\n"
            "lights[0]      12  street lamp    0.1        3    1         1       0        0.1 "
            "      0.05    13.784  cosine, half_angle_deg 80.1, exponent 1.5              1  no\n"
            "lights[1]       1  torch        -0.75     1.35  4.8         0     0.3          0 "
            "       0.1   33.3333  smoothstep, inner_deg 4.3, outer_deg 14              0.4  yes\n"
            "lights[2]       1  stars            0  1000000    0         1       0          0 "
            "      0.05       inf  cookie                                                 1  no\n"
            "lights[3]       1  bulb             0        2    0         1       0        0.1 "
            "      0.05    13.784  all around                                             1  no\n");
}

/// A lamp that turns and one that the eye's vehicle carries.
constexpr const char* kTwoLamps = R"({"litfog": "scene", "version": 1, "name": "two",
  "camera": {"position": [0, 1, 5], "target": [0, 1, 0]}, "objects": [{"model": "box"}],
  "environment": {"ambient": [0, 0, 0], "fog_color": [0, 0, 0], "sky_zenith": [0, 0, 0], "sky_horizon": [0, 0, 0],
                  "moon": {"direction": [0, 0.5, 1], "color": [0, 0, 0]}},
  "lights": [{"light": {"attenuation": {"constant": 1, "quadratic": 0.1},
                        "cone": {"profile": "smoothstep", "inner_deg": 10, "outer_deg": 30}},
              "position": [1, 3, 1], "aim": [0, 0, 0], "turn_deg_per_s": 40},
             {"light": {"attenuation": {"constant": 1, "quadratic": 0.1}}, "position": [1, 1, 5], "carried": true}]})";

TEST_F(DemoCommand, FramesOfASequenceAreThePicturesOfTheirSettings) {
  write("two.json", kTwoLamps);
  const struct {
    std::string changes;
    std::string last;  // the picture of the third frame
  } sequences[] = {
      {"--visibility 100..1", "--visibility 1"},
      {"--visibility 30,20,4 --contrast 0.01 --time 0..2", "--visibility 4 --contrast 0.01 --time 2"},
      {"--set 'lights[1].light.flash={\"period_s\":2,\"flashes\":[{\"start_s\":0,\"duration_s\":0.4},"
       "{\"start_s\":1,\"duration_s\":0.5,\"intensity\":3}]}' --time 0..1",
       "--set 'lights[1].light.flash={\"period_s\":1,\"flashes\":[{\"start_s\":0,\"duration_s\":1,\"intensity\":3}]}' "
       "--time 1"},
      {"--set lights[0].threshold=0.1..0.3 --set lights[1].carried=false --camera 0,1,5..1,1,6",
       "--set lights[0].threshold=0.3 --set lights[1].carried=false --camera 1,1,6"},
      {"--camera 0,1,5..2,1,5 --target 0,1,0..2,1,0 --fov-deg 40..60",  // the carried lamp moves by 2 m
       "--camera 2,1,5 --target 2,1,0 --fov-deg 60 --set lights[1].position[0]=3"},
      {"--camera 0,1,5..2,1,5 --set camera.target[0]=0..2",  // the carried lamp moves by 2 m
       "--camera 2,1,5 --target 2,1,0 --set lights[1].position[0]=3"},
      {"--set lights[0].attenuation.quadratic=0.1..9 --set lights[1].position[1]=1..2",
       "--set lights[0].attenuation.quadratic=9 --set lights[1].position[1]=2"},
      {"--set lights[0].attenuation.constant=1,9,30", "--set lights[0].attenuation.constant=30"},  // off
      {"--set 'lights[0].repeat=[{\"count\":1,\"step\":[1,0,0]}]' --set lights[0].repeat[0].count=1,2,3",
       "--set 'lights[0].repeat=[{\"count\":3,\"step\":[1,0,0]}]'"},
      {"--set objects[0].heading_deg=0..40 --set environment.stars=0..1",
       "--set objects[0].heading_deg=40 --set environment.stars=1"},
      {"--set objects[0].width_m=1..2", "--set objects[0].width_m=2"},
      {"--shadows shafts --set objects[0].width_m=2..1 --set lights[0].position[0]=1..2",
       "--shadows shafts --set objects[0].width_m=1 --set lights[0].position[0]=2"},
      {"--path lookup-3d --fog-light peak --set "
       "'objects[0]={\"model\":\"box\",\"scatter\":{\"count\":1,\"area\":[-1,-1,1,1]}}' "
       "--set objects[0].scatter.count=2,1,5 --set 'lights[0].repeat=[{\"count\":1,\"step\":[1,0,0]}]' "
       "--set lights[0].repeat[0].count=1,4,2",
       "--path lookup-3d --fog-light peak --set "
       "'objects[0]={\"model\":\"box\",\"scatter\":{\"count\":5,\"area\":[-1,-1,1,1]}}' "
       "--set 'lights[0].repeat=[{\"count\":2,\"step\":[1,0,0]}]'"},
      {"--set environment.fog_color[1]=0..0.3 --set environment.sky_zenith[2]=0..0.2 --set phase_g=0..0.7",
       "--set environment.fog_color[1]=0.3 --set environment.sky_zenith[2]=0.2 --set phase_g=0.7"},
      {"--set environment.ambient[0]=0,0.5,0.4", "--set environment.ambient[0]=0.4"},
      {"--path legacy --set environment.ambient[1]=0.1..0.4", "--path legacy --set environment.ambient[1]=0.4"},
      {"--path tangent --set environment.ambient[2]=0.4..0.1 --set environment.fog_color[2]=0..0.4",
       "--path tangent --set environment.ambient[2]=0.1 --set environment.fog_color[2]=0.4"},
      {"--visibility 5000 --shadows shafts --set environment.moon.color[0]=0..0.3 "
       "--set environment.moon.direction[1]=0.2..1",
       "--visibility 5000 --shadows shafts --set environment.moon.color[0]=0.3 "
       "--set environment.moon.direction[1]=1"},
      {"--path lookup-3d --fog-light peak --set environment.moon.color[1]=1,0.5,0",
       "--path lookup-3d --fog-light peak --set environment.moon.color[1]=0"},
      {"--set fog_top_m=100..2 --set environment.stars=0..1 --set environment.sky_horizon[0]=0..0.2",
       "--set fog_top_m=2 --set environment.stars=1 --set environment.sky_horizon[0]=0.2"}};
  for (const auto& [changes, last] : sequences) {
    expect_done("sequence two.json -o frames --size 32x18 --frames 3 " + changes);
    ASSERT_EQ(run("two.json -o last.png --size 32x18 " + last).status, kDone);
    EXPECT_EQ(read("frames/two-0003.png"), read("last.png")) << changes;
    EXPECT_NE(read("frames/two-0001.png"), read("frames/two-0002.png")) << changes;
    EXPECT_NE(read("frames/two-0002.png"), read("frames/two-0003.png")) << changes;
    EXPECT_TRUE(has(read("frames/two.apng"), "acTL"));
    EXPECT_FALSE(exists("frames/two-0004.png"));
  }
}

TEST_F(DemoCommand, SequencesThatCannotBeAreRefusedBeforeAnythingIsDrawn) {
  write("two.json", kTwoLamps);
  const auto expect_error = [&](const std::string& options, const std::string& sentence) {
    expect_usage("sequence two.json -o none " + options, sentence);
  };
  expect_error("--visibility 50", "nothing changes: give a range, such as --visibility 2000..50");
  expect_error("--set lights[0].threshold=0.1..x", "--set lights[0].threshold = x: must be a finite number");
  expect_error("--set lights[0].position=[0,1,2]..[1,1,2]",
               "--set lights[0].position = [0,1,2]: must be a finite number");
  expect_error("--visibility 1,2,3 --time 0..1:2",
               "--time has 2 frames, and --visibility 3: the numbers must be equal");
  expect_error("--visibility 1,2,3 --frames 4", "--visibility has 3 frames, and --frames 4: the numbers must be equal");
  expect_error("--camera 0,4,0..0,1,5 --target 0,0,0",
               "frame 1: the target must not be straight above or below the position, or at it");
  expect_error("--set lights[0].threshold=0.1..0.3 --set lights[0].light.threshold=0.2",
               "--set lights[0].light.threshold: must not be given twice");
  expect_error("--visibility 9..1 --film a.gif", "--film = a.gif: must end in .mp4 or .webm");
  EXPECT_ERROR(run("sequence two.json -o none --set lights[0].threshold=0.1..2"), kBadInput,
               "--set: lights[0].light.threshold = 2: must be in (0, 1); 2 % is 0.02\n");
  EXPECT_FALSE(exists("none"));
}

TEST_F(DemoCommand, SequenceWithAFrameThatCannotBeIsRefusedBeforeAnythingIsDrawn) {
  write("two.json", kTwoLamps);
  expect_usage(
      "sequence two.json -o frames --size 8x8 --frames 3 --camera 0,3,0 --set camera.target[0]=1..-1 "
      "--set camera.target[1]=0",
      "frame 2: the target must not be straight above or below the position, or at it");
  EXPECT_ERROR(run("sequence two.json -o frames --set lights[0].light.cone.inner_deg=9,40,10"), kBadInput,
               "--set: lights[0].light.cone.inner_deg = 40: must be in [0, outer_deg)\n");
  EXPECT_ERROR(run("sequence two.json -o frames --set 'objects[0].repeat=[{\"count\":1,\"step\":[1,0,0]}]' "
                   "--set objects[0].repeat[0].count=3..1:6"),
               kBadInput, "--set: objects[0].repeat[0].count = 1.4: must be a whole number\n");
  write("through.json", R"({"litfog": "camera-path", "version": 1, "keyframes": [
    {"position": [0, 1, 1], "target": [0, 1, 0]}, {"position": [0, 1, -1], "target": [0, 1, 0]}]})");
  EXPECT_ERROR(run("sequence two.json -o frames --frames 3 --camera-path through.json"), kBadInput,
               "through.json: frame 2: the target must not be straight above or below the position, or at it\n");
  EXPECT_FALSE(exists("frames"));
}

TEST_F(DemoCommand, FilmNeedsFfmpeg) {
  write("two.json", kTwoLamps);
  const std::string arguments = "sequence two.json -o frames --size 33x17 --visibility 9,1 --film a.webm";
  const Outcome missing = run(arguments, "PATH=/nowhere");
  EXPECT_EQ(missing.status, kMissingCapability);
  EXPECT_EQ(missing.err, "litfog-demo: ffmpeg cannot be run: No such file or directory; install ffmpeg\n");
  EXPECT_FALSE(exists("frames"));
  if (std::system("command -v ffmpeg >/dev/null") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  expect_done(arguments);
  EXPECT_EQ(read("a.webm").substr(0, 4), "\x1A\x45\xDF\xA3") << "EBML";
}

TEST_F(DemoCommand, SettingsAreComparedOnAPageOfTheirOwn) {
  write("one.json", kOneLamp);
  const Outcome outcome = expect_done(
      "compare one.json -o out.d --size 32x18 --frames 1 --visibility 30 --with \"visibility=9 path=vertex\" "
      "--with lights[0].attenuation.quadratic=0.5 --with '--no-skip --visibility=30' --with 'room no-skip'");
  EXPECT_TRUE(has(outcome.out, "\n3: --no-skip --visibility=30 "));
  EXPECT_TRUE(has(outcome.out, "out.d/index.html shows them\n"));
  const std::string page = read("out.d/index.html");
  EXPECT_TRUE(has(page, "<td class=\"words\">visibility=9 path=vertex</td>"));
  EXPECT_TRUE(has(page, "{first: 2, second: 3, largest: "));

  // Options with an effect on one of the settings only.
  expect_done(
      "compare one.json -o out.d --size 32x18 --frames 1 --visibility 9 --contrast flightgear --map-size 32 --with "
      "fog=none --with path=radial --with contrast=0.01");
  const Outcome contrast =
      expect_done("compare one.json -o out.d --size 32x18 --frames 1 --visibility 9 --with contrast=flightgear");
  EXPECT_FALSE(has(contrast.out, "from 1: largest 0,"));

  expect_done(
      "compare one.json -o out.d --size 32x18 --frames 1 --rvr 30 --with visibility=9 --with rvr=20 --with no-skip");

  const Outcome same = expect_done("compare one.json -o out.d --size 32x18 --frames 1 --with no-skip");
  EXPECT_TRUE(has(same.out, "\n2: no-skip "));
  EXPECT_TRUE(has(same.out, "from 1: largest 0, mean 0 of 1/255"));
}

TEST_F(DemoCommand, WrongSettingsAreNamed) {
  write("one.json", kOneLamp);
  const auto expect_error = [&](const std::string& arguments, const std::string& sentence) {
    expect_usage("compare -o none " + arguments, sentence);
  };
  expect_error("one.json --with visibility=x",
               "--with \"visibility=x\": --visibility = x: must be a number >= 0 or inf");
  expect_error("one.json --with size=9x9",
               "--with \"size=9x9\": --size cannot be given with --with: all pictures are of one size");
  expect_error("one.json --with 'fog=none visibility=9'",
               "--with \"fog=none visibility=9\": --visibility cannot be given with --fog none: the air is clear");
  const auto unused = [&](const std::string& option, const std::string& arguments) {
    expect_error("one.json " + arguments, option + " has no effect on any of these settings");
  };
  unused("--map-size", "--map-size 64 --with no-skip");
  unused("--visibility", "--visibility 9 --with visibility=2 --with rvr=3");
  unused("--contrast", "--contrast flightgear --fog none --with no-skip");
  unused("--shadow-lamps", "--shadow-lamps 2 --path vertex --with no-skip --with path=legacy");
  expect_error("one.json --with time=3", "--time cannot be given: none of the scene's lights turns or flashes");
  expect_error("one.json --with lights=3", "--lights cannot be given: the scene has no generated city");
  expect_error("one.json --with no-skip --with 'camera=0,9,0 target=0,0,0'",
               "--with \"camera=0,9,0 target=0,0,0\": --target = 0,0,0: must not be straight above "
               "or below the camera, or at it");
  expect_error("one.json --with '--set lights[0].threshold'",
               "--with \"--set lights[0].threshold\": --set = lights[0].threshold: must be "
               "MEMBER=VALUE, such as lights[0].attenuation.quadratic=0.002");
  EXPECT_ERROR(
      run("compare one.json -o none --with '--set lights[0].threshold=7'"), kBadInput,
      "--with \"--set lights[0].threshold=7\": --set: lights[0].light.threshold = 7: must be in (0, 1); 7 % is "
      "0.07\n");
  expect_error("one.json --with ' '", "--with \" \": must not be empty");
  expect_error("--with visibility=9", "--with compares settings of one SCENE: name it");
  expect_error("one.json room --with visibility=9",
               "--with compares settings of one SCENE, not of 2: a SETTING may be another, as in --with room");
  EXPECT_ERROR(
      run("compare one.json -o none --with lights[0].threshold=7"), kBadInput,
      "--with \"lights[0].threshold=7\": --set: lights[0].light.threshold = 7: must be in (0, 1); 7 % is 0.07\n");
  EXPECT_ERROR(run("compare one.json -o none --set lights[0].threshold=7 --with no-skip"), kBadInput,
               "--set: lights[0].light.threshold = 7: must be in (0, 1); 7 % is 0.07\n");
  const Outcome misspelt = run("compare one.json -o none --with visibility=9 --with \"tone=clip exposre=3\"");
  EXPECT_EQ(misspelt.status, kBadInput);
  EXPECT_TRUE(misspelt.err.starts_with("--with \"tone=clip exposre=3\": --set: \"exposre\": must be one of "))
      << misspelt.err;
  EXPECT_TRUE(misspelt.err.ends_with("; did you mean exposure?\n")) << misspelt.err;
  const Outcome begun = run("compare one.json -o none --with visib=9");  // or visibilities_m, a member
  EXPECT_TRUE(begun.err.ends_with("objects; did you mean visibility?\n")) << begun.err;
  EXPECT_FALSE(exists("none"));
}

}  // namespace

}  // namespace litfog::test
