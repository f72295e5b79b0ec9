// SPDX-License-Identifier: Apache-2.0
// glTF as artists have it: what their exporters write beyond plain meshes and materials.
#include <OpenImageIO/imageio.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gtest/gtest.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/value_errors.h"
#include "litfog/files/light_file.h"
#include "scene/gltf_floor.h"

namespace litfog::test {
using namespace scene;

namespace {

constexpr int kByte = 5120;
constexpr int kUnsignedByte = 5121;
constexpr int kShort = 5122;
constexpr int kUnsignedShort = 5123;
constexpr int kFloat = 5126;

class GltfFeature : public GltfFileTest {
 protected:
  json& attributes() { return primitive()["attributes"]; }

  /// Returns the index of a buffer view.
  std::size_t add_view(const std::string& bytes) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    file_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}});
    buffer_ += bytes;
    file_["buffers"][0]["byteLength"] = buffer_.size();
    return file_["bufferViews"].size() - 1;
  }
  /// Returns the index of an accessor of tightly packed numbers.
  template <typename Number>
  std::size_t add(const std::vector<Number>& numbers, const char* type, std::size_t count, int component,
                  bool is_normalized = false) {
    const std::size_t view = add_view(bytes_of(numbers));
    file_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    if (is_normalized) file_["accessors"].back()["normalized"] = true;
    return file_["accessors"].size() - 1;
  }
  /// A texture of 2 x 1 texels in RGBA; returns its index.
  std::size_t add_texture(const std::vector<std::uint8_t>& rgba, const json& more = json::object()) {
    const std::string name = path("texture.png");
    const auto output = OIIO::ImageOutput::create(name);
    OIIO::ImageSpec spec(2, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    EXPECT_TRUE(output->open(name, spec) && output->write_image(OIIO::TypeDesc::UINT8, rgba.data()) && output->close());
    std::ifstream file(name, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    file_["images"].push_back({{"bufferView", add_view(bytes)}, {"mimeType", "image/png"}});
    json texture = more;
    if (!texture.contains("extensions")) texture["source"] = file_["images"].size() - 1;
    file_["textures"].push_back(texture);
    return file_["textures"].size() - 1;
  }
  Scene read_file() const { return read(file_, buffer_); }
  std::string error() const { return error_of(file_, buffer_); }

  std::string buffer_ = floor_bytes();
};

const Mesh& mesh_of(const Scene& scene) { return scene.models.at(0).at(0).mesh; }

TEST_F(GltfFeature, MaskTakesItsCoverageFromTheBaseTexture) {
  const std::vector<std::uint8_t> rgba{10, 20, 30, 40, 50, 60, 70, 80};
  material() = {
      {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", add_texture(rgba)}}}, {"metallicFactor", 0}}}};
  const std::vector<std::uint8_t> opaque{10, 20, 30, 255, 50, 60, 70, 255};
  EXPECT_EQ(read_file().materials.at(0).albedo->rgba, opaque);  // alpha is not its gloss
  EXPECT_FALSE(read_file().materials[0].least_coverage);
  material()["alphaMode"] = "MASK";
  EXPECT_EQ(read_file().materials[0].albedo->rgba, rgba);
  EXPECT_EQ(read_file().materials[0].least_coverage, 0.5f);
  material()["alphaCutoff"] = 0.2;
  material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.5};
  EXPECT_FLOAT_EQ(*read_file().materials[0].least_coverage, 0.4f);
  EXPECT_EQ(read_file().left_out, "");
  material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0};
  EXPECT_EQ(read_file().materials[0].least_coverage, std::numeric_limits<float>::infinity());
  material()["alphaCutoff"] = 0;
  EXPECT_FALSE(read_file().materials[0].least_coverage);
  material()["alphaMode"] = "CUTOUT";
  EXPECT_EQ(error(), "materials[0].alphaMode = \"CUTOUT\": must be OPAQUE, MASK or BLEND");
}

TEST_F(GltfFeature, BlendedMaterialIsAPaneOfItsAlphaWithAMaskAtHalf) {
  material()["alphaMode"] = "BLEND";
  material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.25};
  const Scene scene = read_file();
  EXPECT_EQ(scene.materials.at(0).opacity, 0.25f);
  EXPECT_EQ(scene.materials[0].least_coverage, 2.0f);
  EXPECT_EQ(scene.left_out, "");
  material()["alphaMode"] = "MASK";
  EXPECT_FALSE(read_file().materials.at(0).opacity);
}

TEST_F(GltfFeature, LightsChangeAsIfASceneFileStatedThem) {
  const Light before = read_file().lights.at(0).light;
  const auto changed = [&](const std::string& member, const std::string& value) {
    return read_scene(path("scene.gltf"), {}, {{"lights[0].threshold", "0.25"}, {member, value}}).lights.at(0).light;
  };
  const Light light = changed("lights[0].cone", R"({"profile": "smoothstep", "inner_deg": 10, "outer_deg": 30})");
  EXPECT_EQ(light.threshold, 0.25);
  EXPECT_EQ(light.cone.profile, ConeProfile::smoothstep);
  EXPECT_EQ(light.attenuation, before.attenuation);
  EXPECT_EQ(light.color, before.color);
  EXPECT_EQ(light.name, "lamp");
  EXPECT_EQ(changed("lights[0].color", "[1, 2, 3]").color, glm::dvec3(1, 2, 3));
  const auto error = [&](const std::string& member, const std::string& value) -> std::string {
    return sentence_of<InputError>([&] { changed(member, value); });
  };
  EXPECT_EQ(error("lights[0].threshold", "7"), "--set: lights[0].light.threshold = 7: must be in (0, 1); 7 % is 0.07");
  EXPECT_EQ(error("lights[1].threshold", "0.1"), "--set: lights[1]: is not there: the last one is lights[0]");
  EXPECT_EQ(error("lights[0].position", "[1, 2]"),
            "--set: lights[0].position = an array: must be an array of three numbers");
  EXPECT_EQ(error("fog_top_m", "9"),
            "--set: fog_top_m: must be a member of a light, such as lights[0].color: a glTF file has no others");
}

