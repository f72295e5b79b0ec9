// SPDX-License-Identifier: Apache-2.0
// litfog-fit: makes lights from data sheets.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "command/command.h"
#include "command/number.h"
#include "command/option_rule.h"
#include "command/output_files.h"
#include "command/plot.h"
#include "command/printable.h"
#include "command/progress.h"
#include "command/table.h"
#include "command/uncaught.h"
#include "files/angle_deg.h"
#include "files/whole_file.h"
#include "fit/catalogue.h"
#include "fit/data_sheet.h"
#include "fit/fit_record.h"
#include "fit/input_list.h"
#include "fit/light_fit.h"
#include "fit/light_pictures.h"
#include "fit/light_target.h"
#include "fit/outcome.h"
#include "fit/verdict.h"
#include "litfog/files/light_file.h"
#include "litfog/files/light_spec_file.h"
#include "litfog/files/output_error.h"
#include "litfog/input_error.h"
#include "litfog/photometry/cookie_file.h"
#include "model/parallel.h"

using namespace litfog;
using namespace litfog::command;
using namespace litfog::fit;

namespace {

namespace fs = std::filesystem;

constexpr const char* kDescription =
    R"(Makes a light from its data sheet: the constants C, L, Q of its attenuation 1 / (C + L r + Q r^2), and a cone.

  litfog-fit SPEC.json|FILE.ies|FILE.ldt|FILE.csv  [-o LIGHT.json] [--plot FILE.png|.svg] [OPTIONS]
  litfog-fit INPUT INPUT...                [-o FOLDER]    [OPTIONS]
  litfog-fit INPUT...                      --catalogue FOLDER [OPTIONS]
  litfog-fit INPUT --against INPUT         [--plot FILE.png|.svg] [OPTIONS]
)";

constexpr const char* kExplanation =
    R"(A light spec is JSON. State what is known; a spec needs range or cone, everything else is optional:

  {"litfog": "light-spec", "version": 1, "name": "landing lamp",
   "source": "the maker's data sheet", "color": [1, 0.9, 0.8],
   "range": {"extent_m": 450, "threshold": 0.05,
             "samples": [{"range_m": 100, "attenuation": 0.5}, {"range_m": 300, "attenuation": 0.1}]},
   "cone": {"beam_angle_deg": 11, "field_angle_deg": 22}}

