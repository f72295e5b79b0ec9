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
      "camera": {"position": [0, 1, 5], "target": [0, 1, 0]},
      "vehicle": {"position": [0, 0, 0], "heading_deg": 0},
      "objects": [{"model": "box", "repeat": [{"count": 1, "step": [1, 0, 0]}]}],
      "environment": {"ambient": [0, 0, 0], "fog_color": [0, 0, 0], "sky_zenith": [0, 0, 0],
                      "moon": {"direction": [0, 1, 0], "color": [0, 0, 0]}},
      "lights": [{"light": {"attenuation": {"constant": 1}}, "position": [1, 3, 1]}]})";
  }

  demo::SequenceOptions over(const std::string& member, const std::vector<double>& values = {0.5, 0.75}) const {
    return {.scene = scene_,
            .members = {{.change = {.member = member, .value = ""},
                         .numbers = demo::Course<double>{.values = values, .is_range = false}}}};
  }

 private:
  TemporaryDirectory directory_;
  const std::string scene_ = (directory_.path() / "scene.json").string();
};

TEST_F(SequenceTest, ObjectsChangeWithTheirMembersAlone) {
  const demo::SequenceOptions copies = over("objects[0].repeat[0].count", {1, 2});
  EXPECT_TRUE(demo::Sequence(copies).changes_objects());
  const demo::SequenceOptions same = over("objects[0].width_m", {2});
  const demo::SequenceOptions fog = over("fog_top_m");
  demo::SequenceOptions both = fog;
  both.members.push_back(same.members[0]);
  EXPECT_FALSE(demo::Sequence(both).changes_objects());
}

}  // namespace
}  // namespace litfog::test
