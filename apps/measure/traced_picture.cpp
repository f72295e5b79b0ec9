// SPDX-License-Identifier: Apache-2.0
#include "measure/traced_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "litfog/color_temperature.h"
#include "litfog/multiple_scattering.h"
#include "measure/night_sky.h"
#include "measure/path_model.h"
#include "measure/pixel_rays.h"
#include "measure/scattering_walk.h"
#include "measure/triangle_tree.h"
#include "model/parallel.h"
#include "render/gpu/geometry_buffer.h"
#include "render/shadow/shadow_caster.h"
#include "scene/hash_random.h"
#include "scene/srgb.h"

namespace litfog::measure {
namespace {

/// The mean of a picture's linear colours, weighted by coverage if it is a mask.
glm::dvec3 mean_color(const scene::Texels& texels, bool is_mask) {
  glm::dvec3 sum(0.0);
  double weights = 0;
  for (std::size_t i = 0; i + 3 < texels.rgba.size(); i += 4) {
    const auto linear = [&](std::size_t k) { return double(scene::linear_from_srgb(float(texels.rgba[i + k]) / 255)); };
    const double weight = is_mask ? texels.rgba[i + 3] / 255.0 : 1;
    sum += weight * glm::dvec3(linear(0), linear(1), linear(2));
    weights += weight;
  }
  return weights > 0 ? sum / weights : sum;
}

/// A material's reflectance, averaged over its pictures, as luminance.
double mean_albedo(const scene::Material& material) {
  if (material.is_unlit) return 0;
  const glm::dvec3 base = material.plain_albedo ? glm::dvec3(*material.plain_albedo)
                                                : mean_color(*material.albedo, material.least_coverage.has_value());
  return luminance(material.second ? base * mean_color(*material.second, false) : base);
}

class SceneSurfaces : public Surroundings {
 public:
  explicit SceneSurfaces(const render::Renderer& renderer) : triangles_(renderer.scene(), renderer.origin()) {
    for (const scene::Material& material : renderer.scene().materials) albedos_.push_back(mean_albedo(material));
    albedos_.push_back(0);  // of parts without a material
  }

  std::optional<Hit> nearest(const glm::dvec3& origin, const glm::dvec3& direction) const override {
    const auto hit = triangles_.nearest(origin, direction, kOffSurface, std::numeric_limits<double>::infinity());
    if (!hit) return std::nullopt;
    const double side = glm::dot(hit->normal, direction) < 0 ? 1 : -1;
    return Hit{hit->distance, side * hit->normal, albedos_[hit->material]};
  }
  bool is_hidden(const glm::dvec3& lamp, const glm::dvec3& position, bool is_on_surface) const override {
    const glm::dvec3 from_lamp = position - lamp;
    const double range = glm::length(from_lamp);
    if (range < render::kLampRadius) return is_on_surface;  // its housing
    return triangles_.is_met(lamp, from_lamp / range, render::kLampRadius, range - kOffSurface * (1 + range));
  }

 private:
  static constexpr double kOffSurface = 1e-4;  // metres, or of the range: no ray meets the surface on which it begins
  TriangleTree triangles_;
  std::vector<double> albedos_;  // by material
};

/// Where paths may begin, and to which lamp they lead.
struct PathKind {
  std::size_t lamp;
  bool is_reflected;  // begins on the surface that the eye sees, not in the fog
  double expected;    // luminance
};

constexpr double kEvenFraction = 0.1;  // of paths drawn evenly from all kinds: formulas may expect far too little

class Tracer {
 public:
  Tracer(const render::Renderer& renderer, const Tracing& tracing)
      : model_(renderer),
        rays_(renderer.scene().camera, renderer.width(), renderer.height()),
        surfaces_(renderer),
        table_(make_scattering_table(model_.atmosphere())),
        tracing_(tracing) {
    for (const ReferenceLight& light : model_.lights()) {
      walks_.emplace_back(light.placed, model_.atmosphere(), model_.eye(), &surfaces_);
    }
  }

