// SPDX-License-Identifier: Apache-2.0
#include "bench/map_benchmark.h"

#include <string>
#include <vector>

#include "litfog/gl/headless_context.h"
#include "measure/comparison.h"
#include "measure/quantile.h"
#include "render/light/light_map.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace litfog::bench {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr double kKibibytesATexel = 2 / 1024.0;

double squared(int size) { return double(size) * size; }

}  // namespace

Result measure_maps(bool quick) {
  const std::vector<int> sizes = quick ? std::vector{16, 64} : std::vector{16, 32, 64, 128, 256};
  scene::Scene scene = scene::read_scene(scene::bundled_scene_path("headlights"));
  std::erase_if(scene.lights, [](const PlacedLight& light) { return !light.carried; });
  const gl::HeadlessContext context;
  Result result;
  result.gl_renderer = context.renderer();
  result.table.columns = {"path",     "map_size",      "pair_size",      "range_kib",
                          "cone_kib", "max_error_255", "mean_error_255", "p99_error_255"};
  result.figure = {.title = "Hales's light maps: error of the picture", .columns = 2, .width = 1000, .height = 420};
  command::Chart over_size{.x = {"texels a side", true}, .y = {"error, 99th percentile (1/255)", true}};
  command::Chart over_memory{.x = {"range maps (KiB)", true}, .y = {"error, 99th percentile (1/255)", true}};
  for (const char* path : {"lookup-3d", "lookup-2d"}) {
    command::Series by_size{.name = path, .style = command::SeriesStyle::line_and_points};
    command::Series by_memory = by_size;
    for (const int size : sizes) {
      render::Renderer renderer(scene, kWidth, kHeight, {.path = render::find_lighting_path(path), .map_size = size});
      renderer.set_fog(Fog::from_visibility(FogMode::exp2, 100.0));
      renderer.draw();
      const measure::PictureError error = measure::compare_with_reference(renderer).error;
      const double p99 = measure::quantile({error.pixels.begin(), error.pixels.end()}, 0.99);
      const bool is_pair = renderer.settings().path->maps == render::LightMapSet::pair;
      const int pair = is_pair ? render::pair_size(size) : 0;
      const double range_kib = (is_pair ? 2 * squared(pair) : size * squared(size)) * kKibibytesATexel;
      result.table.rows.push_back({path, double(size), double(pair), range_kib, 6 * squared(size) * kKibibytesATexel,
                                   error.largest, error.mean, p99});
      by_size.points.push_back({double(size), p99});
      by_memory.points.push_back({range_kib, p99, is_pair ? "" : std::to_string(size)});
    }
    over_size.series.push_back(by_size);
    over_memory.series.push_back(by_memory);
  }
  result.figure.charts = {over_size, over_memory};
  return result;
}

}  // namespace litfog::bench
