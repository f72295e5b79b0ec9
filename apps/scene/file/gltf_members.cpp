// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace litfog::scene {
namespace {

enum class Kind { index, indices, number, numbers, boolean, string };

struct Member {
  const char* name;
  Kind kind;
  std::size_t count = 0;  // of numbers
};

/// Whole numbers that an int holds, as indices, counts and offsets are.
void expect_index(const JsonValue& value) {
  const double number = value.number();
  if (!(number >= 0 && number == std::floor(number))) value.fail("must be a whole number >= 0");
  if (number > std::numeric_limits<int>::max()) value.fail("must be below 2^31");
}

void expect(const JsonValue& value, const Member& member) {
  switch (member.kind) {
    case Kind::index:
      return expect_index(value);
    case Kind::indices:
      for (const JsonValue& item : value.items()) expect_index(item);
      return;
    case Kind::number:
      value.number();
      return;
    case Kind::numbers: {
      const auto items = value.items();
      if (items.size() != member.count) value.fail(fmt::format("must be {} numbers", member.count));
      for (const JsonValue& item : items) item.number();
      return;
    }
    case Kind::boolean:
      value.boolean();
      return;
    case Kind::string:
      value.string();
      return;
  }
}

/// Members that are given have to be of their kinds.
void expect_members(const JsonValue& object, std::initializer_list<Member> members) {
  for (const Member& member : members) {
    if (const auto given = object.optional(member.name)) expect(*given, member);
  }
}
void expect_members(const std::optional<JsonValue>& object, std::initializer_list<Member> members) {
  if (object) expect_members(*object, members);
}

std::vector<JsonValue> items_of(const JsonValue& object, std::string_view name) {
  const auto given = object.optional(name);
  return given ? given->items() : std::vector<JsonValue>{};
}

std::optional<JsonValue> punctual_lights(const JsonValue& object) {
  const auto extensions = object.optional("extensions");
  return extensions ? extensions->optional("KHR_lights_punctual") : std::nullopt;
}

void expect_texture(const JsonValue& object, std::string_view name) {
  expect_members(object.optional(name), {{"index", Kind::index}, {"texCoord", Kind::index}, {"scale", Kind::number}});
}

void expect_asset(const JsonValue& asset) {
  const JsonValue version = asset.member("version");
  if (!version.string().starts_with("2.")) version.fail("must be \"2.0\" or a later 2");
  const auto least = asset.optional("minVersion");
  if (least && least->string() != "2.0") least->fail("must be \"2.0\", which is what this program knows");
}

void expect_node(const JsonValue& node) {
  expect_members(node, {{"mesh", Kind::index},
                        {"camera", Kind::index},
                        {"children", Kind::indices},
                        {"matrix", Kind::numbers, 16},
                        {"translation", Kind::numbers, 3},
                        {"rotation", Kind::numbers, 4},
                        {"scale", Kind::numbers, 3}});
  expect_members(punctual_lights(node), {{"light", Kind::index}});
  if (const auto rotation = node.optional("rotation")) {
    const auto is_zero = [](const JsonValue& item) { return item.number() == 0; };
    if (std::ranges::all_of(rotation->items(), is_zero)) rotation->fail("must not be all 0");
  }
}

void expect_material(const JsonValue& material) {
  expect_members(material, {{"doubleSided", Kind::boolean}, {"emissiveFactor", Kind::numbers, 3}});
  for (const char* texture : {"normalTexture", "emissiveTexture"}) expect_texture(material, texture);
  const auto pbr = material.optional("pbrMetallicRoughness");
  if (!pbr) return;
  expect_members(
      *pbr,
      {{"baseColorFactor", Kind::numbers, 4}, {"metallicFactor", Kind::number}, {"roughnessFactor", Kind::number}});
  for (const char* texture : {"baseColorTexture", "metallicRoughnessTexture"}) expect_texture(*pbr, texture);
}

void expect_primitive(const JsonValue& primitive) {
  expect_members(primitive, {{"indices", Kind::index}, {"material", Kind::index}, {"mode", Kind::index}});
  expect_members(
      primitive.member("attributes"),
      {{"POSITION", Kind::index}, {"NORMAL", Kind::index}, {"TANGENT", Kind::index}, {"TEXCOORD_0", Kind::index}});
}

void expect_light(const JsonValue& light) {
  expect_members(light, {{"name", Kind::string},
                         {"type", Kind::string},
                         {"color", Kind::numbers, 3},
                         {"intensity", Kind::number},
                         {"range", Kind::number}});
  expect_members(light.optional("spot"), {{"innerConeAngle", Kind::number}, {"outerConeAngle", Kind::number}});
}

}  // namespace

void expect_gltf_members(const JsonValue& root) {
  expect_asset(root.member("asset"));
  expect_members(root, {{"scene", Kind::index}});
  for (const JsonValue& scene : items_of(root, "scenes")) expect_members(scene, {{"nodes", Kind::indices}});
  for (const JsonValue& node : items_of(root, "nodes")) expect_node(node);
  for (const JsonValue& camera : items_of(root, "cameras")) {
    expect_members(camera, {{"type", Kind::string}});
    expect_members(camera.optional("perspective"), {{"yfov", Kind::number}});
  }
  for (const JsonValue& mesh : items_of(root, "meshes")) {
    for (const JsonValue& primitive : mesh.member("primitives").items()) expect_primitive(primitive);
  }
  for (const JsonValue& accessor : items_of(root, "accessors")) {
    expect_members(accessor, {{"bufferView", Kind::index},
                              {"byteOffset", Kind::index},
                              {"componentType", Kind::index},
                              {"count", Kind::index},
                              {"type", Kind::string},
                              {"normalized", Kind::boolean}});
  }
  for (const JsonValue& view : items_of(root, "bufferViews")) {
    expect_members(view, {{"buffer", Kind::index},
                          {"byteOffset", Kind::index},
                          {"byteLength", Kind::index},
                          {"byteStride", Kind::index}});
  }
  for (const JsonValue& buffer : items_of(root, "buffers")) {
    expect_members(buffer, {{"uri", Kind::string}, {"byteLength", Kind::index}});
  }
  for (const JsonValue& texture : items_of(root, "textures")) expect_members(texture, {{"source", Kind::index}});
  for (const JsonValue& image : items_of(root, "images")) {
    expect_members(image, {{"uri", Kind::string}, {"bufferView", Kind::index}});
  }
  for (const JsonValue& material : items_of(root, "materials")) expect_material(material);
  if (const auto punctual = punctual_lights(root)) {
    for (const JsonValue& light : items_of(*punctual, "lights")) expect_light(light);
  }
}

}  // namespace litfog::scene
