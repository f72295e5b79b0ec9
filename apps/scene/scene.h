// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "litfog/atmosphere.h"
#include "litfog/light.h"
#include "litfog/photometry/cookie.h"
#include "scene/camera.h"
#include "scene/light_frame.h"
#include "scene/material.h"
#include "scene/mesh.h"

namespace litfog::scene {

// Limits of a scene, so that no file exhausts memory or exceeds what floats can draw.
inline constexpr std::size_t kMaxSceneLights = 100'000;
inline constexpr std::size_t kMaxTriangles = 20'000'000;
inline constexpr std::size_t kMaxVertices = 20'000'000;  ///< in all models: 960 MB, below the 2 GiB of a GL buffer
inline constexpr double kMaxCoordinate = 1e7;            ///< metres
inline constexpr double kMaxExposure = 32;               ///< EV, above and below 0; half floats span 40
inline constexpr double kMaxColor = 1e4;                 ///< a framebuffer's half floats end at 65,504

/// The light of a scene besides its lamps. Colours are linear RGB.
struct Environment {
  glm::vec3 ambient_light{0.0f};
  glm::vec3 sky_zenith{0.0f};
  glm::vec3 sky_horizon{0.0f};
  float star_brightness = 0.0f;
  glm::vec3 moon_direction{0.0f, 1.0f, 0.0f};  ///< unit, towards the moon
  glm::vec3 moon_color{0.0f};                  ///< light on surfaces outside the fog; 0 is no moon

  friend bool operator==(const Environment&, const Environment&) = default;

  bool has_moon() const { return moon_color != glm::vec3(0.0f); }
};

/// A placed model.
struct Instance {
  std::size_t model;
  glm::dmat4 world_from_model;
  bool is_beyond_lights = false;  ///< drawn without lights, none of which reach it or its fog (render::sort_polygons)
};

/// An instance's matrix relative to an origin.
inline glm::dmat4 placed_relative_to(const glm::dvec3& origin, const Instance& instance) {
  glm::dmat4 placed = instance.world_from_model;
  placed[3] -= glm::dvec4(origin, 0);
  return placed;
}

/// A cookie that replaces a light's cone, turned about the light's axis, to the right as seen along the axis.
struct CookieUse {
  std::size_t cookie;
  double roll = 0;  ///< radians
  double spin = 0;  ///< radians a second
};

/// The default display of a scene's pictures.
struct SceneDisplay {
  std::optional<double> exposure = 0.0;  ///< EV, [-32, 32]; nothing: chosen from each picture
  bool is_clipped = false;               ///< channels are cut at white; otherwise the hue is kept

  friend bool operator==(const SceneDisplay&, const SceneDisplay&) = default;
};

/// A light's mount on a vehicle: its direction as seen from the vehicle.
struct Mount {
  Attitude vehicle = {};
  Bearing light = {};
};

/// Everything that a renderer draws. Plain data: no GL.
struct Scene {
  std::vector<std::string> files;  ///< all files read: the scene's, light files, cookies, buffers, pictures
  std::string name;
  std::string description;
  std::string left_out;  ///< contents of the file that are not drawn, in words; empty: none
  Camera camera;
  Environment environment;
  std::vector<Material> materials;  ///< all that parts name
  std::vector<Model> models;
  std::vector<Instance> instances;
  std::vector<PlacedLight> lights;
  /// The members of the file that state lights: "lights[2]", "city.window". Each light of a glTF file has one, as if it
  /// were in a scene file.
  std::vector<std::string> light_members;
  std::vector<std::size_t> light_entries;  ///< one per light: index in light_members
  bool has_city = false;                   ///< its lights are the last ones, its instances among all (model/city.h)
  std::set<std::size_t> city_without;      ///< City::without
  std::vector<Cookie> cookies;
  std::map<std::size_t, CookieUse> cookie_uses;  ///< by light; these lights have no cone
  std::map<std::size_t, Mount> mounts;           ///< by light; they give these lights' directions
  std::map<std::size_t, double> turn_rates;      ///< by light; radians a second at which its axis turns about +Y
  std::vector<double> visibilities;              ///< metres, for the gallery
  bool is_lit_at_vertices = false;  ///< shows tessellation with light at vertices; a gallery of all scenes omits it
  SceneDisplay display = {};
  double seconds = 0;            ///< time, by which lights flash (lit_light)
  std::vector<FogLayer> layers;  ///< as in the file
  /// Fog of droplets, clear until the scene is drawn, which chooses the visibility outside the layers. The profile is
  /// the layers' at the contrast kContrastMor.
  Atmosphere atmosphere = {.phase = Phase::droplets(kDroplets)};
  bool states_phase = false;  ///< whether the file states the phase function

  static constexpr double kDroplets = 10;  ///< micrometres
};

/// Largest time. A cookie or light at ten turns a second is then still exact to a thousandth of a degree.
inline constexpr double kMaxSeconds = 1e9;

/// Moves a scene as read, which is at time 0, to a time: turns spinning cookies and turning lights.
///
/// seconds  [0, kMaxSeconds]
/// throws   std::invalid_argument naming the rule
inline void move_to_time(Scene& scene, double seconds) {
  if (!(seconds >= 0 && seconds <= kMaxSeconds)) throw std::invalid_argument("seconds: must be in [0, 1e9]");
  for (auto& [light, use] : scene.cookie_uses) use.roll += use.spin * seconds;
  for (const auto& [light, rate] : scene.turn_rates) {
    glm::dvec3& direction = scene.lights[light].direction;
    direction = glm::dmat3(glm::rotate(glm::dmat4(1), rate * seconds, glm::dvec3(0, 1, 0))) * direction;
  }
  scene.seconds = seconds;
}

/// A light at the scene's time: a flashing light is dark between its flashes.
inline PlacedLight lit_light(const Scene& scene, std::size_t light) {
  PlacedLight lit = scene.lights[light];
  lit.light.color *= flash_at(lit.light.flash, scene.seconds);
  return lit;
}

/// The default visibility of a scene, metres: the middle one of its own; without any, infinite with layers, else 200.
inline double suggested_visibility(const Scene& scene) {
  if (!scene.visibilities.empty()) return scene.visibilities[scene.visibilities.size() / 2];
  return scene.layers.empty() ? 200 : std::numeric_limits<double>::infinity();
}

}  // namespace litfog::scene
