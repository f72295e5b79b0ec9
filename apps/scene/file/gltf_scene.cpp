// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <strings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "litfog/fog_light_block.h"
#include "litfog/input_error.h"
#include "model/float_limit.h"
#include "scene/file/gltf_compression.h"
#include "scene/file/gltf_file.h"
#include "scene/file/gltf_material.h"
#include "scene/file/gltf_mesh.h"
#include "scene/file/gltf_uri.h"
#include "scene/file/gltf_value.h"

namespace litfog::scene {
namespace {

constexpr double kSourceRadius = 0.05;    // metres: the format states none
constexpr double kMaxCandela = 1e10;      // ten times the brightest searchlights
constexpr double kLeast = 1.0 / 512;      // half of 1/256 of the display's white
constexpr double kMinTilt = 1e-3;         // radians from the vertical; floats resolve it
constexpr double kMinRoll = 0.026;        // radians, 1.5 degrees; less is not reported
constexpr double kBrightestSun = 65'504;  // times the display's white; the largest half float
constexpr std::string_view kPunctual = "KHR_lights_punctual";
constexpr std::string_view kBasisu = "KHR_texture_basisu";
constexpr std::string_view kKnownExtensions[] = {"EXT_mesh_gpu_instancing",
                                                 kMeshopt,
                                                 "EXT_texture_webp",
                                                 "KHR_draco_mesh_compression",
                                                 kPunctual,
                                                 "KHR_materials_emissive_strength",
                                                 "KHR_materials_unlit",
                                                 "KHR_mesh_quantization",
                                                 "KHR_texture_transform"};

constexpr glm::vec3 kNightAmbient{0.045f, 0.05f, 0.07f};
constexpr glm::vec3 kLamplessAmbient{0.3f};
constexpr glm::vec3 kLamplessSun{0.6f};
constexpr glm::vec3 kNightFog{0.012f, 0.013f, 0.017f};
constexpr glm::vec3 kZenith{0.0012f, 0.0018f, 0.005f};

/// A positive number rounded up to two significant digits.
double with_two_digits(double value) {
  const double exponent = std::floor(std::log10(value)) - 1;
  const double step = std::pow(10.0, std::abs(exponent));
  return exponent < 0 ? std::ceil(value * step) / step : std::ceil(value / step) * step;
}

class GltfReader {
 public:
  explicit GltfReader(const std::string& path)
      : file_(path),
        nodes_(items_of(file_.root(), "nodes")),
        cameras_(items_of(file_.root(), "cameras")),
        meshes_(items_of(file_.root(), "meshes")),
        skins_(items_of(file_.root(), "skins")),
        world_from_node_(nodes_.size()),
        primitives_(meshes_.size()),
        is_read_(meshes_.size()),
        materials_(file_) {
    expect_known_extensions();
    if (const auto punctual = extension_of(file_.root(), kPunctual)) lights_ = items_of(*punctual, "lights");
    read_name(path);
    scene_.description = "a glTF file";
    scene_.display.exposure.reset();  // because light ranges from a candle's to the sun's
    scene_.environment = {.ambient_light = kNightAmbient, .sky_zenith = kZenith, .sky_horizon = kNightFog};
    note_files(path);
    read_nodes();
    if (scene_.models.empty()) file_.root().fail("meshes", "", "must hold triangles");
    const WorldBox box = world_box();
    if (forward_)
      aim_at(box);
    else
      look_at(box);
    light_fog_and_sky();
    if (scene_.lights.empty() && suns_ == 0) light_from_viewer();
    const glm::dvec3& eye = scene_.camera.position;
    const double depth = std::max(0.01, glm::length(glm::max(glm::abs(eye - box.low), glm::abs(eye - box.high))));
    scene_.left_out = left_out();
    for (const double depths : {10, 3, 1}) scene_.visibilities.push_back(with_two_digits(depths * depth));
  }

  Scene take() {
    scene_.materials = materials_.take();
    return std::move(scene_);
  }

