// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "bench/benchmarks.h"
#include "command/progress.h"
#include "litfog/gl/headless_context.h"
#include "measure/frame_times.h"
#include "measure/picture_error.h"
#include "scene/file/scene_file.h"

namespace litfog::bench {
namespace {

/// How lamps light the fog.
struct FogLight {
  const char* name;
  render::FogLighting lighting;
  render::Scattering scattering;
};
constexpr FogLight kFogLights[] = {{"peak", render::FogLighting::peak, render::Scattering::single},
                                   {"single", render::FogLighting::airlight, render::Scattering::single},
                                   {"all", render::FogLighting::airlight, render::Scattering::all}};

struct Setting {
  std::string scene;
  const char* phase;  ///< empty: the scene's
  std::optional<Phase> function = {};
};

constexpr glm::ivec2 kSize{640, 360}, kQuickSize{80, 45};
constexpr glm::ivec2 kErrorSize{16, 9};  ///< small, because the reference integrates each lamp's airlight to 1e-10

std::vector<Setting> settings(bool quick) {
  std::vector<Setting> all;
  for (const std::string& scene : quick ? std::vector<std::string>{"room"} : scene::bundled_scenes()) {
    all.push_back({scene, ""});
    if (scene != "headlights" && scene != "street" && scene != "approach") continue;
    all.push_back({scene, "isotropic", Phase{}});
    all.push_back({scene, "g-0.85", Phase::henyey_greenstein(0.85)});
  }
  return all;
}

/// Measures the rows of a setting with interleaved frames.
void measure(const Setting& setting, bool quick, const measure::Progress& progress, Result& result) {
  const scene::Scene scene = scene::read_scene(scene::bundled_scene_path(setting.scene));
  Atmosphere atmosphere = scene.atmosphere.with(Fog::from_visibility(FogMode::exp, scene::suggested_visibility(scene)));
  if (setting.function) atmosphere.phase = *setting.function;
  const glm::ivec2 size = quick ? kQuickSize : kSize;
  std::vector<std::unique_ptr<render::Renderer>> renderers;
  for (const FogLight& light : kFogLights) {
    const render::RenderSettings settings{.fog_lighting = light.lighting, .scattering = light.scattering};
    render::Renderer& renderer =
        *renderers.emplace_back(std::make_unique<render::Renderer>(scene, size.x, size.y, settings));
    renderer.set_atmosphere(atmosphere);
    renderer.set_exposure({.ev = scene.display.exposure.value_or(0), .is_auto = !scene.display.exposure});
  }
  const measure::FrameBudget budget =
      quick ? measure::FrameBudget::exactly(3) : measure::FrameBudget{.seconds = 10, .fewest = 3, .most = 15};
  const std::vector<measure::FrameTimes> times = measure::time_frames(renderers, budget, progress);
  for (std::size_t i = 0; i < renderers.size(); ++i) {
    const render::FrameCounts counts = times[i].counts;
    renderers[i]->set_size(kErrorSize.x, kErrorSize.y);
    renderers[i]->draw();
    const measure::PictureError error = measure::compare_with_reference(*renderers[i], progress).error;
    const double time = times[i].median();
    result.table.rows.push_back({setting.scene, setting.phase, double(scene.lights.size()), kFogLights[i].name, time,
                                 times[i].spread(), time / times[0].median(), time / times[1].median(),
                                 double(counts.bytes_uploaded), error.largest, error.mean});
    renderers[i].reset();
  }
}

}  // namespace

Result measure_frames(bool quick) {
  const gl::HeadlessContext context;
  command::Progress shown;
  Result result;
  result.gl_renderer = context.renderer();
  result.table.columns = {"scene",          "phase",         "lights",        "fog_light",
                          "ms_per_frame",   "ms_spread",     "ratio_to_peak", "ratio_to_single",
                          "bytes_uploaded", "max_error_255", "mean_error_255"};
  for (const Setting& setting : settings(quick)) {
    const measure::Progress progress = [&](std::string_view step) {
      shown.show(fmt::format("{} {}: {}", setting.scene, setting.phase, step));
    };
    measure(setting, quick, progress, result);
  }
  return result;
}

}  // namespace litfog::bench