  /// The mean of some paths of a sample, numbered from the first on.
  glm::dvec3 trace(const render::GeometrySample& sample, int x, int y, std::uint64_t first, int count) const {
    const glm::dvec3 direction = rays_.direction(x, y);
    std::optional<SurfacePoint> point;
    EyeRay ray{.origin = model_.eye(), .direction = direction};
    if (sample.material < 0) {
      ray.length = fog_before_sky(model_.atmosphere().top_above(ray.origin.y), direction);
    } else {
      point = model_.surface_point(sample);
      ray.length = rays_.length_to(sample, direction);
    }
    const double unit = airlight_unit(model_.atmosphere());
    const double seen = point ? 1 - model_.opacity_before(point->position) : 0;
    const std::vector<PathKind> kinds = expected_kinds(ray, point, seen, unit);
    glm::dvec3 light(0.0);
    double all = 0, before = 0;
    for (const PathKind& kind : kinds) all += kind.expected;
    // Systematic sampling: equal steps through the kinds' expectations, from a random offset on.
    const double offset =
        double(scene::HashRandom(scene::hash(std::uint32_t(first), std::uint32_t(first >> 32), tracing_.seed)).unit());
    int path = 0;
    for (const PathKind& kind : kinds) {
      before += kind.expected;
      for (; path < count && (path + offset) * all < before * count; ++path) {
        const std::uint64_t number = first + std::uint64_t(path);
        const glm::dvec3 scale = unit * all / (kind.expected * count) * model_.lights()[kind.lamp].placed.light.color;
        light += kind.is_reflected
                     ? scale * seen * point->diffuse *
                           walks_[kind.lamp].reflected(point->position, point->normal, tracing_.seed, number)
                     : scale * walks_[kind.lamp].scattered(ray, tracing_.seed, number);
      }
    }
    return light;
  }

 private:
  std::vector<PathKind> expected_kinds(const EyeRay& ray, const std::optional<SurfacePoint>& point, double seen,
                                       double unit) const {
    std::vector<PathKind> kinds;
    double sum = 0;
    const auto add = [&](std::size_t lamp, bool is_reflected, double light) {
      kinds.push_back({lamp, is_reflected, light * luminance(model_.lights()[lamp].placed.light.color)});
      sum += kinds.back().expected;
    };
    for (std::size_t i = 0; i < walks_.size(); ++i) {
      const ReferenceLight& lamp = model_.lights()[i];
      add(i, false, unit * multiple_scattering(lamp.placed, lamp.source, model_.atmosphere(), table_, ray));
      if (!point) continue;
      const DiffuseLight falling = scattered_light(lamp.placed, lamp.source, model_.atmosphere(), point->position);
      add(i, true, seen * luminance(point->diffuse) * irradiance(falling, point->normal));
    }
    if (!(sum > 0)) return {};
    for (PathKind& kind : kinds) {
      kind.expected = std::lerp(kind.expected, sum / double(kinds.size()), kEvenFraction);
    }
    return kinds;
  }

  PathModel model_;
  PixelRays rays_;
  SceneSurfaces surfaces_;
  ScatteringTable table_;
  Tracing tracing_;
  std::vector<ScatteringPaths> walks_;  // by light
};

}  // namespace

render::Picture trace_higher_orders(render::Renderer& renderer, const Tracing& tracing, const Progress& progress) {
  if (tracing.paths < 1) throw std::invalid_argument(fmt::format("paths = {}: must be at least 1", tracing.paths));
  if (!renderer.scene().cookie_uses.empty()) throw std::invalid_argument("scene: must have no lamps with cookies");
  const render::RenderSettings& settings = renderer.settings();
  if (settings.fog_lighting != render::FogLighting::airlight || settings.scattering != render::Scattering::all) {
    throw std::invalid_argument("settings: must light fog by airlight, in all orders of scattering");
  }
  const Tracer tracer(renderer, tracing);
  const int width = renderer.width(), height = renderer.height();
  const render::GeometryBuffer geometry(width, height, renderer.samples());
  renderer.draw_geometry(geometry);
  const auto samples = std::size_t(geometry.samples());
  const int paths = (tracing.paths + int(samples) - 1) / int(samples);  // of a sample
  render::Picture picture{width, height, std::vector<float>(3 * std::size_t(width) * std::size_t(height))};
  for (int y = 0; y < height; ++y) {
    const std::vector<render::GeometrySample> row = geometry.read_rows(y, 1);
    for_each_in_parallel(std::size_t(width), [&](std::size_t x) {
      const std::size_t index = std::size_t(y) * std::size_t(width) + x;
      glm::dvec3 light(0.0);
      for (std::size_t k = 0; k < samples; ++k) {
        const std::uint64_t first = (index * samples + k) * std::uint64_t(paths);
        light += tracer.trace(row[x * samples + k], int(x), y, first, paths) / double(samples);
      }
      for (std::size_t k = 0; k < 3; ++k) picture.rgb[3 * index + k] = float(light[glm::length_t(k)]);
    });
    if (progress) progress(fmt::format("tracing paths: {:.0f} %", 100.0 * (y + 1) / height));
  }
  return picture;
}

}  // namespace litfog::measure