TEST_F(GltfFeature, LightsAreMovedAddedAndRemovedAndOthersStayExact) {
  const PlacedLight first = read_file().lights.at(0);
  const std::string place = path("scene.gltf");
  const std::string second = R"({"light": {"attenuation": {"quadratic": 2}}, "position": [4, 5, 6], "carried": true})";
  Scene scene = read_scene(place, {}, {{"lights[1]", second}});
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.light_members, (std::vector<std::string>{"lights[0]", "lights[1]"}));
  EXPECT_EQ(scene.light_entries, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(light_entry(scene.lights[0]), light_entry(first));
  EXPECT_EQ(scene.lights[1].position, glm::dvec3(4, 5, 6));
  EXPECT_TRUE(scene.lights[1].carried);
  scene = read_scene(place, {}, {{"lights[1]", second}, {"lights[0].position", "[1, 2, 3]"}});
  EXPECT_EQ(scene.lights.at(0).position, glm::dvec3(1, 2, 3));
  EXPECT_EQ(format_light(scene.lights[0].light), format_light(first.light));
  scene = read_scene(place, {},
                     {{"lights[1]", second},
                      {"lights[0]", "null"},
                      {"lights[1]", light_entry(first)},
                      {"lights[0].threshold", "0.25"}});
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].light.threshold, 0.25);
  EXPECT_EQ(scene.lights[0].light.attenuation.quadratic, 2);
  EXPECT_EQ(light_entry(scene.lights[1]), light_entry(first));
  EXPECT_EQ(read_scene(place, {}, {{"lights[0]", "null"}}).lights.size(), 0u);
}

