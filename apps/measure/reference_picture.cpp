// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "measure/night_sky.h"
#include "measure/path_model.h"
#include "measure/pixel_rays.h"
#include "model/parallel.h"
#include "render/gpu/geometry_buffer.h"

namespace litfog::measure {
namespace {

/// A colour, its range by light maps, and whether rounding decides on it.
struct Shade {
  glm::dvec3 color{0.0};
  glm::dvec3 least{0.0};
  glm::dvec3 most{0.0};
  bool is_at_jump = false;
};

using Samples = std::span<const render::GeometrySample>;  // one pixel's

class ReferenceShading {
 public:
  explicit ReferenceShading(const render::Renderer& renderer)
      : model_(renderer),
        jumps_(model_),
        eye_(model_.eye()),
        fog_above_eye_(model_.atmosphere().top_above(model_.eye().y)),
        rays_(renderer.scene().camera, renderer.width(), renderer.height()) {
    if (model_.path().maps != render::LightMapSet::none) bounds_.emplace(model_, renderer.settings().papers);
  }
  ReferenceShading(const ReferenceShading&) = delete;
  ReferenceShading& operator=(const ReferenceShading&) = delete;

  /// The mean of a pixel's samples.
  ///
  /// samples  surfaces or sky behind all panes
  /// panes    layers of panes before and behind each sample, in any order; material -1: none
  Shade pixel(Samples samples, std::span<const Samples> panes, int x, int y) const {
    const glm::dvec3 direction = rays_.direction(x, y);
    Shade mean;
    std::vector<double> seen(samples.size(), 1);  // visible fraction of each sample
    if (panes.empty()) {
      add(samples, seen, direction, mean);
      return mean;
    }
    for (std::size_t i = 0; i < panes.size(); ++i) {
      std::vector<double> pane_seen(samples.size(), 0);
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const render::GeometrySample& pane = panes[i][k];
        if (pane.material < 0 || pane.depth < samples[k].depth) continue;
        pane_seen[k] = double(pane.opacity);
        for (std::size_t j = 0; j < panes.size(); ++j) {  // at equal depth the last pane drawn is in front
          const render::GeometrySample& other = panes[j][k];
          const bool is_before = other.depth > pane.depth || (other.depth == pane.depth && j > i);
          if (other.material >= 0 && is_before) pane_seen[k] *= 1 - double(other.opacity);
        }
        seen[k] *= 1 - double(pane.opacity);
      }
      add(panes[i], pane_seen, direction, mean);
    }
    add(samples, seen, direction, mean);
    return mean;
  }

 private:
  /// Adds the visible fraction of a pixel's samples to the pixel's mean.
  void add(Samples samples, std::span<const double> seen, const glm::dvec3& direction, Shade& mean) const {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const render::GeometrySample& sample = samples[i];
      const auto is_same = [&](const render::GeometrySample& other) { return sample.is_of_same_fragment(other); };
      const auto own = samples.begin() + std::ptrdiff_t(i);
      if (std::find_if(samples.begin(), own, is_same) != own) continue;  // shaded before
      double weight = 0;
      for (std::size_t k = i; k < samples.size(); ++k) weight += is_same(samples[k]) ? seen[k] : 0;
      if (weight == 0) continue;
      weight /= double(samples.size());
      const Shade shade = sample.material < 0 ? sky(direction) : surface(model_.surface_point(sample));
      mean.color += shade.color * weight;
      mean.least += shade.least * weight;
      mean.most += shade.most * weight;
      mean.is_at_jump |= shade.is_at_jump;
    }
    const glm::dvec3 airlight = mean_airlight(samples, seen, direction);
    mean.color += airlight;
    mean.least += airlight;
    mean.most += airlight;
  }

