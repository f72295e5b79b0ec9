// SPDX-License-Identifier: Apache-2.0
// litfog-bench: measures time against error.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/benchmarks.h"
#include "bench/machine.h"
#include "command/command.h"
#include "command/option_rule.h"
#include "command/output_files.h"
#include "command/plot.h"
#include "command/table.h"
#include "command/uncaught.h"
#include "files/whole_file.h"
#include "litfog/gl/unsupported.h"

namespace {

using namespace litfog::bench;
using namespace litfog::command;

constexpr const char* kExplanation =
    R"(solve: per light, over a mix of 4,096 lights: extent 5 to 5,000 m and visibility 50 to 10,000 m log-uniform;
constant below, at and above 1, linear only, quadratic only and mixed, a third each; threshold 0.05; caches warm.
Methods: Hales's sampling with N = 16 to 1024, as published and in SIMD; Boost.Math's brent_find_minima;
exact, one light per call; batch; and, as a lower bound, a copy of the bytes that the batch reads and writes (five
columns in, one out). -uncached is the same with four million lights. Errors are against a 50-digit reference over the
first 2,000 lights.

airlight: per ray, over 4,000 rays whose airlight is more than 1e-10 of the lamp's colour, in six mixes. point: point
lamps in isotropic fog; C below, at and above 1 and 0, L and Q from 0 over decades; visibility 3 m to 100 km, in one
of twenty fogs 5 cm to 3 m; the eye beside, behind and in the lamp's light, rays of any length. g-0.85, droplets: the
same in exp fog with g = 0.85, and with droplets of 10 micrometres. layers: the same in layers of exp fog. any: two
thirds are spots of 0.1 to 180 degrees, half of the fogs have g from -0.9 to 0.9. inverse-square: C = L = 0, outside the
knee.
Methods: uniform steps from the eye (march) and inside the lamp's sphere and cone only (march-clipped, as PlayCanvas);
litfog; the arctangent form without extinction (Macklin 2010); a closed form by the exponential integral (Pegoraro and
Parker 2009); 256 x 256 tables (Sun et al. 2005); litfog's reference.
Errors are against the reference, relative to the lamp's colour, or to the airlight where that is brighter; p99_relative
is the 99th percentile of the relative error. lamp_leg is 1 if the fog also dims the light on its way from the lamp.

lamps: no times; what an eye sees in exp fog that carries a lamp of data/lights and looks along its axis: the fog colour
intensity (peak), the airlight without and with the lamp's own leg through the fog (k0, k1), and its reference.

scattering: no times; M / (I d^2) for a lamp of I / r^2 in endless fog of density d and albedo 1, in the unit of
airlight, by depth tau = d r between eye and lamp and angle between ray and lamp; one row per phase function and depth.
max_error is the largest relative change in the row when a third of the solution's nodes are left out.

glow: the same lamp's light scattered once (single) and in all orders (all), over nine angles, at depths of 0.3 to 6 in
isotropic fog and in droplets of 10 micrometres. Methods: litfog; a Legendre series (Narasimhan and Nayar 2003), which
converges only beyond a depth of 1; one Gaussian (after Premože et al. 2004); three octaves of single scattering in 16
steps (Wrenninge et al. 2013, as in engines); a random walk of 65,536 paths (walk, with its standard error).
Errors are against the discretised equation of transfer (reference). --strip draws one lamp at six visibilities.

traced: no times; four views of scenes, lit by single scattering and by all orders. The truth is single scattering, with
the shafts of shadow of 32 lamps, plus 128 random paths a pixel, which fog scatters and surfaces reflect and block. The
ratios are quantiles of the luminance over the true one, in squares of 4 x 4 pixels. --strip draws all views.

update: 1,000 steps of visibility, 10,000 m to 50 m and back, with a million lights of 200 kinds, all carried and on.
updater-layers: the same in a layer of droplets, with what all orders of scattering need for each kind.
Methods: updater; updater-no-skip, with a budget of 0; batch-of-all, the float batch over every light, no updater.

load: 216,000 steps with a million lights, as in an hour at 60 per second. Each step changes the visibility and the
time, by which 1,000 lights flash, moves 90 lights, replaces 10 of the 1,000 by lights of new kinds and switches 100.
grown_mib: resident memory at the end minus that after a twentieth of the steps.

fit: per table of 20 samples, over 100 tables per problem: exact; noise-2 and noise-20, off by 2 and 20 %; and, off by
2 %, outliers (one sample in eight off by a factor of 2 to 20), clamped (C below 1), far (10 to 1,000 km) and near (1 to
100 mm). Methods: litfog, proof of the global optimum included; plain Ceres from C = L = Q = 1, bounds at 0. digits: the
fewest in which ln attenuation agrees with the optimum at all samples of any table; the optimum is certified at 50
digits.

render: in exp fog, headlights with 1 to 256 lights at 640x360 by every lighting path of litfog-demo, the default one
also with airlight, with only the base texture (unlit) and, as the rival, with a small forward renderer whose one shader
loops over all lights and skips nothing (plain); with 1 to 16 lights also with nothing skipped, and with 2 at 1280x720.
Every scene with 2 and 16 lights at 1280x720 by unified, legacy and plain, with 1 and 4 samples per pixel, with and
without skipping; with 4 and skipping also with airlight. Frames of all paths are interleaved. Errors are those of the
same picture at 80x45, by airlight at 32x18, against the path's own plain formulas, shaded in double. The picture has
table 1 of Hales 2004.

frames: every scene with all its lamps, as litfog-demo draws it, at 640x360: fog lit by peak, by single scattering
(single), and by all orders (all), frames interleaved; headlights, street and approach also in isotropic fog and with
g = 0.85 (phase). Errors as for render, at 16x9.

rejection: every scene by unified and peak, 640x360, with 2 and 16 lights, 1 and 4 samples per pixel: surfaces by
material (none), from the nearest to the farthest (front-to-back), or after a depth pre-pass (depth-pass), frames
interleaved. layers_passed: how often a sample of the picture passes the depth test, the pre-pass included;
fragments_per_pixel: shader runs by the driver's count. llvmpipe also counts those that it rejects.

maps: no times; headlights by its two headlights in exp2 fog, 320x180, drawn from 3-D range maps and from pairs of 2-D
maps with as many texels, of 16 to 256 texels a side. Errors are against the path's plain formulas, shaded in double.

city: a flight of 300 frames through streets. A light's range is its reach in the fog, and the view ends where fog
hides white. clusters: LightClusters (16 x 9 x 24) at each frame; clusters-one-light: the view stays and one light
changes; clusters-fog: a change of the visibility. frame, 320x180, peak: from the scene's camera with all lights;
frame-of-those: with only the lights that the picture needs (all others change it by at most half a step);
ratio_to_those: the first over the second; frame-airlight: the frame by airlight, with the first 100 to 1000 lamps in
view; frame-flight: the flight with 10,000 lights.

Times are processor time of one thread (render, frames: wall time until a frame is finished; city's frames: processor
time of all threads, a software rasteriser's included, and wall_ms): medians, with the spread from the 10th to the 90th
percentile of the repetitions (solve, airlight, fit), steps (update) or frames (render, frames). Errors ending in _255
are in steps of an 8-bit colour channel.

Examples:
  litfog-bench solve --quick
  litfog-bench solve --csv solve.csv --json solve.json --plot solve.png
  litfog-bench update --isa AVX2 --format json

Exit status: 0 done; 1 wrong command line; 3 a Debug build, no OpenGL, or --plot without gnuplot; 4 output cannot be
written; 5 an error larger than litfog states for itself was found (the results are still written).)";

Result fit([[maybe_unused]] bool quick) {
#ifdef LITFOG_HAS_FIT
  return measure_fit(quick);
#else
  throw MissingCapability("this build has no litfog::fit; configure with -DLITFOG_BUILD_FIT=ON");
#endif
}

template <Result (*kMeasure)(bool)>
Result draw([[maybe_unused]] bool quick) {
#ifdef LITFOG_HAS_GL
  try {
    return kMeasure(quick);
  } catch (const litfog::gl::Unsupported& missing) {
    throw MissingCapability(missing.what());
  }
#else
  throw MissingCapability("this build has no litfog::gl; configure with -DLITFOG_BUILD_GL=ON");
#endif
}

struct Benchmark {
  std::string name;
  const char* meaning;
  Result (*measure)(bool quick);
  bool has_batches = false;
  bool has_figure = false;
  bool has_strip = false;
};
const std::vector<Benchmark> kBenchmarks{
    {"solve", "time against error of every method for a light's fog colour intensity", measure_solve, true, true},
    {"airlight", "time against error of every method for a light's airlight along a ray", measure_airlight, true, true},
    {"lamps", "peak and airlight of four lamps over visibility, beside the reference", measure_lamps, false, true},
    {"scattering", "table of a point lamp's light that fog scatters twice or more", tabulate_scattering},
    {"glow", "the glow around a point lamp over angle: scattered once, all orders, and by a random walk", draw_glow,
     false, true, true},
    {"traced", "scenes lit by single scattering and by all orders, beside traced paths", draw<trace_scenes>, false,
     false, true},
    {"update", "time to follow a visibility step by step over a million lights", measure_update, true},
    {"load", "an hour of changing weather and lights, a million lights: steps and memory", measure_load, true},
    {"fit", "time and quality of fits of an attenuation to a falloff table", fit},
    {"render", "frame time and error of every lighting path, over scenes, lights and sizes", draw<measure_render>,
     false, true},
    {"frames", "frame time and error of every scene: fog lit by peak, by single scattering, and by all orders",
     draw<measure_frames>},
    {"rejection", "frame time and fragments shaded by each way to reject hidden fragments early",
     draw<measure_rejection>},
    {"maps", "memory and error of Hales's light maps over their size", draw<measure_maps>},
    {"city", "cluster lists and frames of a city with 100 to 100,000 lights, at four visibilities", draw<measure_city>,
     true}};

struct Options {
  const Benchmark* benchmark = nullptr;
  std::optional<std::string> json_file;
  std::optional<std::string> csv_file;
  std::optional<std::string> plot_file;
  std::optional<std::string> strip_file;
  std::string isa;
  TableFormat format = TableFormat::text;
  bool quick = false;
};

std::string json_of(const Result& result) {
  return fmt::format("{{\n\"machine\": {},\n\"rows\": {}}}\n", to_json(this_machine(result.gl_renderer)),
                     format_table(result.table, TableFormat::json));
}

/// With the machine in every row, so that the rows of several machines make one file.
std::string csv_of(const Result& result) {
  const Machine machine = this_machine(result.gl_renderer);
  Table table = result.table;
  for (const char* column : {"cpu", "isa", "compiler", "commit", "gl_renderer", "date"}) {
    table.columns.emplace_back(column);
  }
  for (auto& row : table.rows) {
    for (const auto& cell :
         {machine.cpu, machine.isa, machine.compiler, machine.commit, machine.gl_renderer, machine.date}) {
      row.emplace_back(cell);
    }
  }
  return format_table(table, TableFormat::csv);
}

std::string text_of(const Result& result, TableFormat format) {
  switch (format) {
    case TableFormat::csv:
      return csv_of(result);
    case TableFormat::json:
      return json_of(result);
    case TableFormat::text:
      break;
  }
  return format_table(result.table, TableFormat::text);
}

ExitStatus run(const Options& options) {
  if (!is_measurable_build()) {
    throw MissingCapability("a Debug build is not measured; configure with -DCMAKE_BUILD_TYPE=Release");
  }
  // What would fail after minutes fails now.
  if (options.strip_file && !options.strip_file->ends_with(".png")) {
    fail_option("--strip", *options.strip_file, "must end in .png");
  }
#ifndef LITFOG_HAS_GL
  if (options.strip_file) throw MissingCapability("this build draws no pictures; configure with -DLITFOG_BUILD_GL=ON");
#endif
  std::optional<FigureFormat> figure_format;
  if (options.plot_file) {
    figure_format = figure_format_of("--plot", *options.plot_file);
    require_plotter();
  }
  OutputFiles outputs;
  for (const auto& [option, file] : {std::pair{"--json", &options.json_file},
                                     {"--csv", &options.csv_file},
                                     {"--plot", &options.plot_file},
                                     {"--strip", &options.strip_file}}) {
    if (*file) outputs.add(option, **file);
  }
  outputs.expect_no_documents();
  if (!options.isa.empty()) {
    const auto targets = simd_targets();
    if (std::ranges::find(targets, options.isa) == targets.end()) {
      fail_option("--isa", options.isa, fmt::format("must be one of {} on this machine", fmt::join(targets, ", ")));
    }
    limit_simd_target(options.isa);
  }

  const Result result = options.benchmark->measure(options.quick);
  write_standard_output(text_of(result, options.format));
  if (options.csv_file) litfog::files::write_whole_file(*options.csv_file, csv_of(result));
  if (options.json_file) litfog::files::write_whole_file(*options.json_file, json_of(result));
  if (figure_format) litfog::files::write_whole_file(*options.plot_file, draw_figure(result.figure, *figure_format));
#ifdef LITFOG_HAS_GL
  if (options.strip_file) litfog::files::write_whole_file(*options.strip_file, result.strip());
#endif
  for (const std::string& failure : result.failures) fmt::print(stderr, "litfog-bench: {}\n", failure);
  return result.failures.empty() ? kDone : kNotToTolerance;
}

}  // namespace

