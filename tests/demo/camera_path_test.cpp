// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/camera_path.h"

#include <gtest/gtest.h>

#include "command/temporary_directory.h"
#include "litfog/input_error.h"

namespace litfog::test {
namespace {

using demo::CameraPath;
using demo::read_camera_path;
using scene::Camera;

const std::vector<CameraPath::Key> kKeys{{0, {0, 1, 0}, {9, 1, 0}, 0.5},
                                         {1, {4, 1, 0}, {9, 2, 0}, 0.6},
                                         {3, {4, 1, 8}, {9, 3, 9}, 0.9},
                                         {4, {0, 2, 8}, {0, 4, 9}, 0.7}};

TEST(CameraPath, EveryKeyframeIsPassedAtItsTime) {
  const CameraPath path(kKeys);
  for (const CameraPath::Key& key : kKeys) {
    const Camera camera = path.at(key.seconds / 4);
    EXPECT_NEAR(glm::distance(glm::dvec3(camera.position), key.position), 0, 1e-6) << key.seconds;
    EXPECT_NEAR(glm::distance(glm::dvec3(camera.target), key.target), 0, 1e-6) << key.seconds;
    EXPECT_NEAR(camera.field_of_view, key.field_of_view, 1e-7) << key.seconds;
  }
}

TEST(CameraPath, EyeChangesNeitherPlaceNorVelocityAbruptly) {
  const CameraPath path(kKeys);
  const auto velocity = [&](double seconds, double side) {
    constexpr double kStep = 1e-3;
    const auto at = [&](double offset) { return glm::dvec3(path.at((seconds + side * offset) / 4).position); };
    return (at(2 * kStep) - at(kStep)) / (side * kStep);
  };
  for (const double seconds : {1.0, 3.0}) {
    EXPECT_LT(glm::distance(velocity(seconds, 1), velocity(seconds, -1)), 0.05) << seconds;
  }
}

TEST(CameraPath, EvenKeyframesOnALineAreAnEvenMotion) {
  std::vector<CameraPath::Key> keys;
  for (const double t : {0.0, 0.5, 2.0, 3.0}) keys.push_back({t, {2 * t, 1, -t}, {2 * t, 1, -9 - t}, 0.5});
  const CameraPath path(keys);
  for (const double fraction : {0.0, 0.1, 0.3, 0.55, 0.8, 1.0}) {
    const glm::dvec3 exact(6 * fraction, 1, -3 * fraction);
    EXPECT_NEAR(glm::distance(glm::dvec3(path.at(fraction).position), exact), 0, 1e-6) << fraction;
  }
}

class CameraPathFile : public testing::Test {
 protected:
  CameraPath read(const std::string& keyframes) const {
    const std::string header = R"({"litfog": "camera-path", "version": 1, "keyframes": )";
    return read_camera_path(directory_.write("path.json", header + keyframes + "}"), 0.25);
  }
  std::string error_of(const std::string& keyframes) const {
    try {
      read(keyframes);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file().size());
    }
    return "no error";
  }
  std::string file() const { return (directory_.path() / "path.json").string(); }

  TemporaryDirectory directory_;
};

TEST_F(CameraPathFile, KeyframesWithoutTimesAreEvenAndWithoutAnAngleHaveTheScenes) {
  const CameraPath path = read(R"([{"position": [0, 1, 0], "target": [0, 1, -9]},
                                   {"position": [1, 1, 0], "target": [0, 1, -9]},
                                   {"position": [2, 1, 0], "target": [0, 1, -9]}])");
  EXPECT_NEAR(path.at(0.25).position.x, 0.5f, 1e-6f);
  EXPECT_FLOAT_EQ(path.at(0.25).field_of_view, 0.25f);
}

TEST_F(CameraPathFile, WrongPathsAreErrorsAtTheirLocation) {
  const std::string key = R"({"position": [0, 1, 0], "target": [0, 1, -9])";
  EXPECT_EQ(error_of("[" + key + "}]"), ":1:54: keyframes = an array: must hold two keyframes or more");
  EXPECT_NE(error_of("[" + key + R"(, "time_s": 1}, )" + key + R"(, "time_s": 1}])")
                .find("keyframes[1].time_s = 1: must be after the keyframe before"),
            std::string::npos);
  EXPECT_NE(error_of("[" + key + "}, " + key + R"(, "time_s": 1}])")
                .find("keyframes[1].time_s = 1: must be given of all keyframes or of none"),
            std::string::npos);
  EXPECT_NE(error_of("[" + key + R"(, "time_s": 1}, )" + key + "}]").find("keyframes[1].time_s: must be given"),
            std::string::npos);
  EXPECT_NE(error_of("[" + key + "}, " + key + R"(, "field_of_view_deg": 151}])").find("must be in [1, 150]"),
            std::string::npos);
  EXPECT_NE(error_of(R"([{"position": [0, 1e8, 0], "target": [0, 0, 1]}, )" + key + "}]").find("must have coordinates"),
            std::string::npos);
  EXPECT_NE(error_of("[" + key + R"(, "time_s": -1e308}, )" + key + R"(, "time_s": 1e308}])")
                .find("keyframes[0].time_s = -1e308: must be in [-1e9, 1e9]"),
            std::string::npos);
  EXPECT_NE(error_of("[" + key + R"(, "tine_s": 1}, )" + key + "}]").find("did you mean time_s?"), std::string::npos);
}

}  // namespace
}  // namespace litfog::test
