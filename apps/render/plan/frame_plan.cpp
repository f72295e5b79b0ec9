// SPDX-License-Identifier: Apache-2.0
#include "render/plan/frame_plan.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <numbers>
#include <numeric>

#include "litfog/airlight.h"
#include "litfog/color_temperature.h"
#include "litfog/cone.h"
#include "litfog/visual_threshold.h"
#include "render/airlight/airlight_bound.h"
#include "render/light/hidden_range.h"
#include "render/plan/fog_top.h"
#include "render/surface/shader_variant.h"

namespace litfog::render {
namespace {

/// Largest y of the unit directions from the eye to a box.
double highest_slope(const glm::dvec3& eye, const scene::Bounds& box, double nearest, double farthest) {
  const double rise = double(box.high.y) - eye.y;
  return rise > 0 ? (rise < nearest ? rise / nearest : 1) : rise / farthest;
}

/// Largest y of the unit directions in which rays to the sky cross at least `range` of fog (shaders/fog_top.glsl).
double slope_in_fog(double fog_above_eye, double range) {
  constexpr double kRounding = 1e-4;
  if (range > kSkyDistance) return -2;  // no ray does
  if (!(fog_above_eye > 0)) return -kRounding;
  return fog_above_eye * (1 - kRounding) / range;
}

}  // namespace

FramePlanner::FramePlanner(const scene::Scene& scene, const SceneLights& lights, const SurfaceList& surfaces,
                           const RenderSettings& settings)
    : scene_(scene), lights_(lights), surfaces_(surfaces), settings_(settings) {}

void FramePlanner::set_atmosphere(const Atmosphere& atmosphere, bool is_fog_lit,
                                  std::span<const std::int32_t> shaft_casters) {
  atmosphere_ = atmosphere;
  is_fog_lit_ = is_fog_lit;
  shaft_casters_ = shaft_casters;
  fog_states_.resize(surfaces_.surfaces().size());
  strengths_.resize(surfaces_.lists().size());
  plan_.higher_orders = settings_.scattering == Scattering::all && !find_scattering_error(atmosphere_)
                            ? HigherOrders(lights_, scene_.cookies, atmosphere_, plan_.higher_orders)
                            : HigherOrders();
  scattered_bound_ = has_scattered_light(settings_) && plan_.higher_orders.table
                         ? ScatteredLightBound(lights_, plan_.higher_orders, atmosphere_.thickest_fog().density)
                         : ScatteredLightBound();
  forget();
}

const FramePlan& FramePlanner::plan(const FrameView& view) {
  const bool is_new_environment = environment_ != scene_.environment;
  has_changed_ = view_ != view || is_new_environment;
  if (!has_changed_) return plan_;
  // set_atmosphere() resets the view.
  if (!view_ || view_->exposures.surfaces != view.exposures.surfaces || is_new_environment) {
    step_ = visible_step(view.exposures.surfaces);
    ++fog_number_;
  }
  view_ = view;
  environment_ = scene_.environment;
  make_plan(view);
  return plan_;
}

FramePlan FramePlanner::plan_geometry(const glm::mat4& clip_from_world) const {
  FramePlan plan;
  const Frustum frustum = make_frustum(clip_from_world);
  for (const Surface& surface : surfaces_.surfaces()) {
    if (settings_.path_skipping() == Skipping::off || can_see(frustum, surface.bounds)) {
      plan.surfaces.push_back({&surface, false, 0, 0});
    }
  }
  return plan;
}

double FramePlanner::sky_brightness() const {
  const scene::Environment& environment = scene_.environment;
  const double moon = environment.has_moon() ? 1.05 : 0;  // shaders/night_sky.glsl
  return std::max(largest_component(environment.sky_zenith), largest_component(environment.sky_horizon)) +
         double(environment.star_brightness) + moon;
}

double FramePlanner::moonlight_in_fog() const {
  if (!is_fog_moonlit(scene_.environment, atmosphere_, settings_.fog_lighting)) return 0;
  return airlight_unit(atmosphere_) * largest_phase(atmosphere_.phase) *
         largest_component(scene_.environment.moon_color);
}

double FramePlanner::least_seen() const {
  if (!settings_.has_eye_threshold) return 0;
  const double background = luminance(atmosphere_.ambient_fog_color);
  return illuminance_threshold(background * kWhiteLux / std::numbers::pi) / kWhiteLux;
}

double FramePlanner::airlight_end_from(const glm::dvec3& eye, double budget) const {
  if (settings_.fog_lighting != FogLighting::airlight) return 0;
  const ScatteringBound scattering(atmosphere_.phase);
  double end = 0;
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    const AirlightBound bound(lights_.lights()[i], lights_.extents()[i], atmosphere_, scattering, eye);
    end = std::max(end, bound.end(budget / double(lights_.size())));
  }
  return std::max(end, plan_.far_airlights.depth);
}