TEST_F(GltfFeature, EmissionKeepsItsTexelsAndItsStrength) {
  const std::vector<std::uint8_t> rgba{10, 20, 30, 255, 200, 220, 240, 255};
  material()["emissiveTexture"] = {{"index", add_texture(rgba)}};
  material()["emissiveFactor"] = {1, 0.5, 0.25};
  material()["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 8;
  const Scene scene = read_file();
  EXPECT_EQ(scene.materials.at(0).emission->rgba, rgba);
  EXPECT_EQ(scene.materials[0].emissive, glm::vec3(8, 4, 2));
  material()["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 1e5;
  EXPECT_EQ(
      error(),
      "materials[0].extensions.KHR_materials_emissive_strength.emissiveStrength = 100000.0: must be in [0, 10000]");
}

TEST_F(GltfFeature, UnlitMaterialSendsItsBaseColor) {
  const std::vector<std::uint8_t> rgba{10, 20, 30, 255, 200, 220, 240, 255};
  material() = {{"pbrMetallicRoughness",
                 {{"baseColorTexture", {{"index", add_texture(rgba)}}}, {"baseColorFactor", {1, 0.5, 0.25, 1}}}},
                {"emissiveFactor", {1, 1, 1}},
                {"extensions", {{"KHR_materials_unlit", json::object()}}}};
  const Scene scene = read_file();
  EXPECT_TRUE(scene.materials.at(0).is_unlit);
  EXPECT_EQ(scene.materials[0].albedo->rgba, rgba);
  EXPECT_EQ(scene.materials[0].emissive, glm::vec3(1, 0.5f, 0.25f));
  EXPECT_EQ(scene.materials[0].specular, glm::vec3(0));
}

TEST_F(GltfFeature, MetalTakesTheDiffuseColorTexelByTexel) {
  const std::size_t base = add_texture({255, 255, 255, 255, 255, 255, 255, 255});
  const std::size_t metal = add_texture({0, 128, 255, 255, 0, 128, 0, 255});
  material() = {{"pbrMetallicRoughness",
                 {{"baseColorTexture", {{"index", base}}}, {"metallicRoughnessTexture", {{"index", metal}}}}}};
  const std::vector<std::uint8_t> expected{0, 0, 0, 255, 255, 255, 255, 255};
  EXPECT_EQ(read_file().materials.at(0).albedo->rgba, expected);
  material()["pbrMetallicRoughness"].erase("baseColorTexture");
  EXPECT_EQ(read_file().materials.at(0).albedo->rgba, expected);
}

TEST_F(GltfFeature, VertexColorsAreReadInAllTheirTypes) {
  const std::vector<std::uint8_t> levels{255, 0, 51, 0, 255, 102, 51, 102, 153, 255, 255, 255};
  const std::vector<std::uint16_t> shorts{65535, 0,     13107, 65535, 0,     65535, 26214, 0,
                                          13107, 26214, 39321, 13107, 65535, 65535, 65535, 65535};
  const std::vector<float> floats{1, 0, 0.2f, 0, 7, 0.4f, 0.2f, 0.4f, 0.6f, 1, 1, 1};
  const std::size_t accessors[] = {add(levels, "VEC3", 4, kUnsignedByte, true), add(floats, "VEC3", 4, kFloat),
                                   add(shorts, "VEC4", 4, kUnsignedShort, true)};
  file_["bufferViews"][file_["accessors"][accessors[0]]["bufferView"].get<std::size_t>()]["byteLength"] = 12;
  for (const std::size_t accessor : accessors) {
    attributes()["COLOR_0"] = accessor;
    const Scene scene = read_file();
    ASSERT_EQ(mesh_of(scene).details.size(), 4u);
    EXPECT_LT(glm::distance(glm::vec3(mesh_of(scene).details[0].color), glm::vec3(1, 0, 0.2f)), 1e-6f);
    EXPECT_LT(glm::distance(glm::vec3(mesh_of(scene).details[1].color), glm::vec3(0, 1, 0.4f)), 1e-6f);
    EXPECT_FLOAT_EQ(mesh_of(scene).details[1].color.a, accessor == accessors[2] ? 0 : 1);
    EXPECT_EQ(mesh_of(scene).details[1].emission_uv, mesh_of(scene).vertices[1].uv);
  }
  // A primitive of the same material that has none is white.
  json plain = primitive();
  plain["attributes"].erase("COLOR_0");
  file_["meshes"][0]["primitives"].push_back(plain);
  const Scene both = read_file();
  ASSERT_EQ(mesh_of(both).details.size(), 8u);
  EXPECT_EQ(mesh_of(both).details[4].color, glm::vec4(1));
}

// The extension's formula: offset, then rotation counter-clockwise in a picture whose v runs down, then scale.
TEST_F(GltfFeature, EachTextureHasItsTransformAndItsSet) {
  const double turn = 0.3;
  const std::size_t texture = add_texture({1, 2, 3, 255, 4, 5, 6, 255});
  attributes()["TEXCOORD_1"] = add(std::vector<float>{0.5f, 0, 0.5f, 1, 0.25f, 1, 0, 0.75f}, "VEC2", 4, kFloat);
  const json transform = {{"offset", {0.1, 0.2}}, {"rotation", turn}, {"scale", {2, 3}}};
  material() = {
      {"pbrMetallicRoughness",
       {{"baseColorTexture", {{"index", texture}, {"extensions", {{"KHR_texture_transform", transform}}}}}}},
      {"normalTexture", {{"index", texture}}},
      {"emissiveTexture", {{"index", texture}, {"extensions", {{"KHR_texture_transform", {{"texCoord", 1}}}}}}},
      {"emissiveFactor", {1, 1, 1}}};
  const Scene scene = read_file();
  const Mesh& mesh = mesh_of(scene);
  const glm::vec2 given[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  ASSERT_EQ(mesh.details.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const double u = 2 * given[i].x;
    const double v = 3 * given[i].y;
    const glm::vec2 expected(0.1 + std::cos(turn) * u + std::sin(turn) * v,
                             0.2 - std::sin(turn) * u + std::cos(turn) * v);
    EXPECT_LT(glm::distance(mesh.vertices[i].uv, expected), 1e-6f);
    EXPECT_EQ(mesh.details[i].normal_uv, given[i]);
    // By the normal map's coordinates, whose u grows to +x.
    EXPECT_LT(glm::distance(glm::vec3(mesh.vertices[i].tangent), glm::vec3(1, 0, 0)), 1e-6f);
  }
  EXPECT_EQ(mesh.details[2].emission_uv, glm::vec2(0.25f, 1));
}

TEST_F(GltfFeature, PicturesAreSampledAsTheirSamplersSay) {
  material() = {{"pbrMetallicRoughness",
                 {{"metallicFactor", 0},
                  {"baseColorTexture", {{"index", add_texture({1, 2, 3, 255, 4, 5, 6, 255}, {{"sampler", 0}})}}}}}};
  file_["samplers"] = {json::object()};
  EXPECT_EQ(read_file().materials.at(0).albedo->sampling, Sampling{});
  file_["samplers"][0] = {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}, {"minFilter", 9985}};
  const Sampling given{.wrap_u = Sampling::Wrap::clamp,
                       .wrap_v = Sampling::Wrap::mirror,
                       .magnified = Sampling::Filter::nearest,
                       .minified = Sampling::Filter::linear,
                       .mipmaps = Sampling::Mipmaps::nearest};
  EXPECT_EQ(read_file().materials[0].albedo->sampling, given);
  // The same picture by another sampler is another texture.
  file_["textures"].push_back({{"source", 0}});
  material()["normalTexture"]["index"] = 1;
  EXPECT_EQ(read_file().materials[0].albedo->sampling, given);
  EXPECT_EQ(read_file().materials[0].normal->sampling, Sampling{});
  using enum Sampling::Mipmaps;
  for (const auto& [filter, mipmaps] :
       {std::pair(9728, none), {9729, none}, {9984, nearest}, {9985, nearest}, {9986, linear}, {9987, linear}}) {
    file_["samplers"][0]["minFilter"] = filter;
    EXPECT_EQ(read_file().materials[0].albedo->sampling.mipmaps, mipmaps) << filter;
    EXPECT_EQ(read_file().materials[0].albedo->sampling.minified == Sampling::Filter::linear, filter % 2 == 1);
  }
  file_["samplers"][0]["wrapS"] = 1;
  EXPECT_EQ(error(), "samplers[0].wrapS = 1: must be 10497, 33071 or 33648");
}

TEST_F(GltfFeature, QuantisedMeshIsTheFloorWithinItsSteps) {
  file_["extensionsRequired"] = {"KHR_mesh_quantization"};
  const std::int16_t most = 32767;
  const std::int16_t least = -32767;
  attributes()["POSITION"] =
      add(std::vector<std::int16_t>{least, 0, least, most, 0, least, most, 0, most, least, 0, most}, "VEC3", 4, kShort,
          true);
  attributes()["NORMAL"] =
      add(std::vector<std::int8_t>{0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 127, 0, 0}, "VEC3", 4, kByte, true);
  file_["bufferViews"].back()["byteStride"] = 4;
  attributes()["TEXCOORD_0"] = add(std::vector<std::uint16_t>{0, 0, 4, 0, 4, 4, 0, 4}, "VEC2", 4, kUnsignedShort);
  file_["nodes"][0]["scale"] = {10, 10, 10};
  const Scene scene = read_file();
  const Scene plain = read(floor_scene());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(glm::distance(mesh_of(scene).vertices[i].position, mesh_of(plain).vertices[i].position), 1e-5f);
    EXPECT_EQ(mesh_of(scene).vertices[i].normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(mesh_of(scene).vertices[i].uv, 4.0f * mesh_of(plain).vertices[i].uv);
  }
}

TEST_F(GltfFeature, SparseAccessorReplacesSomeOfItsNumbers) {
  const std::size_t indices = add_view(bytes_of(std::vector<std::uint16_t>{1, 3}));
  const std::size_t values = add_view(bytes_of(std::vector<float>{7, 1, 7, 8, 2, 8}));
  file_["accessors"][0]["sparse"] = {{"count", 2},
                                     {"indices", {{"bufferView", indices}, {"componentType", kUnsignedShort}}},
                                     {"values", {{"bufferView", values}}}};
  const Scene scene = read_file();
  const glm::vec3 expected[] = {{-10, 0, -10}, {7, 1, 7}, {10, 0, 10}, {8, 2, 8}};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(mesh_of(scene).vertices[i].position, expected[i]);
  file_["accessors"][0].erase("bufferView");  // the rest is 0
  EXPECT_EQ(mesh_of(read_file()).vertices[2].position, glm::vec3(0));
  file_["accessors"][0]["sparse"]["count"] = 3;
  EXPECT_EQ(error(), "accessors[0].sparse.count = 3: must be within its buffer views");
  file_["accessors"][0]["sparse"]["count"] = 2;
  file_["accessors"][0]["sparse"]["indices"]["bufferView"] = add_view(bytes_of(std::vector<std::uint16_t>{1, 4}));
  EXPECT_EQ(error(), "accessors[0].sparse.indices = an object: must be those of its elements");
}

// As exporters leave out the morph targets' numbers that are all 0.
TEST_F(GltfFeature, AccessorWithoutAViewIsZeros) {
  const std::size_t zeros = file_["accessors"].size();
  file_["accessors"].push_back({{"componentType", kFloat}, {"count", 4}, {"type", "VEC3"}});
  primitive()["targets"] = {{{"POSITION", zeros}, {"NORMAL", zeros}}};
  file_["meshes"][0]["weights"] = {1};
  EXPECT_EQ(mesh_of(read_file()).vertices[3].position, glm::vec3(-10, 0, 10));
  attributes()["COLOR_0"] = zeros;
  EXPECT_EQ(mesh_of(read_file()).details.at(3).color, glm::vec4(0, 0, 0, 1));
  file_["accessors"][zeros]["count"] = 1 << 30;
  EXPECT_EQ(error(), "accessors[" + std::to_string(zeros) + "].count = 1073741824: must be one that fits into a GiB");
}

TEST_F(GltfFeature, ViewWhoseElementsOverlapIsRefused) {
  for (const int stride : {8, 14, 256}) {
    file_["bufferViews"][0]["byteStride"] = stride;
    EXPECT_EQ(error(), "bufferViews[0].byteStride = " + std::to_string(stride) +
                           ": must be a multiple of 4, at most 252 and at least an element's 12 bytes");
  }
}

/// The floor's first two vertices on one joint of a skin, the others halfway between both joints.
class GltfPoseTest : public GltfFeature {
 protected:
  GltfPoseTest() {
    attributes()["JOINTS_0"] =
        add(std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, "VEC4", 4, kUnsignedByte);
    attributes()["WEIGHTS_0"] =
        add(std::vector<float>{1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4", 4, kFloat);
    const std::vector<float> unmoved{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const std::vector<float> lowered{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1};
    std::vector<float> matrices = unmoved;
    matrices.insert(matrices.end(), lowered.begin(), lowered.end());
    file_["nodes"][0] = {{"mesh", 0}, {"skin", 0}, {"translation", {500, 0, 0}}};  // which does not count
    file_["nodes"].push_back({{"children", {4, 5}}, {"scale", {0.1, 0.1, 0.1}}});
    file_["nodes"].push_back({{"translation", {0, 0, 7}}});
    file_["nodes"].push_back({{"translation", {0, 12, 0}}});
    file_["scenes"][0]["nodes"].push_back(3);
    file_["skins"] = {{{"joints", {4, 5}}, {"inverseBindMatrices", add(matrices, "MAT4", 2, kFloat)}}};
  }
};

TEST_F(GltfPoseTest, SkinnedMeshIsWhereItsJointsAre) {
  const Scene scene = read_file();
  const Mesh& mesh = mesh_of(scene);
  EXPECT_LT(glm::distance(mesh.vertices[0].position, glm::vec3(-1, 0, -0.3f)), 1e-6f);
  EXPECT_LT(glm::distance(mesh.vertices[1].position, glm::vec3(1, 0, -0.3f)), 1e-6f);
  // Halfway between (1, 0, 1.7) and (1, 1, 1): what was at 0 is 2 lower for the second joint, which is 12 up.
  EXPECT_LT(glm::distance(mesh.vertices[2].position, glm::vec3(1, 0.5f, 1.35f)), 1e-6f);
  EXPECT_LT(glm::distance(mesh.vertices[3].normal, glm::vec3(0, 1, 0)), 1e-6f);
  EXPECT_EQ(scene.left_out, "");
}

TEST_F(GltfPoseTest, SkinnedMeshFarFromTheOriginKeepsItsShape) {
  const Mesh near = mesh_of(read_file());
  file_["nodes"][3]["translation"] = {1e6, 0, -9e6};
  const Scene scene = read_file();
  const Mesh& mesh = mesh_of(scene);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const glm::dvec3 place = scene.instances.at(0).world_from_model * glm::dvec4(mesh.vertices[i].position, 1);
    EXPECT_LT(glm::distance(place - glm::dvec3(1e6, 0, -9e6), glm::dvec3(near.vertices[i].position)), 1e-4) << i;
  }
}

TEST_F(GltfPoseTest, NormalsTurnWithTheirJoints) {
  const double slant = std::sqrt(0.5);
  file_["nodes"][4]["rotation"] = {slant, 0, 0, slant};  // a quarter about x
  file_["nodes"][4]["scale"] = {1, 3, 1};
  const Mesh mesh = mesh_of(read_file());
  EXPECT_LT(glm::distance(mesh.vertices[0].normal, glm::vec3(0, 0, 1)), 1e-6f);
  attributes().erase("NORMAL");  // that of the triangle as it stands
  const Mesh flat = mesh_of(read_file());
  for (std::size_t i = 0; i < flat.vertices.size(); i += 3) {
    const glm::vec3 normal = glm::cross(flat.vertices[i + 1].position - flat.vertices[i].position,
                                        flat.vertices[i + 2].position - flat.vertices[i].position);
    EXPECT_LT(glm::distance(flat.vertices[i].normal, glm::normalize(normal)), 1e-5f);
  }
}

TEST_F(GltfPoseTest, WeightsAreTakenOverTheirSum) {
  attributes()["WEIGHTS_0"] = add(std::vector<std::uint8_t>{100, 0, 0, 0, 0, 0, 0, 0, 100, 100, 0, 0, 200, 200, 0, 0},
                                  "VEC4", 4, kUnsignedByte, true);
  const Mesh mesh = mesh_of(read_file());
  EXPECT_LT(glm::distance(mesh.vertices[0].position, glm::vec3(-1, 0, -0.3f)), 1e-6f);
  EXPECT_LT(glm::distance(mesh.vertices[1].position, glm::vec3(1, 0, -0.3f)), 1e-6f);  // none: by the first joint
  EXPECT_LT(glm::distance(mesh.vertices[2].position, glm::vec3(1, 0.5f, 1.35f)), 1e-6f);
}

TEST_F(GltfPoseTest, SkinsThatAreNotSoundFail) {
  const auto error_with = [&](const char* pointer, const json& value) {
    json file = file_;
    file[json::json_pointer(pointer)] = value;
    return error_of(file, buffer_);
  };
  EXPECT_EQ(error_with("/nodes/0/skin", 1), "nodes[0].skin = 1: must be in [0, 0]");
  EXPECT_EQ(error_with("/skins/0/joints", json::array()), "skins[0].joints = an array: must not be empty");
  EXPECT_EQ(error_with("/skins/0/joints/1", 9), "skins[0].joints[1] = 9: must be in [0, 5]");
  EXPECT_EQ(error_with("/nodes/3/children", {4}), "skins[0].joints[1] = 5: must be a node of the scene");
  EXPECT_EQ(error_with("/skins/0/joints", {4, 5, 3}),
            "skins[0].inverseBindMatrices = 6: must have a matrix for each joint");
  EXPECT_EQ(error_with("/skins/0/joints", {4}),
            "meshes[0].primitives[0] = an object: must have joints that its skin has");
  file_["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  EXPECT_EQ(error(), "meshes[0].primitives[0].attributes.WEIGHTS_0: must be given");
  file_["meshes"][0]["primitives"][0]["attributes"].erase("JOINTS_0");
  EXPECT_EQ(error(), "meshes[0].primitives[0].attributes.JOINTS_0: must be given");
}

TEST_F(GltfFeature, MorphTargetsDisplaceByTheirWeights) {
  const std::size_t up = add(std::vector<float>{0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0}, "VEC3", 4, kFloat);
  const std::size_t along = add(std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3", 4, kFloat);
  primitive()["targets"] = {{{"POSITION", up}}, {{"POSITION", along}, {"NORMAL", along}}};
  EXPECT_EQ(mesh_of(read_file()).vertices[3].position, glm::vec3(-10, 0, 10));
  file_["meshes"][0]["weights"] = {0.5, 0};
  EXPECT_EQ(mesh_of(read_file()).vertices[3].position, glm::vec3(-10, 1, 10));
  file_["nodes"][0]["weights"] = {0, 1};  // instead of the mesh's
  file_["nodes"].push_back({{"mesh", 0}, {"translation", {0, 5, 0}}});
  file_["scenes"][0]["nodes"].push_back(3);
  const Scene scene = read_file();
  const Mesh& mesh = mesh_of(scene);
  ASSERT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.vertices[3].position, glm::vec3(-9, 0, 10));
  EXPECT_LT(glm::distance(mesh.vertices[3].normal, glm::vec3(std::sqrt(0.5f), std::sqrt(0.5f), 0)), 1e-6f);
  EXPECT_EQ(mesh.vertices[7].position, glm::vec3(-10, 6, 10));
  EXPECT_EQ(mesh.vertices[7].normal, glm::vec3(0, 1, 0));
  EXPECT_EQ(scene.left_out, "");
  file_["accessors"][up]["count"] = 3;
  EXPECT_EQ(error(), "meshes[0].primitives[0].targets[0].POSITION = 4: must have as many elements as POSITION");
}

TEST_F(GltfFeature, SpotWithAHardEdgeIsSoftenedByAThousandthOfTheCosine) {
  json& light = file_["extensions"]["KHR_lights_punctual"]["lights"][0];
  const auto cone = [&](double inner, double outer) {
    light = {{"type", "spot"}, {"intensity", 900}, {"spot", {{"innerConeAngle", inner}, {"outerConeAngle", outer}}}};
    return read_file().lights.at(0).light.cone;
  };
  EXPECT_NEAR(std::cos(cone(0.5, 0.5).inner), std::cos(0.5) + 0.001, 1e-12);
  EXPECT_EQ(cone(0.5, 0.5).outer, 0.5);
  EXPECT_EQ(cone(0.01, 0.02).inner, 0);
  EXPECT_EQ(cone(0.3, 0.5).inner, 0.3);
  light["spot"]["innerConeAngle"] = 0.6;
  EXPECT_EQ(error(), "extensions.KHR_lights_punctual.lights[0] = an object: cone.inner must be in [0, outer)");
}

TEST_F(GltfFeature, StripsAndFansAreTheirTriangles) {
  using Indices = std::vector<std::uint32_t>;
  primitive()["indices"] = add(std::vector<std::uint16_t>{0, 3, 1, 2}, "SCALAR", 4, kUnsignedShort);
  primitive()["mode"] = 5;
  EXPECT_EQ(mesh_of(read_file()).indices, (Indices{0, 3, 1, 3, 2, 1}));
  primitive()["mode"] = 6;
  EXPECT_EQ(mesh_of(read_file()).indices, (Indices{3, 1, 0, 1, 2, 0}));
  primitive()["indices"] = add(std::vector<std::uint16_t>{0, 3}, "SCALAR", 2, kUnsignedShort);
  EXPECT_EQ(error(), "meshes[0].primitives[0].indices: must be three a triangle");
}

TEST_F(GltfFeature, MeshIsDrawnAtEachOfItsInstances) {
  const float slant = std::sqrt(0.5f);
  json& node = file_["nodes"][0];
  node["translation"] = {0, 1, 0};
  node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", add(std::vector<float>{0, 0, 0, 100, 0, 0}, "VEC3", 2, kFloat)},
      {"ROTATION", add(std::vector<float>{0, 0, 0, 1, slant, 0, 0, slant}, "VEC4", 2, kFloat)},
      {"SCALE", add(std::vector<float>{1, 1, 1, 1, 1, 2}, "VEC3", 2, kFloat)}};
  const Scene scene = read_file();
  ASSERT_EQ(mesh_of(scene).vertices.size(), 8u);
  EXPECT_LT(glm::distance(mesh_of(scene).vertices[0].position, glm::vec3(-10, 1, -10)), 1e-5f);
  EXPECT_LT(glm::distance(mesh_of(scene).vertices[4].position, glm::vec3(90, 21, 0)), 1e-4f);  // a quarter about x
  node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
      add(std::vector<float>{1, 1, 1}, "VEC3", 1, kFloat);
  EXPECT_EQ(error(), "nodes[0].extensions.EXT_mesh_gpu_instancing.attributes.SCALE = " +
                         std::to_string(file_["accessors"].size() - 1) +
                         ": must have as many elements as the other attributes");
}

TEST_F(GltfFeature, WebpPictureIsReadWithItsAlpha) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 256; ++i) rgba.insert(rgba.end(), {200, 100, std::uint8_t(i), 90});
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), 16, 16, 64, &encoded);
  write("picture.webp", std::string(encoded, encoded + size));
  WebPFree(encoded);
  file_["images"] = {{{"uri", "picture.webp"}}};
  file_["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
  file_["extensionsRequired"] = {"EXT_texture_webp"};
  material() = {{"alphaMode", "MASK"},
                {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}}};
  EXPECT_EQ(read_file().materials.at(0).albedo->rgba, rgba);
  write("picture.webp", "RIFF1234WEBP but no picture");
  EXPECT_EQ(error(), "images[0] = an object: must be a PNG, JPEG or WebP picture");
}

