// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_members.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "command/exit_status.h"
#include "litfog/input_error.h"

namespace litfog::test {
using namespace scene;
using namespace command;

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

/// The sentence without file, line and column; empty where there is none.
std::string refusal(const json& file) {
  try {
    scene::expect_gltf_members(files::parse_json(file.dump(), "a.gltf"));
  } catch (const InputError& bad) {
    const std::string sentence = bad.what();
    return sentence.substr(sentence.find(": ") + 2);
  }
  return "";
}

std::string refusal_with(const std::string& pointer, const json& value) {
  json file = sound_file();
  file.at(json::json_pointer(pointer)) = value;
  return refusal(file);
}

/// "/nodes/0/mesh" as messages have it: "nodes[0].mesh".
std::string path_of(const std::string& pointer) {
  std::string path;
  std::istringstream steps(pointer.substr(1));
  for (std::string step; std::getline(steps, step, '/');) {
    const bool is_index = step.find_first_not_of("0123456789") == step.npos;
    path += is_index ? "[" + step + "]" : (path.empty() ? "" : ".") + step;
  }
  return path;
}

TEST(GltfMembers, OfASoundFileAreAccepted) {
  EXPECT_EQ(refusal(sound_file()), "");
  EXPECT_EQ(refusal(json::parse(R"({"asset": {"version": "2.1"}})")), "");
}

TEST(GltfMembers, OfAnotherKindAreEachRefused) {
  int tried = 0;
  const json members = sound_file().flatten();
  for (const auto& [pointer, value] : members.items()) {
    json file = sound_file();  // an object is of no member's kind
    file.at(json::json_pointer(pointer)) = json::object();
    EXPECT_EQ(refusal(file).find(path_of(pointer) + " = an object: must be "), 0u) << pointer << ": " << refusal(file);
    ++tried;
  }
  EXPECT_GT(tried, 70);
}

TEST(GltfMembers, AreRefusedWithPlaceValueAndRule) {
  EXPECT_EQ(refusal_with("/asset/version", "1.0"), "asset.version = \"1.0\": must be \"2.0\" or a later 2");
  EXPECT_EQ(refusal_with("/asset/minVersion", "2.1"),
            "asset.minVersion = \"2.1\": must be \"2.0\", which is what this program knows");
  EXPECT_EQ(refusal_with("/scene", -1), "scene = -1: must be a whole number >= 0");
  EXPECT_EQ(refusal_with("/scenes/0/nodes/0", 0.5), "scenes[0].nodes[0] = 0.5: must be a whole number >= 0");
  EXPECT_EQ(refusal_with("/nodes/0/mesh", "floor"), "nodes[0].mesh = \"floor\": must be a number");
  EXPECT_EQ(refusal_with("/nodes/0/mesh", -1), "nodes[0].mesh = -1: must be a whole number >= 0");
  EXPECT_EQ(refusal_with("/nodes/0/mesh", 4294967296), "nodes[0].mesh = 4294967296: must be below 2^31");
  EXPECT_EQ(refusal_with("/nodes/0/children/0", -2), "nodes[0].children[0] = -2: must be a whole number >= 0");
  EXPECT_EQ(refusal_with("/nodes/0/matrix", {1, 0, 0}), "nodes[0].matrix = an array: must be 16 numbers");
  EXPECT_EQ(refusal_with("/nodes/0/rotation", {0, 0, 0, 0}), "nodes[0].rotation = an array: must not be all 0");
  EXPECT_EQ(refusal_with("/nodes/0/extensions/KHR_lights_punctual/light", "0"),
            "nodes[0].extensions.KHR_lights_punctual.light = \"0\": must be a number");
  EXPECT_EQ(refusal_with("/accessors/0/byteOffset", -4), "accessors[0].byteOffset = -4: must be a whole number >= 0");
  EXPECT_EQ(refusal_with("/materials/0/doubleSided", 1), "materials[0].doubleSided = 1: must be true or false");
  EXPECT_EQ(refusal_with("/materials/0/normalTexture/scale", "1"),
            "materials[0].normalTexture.scale = \"1\": must be a number");
  EXPECT_EQ(refusal_with("/materials/0/pbrMetallicRoughness/baseColorFactor", {0.5}),
            "materials[0].pbrMetallicRoughness.baseColorFactor = an array: must be 4 numbers");
  EXPECT_EQ(refusal_with("/extensions/KHR_lights_punctual/lights/0/intensity", "bright"),
            "extensions.KHR_lights_punctual.lights[0].intensity = \"bright\": must be a number");
  EXPECT_EQ(refusal_with("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", "wide"),
            "extensions.KHR_lights_punctual.lights[0].spot.outerConeAngle = \"wide\": must be a number");
}

}  // namespace

}  // namespace litfog::test
