// SPDX-License-Identifier: Apache-2.0
#include "window/command_line.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <limits>

#include "render/plan/lighting_path.h"

namespace litfog::test {
using namespace window;

namespace {

TEST(CommandLine, DefaultsAreLeftOut) { EXPECT_EQ(to_string({.scene = "room"}), "litfog-demo room --size 1280x720"); }

TEST(CommandLine, EveryControlHasItsOption) {
  DrawingCommand command{.scene = "room"};
  drawing::DrawingOptions& options = command.options;
  options.fog = FogMode::exp2;
  options.visibility = 62.5;
  options.contrast = kContrastKoschmieder;
  options.phase = "hg:0.5";
  options.fog_light = render::FogLighting::airlight;
  options.scattering = render::Scattering::single;
  options.render.shadows = render::Shadows::shafts;
  options.render.skipping = render::Skipping::off;
  options.render.samples = 8;
  options.seconds = 1.5;
  options.display = {
      .exposure = render::Exposure{.ev = -2.25}, .tone = render::ToneCurve::clip, .glare = drawing::Glare::none};
  options.width = 640;
  options.height = 360;
  command.camera = {.position = {0.1, -2, 3e-5}, .target = {1, 2, 3}, .field_of_view = glm::radians(47.5f)};
  command.changes = {{"lights[0].attenuation.quadratic", "0.002"}, {"lights[1].color", "[1.0,0.5,0.25]"}};
  EXPECT_EQ(to_string(command),
            "litfog-demo room --fog exp2 --visibility 62.5 --contrast koschmieder --phase hg:0.5 --fog-light airlight "
            "--scattering single --shadows shafts --time 1.5 --exposure -2.25 --tone clip --glare none --samples 8 "
            "--no-skip --camera "
            "0.1,-2,3e-05 "
            "--target 1,2,3 --fov-deg 47.5 --set 'lights[0].attenuation.quadratic=0.002' "
            "--set 'lights[1].color=[1.0,0.5,0.25]' --size 640x360");
}

TEST(CommandLine, OptionsWithoutEffectAreLeftOut) {
  DrawingCommand command{.scene = "room"};
  command.options.fog = std::nullopt;
  command.options.visibility = 50;
  command.options.contrast = kContrastFlightgear;
  command.options.phase = "hg:0.5";
  EXPECT_EQ(to_string(command), "litfog-demo room --fog none --size 1280x720");

  command = {.scene = "room"};
  command.options.render.path = render::find_lighting_path("vertex");
  command.options.fog_light = render::FogLighting::airlight;  // which the path lacks
  command.options.render.shadows = render::Shadows::surfaces;
  command.options.phase = "hg:0.5";
  command.options.render.papers.is_flat_shaded = true;
  command.options.render.papers.map_size = 64;
  EXPECT_EQ(to_string(command), "litfog-demo room --path vertex --size 1280x720");
}

TEST(CommandLine, ClearAirAndOwnContrastsAreNumbersThatReadBack) {
  DrawingCommand command{.scene = "room"};
  command.options.visibility = std::numeric_limits<double>::infinity();
  command.options.contrast = 0.03;
  EXPECT_EQ(to_string(command), "litfog-demo room --visibility inf --contrast 0.03 --size 1280x720");
}

TEST(CommandLine, ShellTakesEachWordAsItIs) {
  EXPECT_EQ(to_string({.scene = "my scene's.json"}), R"(litfog-demo 'my scene'\''s.json' --size 1280x720)");
  EXPECT_EQ(to_string({.scene = "a/b-1.glb"}), "litfog-demo a/b-1.glb --size 1280x720");
}

}  // namespace

}  // namespace litfog::test
