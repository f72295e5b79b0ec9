// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command/bundled_data.h"
#include "command/command.h"
#include "command/number.h"
#include "command/option_rule.h"
#include "command/output_files.h"
#include "command/progress.h"
#include "command/runway_lights.h"
#include "command/table.h"
#include "command/uncaught.h"
#include "files/bundled_name.h"
#include "files/hint.h"
#include "files/json_text.h"
#include "litfog/airlight.h"
#include "litfog/files/light_file.h"
#include "litfog/input_error.h"
#include "litfog/runway_visual_range.h"
#include "litfog/solve.h"
#include "text/csv.h"
#include "text/file_text.h"

using namespace litfog;
using namespace litfog::command;

namespace {

constexpr const char* kDescription =
    R"(Computes how brightly a light makes fog glow: its intensity, the range of the peak, the light's extent, and its
airlight.

  litfog-solve --constant C --linear L --quadratic Q  FOG  [OPTIONS]
  litfog-solve --light FILE|NAME...                   FOG  [OPTIONS]
  litfog-solve --csv FILE|-

FOG is --visibility M[,M...], --rvr M[,M...] or --density D[,D...].
)";

constexpr const char* kExamples =
    R"(Units: metres, 1/m (density, linear), 1/m^2 (quadratic). The attenuation is a(r) = 1 / (constant + linear r +
quadratic r^2), at most 1; f(r) is the fog's transmittance. The intensity is the peak of (1 - f(r)) a(r) for r from 0 to
the extent, a fraction of the light's colour. The airlight is the fraction that the fog scatters back along the light's
axis: a(r) integrated over the opacity 1 - f(r). It is never below the intensity.

Examples:
  litfog-solve --constant 1 --quadratic 0.0002 --visibility 50,200,1000
  litfog-solve --light runway-edge --rvr 550,300,175,50 --threshold-lx 1e-4
  litfog-solve --light landing-lamp.json headlight.json --fog exp2 --density 0.01 --format json
  litfog-solve --csv rows.csv > solved.csv     rows.csv starts: fog,density,constant,linear,quadratic,threshold

The batch form reads one light per row, in CSV with those six columns in any order; other columns pass through. It
appends extent,peak_range,intensity,airlight,status. A bad row is kept, with the reason as its status.

Exit status: 0 done; 1 wrong command line; 2 bad input, named file:line:column on standard error (the batch form still
solves the good rows); 4 output cannot be written; 5 a solve did not converge.)";

enum class Method { exact, sampled };

struct Options {
  Attenuation attenuation{0, 0, 0};
  std::vector<std::string> light_files;
  FogMode mode = FogMode::exp;
  std::vector<double> visibilities;
  double contrast = kContrastMor;
  std::vector<double> runway_visual_ranges;
  RunwayLights runway_lights;
  std::vector<double> densities;
  std::optional<double> threshold;
  Method method = Method::exact;
  int samples = 64;
  TableFormat format = TableFormat::text;
  std::string csv_file;
};

FogIntensity solve(const Options& options, const Attenuation& attenuation, const Fog& fog, double threshold) {
  return options.method == Method::exact ? solve_fog_intensity(attenuation, fog, threshold)
                                         : sample_fog_intensity(attenuation, fog, threshold, options.samples);
}

const char* name_of(SolveStatus status) { return status == SolveStatus::ok ? "ok" : "not_converged"; }

std::vector<Light> lights_of(const Options& options) {
  std::vector<Light> lights;
  if (options.light_files.empty()) {
    lights.emplace_back().attenuation = options.attenuation;
  } else {
    const std::filesystem::path folder = bundled_folder("lights");
    for (const std::string& given : options.light_files) {
      lights.push_back(read_light(files::file_or_bundled(given, folder).string()));
    }
  }
  if (options.threshold) {
    for (Light& light : lights) light.threshold = *options.threshold;
  }
  return lights;
}

/// The fogs that are asked for.
std::vector<Fog> fogs_of(const Options& options) {
  std::vector<Fog> fogs;
  for (const double metres : options.visibilities) {
    fogs.push_back(Fog::from_visibility(options.mode, metres, options.contrast));
  }
  for (const double metres : options.runway_visual_ranges) {
    fogs.push_back(fog_from_runway_visual_range(options.mode, metres, options.runway_lights));
  }
  for (const double density : options.densities) fogs.push_back({options.mode, density});
  return fogs;
}

