// SPDX-License-Identifier: Apache-2.0
#include "gltf_scene.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <numbers>
#include <set>
#include <variant>

#include "exit_status.h"
#include "json_document.h"
#include "litfog/fog_light_block.h"

namespace litfog::demo {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;
constexpr std::size_t kMaxTexels = std::size_t{1} << 27;  // of all pictures together: 512 MiB
constexpr int kMaxPictureSide = 16'384;
constexpr float kMaxShininess = 1000;
constexpr double kBrightestAtKnee = 16;          // of the display's white
constexpr double kThreshold = 1.0 / (16 * 512);  // half of 1/256 of the display's white
constexpr glm::vec3 kNightAmbient{0.045f, 0.05f, 0.07f};
constexpr glm::vec3 kLampless{0.6f};
constexpr glm::vec3 kNightFog{0.012f, 0.013f, 0.017f};
constexpr glm::vec3 kZenith{0.0012f, 0.0018f, 0.005f};

using Vector = std::vector<double>;

/// The way to a value from the file's root: names of members and places in arrays.
using Place = std::vector<std::variant<std::string, std::size_t>>;

Place operator/(Place place, std::string name) {
  place.emplace_back(std::move(name));
  return place;
}
Place operator/(Place place, std::size_t index) {
  place.emplace_back(index);
  return place;
}

/// An accessor's numbers, checked against its buffer.
struct Numbers {
  const unsigned char* data = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;
  int component_type = 0;
  bool is_normalized = false;

  double at(std::size_t i, std::size_t component) const {
    const unsigned char* element = data + i * stride;
    const auto read = [&](auto zero) {
      std::memcpy(&zero, element + component * sizeof(zero), sizeof(zero));
      return zero;
    };
    switch (component_type) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return double(read(std::uint8_t{})) / (is_normalized ? 255.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return double(read(std::uint16_t{})) / (is_normalized ? 65535.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return double(read(std::uint32_t{}));
      default:
        return double(read(float{}));
    }
  }
  glm::vec3 vec3(std::size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
};

std::string whole_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  if (file) bytes.assign(std::istreambuf_iterator<char>(file), {});
  if (!file) throw BadInput(path + ": cannot be read");
  return bytes;
}

std::uint32_t little_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

/// The JSON of a binary file: its first chunk.
std::string json_chunk(const std::string& path, const std::string& bytes) {
  constexpr std::size_t kHeaders = 20;  // of the file and of the chunk
  if (bytes.size() < kHeaders || !bytes.starts_with("glTF") || bytes.compare(16, 4, "JSON") != 0 ||
      little_endian(bytes, 12) > bytes.size() - kHeaders) {
    throw BadInput(path + ": must be a binary glTF file that begins with its JSON chunk");
  }
  return bytes.substr(kHeaders, little_endian(bytes, 12));
}

/// Whole numbers >= 0, as indices and offsets are.
void expect_index(const JsonValue& object, std::string_view name) {
  const auto given = object.optional(name);
  if (given && !(given->number() >= 0 && given->number() == std::floor(given->number()))) {
    given->fail("must be a whole number >= 0");
  }
}

void expect_number(const JsonValue& object, std::string_view name) {
  if (const auto given = object.optional(name)) given->number();
}

void expect_numbers(const JsonValue& object, std::string_view name, std::size_t count) {
  const auto given = object.optional(name);
  if (!given) return;
  const auto items = given->items();
  if (items.size() != count) given->fail(fmt::format("must be {} numbers", count));
  for (const JsonValue& item : items) item.number();
}

std::vector<JsonValue> items_of(const JsonValue& object, std::string_view name) {
  const auto given = object.optional(name);
  return given ? given->items() : std::vector<JsonValue>{};
}

/// Refuses what tinygltf passes over in silence, as if it were not given: members of a wrong kind or length.
void expect_values(const JsonValue& root) {
  const JsonValue version = root.member("asset").member("version");
  if (!version.string().starts_with("2.")) version.fail("must be \"2.0\"");
  for (const JsonValue& view : items_of(root, "bufferViews")) expect_index(view, "byteOffset");
  for (const JsonValue& accessor : items_of(root, "accessors")) expect_index(accessor, "byteOffset");
  for (const JsonValue& node : items_of(root, "nodes")) {
    for (const char* name : {"mesh", "camera"}) expect_index(node, name);
    for (const auto& [name, count] : {std::pair{"matrix", 16u}, {"translation", 3u}, {"rotation", 4u}, {"scale", 3u}}) {
      expect_numbers(node, name, count);
    }
    if (const auto rotation = node.optional("rotation")) {
      const auto is_zero = [](const JsonValue& item) { return item.number() == 0; };
      if (std::ranges::all_of(rotation->items(), is_zero)) rotation->fail("must not be all 0");
    }
    const auto extensions = node.optional("extensions");
    const auto punctual = extensions ? extensions->optional("KHR_lights_punctual") : std::nullopt;
    if (punctual) expect_index(*punctual, "light");
  }
  for (const JsonValue& material : items_of(root, "materials")) {
    expect_numbers(material, "emissiveFactor", 3);
    const auto pbr = material.optional("pbrMetallicRoughness");
    if (!pbr) continue;
    expect_numbers(*pbr, "baseColorFactor", 4);
    for (const char* name : {"metallicFactor", "roughnessFactor"}) expect_number(*pbr, name);
  }
  const auto extensions = root.optional("extensions");
  const auto punctual = extensions ? extensions->optional("KHR_lights_punctual") : std::nullopt;
  if (!punctual) return;
  for (const JsonValue& light : items_of(*punctual, "lights")) {
    expect_numbers(light, "color", 3);
    for (const char* name : {"intensity", "range"}) expect_number(light, name);
  }
}

float linear(std::uint8_t srgb) { return OIIO::sRGB_to_linear(float(srgb) / 255.0f); }

/// The mean of a picture's texels, as colours or as they are.
glm::vec3 mean(const Texels& texels, bool is_srgb) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
    for (int channel = 0; channel < 3; ++channel) {
      const std::uint8_t value = texels.rgba[i + std::size_t(channel)];
      sum[channel] += double(is_srgb ? linear(value) : float(value) / 255.0f);
    }
  }
  return sum / double(texels.rgba.size() / 4);
}

