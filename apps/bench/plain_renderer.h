// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"
#include "render/gpu/data_texture.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/texture.h"
#include "render/plan/view.h"
#include "scene/scene.h"

namespace litfog::bench {

inline constexpr std::size_t kMaxPlainLights = 64;  ///< more exceed some drivers' uniforms

/// A light of the uniform array: LitfogLight of litfog/shaders/light.glsl.
struct PlainLight {
  glm::vec4 position_extent;
  glm::vec4 axis_profile;
  glm::vec4 color_intensity;
  glm::vec4 attenuation;
  glm::vec4 cone;
};

/// The rival of the renderer's default path: the forward renderer that an engineer writes in an afternoon. One shader
/// loops over all lights in a uniform array; each mesh is one draw call; nothing is skipped. Its picture equals that of
/// FogLighting::peak within 1/255 of the display's white. With several samples a pixel, up to one value in 300 differs
/// by more, at edges of surfaces. Needs a current GL context.
class PlainRenderer {
 public:
  /// scene   at most kMaxPlainLights lights; must outlive this object
  /// throws  gl::Unsupported where the driver has no framebuffer of that size or fewer samples
  PlainRenderer(const scene::Scene& scene, int width, int height, int samples);

  void set_atmosphere(const Atmosphere& atmosphere);
  /// Draws a frame and waits for it.
  void draw();
  render::Picture read() const { return framebuffer_.read(); }

 private:
  struct Material {
    const scene::Material* material;
    std::shared_ptr<const render::Texture> albedo;
    std::shared_ptr<const render::Texture> normal;
  };
  struct Mesh {
    explicit Mesh(const scene::Mesh& mesh);

    gl::VertexArrayName vertex_array;
    gl::BufferName vertices;
    gl::BufferName indices;
    int index_count;
  };
  struct Draw {
    const Material* material;
    const Mesh* mesh;
    glm::mat4 world_from_model;
  };

  /// Makes a program current and sets the uniforms common to all.
  void use(const gl::Program& program) const;
  void draw_surfaces(const glm::mat4& clip_from_world) const;
  void draw_light_points(const render::View& view) const;

  const scene::Scene& scene_;
  Atmosphere atmosphere_;
  render::Framebuffer framebuffer_;
  std::vector<std::size_t> light_order_;  // in the uniform array: local lights first
  std::size_t local_count_;
  std::vector<PlainLight> packed_;  // in that order
  gl::FogLightBuffer fog_block_;    // for the light points; holds no lights
  std::optional<render::LayeredTexture> cookies_;
  std::map<std::string, Material> materials_;
  std::vector<std::vector<std::unique_ptr<Mesh>>> meshes_;  // by model
  std::vector<Draw> draws_;                                 // sorted by material
  gl::Program surface_program_;
  gl::Program sky_program_;
  gl::Program light_point_program_;
};

}  // namespace litfog::bench