 private:
  /// Adds the directional light to the night's fog and sky. Endless isotropic fog scatters E / 4 pi of E lx into the
  /// eye (single scattering), and so does the horizon; the zenith keeps the night's ratio to it. Surfaces get the mean
  /// of both.
  void light_fog_and_sky() {
    Environment& environment = scene_.environment;
    const glm::vec3 scattered = environment.moon_color / 4.0f;
    const glm::vec3 zenith = scattered * (kZenith / kNightFog);
    environment.sky_horizon += scattered;
    scene_.atmosphere.ambient_fog_color = environment.sky_horizon;
    environment.sky_zenith += zenith;
    environment.ambient_light += (scattered + zenith) / 2.0f;
  }

  /// Lights a file without lights from over the viewer's shoulder, so that shapes show and metals, which reflect no
  /// ambient light, are not black.
  void light_from_viewer() {
    const CameraAxes axes = axes_of(scene_.camera);
    Environment& environment = scene_.environment;
    environment.ambient_light = kLamplessAmbient;
    environment.moon_color = kLamplessSun;
    environment.moon_direction = glm::normalize(0.5 * axes.right + 0.7 * axes.up - 0.6 * axes.forward);
  }

  void expect_known_extensions() const {
    for (const JsonValue& extension : items_of(file_.root(), "extensionsRequired")) {
      if (extension.string() == kBasisu) {
        extension.fail(
            "must not be required: this program reads PNG, JPEG and WebP, not KTX2; export the file with "
            "such pictures");
      }
      if (!is_known(extension.string())) {
        extension.fail("must be one that this program knows: export the file without it");
      }
    }
  }

  static bool is_known(std::string_view extension) {
    return std::ranges::find(kKnownExtensions, extension) != std::end(kKnownExtensions);
  }

  /// What was left out of the file, as text.
  std::string left_out() const {
    std::vector<std::string> parts;
    const auto add = [&parts](std::size_t count, std::string_view one, std::string_view many) {
      if (count > 0) parts.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
    };
    add(items_of(file_.root(), "animations").size(), "animation", "animations");
    add(surfaceless_, "primitive of points or lines", "primitives of points or lines");
    add(materials_.occluded(), "occlusion texture", "occlusion textures");
    add(unmapped_, "primitive without its textures' coordinates", "primitives without their textures' coordinates");
    add(flattened_, "mesh flattened by a scale of 0", "meshes flattened by a scale of 0");
    add(suns_ - std::min<std::size_t>(suns_, 1), "directional light but for the brightest",
        "directional lights but for the brightest");
    add(orthographic_cameras_, "orthographic camera", "orthographic cameras");
    add(other_cameras_, "other camera", "other cameras");
    if (roll_ > kMinRoll) parts.push_back(fmt::format("the camera's roll of {:.0f} degrees", glm::degrees(roll_)));
    const std::size_t scenes = items_of(file_.root(), "scenes").size();
    add(scenes - 1, "other scene", "other scenes");
    std::set<std::string> extensions = materials_.extensions();
    for (const JsonValue& extension : items_of(file_.root(), "extensionsUsed")) extensions.insert(extension.string());
    std::erase_if(extensions, is_known);
    if (!extensions.empty()) parts.push_back(fmt::format("extensions {}", fmt::join(extensions, " ")));
    return fmt::format("{}", fmt::join(parts, ", "));
  }

  void note_files(const std::string& path) {
    scene_.files = {path};
    for (const char* name : {"buffers", "images"}) {
      for (const JsonValue& owner : items_of(file_.root(), name)) {
        if (auto named = gltf_uri_path(owner)) scene_.files.push_back(*std::move(named));
      }
    }
  }

  void read_name(const std::string& path) {
    scene_.name = std::filesystem::path(path).stem().string();
    if (scene_.name.empty() || scene_.name.front() == '.') {
      throw InputError({.file = path}, "must have a name before its ending");
    }
  }

  // --- nodes ---

  static glm::dquat rotation_of(const JsonValue& rotation) {
    const std::vector<double> r = numbers(rotation, 4);
    if (std::ranges::count(r, 0.0) == 4) rotation.fail("must not be all 0");
    return glm::normalize(glm::dquat(r[3], r[0], r[1], r[2]));
  }