class GltfReader {
 public:
  explicit GltfReader(const std::string& path)
      : path_(path), root_(load(path)), used_materials_(model_.materials.size() + 1) {
    for (std::size_t i = 0; i < model_.extensionsRequired.size(); ++i) {
      if (model_.extensionsRequired[i] != "KHR_lights_punctual") {
        refuse(Place{} / "extensionsRequired" / i, "must be KHR_lights_punctual, the only one that this program knows");
      }
    }
    read_name();
    scene_.description = "a glTF file";
    scene_.environment = {.ambient_light = kNightAmbient,
                          .ambient_fog_color = kNightFog,
                          .sky_zenith = kZenith,
                          .sky_horizon = kNightFog};
    scene_.models.emplace_back();
    read_nodes();
    if (scene_.models[0].empty()) throw BadInput(path + ": meshes: must hold triangles");
    scene_.instances.push_back({0, glm::mat4(1.0f)});
    const Bounds box = bounds(scene_.models[0]);
    const double size = std::max(0.01, double(glm::distance(box.low, box.high)));
    if (!has_camera_) look_at(box);
    if (scene_.lights.empty() && scene_.environment.moon_color == glm::vec3(0.0f)) {
      scene_.environment.ambient_light = kLampless;
    }
    scene_.visibilities = {8 * size, 2 * size, size / 2};
  }

  Scene take() { return std::move(scene_); }

 private:
  /// Reads the whole file twice: by litfog's own JSON reader, which bounds its size and depth and knows the places of
  /// what is refused later, and by tinygltf, which also brings the buffers.
  JsonValue load(const std::string& path) {
    std::error_code error;
    if (std::filesystem::file_size(path, error) > kMaxBytes && !error) {
      throw BadInput(fmt::format("{}: must be at most {} MiB", path, kMaxBytes >> 20));
    }
    const std::string bytes = whole_file(path);
    const bool is_binary = std::filesystem::path(path).extension() == ".glb";
    JsonValue root = parse_json(is_binary ? json_chunk(path, bytes) : bytes, path);
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(&keep_encoded, nullptr);
    const std::string folder = std::filesystem::absolute(path).parent_path().string();
    std::string errors;
    std::string warnings;
    bool is_loaded = false;
    try {
      const auto length = static_cast<unsigned>(bytes.size());
      is_loaded =
          is_binary ? loader.LoadBinaryFromMemory(&model_, &errors, &warnings,
                                                  reinterpret_cast<const unsigned char*>(bytes.data()), length, folder)
                    : loader.LoadASCIIFromString(&model_, &errors, &warnings, bytes.data(), length, folder);
    } catch (const std::exception& failure) {  // tinygltf's slips over empty buffers
      errors = failure.what();
    }
    if (!is_loaded) {
      std::ranges::replace(errors, '\n', ' ');
      while (errors.ends_with(' ') || errors.ends_with('.')) errors.pop_back();
      throw BadInput(path + ": must be a glTF 2.0 file: " + errors);
    }
    expect_values(root);
    return root;
  }

