// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "measure/jump_watch.h"
#include "measure/lookup_bounds.h"
#include "measure/model.h"
#include "measure/night_sky.h"
#include "parallel.h"
#include "render/gpu/geometry_buffer.h"

namespace litfog::measure {
namespace {

/// The direction in which the middle of a pixel is seen; row 0 is the top one.
class PixelRays {
 public:
  PixelRays(const scene::Camera& camera, int width, int height)
      : forward_(glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.position))),
        middle_(width / 2.0, height / 2.0) {
    const double pixel = 2 * std::tan(double(camera.field_of_view) / 2) / height;
    const glm::dvec3 right = glm::normalize(glm::cross(forward_, glm::dvec3(0, 1, 0)));
    right_ = right * pixel;
    up_ = glm::cross(right, forward_) * pixel;
  }

  glm::dvec3 direction(int x, int y) const {
    return glm::normalize(forward_ + right_ * (x + 0.5 - middle_.x) + up_ * (middle_.y - y - 0.5));
  }

  /// Metres along a direction to a distance along the camera's axis.
  double length_to(double distance, const glm::dvec3& direction) const {
    return distance / glm::dot(direction, forward_);
  }

 private:
  glm::dvec3 forward_;
  glm::dvec3 right_;  // a pixel's width
  glm::dvec3 up_;
  glm::dvec2 middle_;  // pixels
};

/// A colour, the colours between which light maps leave it, and whether rounding decides on it.
struct Shade {
  glm::dvec3 color{0.0};
  glm::dvec3 least{0.0};
  glm::dvec3 most{0.0};
  bool is_at_jump = false;
};

class ReferenceShading {
 public:
  explicit ReferenceShading(const render::Renderer& renderer)
      : model_(renderer),
        jumps_(model_),
        eye_(renderer.scene().camera.position),
        fog_above_eye_(renderer.scene().fog_top - eye_.y),
        rays_(renderer.scene().camera, renderer.width(), renderer.height()) {
    if (model_.path().maps != render::LightMapSet::none) bounds_.emplace(model_, renderer.settings());
  }
  ReferenceShading(const ReferenceShading&) = delete;
  ReferenceShading& operator=(const ReferenceShading&) = delete;

  /// The mean of a pixel's samples.
  Shade pixel(std::span<const render::GeometrySample> samples, int x, int y) const {
    const glm::dvec3 direction = rays_.direction(x, y);
    Shade mean;
    for (auto sample = samples.begin(); sample != samples.end(); ++sample) {
      const auto is_same = [&](const render::GeometrySample& other) { return sample->is_of_same_fragment(other); };
      if (std::find_if(samples.begin(), sample, is_same) != sample) continue;  // shaded before
      const double weight = double(std::count_if(sample, samples.end(), is_same)) / double(samples.size());
      const Shade shade = sample->material < 0 ? sky(direction) : surface(model_.surface_point(*sample));
      mean.color += shade.color * weight;
      mean.least += shade.least * weight;
      mean.most += shade.most * weight;
      mean.is_at_jump |= shade.is_at_jump;
    }
    const glm::dvec3 airlight = mean_airlight(samples, direction);
    mean.color += airlight;
    mean.least += airlight;
    mean.most += airlight;
    return mean;
  }

 private:
  /// That of the pixel's ray to the distance of each sample: that of the surface in the middle of the pixel or, if
  /// several are seen and a surface may end before the middle, the sample's own.
  glm::dvec3 mean_airlight(std::span<const render::GeometrySample> samples, const glm::dvec3& direction) const {
    const render::GeometrySample& first = samples.front();
    const bool is_edge = !std::ranges::all_of(
        samples, [&](const render::GeometrySample& sample) { return sample.is_of_same_fragment(first); });
    if (!is_edge) return model_.airlight(direction, length_to(first, is_edge, direction));
    glm::dvec3 sum(0.0);
    for (const render::GeometrySample& sample : samples)
      sum += model_.airlight(direction, length_to(sample, is_edge, direction));
    return sum / double(samples.size());
  }

  double length_to(const render::GeometrySample& sample, bool is_edge, const glm::dvec3& direction) const {
    if (sample.material < 0) return fog_before_sky(fog_above_eye_, direction);
    if (is_edge) return rays_.length_to(render::kNearPlane / double(sample.depth), direction);
    return glm::distance(glm::dvec3(sample.position), eye_);
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
    return {.color = veil.over(color),
            .least = glm::mix(bounds.least, fog.least, veil.opacity),
            .most = glm::mix(bounds.most, fog.most, veil.opacity),
            .is_at_jump = jumps_.is_at_jump(point) || jumps_.is_at_jump(veil, point.position)};
  }

  Shade sky(const glm::dvec3& direction) const {
    const glm::dvec3 position = eye_ + direction * fog_before_sky(fog_above_eye_, direction);
    const Veil veil = model_.veil(position);
    const glm::dvec3 color = veil.over(night_sky(model_.environment(), direction));
    return {.color = color,
            .least = color,
            .most = color,
            .is_at_jump = jumps_.is_at_jump(veil, position) || jumps_.is_at_fog_horizon(fog_above_eye_, direction)};
  }

  Model model_;
  JumpWatch jumps_;
  std::optional<LookupBounds> bounds_;  // of paths with light maps
  glm::dvec3 eye_;
  double fog_above_eye_;  // metres
  PixelRays rays_;
};

void set_pixel(render::Picture& picture, std::size_t pixel, const glm::dvec3& color) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    picture.rgb[3 * pixel + channel] = float(color[glm::length_t(channel)]);
  }
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
  for (int first = 0; first < height; first += render::GeometryBuffer::kMostRows) {
    const int count = std::min(render::GeometryBuffer::kMostRows, height - first);
    const std::vector<render::GeometrySample> rows = geometry.read_rows(first, count);
    for_each_in_parallel(std::size_t(count), [&](std::size_t row) {
      for (int x = 0; x < width; ++x) {
        const std::size_t read = row * std::size_t(width) + std::size_t(x);
        const std::size_t pixel = std::size_t(first) * std::size_t(width) + read;
        const Shade shade = shading.pixel(std::span(rows).subspan(read * samples, samples), x, first + int(row));
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
