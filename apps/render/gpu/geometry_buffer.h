// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"

namespace litfog::render {

/// One rasterised sample of a picture: the shading inputs of its fragment, and its depth. World space, metres.
struct GeometrySample {
  glm::vec3 position;      ///< within the bounds of the surface drawn
  float material;          ///< index in Renderer::materials(); -1: sky
  glm::vec4 normal_texel;  ///< normal map (Material::normal) as filtered by the GPU; [0, 1]
  glm::vec4 tangent;       ///< Vertex::tangent, interpolated
  glm::vec3 normal;        ///< interpolated from the vertices' unit normals
  float gloss;
  glm::vec3 emission;  ///< linear RGB
  float opacity;       ///< fraction of the background that a pane hides; 1: no pane
  glm::vec3 albedo;    ///< linear RGB
  float depth;         ///< the sample's own (render/gpu/depth.h), not the fragment's

  bool is_of_same_fragment(const GeometrySample& other) const;
};

/// The scene's surfaces as the GPU rasterises them: floats for each sample, which can be read back. With as many
/// samples a pixel as a Framebuffer, surfaces cover the same samples in both.
class GeometryBuffer {
 public:
  /// throws gl::Unsupported where the driver has no float framebuffer of that size or fewer samples
  GeometryBuffer(int width, int height, int samples);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }
  /// Makes this the target of drawing and clears it: sky everywhere.
  void begin() const;
  /// Begins a layer, below kMaxLayers. Each sample keeps the fragment that is drawn after `layer` others, at any depth.
  void begin_layer(int layer) const;
  /// Must be called after drawing.
  void end() const;
  /// Rows of samples, from the picture's top row 0: all samples of a pixel, then of the next pixel.
  std::vector<GeometrySample> read_rows(int first, int count) const;

  static constexpr int kMaxRows = 64;  ///< largest count of read_rows()
  static constexpr int kMaxLayers = 254;

 private:
  static constexpr int kTargets = 6;  // a GeometrySample is this many vec4s

  int width_;
  int height_;
  int samples_;
  gl::Program sample_program_;
  gl::FramebufferName drawn_;
  gl::FramebufferName read_;
  gl::TextureName textures_[kTargets];
  gl::TextureName drawn_depth_;
  gl::RenderbufferName read_color_;   // rows of one target
  gl::VertexArrayName vertex_array_;  // without attributes
};

}  // namespace litfog::render
