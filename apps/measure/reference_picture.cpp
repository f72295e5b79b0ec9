// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <optional>
#include <span>
#include <system_error>
#include <thread>

#include "measure/jump_watch.h"
#include "measure/lookup_bounds.h"
#include "measure/model.h"
#include "measure/night_sky.h"
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

  /// Metres along a direction that are as far along the camera's axis as an offset from the eye.
  double length_to(const glm::dvec3& offset, const glm::dvec3& direction) const {
    return glm::dot(offset, forward_) / glm::dot(direction, forward_);
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
    if (model_.path().maps != render::LightMapSet::none) bounds_.emplace(model_, renderer.settings().map_size);
  }
  ReferenceShading(const ReferenceShading&) = delete;
  ReferenceShading& operator=(const ReferenceShading&) = delete;

  /// The mean of a pixel's samples.
  Shade pixel(std::span<const render::GeometrySample> samples, int x, int y) const {
    Shade mean;
    for (auto sample = samples.begin(); sample != samples.end(); ++sample) {
      if (std::find(samples.begin(), sample, *sample) != sample) continue;  // shaded before
      const double weight = double(std::count(sample, samples.end(), *sample)) / double(samples.size());
      const Shade shade =
          sample->material < 0 ? sky(x, y) : surface(model_.surface_point(*sample), rays_.direction(x, y));
      mean.color += shade.color * weight;
      mean.least += shade.least * weight;
      mean.most += shade.most * weight;
      mean.is_at_jump |= shade.is_at_jump;
    }
    return mean;
  }

 private:
  /// direction  of the pixel's ray, on which the airlight reaches to the point's distance along the camera's axis: the
  ///            sample's own ray may be another, because at an edge a surface's attributes are kept within its bounds
  Shade surface(const SurfacePoint& point, const glm::dvec3& direction) const {
    const Veil veil = model_.veil(point.position);
    const glm::dvec3 color = model_.surface_color(point);
    const LookupBounds::Interval bounds =
        bounds_ ? bounds_->surface_color(point) : LookupBounds::Interval{color, color};
    const glm::dvec3 airlight = model_.airlight(direction, rays_.length_to(point.position - eye_, direction));
    return {.color = veil.over(color) + airlight,
            .least = veil.over(bounds.least) + airlight,
            .most = veil.over(bounds.most) + airlight,
            .is_at_jump = jumps_.is_at_jump(point) || jumps_.is_at_jump(veil, point.position)};
  }

  Shade sky(int x, int y) const {
    const glm::dvec3 direction = rays_.direction(x, y);
    const double length = fog_before_sky(fog_above_eye_, direction);
    const glm::dvec3 position = eye_ + direction * length;
    const Veil veil = model_.veil(position);
    const glm::dvec3 color = veil.over(night_sky(model_.environment(), direction)) + model_.airlight(direction, length);
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

/// Calls work(i) for i in [0, count) on all cores.
template <typename Work>
void for_each_in_parallel(int count, const Work& work) {
  std::atomic<int> next = 0;
  const auto run = [&] {
    for (int i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> others;
  try {
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) {
      others.push_back(std::async(std::launch::async, run));
    }
  } catch (const std::system_error&) {  // no more threads: those that have started, and this one, do all
  }
  run();
  for (std::future<void>& other : others) other.get();
}

void set_pixel(render::Picture& picture, std::size_t pixel, const glm::dvec3& color) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    picture.rgb[3 * pixel + channel] = float(color[glm::length_t(channel)]);
  }
}

}  // namespace

ReferencePicture shade_reference(render::Renderer& renderer, const Progress& progress) {
  const int width = renderer.width();
  const int height = renderer.height();
  const render::GeometryBuffer geometry(width, height);
  renderer.draw_geometry(geometry);
  const ReferenceShading shading(renderer);
  const auto samples = std::size_t(geometry.samples());
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  const render::Picture empty{width, height, std::vector<float>(3 * pixels)};
  ReferencePicture reference{empty, empty, empty, std::vector<std::uint8_t>(pixels)};
  for (int first = 0; first < height; first += render::GeometryBuffer::kMostRows) {
    const int count = std::min(render::GeometryBuffer::kMostRows, height - first);
    const std::vector<render::GeometrySample> rows = geometry.read_rows(first, count);
    for_each_in_parallel(count, [&](int row) {
      for (int x = 0; x < width; ++x) {
        const std::size_t read = std::size_t(row) * std::size_t(width) + std::size_t(x);
        const std::size_t pixel = std::size_t(first) * std::size_t(width) + read;
        const Shade shade = shading.pixel(std::span(rows).subspan(read * samples, samples), x, first + row);
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
