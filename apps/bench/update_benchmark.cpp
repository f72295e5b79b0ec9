// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "bench/light_mix.h"
#include "bench/stopwatch.h"
#include "command/progress.h"
#include "litfog/batch.h"
#include "litfog/updater.h"
#include "measure/quantile.h"
#include "reference/random_light.h"

namespace litfog::bench {
namespace {

struct Scale {
  std::size_t lights;
  std::size_t kinds;
  std::size_t steps;
  std::size_t full_check;  ///< every full_check-th step compares all lights, the others one light of each kind
};
constexpr Scale kFull{1'000'000, 200, 1000, 50};
constexpr Scale kQuick{10'000, 20, 30, 10};

constexpr std::uint64_t kSeed = 20'050'301;
constexpr double kClearest = 10'000;  // metres
constexpr double kThickest = 50;

double visibility_at(std::size_t step, std::size_t steps) {
  const double phase = double(step) / double(steps);
  const double fraction = (1 + std::cos(2 * std::numbers::pi * phase)) / 2;
  return kThickest * std::pow(kClearest / kThickest, fraction);
}

/// Light i is of kind i modulo the number of kinds.
std::vector<PlacedLight> draw_lights(const Scale& scale) {
  test::Random random(kSeed);
  const auto kinds = draw_light_mix(FogMode::exp, scale.kinds, kSeed);
  std::vector<double> density_scales;
  for (std::size_t i = 0; i < scale.kinds; ++i) {
    density_scales.push_back(random.pick(std::vector{1.0, 1 / 1.5, 1 / 2.5}));  // FlightGear's taxi and runway lights
  }
  std::vector<PlacedLight> lights(scale.lights);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::size_t kind = i % scale.kinds;
    Light& light = lights[i].light;
    light.attenuation = kinds.attenuation(kind);
    light.threshold = kinds.threshold[kind];
    light.density_scale = density_scales[kind];
    const double brightness = random.uniform(0.2, 1);
    light.color = {brightness, brightness * random.uniform(0.5, 1), brightness * random.uniform(0, 1)};
    lights[i].carried = true;
  }
  return lights;
}

/// One way of following the visibility.
struct Follower {
  std::string name;
  std::function<void(const Fog&)> step;
  std::function<double(std::size_t light)> intensity;  ///< as it stands after a step
  std::function<double()> skipped_share;
  std::function<std::size_t()> dirty_bytes;  ///< the lights' bytes, after a step
};

/// What a follower did at each step.
struct Record {
  std::vector<double> milliseconds;
  std::vector<double> skipped_shares;
  std::size_t most_bytes = 0;
  double max_deviation_255 = 0;
};

Record follow(const Follower& follower, FogMode mode, const std::vector<PlacedLight>& lights, const Scale& scale,
              command::Progress& progress) {
  Record record;
  follower.step(Fog::from_visibility(mode, kClearest));  // the first step's set-up is not measured
  for (std::size_t step = 1; step <= scale.steps; ++step) {
    const Fog fog = Fog::from_visibility(mode, visibility_at(step, scale.steps));
    const double begin = thread_milliseconds();
    follower.step(fog);
    record.milliseconds.push_back(thread_milliseconds() - begin);
    record.skipped_shares.push_back(follower.skipped_share());
    record.most_bytes = std::max(record.most_bytes, sizeof(FogHeader) + follower.dirty_bytes());

    std::vector<double> exact;
    for (std::size_t kind = 0; kind < scale.kinds; ++kind) {
      exact.push_back(solve_fog_intensity(lights[kind].light, fog).intensity);
    }
    const std::size_t checked = step % scale.full_check == 0 ? lights.size() : scale.kinds;
    for (std::size_t i = 0; i < checked; ++i) {
      const auto& color = lights[i].light.color;
      const double brightest = std::max({color.x, color.y, color.z});
      const double deviation = 255 * brightest * std::abs(follower.intensity(i) - exact[i % scale.kinds]);
      record.max_deviation_255 = std::max(record.max_deviation_255, deviation);
    }
    progress.show(fmt::format("{}, {} fog: step {} of {}", follower.name, name_of(mode), step, scale.steps));
  }
  return record;
}

/// Droplets with a fog between the eye's height, 0, and 100 m, and clear air above.
Atmosphere layered_air(const Fog& fog) {
  const std::array<DensityKnot, 2> knots{{{100, fog.density}, {110, 0}}};
  return {.fog = {fog.mode, 0}, .phase = Phase::droplets(10), .profile = make_density_profile(knots)};
}

Record follow_by_updater(const std::string& name, double budget_255, FogMode mode,
                         const std::vector<PlacedLight>& lights, const Scale& scale, command::Progress& progress,
                         bool is_layered = false) {
  FogUpdater updater(budget_255);
  if (is_layered) updater.solve_sources();
  std::vector<FogLightHandle> handles;
  handles.reserve(lights.size());
  for (const PlacedLight& light : lights) handles.push_back(updater.add(light));
  const Follower follower{
      .name = name,
      .step = [&](const Fog& fog) { is_layered ? updater.set_atmosphere(layered_air(fog)) : updater.set_fog(fog); },
      .intensity = [&](std::size_t i) { return updater.kinds()[updater.kind_of(handles[i])].cone_scale_intensity.w; },
      .skipped_share = [&] { return double(updater.statistics().lights_skipped) / double(lights.size()); },
      .dirty_bytes = [&] { return updater.statistics().bytes_dirty; },
  };
  return follow(follower, mode, lights, scale, progress);
}

/// What a shader needs of a light, where each light has its own.
struct LightEntry {
  FogLightKind kind;
  FogLightInstance instance;
};

Record follow_by_batch(const std::string& name, FogMode mode, const std::vector<PlacedLight>& lights,
                       const Scale& scale, command::Progress& progress) {
  LightColumns<float> columns;
  std::vector<float> density_scales;
  for (const PlacedLight& placed : lights) {
    const Light& light = placed.light;
    columns.constant.push_back(float(light.attenuation.constant));
    columns.linear.push_back(float(light.attenuation.linear));
    columns.quadratic.push_back(float(light.attenuation.quadratic));
    columns.threshold.push_back(float(light.threshold));
    density_scales.push_back(float(light.density_scale));
  }
  columns.density.resize(lights.size());
  std::vector<float> intensity(lights.size());
  std::vector<LightEntry> entries(lights.size());
  const Follower follower{
      .name = name,
      .step =
          [&](const Fog& fog) {
            const auto density = float(fog.density);
            std::transform(density_scales.begin(), density_scales.end(), columns.density.begin(),
                           [density](float scale_of_light) { return density * scale_of_light; });
            solve_fog_intensities(mode, columns.view(), BatchSolutionsF{intensity});
            for (std::size_t i = 0; i < entries.size(); ++i) entries[i].kind.cone_scale_intensity.w = intensity[i];
          },
      .intensity = [&](std::size_t i) { return entries[i].kind.cone_scale_intensity.w; },
      .skipped_share = [] { return 0.0; },
      .dirty_bytes = [&] { return entries.size() * sizeof(LightEntry); },
  };
  return follow(follower, mode, lights, scale, progress);
}

/// What the process has of the machine's memory, in MiB.
double resident_mib() {
  double whole = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> whole >> resident;
  return resident * double(sysconf(_SC_PAGESIZE)) / 1048576;
}

/// The batch has floats for arguments: some ulps of the intensity each, far below a thousandth of a step.
constexpr double kRounding255 = 1e-3;

constexpr std::size_t kFlashing = 1000;       ///< lights; those of them that are replaced come as kinds of their own
constexpr std::size_t kChangesPerStep = 100;  ///< and as many lights switched

struct Load {
  std::vector<double> milliseconds;  ///< a step
  std::size_t kinds = 0;
  double resident_mib = 0;
  double grown_mib = 0;
  double max_deviation_255 = 0;
};

Load follow_load(const Scale& scale, const char* name, command::Progress& progress) {
  auto lights = draw_lights(scale);
  for (std::size_t i = 0; i < kFlashing; ++i) {
    const double start = 1.8 * double(i) / kFlashing;
    lights[i].light.flash = {.period = 2, .count = 1, .flashes = {{{.start = start, .duration = 0.2, .intensity = 3}}}};
  }
  test::Random random(kSeed);
  FogUpdater updater(0);
  std::vector<FogLightHandle> handles;
  handles.reserve(lights.size());
  for (const PlacedLight& light : lights) handles.push_back(updater.add(light));
  Fog fog;
  updater.set_fog(fog);  // the first step's set-up is not measured
  Load load{.milliseconds = std::vector<double>(scale.steps)};
  double resident_at_first = 0;
  for (std::size_t step = 0; step < scale.steps; ++step) {
    if (step == scale.steps / 20) resident_at_first = resident_mib();
    fog = Fog::from_visibility(FogMode::exp, visibility_at(step % 3600, 3600));
    const double begin = thread_milliseconds();
    for (std::size_t i = 0; i < kChangesPerStep; ++i) {
      const bool replaces = i % 10 == 0;
      const auto changed = std::size_t(random.below(int(replaces ? kFlashing : lights.size())));
      lights[changed].position = {random.uniform(-1e4, 1e4), random.uniform(0, 30), random.uniform(-1e4, 1e4)};
      if (replaces) {
        updater.remove(handles[changed]);
        lights[changed].light.attenuation.quadratic = random.log_uniform(1e-4, 1);
        handles[changed] = updater.add(lights[changed]);
      } else {
        updater.change(handles[changed], lights[changed]);
      }
      updater.switch_light(random.pick(handles), random.chance(0.9));
    }
    updater.set_time(double(step) / 60);
    updater.set_fog(fog);
    load.milliseconds[step] = thread_milliseconds() - begin;
    progress.show(fmt::format("{}: step {} of {}", name, step + 1, scale.steps));
  }
  load.kinds = updater.kinds().size();
  load.resident_mib = resident_mib();
  load.grown_mib = load.resident_mib - resident_at_first;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (updater.instances()[updater.instance_of(handles[i])].color == glm::vec4(0))
      continue;  // its kind may be skipped
    const double found = updater.kinds()[updater.kind_of(handles[i])].cone_scale_intensity.w;
    const double exact = solve_fog_intensity(lights[i].light, fog).intensity;
    load.max_deviation_255 = std::max(load.max_deviation_255, 255 * std::abs(found - exact));
  }
  return load;
}

}  // namespace