double FramePlanner::brightness_of(std::size_t index) {
  SurfaceFogState& state = fog_states_[index];
  if (state.fog_number == fog_number_) return double(state.brightness);
  const Surface& surface = surfaces_.surfaces()[index];
  double brightness = surface.material->own_light(scene_.environment) +
                      surface.material->reflectance * scattered_bound_.largest_irradiance(surface.bounds);
  const std::span<const std::int32_t> lights = surfaces_.lights_of(surface);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto light = std::size_t(lights[i]);
    const PlacedLight& placed = lights_.lights()[light];
    const double strength =
        surface.material->reflectance * largest_component(placed.light.color) *
        largest_irradiance(placed.light, placed.position, surfaces_.range_of(lights_.extents()[light]),
                           fog_before(placed.position.y, surface.bounds), settings_.fog_lighting, *settings_.path,
                           surface.bounds);
    strengths_[std::size_t(surface.list_first) + i] = float(strength);
    brightness += strength;
  }
  state = {fog_number_, float(brightness)};
  return double(state.brightness);
}

Fog FramePlanner::fog_before(double height, const scene::Bounds& box) const {
  return atmosphere_.thinnest_fog_between(height, double(box.low.y), double(box.high.y));
}

PlannedSurface FramePlanner::list_lights(std::size_t index, double most_left_out) {
  const Surface& surface = surfaces_.surfaces()[index];
  const std::span<const std::int32_t> lights = surfaces_.lights_of(surface);
  const std::span<const float> strengths =
      std::span(strengths_).subspan(std::size_t(surface.list_first), lights.size());
  sorted_.clear();  // the strengths of lights that may be left out
  std::ranges::copy_if(strengths, std::back_inserter(sorted_),
                       [&](float strength) { return double(strength) <= most_left_out; });
  std::ranges::sort(sorted_);
  double sum = 0;
  const auto kept = std::ranges::find_if(sorted_, [&](float strength) { return (sum += strength) > most_left_out; });
  const double least = kept == sorted_.end() ? most_left_out : *kept;
  PlannedSurface planned{&surface, false, int(plan_.light_list.size()), 0};
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (double(strengths[i]) < least) continue;
    plan_.light_list.push_back(lights[i]);
    ++planned.list_count;
  }
  plan_.counts.lights_listed += std::size_t(planned.list_count);
  plan_.counts.lights_hidden += lights.size() - std::size_t(planned.list_count);
  plan_.counts.lights_out_of_reach += lights_.size() - lights.size();
  return planned;
}

void FramePlanner::make_plan(const FrameView& view) {
  plan_.surfaces.clear();
  plan_.counts = {};
  plan_.light_list.resize(lights_.size() - lights_.local_count());
  std::iota(plan_.light_list.begin(), plan_.light_list.end(), std::int32_t(lights_.local_count()));
  if (settings_.fog_lighting == FogLighting::airlight) plan_airlight(view);
  if (settings_.path_skipping() == Skipping::on) {
    plan_visible(view);
  } else {
    plan_everything();
  }
  if (settings_.papers.early_rejection == EarlyRejection::front_to_back) {
    std::ranges::stable_sort(plan_.surfaces, {}, [&](const PlannedSurface& planned) {
      return nearest_distance(view.camera.position, planned.surface->bounds);
    });
  }
}