/// One row for each light in each fog.
ExitStatus solve_table(const Options& options) {
  const bool has_visibility = options.densities.empty();
  const std::vector<Fog> fogs = fogs_of(options);
  Table table;
  table.columns = {"light", "fog"};
  if (has_visibility) table.columns.push_back("visibility_m");
  for (const char* column : {"density", "constant", "linear", "quadratic", "threshold", "extent", "peak_range",
                             "intensity", "airlight", "status"}) {
    table.columns.push_back(column);
  }

  ExitStatus status = kDone;
  for (const Light& light : lights_of(options)) {
    for (std::size_t i = 0; i < fogs.size(); ++i) {
      const Fog fog = scaled(fogs[i], light.density_scale);
      const auto [constant, linear, quadratic] = light.attenuation;
      const FogIntensity result = solve(options, light.attenuation, fog, light.threshold);
      if (result.status != SolveStatus::ok) status = kNotToTolerance;
      auto& row = table.rows.emplace_back();
      row = {light.name, name_of(fog.mode)};
      if (has_visibility) {
        row.emplace_back(options.visibilities.empty() ? visibility(fogs[i]) : options.visibilities[i]);
      }
      for (const double cell :
           {fog.density, constant, linear, quadratic, light.threshold, result.extent, result.peak_range,
            result.intensity, axial_airlight(light.attenuation, fog, light.threshold)}) {
        row.emplace_back(cell);
      }
      row.emplace_back(name_of(result.status));
    }
  }
  write_standard_output(format_table(table, options.format));
  return status;
}

/// The batch form's columns, in the order in which they are named to people.
enum Column { kFog, kDensity, kConstant, kLinear, kQuadratic, kThreshold, kColumnCount };
constexpr std::array<std::string_view, kColumnCount> kColumnNames{"fog",    "density",   "constant",
                                                                  "linear", "quadratic", "threshold"};
constexpr std::size_t kMaxColumns = 1024;  // a row that is shorter than the header is filled up
constexpr std::array<std::string_view, 5> kAppendedNames{"extent", "peak_range", "intensity", "airlight", "status"};

/// What is wrong with a row, and where.
struct RowError {
  CsvLocation location;
  std::string sentence;
};

InputError located(const std::string& file, const RowError& error) {
  const auto& [line, column] = error.location;
  return {{file, std::size_t(line), std::size_t(column)}, error.sentence};
}

/// The header: which field of a row holds which column.
struct Header {
  std::array<std::size_t, kColumnCount> index;
  std::size_t field_count;
};

/// The error of a missing column. Names semicolons instead of commas, or a slip in the column's name.
RowError missing_column(std::string_view name, const CsvRecord& record) {
  std::string sentence = fmt::format("column {}: must be given in the header", name);
  for (std::size_t i = 0; i < record.size(); ++i) {
    const std::string_view given = record.field(i);
    const bool is_other_column = std::ranges::find(kColumnNames, given) != kColumnNames.end();
    if (is_other_column || files::hint_for_word(given, {name}).empty()) continue;
    return {record.location(i), fmt::format("{}; is {} meant?", sentence, files::quoted_excerpt(given))};
  }
  const bool has_semicolons = record.size() == 1 && record.field(0).find(';') != std::string_view::npos;
  return {{}, sentence + (has_semicolons ? ", with commas between columns" : "")};
}

std::optional<RowError> read_header(const CsvRecord& record, Header& header) {
  if (record.error() != nullptr) return RowError{record.error_location(), fmt::format("header: {}", record.error())};
  if (record.size() > kMaxColumns) {
    return RowError{record.location(kMaxColumns),
                    fmt::format("header: must not have more than {} columns", kMaxColumns)};
  }
  std::array<bool, kColumnCount> is_found{};
  header.field_count = record.size();
  for (std::size_t i = 0; i < record.size(); ++i) {
    const std::string_view name = record.field(i);
    if (std::find(kAppendedNames.begin(), kAppendedNames.end(), name) != kAppendedNames.end()) {
      return RowError{record.location(i), fmt::format("column {}: must not be given, it is computed", name)};
    }
    const auto known = std::find(kColumnNames.begin(), kColumnNames.end(), name);
    if (known == kColumnNames.end()) continue;
    const auto column = std::size_t(known - kColumnNames.begin());
    if (is_found[column]) return RowError{record.location(i), fmt::format("column {}: must not be given twice", name)};
    is_found[column] = true;
    header.index[column] = i;
  }
  for (std::size_t column = 0; column < kColumnCount; ++column) {
    if (!is_found[column]) return missing_column(kColumnNames[column], record);
  }
  return std::nullopt;
}

/// A row's input.
struct Row {
  Fog fog;
  Attenuation attenuation;
  double threshold;
};

/// The inverse of name_of; nothing for any other word.
std::optional<FogMode> parse_fog_mode(std::string_view text) {
  for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
    if (text == name_of(mode)) return mode;
  }
  return std::nullopt;
}

