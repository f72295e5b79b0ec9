// SPDX-License-Identifier: Apache-2.0
#include "gltf_members.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "exit_status.h"

namespace {

using nlohmann::json;

/// With every member that is looked at.
json sound_file() {
  return json::parse(R"({
    "asset": {"version": "2.0", "minVersion": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0, "camera": 0, "children": [1], "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1],
               "translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1],
               "extensions": {"KHR_lights_punctual": {"light": 0}}}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TANGENT": 2, "TEXCOORD_0": 3},
                                "indices": 3, "material": 0, "mode": 4}]}],
    "accessors": [{"bufferView": 0, "byteOffset": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                   "normalized": false}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48, "byteStride": 12}],
    "buffers": [{"uri": "a.bin", "byteLength": 48}],
    "textures": [{"source": 0}], "images": [{"uri": "a.png"}, {"bufferView": 0}],
    "materials": [{"doubleSided": true, "emissiveFactor": [0, 0, 0],
                   "normalTexture": {"index": 0, "texCoord": 0, "scale": 1},
                   "emissiveTexture": {"index": 0, "texCoord": 0},
                   "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0, "roughnessFactor": 1,
                                            "baseColorTexture": {"index": 0, "texCoord": 0},
                                            "metallicRoughnessTexture": {"index": 0, "texCoord": 0}}}],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"name": "lamp", "type": "spot", "color": [1, 1, 1], "intensity": 1, "range": 9,
       "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}]}}})");
}

/// The sentence without place, member and value; empty where there is none.
std::string rule(const json& file) {
  try {
    litfog::demo::expect_gltf_members(parse_json(file.dump(), "a.gltf"));
  } catch (const BadInput& bad) {
    const std::string sentence = bad.what();
    return sentence.substr(sentence.rfind(": ") + 2);
  }
  return "";
}

std::string rule_with(const std::string& pointer, const json& value) {
  json file = sound_file();
  file.at(json::json_pointer(pointer)) = value;
  return rule(file);
}

TEST(GltfMembers, OfASoundFileAreAccepted) {
  EXPECT_EQ(rule(sound_file()), "");
  EXPECT_EQ(rule(json::parse(R"({"asset": {"version": "2.1"}})")), "");
}

TEST(GltfMembers, OfAnotherKindAreEachRefused) {
  int tried = 0;
  const json members = sound_file().flatten();
  for (const auto& [pointer, value] : members.items()) {
    json file = sound_file();  // an object is of no member's kind
    file.at(json::json_pointer(pointer)) = json::object();
    EXPECT_NE(rule(file), "") << pointer;
    ++tried;
  }
  EXPECT_GT(tried, 70);
}

TEST(GltfMembers, AreRefusedWithTheRule) {
  const std::string index = "must be a whole number >= 0";
  EXPECT_EQ(rule_with("/asset/version", "1.0"), "must be \"2.0\" or a later 2");
  EXPECT_EQ(rule_with("/asset/minVersion", "2.1"), "must be \"2.0\", which is what this program knows");
  EXPECT_EQ(rule_with("/scene", -1), index);
  EXPECT_EQ(rule_with("/scenes/0/nodes/0", 0.5), index);
  EXPECT_EQ(rule_with("/nodes/0/children/0", -2), index);
  EXPECT_EQ(rule_with("/nodes/0/mesh", 4294967296.0), "must be below 2^31");
  EXPECT_EQ(rule_with("/nodes/0/scale", {1, 1}), "must be 3 numbers");
  EXPECT_EQ(rule_with("/nodes/0/rotation", {0, 0, 0, 0}), "must not be all 0");
  EXPECT_EQ(rule_with("/materials/0/doubleSided", 1), "must be true or false");
  EXPECT_EQ(rule_with("/materials/0/normalTexture/scale", "1"), "must be a number");
  EXPECT_EQ(rule_with("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", "wide"), "must be a number");
}

}  // namespace