void FramePlanner::plan_airlight(const FrameView& view) {
  const double exposure = view.exposures.airlight;
  const bool beyond_extents = lights_fog_beyond_end(settings_);
  plan_.airlights = list_airlight(lights_, atmosphere_, view.camera.position, view.pixels_per_radian, exposure,
                                  plan_.higher_orders, shaft_casters_, beyond_extents);
  plan_.airlight_tiles = list_airlight_tiles(plan_.airlights, view.camera, view.picture_size, kCoarsestGrid);
  plan_.far_airlights = list_far_airlight(lights_, atmosphere_, view.camera.position, exposure, plan_.higher_orders,
                                          shaft_casters_, beyond_extents);
  plan_.counts.airlights_drawn = plan_.airlights.light_count;
  plan_.counts.airlights_invisible = lights_.size() - plan_.airlights.light_count;
}

void FramePlanner::plan_everything() {
  PointList points;
  points.lights.resize(lights_.local_count());
  std::iota(points.lights.begin(), points.lights.end(), 0);
  add_points(points);
  const auto first = int(plan_.light_list.size());
  const std::span<const std::int32_t> lists = surfaces_.lists();
  plan_.light_list.insert(plan_.light_list.end(), lists.begin(), lists.end());
  for (const Surface& surface : surfaces_.surfaces()) {
    plan_.surfaces.push_back({&surface, false, first + surface.list_first, surface.list_count});
    plan_.counts.lights_listed += std::size_t(surface.list_count);
    plan_.counts.lights_out_of_reach += lights_.size() - std::size_t(surface.list_count);
  }
  plan_.counts.chunks_drawn = plan_.surfaces.size();
}

void FramePlanner::plan_visible(const FrameView& view) {
  FrameCounts& counts = plan_.counts;
  const Frustum frustum = make_frustum(view.clip_from_world);
  const PointList points = list_points(lights_, atmosphere_, settings_.fog_lighting,
                                       {.eye = view.camera.position,
                                        .forward = axes_of(view.camera).forward,
                                        .frustum = frustum,
                                        .pixels_per_radian = view.pixels_per_radian,
                                        .height = view.picture_size.y,
                                        .least_seen = least_seen()},
                                       kPointShare * step_);
  add_points(points);

  const double fog_above_eye = atmosphere_.top_above(view.camera.position.y);
  const double fog_color = largest_component(atmosphere_.ambient_fog_color);
  const double moonlight = moonlight_in_fog();
  const double sky_range = hidden_range(atmosphere_.thinnest_fog(), sky_brightness() + fog_color, kHiddenShare * step_);
  if (view.highest_slope <= slope_in_fog(fog_above_eye, sky_range)) {
    counts.sky = is_fog_lit_ || moonlight > 0 ? SkyDrawing::fog : SkyDrawing::background;
  }

  const std::vector<SurfaceInView> in_view = find_surfaces_in_view(view.camera.position, frustum);
  double hidden_from = 0;  // nothing farther away is visible
  for (const SurfaceInView& each : in_view) {
    constexpr double kRounding = 1 + 1e-6;
    if (each.nearest >= each.hidden_range) continue;
    hidden_from = std::max(hidden_from, std::min(each.farthest, each.hidden_range) * kRounding);
  }
  const double fog_range =  // the sky's, with the moon's airlight before it
      hidden_range(atmosphere_.thinnest_fog(), sky_brightness() + fog_color + moonlight, kHiddenShare * step_);
  const double left_out_from = std::max(
      {hidden_from, fog_range, airlight_end_from(view.camera.position, kBehindShare * step_), points.hidden_by});
  const double highest_left_out = slope_in_fog(fog_above_eye, left_out_from);
  const bool hides = settings_.path->has_light_bound && settings_.papers.light_ambient == 0;
  for (const SurfaceInView& each : in_view) {
    const Surface& surface = surfaces_.surfaces()[each.surface];
    const bool has_mapped_fog = settings_.path->has_mapped_fog() && surface.is_fog_lit;
    if (!hides || has_mapped_fog || each.nearest < each.hidden_range) {
      const double through = fog_factor_at(fog_before(view.camera.position.y, surface.bounds), each.nearest);
      plan_.surfaces.push_back(list_lights(each.surface, hides ? kSurfaceLightShare * step_ / through : -1));
      ++counts.chunks_drawn;
    } else if (each.nearest < left_out_from || can_be_lit_from(view.camera.position, surface, left_out_from) ||
               highest_slope(view.camera.position, surface.bounds, each.nearest, each.farthest) > highest_left_out) {
      plan_.surfaces.push_back({&surface, true, 0, 0});
      ++counts.chunks_as_fog;
    } else {
      ++counts.chunks_hidden;
    }
  }
}

