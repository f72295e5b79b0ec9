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

/// A material with its textures on the GPU.
struct SurfaceMaterial {
  scene::Material material;                 ///< without its texels
  float number;                             ///< position in the order of materials
  double reflectance;                       ///< largest component of diffuse plus specular reflectance
  double ambient;                           ///< largest component of the reflectance of ambient light
  double emitted;                           ///< largest component of its own light, linear
  bool is_flat;                             ///< all texels of its normal map are flat
  std::shared_ptr<const Texture> albedo;    ///< shared by materials with the same texels
  std::shared_ptr<const Texture> normal;    ///< null: not used
  std::shared_ptr<const Texture> emission;  ///< null: none
  std::shared_ptr<const Texture> second;    ///< null: none

  bool is_pane() const { return material.opacity.has_value(); }
  /// Upper bound of its light without lamps, largest component, linear.
  double own_light(const scene::Environment& environment) const {
    return emitted + ambient * largest_component(environment.ambient_light) +
           reflectance * largest_component(environment.moon_color);
  }
};

/// A chunk placed in the world, and the lights that can reach it.
struct Surface {
  const SurfaceMaterial* material;
  const Chunk* chunk;
  glm::mat4 world_from_model;
  scene::Bounds bounds;  ///< world space, relative to SceneLights::origin() like the matrix
  bool is_fog_lit;       ///< a carried light's cone meets it, so that carried lights light the fog before it
  int list_first;        ///< its lights are list_count entries of SurfaceList::lists() from here on
  int list_count;
};

/// The surfaces of a scene, sorted by material to change the least GL state; EarlyRejection has other orders. Needs a
/// current GL context.
class SurfaceList {
 public:
  /// has_normal_maps  false uploads none
  /// throws           gl::Unsupported where this OpenGL cannot hold the light lists; std::invalid_argument where the
  ///                  scene lacks a part's material
  SurfaceList(const scene::Scene& scene, const SceneLights& lights, Skipping skipping, bool has_normal_maps = true);

  /// Applies a change of the scene's objects. A material whose name has been used before stays as it was. Must be
  /// followed by set_lights().
  ///
  /// throws  like the constructor
  void set_objects(const scene::Scene& scene);
  /// Applies a change of the lights. The surfaces keep their number and order. Where lights light surfaces beyond their
  /// ends, their reach is the largest of kReaches that keeps all lists together short enough: infinity for up to some
  /// millions of surfaces times lights. With a finite reach a surface in clear air lacks at most the sum of colour
  /// times attenuation at its nearest point over the lights beyond reach: in `approach` (1148 lights, 16) 0.5/255 of
  /// white, in `city` (400 lights, 8) 3.7/255 (surface_list_test.cpp). As drawn, pictures at 16 err by up to 0.3 steps
  /// of 1/255, at 1 by 35 (`city`) and 8.9.
  ///
  /// throws  gl::Unsupported like the constructor
  void set_lights(const scene::Scene& scene, const SceneLights& lights, Skipping skipping);

  static constexpr double kReaches[] = {std::numeric_limits<double>::infinity(), 16, 8, 4, 2, 1};
  /// The range up to which lights light surfaces, as a multiple of their extents.
  double reach() const { return reach_; }
  /// The range up to which a light of an extent lights surfaces, metres.
  double range_of(double extent) const { return extent > 0 ? extent * reach_ : 0; }

  const std::vector<Surface>& surfaces() const { return surfaces_; }
  /// The lights that can reach a surface: indices in SceneLights, ascending. Without skipping all lights, or none for a
  /// surface beyond lights.
  std::span<const std::int32_t> lights_of(const Surface& surface) const {
    return std::span(list_).subspan(std::size_t(surface.list_first), std::size_t(surface.list_count));
  }
  std::span<const std::int32_t> lists() const { return list_; }  ///< lights_of() all surfaces, one after another
  /// All materials, in the order of their numbers.
  std::vector<scene::Material> materials() const;
  bool has_panes() const { return std::ranges::any_of(materials_, &SurfaceMaterial::is_pane); }
  /// The vertices, for whole surfaces and for triangles of panes in sorted order.
  const MeshStore& meshes() const { return meshes_; }

 private:
  /// Lists the lights that reach each surface. Returns false, with the lists incomplete, if they have more than `most`
  /// entries.
  bool list_lights(const scene::Scene& scene, const SceneLights& lights, Skipping skipping, std::size_t most);
  const SurfaceMaterial& material(const std::string& name) const;
  MeshStore upload_meshes(const scene::Scene& scene) const;

  bool has_normal_maps_;
  std::vector<SurfaceMaterial> materials_;  // sorted by name
  MeshStore meshes_;
  double reach_ = 1;
  std::vector<Surface> surfaces_;
  std::vector<std::int32_t> list_;  // indices in SceneLights
};

}  // namespace litfog::render
