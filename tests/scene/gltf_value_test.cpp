// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_value.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "command/temporary_directory.h"
#include "litfog/input_error.h"
#include "scene/file/gltf_scene.h"

namespace litfog::test {
namespace {

using nlohmann::json;

/// A grey picture of one pixel.
const std::string kPng = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==";

/// Every member that is read. All numbers in its buffer are 0.
json sound_file() {
  json file = json::parse(R"({
    "asset": {"version": "2.0", "minVersion": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "extensionsRequired": ["KHR_lights_punctual"],
    "nodes": [{"mesh": 0, "camera": 0, "children": [1],
               "translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1],
               "extensions": {"KHR_lights_punctual": {"light": 0}}},
              {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.9}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0, "TANGENT": 1, "TEXCOORD_0": 2},
                                "indices": 3, "material": 0, "mode": 4}]}],
    "accessors": [{"bufferView": 0, "byteOffset": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "normalized": false},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC4"},
                  {"bufferView": 1, "componentType": 5123, "count": 3, "type": "VEC2", "normalized": true},
                  {"bufferView": 1, "componentType": 5121, "count": 3, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48, "byteStride": 12},
                    {"buffer": 0, "byteLength": 48}, {"buffer": 1, "byteLength": 67}],
    "buffers": [{"byteLength": 48}, {"byteLength": 67}],
    "textures": [{"source": 0}, {"source": 1}], "images": [{}, {"bufferView": 2}],
    "materials": [{"doubleSided": true, "emissiveFactor": [1, 1, 1],
                   "normalTexture": {"index": 0, "texCoord": 0, "scale": 1},
                   "emissiveTexture": {"index": 0, "texCoord": 0},
                   "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0, "roughnessFactor": 1,
                                            "baseColorTexture": {"index": 0, "texCoord": 0},
                                            "metallicRoughnessTexture": {"index": 1, "texCoord": 0}}}],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"name": "lamp", "type": "spot", "color": [1, 1, 1], "intensity": 1, "range": 9,
       "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.2}}]}}})");
  file["buffers"][0]["uri"] = "data:application/octet-stream;base64," + std::string(64, 'A');
  file["buffers"][1]["uri"] = "data:application/octet-stream;base64," + kPng;
  file["images"][0]["uri"] = "data:image/png;base64," + kPng;
  return file;
}

/// The sentence without its location, which it has to have; empty where there is none.
std::string error_of(const json& file) {
  const TemporaryDirectory directory;
  const std::string path = directory.write("a.gltf", file.dump(1));
  try {
    scene::read_gltf_scene(path);
  } catch (const InputError& error) {
    EXPECT_EQ(error.location().file, path);
    EXPECT_GT(error.location().line, 0u) << error.what();
    EXPECT_GT(error.location().column, 0u) << error.what();
    return std::string(error.what()).substr(to_string(error.location()).size() + 2);
  }
  return "";
}

std::string error_with(const std::string& pointer, const json& value) {
  json file = sound_file();
  file.at(json::json_pointer(pointer)) = value;
  return error_of(file);
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

TEST(GltfValues, ASoundFileIsRead) {
  EXPECT_EQ(error_of(sound_file()), "");
  EXPECT_EQ(error_with("/asset/version", "2.1"), "");
}

TEST(GltfValues, AMemberOfAnotherKindFailsAtItsLocation) {
  int tried = 0;
  const json members = sound_file().flatten();
  for (const auto& [pointer, value] : members.items()) {
    json file = sound_file();  // an object is of no member's kind
    file.at(json::json_pointer(pointer)) = json::object();
    EXPECT_EQ(error_of(file).find(path_of(pointer) + " = an object: must be "), 0u)
        << pointer << ": " << error_of(file);
    ++tried;
  }
  EXPECT_GT(tried, 70);
}

TEST(GltfValues, ErrorsNameLocationValueAndRule) {
  EXPECT_EQ(error_with("/asset/version", "1.0"), "asset.version = \"1.0\": must be \"2.0\" or a later 2");
  EXPECT_EQ(error_with("/asset/minVersion", "2.1"),
            "asset.minVersion = \"2.1\": must be \"2.0\", which is what this program knows");
  EXPECT_EQ(error_with("/scene", -1), "scene = -1: must be a whole number >= 0");
  EXPECT_EQ(error_with("/scenes/0/nodes/0", 0.5), "scenes[0].nodes[0] = 0.5: must be a whole number >= 0");
  EXPECT_EQ(error_with("/nodes/0/mesh", "floor"), "nodes[0].mesh = \"floor\": must be a number");
  EXPECT_EQ(error_with("/nodes/0/mesh", -1), "nodes[0].mesh = -1: must be a whole number >= 0");
  EXPECT_EQ(error_with("/nodes/0/mesh", 4294967296), "nodes[0].mesh = 4294967296: must be below 2^31");
  EXPECT_EQ(error_with("/nodes/0/children/0", -2), "nodes[0].children[0] = -2: must be a whole number >= 0");
  EXPECT_EQ(error_with("/nodes/1/matrix", {1, 0, 0}), "nodes[1].matrix = an array: must be 16 numbers");
  EXPECT_EQ(error_with("/nodes/0/rotation", {0, 0, 0, 0}), "nodes[0].rotation = an array: must not be all 0");
  EXPECT_EQ(
      error_with("/nodes/0/extensions/KHR_lights_punctual/light", "0"),
      "nodes[0].extensions.KHR_lights_punctual.light = \"0\": must be a number; write 0, without quotation marks");
  EXPECT_EQ(error_with("/accessors/0/byteOffset", -4), "accessors[0].byteOffset = -4: must be a whole number >= 0");
  EXPECT_EQ(error_with("/materials/0/doubleSided", 1), "materials[0].doubleSided = 1: must be true or false");
  EXPECT_EQ(error_with("/materials/0/normalTexture/scale", "1"),
            "materials[0].normalTexture.scale = \"1\": must be a number; write 1, without quotation marks");
  EXPECT_EQ(error_with("/materials/0/pbrMetallicRoughness/baseColorFactor", {0.5}),
            "materials[0].pbrMetallicRoughness.baseColorFactor = an array: must be 4 numbers");
  EXPECT_EQ(error_with("/extensions/KHR_lights_punctual/lights/0/intensity", "bright"),
            "extensions.KHR_lights_punctual.lights[0].intensity = \"bright\": must be a number");
  EXPECT_EQ(error_with("/extensions/KHR_lights_punctual/lights/0/spot/outerConeAngle", "wide"),
            "extensions.KHR_lights_punctual.lights[0].spot.outerConeAngle = \"wide\": must be a number");
}

}  // namespace

}  // namespace litfog::test