TEST_F(GltfFeature, Ktx2IsRefusedUnlessThereIsAnotherPicture) {
  const std::size_t texture = add_texture({1, 2, 3, 255, 4, 5, 6, 255});
  material() = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}, {"metallicFactor", 0}}}};
  file_["textures"][0]["extensions"]["KHR_texture_basisu"]["source"] = 1;
  file_["images"].push_back({{"uri", "none.ktx2"}});
  file_["extensionsUsed"].push_back("KHR_texture_basisu");
  EXPECT_EQ(read_file().left_out, "extensions KHR_texture_basisu");
  file_["textures"][0].erase("source");
  EXPECT_EQ(error(),
            "textures[0].source: must be given beside KHR_texture_basisu: this program reads PNG, JPEG and WebP, not "
            "KTX2; export the file with such pictures");
}

/// A mesh of 20 x 20 squares with heights.
struct Hills {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
};
Hills hills() {
  Hills made;
  for (int z = 0; z <= 20; ++z) {
    for (int x = 0; x <= 20; ++x) {
      made.positions.insert(made.positions.end(), {float(x), std::sin(float(x * z)), float(z)});
    }
  }
  for (std::uint32_t z = 0; z < 20; ++z) {
    for (std::uint32_t x = 0; x < 20; ++x) {
      const std::uint32_t at = 21 * z + x;
      made.indices.insert(made.indices.end(), {at, at + 21, at + 1, at + 1, at + 21, at + 22});
    }
  }
  return made;
}

