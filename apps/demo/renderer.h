// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framebuffer.h"
#include "light_list.h"
#include "litfog/gl/fog_light_buffer.h"
#include "litfog/gl/program.h"
#include "litfog/solve.h"
#include "material.h"
#include "mesh_store.h"
#include "scene.h"
#include "texture.h"

namespace litfog::demo {

/// Whether the renderer leaves out what cannot show: surfaces out of view, lights out of reach of a surface.
enum class Skipping { on, off };

/// What a frame drew, and what it could leave out.
struct FrameCounts {
  std::size_t chunks_drawn = 0;
  std::size_t chunks_skipped = 0;  ///< out of view
  std::size_t lights_listed = 0;   ///< listed for all drawn chunks together
  std::size_t lights_skipped = 0;  ///< not listed, for all drawn chunks together
};

/// Draws a scene by the path `unified` into a framebuffer. Needs a current GL 3.3 core context.
class Renderer {
 public:
  /// throws gl::Unsupported where this OpenGL cannot hold the scene's light lists, std::invalid_argument where the
  /// eye's vehicle carries more than kMaxFogLights
  Renderer(const Scene& scene, int width, int height, Skipping skipping);

  /// Takes a change of the fog: solves the carried lights and uploads the block.
  void set_fog(const Fog& fog);
  /// Draws a frame and waits for it.
  FrameCounts draw();
  Picture read() const { return framebuffer_.read(); }

 private:
  struct MaterialTextures {
    Material material;  // its texels are dropped after the upload
    Texture albedo;
    Texture normal;
  };
  struct Draw {
    const MaterialTextures* material;
    const Chunk* chunk;
    glm::mat4 world_from_model;
    Bounds bounds;  // world space
    int list_first;
    int list_count;
  };

  void load_materials();
  void make_draws(const std::vector<double>& extents);
  FrameCounts draw_surfaces(const glm::mat4& clip_from_world);
  void draw_sky(const glm::mat4& clip_from_world);
  void draw_light_points(const glm::mat4& clip_from_world);

  const Scene& scene_;
  Skipping skipping_;
  Framebuffer framebuffer_;
  std::vector<PlacedLight> carried_;
  std::vector<PlacedLight> local_;  // the others, less those that are dark everywhere
  gl::Program surface_program_;
  gl::Program sky_program_;
  gl::Program light_point_program_;
  gl::FogLightBuffer fog_lights_;
  MeshStore meshes_;
  std::map<std::string, MaterialTextures> materials_;
  std::vector<Draw> draws_;
  std::unique_ptr<BufferTexture> local_lights_;
  std::unique_ptr<BufferTexture> light_list_;
};

}  // namespace litfog::demo