Range. extent_m is where the attenuation reaches the threshold (0.05 if not given); it is met exactly. Instead, peak_cd,
illuminance {"range_m", "lx"} (or an array of them) or flux_lm puts the extent where the light gives end_lx (1 if not
given). end_lx is a number or an eye's threshold: dark night (a mariner's), night, twilight, day or bright day (a
pilot's). constant fixes C.
samples are a falloff table; the fit minimises sum weight * (ln a(r) - ln attenuation)^2 with C, L, Q >= 0. An extent
alone is met by C = 1 and the family: quadratic (if not given), linear or mixed.

Cone. beam_angle_deg and field_angle_deg are the full angles at 50 % and 10 % of the peak; for an elliptical beam each
is [horizontal, vertical]. Cones are round: the cone is fitted to circles of the same solid angle, so that it has the
beam's flux; the error is stated, and --cookie keeps the ellipse. samples have angle_deg from the axis and intensity in
any unit; half_angle_deg is where the light ends; photometry names a photometric file instead of samples. The fit
minimises sum weight * (cone - intensity/peak)^2. profile is one of --profile's; with best, all are fitted and shown,
and the light has the best one.

Color. color is linear RGB; color_temperature_k may replace it. Candela are for a color of luminance 1.

Source. source_radius_m is the radius of the lamp's luminous disc, 0.05 if not given: near the lamp the light gives
I / (r^2 + R^2). A falloff table already states the brightness near the lamp, so with one the radius is 0 if not given.

--details shows step by step, as "derived", what is derived from these figures. The light's "source" keeps it.

A photometric file (IES LM-63 of any edition, EULUMDAT, TM-33, GLDF, or an isocandela table) needs no spec. The cone is
fitted to the mean intensity about the axis at the file's own angles, each of weight 1. The light is white; it ends, at
the threshold 0.05, where its peak gives 1 lx; its source radius is that of a disc with the luminous opening's area. The
peak is the largest mean about the axis, so that the light has the beam's flux. With --cookie it is the largest
intensity: a light written with --cookie is for its cookie. A spec with photometry and no range also ends at 1 lx. With
a range, its peak_cd, illuminance or flux_lm scales the intensities, which may then be percentages. Angles that the file
does not state are dark.

A light of I cd has C = 1, no L, and Q = 20 lx * size / I: a color of 1 is 20 lx. size = end_lx / (20 lx * threshold)
multiplies the color, so that the light gives end_lx where its attenuation is the threshold.

The axis is the photometric one (down), its opposite if the peak lies above the horizon, or the peak of a beam aimed
elsewhere. --details says which, and --axis moves it: for an isocandela table in degrees to the right and above,
otherwise by the file's two angles. --details also says how far a beam is from rotational symmetry, and --cookie keeps
its shape as a cube map.

A beam may have a hot spot in a wide spill; one cone then leaves out much of the flux. --spill fits two cones about the
axis, whose sum is nearest to the beam, and writes two lights: put both at the lamp's position.

An isocandela table is CSV with commas, or with semicolons and decimal commas; lines with # are comments, of which the
first names the light. It is a grid of candela, with degrees to the right and above,
  vertical_deg,-10,-5,0,5,10
  5,300,1200,2000,1200,300
  0,400,1500,2500,1500,400
or ellipses from the inner to the outer, with half axes in degrees; it is dark beyond the last. A standard's ellipses
are minima; a lamp may be brighter:
  candela,horizontal_deg,vertical_deg
  5000,7,5
  500,11.5,6

The optimum is global, and --details proves it by a lower bound on every other light's objective. The best light may
still be poor; the verdict says how well it follows the data. Its largest errors are
)";