using Corner = std::array<float, 3>;

/// The corners of all triangles, each triangle from its least corner on, sorted.
std::vector<std::array<Corner, 3>> sorted_triangles(std::vector<Corner> corners) {
  std::vector<std::array<Corner, 3>> triangles;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    auto& triangle = triangles.emplace_back(std::array<Corner, 3>{corners[i], corners[i + 1], corners[i + 2]});
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  }
  std::ranges::sort(triangles);
  return triangles;
}
std::vector<std::array<Corner, 3>> triangles_of(const Mesh& mesh) {
  std::vector<Corner> corners;
  for (const std::uint32_t index : mesh.indices) {
    const glm::vec3& position = mesh.vertices[index].position;
    corners.push_back({position.x, position.y, position.z});
  }
  return sorted_triangles(corners);
}
std::vector<std::array<Corner, 3>> triangles_of(const Hills& given) {
  std::vector<Corner> corners;
  for (const std::uint32_t index : given.indices) {
    const float* const at = &given.positions[std::size_t{3} * index];
    corners.push_back({at[0], at[1], at[2]});
  }
  return sorted_triangles(corners);
}

class GltfCompression : public GltfFeature {
 protected:
  /// Makes the hills, Draco's, the file's only mesh; returns where their bytes are in the buffer.
  std::pair<std::size_t, std::size_t> compress_by_draco() {
    const Hills given = hills();
    draco::TriangleSoupMeshBuilder builder;
    builder.Start(int(given.indices.size() / 3));
    const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
    const auto corner = [&](std::size_t i) { return &given.positions[std::size_t{3} * given.indices[i]]; };
    for (std::size_t i = 0; i < given.indices.size(); i += 3) {
      builder.SetAttributeValuesForFace(position, draco::FaceIndex(std::uint32_t(i / 3)), corner(i), corner(i + 1),
                                        corner(i + 2));
    }
    const auto mesh = builder.Finalize();
    draco::Encoder encoder;  // without quantisation, so that nothing is lost
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    draco::EncoderBuffer encoded;
    EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &encoded).ok());
    const std::size_t view = add_view(std::string(encoded.data(), encoded.size()));
    json& accessors = file_["accessors"];
    accessors.push_back({{"componentType", kFloat}, {"count", mesh->num_points()}, {"type", "VEC3"}});
    accessors.push_back({{"componentType", kUnsignedShort}, {"count", given.indices.size()}, {"type", "SCALAR"}});
    primitive()["attributes"] = {{"POSITION", accessors.size() - 2}};
    primitive()["indices"] = accessors.size() - 1;
    primitive()["extensions"]["KHR_draco_mesh_compression"] = {
        {"bufferView", view}, {"attributes", {{"POSITION", mesh->attribute(position)->unique_id()}}}};
    file_["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    return {buffer_.size() - encoded.size(), encoded.size()};
  }

  /// Makes bytes those of a view that stands in a buffer which is not there.
  void compress_view(const std::vector<unsigned char>& encoded, std::size_t size, const json& more) {
    const std::size_t compressed = add_view(std::string(encoded.begin(), encoded.end()));
    json extension = file_["bufferViews"][compressed];
    extension.update(more);
    file_["buffers"][1] = {{"byteLength", 1 << 20},
                           {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}};
    file_["bufferViews"].push_back(
        {{"buffer", 1}, {"byteLength", size}, {"extensions", {{"EXT_meshopt_compression", extension}}}});
    file_["extensionsRequired"] = {"EXT_meshopt_compression"};
  }

  /// The same by meshopt.
  std::pair<std::size_t, std::size_t> compress_by_meshopt() {
    const Hills given = hills();
    const std::size_t vertices = given.positions.size() / 3;
    std::vector<unsigned char> encoded(meshopt_encodeVertexBufferBound(vertices, 12));
    encoded.resize(meshopt_encodeVertexBuffer(encoded.data(), encoded.size(), given.positions.data(), vertices, 12));
    compress_view(encoded, 12 * vertices, {{"byteStride", 12}, {"count", vertices}, {"mode", "ATTRIBUTES"}});
    json& accessors = file_["accessors"];
    accessors.push_back({{"bufferView", file_["bufferViews"].size() - 1},
                         {"componentType", kFloat},
                         {"count", vertices},
                         {"type", "VEC3"}});
    const std::size_t first = buffer_.size() - encoded.size();
    encoded.resize(meshopt_encodeIndexBufferBound(given.indices.size(), vertices));
    encoded.resize(
        meshopt_encodeIndexBuffer(encoded.data(), encoded.size(), given.indices.data(), given.indices.size()));
    compress_view(encoded, 4 * given.indices.size(),
                  {{"byteStride", 4}, {"count", given.indices.size()}, {"mode", "TRIANGLES"}});
    accessors.push_back({{"bufferView", file_["bufferViews"].size() - 1},
                         {"componentType", 5125},
                         {"count", given.indices.size()},
                         {"type", "SCALAR"}});
    primitive()["attributes"] = {{"POSITION", accessors.size() - 2}};
    primitive()["indices"] = accessors.size() - 1;
    return {first, buffer_.size() - first};
  }
};

