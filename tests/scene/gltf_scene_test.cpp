// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_scene.h"

#include <OpenImageIO/imageio.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <tuple>

#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "litfog/attenuation.h"
#include "litfog/input_error.h"
#include "scene/file/scene_file.h"
#include "scene/gltf_floor.h"

namespace litfog::test {
using namespace scene;

namespace {

using std::numbers::pi;

class GltfScene : public GltfFileTest {};

TEST_F(GltfScene, MeshesAreAtTheirNodesAndTheCameraAtItsOwn) {
  file_["nodes"][0] = {{"translation", {1, 2, 3}}, {"scale", {1, 1, 0.5}}, {"children", {3}}};
  file_["nodes"].push_back({{"mesh", 0}, {"rotation", {0, 0.70710678, 0, 0.70710678}}});
  const Scene scene = read(file_);
  ASSERT_EQ(scene.instances.size(), 1u);
  const Bounds box = bounds(scene.models.at(0));
  EXPECT_LT(glm::distance(box.low, glm::vec3(-9, 2, -2)), 1e-5f);
  EXPECT_LT(glm::distance(box.high, glm::vec3(11, 2, 8)), 1e-5f);
  EXPECT_EQ(triangle_count(scene.models[0]), 2u);
  EXPECT_LT(glm::distance(scene.camera.position, glm::dvec3(0, 5, 5)), 1e-6);
  const double slant = std::sqrt(0.5);
  const glm::dvec3 view = scene.camera.target - scene.camera.position;
  EXPECT_LT(glm::distance(glm::normalize(view), glm::dvec3(0, -slant, -slant)), 1e-6);
  EXPECT_NEAR(glm::dot(scene.camera.target - glm::dvec3(box.low + box.high) / 2.0, view), 0,
              1e-4);  // as far as the middle
  EXPECT_EQ(scene.left_out, "");
  EXPECT_FLOAT_EQ(scene.camera.field_of_view, 0.9f);
}

// Of floats from the world's origin none would be within 3 cm there, and the floor's slanted edges would have steps.
TEST_F(GltfScene, MeshesFarFromTheOriginKeepTheirShape) {
  const double turn = 0.3;
  const glm::dvec3 place(1'000'000.25, 30.5, -9'876'543.1);
  file_["nodes"][0] = {{"mesh", 0},
                       {"translation", {place.x, place.y, place.z}},
                       {"rotation", {0, std::sin(turn / 2), 0, std::cos(turn / 2)}}};
  file_["nodes"].push_back({{"mesh", 0}});
  file_["scenes"][0]["nodes"] = {0, 3};
  const Scene scene = read(file_);
  ASSERT_EQ(scene.instances.size(), 2u);  // the near one has an origin of its own
  const glm::dmat4 world_from_node = glm::rotate(glm::translate(glm::dmat4(1), place), turn, glm::dvec3(0, 1, 0));
  const auto expect_floor = [&](const Instance& instance, const glm::dmat4& expected) {
    const Mesh& mesh = scene.models[instance.model][0].mesh;
    ASSERT_EQ(mesh.vertices.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec4 corner(i == 1 || i == 2 ? 10 : -10, 0, i > 1 ? 10 : -10, 1);
      const glm::dvec4 read = instance.world_from_model * glm::dvec4(mesh.vertices[i].position, 1);
      EXPECT_LT(glm::distance(read, expected * corner), 1e-4) << i;
    }
  };
  expect_floor(scene.instances[0], world_from_node);
  expect_floor(scene.instances[1], glm::dmat4(1));
}

TEST_F(GltfScene, ACameraThatLooksStraightUpOrDownKeepsItsUpright) {
  for (const double pitch : {-pi / 2, pi / 2}) {
    for (const double heading : {0.0, 0.7, 2.5}) {
      const glm::dquat rotation =
          glm::angleAxis(heading, glm::dvec3(0, 1, 0)) * glm::angleAxis(pitch, glm::dvec3(1, 0, 0));
      json file = floor_scene();
      file["nodes"][1] = {{"camera", 0},
                          {"translation", {300, 400, 500}},
                          {"rotation", {rotation.x, rotation.y, rotation.z, rotation.w}}};
      const Scene scene = read(file);
      const Camera& camera = scene.camera;
      EXPECT_TRUE(has_heading(camera));
      const glm::dmat4 view_from_world =
          glm::lookAt(glm::dvec3(camera.position), glm::dvec3(camera.target), glm::dvec3(0, 1, 0));
      EXPECT_LT(glm::distance(view_from_world * glm::dvec4(rotation * glm::dvec3(0, 1, 0), 0), {0, 1, 0, 0}), 2e-3);
      EXPECT_LT(glm::distance(view_from_world * glm::dvec4(rotation * glm::dvec3(0, 0, 1), 0), {0, 0, 1, 0}), 1.1e-3);
      EXPECT_EQ(scene.left_out, "");
    }
  }
}

TEST_F(GltfScene, ARolledCameraIsDrawnUprightAndSaysSo) {
  file_["nodes"][1]["rotation"] = {0, 0, std::sin(0.15), std::cos(0.15)};
  EXPECT_EQ(read(file_).left_out, "the camera's roll of 17 degrees");
}

TEST_F(GltfScene, ABinaryFileAndOneWithItsBufferBesideItAreTheSame) {
  const Scene text = read(floor_scene());
  const Scene binary = read_scene(write("BINARY.GLB", binary_file(floor_scene(), floor_bytes())));
  write("floor buffer.bin", floor_bytes() + "more");
  json beside = floor_scene();
  beside["buffers"][0]["uri"] = "floor%20buffer.bin";
  const Scene external = read_scene(write("beside.gltf", beside.dump()));
  for (const Scene* scene : {&binary, &external}) {
    ASSERT_EQ(triangle_count(scene->models.at(0)), 2u);
    const auto& vertices = text.models[0][0].mesh.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      EXPECT_EQ(scene->models[0][0].mesh.vertices[i].position, vertices[i].position);
    }
  }
}

TEST_F(GltfScene, APointLightHasItsCandela) {
  for (const double intensity : {0.01, 40.0, 900.0, 1e6, 1e10}) {
    light()["intensity"] = intensity;
    const PlacedLight placed = read(file_).lights.at(0);
    EXPECT_EQ(placed.light.name, "lamp");
    EXPECT_FALSE(placed.carried);
    EXPECT_LT(glm::distance(candela(placed.light), glm::dvec3(1, 0.5, 0.25) * intensity), 1e-14 * intensity);
    EXPECT_EQ(placed.light.source_radius, intensity == 0.01 ? 0.5 * std::sqrt(0.01 / 20) : 0.05);
    const Light near = photometric(placed.light);
    for (const double range : {0.0, 0.1, 1.0, 70.0}) {
      const double square = range * range + placed.light.source_radius * placed.light.source_radius;
      EXPECT_NEAR(kWhiteLux * near.color.r * attenuation_at(near.attenuation, range) * square / intensity, 1, 1e-12);
    }
    EXPECT_EQ(placed.light.threshold, 1.0 / 512) << "half of 1/256";
  }
  light()["intensity"] = 1e30;
  EXPECT_EQ(error_of(file_), "extensions.KHR_lights_punctual.lights[0].intensity = 1e+30: must be at most 10000000000");
}

TEST_F(GltfScene, ALightEndsAtItsRange) {
  for (const double range : {0.5, 7.0, 500.0}) {
    light()["range"] = range;
    const Scene scene = read(file_);
    const Light& given = scene.lights.at(0).light;
    EXPECT_NEAR(compute_extent(given.attenuation, given.threshold), range, 1e-12 * range);
    EXPECT_NEAR(candela(given).r, 40, 1e-12);
  }
}

TEST_F(GltfScene, ASpotAtTheCameraIsCarriedAndLooksWithIt) {
  json& lights = file_["extensions"]["KHR_lights_punctual"]["lights"];
  lights[0] = {{"type", "spot"}, {"intensity", 900}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}};
  file_["nodes"][1]["children"] = {2};
  file_["scenes"][0]["nodes"] = {0, 1};
  const Scene scene = read(file_);
  const PlacedLight& light = scene.lights.at(0);
  EXPECT_TRUE(light.carried);
  EXPECT_EQ(light.light.cone, Cone::smoothstep(0.1, 0.3));
  EXPECT_LT(glm::distance(light.direction, glm::dvec3(0, -std::sqrt(0.5), -std::sqrt(0.5))), 1e-7);
  EXPECT_NEAR(glm::distance(light.position, glm::dvec3(0, 5, 5)), std::sqrt(0.25 + 4), 1e-6);
}