  static glm::dmat4 local_transform(const JsonValue& node) {
    if (const auto matrix = node.optional("matrix")) return glm::make_mat4(numbers(*matrix, 16).data());
    glm::dmat4 transform(1.0);
    if (const auto translation = node.optional("translation")) {
      transform = glm::translate(transform, glm::make_vec3(numbers(*translation, 3).data()));
    }
    if (const auto rotation = node.optional("rotation")) {
      transform *= glm::mat4_cast(rotation_of(*rotation));
    }
    if (const auto scale = node.optional("scale")) {
      transform = glm::scale(transform, glm::make_vec3(numbers(*scale, 3).data()));
    }
    return transform;
  }

  /// A node's rotation without its scale: a scale of 0 hides meshes, but not lights and cameras.
  static glm::dmat3 local_turn(const JsonValue& node) {
    const auto matrix = node.optional("matrix");
    if (!matrix) {
      const auto rotation = node.optional("rotation");
      return rotation ? glm::mat3_cast(rotation_of(*rotation)) : glm::dmat3(1.0);
    }
    glm::dmat3 turn(1.0);
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 axis(local_transform(node)[i]);
      if (glm::length(axis) > 0) turn[i] = glm::normalize(axis);
    }
    return turn;
  }

  static void expect_within_limits(const JsonValue& node, const glm::dmat4& transform) {
    const double* const first = glm::value_ptr(transform);
    if (!std::all_of(first, first + 16, [](double x) { return is_within(x, -kMaxCoordinate, kMaxCoordinate); })) {
      node.fail(fmt::format("must lie within {} metres", kMaxCoordinate));
    }
  }

  void read_nodes() {
    struct Visit {
      std::size_t node;
      glm::dmat4 world_from_parent;
      glm::dmat3 parents_turn;
      bool is_carried;
    };
    std::vector<Visit> visits;
    const auto add = [&](const std::vector<JsonValue>& nodes, const glm::dmat4& transform, const glm::dmat3& turn,
                         bool carried) {
      for (std::size_t i = nodes.size(); i-- > 0;) {  // so that the first is popped first
        visits.push_back({index_in(nodes_, nodes[i]), transform, turn, carried});
      }
    };
    const std::vector<JsonValue> scenes = items_of(file_.root(), "scenes");
    if (scenes.empty()) file_.root().fail("must hold a scene");
    const auto chosen = file_.root().optional("scene");
    add(items_of(scenes[chosen ? index_in(scenes, *chosen) : 0], "nodes"), glm::dmat4(1.0), glm::dmat3(1.0), false);
    std::vector<std::size_t> with_mesh;  // read when all nodes are known, because nodes may be joints of their skins
    while (!visits.empty()) {
      Visit visit = visits.back();
      visits.pop_back();
      const JsonValue& node = nodes_[visit.node];
      if (world_from_node_[visit.node]) node.fail("must be one node's child only");
      const glm::dmat4 world_from_node = visit.world_from_parent * local_transform(node);
      expect_within_limits(node, world_from_node);
      world_from_node_[visit.node] = world_from_node;
      const glm::dmat3 turn = visit.parents_turn * local_turn(node);
      if (const auto camera = node.optional("camera")) visit.is_carried |= read_camera(*camera, world_from_node, turn);
      if (node.optional("mesh")) with_mesh.push_back(visit.node);
      if (const auto punctual = extension_of(node, kPunctual)) {
        read_light(punctual->member("light"), world_from_node, turn, visit.is_carried);
      }
      add(items_of(node, "children"), world_from_node, turn, visit.is_carried);
    }
    for (const std::size_t node : with_mesh) read_instances(nodes_[node], *world_from_node_[node]);
  }

  // --- camera ---