constexpr const char* kExamples = R"(
Examples:
  litfog-fit landing-lamp.json                                the report, in 15 lines; --details has more
  litfog-fit landing-lamp.json -o light.json --plot fit.png   the light, which litfog-solve and litfog-demo read
  litfog-fit flood.ies -o flood.json --cookie flood.exr --cookie-size 128
  litfog-fit spot.ies -o spot.json --spill spot-spill.json    a beam with a hot spot and a spill
  litfog-fit specs/*.json lamps/*.ldt -o lights               one light each, and a table of all
  litfog-fit lamps --catalogue catalogue --format csv         all of a folder: pictures, a page, a table as CSV
  litfog-fit landing-lamp --against my-lamp.ies --plot both.png

Exit status: 0 done; 1 wrong command line; 2 bad input, named file:line:column on standard error; 3 --plot without
gnuplot; 4 output cannot be written; 5 a poor light, a target that cannot be met, or an optimum that is not proven: the
best light is written. With several inputs it is the worst status.)";

struct Options {
  std::vector<std::string> inputs;
  std::string output;
  std::string against;
  std::string catalogue;
  FitChoices choices;
  bool has_details = false;
  bool is_forced = false;
  std::string plot;
  std::string cookie;
  std::string spill;
  TableFormat format = TableFormat::text;
};

bool is_spec(const std::string& path) { return ending_of(path) == ".json"; }

/// From harmless to grave.
int gravity(ExitStatus status) {
  switch (status) {
    case kDone:
      return 0;
    case kNotToTolerance:
      return 1;
    case kBadInput:
      return 2;
    default:
      return 3;
  }
}

// --- before anything is fitted ---

/// What an input has for options to change. What cannot be read may have anything: its error comes later.
struct Traits {
  bool has_falloff_table = true, has_cone = true, has_luminaire = true;
  std::optional<std::string> photometry = std::nullopt;  // the file that a spec names
};

Traits traits_of(const Input& input) try {
  if (input.error) return {};
  if (!is_spec(input.path)) return {.has_falloff_table = false};
  const LightSpec spec = read_light_spec(input.path);
  return {.has_falloff_table = spec.range && !spec.range->samples.empty(),
          .has_cone = spec.cone.has_value(),
          .has_luminaire = spec.cone && spec.cone->photometry,
          .photometry = spec.cone ? spec.cone->photometry : std::nullopt};
} catch (const std::exception&) {
  return {};
}

/// Options that the inputs give nothing to do.
void expect_effect(const CLI::App& app, const std::vector<Input>& inputs, const std::vector<Traits>& traits) {
  constexpr std::array kOptions{std::tuple("--robust", &Traits::has_falloff_table, "there is no falloff table"),
                                std::tuple("--profile", &Traits::has_cone, "there is no cone to fit"),
                                std::tuple("--axis", &Traits::has_luminaire, "there is no photometric file"),
                                std::tuple("--tilt", &Traits::has_luminaire, "there is no photometric file")};
  for (const auto& [option, member, reason] : kOptions) {
    if (app.count(option) == 0) continue;
    const std::string all = inputs.size() == 1 ? inputs.front().path : "these inputs";
    check_options(app, {{all, std::ranges::none_of(traits, member), {option}, reason}});
  }
}

/// Where each input's light goes, empty for nowhere. Makes the folder of several where it is missing.
std::vector<std::string> outputs_of(const Options& options, const std::vector<Input>& inputs,
                                    const std::optional<Catalogue>& catalogue) {
  std::error_code error;
  if (inputs.size() > 1 && !options.output.empty()) {
    const fs::path folder(options.output);
    if (folder.extension() != ".json" && !fs::exists(folder, error)) fs::create_directory(folder, error);
    if (error) throw OutputError(fmt::format("{}: cannot be made: {}", options.output, error.message()));
    if (!fs::is_directory(folder, error)) fail_option("-o", options.output, "must be a folder for several inputs");
  }
  const bool is_folder = fs::is_directory(options.output, error);
  std::vector<std::string> outputs;
  for (const Input& input : inputs) {
    if (input.error) {
      outputs.emplace_back();
    } else if (catalogue) {
      outputs.push_back(catalogue->light_path(input));
    } else {
      outputs.push_back(is_folder ? (fs::path(options.output) / (input.name + ".json")).string() : options.output);
    }
  }
  return outputs;
}

/// The later of two inputs of one name gets an error: a catalogue would have one lamp's files for both.
void expect_names_apart(std::vector<Input>& inputs) {
  std::map<std::string, std::string> path_of;
  for (Input& input : inputs) {
    if (input.error) continue;
    const auto [first, is_new] = path_of.emplace(input.name, input.path);
    if (is_new) continue;
    input.error = std::make_exception_ptr(
        InputError({.file = input.path}, "name in the catalogue", input.name, "must not be that of " + first->second));
  }
}

OutputFiles files_to_write(const Options& options, const std::vector<Input>& inputs, const std::vector<Traits>& traits,
                           const std::vector<std::string>& outputs) {
  OutputFiles files;
  for (const std::string& output : outputs) {
    if (!output.empty()) files.add(options.catalogue.empty() ? "-o" : "--catalogue", output);
  }
  for (const auto& [option, picture] : {std::pair{"--plot", &options.plot}, {"--cookie", &options.cookie}}) {
    if (picture->empty()) continue;
    files.add(option, *picture);
    if (!options.is_forced) expect_picture_or_nothing(*picture);
  }
  if (!options.spill.empty()) files.add("--spill", options.spill);
  for (const Input& input : inputs) files.expect_apart_from(input.path);
  for (const Traits& trait : traits) {
    if (trait.photometry) files.expect_apart_from(*trait.photometry);
  }
  return files;
}

// --- one input ---

LightTarget read(const Input& input, const FitChoices& choices) {
  LightTarget target = input.container       ? target_of(input.container->read(input.path), input.path, choices)
                       : is_spec(input.path) ? read_spec(input.path, choices)
                                             : read_photometric_spec(input.path, choices);
  if (choices.cookie_size > 0 && !target.luminaire && target.ellipses.empty()) {
    throw InputError({input.path, 1, 1}, "cone.photometry", "",
                     "must be given for a cookie, or the angles of an elliptical beam");
  }
  if (choices.has_spill && !(target.luminaire && target.end_illuminance && target.range->samples.empty())) {
    throw InputError({input.path, 1, 1}, "cone.photometry", "",
                     "must be given for two lights, with a range that states no extent_m and no samples");
  }
  return target;
}

std::string text_of(const LightFit& fit) {
  std::vector<std::string> source = fit.target.source;
  source.insert(source.end(), fit.target.derived.begin(), fit.target.derived.end());
  return format_light(fit.light, source, fit_record(fit));
}

/// Puts two lights in the place of one.
void split(Outcome& outcome) {
  outcome.two = fit_two_lights(*outcome.fit);
  if (!outcome.two) throw InputError({.file = outcome.input.path}, "must have a beam with a spill for two lights");
  outcome.light = text_of(outcome.two->hot_spot);
  outcome.spill = text_of(outcome.two->spill);
  outcome.verdict = judge(*outcome.two);
}

/// Throws the usage error of an output that is one of the files that the input names.
Outcome fit(const Options& options, const Input& input, const std::string& output, const OutputFiles& files) {
  Outcome outcome;
  outcome.input = input;
  outcome.output = output;
  try {
    if (input.error) std::rethrow_exception(input.error);
    LightTarget target = read(input, options.choices);
    for (const std::string& file : files_of(input, target)) files.expect_apart_from(file);
    for (const std::string& light : {output, options.spill}) {
      if (options.catalogue.empty() && !options.is_forced && !light.empty()) expect_fitted_light_or_nothing(light);
    }
    const LightFit& fitted = outcome.fit.emplace(fit_light(std::move(target)));
    outcome.light = text_of(fitted);
    outcome.verdict = judge(fitted);
    if (options.choices.has_spill) split(outcome);
    outcome.advice = advice_on(fitted, outcome.two, options.choices,
                               [&input](const FitChoices& other) { return read(input, other); });
    const bool is_proven =
        outcome.two ? outcome.two->hot_spot.is_proven() && outcome.two->spill.is_proven() : fitted.is_proven();
    if (!is_proven || outcome.verdict->grade == Grade::poor) outcome.status = kNotToTolerance;
  } catch (...) {
    fail(outcome);
  }
  return outcome;
}

Summary summarise(Outcome& outcome, bool has_report) try { return summary_of(outcome, has_report); } catch (...) {
  fail(outcome);
  return summary_of(outcome, has_report);
}

void write_light(const Outcome& outcome) {
  if (outcome.fit && !outcome.output.empty()) files::write_whole_file(outcome.output, outcome.light);
}

// --- all inputs ---

/// Outcomes are kept whole where they are few: for a report, a figure or a cookie.
struct Results {
  std::vector<Summary> summaries;
  std::vector<Outcome> outcomes;
};

/// Inputs as they are done, by any thread.
class FitProgress {
 public:
  explicit FitProgress(std::size_t count) : count_(count) { progress_.show(fmt::format("fitting 1 of {}", count)); }

  void add(const Input& input) {
    const std::scoped_lock lock(mutex_);
    progress_.show(fmt::format("{} of {}: {}", ++done_, count_, input.path));
  }

 private:
  std::size_t count_;
  std::size_t done_ = 0;
  std::mutex mutex_;
  Progress progress_;
};

Results fit_all(const Options& options, const std::vector<Input>& inputs, const std::vector<std::string>& outputs,
                const OutputFiles& files, bool keeps_outcomes) {
  const bool has_report = options.format == TableFormat::json;
  Results results{.summaries = std::vector<Summary>(inputs.size()),
                  .outcomes = std::vector<Outcome>(keeps_outcomes ? inputs.size() : 0)};
  FitProgress progress(inputs.size());
  for_each_in_parallel(inputs.size(), [&](std::size_t i) {
    Outcome outcome = fit(options, inputs[i], outputs[i], files);
    if (!keeps_outcomes) {
      try {
        write_light(outcome);
      } catch (...) {
        fail(outcome);
      }
    }
    results.summaries[i] = summarise(outcome, has_report);
    if (keeps_outcomes) results.outcomes[i] = std::move(outcome);
    progress.add(inputs[i]);
  });
  return results;
}

/// Adds lamps to a catalogue: together or, where that fails, one by one, so that an error of one is that lamp's alone.
void add_lamps(const Catalogue& catalogue, std::vector<Outcome>& outcomes) {
  std::vector<const Outcome*> lamps;
  for (const Outcome& outcome : outcomes) {
    if (outcome.fit) lamps.push_back(&outcome);
  }
  try {
    if (!lamps.empty()) catalogue.add(lamps);
  } catch (const std::exception&) {
    for (Outcome& outcome : outcomes) {
      if (!outcome.fit) continue;
      try {
        catalogue.add({&outcome});
      } catch (...) {
        fail(outcome);
      }
    }
  }
}

/// Fits a few inputs at a time: they share a run of gnuplot.
Results fill_catalogue(const Options& options, const std::vector<Input>& inputs,
                       const std::vector<std::string>& outputs, const OutputFiles& files, const Catalogue& catalogue) {
  constexpr std::size_t kMaxTogether = 32, kMinTurns = 16;
  const std::size_t together = std::clamp<std::size_t>(inputs.size() / kMinTurns, 1, kMaxTogether);
  Results results{.summaries = std::vector<Summary>(inputs.size()), .outcomes = {}};
  FitProgress progress(inputs.size());
  for_each_in_parallel((inputs.size() + together - 1) / together, [&](std::size_t turn) {
    const std::size_t first = turn * together, last = std::min(first + together, inputs.size());
    std::vector<Outcome> outcomes;
    for (std::size_t i = first; i < last; ++i) outcomes.push_back(fit(options, inputs[i], outputs[i], files));
    add_lamps(catalogue, outcomes);
    for (std::size_t i = first; i < last; ++i) {
      results.summaries[i] = summarise(outcomes[i - first], true);
      progress.add(inputs[i]);
    }
  });
  return results;
}

void write_kept(const Options& options, const std::vector<Outcome>& outcomes) {
  std::vector<const LightFit*> fits;
  for (const Outcome& outcome : outcomes) {
    if (outcome.fit) fits.push_back(&*outcome.fit);
  }
  const bool is_whole = fits.size() == outcomes.size();
  std::string figure;
  if (!options.plot.empty() && is_whole) {
    figure = draw_figure(fit_figure(fits), figure_format_of("--plot", options.plot));
  }
  for (const Outcome& outcome : outcomes) {
    write_light(outcome);
    if (outcome.two) files::write_whole_file(options.spill, outcome.spill);
  }
  if (!figure.empty()) files::write_whole_file(options.plot, figure);
  if (!options.cookie.empty() && is_whole) {
    files::write_whole_file(options.cookie, format_cookie(*fits.front()->cookie));
  }
}

std::string report_of(const Options& options, const Results& results) {
  const auto& [summaries, outcomes] = results;
  if (options.format == TableFormat::json) {
    std::string text;
    for (const Summary& summary : summaries) text += (text.empty() ? "[\n" : ",\n") + summary.report;
    return text + "\n]\n";
  }
  if (options.format == TableFormat::text && std::ranges::all_of(outcomes, &Outcome::has_light)) {
    if (outcomes.size() == 2) return format_comparison(outcomes[0], outcomes[1]);
    if (outcomes.size() == 1) {
      return format_report(outcomes[0]) + (options.has_details ? format_details(outcomes[0]) : "");
    }
  }
  Table table{.columns = summary_columns()};
  for (const Summary& summary : summaries) table.rows.push_back(summary.row);
  return format_table(table, options.format);
}

ExitStatus run(const CLI::App& app, const Options& options) {
  std::vector<Input> inputs = list_inputs(options.inputs);
  if (!options.catalogue.empty()) expect_names_apart(inputs);
  const bool is_pair = !options.against.empty();
  if (is_pair && inputs.size() != 2) {
    fail_option("--against", options.against, "must be one light, and so must the input");
  }
  const char* const several = is_pair ? "--against" : "several inputs";
  check_options(
      app, {{several, inputs.size() > 1 && !is_pair, {"--plot"}, "it shows a single light"},
            {several, inputs.size() > 1, {"--cookie"}, "it shows a single light"},
            {several, inputs.size() > 1, {"--spill"}, "it is of a single beam"},
            {several, inputs.size() > 1, {"--details"}, "it shows a single light"},
            {"no output", (options.output + options.plot + options.cookie).empty(), {"--force"}, "it replaces files"}});
  if (!options.plot.empty()) figure_format_of("--plot", options.plot);
  if (!options.cookie.empty() && fs::path(options.cookie).extension() != ".exr") {
    fail_option("--cookie", options.cookie, "must end in .exr");
  }
  std::vector<Traits> traits;
  for (const Input& input : inputs) traits.push_back(traits_of(input));
  expect_effect(app, inputs, traits);
  std::optional<Catalogue> catalogue;
  if (!options.catalogue.empty()) catalogue.emplace(options.catalogue, inputs);
  const std::vector<std::string> outputs = outputs_of(options, inputs, catalogue);
  const OutputFiles files = files_to_write(options, inputs, traits, outputs);
  if (!options.plot.empty() || catalogue) require_plotter();

  const bool keeps_outcomes = inputs.size() == 1 || is_pair;
  const Results results = catalogue ? fill_catalogue(options, inputs, outputs, files, *catalogue)
                                    : fit_all(options, inputs, outputs, files, keeps_outcomes);
  write_kept(options, results.outcomes);
  if (catalogue) catalogue->write_page(inputs, results.summaries);
  ExitStatus worst = kDone;
  for (const Summary& summary : results.summaries) {
    if (gravity(summary.status) > gravity(worst)) worst = summary.status;
    for (const std::string& message : summary.messages) fmt::print(stderr, "{}\n", printable(message));
  }
  // A single input with an error has nothing to show.
  if (inputs.size() > 1 || gravity(worst) < gravity(kBadInput)) write_standard_output(report_of(options, results));
  return worst;
}

CLI::Option* add_axis(CLI::App& app, AxisChoice& choice) {
  using Kind = AxisChoice::Kind;
  const auto parse = [&choice](const CLI::results_t& values) {
    const std::string& text = values.front();
    for (const auto& [word, kind] : {std::pair{"peak", Kind::peak}, {"down", Kind::down}, {"up", Kind::up}}) {
      if (text != word) continue;
      choice = {kind};
      return true;
    }
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto angle = [&](std::string_view part) {
      const auto number = parse_number(part);
      if (!number || !(std::abs(*number) <= 360)) {
        fail_option("--axis", text, "must be peak, down, up or two angles H,V in degrees, each from -360 to 360");
      }
      return files::radians(*number);
    };
    const std::string_view view = text;
    choice = {Kind::given, angle(view.substr(0, comma)), angle(view.substr(std::min(comma + 1, view.size())))};
    return true;
  };
  return app
      .add_option("--axis", parse,
                  "Axis of a photometric file's cone and cookie: the peak, the photometric axis, its opposite, or a "
                  "direction in the file's angles")
      ->type_name("peak|down|up|H,V");
}

}  // namespace

int main(int argc, char** argv) {
  expect_uncaught();
  Options options;
  CLI::App app{kDescription, "litfog-fit"};
  app.footer(kExplanation + fit::grade_table() + kExamples);
  app.add_option("input", options.inputs,
                 "Light specs (.json), photometric files (.ies, .ldt, .csv, .xml, .gldf), folders of them, "
                 "names of bundled lights")
      ->type_name("FILE...")
      ->required();
  app.option_defaults()->group("Fit");
  std::optional<ConeProfile> profile;
  std::vector<std::pair<std::string, std::optional<ConeProfile>>> profiles;
  std::string meanings;
  for (const ConeProfileFacts& facts : kConeProfiles) {
    if (fitted_parameters(facts.profile).empty()) continue;
    profiles.emplace_back(facts.name, facts.profile);
    meanings += std::string("; ") + facts.name + " is " + facts.meaning;
  }
  profiles.emplace_back("best", std::nullopt);
  add_choice<std::optional<ConeProfile>>(app, "--profile", profile, profiles,
                                         "Cone profile, instead of the spec's own" + meanings);
  app.add_flag("--robust", options.choices.is_robust, "For measured falloff tables: outliers count less");
  add_axis(app, options.choices.axis);
  double tilt_deg = 0;
  constexpr NumberRule kTiltRule{[](double x) { return x >= 0 && x <= 180; }, "must be a number from 0 to 180", 0, 180};
  add_number(app, "--tilt", tilt_deg, kTiltRule,
             "The mounted luminaire's tilt in degrees, for files with tilt data; 0 if not given");
  app.option_defaults()->group("Output");
  CLI::Option* const output = app.add_option("-o,--output", options.output,
                                             "Write the light here; only a fitted light is replaced. With several "
                                             "inputs, write NAME.json each into this folder, made if missing")
                                  ->type_name("FILE|FOLDER");
  app.add_flag("--force", options.is_forced,
               "Let the light, the spill, the plot and the cookie replace files of other kinds");
  app.add_option("--catalogue", options.catalogue,
                 "Write the lights, their pictures and a page with all of them, index.html, into this folder")
      ->type_name("FOLDER");
  app.add_option("--plot", options.plot, "Draw targets, fits and errors over range and angle")
      ->type_name("FILE.png|FILE.svg");
  CLI::Option* const cookie =
      app.add_option("--cookie", options.cookie,
                     "Write a measured or elliptical beam as a cube map, its six faces in a column")
          ->type_name("FILE.exr");
  int cookie_size = kUnstatedCookieSize;
  add_integer(app, "--cookie-size", cookie_size, 1, kMaxCookieSize, "Edge of a face in texels, 256 if not given")
      ->needs(cookie);
  app.add_option("--spill", options.spill,
                 "Write a photometric file's beam as two lights at one position: its hot spot to -o, its spill here")
      ->type_name("FILE.json")
      ->needs(output);
  app.add_option("--against", options.against, "Compare with this input in one table and one plot")->type_name("INPUT");
  app.add_flag("--details", options.has_details,
               "Report more about a single input: derived figures, each sample's error, and the proof of the optimum");
  add_choice<TableFormat>(app, "--format", options.format,
                          {{"text", TableFormat::text}, {"csv", TableFormat::csv}, {"json", TableFormat::json}},
                          "Format of the report or, with several inputs, the table: text if not given");
  return run_command(app, argc, argv, [&] {
    for (const auto& [option, value] : {std::pair{"-o", &options.output},
                                        {"--against", &options.against},
                                        {"--catalogue", &options.catalogue},
                                        {"--plot", &options.plot},
                                        {"--cookie", &options.cookie},
                                        {"--spill", &options.spill}}) {
      if (app.count(option) > 0 && value->empty()) fail_option(option, "", "must not be empty");
    }
    if (!options.cookie.empty()) options.choices.cookie_size = cookie_size;
    options.choices.has_spill = !options.spill.empty();
    if (app.count("--profile") > 0) options.choices.profile = profile;
    options.choices.tilt = files::radians(tilt_deg);
    check_options(app,
                  {{"--spill", options.choices.has_spill, {"--plot", "--cookie", "--details"}, "they show one light"},
                   {"--format csv or json", options.format != TableFormat::text, {"--details"}, "json has all"},
                   {"--catalogue",
                    !options.catalogue.empty(),
                    {"-o", "--force", "--plot", "--cookie", "--spill", "--against"},
                    "its folder holds the lights and their pictures"}});
    if (!options.against.empty()) options.inputs.push_back(options.against);
    return run(app, options);
  });
}
