// SPDX-License-Identifier: Apache-2.0
#include "drawing/drawing.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "litfog/gl/headless_context.h"
#include "litfog/multiple_scattering.h"

namespace litfog::drawing {
namespace {

const char* sky_name(render::SkyDrawing sky) {
  switch (sky) {
    case render::SkyDrawing::sky:
      return "drawn";
    case render::SkyDrawing::fog:
      return "fog_alone";
    case render::SkyDrawing::background:
      return "hidden_by_fog";
  }
  return "";
}

}  // namespace

DrawnFor set_fog_and_exposure(render::Renderer& renderer, const DrawingOptions& options) {
  const double visibility = options.visibility_in(renderer.scene());
  renderer.set_atmosphere(options.atmosphere_of(renderer.scene(), visibility));
  Display display = options.display.display_for(renderer.scene(), renderer.settings().fog_lighting);
  display.exposure = renderer.set_exposure(display.exposure);
  return {.display = display, .visibility = visibility};
}

render::Picture whole_light(render::Renderer& renderer, render::Picture light) {
  return is_cut_off(light) ? renderer.draw_in_floats() : std::move(light);
}

Drawn draw(const scene::Scene& scene, const DrawingOptions& options, const command::WallTimer& load,
           command::Progress& progress, int frames, bool has_reference, bool has_statistics, bool in_floats) {
  const gl::HeadlessContext context;
  render::Renderer renderer(scene, options.width, options.height, options.settings());
  const double load_ms = load.milliseconds();
  const command::WallTimer timer;
  const measure::Progress show = [&](std::string_view step) { progress.show(fmt::format("{}: {}", scene.name, step)); };
  show(measure::kCompiling);
  const DrawnFor drawn_for = set_fog_and_exposure(renderer, options);
  Drawn drawn{
      .picture = {},
      .display = drawn_for.display,
      .visibility = drawn_for.visibility,
      .times =
          measure::time_frames({measure::frames_of(renderer)}, measure::FrameBudget::exactly(frames), show).front(),
      .load_ms = load_ms,
      .first_ms = timer.milliseconds(),
      .shadow_lamps = renderer.shadows() ? renderer.shadows()->casters().size() : 0,
      .shadow_maps = renderer.shadows() ? renderer.shadows()->map_count() : 0,
      .statistics = {},
      .comparison = {},
      .samples = renderer.samples(),
      .gl_renderer = context.renderer(),
      .gl_version = context.version()};
  drawn.first_ms -= std::reduce(drawn.times.milliseconds.begin(), drawn.times.milliseconds.end());
  if (has_statistics) drawn.statistics = renderer.draw_and_measure();
  if (has_reference) drawn.comparison = measure::compare_with_reference(renderer, show);
  if (in_floats) {
    drawn.picture = renderer.draw_in_floats();
  } else {
    drawn.picture = whole_light(renderer, drawn.comparison ? drawn.comparison->drawn : renderer.read());
  }
  return drawn;
}

std::string stats_json(const scene::Scene& scene, const DrawingOptions& options, const Drawn& drawn,
                       const std::optional<Display>& display) {
  using Json = nlohmann::ordered_json;
  const measure::FrameTimes& times = drawn.times;
  const render::FrameCounts& counts = drawn.statistics.counts;
  const render::LightCounts& lights = drawn.statistics.lights;
  const render::StageTimes& stages = drawn.statistics.times;
  const render::RenderSettings settings = options.settings();
  const Atmosphere air = options.atmosphere_of(scene, drawn.visibility);
  const bool has_all_orders = settings.fog_lighting == render::FogLighting::airlight &&
                              settings.scattering == render::Scattering::all && !find_scattering_error(air);
  Json stats{
      {"scene", scene.name},
      {"path", options.render.path->name},
      {"fog_light", name_of(settings.fog_lighting)},
      {"scattering", has_all_orders ? "all" : "single"},
      {"albedo", air.albedo},
      {"layer_heights", air.profile.count},
      {"fog", options.fog ? name_of(*options.fog) : "none"},
      {"visibility_m", std::isinf(drawn.visibility) ? Json("inf") : Json(drawn.visibility)},
      {"size", {options.width, options.height}},
      {"samples", drawn.samples},
      {"lights", scene.lights.size()},
      {"ms_to_load", drawn.load_ms},
      {"ms_to_first_frame", drawn.first_ms},
      {"frames", times.milliseconds.size()},
      {"ms_per_frame",
       {{"median", times.median()},
        {"spread", times.spread()},
        {"min", times.milliseconds.front()},
        {"max", times.milliseconds.back()}}},
      {"skip", options.render.skipping == render::Skipping::on},
      {"shadow_lamps", drawn.shadow_lamps},
      {"shadow_maps", drawn.shadow_maps},
      {"chunks_drawn", counts.chunks_drawn + counts.chunks_as_fog},
      {"chunks_skipped", counts.chunks_outside_view + counts.chunks_hidden},
      {"surface_lights_listed", counts.lights_listed},
      {"surface_lights_skipped", counts.lights_out_of_reach + counts.lights_hidden},
      {"chunks",
       {{"drawn", counts.chunks_drawn},
        {"fog_alone", counts.chunks_as_fog},
        {"outside_view", counts.chunks_outside_view},
        {"hidden_by_fog", counts.chunks_hidden}}},
      {"lights_by_fate",
       {{"drawn", lights.drawn},
        {"off", lights.off},
        {"outside_view", lights.outside_view},
        {"out_of_reach", lights.out_of_reach},
        {"hidden_by_fog", lights.hidden}}},
      {"surface_lights",
       {{"listed", counts.lights_listed},
        {"out_of_reach", counts.lights_out_of_reach},
        {"hidden_by_fog", counts.lights_hidden}}},
      {"points",
       {{"drawn", counts.points_drawn},
        {"outside_view", counts.points_outside_view},
        {"hidden_by_fog", counts.points_hidden}}},
      {"airlights", {{"drawn", counts.airlights_drawn}, {"invisible", counts.airlights_invisible}}},
      {"sky", sky_name(counts.sky)},
      {"lights_per_fragment", drawn.statistics.lights_per_fragment},
      {"bytes_uploaded", {{"fog_change", drawn.statistics.fog_bytes_uploaded}, {"frame", counts.bytes_uploaded}}},
      {"ms_by_stage",
       {{"plan", stages.plan},
        {"surfaces", stages.surfaces},
        {"sky", stages.sky},
        {"points", stages.points},
        {"panes", stages.panes},
        {"resolve", stages.resolve},
        {"airlight", stages.airlight}}},
      {"gl_renderer", drawn.gl_renderer},
      {"gl_version", drawn.gl_version}};
  if (display) {
    stats["exposure_ev"] = display->exposure.ev;
    stats["exposure_auto"] = display->exposure.is_auto;
    stats["tone"] = command::word_of(kTones, display->tone);
    stats["glare"] = command::word_of(kGlares, display->glare);
  }
  if (drawn.comparison) {
    const measure::PictureError& error = drawn.comparison->error;
    stats["max_error_255"] = error.largest;
    stats["mean_error_255"] = error.mean;
    stats["excepted_pixels"] = error.excluded;
  }
  // A scene's name may be a file name that is not UTF-8.
  return stats.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace litfog::drawing