std::optional<RowError> read_row(const Header& header, const CsvRecord& record, Row& row) {
  if (record.error() != nullptr) return RowError{record.error_location(), record.error()};
  if (record.size() != header.field_count) {
    return RowError{
        record.location(std::min(record.size(), header.field_count + 1) - 1),
        fmt::format("number of fields = {}: must be {} as in the header", record.size(), header.field_count)};
  }
  const auto error_in = [&](std::size_t column, std::string_view rule) {
    const std::size_t i = header.index[column];
    return RowError{record.location(i),
                    fmt::format("{} = {}: {}", kColumnNames[column], files::quoted_excerpt(record.field(i)), rule)};
  };
  const auto mode = parse_fog_mode(record.field(header.index[kFog]));
  if (!mode) return error_in(kFog, "must be exp or exp2");
  std::array<double, kColumnCount> values;
  for (std::size_t column = kDensity; column < kColumnCount; ++column) {
    const auto number = parse_number(record.field(header.index[column]));
    if (!number)
      return error_in(column, "must be a number" + files::hint_for_number(record.field(header.index[column])));
    values[column] = *number;
  }
  row = {{*mode, values[kDensity]}, {values[kConstant], values[kLinear], values[kQuadratic]}, values[kThreshold]};

  auto error = find_error(row.fog);
  if (!error) error = find_error(row.attenuation);
  if (!error) error = find_threshold_error(row.threshold);
  if (!error) return std::nullopt;
  std::string_view field = error->field;
  field.remove_prefix(field.rfind('.') + 1);  // "attenuation.linear" is the column linear
  const auto column = std::find(kColumnNames.begin(), kColumnNames.end(), field);
  return error_in(std::size_t(column - kColumnNames.begin()), error->rule);
}

/// Bad rows on standard error, at most a screenful of them, and the progress.
class BatchReport {
 public:
  explicit BatchReport(const std::string& file) : file_(file) {}

  void add_error(const RowError& error) {
    if (++errors_ <= kMaxReported) progress_.print(located(file_, error).what());
  }

  void add_row() {
    if (++rows_ % 1024 == 0) progress_.show(fmt::format("{} rows", rows_));
  }

  /// Returns whether all rows were good.
  bool finish() {
    if (errors_ > kMaxReported) progress_.print(fmt::format("{}: {} more bad rows", file_, errors_ - kMaxReported));
    return errors_ == 0;
  }

 private:
  static constexpr long kMaxReported = 20;

  std::string file_;
  long errors_ = 0;
  long rows_ = 0;
  Progress progress_;
};

/// Rows from CSV to CSV, as they come.
ExitStatus solve_batch(const Options& options) {
  const bool is_standard_input = options.csv_file == "-";
  const std::string name = is_standard_input ? "<stdin>" : options.csv_file;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(is_standard_input ? stdin : open_file(options.csv_file),
                                                             std::fclose);
  if (!is_standard_input) {
    OutputFiles outputs;
    outputs.add_standard_output();
    outputs.expect_apart_from(options.csv_file);
  }
  CsvReader reader(file.get(), name);
  CsvRecord record;
  Header header;
  if (!reader.read(record)) throw located(name, {{}, "header: must be given"});
  if (const auto error = read_header(record, header)) throw located(name, *error);

  const char* const line_end = record.ends_in_crlf() ? "\r\n" : "\n";
  fmt::memory_buffer out;
  fmt::format_to(std::back_inserter(out), "{},{}{}", record.raw(record.size()), fmt::join(kAppendedNames, ","),
                 line_end);
  BatchReport report(name);
  ExitStatus status = kDone;
  while (reader.read(record)) {
    Row row;
    if (record.is_blank()) {  // no row, and still none in the output
      fmt::format_to(std::back_inserter(out), "{}", line_end);
    } else if (const auto error = read_row(header, record, row)) {
      report.add_error(*error);
      // As many fields as the header has, so that the status stands in its column.
      const std::size_t count = std::min(record.size(), header.field_count);
      const std::size_t missing = header.field_count - std::max(count, std::size_t{1});
      fmt::format_to(std::back_inserter(out), "{}{:,>{}},,,,,{}{}", record.raw(count), "", missing,
                     csv_quoted(error->sentence), line_end);
    } else {
      const FogIntensity result = solve(options, row.attenuation, row.fog, row.threshold);
      if (result.status != SolveStatus::ok) status = kNotToTolerance;
      fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{}{}", record.raw(record.size()), result.extent,
                     result.peak_range, result.intensity, axial_airlight(row.attenuation, row.fog, row.threshold),
                     name_of(result.status), line_end);
    }
    report.add_row();
    constexpr std::size_t kChunk = std::size_t{1} << 16;
    if (out.size() >= kChunk) {
      write_standard_output({out.data(), out.size()});
      out.clear();
    }
  }
  write_standard_output({out.data(), out.size()});
  return report.finish() ? status : kBadInput;
}