TEST_F(GltfScene, ADirectionalLightIsTheMoon) {
  light() = {{"type", "directional"}, {"intensity", 0.2}};
  const Scene scene = read(file_);
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_NEAR(double(scene.environment.moon_color.r), 0.2 / 20, 1e-9);
  EXPECT_LT(glm::distance(scene.environment.moon_direction, glm::vec3(0, 0, 1)), 1e-6f);
}

TEST_F(GltfScene, TheBrightestOfSeveralDirectionalLightsIsTheMoon) {
  for (const double lux : {1., 3., 2.}) {
    json& lights = file_["extensions"]["KHR_lights_punctual"]["lights"];
    file_["scenes"][0]["nodes"].push_back(file_["nodes"].size());
    file_["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", lights.size()}}}}}});
    lights.push_back({{"type", "directional"}, {"intensity", lux}});
  }
  const Scene scene = read(file_);
  EXPECT_NEAR(double(scene.environment.moon_color.r), 3. / 20, 1e-7);
  EXPECT_EQ(scene.left_out, "2 directional lights but for the brightest");
}

// A night's fog before a sunlit scene would be black.
TEST_F(GltfScene, ADirectionalLightLightsFogAndSky) {
  const Scene night_scene = read(file_);
  const Environment& night = night_scene.environment;
  light() = {{"type", "directional"}, {"intensity", 68'300}, {"color", {1, 0.9, 0.8}}};
  const Scene day_scene = read(file_);
  const Environment& day = day_scene.environment;
  const glm::vec3 scattered = glm::vec3(1, 0.9f, 0.8f) * float(68'300 / (4 * 20.));
  const auto expect_near = [](const glm::vec3& actual, const glm::vec3& expected) {
    EXPECT_LT(glm::distance(actual, expected), 1e-6f * glm::length(expected));
  };
  expect_near(day_scene.atmosphere.ambient_fog_color, glm::vec3(night_scene.atmosphere.ambient_fog_color) + scattered);
  expect_near(day.sky_horizon, night.sky_horizon + scattered);
  const glm::vec3 zenith = scattered * night.sky_zenith / night.sky_horizon;
  expect_near(day.sky_zenith, night.sky_zenith + zenith);
  expect_near(day.ambient_light, night.ambient_light + (scattered + zenith) / 2.0f);
}

TEST_F(GltfScene, ASunIsTakenUpToTheEndOfHalfFloats) {
  light() = {{"type", "directional"}, {"intensity", 68'300}};
  EXPECT_NEAR(double(read(file_).environment.moon_color.r), 68'300 / 20., 1e-2);
  light()["intensity"] = 1'310'080;
  EXPECT_LE(read(file_).environment.moon_color.r, 65'504.0f);
  light()["intensity"] = 1'310'081;
  EXPECT_EQ(error_of(file_),
            "extensions.KHR_lights_punctual.lights[0].intensity = 1310081: must not show more than 65504 times the "
            "display's white");
}

TEST_F(GltfScene, TheFarthestCornerKeeps37PercentOfItsContrastWhereNoVisibilityIsGiven) {
  json seen_from_afar = floor_scene();
  seen_from_afar["nodes"][1]["translation"] = {0, 300, 400};
  json without_camera = floor_scene();
  without_camera["scenes"][0]["nodes"] = {0, 2};
  for (const json& file : {floor_scene(), seen_from_afar, without_camera}) {
    const Scene scene = read(file);
    const Fog fog = Fog::from_visibility(FogMode::exp, suggested_visibility(scene));
    double least = 1;
    for (const double x : {-10.0, 10.0}) {
      for (const double z : {-10.0, 10.0}) {
        const double range = glm::distance(scene.camera.position, glm::dvec3(x, 0, z));
        least = std::min(least, std::exp(-fog.density * range));
      }
    }
    EXPECT_GT(least, std::cbrt(0.05) - 1e-5);
    EXPECT_LT(least, std::pow(0.05, 1 / 3.3) + 1e-5);  // rounded up by at most a tenth
  }
}

TEST_F(GltfScene, VisibilitiesHaveTwoSignificantDigits) {
  for (const auto& [scale, height, shown] :
       {std::tuple{1.0, 400.0, "4100 1300 410"}, {1.0, 0.5, "150 43 15"}, {0.1, 0.05, "15 4.3 1.5"}}) {
    file_["nodes"][0]["scale"] = {scale, scale, scale};
    file_["nodes"][1]["translation"] = {0, height, 0};
    EXPECT_EQ(fmt::format("{}", fmt::join(read(file_).visibilities, " ")), shown);
  }
}

TEST_F(GltfScene, AFileWithoutLightsOrCameraIsStillSeen) {
  file_["scenes"][0]["nodes"] = {0};
  const Scene scene = read(file_);
  const Environment& environment = scene.environment;
  EXPECT_EQ(environment.ambient_light, glm::vec3(0.3f));
  EXPECT_EQ(environment.moon_color, glm::vec3(0.6f));
  EXPECT_GT(glm::dot(glm::dvec3(environment.moon_direction), glm::normalize(scene.camera.position)), 0.5);
  EXPECT_FLOAT_EQ(glm::length(environment.moon_direction), 1);
  EXPECT_EQ(scene.atmosphere.ambient_fog_color, read(floor_scene()).atmosphere.ambient_fog_color);  // the night's
  EXPECT_GT(glm::length(scene.camera.position), 14.2);  // outside of the floor
  EXPECT_EQ(scene.camera.target, glm::dvec3(0));
}

TEST_F(GltfScene, MetallicRoughnessBecomesTheBasicModel) {
  material() = {{"pbrMetallicRoughness",
                 {{"baseColorFactor", {0.5, 0.25, 1, 1}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}},
                {"emissiveFactor", {0, 0.5, 0}}};
  const Scene scene = read(file_);
  const Material& material = scene.materials.at(0);
  const float shininess = 2 / 0.0625f - 2;  // alpha = 0.25
  EXPECT_FLOAT_EQ(material.shininess, shininess);
  EXPECT_FLOAT_EQ(material.specular.g, (0.75f * 0.04f + 0.25f * 0.25f) * (shininess + 8) / 8);
  EXPECT_EQ(material.emissive, glm::vec3(0, 0.5f, 0));
  const std::vector<std::uint8_t> srgb{165, 120, 225, 255};  // from 0.375, 0.1875, 0.75
  EXPECT_EQ(material.albedo->rgba, srgb);
}

// 128 stands for 0 there; as rgb / 127.5 - 1, which pictures of normals are read by, it would tilt every surface.
TEST_F(GltfScene, WithoutANormalMapSurfacesAreFlat) {
  const std::vector<std::uint8_t> flat{128, 128, 255, 0};
  EXPECT_EQ(read(floor_scene()).materials.at(0).normal->rgba, flat);
}

TEST_F(GltfScene, PicturesAreReadFromFilesAndFromBuffers) {
  const std::vector<std::uint8_t> rgb{10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120};
  const std::string bytes = png(path("base.png"), rgb, 2);
  material() = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}}}};
  file_["textures"] = {{{"source", 0}}};
  file_["images"] = {{{"uri", "base.png"}}};
  const Scene external = read(file_);
  file_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 140}, {"byteLength", bytes.size()}});
  file_["buffers"][0]["byteLength"] = 140 + bytes.size();
  file_["images"] = {{{"bufferView", 4}, {"mimeType", "image/png"}}};
  const Scene embedded = read(file_, floor_bytes() + bytes);
  const std::vector<std::uint8_t> rgba{10, 20, 30, 255, 40, 50, 60, 255, 70, 80, 90, 255, 100, 110, 120, 255};
  for (const Scene* scene : {&external, &embedded}) {
    EXPECT_EQ(scene->materials.at(0).albedo->width, 2);
    EXPECT_EQ(scene->materials[0].albedo->height, 2);
    EXPECT_EQ(scene->materials[0].albedo->rgba, rgba);
  }
}

// "+Y up" in the picture, whose v runs down: here to +z, so that up is -z.
TEST_F(GltfScene, TheBitangentPointsUpInTheNormalMap) {
  const Scene scene = read(floor_scene());
  for (const Vertex& vertex : scene.models[0][0].mesh.vertices) {
    const glm::vec3 bitangent = glm::cross(vertex.normal, glm::vec3(vertex.tangent)) * vertex.tangent.w;
    EXPECT_LT(glm::distance(glm::vec3(vertex.tangent), glm::vec3(1, 0, 0)), 1e-6f);
    EXPECT_LT(glm::distance(bitangent, glm::vec3(0, 0, -1)), 1e-6f);
  }
}

TEST_F(GltfScene, AFileWithoutTrianglesFails) {
  file_["meshes"][0]["primitives"] = json::array();
  EXPECT_EQ(error_of(file_), "meshes: must hold triangles");
}

TEST_F(GltfScene, AFileWithoutACameraIsLargerThanAPoint) {
  file_["nodes"][0]["scale"] = {1.2e-6, 1.2e-6, 1.2e-6};
  file_["nodes"][0]["translation"] = {1e6, 0, 1e6};  // 448 m from a multiple of 1024 m: floats resolve 31 micrometres
  EXPECT_EQ(read(file_).camera.position, glm::dvec3(0, 5, 5));
  file_["scenes"][0]["nodes"] = {0};
  EXPECT_EQ(error_of(file_), "meshes: must be larger than a point");
}

TEST_F(GltfScene, APointLightNeedsNoDirection) {
  file_["nodes"][2]["scale"] = {0, 0, 0};
  EXPECT_EQ(read(file_).lights.at(0).position, glm::dvec3(0.5, 2, 0));
}

TEST_F(GltfScene, ScaleOfZeroLeavesALightsAndTheCamerasDirection) {
  const double half = std::sqrt(0.5);
  file_["nodes"][1]["scale"] = {0, 1, 0};
  file_["nodes"][2]["scale"] = {0, 0, 0};
  file_["nodes"][2]["rotation"] = {-half, 0, 0, half};  // straight down
  light() = {{"type", "spot"}, {"spot", json::object()}};
  const Scene scene = read(file_);
  EXPECT_LT(glm::distance(scene.lights.at(0).direction, glm::dvec3(0, -1, 0)), 1e-12);
  EXPECT_EQ(scene.camera.position, glm::dvec3(0, 5, 5));
  EXPECT_LT(glm::distance(axes_of(scene.camera).forward, glm::dvec3(0, -half, -half)), 1e-6);
  light() = {{"type", "directional"}};
  EXPECT_LT(glm::distance(read(file_).environment.moon_direction, glm::vec3(0, 1, 0)), 1e-6f);
  file_["nodes"][2].erase("scale");
  file_["nodes"][2].erase("rotation");
  file_["nodes"][2].erase("translation");
  file_["nodes"][2]["matrix"] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 2, 0, 1};
  EXPECT_LT(glm::distance(read(file_).environment.moon_direction, glm::vec3(0, 0, 1)), 1e-6f);
}

