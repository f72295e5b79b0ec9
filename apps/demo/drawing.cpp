// SPDX-License-Identifier: Apache-2.0
#include "demo/drawing.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "command/progress.h"
#include "litfog/gl/headless_context.h"
#include "render/renderer.h"

namespace litfog::demo {

Drawn draw(const scene::Scene& scene, const DrawingOptions& options, int frames, bool has_reference) {
  const gl::HeadlessContext context;
  render::Renderer renderer(scene, options.width, options.height, options.settings_of(*options.render.path));
  const double visibility = options.chosen_visibility().value_or(scene::suggested_visibility(scene));
  renderer.set_fog(Fog::from_visibility(options.fog_mode(), visibility));
  command::Progress progress;
  const measure::Progress show = [&progress](std::string_view step) { progress.show(step); };
  Drawn drawn{
      .picture = {},
      .visibility = visibility,
      .times =
          measure::time_frames({measure::frames_of(renderer)}, measure::FrameBudget::exactly(frames), show).front(),
      .comparison = {},
      .samples = renderer.samples(),
      .gl_renderer = context.renderer(),
      .gl_version = context.version()};
  if (has_reference) drawn.comparison = measure::compare_with_reference(renderer, show);
  drawn.picture = drawn.comparison ? drawn.comparison->drawn : renderer.read();
  return drawn;
}

std::string stats_json(const scene::Scene& scene, const DrawingOptions& options, const Drawn& drawn,
                       const std::optional<render::Display>& display) {
  using Json = nlohmann::ordered_json;
  const measure::FrameTimes& times = drawn.times;
  Json stats{
      {"scene", scene.name},
      {"path", options.render.path->name},
      {"fog_light",
       options.settings_of(*options.render.path).fog_lighting == render::FogLighting::airlight ? "airlight" : "peak"},
      {"fog", options.fog ? name_of(*options.fog) : "none"},
      {"visibility_m", std::isinf(drawn.visibility) ? Json("inf") : Json(drawn.visibility)},
      {"size", {options.width, options.height}},
      {"samples", drawn.samples},
      {"lights", scene.lights.size()},
      {"frames", times.milliseconds.size()},
      {"ms_per_frame",
       {{"median", times.median()},
        {"spread", times.spread()},
        {"min", times.milliseconds.front()},
        {"max", times.milliseconds.back()}}},
      {"skip", options.render.skipping == render::Skipping::on},
      {"chunks_drawn", times.counts.chunks_drawn},
      {"chunks_fog", times.counts.chunks_as_fog},
      {"chunks_outside", times.counts.chunks_outside_view},
      {"chunks_hidden", times.counts.chunks_hidden},
      {"surface_lights_listed", times.counts.lights_listed},
      {"surface_lights_hidden", times.counts.lights_hidden},
      {"points", times.counts.points_drawn},
      {"points_hidden", times.counts.points_hidden},
      {"sky", int(times.counts.sky)},
      {"gl_renderer", drawn.gl_renderer},
      {"gl_version", drawn.gl_version}};
  if (display) {
    stats["exposure_ev"] = display->exposure.ev;
    stats["exposure_auto"] = display->exposure.is_auto;
    stats["tone"] = tone_name(display->tone);
  }
  if (drawn.comparison) {
    const measure::PictureError& error = drawn.comparison->error;
    stats["max_error_255"] = error.largest;
    stats["mean_error_255"] = error.mean;
    stats["excepted_pixels"] = error.excluded;
  }
  // A scene may be named by a file whose name is no UTF-8.
  return stats.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace litfog::demo