  /// The mean airlight along the pixel's ray up to the distance of each sample.
  glm::dvec3 mean_airlight(Samples samples, std::span<const double> seen, const glm::dvec3& direction) const {
    std::map<double, double> seen_up_to;  // samples of the sky have one length
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (seen[i] > 0) seen_up_to[length_to(samples[i], direction)] += seen[i];
    }
    glm::dvec3 sum(0.0);
    for (const auto& [length, weight] : seen_up_to) sum += model_.airlight(direction, length) * weight;
    return sum / double(samples.size());
  }

  double length_to(const render::GeometrySample& sample, const glm::dvec3& direction) const {
    if (sample.material < 0) return fog_before_sky(fog_above_eye_, direction);
    return rays_.length_to(sample, direction);
  }

  Shade surface(const SurfacePoint& point) const {
    const Veil veil = model_.veil(point.position);
    const glm::dvec3 color = model_.surface_color(point);
    LookupBounds::Interval bounds{color, color};
    LookupBounds::Interval fog{veil.color, veil.color};
    if (bounds_) {
      bounds = bounds_->surface_color(point);
      if (model_.path().has_mapped_fog()) fog = bounds_->fog_color(point.position);
    }
    const glm::dvec3 moonlight = model_.moon_airlight(point.position);
    return {.color = veil.over(color) + moonlight,
            .least = glm::mix(bounds.least, fog.least, veil.opacity) + moonlight,
            .most = glm::mix(bounds.most, fog.most, veil.opacity) + moonlight,
            .is_at_jump = jumps_.is_at_jump(point) || jumps_.is_at_jump(veil, point.position)};
  }

  Shade sky(const glm::dvec3& direction) const {
    const double range = fog_before_sky(fog_above_eye_, direction);
    const glm::dvec3 position = eye_ + direction * range;
    const Veil veil = model_.veil(position);
    const glm::dvec3 color =
        veil.over(night_sky(model_.environment(), direction)) + model_.moon_airlight_before_sky(direction, range);
    return {.color = color,
            .least = color,
            .most = color,
            .is_at_jump = jumps_.is_at_jump(veil, position) || jumps_.is_at_fog_horizon(fog_above_eye_, direction)};
  }

  PathModel model_;
  JumpWatch jumps_;
  std::optional<LookupBounds> bounds_;  // for paths with light maps
  glm::dvec3 eye_;
  double fog_above_eye_;  // metres
  PixelRays rays_;
};

void set_pixel(render::Picture& picture, std::size_t pixel, const glm::dvec3& color) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    picture.rgb[3 * pixel + channel] = float(color[glm::length_t(channel)]);
  }
}

/// Reads the layers of a renderer's panes in some rows, up to the first empty layer.
std::vector<std::vector<render::GeometrySample>> read_panes(render::Renderer& renderer,
                                                            const render::GeometryBuffer& geometry, int first,
                                                            int count) {
  std::vector<std::vector<render::GeometrySample>> layers;
  while (int(layers.size()) < render::GeometryBuffer::kMaxLayers) {
    renderer.draw_pane_geometry(geometry, int(layers.size()));
    std::vector<render::GeometrySample> rows = geometry.read_rows(first, count);
    if (std::ranges::all_of(rows, [](const render::GeometrySample& sample) { return sample.material < 0; })) break;
    layers.push_back(std::move(rows));
  }
  return layers;
}

}  // namespace

ReferencePicture shade_reference(render::Renderer& renderer, const Progress& progress) {
  const int width = renderer.width();
  const int height = renderer.height();
  const render::GeometryBuffer geometry(width, height, renderer.samples());
  renderer.draw_geometry(geometry);
  const ReferenceShading shading(renderer);
  const auto samples = std::size_t(geometry.samples());
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  const render::Picture empty{width, height, std::vector<float>(3 * pixels)};
  ReferencePicture reference{empty, empty, empty, std::vector<std::uint8_t>(pixels)};
  for (int first = 0; first < height; first += render::GeometryBuffer::kMaxRows) {
    const int count = std::min(render::GeometryBuffer::kMaxRows, height - first);
    std::vector<std::vector<render::GeometrySample>> pane_rows;
    if (renderer.has_panes()) {  // drawn into the same buffer
      pane_rows = read_panes(renderer, geometry, first, count);
      renderer.draw_geometry(geometry);
    }
    const std::vector<render::GeometrySample> rows = geometry.read_rows(first, count);
    for_each_in_parallel(std::size_t(count), [&](std::size_t row) {
      for (int x = 0; x < width; ++x) {
        const std::size_t read = row * std::size_t(width) + std::size_t(x);
        const std::size_t pixel = std::size_t(first) * std::size_t(width) + read;
        std::vector<Samples> panes;
        for (const auto& layer : pane_rows) panes.push_back(std::span(layer).subspan(read * samples, samples));
        const Shade shade = shading.pixel(std::span(rows).subspan(read * samples, samples), panes, x, first + int(row));
        set_pixel(reference.picture, pixel, shade.color);
        set_pixel(reference.least, pixel, shade.least);
        set_pixel(reference.most, pixel, shade.most);
        reference.is_at_jump[pixel] = shade.is_at_jump;
      }
    });
    if (progress) progress(fmt::format("shading the reference: {:.0f} %", 100.0 * (first + count) / height));
  }
  return reference;
}

}  // namespace litfog::measure