Result measure_load(bool quick) {
  const Scale scale = quick ? Scale{20'000, 20, 2000, 0} : Scale{1'000'000, 200, 216'000, 0};
  command::Progress progress;
  Load load = follow_load(scale, "first run", progress);
  const auto again = follow_load(scale, "second run", progress).milliseconds;
  std::ranges::transform(load.milliseconds, again, load.milliseconds.begin(),
                         [](double a, double b) { return std::min(a, b); });
  Result result;
  result.table.columns = {"lights",   "kinds",        "steps",     "ms_per_step",      "ms_99",
                          "ms_worst", "resident_mib", "grown_mib", "max_deviation_255"};
  result.table.rows.push_back({double(scale.lights), double(load.kinds), double(scale.steps),
                               measure::quantile(load.milliseconds, 0.5), measure::quantile(load.milliseconds, 0.99),
                               measure::quantile(load.milliseconds, 1), load.resident_mib, load.grown_mib,
                               load.max_deviation_255});
  if (!(load.max_deviation_255 <= kRounding255)) {
    result.failures.push_back(
        fmt::format("deviation = {}/255: must be at most {}/255", load.max_deviation_255, kRounding255));
  }
  return result;
}

Result measure_update(bool quick) {
  const Scale& scale = quick ? kQuick : kFull;
  const auto lights = draw_lights(scale);
  command::Progress progress;
  Result result;
  result.table.columns = {"method",      "fog",       "lights",         "kinds",         "steps",
                          "ms_per_step", "ms_spread", "bytes_per_step", "skipped_share", "max_deviation_255"};
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    const auto add = [&](const std::string& name, double allowed_255, const Record& record) {
      double share = 0;
      for (const double one : record.skipped_shares) share += one / double(scale.steps);
      result.table.rows.push_back(
          {name, name_of(mode), double(scale.lights), double(scale.kinds), double(scale.steps),
           measure::quantile(record.milliseconds, 0.5),
           measure::quantile(record.milliseconds, 0.9) - measure::quantile(record.milliseconds, 0.1),
           double(record.most_bytes), share, record.max_deviation_255});
      if (!(record.max_deviation_255 <= allowed_255)) {
        result.failures.push_back(fmt::format("{} {}: deviation = {}/255: must be at most {}/255", name, name_of(mode),
                                              record.max_deviation_255, allowed_255));
      }
    };
    add("updater", kDefaultSkipBudget255,
        follow_by_updater("updater", kDefaultSkipBudget255, mode, lights, scale, progress));
    add("updater-no-skip", kRounding255, follow_by_updater("updater-no-skip", 0, mode, lights, scale, progress));
    if (mode == FogMode::exp) {
      add("updater-layers", kDefaultSkipBudget255,
          follow_by_updater("updater-layers", kDefaultSkipBudget255, mode, lights, scale, progress, true));
    }
    add("batch-of-all", kRounding255, follow_by_batch("batch-of-all", mode, lights, scale, progress));
  }
  return result;
}

}  // namespace litfog::bench