TEST_F(GltfScene, RangeBeyondTheSceneEndsWithIt) {
  light()["range"] = 1e7;
  const Light meant = read(file_).lights.at(0).light;
  for (const double range : {1.00001e7, 1e12, 1.7e308}) {
    light()["range"] = range;
    EXPECT_EQ(read(file_).lights.at(0).light.threshold, meant.threshold) << range;
    EXPECT_EQ(read(file_).lights.at(0).light.attenuation, meant.attenuation) << range;
  }
}

TEST_F(GltfScene, NumbersThatFloatsRoundBeyondALimitAreTheLimit) {
  light() = {{"type", "spot"}, {"spot", {{"outerConeAngle", double(float(pi / 2))}}}};
  json& pbr = material()["pbrMetallicRoughness"];
  const double above = double(std::nextafter(1.0f, 2.0f));
  material()["alphaMode"] = "BLEND";
  material()["emissiveFactor"] = {above, 1.00016, 0};
  pbr["metallicFactor"] = above;
  pbr["roughnessFactor"] = above;
  pbr["baseColorFactor"] = {1.00016, 0, above, 1.00016};
  const Scene scene = read(file_);
  EXPECT_EQ(scene.lights.at(0).light.cone.outer, pi / 2);
  const Material& read_one = scene.materials.at(0);
  EXPECT_EQ(read_one.opacity, 1.0f);
  EXPECT_EQ(read_one.emissive, glm::vec3(1, 1, 0));
  EXPECT_EQ(read_one.plain_albedo, glm::vec3(0)) << "all of it is metal";
  pbr["metallicFactor"] = 0;
  EXPECT_EQ(read(file_).materials.at(0).plain_albedo, glm::vec3(1, 0, 1));

  pbr["baseColorFactor"] = {1.01, 0, 1, 1};
  EXPECT_EQ(error_of(file_),
            "materials[0].pbrMetallicRoughness.baseColorFactor = an array: must be 4 numbers in [0, 1]");
  pbr.erase("baseColorFactor");
  pbr["metallicFactor"] = 1.000001;
  EXPECT_TRUE(
      error_of(file_).starts_with("materials[0].pbrMetallicRoughness.metallicFactor = 1.000001: must be in [0, 1]"));
  pbr.erase("metallicFactor");
  light()["spot"]["outerConeAngle"] = 1.571;
  EXPECT_EQ(error_of(file_),
            "extensions.KHR_lights_punctual.lights[0].spot.outerConeAngle = 1.571: must be at most pi/2");
}

