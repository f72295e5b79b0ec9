// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/light_count.h"
#include "command/progress.h"
#include "litfog/gl/headless_context.h"
#include "measure/frame_times.h"
#include "scene/file/scene_file.h"

namespace litfog::bench {
namespace {

using render::EarlyRejection;

constexpr std::pair<const char*, EarlyRejection> kRejections[]{{"none", EarlyRejection::none},
                                                               {"front-to-back", EarlyRejection::front_to_back},
                                                               {"depth-pass", EarlyRejection::depth_pass}};

/// An OpenGL query's count over a frame's surfaces and sky, per pixel.
double count_per_pixel(render::Renderer& renderer, GLenum counted) {
  GLuint query = 0;
  glGenQueries(1, &query);
  glBeginQuery(counted, query);
  renderer.draw(render::LightPoints::off);
  glEndQuery(counted);
  GLuint64 count = 0;
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return double(count) / (double(renderer.width()) * renderer.height());
}

command::Table::Cell count_fragments(render::Renderer& renderer) {
  if (!epoxy_has_gl_extension("GL_ARB_pipeline_statistics_query")) return std::monostate{};
  return count_per_pixel(renderer, GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
}

}  // namespace

Result measure_rejection(bool quick) {
  const std::vector<std::string> scenes = quick ? std::vector<std::string>{"room"} : scene::bundled_scenes();
  const std::vector<std::size_t> light_counts = quick ? std::vector<std::size_t>{2} : std::vector<std::size_t>{2, 16};
  const int width = quick ? 80 : 640;
  const int height = quick ? 45 : 360;
  const measure::FrameBudget budget =
      quick ? measure::FrameBudget::exactly(3) : measure::FrameBudget{.seconds = 3, .fewest = 3, .most = 15};
  const gl::HeadlessContext context;
  Result result;
  result.gl_renderer = context.renderer();
  result.table.columns = {"scene",        "lights",    "size",          "samples",       "rejection",
                          "ms_per_frame", "ms_spread", "ratio_to_none", "layers_passed", "fragments_per_pixel"};
  command::Progress shown;
  for (const std::string& name : scenes) {
    const scene::Scene bundled = scene::read_scene(scene::bundled_scene_path(name));
    for (const std::size_t lights : light_counts) {
      const scene::Scene scene = with_light_count(bundled, lights);
      const Fog fog = Fog::from_visibility(FogMode::exp, scene::suggested_visibility(scene));
      for (const int samples : {1, 4}) {
        std::vector<std::unique_ptr<render::Renderer>> renderers;
        for (const auto& [text, rejection] : kRejections) {
          const render::RenderSettings settings{.papers = {.early_rejection = rejection}, .samples = samples};
          renderers.push_back(std::make_unique<render::Renderer>(scene, width, height, settings));
          renderers.back()->set_atmosphere(scene.atmosphere.with(fog));
        }
        const auto times = measure::time_frames(renderers, budget, [&](std::string_view step) {
          shown.show(fmt::format("{}, {} lights, {} a pixel: {}", name, lights, samples, step));
        });
        for (std::size_t i = 0; i < times.size(); ++i) {
          result.table.rows.push_back(
              {name, double(lights), fmt::format("{}x{}", width, height), double(samples), kRejections[i].first,
               times[i].median(), times[i].spread(), times[i].median() / times[0].median(),
               count_per_pixel(*renderers[i], GL_SAMPLES_PASSED) / samples, count_fragments(*renderers[i])});
        }
      }
    }
  }
  return result;
}

}  // namespace litfog::bench