void FramePlanner::add_points(const PointList& points) {
  plan_.point_first = int(plan_.light_list.size());
  plan_.point_count = int(points.lights.size());
  plan_.light_list.insert(plan_.light_list.end(), points.lights.begin(), points.lights.end());
  for (const std::int32_t light : points.lights) {
    plan_.light_list.push_back(std::bit_cast<std::int32_t>(float(lights_.source_radius(std::size_t(light)))));
  }
  plan_.counts.points_drawn = points.lights.size();
  plan_.counts.points_outside_view = points.outside_view;
  plan_.counts.points_hidden = points.hidden;
}

std::vector<FramePlanner::SurfaceInView> FramePlanner::find_surfaces_in_view(const glm::dvec3& eye,
                                                                             const Frustum& frustum) {
  std::vector<SurfaceInView> found;
  const double fog = largest_component(atmosphere_.ambient_fog_color);
  for (std::size_t i = 0; i < surfaces_.surfaces().size(); ++i) {
    const scene::Bounds& box = surfaces_.surfaces()[i].bounds;
    if (!can_see(frustum, box)) continue;
    const double hidden = hidden_range(fog_before(eye.y, box), brightness_of(i) + fog, kHiddenShare * step_);
    found.push_back({i, nearest_distance(eye, box), farthest_distance(eye, box), hidden});
  }
  plan_.counts.chunks_outside_view = surfaces_.surfaces().size() - found.size();
  return found;
}

bool FramePlanner::can_be_lit_from(const glm::dvec3& eye, const Surface& surface, double range) const {
  if (!is_fog_lit_) return false;
  if (settings_.path->has_mapped_fog()) return true;
  for (std::size_t i = lights_.local_count(); i < lights_.size(); ++i) {
    const PlacedLight& light = lights_.lights()[i];
    const double half_angle = lights_.cookie(i) ? std::numbers::pi : cutoff_angle(light.light.cone);
    if (can_light_from(light, half_angle, eye, surface.bounds, range)) return true;
  }
  return false;
}

LightCounts FramePlanner::count_lights() const {
  enum class Fate { out_of_reach, outside_view, hidden, drawn };
  std::vector<Fate> fates(lights_.size(), Fate::out_of_reach);
  const auto raise = [&](std::span<const std::int32_t> lights, Fate fate) {
    for (const std::int32_t i : lights) fates[std::size_t(i)] = std::max(fates[std::size_t(i)], fate);
  };
  const Frustum frustum = make_frustum(view_->clip_from_world);
  for (const Surface& surface : surfaces_.surfaces()) {
    raise(surfaces_.lights_of(surface), can_see(frustum, surface.bounds) ? Fate::hidden : Fate::outside_view);
  }
  for (std::size_t i = 0; i < lights_.local_count(); ++i) {
    const glm::vec3 position(lights_.lights()[i].position);
    if (can_see(frustum, {position, position})) fates[i] = std::max(fates[i], Fate::hidden);
  }
  for (const PlannedSurface& surface : plan_.surfaces) {
    raise(plan_.lights_of(surface), Fate::drawn);
  }
  raise(plan_.points(), Fate::drawn);
  for (const AirlightEntry& entry : plan_.airlights.entries) fates[std::size_t(entry.light)] = Fate::drawn;
  const auto count = [&](Fate fate) { return std::size_t(std::ranges::count(fates, fate)); };
  return {.off = scene_.lights.size() - lights_.size(),
          .drawn = count(Fate::drawn),
          .hidden = count(Fate::hidden),
          .outside_view = count(Fate::outside_view),
          .out_of_reach = count(Fate::out_of_reach)};
}

}  // namespace litfog::render