TEST_F(GltfCompression, DracoMeshIsTheOneThatWasCompressed) {
  compress_by_draco();
  const Scene scene = read_file();
  EXPECT_EQ(triangles_of(mesh_of(scene)), triangles_of(hills()));
  EXPECT_EQ(triangle_count(scene.models[0]), 800u);
}

TEST_F(GltfCompression, DracoMeshThatIsNotAsStatedFails) {
  const auto [first, size] = compress_by_draco();
  json& extension = primitive()["extensions"]["KHR_draco_mesh_compression"];
  const std::string where = "meshes[0].primitives[0].extensions.KHR_draco_mesh_compression";
  extension["attributes"]["POSITION"] = 9;
  EXPECT_EQ(error(), where +
                         ".attributes.POSITION = 9: must be an attribute of the compressed mesh, as its accessor "
                         "states");
  buffer_.replace(first, 5, "Draco");
  EXPECT_EQ(error().find(where + " = an object: must be sound: "), 0u) << error();
}

TEST_F(GltfCompression, MeshoptMeshIsTheOneThatWasCompressed) {
  compress_by_meshopt();
  EXPECT_EQ(triangles_of(mesh_of(read_file())), triangles_of(hills()));
  file_["buffers"][1].erase("extensions");  // a buffer that is not there needs no mark: nothing asks for it
  EXPECT_EQ(triangles_of(mesh_of(read_file())), triangles_of(hills()));
  file_["bufferViews"].back()["extensions"]["EXT_meshopt_compression"]["count"] = 2401;
  EXPECT_EQ(error(), "bufferViews[7].extensions.EXT_meshopt_compression.count = 2401: must be three a triangle");
}