  /// Returns whether it is the camera that sees the scene.
  bool read_camera(const JsonValue& index, const glm::dmat4& world_from_node, const glm::dmat3& turn) {
    const JsonValue& camera = cameras_[index_in(cameras_, index)];
    const bool is_perspective = camera.member("type").string() == "perspective";
    if (forward_ || !is_perspective) {
      ++(is_perspective ? other_cameras_ : orthographic_cameras_);
      return false;
    }
    const JsonValue field_of_view = camera.member("perspective").member("yfov");
    const double yfov = field_of_view.number();
    if (!(yfov > 0 && yfov < std::numbers::pi * 0.95)) field_of_view.fail("must be in (0, 2.98) radians");
    glm::dmat3 axes(world_from_node);
    if (!(std::abs(glm::determinant(axes)) > 0)) axes = turn;
    if (!(std::abs(glm::determinant(axes)) > 0)) index.fail("must not be at a node without axes");
    glm::dvec3 forward = -glm::normalize(axes[2]);
    const glm::dvec3 up = glm::normalize(axes[1]);
    // A camera that looks straight up or down needs its own up direction: 0.06 degrees of tilt keep it.
    if (std::hypot(forward.x, forward.z) < kMinTilt) {
      forward = glm::normalize(forward - std::copysign(kMinTilt, forward.y) * up);
    }
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    roll_ = std::abs(std::atan2(glm::dot(up, right), glm::dot(up, glm::cross(right, forward))));
    scene_.camera.position = world_from_node[3];
    scene_.camera.field_of_view = float(yfov);
    forward_ = forward;
    return true;
  }

  /// The bounds of all that is drawn.
  struct WorldBox {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};
  };
  WorldBox world_box() const {
    WorldBox box;
    for (const Instance& instance : scene_.instances) {
      const Bounds own = bounds(scene_.models[instance.model]);
      const glm::dvec3 origin(instance.world_from_model[3]);
      box.low = glm::min(box.low, origin + glm::dvec3(own.low));
      box.high = glm::max(box.high, origin + glm::dvec3(own.high));
    }
    return box;
  }

  /// Puts the target as far ahead as the scene's centre, about which users move the camera; far enough for floats to
  /// keep the camera's heading.
  void aim_at(const WorldBox& box) {
    const glm::dvec3& position = scene_.camera.position;
    const glm::dvec3 middle = (box.low + box.high) * 0.5;
    const double least = 3e-4 * glm::distance(position, local_origin(position)) / std::hypot(forward_->x, forward_->z);
    const double distance =
        std::max({glm::dot(middle - position, *forward_), glm::distance(box.high, middle) / 10, least, 1e-3});
    scene_.camera.target = position + *forward_ * distance;
  }

  /// Shows the whole scene from its front, slightly from above.
  void look_at(const WorldBox& box) {
    const glm::dvec3 middle = (box.low + box.high) * 0.5;
    const double radius = glm::distance(box.high, middle);
    scene_.camera.field_of_view = 0.8f;
    scene_.camera.target = middle;
    scene_.camera.position = middle + glm::normalize(glm::dvec3(0.3, 0.35, 1)) *
                                          (radius / std::sin(double(scene_.camera.field_of_view) / 2));
    if (!has_heading(scene_.camera)) file_.root().fail("meshes", "", "must be larger than a point");
  }

  // --- lights ---