int main(int argc, char** argv) {
  expect_uncaught();
  Options options;
  std::string description = "Measures litfog and its rivals: time beside error, in the same run.\n\n";
  std::vector<std::pair<std::string, const Benchmark*>> choices;
  for (const Benchmark& each : kBenchmarks) {
    description += fmt::format("  litfog-bench {:<10} {}\n", each.name, each.meaning);
    choices.emplace_back(each.name, &each);
  }
  CLI::App app{description, "litfog-bench"};
  app.footer(kExplanation);
  add_choice(app, "benchmark", options.benchmark, choices, "What to measure")->required();
  app.add_option("--json", options.json_file, "Write machine and rows as JSON")->type_name("FILE");
  app.add_option("--csv", options.csv_file, "Write the rows as CSV, the machine in each")->type_name("FILE");
  app.add_option("--plot", options.plot_file,
                 "Draw time against error (solve, airlight), over visibility (lamps), angle (glow) or lights (render)")
      ->type_name("FILE.png|FILE.svg");
  app.add_option("--strip", options.strip_file,
                 "Draw pictures scattered once, in all orders and by the reference: one lamp at six "
                 "visibilities (glow), or scenes (traced)")
      ->type_name("FILE.png");
  app.add_option("--isa", options.isa,
                 "Batches and cluster lists use no wider SIMD target than this, by Highway's names: AVX3, AVX2, SSE4")
      ->type_name("NAME");
  add_choice<TableFormat>(app, "--format", options.format,
                          {{"table", TableFormat::text}, {"csv", TableFormat::csv}, {"json", TableFormat::json}},
                          "Format on standard output, table if not given");
  app.add_flag("--quick", options.quick, "Fewer lights or tables and shorter runs, to see that it works");
  return run_command(app, argc, argv, [&] {
    const Benchmark& benchmark = *options.benchmark;
    check_options(app, {{benchmark.name, !benchmark.has_batches, {"--isa"}, "it has no batches"},
                        {benchmark.name, !benchmark.has_figure, {"--plot"}, "it has no figure"},
                        {benchmark.name, !benchmark.has_strip, {"--strip"}, "it has no strip"}});
    return run(options);
  });
}
