// SPDX-License-Identifier: Apache-2.0
// Pictures of glTF files against the Basic model and the reference.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "command/temporary_directory.h"
#include "gl/gl_test.h"
#include "measure/picture_error.h"
#include "measure/reference_picture.h"
#include "scene/file/scene_file.h"
#include "scene/gltf_floor.h"

namespace litfog::test {
using namespace render;
using namespace scene;
using namespace measure;

namespace {

class GltfPicture : public test::GlTest {};

// In 8 bits of sRGB these would be the same colour, some percent off.
TEST_F(GltfPicture, ADarkColorIsNotRounded) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "floor.glb").string();
  json file = floor_scene();
  file["materials"][0] = {
      {"pbrMetallicRoughness", {{"baseColorFactor", {0.0041, 0.004, 0.0039, 1}}, {"metallicFactor", 0}}}};
  std::ofstream(path, std::ios::binary) << binary_file(file, floor_bytes());
  Scene scene = read_scene(path);
  scene.lights.clear();
  scene.environment.ambient_light = glm::vec3(100);
  Renderer renderer(scene, 80, 80, {});
  renderer.draw(LightPoints::off);
  const Picture picture = renderer.read();
  const float* const middle = &picture.rgb[std::size_t(3 * (40 * 80 + 40))];
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(middle[channel], 0.41f - 0.01f * float(channel), 1e-3f);
}

// Nodes, camera and lamp 1000 km away: the picture's floats stay near them.
TEST_F(GltfPicture, FarFloorLooksAsTheNearOne) {
  const test::TemporaryDirectory directory;
  const auto drawn = [&](const glm::dvec3& place) {
    const std::string path = (directory.path() / "floor.glb").string();
    json file = floor_scene();
    file["nodes"].push_back({{"translation", {place.x, place.y, place.z}}, {"children", {0, 1, 2}}});
    file["scenes"][0]["nodes"] = {3};
    std::ofstream(path, std::ios::binary) << binary_file(file, floor_bytes());
    const Scene scene = read_scene(path);
    Renderer renderer(scene, 80, 80, {.fog_lighting = FogLighting::airlight});
    renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp, 30.0)));
    renderer.draw();
    return renderer.read();
  };
  const Picture near = drawn({0, 0, 0});
  const Picture far = drawn({1e6, 10, -9e6});
  const PictureError error = picture_error(far, near);
  EXPECT_LE(error.largest, 1);
  EXPECT_GT(near.rgb[std::size_t(3 * (40 * 80 + 40))], 0.05f);
}

/// The floor's red in the pixel below and right of the middle of an 80x80 picture, lit by the lamp: the Basic model
/// written out. The middle of the picture looks at the origin.
double lit_red(const Scene& scene, const glm::dvec3& normal, double shininess) {
  const glm::dvec3 eye = scene.camera.position;
  const double pixel = 2 * std::tan(0.45) / 80;
  const glm::dvec3 forward = glm::normalize(-eye);
  const glm::dvec3 right(1, 0, 0);
  const glm::dvec3 view = forward + (right - glm::cross(right, forward)) * (pixel / 2);
  const glm::dvec3 to_light = glm::dvec3(0.5, 2, 0) - (eye - view * (eye.y / view.y));
  const double range = glm::length(to_light);
  const double facing = glm::dot(normal, to_light) / range;
  const double highlight = glm::dot(normal, glm::normalize(to_light / range - glm::normalize(view)));
  const double specular = 0.04 * (shininess + 8) / 8 * std::pow(highlight, shininess);
  const double arriving = 1 / (1 + kWhiteLux / 40 * range * range);
  return double(scene.environment.ambient_light.r) + arriving * (facing + specular);
}

double drawn_red(const Picture& picture) { return double(picture.rgb[std::size_t(3 * (40 * 80 + 40))]); }

// Lit as the lamp's candela say: the Basic model written out, and the reference in every pixel.
TEST_F(GltfPicture, TheFloorIsAsBrightAsItsLightSays) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "floor.glb").string();
  std::ofstream(path, std::ios::binary) << binary_file(floor_scene(), floor_bytes());
  const Scene scene = read_scene(path);
  Renderer renderer(scene, 80, 80, {});
  renderer.draw(LightPoints::off);
  const Picture picture = renderer.read();
  EXPECT_LE(picture_error(picture, shade_reference(renderer)).largest, 0.25);
  const double red = lit_red(scene, {0, 1, 0}, 1);  // roughness 1: shininess 1
  EXPECT_NEAR(drawn_red(picture), red, 2e-3 * red);
}

// In 8 bits this normal would be a quarter of a degree off, and the picture half a percent.
TEST_F(GltfPicture, AScaledNormalIsNotRounded) {
  const test::TemporaryDirectory directory;
  const std::string path = (directory.path() / "floor.glb").string();
  json file = floor_scene();
  png((directory.path() / "normal.png").string(), {169, 30, 181}, 1);
  file["images"] = {{{"uri", "normal.png"}}};
  file["textures"] = {{{"source", 0}}};
  file["materials"][0]["normalTexture"] = {{"index", 0}, {"scale", 0.2}};
  file["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0.3;
  std::ofstream(path, std::ios::binary) << binary_file(file, floor_bytes());
  const Scene scene = read_scene(path);
  Renderer renderer(scene, 80, 80, {});
  renderer.draw(LightPoints::off);
  const Picture picture = renderer.read();
  EXPECT_LE(picture_error(picture, shade_reference(renderer)).largest, 0.25);
  const glm::dvec3 texel = glm::dvec3(169, 30, 181) / 127.5 - 1.0;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2 * texel.x, texel.z, -0.2 * texel.y));  // u: +x, v: +z
  const double red = lit_red(scene, normal, 2 / std::pow(0.3, 4) - 2);
  EXPECT_NEAR(drawn_red(picture), red, 2e-3 * red);
}

}  // namespace

}  // namespace litfog::test
