// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <vector>

#include "litfog/gl/headless_context.h"
#include "measure/picture_error.h"
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
  for (const char* path : {"lookup-3d", "lookup-2d"}) {
    for (const int size : sizes) {
      render::Renderer renderer(scene, kWidth, kHeight,
                                {.path = render::find_lighting_path(path), .papers = {.map_size = size}});
      renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp2, 100.0)));
      renderer.draw();
      const measure::PictureError error = measure::compare_with_reference(renderer).error;
      const double p99 = measure::quantile({error.pixels.begin(), error.pixels.end()}, 0.99);
      const bool is_pair = renderer.settings().path->maps == render::LightMapSet::pair;
      const int pair = is_pair ? render::pair_size(size) : 0;
      const double range_kib = (is_pair ? 2 * squared(pair) : size * squared(size)) * kKibibytesATexel;
      result.table.rows.push_back({path, double(size), double(pair), range_kib, 6 * squared(size) * kKibibytesATexel,
                                   error.largest, error.mean, p99});
    }
  }
  return result;
}

}  // namespace litfog::bench