  void read_light(const JsonValue& index, const glm::dmat4& world_from_node, const glm::dmat3& turn, bool is_carried) {
    const std::size_t number = index_in(lights_, index);
    const JsonValue& light = lights_[number];
    const JsonValue type = light.member("type");
    const bool is_spot = type.string() == "spot";
    const bool is_directional = type.string() == "directional";
    if (!is_spot && !is_directional && type.string() != "point") type.fail("must be directional, point or spot");
    glm::dvec3 color(1.0);
    if (const auto given = light.optional("color")) {
      color = glm::make_vec3(numbers(*given, 3).data());
      for (int i = 0; i < 3; ++i) {
        color[i] = snapped(color[i], 0, kMaxColor);
        if (is_within(color[i], 0, kMaxColor)) continue;
        given->items()[std::size_t(i)].fail(fmt::format("must be in [0, {}]", kMaxColor));
      }
    }
    const double intensity = light.number_or("intensity", 1);
    if (!(intensity >= 0)) light.member("intensity").fail("must be >= 0");
    const glm::dvec3 at_one_metre = color * (intensity / kWhiteLux);
    const double brightest = std::max({at_one_metre.r, at_one_metre.g, at_one_metre.b});
    if (brightest == 0) return;
    glm::dvec3 axis = -glm::dvec3(world_from_node[2]);
    if (!(glm::length(axis) > 0)) axis = -turn[2];
    if (!(glm::length(axis) > 0)) {
      if (is_spot || is_directional) index.fail("must not be at a node without axes");
      axis = {0, 0, -1};  // arbitrary: the light shines all around
    }
    if (is_directional) {
      ++suns_;
      if (brightest <= brightest_sun_) return;
      brightest_sun_ = brightest;
      if (!(brightest <= kBrightestSun)) {
        fail_at(light, "intensity", "must not show more than 65504 times the display's white");
      }
      scene_.environment.moon_color = at_one_metre;
      scene_.environment.moon_direction = glm::normalize(-axis);
      return;
    }
    PlacedLight placed;
    const auto name = light.optional("name");
    placed.light.name = name && !name->string().empty() ? name->string() : fmt::format("light {}", number);
    placed.position = glm::dvec3(world_from_node[3]);
    placed.direction = glm::normalize(axis);
    placed.carried = is_carried;
    if (!(intensity <= kMaxCandela)) light.member("intensity").fail(fmt::format("must be at most {}", kMaxCandela));
    const double quadratic = kWhiteLux / intensity;
    placed.light.color = color;
    placed.light.attenuation = {.constant = 1, .linear = 0, .quadratic = quadratic};
    placed.light.source_radius = std::min(kSourceRadius, 0.5 / std::sqrt(quadratic));
    placed.light.threshold = kLeast / std::max({color.r, color.g, color.b, 1.0});
    if (double range = light.number_or("range", 0); range != 0) {
      if (!(range > 0)) light.member("range").fail("must be > 0");
      range = std::min(range, kMaxCoordinate);  // beyond the scene
      placed.light.threshold = std::min(1 / (1 + quadratic * range * range), std::nextafter(1.0, 0.0));
    }
    if (is_spot) placed.light.cone = read_cone(light.member("spot"));
    if (const auto error = find_error(placed)) light.fail(fmt::format("{} {}", error->field, error->rule));
    scene_.light_entries.push_back(scene_.lights.size());
    scene_.light_members.push_back(fmt::format("lights[{}]", scene_.lights.size()));
    scene_.lights.push_back(placed);
    if (scene_.lights.size() > kMaxSceneLights) index.fail(fmt::format("lights must be at most {}", kMaxSceneLights));
    if (is_carried && ++carried_ > kMaxFogLights) {
      index.fail(fmt::format("lights at the camera must be at most {}", kMaxFogLights));
    }
  }

  static Cone read_cone(const JsonValue& spot) {
    const double outer = snapped(spot.number_or("outerConeAngle", std::numbers::pi / 4), 0, std::numbers::pi / 2);
    if (!(outer <= std::numbers::pi / 2)) spot.member("outerConeAngle").fail("must be at most pi/2");
    const double inner = spot.number_or("innerConeAngle", 0);
    // Exporters write a hard edge as inner = outer. As in the extension's own formula, cosines differ by at least
    // 0.001.
    const double hardest = std::acos(std::min(std::cos(outer) + 0.001, 1.0));
    return Cone::smoothstep(inner <= outer ? std::min(inner, hardest) : inner, outer);
  }

  /// Fails at a member, whether it is given or not.
  [[noreturn]] static void fail_at(const JsonValue& object, const char* name, const char* rule) {
    if (const auto member = object.optional(name)) member->fail(rule);
    object.fail(object.path_of(name), "", rule);
  }

  // --- meshes ---

  /// A primitive, read once for all nodes that draw it.
  struct Primitive {
    JsonValue json;
    std::string material;
    Mesh mesh;
  };

