// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/sequence.h"

#include <gtest/gtest.h>

#include <fstream>

#include "command/temporary_directory.h"

namespace litfog::test {
namespace {

using demo::MemberCourse;

class SequenceTest : public testing::Test {
 protected:
  SequenceTest() {
    std::ofstream(scene_) << R"({"litfog": "scene", "version": 1, "fog_top_m": 9, "visibilities_m": [50],
      "camera": {"position": [0, 1, 5], "target": [0, 1, 0]}, "objects": [{"model": "box"}],
      "environment": {"ambient": [0, 0, 0], "fog_color": [0, 0, 0], "sky_zenith": [0, 0, 0],
                      "moon": {"direction": [0, 1, 0], "color": [0, 0, 0]}},
      "lights": [{"light": {"attenuation": {"constant": 1}}, "position": [1, 3, 1]}]})";
  }

  bool keeps_renderer(const std::string& member) const {
    const demo::SequenceOptions options{
        .scene = scene_,
        .members = {{.change = {.member = member, .value = ""},
                     .numbers = demo::Course<double>{.values = {0.5, 0.75}, .is_range = true}}},
        .frames = 2};
    return demo::Sequence(options, {}).keeps_renderer();
  }

 private:
  TemporaryDirectory directory_;
  const std::string scene_ = (directory_.path() / "scene.json").string();
};

TEST_F(SequenceTest, OneRendererDrawsAllFramesUnlessWhatItHoldsChanges) {
  for (const char* member : {"camera.position[0]", "lights[0].threshold", "lights[0].position[1]", "fog_top_m",
                             "phase_g", "visibilities_m[0]", "environment.ambient[0]", "environment.fog_color[0]",
                             "environment.sky_zenith[2]", "environment.stars"}) {
    EXPECT_TRUE(keeps_renderer(member)) << member;
  }
  for (const char* member : {"objects[0].width_m", "objects[0].heading_deg", "environment.moon.color[0]"}) {
    EXPECT_FALSE(keeps_renderer(member)) << member;
  }
}

}  // namespace
}  // namespace litfog::test
