// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>

#include "command/temporary_directory.h"
#include "demo/sequence/camera_path.h"
#include "files/json_schema.h"

namespace litfog::test {
namespace {

/// Between them they have every member.
constexpr std::array kPaths{
    R"({"$schema": "s", "litfog": "camera-path", "version": 1, "keyframes": [
      {"time_s": 0, "position": [0, 2, 9], "target": [0, 1, 0], "field_of_view_deg": 50},
      {"time_s": 4, "position": [3, 2, 5], "target": [0, 1, 0]}]})",
    R"({"litfog": "camera-path", "version": 1, "keyframes": [
      {"position": [0, 2, 9], "target": [0, 1, 0]}, {"position": [0, 2, 5], "target": [0, 1, 0]}]})"};

class CameraPathSchema : public testing::Test {
 protected:
  const JsonSchema schema_{"camera-path"};
  TemporaryDirectory directory_;
  const Refusal refusal_of_ =
      refusal_by([](const std::string& path) { demo::read_camera_path(path, 1); }, directory_.path());
};

TEST_F(CameraPathSchema, SchemaHasTheReadersMembersAlone) {
  const std::string header = R"({"litfog": "camera-path", "version": 1, )";
  EXPECT_EQ(schema_.members_at(""), members_in(refusal_of_(header + R"("zzz": 1})")));
  EXPECT_EQ(schema_.members_at("/definitions/keyframe"),
            members_in(refusal_of_(header + R"("keyframes": [{"zzz": 1}, {}]})")));
}

TEST_F(CameraPathSchema, SchemaRefusesWhatTheReaderRefusesAndNothingElse) {
  const auto is_of_order = [](const std::string& refusal) {  // which a schema cannot say
    return refusal.find("must be after the keyframe before") != refusal.npos;
  };
  int refused = 0;
  for (const char* path : kPaths) refused += expect_same_refusals(schema_, refusal_of_, path, is_of_order);
  EXPECT_GT(refused, 100);
}

TEST_F(CameraPathSchema, SchemaHasTheReadersLimits) {
  for (const char* key :
       {R"("position": [10000000, 0, 0], "target": [0, 0, 0])", R"("position": [10000002, 0, 0], "target": [0, 0, 0])",
        R"("position": [0, 0, 0], "target": [0, -10000000, 0])",
        R"("position": [0, 0, 0], "target": [0, -10000002, 0])",
        R"("position": [0, 0, 0], "target": [0, 0, 0], "field_of_view_deg": 1)",
        R"("position": [0, 0, 0], "target": [0, 0, 0], "field_of_view_deg": 0.999)",
        R"("position": [0, 0, 0], "target": [0, 0, 0], "field_of_view_deg": 150)",
        R"("position": [0, 0, 0], "target": [0, 0, 0], "field_of_view_deg": 150.1)"}) {
    const std::string text = R"({"litfog": "camera-path", "version": 1, "keyframes": [{"position": [0, 0, 0], )"
                             R"("target": [0, 0, 0]}, {)" +
                             std::string(key) + "}]}";
    EXPECT_EQ(schema_.error_of(text).empty(), refusal_of_(text).empty()) << text << "\n" << refusal_of_(text);
  }
  for (const char* seconds : {"-1e9", "-1000000200", "1000000200"}) {
    const std::string text = R"({"litfog": "camera-path", "version": 1, "keyframes": [
      {"time_s": )" + std::string(seconds) +
                             R"(, "position": [0, 0, 0], "target": [0, 0, 0]},
      {"time_s": 1e9, "position": [0, 0, 0], "target": [0, 0, 0]}]})";
    EXPECT_EQ(schema_.error_of(text).empty(), refusal_of_(text).empty()) << text << "\n" << refusal_of_(text);
  }
}

}  // namespace
}  // namespace litfog::test
