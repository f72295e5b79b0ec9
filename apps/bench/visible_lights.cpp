// SPDX-License-Identifier: Apache-2.0
#include "bench/visible_lights.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>

#include "measure/path_model.h"
#include "render/gpu/depth.h"
#include "render/gpu/geometry_buffer.h"
#include "render/light/hidden_range.h"
#include "render/light/point_list.h"
#include "render/plan/view.h"

namespace litfog::bench {
namespace {

/// The largest contribution of each light to any pixel tried, in steps of the display.
std::vector<double> largest_contributions(render::Renderer& renderer) {
  const measure::PathModel model(renderer);
  const std::vector<measure::ReferenceLight>& lights = model.lights();
  const double step = render::visible_step(0);
  const render::GeometryBuffer geometry(renderer.width(), renderer.height(), renderer.samples());
  renderer.draw_geometry(geometry);
  std::vector<double> most(lights.size(), 0.0);
  for (int y = 0; y < renderer.height(); ++y) {
    const std::vector<render::GeometrySample> row = geometry.read_rows(y, 1);
    for (std::size_t s = 0; s < row.size(); ++s) {
      const render::GeometrySample& sample = row[s];
      const bool is_sky = sample.material < 0;
      if (is_sky || (s > 0 && sample.is_of_same_fragment(row[s - 1]))) continue;
      const measure::SurfacePoint point = model.surface_point(sample);
      const Fog fog = model.atmosphere().fog_between(point.position.y, model.eye().y);
      const double through = fog_factor_at(fog, glm::distance(point.position, model.eye())) / step;
      for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto ray = measure::ray_within(lights[i].extent, lights[i], point.position);
        if (!ray) continue;
        const double light =
            lights[i].emitted(ray->direction) * model.falloff(lights[i], point.position.y, ray->range) * through;
        if (!(light > 0)) continue;
        const glm::dvec3 seen = lights[i].placed.light.color * model.reflectance(point, -ray->direction);
        most[i] = std::max(most[i], light * render::largest_component(seen));
      }
    }
  }
  return most;
}

/// Indices in the scene's lights.
std::vector<std::size_t> lights_with_points(const render::Renderer& renderer) {
  const render::SceneLights lights(renderer.scene(), renderer.settings());
  const scene::Camera camera = relative_to(lights.origin(), renderer.scene().camera);
  const double aspect = double(renderer.width()) / renderer.height();
  const glm::mat4 clip_from_world = render::clip_from_view(camera, aspect) * scene::view_from_world<float>(camera);
  const render::PointList points =
      render::list_points(lights, renderer.atmosphere().seen_from(lights.origin().y), renderer.settings().fog_lighting,
                          {.eye = camera.position,
                           .forward = axes_of(camera).forward,
                           .frustum = render::make_frustum(clip_from_world),
                           .pixels_per_radian = render::pixels_per_radian(camera, renderer.height()),
                           .height = renderer.height()},
                          render::kPointShare * render::visible_step(0));
  std::vector<std::size_t> found;
  for (const std::int32_t point : points.lights) found.push_back(lights.scene_light(std::size_t(point)));
  return found;
}

}  // namespace

std::vector<std::size_t> find_visible_lights(render::Renderer& renderer) {
  std::vector<double> most = largest_contributions(renderer);
  constexpr double kNeeded = std::numeric_limits<double>::infinity();
  for (const std::size_t light : lights_with_points(renderer)) most[light] = kNeeded;
  for (std::size_t i = 0; i < most.size(); ++i) {
    if (renderer.scene().lights[i].carried) most[i] = kNeeded;
  }
  std::vector<std::size_t> lights(most.size());
  std::iota(lights.begin(), lights.end(), 0);
  std::ranges::sort(lights, {}, [&](std::size_t i) { return most[i]; });
  constexpr double kMaxLeftOut = 0.5;
  double left_out = 0;
  const auto first = std::ranges::find_if(lights, [&](std::size_t i) { return (left_out += most[i]) > kMaxLeftOut; });
  lights.erase(lights.begin(), first);
  std::ranges::sort(lights);
  return lights;
}

}  // namespace litfog::bench
