// SPDX-License-Identifier: Apache-2.0
// litfog-fit: makes lights from data sheets.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "command/command.h"
#include "command/number.h"
#include "command/option_rule.h"
#include "command/output_files.h"
#include "command/plot.h"
#include "command/progress.h"
#include "command/table.h"
#include "files/angle_deg.h"
#include "files/json_text.h"
#include "files/whole_file.h"
#include "fit/beam_data.h"
#include "fit/data_sheet.h"
#include "fit/fit_figure.h"
#include "fit/fit_record.h"
#include "fit/light_fit.h"
#include "fit/light_target.h"
#include "fit/verdict.h"
#include "litfog/attenuation.h"
#include "litfog/files/light_file.h"
#include "litfog/input_error.h"
#include "litfog/photometry/cookie_file.h"

using namespace litfog::command;
using namespace litfog::fit;

namespace {

namespace fs = std::filesystem;
using litfog::ConeChoice;

constexpr const char* kDescription =
    R"(Makes a light from its data sheet: the constants C, L, Q of its attenuation 1 / (C + L r + Q r^2), and a cone.

  litfog-fit SPEC.json|FILE.ies|FILE.ldt|FILE.csv  [-o LIGHT.json] [--plot FILE.png|.svg] [OPTIONS]
  litfog-fit INPUT INPUT...                -o FOLDER      [OPTIONS]
)";

constexpr const char* kExplanation =
    R"(A light spec is JSON. Give it what is known; every member but range or cone may be left out:

  {"litfog": "light-spec", "version": 1, "name": "landing lamp",
   "source": "the maker's data sheet", "color": [1, 0.9, 0.8],
   "range": {"extent_m": 450, "threshold": 0.05,
             "samples": [{"range_m": 100, "attenuation": 0.5}, {"range_m": 300, "attenuation": 0.1}]},
   "cone": {"beam_angle_deg": 11, "field_angle_deg": 22}}

Range. extent_m is where the attenuation is to be the threshold (0.05 if not given) and is met exactly. In its place
peak_cd, illuminance {"range_m", "lx"} or flux_lm puts it where the light gives 1 lx, or end_lx: a number, or what an eye
just sees: dark night (a mariner's), night, twilight, day or bright day (a pilot's). constant fixes C. samples are a
falloff table; the fit minimises sum weight * (ln a(r) - ln attenuation)^2 with C, L, Q >= 0. An extent alone is met by
C = 1 and the family: quadratic (if not given), linear or mixed.

Cone. beam_angle_deg and field_angle_deg are the full angles at 50 % and 10 % of the peak; of an elliptical beam either
is [horizontal, vertical]. Cones are round: the cone is fitted to the circles of the same solid angle, so that it has
the beam's flux, the error is told, and --cookie keeps the ellipse. samples are angle_deg from the axis and intensity in
any unit; half_angle_deg is where the light ends; photometry names a photometric file in place of samples. The fit
minimises sum weight * (cone - intensity/peak)^2. profile is cosine (cos^S u for u < H), smoothstep (inner to outer), or
best: both are fitted and shown, the better one is the light's.

Color. color is linear RGB; color_temperature_k may stand in its place.

What is made of these figures is shown step by step, as "derived", and is kept in the light's "source".

A photometric file (IES LM-63 of any edition, EULUMDAT, or an isocandela table) is a light without a spec: its cone is
fitted to the intensities at the file's own angles, each of weight 1, as the mean over the turn about the axis; it is
white; and it ends, at the threshold 0.05, where its peak gives 1 lx: C = 1, Q = (1/0.05 - 1) / (peak in cd / 1 lx). A
spec with photometry and no range ends there, too. Angles that the file does not state are dark. The axis is the
photometric one, down, or its opposite where the peak lies above the horizon, or the peak of a beam aimed elsewhere, and
is told; --axis moves it. A beam that is not rotationally symmetric is reported with a measure of it, and --cookie keeps
its shape as a cube map.

An isocandela table is CSV, lines with # are comments. It is a grid of candela, with degrees to the right and above,
  vertical_deg,-10,-5,0,5,10
  5,300,1200,2000,1200,300
  0,400,1500,2500,1500,400
