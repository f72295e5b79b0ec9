// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/contact_sheet.h"
#include "litfog/light.h"
#include "render/renderer.h"
#include "scene/scene.h"

// Shared by the papers' figures.

namespace litfog::papers {

/// A paper's sheet.
using Rows = std::vector<std::vector<drawing::SheetEntry>>;

constexpr double kDegree = std::numbers::pi / 180;

render::RenderSettings along(std::string_view path, render::RenderSettings settings = {});

/// Draws the figures of a sheet, all of one size.
class FigurePainter {
 public:
  FigurePainter(int width, int height, int frames) : width_(width), height_(height), frames_(frames) {}

  drawing::SheetEntry draw(const scene::Scene& scene, const render::RenderSettings& render,
                           std::vector<std::string> caption) const;
  drawing::SheetEntry draw(render::Renderer& renderer, std::vector<std::string> caption) const;
  std::unique_ptr<render::Renderer> renderer(const scene::Scene& scene, const render::RenderSettings& render) const;
  /// A sheet entry for a renderer's picture.
  static drawing::SheetEntry entry(const render::Picture& picture, std::vector<std::string> caption);
  int frames() const { return frames_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_, height_, frames_;
};

/// The renderers' frame times over the first one's, frames interleaved.
std::vector<double> relative_times(const std::vector<std::unique_ptr<render::Renderer>>& renderers, int frames);

/// A wall of one material facing +Z at z = 0, cells.x by cells.y cells, six metres wide and four high.
scene::Scene wall(const glm::ivec2& cells, const std::string& material);

PlacedLight lamp(const glm::dvec3& position, const Attenuation& attenuation, const Cone& cone = {});

/// The material of the figures' objects.
struct Finish {
  glm::vec3 ambient{0.0f};  ///< Ka; globalAmbient is 1 if this is not 0
  glm::vec3 diffuse{0.0f};
  glm::vec3 specular{0.0f};
  float shininess = 1;
  glm::vec3 emissive{0.0f};
};

/// A mesh in white light from the upper left, in front of the camera.
scene::Scene figure(scene::Mesh mesh, const Finish& finish);

Rows hales_figures(const FigurePainter& painter);
Rows lacroix_figures(const FigurePainter& painter);
Rows cg_figures(const FigurePainter& painter);
Rows frazier_figures(const FigurePainter& painter);

}  // namespace litfog::papers