// Normals of 16 bits on the octahedron, and heights as powers of two.
TEST_F(GltfCompression, MeshoptFiltersAreUndone) {
  const std::vector<float> normals{0, 1, 0, 0, 0.6f, 0.8f, 0, 0, 0, -0.8f, 0.6f, 0, 1, 0, 0, 0};
  std::vector<std::int16_t> octahedral(16);
  meshopt_encodeFilterOct(octahedral.data(), 4, 8, 16, normals.data());
  std::vector<unsigned char> encoded(meshopt_encodeVertexBufferBound(4, 8));
  encoded.resize(meshopt_encodeVertexBuffer(encoded.data(), encoded.size(), octahedral.data(), 4, 8));
  compress_view(encoded, 32, {{"byteStride", 8}, {"count", 4}, {"mode", "ATTRIBUTES"}, {"filter", "OCTAHEDRAL"}});
  file_["bufferViews"].back()["byteStride"] = 8;
  file_["accessors"].push_back({{"bufferView", file_["bufferViews"].size() - 1},
                                {"componentType", kShort},
                                {"normalized", true},
                                {"count", 4},
                                {"type", "VEC3"}});
  attributes()["NORMAL"] = file_["accessors"].size() - 1;
  const std::vector<float> uvs{0, 1.5f, 2.25f, 3, 1000, 5, 6, 7};
  std::vector<std::uint32_t> exponential(8);
  meshopt_encodeFilterExp(exponential.data(), 4, 8, 20, uvs.data());
  encoded.resize(meshopt_encodeVertexBufferBound(4, 8));
  encoded.resize(meshopt_encodeVertexBuffer(encoded.data(), encoded.size(), exponential.data(), 4, 8));
  compress_view(encoded, 32, {{"byteStride", 8}, {"count", 4}, {"mode", "ATTRIBUTES"}, {"filter", "EXPONENTIAL"}});
  file_["accessors"].push_back(
      {{"bufferView", file_["bufferViews"].size() - 1}, {"componentType", kFloat}, {"count", 4}, {"type", "VEC2"}});
  attributes()["TEXCOORD_0"] = file_["accessors"].size() - 1;
  const Scene scene = read_file();
  for (std::size_t i = 0; i < 4; ++i) {
    const Vertex& vertex = mesh_of(scene).vertices[i];
    EXPECT_LT(glm::distance(vertex.normal, glm::vec3(normals[4 * i], normals[4 * i + 1], normals[4 * i + 2])), 1e-4f);
    EXPECT_LT(glm::distance(vertex.uv, glm::vec2(uvs[2 * i], uvs[2 * i + 1])), 1e-2f);
  }
  file_["bufferViews"].back()["extensions"]["EXT_meshopt_compression"]["filter"] = "COLOR";
  EXPECT_EQ(error(),
            "bufferViews[7].extensions.EXT_meshopt_compression.filter = \"COLOR\": must be NONE, OCTAHEDRAL, "
            "QUATERNION or EXPONENTIAL");
}