or ellipses from the inner to the outer, with their half axes in degrees, beyond the last of which it is dark:
  candela,horizontal_deg,vertical_deg
  5000,7,5
  500,11.5,6

The optimum is the global one and is shown to be: the report has the bound below which nothing is. The best light may
still be a bad one; the verdict says how well it follows the data. Its largest errors are
                                        good    fair, else it is poor
  attenuation, rms, and largest      5, 15 %    20, 50 %
  cone, rms, of the peak                 5 %    10 %
  flux                                  10 %    33 %
  angle at 50 %                         10 %    25 %
  angle at 10 %                         15 %    40 %
  asymmetry of the beam                 0.15    0.4

Examples:
  litfog-fit landing-lamp.json                                the report
  litfog-fit landing-lamp.json -o light.json --plot fit.png   the light, which litfog-solve and litfog-demo read
  litfog-fit flood.ies -o flood.json --cookie flood.exr --cookie-size 128
  litfog-fit specs/*.json lamps/*.ldt -o lights               a light each, and a table of all

Exit status: 0 done; 1 wrong command line; 2 bad input, named file:line:column on standard error; 3 --plot without
gnuplot; 4 output cannot be written; 5 a poor light, a target that cannot be met, or an optimum that could not be shown:
the best light is written. Of several inputs the worst.)";

struct Options {
  std::vector<std::string> inputs;
  std::string output;
  FitChoices choices;
  bool is_robust = false;
  std::string plot;
  std::string cookie;
  int cookie_size = 256;
  bool is_reproducible = false;
  TableFormat format = TableFormat::text;
};

/// One input and what became of it.
struct Outcome {
  std::string input;
  std::string output;  ///< empty for none
  std::optional<LightTarget> target;
  std::optional<LightFit> fit;
  std::optional<Verdict> verdict;  ///< of the fit
  std::string light;               ///< text of its file
  std::string reason;              ///< why there is none
  ExitStatus status = kDone;
};

bool is_spec(const std::string& path) { return fs::path(path).extension() == ".json"; }

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

/// Options that the inputs, all of them read, give nothing to do.
std::vector<OptionRule> rules_of(const std::vector<Outcome>& outcomes) {
  const auto has_none = [&outcomes](const auto& has) {
    return std::ranges::none_of(outcomes,
                                [&has](const Outcome& outcome) { return !outcome.target || has(*outcome.target); });
  };
  const std::string inputs = outcomes.size() == 1 ? outcomes.front().input : "these inputs";
  return {{inputs,
           has_none([](const LightTarget& target) { return target.range && !target.range->samples.empty(); }),
           {"--robust"},
           "there is no falloff table"},
          {inputs,
           has_none([](const LightTarget& target) { return target.cone.has_value(); }),
           {"--profile"},
           "there is no cone to fit"},
          {inputs,
           has_none([](const LightTarget& target) { return target.luminaire.has_value(); }),
           {"--axis"},
           "there is no photometric file"}};
}

/// Where each input's light goes.
std::vector<Outcome> plan(const Options& options) {
  std::error_code error;
  const bool is_folder = fs::is_directory(options.output, error);
  if (options.inputs.size() > 1 && !options.output.empty() && !is_folder) {
    fail_option("-o", options.output, "must be a folder for several inputs");
  }
  std::map<fs::path, std::set<fs::path>> names_of_stem;
  for (const std::string& input : options.inputs) {
    names_of_stem[fs::path(input).stem()].insert(fs::path(input).filename());
  }
  std::vector<Outcome> outcomes;
  for (const std::string& input : options.inputs) {
    if (input.empty()) fail_option("input", input, "must not be empty");
    Outcome& outcome = outcomes.emplace_back();
    outcome.input = input;
    if (options.output.empty()) continue;
    const fs::path path(input);  // lamp.ies beside lamp.ldt: lamp.ies.json
    const fs::path name = names_of_stem[path.stem()].size() > 1 ? path.filename() : path.stem();
    outcome.output = is_folder ? (fs::path(options.output) / name).string() + ".json" : options.output;
  }
  return outcomes;
}

OutputFiles outputs_of(const Options& options, const std::vector<Outcome>& outcomes) {
  OutputFiles outputs;
  for (const Outcome& outcome : outcomes) {
    if (!outcome.output.empty()) outputs.add("-o", outcome.output);
  }
  if (!options.plot.empty()) outputs.add("--plot", options.plot);
  if (!options.cookie.empty()) outputs.add("--cookie", options.cookie);
  for (const Outcome& outcome : outcomes) outputs.expect_apart_from(outcome.input);
  return outputs;
}

void read(const Options& options, Outcome& outcome) try {
  LightTarget target = is_spec(outcome.input) ? read_spec(outcome.input, options.choices)
                                              : read_photometric_spec(outcome.input, options.choices);
  if (!options.cookie.empty() && !target.luminaire && target.ellipses.empty()) {
    throw litfog::InputError({.file = outcome.input}, "cone.photometry", "",
                             "must be given for a cookie, or the angles of an elliptical beam");
  }
  outcome.target = std::move(target);
} catch (const litfog::InputError& error) {
  outcome.reason = error.what();
  outcome.status = kBadInput;
}

/// The same for the files that an input names.
void expect_apart_from_files_of(const LightTarget& target, const OutputFiles& outputs) {
  if (!target.luminaire) return;
  outputs.expect_apart_from(target.luminaire->file);
  const auto& tilt = target.luminaire->tilt;
  if (tilt && !tilt->file.empty()) outputs.expect_apart_from(tilt->file);
}

void fit(const Options& options, Outcome& outcome) {
  outcome.fit = fit_light(std::move(*outcome.target), options.is_robust);
  std::vector<std::string> source = outcome.fit->target.source;
  source.insert(source.end(), outcome.fit->target.derived.begin(), outcome.fit->target.derived.end());
  outcome.light = litfog::format_light(outcome.fit->light, source, fit_record(*outcome.fit, !options.is_reproducible));
  outcome.verdict = judge(*outcome.fit);
  if (!outcome.fit->is_proven() || outcome.verdict->grade == Grade::poor) outcome.status = kNotToTolerance;
}

void write(const Options& options, const Outcome& outcome, std::optional<FigureFormat> figure_format) {
  std::string figure;
  if (figure_format) figure = draw_figure(fit_figure({&*outcome.fit}), *figure_format);
  if (!outcome.output.empty()) litfog::files::write_whole_file(outcome.output, outcome.light);
  if (figure_format) litfog::files::write_whole_file(options.plot, figure);
  if (!options.cookie.empty()) {
    const auto cookie = bake_cookie(*outcome.fit->beam(), options.cookie_size, outcome.fit->target.axis);
    litfog::files::write_whole_file(options.cookie, format_cookie(cookie));
  }
}

std::string status_of(const Outcome& outcome) {
  if (!outcome.fit) return "error";
  const auto& [range, cone] = std::pair(outcome.fit->range, outcome.fit->cone);
  if (range && range->status != litfog::AttenuationFitStatus::optimal) return name_of(range->status);
  return cone ? name_of(cone->best().status) : "optimal";
}

/// Why the status is 5, in a sentence.
void report_shortfall(const Outcome& outcome) {
  if (outcome.status != kNotToTolerance) return;
  const LightFit& fit = *outcome.fit;
  if (fit.range && fit.range->status != litfog::AttenuationFitStatus::optimal) {
    fmt::print(stderr, "{}: range: {}: {}\n", outcome.input, name_of(fit.range->status), fit.range->sentence);
  }
  if (fit.cone && fit.cone->best().status != litfog::ConeFitStatus::optimal) {
    fmt::print(stderr, "{}: cone: unproven: its objective is {:.6g}, another may have {:.6g}\n", outcome.input,
               fit.cone->best().objective, fit.cone->best().lower_bound);
  }
  if (fit.is_proven()) fmt::print(stderr, "{}: poor: {}\n", outcome.input, outcome.verdict->why);
}

std::string json_of(const BeamData& beam) {
  const auto number = [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : "null"; };
  const auto angles = [](const std::vector<double>& radians) -> std::string {
    if (radians.empty()) return "null";
    if (radians.size() == 1) return fmt::format("{}", litfog::files::degrees(radians[0]));
    return fmt::format("[{}, {}]", litfog::files::degrees(radians[0]), litfog::files::degrees(radians[1]));
  };
  return fmt::format(R"({{"peak_cd": {}, "flux_lm": {}, "beam_angle_deg": {}, "field_angle_deg": {}}})",
                     number(beam.peak), number(beam.flux), angles(beam.beam_angle), angles(beam.field_angle));
}

std::string json_of(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences)
    text += (text.empty() ? "" : ", ") + litfog::files::json_quoted(sentence);
  return "[" + text + "]";
}

std::string json_of(const Outcome& outcome) {
  const auto text_or_null = [](const std::string& value) {
    return value.empty() ? "null" : litfog::files::json_quoted(value);
  };
  const bool has_axis = outcome.fit && outcome.fit->target.luminaire;
  std::string text = fmt::format(
      "{{\"input\": {}, \"output\": {}, \"status\": \"{}\", \"reason\": {},\n\"verdict\": {}, \"why\": {},\n"
      "\"beam\": {},\n\"axis\": {},\n\"derived\": {},\n\"advice\": {},\n",
      litfog::files::json_quoted(outcome.input), text_or_null(outcome.output), status_of(outcome),
      text_or_null(outcome.reason), text_or_null(outcome.verdict ? name_of(outcome.verdict->grade) : ""),
      text_or_null(outcome.verdict ? outcome.verdict->why : ""),
      outcome.fit ? json_of(beam_data(*outcome.fit)) : "null",
      text_or_null(has_axis ? describe_axis(outcome.fit->target.luminaire->distribution.type, outcome.fit->target.axis)
                            : ""),
      outcome.fit ? json_of(outcome.fit->target.derived) : "[]", outcome.fit ? json_of(outcome.fit->advice()) : "[]");
  text += "\"light\": " + (outcome.fit ? outcome.light : std::string("null"));
  while (text.ends_with('\n')) text.pop_back();
  return text + "}";
}

Table summary_of(const std::vector<Outcome>& outcomes) {
  Table table{.columns = {"input", "extent_m", "constant", "linear", "quadratic", "cone", "first", "second", "rms_%",
                          "verdict", "status"}};
  for (const Outcome& outcome : outcomes) {
    auto& row = table.rows.emplace_back();
    row.emplace_back(outcome.input);
    if (outcome.fit) {
      const litfog::Light& light = outcome.fit->light;
      const auto& [constant, linear, quadratic] = light.attenuation;
      for (const double number : {compute_extent(light.attenuation, light.threshold), constant, linear, quadratic}) {
        row.emplace_back(number);
      }
      switch (light.cone.profile) {
        case litfog::ConeProfile::none:
          row.insert(row.end(), {"none", std::monostate(), std::monostate(), std::monostate()});
          break;
        case litfog::ConeProfile::cosine:
          row.insert(row.end(), {"cosine", litfog::files::degrees(light.cone.half_angle), light.cone.exponent});
          row.emplace_back(100 * outcome.fit->cone->best().rms);
          break;
        case litfog::ConeProfile::smoothstep:
          row.insert(row.end(), {"smoothstep", litfog::files::degrees(light.cone.inner),
                                 litfog::files::degrees(light.cone.outer)});
          row.emplace_back(100 * outcome.fit->cone->best().rms);
          break;
      }
    }
    row.resize(table.columns.size() - 2, std::monostate());
    if (outcome.verdict) {
      row.emplace_back(name_of(outcome.verdict->grade));
    } else {
      row.emplace_back(std::monostate());
    }
    row.emplace_back(status_of(outcome));
  }
  return table;
}

std::string report_of(const std::vector<Outcome>& outcomes, TableFormat format) {
  if (format == TableFormat::json) {
    std::string text;
    for (const Outcome& outcome : outcomes) text += (text.empty() ? "[\n" : ",\n") + json_of(outcome);
    return text + "\n]\n";
  }
  if (outcomes.size() > 1) return format_table(summary_of(outcomes), TableFormat::text);
  return outcomes.front().fit ? format_data_sheet(*outcomes.front().fit) : "";
}

ExitStatus run(const CLI::App& app, const Options& options) {
  std::optional<FigureFormat> figure_format;
  if (!options.plot.empty()) figure_format = figure_format_of("--plot", options.plot);
  if (!options.cookie.empty() && fs::path(options.cookie).extension() != ".exr") {
    fail_option("--cookie", options.cookie, "must end in .exr");
  }
  std::vector<Outcome> outcomes = plan(options);
  const OutputFiles outputs = outputs_of(options, outcomes);
  if (figure_format) require_plotter();
  for (Outcome& outcome : outcomes) {  // all before the first is written
    read(options, outcome);
    if (outcome.target) expect_apart_from_files_of(*outcome.target, outputs);
  }
  check_options(app, rules_of(outcomes));

  ExitStatus worst = kDone;
  {
    Progress progress;
    for (Outcome& outcome : outcomes) {
      progress.show(fmt::format("{} of {}: {}", &outcome - outcomes.data() + 1, outcomes.size(), outcome.input));
      if (outcome.target) {
        fit(options, outcome);
        write(options, outcome, figure_format);
      }
      if (gravity(outcome.status) > gravity(worst)) worst = outcome.status;
    }
  }
  for (const Outcome& outcome : outcomes) {
    if (!outcome.reason.empty()) fmt::print(stderr, "{}\n", outcome.reason);
    report_shortfall(outcome);
  }
  // A single input with an error has nothing to show.
  if (outcomes.size() > 1 || outcomes.front().fit) write_standard_output(report_of(outcomes, options.format));
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
        fail_option("--axis", text, "must be peak, down, up or two angles H,V in degrees");
      }
      return litfog::files::radians(*number);
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
  Options options;
  CLI::App app{kDescription, "litfog-fit"};
  app.footer(kExplanation);
  app.add_option("input", options.inputs, "Light specs (.json) and photometric files (.ies, .ldt, .csv)")
      ->type_name("FILE...")
      ->required();
  app.add_option("-o,--output", options.output,
                 "Write the light here; of several inputs, NAME.json each in this folder")
      ->type_name("FILE|FOLDER");
  ConeChoice profile = ConeChoice::best;
  add_choice<ConeChoice>(
      app, "--profile", profile,
      {{"cosine", ConeChoice::cosine}, {"smoothstep", ConeChoice::smoothstep}, {"best", ConeChoice::best}},
      "Cone profile, in place of the spec's own");
  app.add_flag("--robust", options.is_robust, "For measured falloff tables: samples that lie far off count less");
  app.add_option("--plot", options.plot, "Draw targets, fits and errors over range and angle")
      ->type_name("FILE.png|FILE.svg");
  CLI::Option* const cookie = app.add_option("--cookie", options.cookie,
                                             "Write a measured or elliptical beam as a cube map, six faces in a column")
                                  ->type_name("FILE.exr");
  add_integer(app, "--cookie-size", options.cookie_size, 1, 4096, "Edge of a face in texels, 256 if not given")
      ->needs(cookie);
  app.add_flag("--reproducible", options.is_reproducible,
               "Leave the time out of the light's \"fit\": same input, same file");
  add_axis(app, options.choices.axis);
  add_choice<TableFormat>(app, "--format", options.format, {{"text", TableFormat::text}, {"json", TableFormat::json}},
                          "Report's format, text if not given");
  return run_command(app, argc, argv, [&] {
    for (const auto& [option, value] :
         {std::pair{"-o", &options.output}, {"--plot", &options.plot}, {"--cookie", &options.cookie}}) {
      if (app.count(option) > 0 && value->empty()) fail_option(option, "", "must not be empty");
    }
    if (app.count("--profile") > 0) options.choices.profile = profile;
    const bool shows_no_record = options.output.empty() && options.format == TableFormat::text;
    check_options(
        app, {{"several inputs", options.inputs.size() > 1, {"--plot", "--cookie"}, "it shows a single light"},
              {"--format text and no -o", shows_no_record, {"--reproducible"}, "the light's \"fit\" is not written"}});
    return run(app, options);
  });
}
