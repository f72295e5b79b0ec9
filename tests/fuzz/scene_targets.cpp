// SPDX-License-Identifier: Apache-2.0
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "demo/sequence/camera_path.h"
#include "fuzz/fuzz_target.h"
#include "image/png_text.h"
#include "scene/file/gltf_scene.h"
#include "scene/file/scene_file.h"
#include "scene/gltf_bytes.h"
#include "text/csv.h"

namespace litfog::test {
namespace {

void read_csv(std::string_view bytes) {
  if (bytes.empty()) return;
  expect_read_or_refused(bytes, "table", [&] {
    std::FILE* const file = fmemopen(const_cast<char*>(bytes.data()), bytes.size(), "r");
    CsvReader reader(file, "table");
    CsvRecord record;
    while (reader.read(record)) {
      std::string quoted;  // the record's fields, written anew
      bool is_written = !record.error();
      for (std::size_t i = 0; i < record.size(); ++i) {
        EXPECT_GE(record.raw(i + 1).size(), record.raw(i).size());
        is_written = is_written && record.field(i).find_first_of("\r\n") == std::string_view::npos;
        quoted += (i > 0 ? "," : "") + csv_quoted(record.field(i));
      }
      if (!is_written || quoted.empty() || quoted.starts_with("\xEF\xBB\xBF")) continue;  // of which a mark is skipped
      std::FILE* const again = fmemopen(quoted.data(), quoted.size(), "r");
      CsvReader quoted_reader(again, "fields");
      CsvRecord same;
      EXPECT_TRUE(quoted_reader.read(same));
      EXPECT_EQ(same.size(), record.size()) << quoted;
      for (std::size_t i = 0; i < record.size(); ++i) EXPECT_EQ(same.field(i), record.field(i)) << quoted;
      std::fclose(again);
    }
    std::fclose(file);
  });
}

/// What a renderer relies on.
void expect_sound(const scene::Scene& scene) {
  for (const scene::Model& model : scene.models) {
    for (const auto& [material, mesh] : model) {
      for (const std::uint32_t index : mesh.indices) EXPECT_LT(index, mesh.vertices.size());
    }
  }
  for (const PlacedLight& light : scene.lights) EXPECT_FALSE(find_error(light));
  EXPECT_FALSE(find_error(scene.atmosphere));
}

void read_scene(std::string_view bytes) {
  const MemoryFile file(bytes);
  expect_read_or_refused(bytes, file.path(), [&] { expect_sound(scene::read_scene(file.path(), 10)); });
}

void read_camera_path(std::string_view bytes) {
  const MemoryFile file(bytes);
  expect_read_or_refused(bytes, file.path(), [&] {
    const demo::CameraPath path = demo::read_camera_path(file.path(), 0.8);
    for (const double fraction : {0., 0.3, 0.5, 1.}) {
      const scene::Camera camera = path.at(fraction);
      EXPECT_TRUE(std::isfinite(glm::length(camera.position)) && std::isfinite(glm::length(camera.target)));
      EXPECT_GT(camera.field_of_view, 0);
    }
  });
}

/// The bundled scenes, which find their lights from anywhere. Their models are left out: painting those of one takes a
/// minute under sanitizers.
std::vector<std::string> scene_seeds() {
  std::vector<std::string> seeds;
  for (const std::string& name : scene::bundled_scenes()) {
    std::ifstream file(scene::bundled_scene_path(name), std::ios::binary);
    json scene = json::parse(file);
    scene["objects"] = json::array();
    scene.erase("city");
    scene.erase("vehicle");
    std::string text = scene.dump(1);
    for (std::size_t at; (at = text.find("\"../lights")) != std::string::npos;) {
      text.replace(at + 1, 2, LITFOG_DATA_DIR);
    }
    seeds.push_back(text);
  }
  return seeds;
}

std::vector<std::string> camera_path_seeds() {
  return {R"({"litfog": "camera-path", "version": 1, "keyframes": [
    {"time_s": 0, "position": [0, 40, 500], "target": [0, 0, 0], "field_of_view_deg": 50},
    {"time_s": 2.5, "position": [0, 30, 300], "target": [0, 1, 0]},
    {"time_s": 9, "position": [0, 2, 1], "target": [0, 0, 0]}]})"};
}

void read_gltf(std::string_view bytes) {
  const MemoryFile file(bytes);
  expect_read_or_refused(bytes, file.path(), [&] { expect_sound(scene::read_gltf_scene(file.path())); });
}