TEST_F(GltfFeature, WhatIsLeftOutIsSaidInOneLine) {
  file_["animations"] = {json::object(), json::object()};
  json points = primitive();
  points["mode"] = 0;
  file_["meshes"][0]["primitives"].push_back(points);
  material()["occlusionTexture"]["index"] = 0;
  material()["extensions"]["KHR_materials_ior"]["ior"] = 1.3;  // not listed as used
  material()["emissiveTexture"] = {{"index", add_texture({9, 9, 9, 9, 9, 9, 9, 9})}, {"texCoord", 1}};
  for (const json& scale : {json{1, 0, 1}, json{0, 0, 0}}) {  // the second one is how files hide a mesh
    file_["scenes"][0]["nodes"].push_back(file_["nodes"].size());
    file_["nodes"].push_back({{"mesh", 0}, {"scale", scale}});
  }
  file_["scenes"].push_back(json::object());
  file_["cameras"].push_back({{"type", "orthographic"}});
  for (const std::size_t camera : {0u, 1u}) {
    file_["scenes"][0]["nodes"].push_back(file_["nodes"].size());
    file_["nodes"].push_back({{"camera", camera}});
  }
  file_["extensionsUsed"] = {"KHR_materials_sheen", "KHR_lights_punctual", "KHR_materials_clearcoat"};
  testing::internal::CaptureStderr();
  const Scene scene = read_file();
  const std::string line = testing::internal::GetCapturedStderr();
  EXPECT_EQ(scene.left_out,
            "2 animations, 1 primitive of points or lines, 1 occlusion texture, 1 primitive without its textures' "
            "coordinates, 1 mesh flattened by a scale of 0, 1 orthographic camera, 1 other camera, 1 other scene, "
            "extensions KHR_materials_clearcoat KHR_materials_ior KHR_materials_sheen");
  EXPECT_EQ(line, path("scene.gltf") + ": left out: " + scene.left_out + "\n");
  file_ = floor_scene();
  testing::internal::CaptureStderr();
  EXPECT_EQ(read_file().left_out, "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace

}  // namespace litfog::test
