// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/program.h"

namespace litfog::render {

/// One sample of a picture as rasterised: what its fragment is shaded from, and how deep it is. World space, metres.
struct GeometrySample {
  glm::vec3 position;      ///< within the bounds of the surface drawn
  float material;          ///< its number (Renderer::materials), whole; -1 where the sky is seen
  glm::vec4 normal_texel;  ///< of the normal map (Material::normal), filtered by the GPU; [0, 1]
  glm::vec4 tangent;       ///< Vertex::tangent, interpolated
  glm::vec3 normal;        ///< interpolated from the vertices, where it is a unit vector
  float gloss;
  glm::vec3 emission;  ///< linear RGB
  float opacity;       ///< of a pane the fraction of what is behind it that it hides, else 1
  glm::vec3 albedo;    ///< linear RGB
  float depth;         ///< the sample's own, not part of the fragment: render/gpu/depth.h

  bool is_of_same_fragment(const GeometrySample& other) const;
};

/// The scene's surfaces as the GPU rasterises them: floats for each sample, which can be read back. With as many
/// samples a pixel as a Framebuffer's, the edges of surfaces cover the same samples.
class GeometryBuffer {
 public:
  /// throws gl::Unsupported where the driver has no float framebuffer of that size or fewer samples
  GeometryBuffer(int width, int height, int samples);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }
  /// Makes it the target of drawing, and empty: sky everywhere.
  void begin() const;
  /// The same for a layer, below kMaxLayers: what is drawn in a sample after `layer` others, at any depth.
  void begin_layer(int layer) const;
  /// Has to be called when all is drawn.
  void end() const;
  /// Rows of samples, the picture's top row being row 0: all of a pixel's samples, then the next pixel's.
  std::vector<GeometrySample> read_rows(int first, int count) const;

  static constexpr int kMaxRows = 64;  ///< at a time
  static constexpr int kMaxLayers = 254;

 private:
  static constexpr int kTargets = 6;  // vec4s of a GeometrySample

  int width_;
  int height_;
  int samples_;
  gl::Program sample_program_;
  gl::FramebufferName drawn_;
  gl::FramebufferName read_;
  gl::TextureName textures_[kTargets];
  gl::TextureName drawn_depth_;
  gl::RenderbufferName read_color_;   // a target's rows
  gl::VertexArrayName vertex_array_;  // of no attributes
};

}  // namespace litfog::render