[[noreturn]] void fail_form(const std::string& sentence) { throw CLI::ValidationError(sentence); }

/// What the options mean together.
void check_form(const CLI::App& app, const Options& options) {
  const auto is_given = [&app](const char* name) { return app.count(name) > 0; };
  check_options(
      app, {{"--method exact", options.method == Method::exact, {"--samples"}, "it takes none"},
            {"--csv",
             is_given("--csv"),
             {"--constant", "--linear", "--quadratic", "--light", "--fog", "--visibility", "--contrast", "--rvr",
              "--lamp-cd", "--background-cd-m2", "--threshold-lx", "--density", "--threshold", "--format"}},
            {"--light", is_given("--light"), {"--constant", "--linear", "--quadratic"}},
            {"--density",
             is_given("--density"),
             {"--visibility", "--contrast", "--rvr", "--lamp-cd", "--background-cd-m2", "--threshold-lx"}},
            {"--visibility", is_given("--visibility"), {"--rvr", "--lamp-cd", "--background-cd-m2", "--threshold-lx"}},
            {"--rvr", is_given("--rvr"), {"--contrast"}, "its visibility_m is always by mor"}});
  if (is_given("--csv")) return;
  if (!is_given("--light") && !is_given("--constant") && !is_given("--linear") && !is_given("--quadratic")) {
    fail_form("a light must be given: --constant, --linear, --quadratic or --light or --csv");
  }
  if (!is_given("--light")) {
    if (const auto error = find_error(options.attenuation)) {
      fail_option("--constant", fmt::format("{}", error->value), error->rule);
    }
  }
  if (!is_given("--density") && !is_given("--visibility") && !is_given("--rvr")) {
    fail_form("a fog must be given: --visibility, --rvr or --density");
  }
  for (const double metres : options.runway_visual_ranges) expect_lamps_reach(metres, options.runway_lights);
}

}  // namespace

int main(int argc, char** argv) {
  expect_uncaught();
  Options options;
  CLI::App app{kDescription, "litfog-solve"};
  app.footer(kExamples);
  app.option_defaults()->group("Light");
  add_number(app, "--constant", options.attenuation.constant, kFiniteNotNegative,
             "Attenuation's constant, 0 if not given");
  add_number(app, "--linear", options.attenuation.linear, kFiniteNotNegative, "Its linear term in 1/m, 0 if not given");
  add_number(app, "--quadratic", options.attenuation.quadratic, kFiniteNotNegative,
             "Its quadratic term in 1/m^2, 0 if not given");
  app.add_option("--light", options.light_files,
                 "Light files, or bundled lights such as landing-lamp, instead of these three; one row each")
      ->type_name("FILE|NAME");
  double threshold = 0;
  add_number(app, "--threshold", threshold, kOpenUnitInterval,
             "Attenuation at which a light ends; the light's own or 0.05 if not given");
  app.option_defaults()->group("Fog");
  add_choice<FogMode>(app, "--fog", options.mode, {{"exp", FogMode::exp}, {"exp2", FogMode::exp2}},
                      "Fog's falloff, exp if not given");
  add_numbers(app, "--visibility", options.visibilities, kNotNegative, "Visibilities in metres; inf is clear air");
  add_contrast(app, options.contrast);
  add_runway_lights(app, options.runway_lights);
  add_numbers(app, "--rvr", options.runway_visual_ranges, kNotNegative,
              "Runway visual ranges in metres instead of visibilities, which are then printed: by mor");
  add_numbers(app, "--density", options.densities, kNotNegative,
              "Fog densities in 1/m instead of visibilities; inf is total fog");
  app.option_defaults()->group("Solution and output");
  add_choice<Method>(app, "--method", options.method, {{"exact", Method::exact}, {"sampled", Method::sampled}},
                     "How to solve, exact if not given; sampled is Hales's, kept for comparison");
  add_integer(app, "--samples", options.samples, 1, 1'000'000'000, "Samples of --method sampled, 64 if not given");
  add_choice<TableFormat>(app, "--format", options.format,
                          {{"table", TableFormat::text}, {"csv", TableFormat::csv}, {"json", TableFormat::json}},
                          "Result's format, table if not given");
  app.add_option("--csv", options.csv_file, "Batch form: rows from this file, - is standard input")
      ->type_name("FILE|-");
  return run_command(app, argc, argv, [&] {
    if (app.count("--threshold") > 0) options.threshold = threshold;
    check_form(app, options);
    return app.count("--csv") > 0 ? solve_batch(options) : solve_table(options);
  });
}
