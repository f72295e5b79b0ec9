// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/stopwatch.h"
#include "bench/visible_lights.h"
#include "command/progress.h"
#include "command/wall_timer.h"
#include "litfog/gl/headless_context.h"
#include "litfog/light_clusters.h"
#include "litfog/updater.h"
#include "measure/picture_error.h"
#include "measure/quantile.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace litfog::bench {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;
constexpr double kBudget = 0.5 / 255;  // fraction of a display's white
constexpr double kFarthest = 4000;     // metres: beyond the city
constexpr double kMaxLostSteps =
    2;  // steps of the display: half a step is left out here, and each frame leaves out up to 3/4
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Scale {
  std::vector<double> visibilities;
  std::vector<std::size_t> lights;
  std::size_t most_drawn;       ///< lights, in frames
  std::size_t most_airlit;      ///< lights, in frames by airlight
  std::size_t drawn_in_flight;  ///< lights
  int flight_frames;
  int still_frames;
};
const Scale kFull{
    {kInfinity, 1500, 400, 50}, {100, 300, 1000, 3000, 10'000, 30'000, 100'000}, 10'000, 1000, 10'000, 300, 9};
const Scale kQuick{{kInfinity, 50}, {100, 1000}, 100, 100, 100, 4, 2};

// --- the flight ---

/// Along streets, round four blocks and back; metres.
constexpr std::array<glm::dvec3, 10> kWay{{{0, 10, 62},
                                           {0, 9, -60},
                                           {0, 9, -150},
                                           {30, 10, -180},
                                           {150, 12, -180},
                                           {180, 12, -150},
                                           {180, 13, 60},
                                           {150, 14, 90},
                                           {30, 12, 90},
                                           {0, 10, 62}}};

/// A Catmull-Rom spline through the way, at a fraction of it.
glm::dvec3 point_at(double fraction) {
  const double position = std::clamp(fraction, 0.0, 1.0) * double(kWay.size() - 1);
  const auto i = std::min(std::size_t(position), kWay.size() - 2);
  const double t = position - double(i);
  const glm::dvec3 a = kWay[i == 0 ? 0 : i - 1];
  const glm::dvec3 b = kWay[i];
  const glm::dvec3 c = kWay[i + 1];
  const glm::dvec3 d = kWay[std::min(i + 2, kWay.size() - 1)];
  return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

scene::Camera camera_at(double fraction, float field_of_view) {
  const glm::dvec3 position = point_at(fraction);
  const glm::dvec3 ahead = point_at(std::fmod(fraction + 0.05, 1.0));
  return {position, glm::vec3(ahead.x, 0.8 * ahead.y, ahead.z), field_of_view};
}

double farthest_in(double visibility) {
  return std::min(kFarthest, visibility * std::log(kBudget) / std::log(kContrastMor));
}

View view_of(const scene::Camera& camera, double visibility) {
  const scene::CameraAxes axes = axes_of(camera);
  const double top = std::tan(double(camera.field_of_view) / 2);
  const double side = top * kWidth / kHeight;
  return {.eye = camera.position,
          .forward = axes.forward,
          .up = axes.up,
          .left = -side,
          .right = side,
          .bottom = -top,
          .top = top,
          .nearest = render::kNearPlane,
          .farthest = farthest_in(visibility)};
}

// --- times ---

template <typename Clock, typename Work>
double time_of(const Clock& clock, const Work& work) {
  const double begin = clock();
  work();
  return clock() - begin;
}

/// A method at a visibility and a number of lights.
struct Trial {
  std::string method;
  double visibility;
  std::size_t lights;
  std::vector<double> matter = {};  ///< one value per frame, as in the next members
  std::vector<double> entries = {};
  std::vector<double> milliseconds = {};       ///< processor time
  std::vector<double> wall_milliseconds = {};  ///< wall time of frames
  std::optional<double> ratio_to_those = {};
  std::optional<double> max_error = {};  ///< steps of the display

  double median() const { return measure::quantile(milliseconds, 0.5); }
};

/// Records the times of a frame.
void time_frame(Trial& trial, render::Renderer& renderer) {
  const command::WallTimer wall;
  trial.milliseconds.push_back(time_of(process_milliseconds, [&] { renderer.draw(); }));
  trial.wall_milliseconds.push_back(wall.milliseconds());
}

/// Measures a city.
class CityTrials {
 public:
  explicit CityTrials(const Scale& scale)
      : scale_(scale), city_(scene::read_scene(scene::bundled_scene_path("city"), std::ranges::max(scale.lights))) {}

  void measure_clusters(double visibility, std::size_t count) {
    FogUpdater lights;
    for (const PlacedLight& light : std::span(city_.lights).first(count)) lights.add(light);
    const Atmosphere air{.fog = Fog::from_visibility(FogMode::exp, visibility)};
    LightClusters clusters;
    Trial& change = add("clusters-fog", visibility, count);
    const View first = view_of(camera_at(0, city_.camera.field_of_view), visibility);
    for (int i = 0; i < scale_.still_frames + 1; ++i) {
      const Atmosphere other = air.with({FogMode::exp, air.fog.density * (1 + 1e-3 * (scale_.still_frames - i))});
      const double time = time_of(thread_milliseconds, [&] {
        lights.bound_lights(clusters, other, kBudget);
        clusters.update(first);
      });
      if (i > 0) note(change, clusters, time);  // the first one is set-up
    }
    lights.bound_lights(clusters, air, kBudget);

    Trial& flight = add("clusters", visibility, count);
    for (int frame = 0; frame < scale_.flight_frames; ++frame) {
      const View view = view_at(frame, visibility);
      note(flight, clusters, time_of(thread_milliseconds, [&] { clusters.update(view); }));
    }

    Trial& still = add("clusters-one-light", visibility, count);
    for (int i = 0; i < 10 * scale_.still_frames; ++i) {
      const std::size_t light = std::size_t(i) * 37 % count;
      const auto kind = std::size_t(lights.instances()[light].position_kind.w);
      clusters.set_light(light, bounds_of(city_.lights[light], 1.5 * lights.reach_of_kind(kind, air, kBudget)));
      note(still, clusters,
           time_of(thread_milliseconds, [&] { clusters.update(view_at(scale_.flight_frames - 1, visibility)); }));
    }
  }

  /// Measures a frame from the scene's camera with `count` lights, and one with only the lights that matter there.
  void measure_frames(double visibility, std::size_t count) {
    scene::Scene all = city_;
    all.lights.resize(count);
    const auto with_all = renderer_of(all, visibility);
    scene::Scene some = all;
    some.lights.clear();
    for (const std::size_t light : find_visible_lights(*with_all)) some.lights.push_back(all.lights[light]);
    const auto with_some = renderer_of(some, visibility);
    const auto matter = double(some.lights.size());
    Trial& frame = trials_.emplace_back(Trial{"frame", visibility, count, {matter}});
    Trial& those = trials_.emplace_back(Trial{"frame-of-those", visibility, some.lights.size(), {matter}});
    for (int i = 0; i < scale_.still_frames; ++i) {  // interleaved
      time_frame(frame, *with_all);
      time_frame(those, *with_some);
    }
    frame.ratio_to_those = frame.median() / those.median();
    frame.max_error = measure::picture_error(with_all->read(), with_some->read()).largest;
  }

  /// Measures a frame from the scene's camera with the airlight of the first `count` lights in view.
  void measure_airlight(double visibility, std::size_t count) {
    scene::Scene scene = city_;
    const ViewFrustum frustum(view_of(scene.camera, kInfinity));
    std::erase_if(scene.lights, [&](const PlacedLight& light) { return !frustum.can_see(light.position, 0); });
    scene.lights.resize(std::min(count, scene.lights.size()));
    const auto renderer = renderer_of(scene, visibility, render::FogLighting::airlight);
    Trial& frame = add("frame-airlight", visibility, count);
    for (int i = 0; i < scale_.still_frames; ++i) {
      frame.matter.push_back(double(renderer->draw().airlights_drawn));
      time_frame(frame, *renderer);
    }
  }

  void measure_flight(double visibility) {
    scene::Scene scene = city_;
    scene.lights.resize(scale_.drawn_in_flight);
    const auto renderer = renderer_of(scene, visibility);
    Trial& flight = add("frame-flight", visibility, scene.lights.size());
    for (int frame = 0; frame < scale_.flight_frames; ++frame) {
      scene.camera = camera_at(double(frame) / scale_.flight_frames, city_.camera.field_of_view);
      time_frame(flight, *renderer);
    }
  }

  const std::deque<Trial>& trials() const { return trials_; }

 private:
  Trial& add(const std::string& method, double visibility, std::size_t lights) {
    trials_.push_back({method, visibility, lights});
    return trials_.back();
  }

  static void note(Trial& trial, const LightClusters& clusters, double milliseconds) {
    trial.matter.push_back(double(clusters.statistics().lights_in_view));
    trial.entries.push_back(double(clusters.statistics().entries));
    trial.milliseconds.push_back(milliseconds);
  }

  View view_at(int frame, double visibility) const {
    return view_of(camera_at(double(frame) / scale_.flight_frames, city_.camera.field_of_view), visibility);
  }

  /// A renderer that has drawn a frame, because drivers compile shaders at their first draw call.
  static std::unique_ptr<render::Renderer> renderer_of(const scene::Scene& scene, double visibility,
                                                       render::FogLighting fog_lighting = render::FogLighting::peak) {
    const render::RenderSettings settings{.fog_lighting = fog_lighting};
    auto renderer = std::make_unique<render::Renderer>(scene, kWidth, kHeight, settings);
    renderer->set_atmosphere(renderer->scene().atmosphere.with(Fog::from_visibility(FogMode::exp, visibility)));
    renderer->draw();
    return renderer;
  }

  const Scale& scale_;
  scene::Scene city_;
  std::deque<Trial> trials_;
};

// --- the result ---

double ratio_of_worst(const Trial& trial) { return std::ranges::max(trial.milliseconds) / trial.median(); }

command::Table make_table(const std::deque<Trial>& trials) {
  command::Table table{{"method", "visibility_m", "lights", "lights_that_matter", "entries", "ms", "ms_spread",
                        "worst_ratio", "wall_ms", "ratio_to_those", "max_error_255"},
                       {}};
  using Cell = command::Table::Cell;
  const auto median = [](const std::vector<double>& values) {
    return values.empty() ? Cell(std::monostate{}) : Cell(measure::quantile(values, 0.5));
  };
  const auto stated = [](const std::optional<double>& value) { return value ? Cell(*value) : Cell(std::monostate{}); };
  for (const Trial& trial : trials) {
    const double spread = measure::quantile(trial.milliseconds, 0.9) - measure::quantile(trial.milliseconds, 0.1);
    table.rows.push_back({trial.method, trial.visibility, double(trial.lights), median(trial.matter),
                          median(trial.entries), trial.median(), spread, ratio_of_worst(trial),
                          median(trial.wall_milliseconds), stated(trial.ratio_to_those), stated(trial.max_error)});
  }
  return table;
}

std::string visibility_text(double visibility) {
  return std::isinf(visibility) ? "clear" : fmt::format("{:.0f} m", visibility);
}

}  // namespace

Result measure_city(bool quick) {
  const gl::HeadlessContext context;
  const Scale& scale = quick ? kQuick : kFull;
  command::Progress progress;
  CityTrials trials(scale);
  for (const double visibility : scale.visibilities) {
    const std::string name = visibility_text(visibility);
    for (const std::size_t lights : scale.lights) {
      progress.show(fmt::format("{}: clusters of {} lights", name, lights));
      trials.measure_clusters(visibility, lights);
      if (lights > scale.most_drawn) continue;
      progress.show(fmt::format("{}: frames with {} lights", name, lights));
      trials.measure_frames(visibility, lights);
      if (lights <= scale.most_airlit) trials.measure_airlight(visibility, lights);
    }
    progress.show(fmt::format("{}: flight", name));
    trials.measure_flight(visibility);
  }
  Result result{.table = make_table(trials.trials()), .figure = {}, .gl_renderer = context.renderer(), .failures = {}};
  for (const Trial& trial : trials.trials()) {
    if (!(trial.max_error.value_or(0) > kMaxLostSteps)) continue;
    result.failures.push_back(fmt::format("{} of {} lights at {}: max_error_255 = {}: must be at most {}", trial.method,
                                          trial.lights, visibility_text(trial.visibility), *trial.max_error,
                                          kMaxLostSteps));
  }
  return result;
}

}  // namespace litfog::bench
