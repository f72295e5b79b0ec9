// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

#include "command/exit_status.h"
#include "litfog/fog_light_block.h"
#include "litfog/input_error.h"
#include "scene/file/gltf_file.h"
#include "scene/file/gltf_material.h"
#include "scene/file/gltf_mesh.h"

namespace litfog::scene {
namespace {

constexpr double kBrightestAtKnee = 16;          // of the display's white
constexpr double kThreshold = 1.0 / (16 * 512);  // half of 1/256 of the display's white
constexpr glm::vec3 kNightAmbient{0.045f, 0.05f, 0.07f};
constexpr glm::vec3 kLampless{0.6f};
constexpr glm::vec3 kNightFog{0.012f, 0.013f, 0.017f};
constexpr glm::vec3 kZenith{0.0012f, 0.0018f, 0.005f};

class GltfReader {
 public:
  explicit GltfReader(const std::string& path) : file_(path), model_(file_.model()), materials_(file_) {
    for (std::size_t i = 0; i < model_.extensionsRequired.size(); ++i) {
      if (model_.extensionsRequired[i] != "KHR_lights_punctual") {
        file_.refuse(GltfPlace{} / "extensionsRequired" / i,
                     "must be KHR_lights_punctual, the only one that this program knows");
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
    if (scene_.models[0].empty()) throw InputError({.file = path}, "meshes: must hold triangles");
    scene_.instances.push_back({0, glm::mat4(1.0f)});
    const Bounds box = bounds(scene_.models[0]);
    const double size = std::max(0.01, double(glm::distance(box.low, box.high)));
    if (!has_camera_) look_at(box);
    if (scene_.lights.empty() && scene_.environment.moon_color == glm::vec3(0.0f)) {
      scene_.environment.ambient_light = kLampless;
    }
    scene_.visibilities = {8 * size, 2 * size, size / 2};
  }

  Scene take() {
    scene_.files = file_.files();
    scene_.materials = materials_.take();
    return std::move(scene_);
  }

 private:
  void read_name() {
    scene_.name = std::filesystem::path(file_.path()).stem().string();
    if (scene_.name.empty() || scene_.name.front() == '.')
      throw InputError({.file = file_.path()}, "must have a name before its ending");
  }

  // --- nodes ---

  static glm::dmat4 local_transform(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
    glm::dmat4 transform(1.0);
    if (node.translation.size() == 3) transform = glm::translate(transform, glm::make_vec3(node.translation.data()));
    if (node.rotation.size() == 4) {
      const std::vector<double>& r = node.rotation;
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
    const auto add = [&](const GltfPlace& place, const std::vector<int>& nodes, const glm::dmat4& transform,
                         bool carried) {
      for (std::size_t i = nodes.size(); i-- > 0;) {  // the first one comes off the stack first
        visits.push_back({file_.index(place / i, nodes[i], model_.nodes.size()), transform, carried});
      }
    };
    if (model_.scenes.empty()) file_.refuse({}, "must hold a scene");
    const std::size_t scene =
        model_.defaultScene < 0 ? 0 : file_.index(GltfPlace{} / "scene", model_.defaultScene, model_.scenes.size());
    add(GltfPlace{} / "scenes" / scene / "nodes", model_.scenes[scene].nodes, glm::dmat4(1.0), false);
    std::vector<bool> is_met(model_.nodes.size());
    while (!visits.empty()) {
      Visit visit = visits.back();
      visits.pop_back();
      const tinygltf::Node& node = model_.nodes[visit.node];
      const GltfPlace place = GltfPlace{} / "nodes" / visit.node;
      if (is_met[visit.node]) file_.refuse(place, "must be one node's child only");
      is_met[visit.node] = true;
      const glm::dmat4 world_from_node = visit.world_from_parent * local_transform(node);
      const double* const first = glm::value_ptr(world_from_node);
      if (!std::all_of(first, first + 16, [](double x) { return std::abs(x) <= kMaxCoordinate; })) {
        file_.refuse(place, fmt::format("must lie within {} metres", kMaxCoordinate));
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
  bool read_camera(const GltfPlace& place, int number, const glm::dmat4& world_from_node) {
    const tinygltf::Camera& camera = model_.cameras[file_.index(place, number, model_.cameras.size())];
    if (has_camera_ || camera.type != "perspective") return false;
    const GltfPlace yfov = GltfPlace{} / "cameras" / std::size_t(number) / "perspective" / "yfov";
    if (!(camera.perspective.yfov > 0 && camera.perspective.yfov < std::numbers::pi * 0.95)) {
      file_.refuse(yfov, "must be in (0, 2.98) radians");
    }
    const glm::dvec3 forward = -glm::dvec3(world_from_node[2]);
    if (!(glm::length(glm::dvec2(forward.x, forward.z)) > 1e-4 * glm::length(forward))) {
      file_.refuse(place, "must not look straight up or down");
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

  void read_light(const GltfPlace& place, int number, const glm::dmat4& world_from_node, bool is_carried) {
    const tinygltf::Light& light = model_.lights[file_.index(place, number, model_.lights.size())];
    const GltfPlace own = GltfPlace{} / "extensions" / "KHR_lights_punctual" / "lights" / std::size_t(number);
    glm::dvec3 color(1.0);
    if (!light.color.empty()) color = glm::make_vec3(light.color.data());
    if (!glm::all(glm::greaterThanEqual(color, glm::dvec3(0.0)))) file_.refuse(own / "color", "must be >= 0");
    if (!(light.intensity >= 0)) file_.refuse(own / "intensity", "must be >= 0");
    const glm::dvec3 at_one_metre = color * (light.intensity / std::numbers::pi);
    const double brightest = std::max({at_one_metre.r, at_one_metre.g, at_one_metre.b});
    if (brightest == 0) return;
    const glm::dvec3 axis = -glm::dvec3(world_from_node[2]);
    if (!(glm::length(axis) > 0)) file_.refuse(place, "must not be at a node of scale 0");
    if (light.type == "directional") {
      if (scene_.environment.moon_color != glm::vec3(0.0f)) file_.refuse(own, "must be the only directional light");
      if (!(brightest <= kMaxColor))
        file_.refuse(own / "intensity", "must not show more than 10000 times the display's white");
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
      if (!(light.range > 0 && light.range <= kMaxCoordinate))
        file_.refuse(own / "range", "must be > 0 and at most 1e7");
      knee_square = std::min(knee_square, light.range * light.range / 4);
      placed.light.threshold = knee_square / (light.range * light.range);
    }
    placed.light.attenuation = {.constant = 0, .linear = 0, .quadratic = 1 / knee_square};
    placed.light.color = at_one_metre / knee_square;
    if (light.type == "spot") {
      placed.light.cone = Cone::smoothstep(light.spot.innerConeAngle, light.spot.outerConeAngle);
      if (!(light.spot.outerConeAngle <= std::numbers::pi / 2)) {
        file_.refuse(own / "spot" / "outerConeAngle", "must be at most pi/2");
      }
    } else if (light.type != "point") {
      file_.refuse(own / "type", "must be directional, point or spot");
    }
    if (const auto refusal = check(placed.light)) file_.refuse(own, refusal->field + std::string(" ") + refusal->rule);
    if (!(brightest / knee_square <= kMaxColor)) {
      file_.refuse(own / "range", "must not end a light where it shows more than 2500 times the display's white");
    }
    scene_.lights.push_back(placed);
    if (scene_.lights.size() > kMaxSceneLights) {
      file_.refuse(place, fmt::format("lights must be at most {}", kMaxSceneLights));
    };
    if (is_carried && ++carried_ > kMaxFogLights) {
      file_.refuse(place, fmt::format("lights at the camera must be at most {}", kMaxFogLights));
    }
  }

  // --- meshes ---

  void read_mesh(const GltfPlace& place, int number, const glm::dmat4& world_from_node) {
    if (!(std::abs(glm::determinant(glm::dmat3(world_from_node))) > 1e-18)) return;  // flattened to nothing
    const std::size_t at = file_.index(place, number, model_.meshes.size());
    const auto& primitives = model_.meshes[at].primitives;
    for (std::size_t i = 0; i < primitives.size(); ++i) {
      const GltfPlace own = GltfPlace{} / "meshes" / at / "primitives" / i;
      const Mesh mesh = read_gltf_primitive(file_, own, primitives[i]);
      triangles_ += mesh.indices.size() / 3;
      vertices_ += mesh.vertices.size();
      if (triangles_ > kMaxTriangles || vertices_ > kMaxVertices) {
        file_.refuse(own, fmt::format("triangles must be at most {} in all, vertices {}", kMaxTriangles, kMaxVertices));
      }
      append(part(scene_.models[0], materials_.use(own / "material", primitives[i].material)), mesh, world_from_node);
    }
  }

  GltfFile file_;
  const tinygltf::Model& model_;
  GltfMaterials materials_;
  Scene scene_;
  bool has_camera_ = false;
  std::size_t triangles_ = 0;
  std::size_t vertices_ = 0;
  std::size_t carried_ = 0;
};

}  // namespace

bool is_gltf_path(const std::string& path) {
  const auto ending = std::filesystem::path(path).extension();
  return ending == ".gltf" || ending == ".glb";
}

Scene read_gltf_scene(const std::string& path) { return GltfReader(path).take(); }

}  // namespace litfog::scene
