// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "bench/benchmarks.h"
#include "command/progress.h"
#include "drawing/contact_sheet.h"
#include "drawing/picture_file.h"
#include "litfog/color_temperature.h"
#include "litfog/gl/headless_context.h"
#include "measure/quantile.h"
#include "measure/traced_picture.h"
#include "render/display.h"
#include "scene/file/scene_file.h"

namespace litfog::bench {
namespace {

struct View {
  const char* scene;
  double visibility;  // metres
};
constexpr View kViews[] = {{"street", 120}, {"street", 40}, {"approach", 200}, {"room", 20}};
constexpr int kBlock = 4;  // pixels: side of the squares that are compared, in which noise is less

/// The mean luminance of each square of a picture.
std::vector<double> blocks_of(const render::Picture& picture) {
  std::vector<double> blocks;
  for (int top = 0; top + kBlock <= picture.height; top += kBlock) {
    for (int left = 0; left + kBlock <= picture.width; left += kBlock) {
      double sum = 0;
      for (int i = 0; i < kBlock * kBlock; ++i) {
        const auto pixel = std::size_t(top + i / kBlock) * std::size_t(picture.width) + std::size_t(left + i % kBlock);
        sum += luminance(glm::dvec3(picture.rgb[3 * pixel], picture.rgb[3 * pixel + 1], picture.rgb[3 * pixel + 2]));
      }
      blocks.push_back(sum / (kBlock * kBlock));
    }
  }
  return blocks;
}

render::Picture sum_of(render::Picture a, const render::Picture& b) {
  for (std::size_t i = 0; i < a.rgb.size(); ++i) a.rgb[i] += b.rgb[i];
  return a;
}

render::Picture mean_of(render::Picture a, const render::Picture& b) {
  for (std::size_t i = 0; i < a.rgb.size(); ++i) a.rgb[i] = std::midpoint(a.rgb[i], b.rgb[i]);
  return a;
}

std::vector<drawing::SheetEntry> measure(const View& view, bool quick, const measure::Progress& progress,
                                         Result& result) {
  const scene::Scene scene = scene::read_scene(scene::bundled_scene_path(view.scene));
  const glm::ivec2 size = quick ? glm::ivec2(16, 8) : glm::ivec2(96, 54);
  const auto renderer_of = [&](render::Scattering scattering) {
    auto renderer =
        std::make_unique<render::Renderer>(scene, size.x, size.y,
                                           render::RenderSettings{.fog_lighting = render::FogLighting::airlight,
                                                                  .scattering = scattering,
                                                                  .samples = 1,
                                                                  .shadows = render::Shadows::shafts,
                                                                  .shadow_lamps = 32});
    renderer->set_atmosphere(scene.atmosphere.with(Fog::from_visibility(FogMode::exp, view.visibility)));
    return renderer;
  };
  const auto drawn_by = [](render::Renderer& renderer) {
    renderer.draw(render::LightPoints::off);
    return renderer.draw_in_floats();
  };
  const auto of_all = renderer_of(render::Scattering::all);
  const render::Picture all = drawn_by(*of_all), single = drawn_by(*renderer_of(render::Scattering::single));
  render::Picture halves[2];
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    halves[seed - 1] =
        sum_of(single, measure::trace_higher_orders(*of_all, {.paths = quick ? 8 : 64, .seed = seed}, progress));
  }
  const render::Picture traced = mean_of(halves[0], halves[1]);

  const std::vector<double> truth = blocks_of(traced), one = blocks_of(halves[0]), other = blocks_of(halves[1]);
  std::vector<double> noise;
  for (std::size_t i = 0; i < truth.size(); ++i) noise.push_back(std::abs(one[i] - other[i]) / (one[i] + other[i]));
  for (const auto& [name, picture] : {std::pair{"single", &single}, {"all", &all}}) {
    std::vector<double> ratios = blocks_of(*picture);
    for (std::size_t i = 0; i < ratios.size(); ++i) ratios[i] /= truth[i];
    result.table.rows.push_back({view.scene, view.visibility, name, measure::quantile(ratios, 0.1),
                                 measure::quantile(ratios, 0.5), measure::quantile(ratios, 0.9),
                                 measure::quantile(noise, 0.5)});
  }
  const render::Display display{.exposure = {.ev = render::auto_exposure(traced)}};
  std::vector<drawing::SheetEntry> row;
  for (const auto& [name, picture] :
       {std::pair{"scattered once", &single}, {"all orders, litfog", &all}, {"all orders, traced paths", &traced}}) {
    row.push_back(
        {render::displayed(*picture, display), {fmt::format("{}, {} m: {}", view.scene, view.visibility, name)}});
  }
  return row;
}

}  // namespace

Result trace_scenes(bool quick) {
  const gl::HeadlessContext context;
  command::Progress shown;
  Result result;
  result.gl_renderer = context.renderer();
  result.table.columns = {"scene", "visibility_m", "fog_light", "ratio_p10", "ratio_p50", "ratio_p90", "noise_p50"};
  std::vector<std::vector<drawing::SheetEntry>> sheet;
  for (const View& view : std::span(kViews).first(quick ? 1 : std::size(kViews))) {
    sheet.push_back(measure(
        view, quick,
        [&](std::string_view step) { shown.show(fmt::format("{} at {} m: {}", view.scene, view.visibility, step)); },
        result));
  }
  result.strip = [sheet = std::move(sheet)] { return drawing::png_text(drawing::make_contact_sheet(sheet)); };
  return result;
}

}  // namespace litfog::bench