TEST_F(GltfScene, WithoutNormalsEachTriangleIsFlat) {
  primitive()["attributes"].erase("NORMAL");
  const Scene scene = read(file_);
  ASSERT_EQ(scene.models[0][0].mesh.vertices.size(), 6u);
  for (const Vertex& vertex : scene.models[0][0].mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
}

TEST_F(GltfScene, ErrorsNameLocationValueAndRule) {
  const auto with = [](const std::string& pointer, const json& value) {
    json file = floor_scene();
    file[json::json_pointer(pointer)] = value;
    return file;
  };
  EXPECT_EQ(error_of(with("/nodes/0/mesh", 7)), "nodes[0].mesh = 7: must be in [0, 0]");
  EXPECT_EQ(error_of(with("/scene", 3)), "scene = 3: must be in [0, 0]");
  EXPECT_EQ(error_of(with("/accessors/0/count", 5)), "accessors[0].count = 5: must be > 0 and within its buffer view");
  EXPECT_EQ(error_of(with("/accessors/0/type", "VEC2")), "accessors[0].type = \"VEC2\": must be VEC3");
  EXPECT_EQ(error_of(with("/accessors/3/componentType", 5126)),
            "accessors[3].componentType = 5126: must be 5121 or 5123 or 5125");
  EXPECT_EQ(error_of(with("/bufferViews/0/byteLength", 1000)),
            "bufferViews[0].byteLength = 1000: must end within its buffer");
  EXPECT_EQ(error_of(with("/bufferViews/0/buffer", 2)), "bufferViews[0].buffer = 2: must be in [0, 0]");
  EXPECT_EQ(error_of(with("/meshes/0/primitives/0/mode", 7)), "meshes[0].primitives[0].mode = 7: must be at most 6");
  EXPECT_EQ(error_of(with("/meshes/0/primitives/0/mode", 1)), "meshes: must hold triangles");
  EXPECT_EQ(error_of(with("/extensionsRequired", {"KHR_texture_basisu"})),
            "extensionsRequired[0] = \"KHR_texture_basisu\": must not be required: this program reads PNG, JPEG and "
            "WebP, not KTX2; export the file with such pictures");
  EXPECT_EQ(error_of(with("/extensionsRequired", {"KHR_materials_diffuse_transmission"})),
            "extensionsRequired[0] = \"KHR_materials_diffuse_transmission\": must be one that this program knows: "
            "export the file without it");
  EXPECT_EQ(error_of(with("/nodes/0/children", {0})), "nodes[0] = an object: must be one node's child only");
  EXPECT_EQ(error_of(with("/nodes/2/extensions/KHR_lights_punctual/light", 1)),
            "nodes[2].extensions.KHR_lights_punctual.light = 1: must be in [0, 0]");
  EXPECT_EQ(error_of(with("/extensions/KHR_lights_punctual/lights/0/intensity", -1)),
            "extensions.KHR_lights_punctual.lights[0].intensity = -1: must be >= 0");
  EXPECT_EQ(error_of(with("/extensions/KHR_lights_punctual/lights/0/color", {1, 2e4, 1})),
            "extensions.KHR_lights_punctual.lights[0].color[1] = 20000.0: must be in [0, 10000]");
  EXPECT_EQ(error_of(with("/extensions/KHR_lights_punctual/lights/0/range", -2)),
            "extensions.KHR_lights_punctual.lights[0].range = -2: must be > 0");
  EXPECT_EQ(error_of(with("/materials/0/pbrMetallicRoughness/metallicFactor", 2)),
            "materials[0].pbrMetallicRoughness.metallicFactor = 2: must be in [0, 1]; 2 % is 0.02");
  EXPECT_EQ(error_of(with("/nodes/0/translation", {1e9, 0, 0})),
            "nodes[0] = an object: must lie within 10000000 metres");
  EXPECT_EQ(error_of(with("/nodes/0/mesh", "floor")), "nodes[0].mesh = \"floor\": must be a number");  // GltfValues
  std::string bad_index = floor_bytes();
  bad_index[128] = 4;
  EXPECT_EQ(error_of(floor_scene(), bad_index), "meshes[0].primitives[0].indices = 3: must be those of given vertices");
  json with_tangents = floor_scene();
  with_tangents["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = 4;
  with_tangents["accessors"].push_back({{"bufferView", 4}, {"componentType", 5126}, {"count", 4}, {"type", "VEC4"}});
  with_tangents["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 140}, {"byteLength", 64}});
  with_tangents["buffers"][0]["byteLength"] = 204;
  const std::vector<float> no_numbers(16, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(error_of(with_tangents, floor_bytes() + std::string(reinterpret_cast<const char*>(no_numbers.data()), 64)),
            "meshes[0].primitives[0].attributes = an object: must be finite and at most 10000000");
  const float infinity = std::numeric_limits<float>::infinity();
  for (const std::size_t at : {0u, 48u, 96u}) {  // in a position, a normal and a texture coordinate
    std::string infinite = floor_bytes();
    std::memcpy(infinite.data() + at, &infinity, sizeof(infinity));
    EXPECT_EQ(error_of(floor_scene(), infinite),
              "meshes[0].primitives[0].attributes = an object: must be finite and at most 10000000");
  }
}

TEST_F(GltfScene, PicturesThatCannotBeReadFail) {
  material() = {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}};
  file_["textures"] = {{{"source", 0}}};
  file_["images"] = {{{"uri", "none.png"}}};
  EXPECT_EQ(error_of(file_), "images[0] = an object: must be a picture that can be read: " + path("none.png") +
                                 ": cannot be read: No such file or directory");
  write("text.png", "no picture");
  file_["images"] = {{{"uri", "text.png"}}};
  EXPECT_EQ(error_of(file_), "images[0] = an object: must be a PNG, JPEG or WebP picture");
  const std::string whole = png(path("whole.png"), std::vector<std::uint8_t>(3 * 64 * 64, 77), 64);
  write("half.png", whole.substr(0, whole.size() / 2));
  file_["images"] = {{{"uri", "half.png"}}};
  testing::internal::CaptureStderr();  // to which libraries write of themselves
  EXPECT_EQ(error_of(file_).find("images[0] = an object: must be a sound picture: "), 0u) << error_of(file_);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(error_of(file_).find('\n'), std::string::npos) << error_of(file_);
}

TEST_F(GltfScene, FilesThatAreNoGltfFail) {
  EXPECT_THROW(read_scene(path("none.gltf")), InputError);
  EXPECT_THROW(read_scene(write("empty.gltf", "")), InputError);
  EXPECT_THROW(read_scene(write("empty.glb", "")), InputError);
  EXPECT_THROW(read_scene(write("text.glb", "glTF but not binary, and longer than its headers")), InputError);
  std::string old = binary_file(floor_scene(), floor_bytes());
  old[4] = 1;
  EXPECT_THROW(read_scene(write("old.glb", old)), InputError);
  EXPECT_THROW(read_scene(write("old.gltf", R"({"nodes": []})")), InputError);
  try {
    read_scene(write("comma.gltf", "{\"asset\": {\"version\": \"2.0\"},\n  }"));
    FAIL();
  } catch (const InputError& bad) {
    EXPECT_NE(std::string(bad.what()).find("comma.gltf:2:3: "), std::string::npos) << bad.what();
  }
}

TEST_F(GltfScene, BuffersThatAreNotAsStatedFail) {
  const auto error = [&](const json& buffer) {
    json file = floor_scene();
    file["buffers"] = {buffer};
    return error_as_given(file);
  };
  const std::string data = "data:application/octet-stream;base64,";
  EXPECT_EQ(error({{"uri", data + base64(floor_bytes())}}), "buffers[0].byteLength: must be given");
  EXPECT_EQ(error({{"byteLength", 140}}), "buffers[0].uri: must be given");
  EXPECT_EQ(error({{"byteLength", 141}, {"uri", data + base64(floor_bytes())}}),
            "buffers[0].byteLength = 141: must be at most the buffer's 140 bytes");
  EXPECT_EQ(error({{"byteLength", 3}, {"uri", data + "AAA!"}}),
            "buffers[0].uri = \"data:application/octet-stream;base64,AAA\"...: must hold base64 after its comma");
  EXPECT_EQ(error({{"byteLength", 3}, {"uri", "data:,abc"}}),
            "buffers[0].uri = \"data:,abc\": must be a data URI in base64");
  EXPECT_LT(error({{"byteLength", 3}, {"uri", data + std::string(5'000'000, '!')}}).size(), 200u);
  EXPECT_EQ(error({{"byteLength", 140}, {"uri", "none.bin"}}),
            "buffers[0] = an object: must be a buffer that can be read: " + path("none.bin") +
                ": cannot be read: No such file or directory");
}

TEST_F(GltfScene, AFileBesideItIsReadUpToItsLimitOnly) {
  write("large", "");
  std::filesystem::resize_file(path("large"), std::uintmax_t{3} << 30);  // sparse
  file_["buffers"][0]["uri"] = "large";
  EXPECT_EQ(error_as_given(file_), "no error");  // a buffer may be the beginning of a file
  std::filesystem::create_symlink("/dev/zero", path("endless"));
  file_["buffers"][0]["uri"] = "endless";
  EXPECT_EQ(error_as_given(file_), "buffers[0] = an object: must be a buffer that can be read: " + path("endless") +
                                       ": cannot be read: Is a device");
  json pictured = floor_scene();
  pictured["materials"][0] = {{"normalTexture", {{"index", 0}}}};
  pictured["textures"] = {{{"source", 0}}};
  pictured["images"] = {{{"uri", "large"}}};
  EXPECT_EQ(error_of(pictured), "images[0] = an object: must be a picture that can be read: " + path("large") +
                                    ": file: must not be larger than 268435456 bytes");
}

TEST_F(GltfScene, BuffersAreCountedBeforeTheyAreRead) {
  for (int i = 1; i < 4; ++i) file_["buffers"].push_back({{"uri", "none.bin"}, {"byteLength", 1 << 29}});
  EXPECT_EQ(error_of(file_), "buffers[2].byteLength = 536870912: buffers must be at most 1024 MiB in all");
}

TEST_F(GltfScene, ABinaryChunkEndsWithinItsFile) {
  file_["buffers"][0]["byteLength"] = 148;
  std::string bytes = binary_file(file_, floor_bytes());
  bytes[bytes.size() - 140 - 8] = char(148);  // the chunk's length
  EXPECT_EQ(sentence_of<InputError>([&] { read_scene(write("over.glb", bytes)); }),
            path("over.glb") + ": must not end within its binary chunk");
}

// 3 vertices and a million triangles of them: 20 nodes are within the limit.
TEST_F(GltfScene, EachNodeCountsTheTrianglesOfItsMesh) {
  constexpr std::size_t kIndices = 3'000'000;
  file_["accessors"][3] = {{"bufferView", 3}, {"componentType", 5121}, {"count", kIndices}, {"type", "SCALAR"}};
  file_["bufferViews"][3]["byteLength"] = kIndices;
  file_["buffers"][0]["byteLength"] = 128 + kIndices;
  for (std::size_t i = 3; i < 23; ++i) {
    file_["nodes"].push_back({{"mesh", 0}});
    file_["scenes"][0]["nodes"].push_back(i);
  }
  EXPECT_EQ(error_of(file_, floor_bytes().substr(0, 128) + std::string(kIndices, '\0')),
            "meshes[0].primitives[0] = an object: triangles must be at most 20000000 in all, vertices 20000000");
}

// Flat triangles take three vertices each, however few there are in the file.
TEST_F(GltfScene, AMeshIsCountedBeforeItIsMade) {
  constexpr std::size_t kIndices = 21'000'000;
  primitive()["attributes"] = {{"POSITION", 0}};
  file_["accessors"][3] = {{"bufferView", 3}, {"componentType", 5121}, {"count", kIndices}, {"type", "SCALAR"}};
  file_["bufferViews"][3]["byteLength"] = kIndices;
  file_["buffers"][0]["byteLength"] = 128 + kIndices;
  EXPECT_EQ(error_of(file_, floor_bytes().substr(0, 128) + std::string(kIndices, '\0')),
            "meshes[0].primitives[0] = an object: triangles must be at most 20000000 in all, vertices 20000000");
}

/// A grey PNG of 16,384 by 16,384 pixels, or of 16,385 by 1, up to its pixels.
std::string large_png(bool is_high) {
  return std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\x40", 19) +
         (is_high ? std::string("\0\0\0\x40\0\b\0\0\0\0\x8C\xA3\x4F\x58", 14)
                  : std::string("\1\0\0\0\1\b\0\0\0\0\xEC\x36\x82\xBA", 14)) +
         std::string("\0\0\0\0IDAT\x35\xAF\x06\x1E", 12);
}

TEST_F(GltfScene, PicturesWithTooManyPixelsFailBeforeTheyAreDecoded) {
  material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  file_["textures"] = {{{"source", 0}}};
  file_["images"] = {{{"uri", "large.png"}}};
  write("large.png", large_png(true));
  EXPECT_EQ(error_of(file_), "images[0] = an object: pictures must be at most 134217728 pixels in all");
  write("large.png", large_png(false));
  EXPECT_EQ(error_of(file_), "images[0] = an object: must be at most 16384 pixels a side");
}

// 33 times 2^22 texels would be more than all pictures may have.
TEST_F(GltfScene, MaterialsShareAPicture) {
  constexpr int kSide = 2048;
  png(path("atlas.png"), std::vector<std::uint8_t>(std::size_t{3} * kSide * kSide, 99), kSide);
  file_["textures"] = {{{"source", 0}}};
  file_["images"] = {{{"uri", "atlas.png"}}};
  const json floor = primitive();
  for (std::size_t i = 0; i < 33; ++i) {
    file_["materials"][i] = {
        {"normalTexture", {{"index", 0}}},
        {"pbrMetallicRoughness",
         {{"baseColorTexture", {{"index", 0}}}, {"metallicFactor", 0}, {"roughnessFactor", double(i) / 32}}}};
    file_["meshes"][0]["primitives"][i] = floor;
    file_["meshes"][0]["primitives"][i]["material"] = i;
  }
  for (const unsigned tinted : {31u, 32u}) {
    file_["materials"][tinted]["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 1, 1, 1};
  }
  const Scene scene = read(file_);
  ASSERT_EQ(scene.materials.size(), 33u);
  EXPECT_EQ(scene.materials[0].albedo, scene.materials[30].albedo);
  EXPECT_EQ(scene.materials[0].normal, scene.materials[32].normal);
  EXPECT_NE(scene.materials[30].albedo, scene.materials[31].albedo);
  EXPECT_EQ(scene.materials[31].albedo, scene.materials[32].albedo);
  EXPECT_LT(scene.materials[31].albedo->rgba[0], 99);
  EXPECT_GT(scene.materials[0].shininess, scene.materials[30].shininess);
}

}  // namespace

}  // namespace litfog::test