std::vector<std::string> gltf_seeds() {
  json text = floor_scene();
  text["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(floor_bytes());
  return {text.dump(1), binary_file(floor_scene(), floor_bytes())};
}

/// The floor with some bytes as its last buffer view, 4.
void read_floor(json file, std::string_view bytes) {
  const std::string buffer = floor_bytes();
  file["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
  file["buffers"][0]["byteLength"] = buffer.size() + bytes.size();
  read_gltf(binary_file(file, buffer + std::string(bytes)));
}

void read_draco(std::string_view bytes) {
  json file = floor_scene();
  file["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  json& primitive = file["meshes"][0]["primitives"][0];
  primitive["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", 4}, {"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"TEXCOORD_0", 2}}}};
  read_floor(file, bytes);
}

std::vector<std::string> draco_seeds() {
  std::vector<std::string> seeds;
  for (const int method : {draco::MESH_EDGEBREAKER_ENCODING, draco::MESH_SEQUENTIAL_ENCODING}) {
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(2);
    constexpr std::array<std::array<float, 3>, 4> kCorners{{{-10, 0, -10}, {10, 0, -10}, {10, 0, 10}, {-10, 0, 10}}};
    constexpr std::array<float, 3> kUp{0, 1, 0};
    const auto add = [&](draco::GeometryAttribute::Type type, std::int8_t components, const auto& value_of) {
      const int id = builder.AddAttribute(type, components, draco::DT_FLOAT32);
      builder.SetAttributeValuesForFace(id, draco::FaceIndex(0), value_of(0), value_of(2), value_of(1));
      builder.SetAttributeValuesForFace(id, draco::FaceIndex(1), value_of(0), value_of(3), value_of(2));
    };
    add(draco::GeometryAttribute::POSITION, 3, [&](std::size_t i) { return kCorners[i].data(); });
    add(draco::GeometryAttribute::NORMAL, 3, [&](std::size_t) { return kUp.data(); });
    add(draco::GeometryAttribute::TEX_COORD, 2, [&](std::size_t i) { return kCorners[i].data(); });
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    draco::EncoderBuffer encoded;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*builder.Finalize(), &encoded).ok());
    seeds.emplace_back(encoded.data(), encoded.size());
  }
  return seeds;
}

/// The first byte says what is compressed, and how it is filtered.
void read_meshopt(std::string_view bytes) {
  if (bytes.empty()) return;
  constexpr std::array kModes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
  constexpr std::array kFilters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
  const auto choice = std::size_t{static_cast<unsigned char>(bytes[0])};
  const std::string mode = kModes[choice % 3];
  const bool are_attributes = mode == "ATTRIBUTES";
  const std::size_t stride = are_attributes ? (choice / 12 % 2 == 0 ? 12 : 8) : 4, count = are_attributes ? 4 : 6;
  json file = floor_scene();
  file["extensionsRequired"] = {"EXT_meshopt_compression"};
  file["buffers"].push_back(
      {{"byteLength", 1024}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  json view{{"buffer", 1}, {"byteLength", stride * count}};
  if (are_attributes) view["byteStride"] = stride;
  view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                   {"byteOffset", floor_bytes().size()},
                                                   {"byteLength", bytes.size() - 1},
                                                   {"byteStride", stride},
                                                   {"count", count},
                                                   {"mode", mode},
                                                   {"filter", kFilters[choice / 3 % 4]}};
  const std::size_t replaced = are_attributes ? 0 : 3;
  file["bufferViews"][replaced] = view;
  if (!are_attributes) file["accessors"][3]["componentType"] = 5125;
  if (stride == 8) {  // normals of bytes, positions of shorts
    file["accessors"][0]["componentType"] = 5122;
  }
  read_floor(file, bytes.substr(1));
}

std::vector<std::string> meshopt_seeds() {
  const std::string positions = floor_bytes().substr(0, 48);
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(4, 12));
  vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), positions.data(), 4, 12));
  const std::vector<unsigned> corners{0, 2, 1, 0, 3, 2};
  std::vector<unsigned char> triangles(meshopt_encodeIndexBufferBound(6, 4)), indices(100);
  triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), corners.data(), 6));
  indices.resize(meshopt_encodeIndexSequence(indices.data(), indices.size(), corners.data(), 6));
  std::vector<std::string> seeds;
  for (const auto& [choice, bytes] : {std::pair{0, vertices}, {9, vertices}, {1, triangles}, {2, indices}}) {
    seeds.push_back(std::string(1, char(choice)) + std::string(bytes.begin(), bytes.end()));
  }
  return seeds;
}

void read_picture(std::string_view bytes) {
  json file = floor_scene();
  file["images"] = {{{"bufferView", 4}, {"mimeType", "image/png"}}};
  file["textures"] = {{{"source", 0}}};
  file["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  file["materials"][0]["alphaMode"] = "MASK";
  read_floor(file, bytes);
}

std::vector<std::string> picture_seeds() {
  const std::vector<std::uint8_t> levels{255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 99, 199};
  std::uint8_t* webp = nullptr;
  const std::size_t size = WebPEncodeLosslessRGB(levels.data(), 2, 2, 6, &webp);
  const std::string lossless(reinterpret_cast<const char*>(webp), size);
  WebPFree(webp);
  const std::size_t lossy_size = WebPEncodeRGB(levels.data(), 2, 2, 6, 50, &webp);
  const std::string lossy(reinterpret_cast<const char*>(webp), lossy_size);
  WebPFree(webp);
  return {image::png_text(2, 2, levels), lossless, lossy};
}

const std::string kData = LITFOG_DATA_DIR;
const AddFuzzTargets kAdd{{"csv", read_csv, {kData + "/photometry"}},
                          {"scene", read_scene, {}, scene_seeds},
                          {"camera-path", read_camera_path, {}, camera_path_seeds},
                          {"gltf", read_gltf, {}, gltf_seeds},
                          {"gltf-draco", read_draco, {}, draco_seeds},
                          {"gltf-meshopt", read_meshopt, {}, meshopt_seeds},
                          {"gltf-picture", read_picture, {}, picture_seeds}};

}  // namespace
}  // namespace litfog::test
