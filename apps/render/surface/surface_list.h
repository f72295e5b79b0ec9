// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/gpu/texture.h"
#include "render/light/scene_lights.h"
#include "render/render_settings.h"
#include "render/surface/mesh_store.h"
#include "scene/material.h"
#include "scene/scene.h"

namespace litfog::render {

/// A material with its pictures on the GPU.
struct SurfaceMaterial {
  scene::Material material;  ///< without its texels
  float number;              ///< in their order
  double reflectance;        ///< most of a light that it reflects, diffuse and specular together: the largest component
  double diffuse;            ///< most of it that is diffuse, likewise
  double emitted;            ///< most that it sends to the eye by itself: linear, likewise
  bool is_flat;              ///< all texels of its normal map say so
  std::shared_ptr<const Texture> albedo;  ///< materials of the same texels share their texture
  std::shared_ptr<const Texture> normal;
  std::shared_ptr<const Texture> emission;  ///< null: none
  std::shared_ptr<const Texture> second;    ///< null: none

  bool is_pane() const { return material.opacity.has_value(); }
  /// What it sends to the eye without lamps is at most this: linear, the largest component.
  double own_light(const scene::Environment& environment) const {
    return emitted + diffuse * largest_component(environment.ambient_light) +
           reflectance * largest_component(environment.moon_color);
  }
};

/// A run of triangles of one material, placed in the world, and the lights that can reach it.
struct Surface {
  const SurfaceMaterial* material;
  const Chunk* chunk;
  glm::mat4 world_from_model;
  scene::Bounds bounds;  ///< world space, relative to SceneLights::origin() like the matrix
  bool is_fog_lit;       ///< a carried light's cone meets it, so that fog before it is lit by such lights
  int list_first;        ///< in the lists of all surfaces: the lights that can reach it, of which there are
  int list_count;
};

/// The surfaces of a scene, sorted by material. Needs a current GL context.
class SurfaceList {
 public:
  /// throws  gl::Unsupported where this OpenGL cannot hold the light lists, std::invalid_argument where a part is of a
  ///         material that the scene lacks
  SurfaceList(const scene::Scene& scene, const SceneLights& lights, Skipping skipping);

  /// Takes a change of the scene's objects; set_lights() has to follow. Materials of names that it has had stay as they
  /// are.
  ///
  /// throws  as the constructor
  void set_objects(const scene::Scene& scene);
  /// Takes a change of the lights. The surfaces stay as many as they are, in their order. Where lights light surfaces
  /// beyond their ends, they have the largest of kReaches that leaves all lists together short enough: infinity where
  /// surfaces times lights are some millions or fewer. What is cut off by another is not bounded: at 16, which `city`
  /// (400 lights) and `approach` (1148) have, pictures in clear air err by up to 0.3 steps of 1/255, of 35 and 8.9
  /// at 1.
  ///
  /// throws  gl::Unsupported as the constructor
  void set_lights(const scene::Scene& scene, const SceneLights& lights, Skipping skipping);

  static constexpr double kReaches[] = {std::numeric_limits<double>::infinity(), 16, 8, 4, 2, 1};
  /// How far lights light surfaces, in their extents.
  double reach() const { return reach_; }
  /// How far a light of an extent does, metres.
  double range_of(double extent) const { return extent > 0 ? extent * reach_ : 0; }

  const std::vector<Surface>& surfaces() const { return surfaces_; }
  /// The lights that can reach a surface: indices in SceneLights, ascending. Without skipping they are
  /// all lights, or none of a surface that is beyond lights.
  std::span<const std::int32_t> lights_of(const Surface& surface) const {
    return std::span(list_).subspan(std::size_t(surface.list_first), std::size_t(surface.list_count));
  }
  std::span<const std::int32_t> lists() const { return list_; }  ///< of all surfaces
  /// In the order of their numbers.
  std::vector<scene::Material> materials() const;
  bool has_panes() const { return std::ranges::any_of(materials_, &SurfaceMaterial::is_pane); }
  /// The vertices and what is drawn of them: all triangles of a surface, or triangles of panes in an order of their
  /// own.
  const MeshStore& meshes() const { return meshes_; }

 private:
  /// Lists the lights that reach each surface. Returns false, with some surfaces only, where that makes too many.
  bool list_lights(const scene::Scene& scene, const SceneLights& lights, Skipping skipping, std::size_t most);
  const SurfaceMaterial& material(const std::string& name) const;
  MeshStore upload_meshes(const scene::Scene& scene) const;

  std::vector<SurfaceMaterial> materials_;  // sorted by name
  MeshStore meshes_;
  double reach_ = 1;
  std::vector<Surface> surfaces_;
  std::vector<std::int32_t> list_;  // indices in SceneLights
};

}  // namespace litfog::render