  /// For tinygltf: a picture's own bytes, decoded when a material wants it. Those in a buffer are not checked yet.
  static bool keep_encoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                           const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    return true;
  }

  /// Refuses the value at a place of the file.
  [[noreturn]] void refuse(const Place& place, const std::string& rule) const {
    JsonValue value = root_;
    for (const auto& step : place) {
      if (const auto* index = std::get_if<std::size_t>(&step)) {
        value = value.items().at(*index);
        continue;
      }
      const std::string& name = std::get<std::string>(step);
      const auto member = value.optional(name);
      if (!member) value.fail((value.path().empty() ? "" : value.path() + ".") + name, "", rule);
      value = *member;
    }
    value.fail(rule);
  }

  /// An index into one of the file's arrays.
  std::size_t index(const Place& place, int value, std::size_t size) const {
    if (value < 0 || std::size_t(value) >= size) {
      refuse(place, size == 0 ? "must not be given: there are none" : fmt::format("must be in [0, {}]", size - 1));
    }
    return std::size_t(value);
  }

  void read_name() {
    scene_.name = std::filesystem::path(path_).stem().string();
    if (scene_.name.empty() || scene_.name.front() == '.')
      throw BadInput(path_ + ": must have a name before its ending");
  }

  // --- nodes ---

  static glm::dmat4 local_transform(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
    glm::dmat4 transform(1.0);
    if (node.translation.size() == 3) transform = glm::translate(transform, glm::make_vec3(node.translation.data()));
    if (node.rotation.size() == 4) {
      const Vector& r = node.rotation;
      transform *= glm::mat4_cast(glm::normalize(glm::dquat(r[3], r[0], r[1], r[2])));
    }
    if (node.scale.size() == 3) transform = glm::scale(transform, glm::make_vec3(node.scale.data()));
    return transform;
  }

  void read_nodes() {
    struct Visit {
      std::size_t node;
      glm::dmat4 world_from_parent;
      bool is_carried;
    };
    std::vector<Visit> visits;
    const auto add = [&](const Place& place, const std::vector<int>& nodes, const glm::dmat4& transform, bool carried) {
      for (std::size_t i = nodes.size(); i-- > 0;) {  // the first one comes off the stack first
        visits.push_back({index(place / i, nodes[i], model_.nodes.size()), transform, carried});
      }
    };
    if (model_.scenes.empty()) refuse({}, "must hold a scene");
    const std::size_t scene =
        model_.defaultScene < 0 ? 0 : index(Place{} / "scene", model_.defaultScene, model_.scenes.size());
    add(Place{} / "scenes" / scene / "nodes", model_.scenes[scene].nodes, glm::dmat4(1.0), false);
    std::vector<bool> is_met(model_.nodes.size());
    while (!visits.empty()) {
      Visit visit = visits.back();
      visits.pop_back();
      const tinygltf::Node& node = model_.nodes[visit.node];
      const Place place = Place{} / "nodes" / visit.node;
      if (is_met[visit.node]) refuse(place, "must be one node's child only");
      is_met[visit.node] = true;
      const glm::dmat4 world_from_node = visit.world_from_parent * local_transform(node);
      const double* const first = glm::value_ptr(world_from_node);
      if (!std::all_of(first, first + 16, [](double x) { return std::abs(x) <= kMaxCoordinate; })) {
        refuse(place, fmt::format("must lie within {} metres", kMaxCoordinate));
      }
      if (node.camera >= 0) visit.is_carried |= read_camera(place / "camera", node.camera, world_from_node);
      if (node.mesh >= 0) read_mesh(place / "mesh", node.mesh, world_from_node);
      if (const auto light = node.extensions.find("KHR_lights_punctual"); light != node.extensions.end()) {
        const int number = light->second.Has("light") ? light->second.Get("light").GetNumberAsInt() : -1;
        read_light(place / "extensions" / "KHR_lights_punctual" / "light", number, world_from_node, visit.is_carried);
      }
      add(place / "children", node.children, world_from_node, visit.is_carried);
    }
  }

  // --- camera ---

  /// Returns whether it is the camera that sees the scene.
  bool read_camera(const Place& place, int number, const glm::dmat4& world_from_node) {
    const tinygltf::Camera& camera = model_.cameras[index(place, number, model_.cameras.size())];
    if (has_camera_ || camera.type != "perspective") return false;
    const Place yfov = Place{} / "cameras" / std::size_t(number) / "perspective" / "yfov";
    if (!(camera.perspective.yfov > 0 && camera.perspective.yfov < std::numbers::pi * 0.95)) {
      refuse(yfov, "must be in (0, 2.98) radians");
    }
    const glm::dvec3 forward = -glm::dvec3(world_from_node[2]);
    if (!(glm::length(glm::dvec2(forward.x, forward.z)) > 1e-4 * glm::length(forward))) {
      refuse(place, "must not look straight up or down");
    }
    scene_.camera = {.position = glm::dvec3(world_from_node[3]),
                     .target = glm::dvec3(world_from_node[3]) + glm::normalize(forward),
                     .field_of_view = float(camera.perspective.yfov)};
    has_camera_ = true;
    return true;
  }

  /// The whole from its front, somewhat above.
  void look_at(const Bounds& box) {
    const glm::vec3 middle = (box.low + box.high) * 0.5f;
    const float radius = glm::distance(box.high, middle);
    scene_.camera.field_of_view = 0.8f;
    scene_.camera.target = middle;
    scene_.camera.position =
        middle + glm::normalize(glm::vec3(0.3f, 0.35f, 1)) * (radius / std::sin(scene_.camera.field_of_view / 2));
  }

  // --- lights ---

  void read_light(const Place& place, int number, const glm::dmat4& world_from_node, bool is_carried) {
    const tinygltf::Light& light = model_.lights[index(place, number, model_.lights.size())];
    const Place own = Place{} / "extensions" / "KHR_lights_punctual" / "lights" / std::size_t(number);
    glm::dvec3 color(1.0);
    if (!light.color.empty()) {
      if (light.color.size() != 3) refuse(own / "color", "must be three numbers");
      color = glm::make_vec3(light.color.data());
    }
    if (!glm::all(glm::greaterThanEqual(color, glm::dvec3(0.0)))) refuse(own / "color", "must be >= 0");
    if (!(light.intensity >= 0)) refuse(own / "intensity", "must be >= 0");
    const glm::dvec3 at_one_metre = color * (light.intensity / std::numbers::pi);
    const double brightest = std::max({at_one_metre.r, at_one_metre.g, at_one_metre.b});
    if (brightest == 0) return;
    const glm::dvec3 axis = -glm::dvec3(world_from_node[2]);
    if (!(glm::length(axis) > 0)) refuse(place, "must not be at a node of scale 0");
    if (light.type == "directional") {
      if (scene_.environment.moon_color != glm::vec3(0.0f)) refuse(own, "must be the only directional light");
      if (!(brightest <= kMaxColor))
        refuse(own / "intensity", "must not show more than 10000 times the display's white");
      scene_.environment.moon_color = at_one_metre;
      scene_.environment.moon_direction = glm::normalize(-axis);
      return;
    }
    PlacedLight placed;
    placed.light.name = light.name.empty() ? fmt::format("light {}", number) : light.name;
    placed.position = glm::dvec3(world_from_node[3]);
    placed.direction = glm::normalize(axis);
    placed.carried = is_carried;
    double knee_square = brightest / kBrightestAtKnee;
    placed.light.threshold = kThreshold;
    if (light.range != 0) {
      if (!(light.range > 0 && light.range <= kMaxCoordinate)) refuse(own / "range", "must be > 0 and at most 1e7");
      knee_square = std::min(knee_square, light.range * light.range / 4);
      placed.light.threshold = knee_square / (light.range * light.range);
    }
    placed.light.attenuation = {.constant = 0, .linear = 0, .quadratic = 1 / knee_square};
    placed.light.color = at_one_metre / knee_square;
    if (light.type == "spot") {
      placed.light.cone = Cone::smoothstep(light.spot.innerConeAngle, light.spot.outerConeAngle);
      if (!(light.spot.outerConeAngle <= std::numbers::pi / 2)) {
        refuse(own / "spot" / "outerConeAngle", "must be at most pi/2");
      }
    } else if (light.type != "point") {
      refuse(own / "type", "must be directional, point or spot");
    }
    if (const auto refusal = check(placed.light)) refuse(own, refusal->field + std::string(" ") + refusal->rule);
    if (!(brightest / knee_square <= kMaxColor)) {
      refuse(own / "range", "must not end a light where it shows more than 2500 times the display's white");
    }
    scene_.lights.push_back(placed);
    if (scene_.lights.size() > kMaxSceneLights) {
      refuse(place, fmt::format("lights must be at most {}", kMaxSceneLights));
    };
    if (is_carried && ++carried_ > kMaxFogLights) {
      refuse(place, fmt::format("lights at the camera must be at most {}", kMaxFogLights));
    }
  }

  // --- meshes ---

  Numbers numbers(const Place& place, int number, int type, std::initializer_list<int> component_types) const {
    const std::size_t at = index(place, number, model_.accessors.size());
    const tinygltf::Accessor& accessor = model_.accessors[at];
    const Place own = Place{} / "accessors" / at;
    if (accessor.type != type) refuse(own / "type", "must be that of what it is used for");
    const bool is_known = std::ranges::find(component_types, accessor.componentType) != component_types.end();
    if (!is_known) refuse(own / "componentType", "must be one that glTF allows for what it is used for");
    if (accessor.sparse.isSparse) refuse(own / "sparse", "must not be given: this program reads dense accessors only");
    const std::span<const unsigned char> bytes = view(own / "bufferView", accessor.bufferView);
    const auto& buffer_view = model_.bufferViews[std::size_t(accessor.bufferView)];
    const auto element = std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(accessor.componentType)) *
                                     tinygltf::GetNumComponentsInType(std::uint32_t(type)));
    const std::size_t stride = buffer_view.byteStride == 0 ? element : buffer_view.byteStride;
    const bool fits = accessor.count > 0 && accessor.byteOffset <= bytes.size() &&
                      bytes.size() - accessor.byteOffset >= element &&
                      (bytes.size() - accessor.byteOffset - element) / stride >= accessor.count - 1;
    if (!fits) refuse(own / "count", "must be > 0 and within its buffer view");
    return {bytes.data() + accessor.byteOffset, stride, accessor.count, accessor.componentType, accessor.normalized};
  }

  /// The bytes of a buffer view.
  std::span<const unsigned char> view(const Place& place, int number) const {
    const std::size_t at = index(place, number, model_.bufferViews.size());
    const tinygltf::BufferView& view = model_.bufferViews[at];
    const Place own = Place{} / "bufferViews" / at;
    const auto& bytes = model_.buffers[index(own / "buffer", view.buffer, model_.buffers.size())].data;
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset) {
      refuse(own / "byteLength", "must end within its buffer");
    }
    return std::span(bytes).subspan(view.byteOffset, view.byteLength);
  }

  void read_mesh(const Place& place, int number, const glm::dmat4& world_from_node) {
    if (!(std::abs(glm::determinant(glm::dmat3(world_from_node))) > 1e-18)) return;  // flattened to nothing
    const std::size_t at = index(place, number, model_.meshes.size());
    const auto& primitives = model_.meshes[at].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const Place own = Place{} / "meshes" / at / "primitives" / i;
      const Mesh mesh = read_primitive(own, primitives[i]);
      triangles_ += mesh.indices.size() / 3;
      vertices_ += mesh.vertices.size();
      if (triangles_ > kMaxTriangles || vertices_ > 3 * kMaxTriangles) {
        refuse(own, fmt::format("triangles must be at most {} in all, vertices three times that", kMaxTriangles));
      }
      append(part(scene_.models[0], material(own / "material", primitives[i].material)), mesh, world_from_node);
    }
  }

  Mesh read_primitive(const Place& place, const tinygltf::Primitive& primitive) const {
    constexpr int kFloat = TINYGLTF_COMPONENT_TYPE_FLOAT;
    constexpr int kByte = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    constexpr int kShort = TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) {
      refuse(place / "mode", "must be 4: this program draws triangles");
    }
    const auto attribute = [&](const char* name, int type, std::initializer_list<int> components) {
      const auto found = primitive.attributes.find(name);
      if (found == primitive.attributes.end()) return Numbers{};
      return numbers(place / "attributes" / name, found->second, type, components);
    };
    const Numbers positions = attribute("POSITION", TINYGLTF_TYPE_VEC3, {kFloat});
    if (!positions.data) refuse(place / "attributes" / "POSITION", "must be given");
    const Numbers normals = attribute("NORMAL", TINYGLTF_TYPE_VEC3, {kFloat});
    const Numbers tangents = attribute("TANGENT", TINYGLTF_TYPE_VEC4, {kFloat});
    const Numbers uvs = attribute("TEXCOORD_0", TINYGLTF_TYPE_VEC2, {kFloat, kByte, kShort});
    for (const auto& [name, given] : {std::pair{"NORMAL", normals}, {"TANGENT", tangents}, {"TEXCOORD_0", uvs}}) {
      if (given.data && given.count != positions.count) {
        refuse(place / "attributes" / name, "must have as many elements as POSITION");
      }
    }
    Mesh mesh;
    for (std::size_t i = 0; i < positions.count; ++i) {
      Vertex vertex{positions.vec3(i), glm::vec3(0, 1, 0), glm::vec4(0), glm::vec2(0)};
      if (normals.data) vertex.normal = normals.vec3(i);
      if (tangents.data) vertex.tangent = glm::vec4(tangents.vec3(i), tangents.at(i, 3) < 0 ? -1 : 1);
      if (uvs.data) vertex.uv = {uvs.at(i, 0), uvs.at(i, 1)};
      const bool is_sound = glm::all(glm::lessThanEqual(glm::abs(vertex.position), glm::vec3(kMaxCoordinate))) &&
                            glm::all(glm::lessThanEqual(glm::abs(vertex.uv), glm::vec2(kMaxCoordinate)));
      if (!is_sound) refuse(place / "attributes", fmt::format("must be finite and at most {}", kMaxCoordinate));
      mesh.vertices.push_back(vertex);
    }
    read_indices(place, primitive, mesh);
    if (!normals.data) flatten(mesh);
    for (Vertex& vertex : mesh.vertices) {
      const float length = glm::length(vertex.normal);
      vertex.normal = length > 0 && std::isfinite(length) ? vertex.normal / length : glm::vec3(0, 1, 0);
    }
    if (!normals.data || !tangents.data || !uvs.data) {
      compute_tangents(mesh);
      // There v grows along the bitangent; glTF's v runs down a picture whose normals have +Y up.
      for (Vertex& vertex : mesh.vertices) vertex.tangent.w = -vertex.tangent.w;
    }
    const bool is_seen_from_behind =
        primitive.material >= 0 &&
        model_.materials[index(place / "material", primitive.material, model_.materials.size())].doubleSided;
    if (is_seen_from_behind) add_back_faces(mesh);
    return mesh;
  }

  void read_indices(const Place& place, const tinygltf::Primitive& primitive, Mesh& mesh) const {
    std::size_t count = mesh.vertices.size();
    Numbers indices;
    if (primitive.indices >= 0) {
      indices = numbers(place / "indices", primitive.indices, TINYGLTF_TYPE_SCALAR,
                        {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT,
                         TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT});
      count = indices.count;
    }
    if (count % 3 != 0) refuse(place / "indices", "must be three a triangle");
    if (count > 3 * kMaxTriangles) refuse(place / "indices", fmt::format("must be at most {}", 3 * kMaxTriangles));
    for (std::size_t i = 0; i < count; ++i) {
      const double vertex = indices.data ? indices.at(i, 0) : double(i);
      if (!(vertex < double(mesh.vertices.size()))) refuse(place / "indices", "must be those of given vertices");
      mesh.indices.push_back(std::uint32_t(vertex));
    }
  }

  /// Three vertices of its own for each triangle, with its normal (glTF 2.0, 3.7.2.1: flat normals where none are
  /// given).
  static void flatten(Mesh& mesh) {
    std::vector<Vertex> vertices;
    for (const std::uint32_t vertex : mesh.indices) vertices.push_back(mesh.vertices[vertex]);
    for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
      const glm::vec3 normal =
          glm::cross(vertices[i + 1].position - vertices[i].position, vertices[i + 2].position - vertices[i].position);
      for (std::size_t corner = i; corner < i + 3; ++corner) vertices[corner].normal = normal;
    }
    mesh.vertices = std::move(vertices);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = std::uint32_t(i);
  }

  // --- materials ---

  /// The name of a material in the scene, made when first used; -1 is glTF's default material.
  std::string material(const Place& place, int number) {
    const std::size_t at = number == -1 ? model_.materials.size() : index(place, number, model_.materials.size());
    const std::string name = fmt::format("glTF material {}", number);
    if (used_materials_[at]) return name;
    used_materials_[at] = true;
    scene_.materials.push_back(number == -1 ? make_material(name, Place{}, tinygltf::Material{})
                                            : make_material(name, Place{} / "materials" / at, model_.materials[at]));
    return name;
  }

  Material make_material(const std::string& name, const Place& place, const tinygltf::Material& given) {
    const tinygltf::PbrMetallicRoughness& pbr = given.pbrMetallicRoughness;
    const Place pbr_place = place / "pbrMetallicRoughness";
    const glm::vec3 factor = color_of(pbr_place / "baseColorFactor", pbr.baseColorFactor, 4);
    Texels base = texture(pbr_place / "baseColorTexture", pbr.baseColorTexture, {255, 255, 255});
    const Texels rough = texture(pbr_place / "metallicRoughnessTexture", pbr.metallicRoughnessTexture, {255, 255, 255});
    const glm::vec3 rough_mean = mean(rough, false);
    const float metallic = share_of(pbr_place / "metallicFactor", pbr.metallicFactor) * rough_mean.b;
    const float roughness = share_of(pbr_place / "roughnessFactor", pbr.roughnessFactor) * rough_mean.g;
    const glm::vec3 reflected = glm::mix(glm::vec3(0.04f), mean(base, true) * factor, metallic);
    const float alpha = std::max(roughness * roughness, 1e-3f);
    const float shininess = std::clamp(2 / (alpha * alpha) - 2, 1.0f, kMaxShininess);
    const glm::vec3 kept = factor * (1 - metallic);
    for (std::size_t i = 0; i < base.rgba.size(); i += 4) {
      for (int channel = 0; channel < 3; ++channel) {
        std::uint8_t& texel = base.rgba[i + std::size_t(channel)];
        if (kept[channel] != 1) texel = srgb_level_of(linear(texel) * kept[channel]);
      }
      base.rgba[i + 3] = 255;  // gloss
    }
    glm::vec3 emissive(0.0f);
    if (!given.emissiveFactor.empty()) emissive = color_of(place / "emissiveFactor", given.emissiveFactor, 3);
    if (emissive != glm::vec3(0.0f)) {
      emissive *= mean(texture(place / "emissiveTexture", given.emissiveTexture, {255, 255, 255}), true);
    }
    return {.name = name,
            .size_m = 1,
            .albedo = std::move(base),
            .normal = normal_map(place / "normalTexture", given.normalTexture),
            .specular = reflected * ((shininess + 8) / 8),
            .shininess = shininess,
            .emissive = emissive,
            .plain_albedo = pbr.baseColorTexture.index == -1 ? std::optional(kept) : std::nullopt};
  }

  glm::vec3 color_of(const Place& place, const Vector& given, std::size_t size) const {
    const bool is_color = given.size() == size && std::ranges::all_of(given, [](double x) { return x >= 0 && x <= 1; });
    if (!is_color) refuse(place, fmt::format("must be {} numbers in [0, 1]", size));
    return {given[0], given[1], given[2]};
  }

  float share_of(const Place& place, double given) const {
    if (!(given >= 0 && given <= 1)) refuse(place, "must be in [0, 1]");
    return float(given);
  }

  Texels normal_map(const Place& place, const tinygltf::NormalTextureInfo& given) {
    if (given.index == -1) return {1, 1, {128, 128, 255, 0}};  // flat
    tinygltf::TextureInfo info;
    info.index = given.index;
    info.texCoord = given.texCoord;
    Texels texels = texture(place, info, {});
    if (given.scale == 1) return texels;
    if (!(std::abs(given.scale) <= 1000)) refuse(place / "scale", "must be at most 1000");
    for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
      glm::vec3 normal;
      for (int axis = 0; axis < 3; ++axis) normal[axis] = float(texels.rgba[i + std::size_t(axis)]) / 127.5f - 1;
      normal = glm::normalize(normal * glm::vec3(float(given.scale), float(given.scale), 1));
      for (int axis = 0; axis < 3; ++axis) texels.rgba[i + std::size_t(axis)] = level_of(normal[axis] * 0.5f + 0.5f);
    }
    return texels;
  }

  /// A texture's picture, or one texel where there is none.
  Texels texture(const Place& place, const tinygltf::TextureInfo& info, const std::array<std::uint8_t, 3>& absent) {
    if (info.index == -1) return {1, 1, {absent[0], absent[1], absent[2], 255}};
    if (info.texCoord != 0) refuse(place / "texCoord", "must be 0: this program reads TEXCOORD_0 only");
    const std::size_t at = index(place / "index", info.index, model_.textures.size());
    const Place source = Place{} / "textures" / at / "source";
    const std::size_t number = index(source, model_.textures[at].source, model_.images.size());
    const tinygltf::Image& image = model_.images[number];
    const Place own = Place{} / "images" / number;
    std::span<const unsigned char> bytes = image.image;
    if (image.bufferView >= 0) bytes = view(own / "bufferView", image.bufferView);
    if (bytes.empty()) refuse(own, "must be a picture that can be read");
    return decode(own, bytes);
  }

  Texels decode(const Place& place, std::span<const unsigned char> bytes) {
    constexpr std::array<unsigned char, 4> kPng{0x89, 'P', 'N', 'G'};
    constexpr std::array<unsigned char, 2> kJpeg{0xFF, 0xD8};
    const auto begins = [&](const auto& magic) {
      return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
    };
    if (!begins(kPng) && !begins(kJpeg)) refuse(place, "must be a PNG or JPEG picture");
    OIIO::Filesystem::IOMemReader reader(const_cast<unsigned char*>(bytes.data()), bytes.size());
    const std::string format = begins(kPng) ? "png" : "jpeg";
    const auto input = OIIO::ImageInput::create(format);
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // else colours come multiplied by alpha
    OIIO::ImageSpec spec;
    if (!input) refuse(place, "must be a picture of a kind that this OpenImageIO reads: " + OIIO::geterror());
    if (!input->set_ioproxy(&reader) || !input->open("picture." + format, spec, config)) {
      refuse(place, "must be a sound picture: " + input->geterror());
    }
    if (spec.width > kMaxPictureSide || spec.height > kMaxPictureSide) {
      refuse(place, fmt::format("must be at most {} pixels a side", kMaxPictureSide));
    }
    texels_ += spec.image_pixels();
    if (texels_ > kMaxTexels) refuse(place, fmt::format("pictures must be at most {} pixels in all", kMaxTexels));
    const auto channels = std::size_t(spec.nchannels);
    std::vector<std::uint8_t> pixels(spec.image_pixels() * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data())) {
      refuse(place, "must be a sound picture: " + input->geterror());
    }
    Texels texels{spec.width, spec.height, std::vector<std::uint8_t>(spec.image_pixels() * 4, 255)};
    for (std::size_t i = 0; i < spec.image_pixels(); ++i) {
      for (std::size_t channel = 0; channel < 3; ++channel) {  // a grey picture has one for all three
        texels.rgba[4 * i + channel] = pixels[i * channels + (channels < 3 ? 0 : channel)];
      }
    }
    return texels;
  }

  std::string path_;
  tinygltf::Model model_;
  JsonValue root_;
  Scene scene_;
  bool has_camera_ = false;
  std::vector<bool> used_materials_;
  std::size_t triangles_ = 0;
  std::size_t vertices_ = 0;
  std::size_t texels_ = 0;
  std::size_t carried_ = 0;
};

}  // namespace

bool is_gltf_path(const std::string& path) {
  const auto ending = std::filesystem::path(path).extension();
  return ending == ".gltf" || ending == ".glb";
}

Scene read_gltf_scene(const std::string& path) { return GltfReader(path).take(); }

}  // namespace litfog::demo