  /// The pose of a node's mesh; empty if it has neither weights nor skin.
  GltfPose pose_of(const JsonValue& node, const JsonValue& mesh) const {
    GltfPose pose;
    const auto own = node.optional("weights");
    for (const JsonValue& weight : own ? own->items() : items_of(mesh, "weights")) {
      pose.weights.push_back(weight.number());
    }
    if (std::ranges::count(pose.weights, 0.0) == std::ssize(pose.weights)) pose.weights.clear();
    const auto skin_index = node.optional("skin");
    if (!skin_index) return pose;
    const JsonValue& skin = skins_[index_in(skins_, *skin_index)];
    const JsonValue joints_given = skin.member("joints");
    const std::vector<JsonValue> joints = joints_given.items();
    if (joints.empty()) joints_given.fail("must not be empty");
    GltfNumbers joint_from_mesh;
    if (const auto matrices = skin.optional("inverseBindMatrices")) {
      joint_from_mesh = file_.numbers(*matrices, {kGltfMat4}, {GltfComponent::floating});
      if (joint_from_mesh.count < joints.size()) matrices->fail("must have a matrix for each joint");
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const auto& world_from_joint = world_from_node_[index_in(nodes_, joints[i])];
      if (!world_from_joint) joints[i].fail("must be a node of the scene");
      glm::dmat4 bind(1.0);
      for (int k = 0; joint_from_mesh.data && k < 16; ++k) bind[k / 4][k % 4] = joint_from_mesh.at(i, std::size_t(k));
      pose.world_from_mesh.push_back(*world_from_joint * bind);
    }
    return pose;
  }

  /// A node's mesh, once or as often as it states (EXT_mesh_gpu_instancing).
  void read_instances(const JsonValue& node, const glm::dmat4& world_from_node) {
    const std::size_t mesh = index_in(meshes_, node.member("mesh"));
    GltfPose pose = pose_of(node, meshes_[mesh]);
    const bool is_skinned = !pose.world_from_mesh.empty();
    // A skinned mesh is where its joints are (glTF 2.0, 3.7.3.3): its vertices' floats need an origin near there.
    const glm::dvec3 origin = is_skinned ? local_origin(pose.world_from_mesh.front()[3]) : glm::dvec3(0);
    for (glm::dmat4& world_from_mesh : pose.world_from_mesh) world_from_mesh[3] -= glm::dvec4(origin, 0);
    std::vector<Primitive> posed;
    if (is_skinned || !pose.weights.empty()) posed = read_primitives(mesh, pose);
    const std::vector<Primitive>& primitives = posed.empty() ? primitives_of(mesh) : posed;
    if (is_skinned) return draw(primitives, glm::translate(glm::dmat4(1), origin));
    const auto instancing = extension_of(node, "EXT_mesh_gpu_instancing");
    if (!instancing) return draw(primitives, world_from_node);
    using enum GltfComponent;
    const JsonValue attributes = instancing->member("attributes");
    std::optional<std::size_t> count;
    const auto read = [&](const char* name, const GltfType& type, std::initializer_list<GltfComponent> components) {
      const auto index = attributes.optional(name);
      if (!index) return GltfNumbers{};
      const GltfNumbers given = file_.numbers(*index, {type}, components);
      if (count && *count != given.count) index->fail("must have as many elements as the other attributes");
      count = given.count;
      return given;
    };
    const GltfNumbers translations = read("TRANSLATION", kGltfVec3, {floating});
    const GltfNumbers rotations = read("ROTATION", kGltfVec4, {floating, signed_byte, signed_short});
    const GltfNumbers scales = read("SCALE", kGltfVec3, {floating});
    for (std::size_t i = 0; i < count.value_or(1); ++i) {
      glm::dmat4 transform = world_from_node;
      if (translations.data) transform = glm::translate(transform, glm::dvec3(translations.vec3(i)));
      if (rotations.data) {
        const glm::dquat rotation(rotations.at(i, 3), rotations.at(i, 0), rotations.at(i, 1), rotations.at(i, 2));
        if (!(glm::length(rotation) > 0)) attributes.member("ROTATION").fail("must not be all 0");
        transform *= glm::mat4_cast(glm::normalize(rotation));
      }
      if (scales.data) transform = glm::scale(transform, glm::dvec3(scales.vec3(i)));
      expect_within_limits(node, transform);
      draw(primitives, transform);
    }
  }

  void draw(const std::vector<Primitive>& primitives, const glm::dmat4& world_from_node) {
    const glm::dmat3 linear(world_from_node);
    if (!(std::abs(glm::determinant(linear)) > 1e-18)) {
      flattened_ += linear != glm::dmat3(0.0);  // a scale of 0 in all axes hides a mesh
      return;
    }
    if (primitives.empty()) return;
    Bounds box = bounds(primitives.front().mesh);
    for (const Primitive& primitive : primitives) box = united(box, bounds(primitive.mesh));
    const glm::dvec3 origin =
        local_origin(world_from_node * glm::dvec4(0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high)), 1));
    glm::dmat4 model_from_node = world_from_node;
    model_from_node[3] -= glm::dvec4(origin, 0);
    Model& model = model_at(origin);
    for (const Primitive& primitive : primitives) {
      const Mesh& mesh = primitive.mesh;
      drawn_.take(primitive.json, mesh.indices.size() / 3, mesh.vertices.size());
      append(part(model, primitive.material), mesh, model_from_node);
    }
  }

  /// The model of all that is drawn near an origin, the origin of its vertices.
  Model& model_at(const glm::dvec3& origin) {
    const auto [entry, is_new] = models_.try_emplace({origin.x, origin.y, origin.z}, scene_.models.size());
    if (is_new) {
      scene_.instances.push_back({scene_.models.size(), glm::translate(glm::dmat4(1), origin)});
      scene_.models.emplace_back();
    }
    return scene_.models[entry->second];
  }

  const std::vector<Primitive>& primitives_of(std::size_t mesh) {
    if (!is_read_[mesh]) primitives_[mesh] = read_primitives(mesh, {});
    is_read_[mesh] = true;
    return primitives_[mesh];
  }

  std::vector<Primitive> read_primitives(std::size_t mesh, const GltfPose& pose) {
    std::vector<Primitive> primitives;
    for (const JsonValue& json : meshes_[mesh].member("primitives").items()) {
      if (is_without_surface(json)) {
        ++surfaceless_;
        continue;
      }
      const GltfMaterial& material = materials_.use(json);
      const JsonValue attributes = json.member("attributes");
      unmapped_ += std::ranges::any_of(
          material.sets, [&](std::size_t set) { return !attributes.optional(fmt::format("TEXCOORD_{}", set)); });
      primitives.push_back({json, material.name, read_gltf_primitive(file_, json, material, pose, read_)});
    }
    return primitives;
  }

  GltfFile file_;
  std::vector<JsonValue> nodes_;
  std::vector<JsonValue> cameras_;
  std::vector<JsonValue> lights_;
  std::vector<JsonValue> meshes_;
  std::vector<JsonValue> skins_;
  std::vector<std::optional<glm::dmat4>> world_from_node_;  // nodes visited so far
  std::vector<std::vector<Primitive>> primitives_;          // one per mesh, as in the file, read when first drawn
  std::vector<bool> is_read_;                               // one per mesh
  std::map<std::array<double, 3>, std::size_t> models_;     // indices in the scene, by origin
  GltfMaterials materials_;
  Scene scene_;
  std::optional<glm::dvec3> forward_;  // the camera's, if there is one
  double roll_ = 0;                    // the camera's, radians
  double brightest_sun_ = 0;
  MeshBudget read_;
  MeshBudget drawn_;
  std::size_t carried_ = 0;
  // What is left out.
  std::size_t surfaceless_ = 0;
  std::size_t unmapped_ = 0;
  std::size_t flattened_ = 0;
  std::size_t suns_ = 0;
  std::size_t orthographic_cameras_ = 0;
  std::size_t other_cameras_ = 0;
};

}  // namespace

bool is_gltf_path(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension();
  return strcasecmp(ending.c_str(), ".gltf") == 0 || strcasecmp(ending.c_str(), ".glb") == 0;
}

Scene read_gltf_scene(const std::string& path) { return GltfReader(path).take(); }

}  // namespace litfog::scene
