// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <vector>

#include "command/command_test.h"
#include "command/exit_status.h"
#include "litfog/batch.h"
#include "litfog/solve.h"

namespace litfog::test {
using namespace command;

// What the benchmark prints and writes, and the errors it finds. Its times are only times: positive and finite.

namespace {

using Json = nlohmann::json;

class BenchCommand : public CommandTest {
 protected:
  BenchCommand() : CommandTest(LITFOG_BENCH_PATH) {}
};

std::string usage_message(const std::string& reason) {
  return "litfog-bench: " + reason + "; see litfog-bench --help\n";
}

const std::vector<std::string> kSolveColumns{"method",  "precision", "fog",           "ns_per_light",  "ns_spread",
                                             "max_ulp", "mean_ulp",  "max_error_255", "mean_error_255"};
const std::vector<std::string> kAirlightColumns{"method",     "nodes",     "fog",           "lights",      "lamp_leg",
                                                "ns_per_ray", "ns_spread", "max_error_255", "p99_relative"};
const std::vector<std::string> kLampColumns{"lamp",        "visibility_m", "peak",         "airlight_k0",
                                            "airlight_k1", "reference_k0", "reference_k1", "max_error_255"};
const std::vector<std::string> kGlowColumns{"phase",      "parameter",      "tau",       "angle_deg", "method", "glow",
                                            "glow_error", "relative_error", "ns_per_ray"};
const std::vector<std::string> kUpdateColumns{
    "method",      "fog",       "lights",         "kinds",         "steps",
    "ms_per_step", "ms_spread", "bytes_per_step", "skipped_share", "max_deviation_255"};

const std::vector<std::string> kFitColumns{"problem",   "method",    "tables",       "ms",
                                           "ms_spread", "objective", "solved_share", "digits"};

void expect_machine(const Json& document, bool draws) {
  ASSERT_TRUE(document.contains("machine"));
  const Json& machine = document["machine"];
  ASSERT_EQ(machine.size(), 6u);
  for (const char* member : {"cpu", "isa", "compiler", "commit", "gl_renderer", "date"}) {
    ASSERT_TRUE(machine.contains(member)) << member;
    EXPECT_NE(machine[member].get<std::string>(), "") << member;
  }
  EXPECT_EQ(machine["gl_renderer"] == "none", !draws);
  EXPECT_TRUE(std::regex_match(machine["commit"].get<std::string>(), std::regex("unknown|[0-9a-f]{12,}")));
  EXPECT_TRUE(
      std::regex_match(machine["date"].get<std::string>(), std::regex("\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\dZ")));
}

void expect_columns(const Json& rows, const std::vector<std::string>& columns) {
  for (const Json& row : rows) {
    EXPECT_EQ(row.size(), columns.size());
    for (const std::string& column : columns) EXPECT_TRUE(row.contains(column)) << column;
  }
}

/// The tests of what a Release build measures; a Debug build has but one thing to say.
class BenchMeasurement : public BenchCommand {
 protected:
  void SetUp() override {
#ifndef NDEBUG
    GTEST_SKIP() << "a Debug build does not measure";
#endif
  }

  /// The rows that a quick benchmark writes, which must have these columns, if any are given. The README has to explain
  /// each column.
  Json measure(const std::string& arguments, const std::vector<std::string>& columns = {}, bool draws = false) const {
    expect_done(arguments + " --quick --json rows.json");
    const Json document = Json::parse(read("rows.json"));
    expect_machine(document, draws);
    if (!columns.empty()) expect_columns(document["rows"], columns);
    static const std::string readme = read(LITFOG_DATA_DIR "/benchmarks/README.md");
    for (const auto& [column, value] : document["rows"].at(0).items()) {
      const bool is_angle = column.ends_with(" deg");
      EXPECT_TRUE(is_angle || readme.find('`' + column + '`') != std::string::npos) << column;
    }
    return document["rows"];
  }
};

TEST_F(BenchMeasurement, SolveMeasuresEveryMethodInBothFogs) {
  const Json rows = measure("solve --csv solve.csv --plot solve.png", kSolveColumns);
  std::multiset<std::string> found;
  for (const Json& row : rows) {
    if (row["fog"].is_string()) {
      found.insert(row["method"].get<std::string>() + " " + row["precision"].get<std::string>() + " " +
                   row["fog"].get<std::string>());
    }
  }
  for (const char* method :
       {"hales-16 double", "hales-64 double", "hales-256 double", "hales-1024 double", "hales-16-simd float",
        "hales-64-simd float", "hales-256-simd float", "hales-1024-simd float", "boost-brent double", "exact double",
        "exact float", "batch double", "batch float"}) {
    for (const char* fog : {" exp", " exp2"}) EXPECT_EQ(found.count(std::string(method) + fog), 1u) << method << fog;
  }

  const std::string table = read("out");
  std::string header = table.substr(0, table.find('\n'));
  header = std::regex_replace(header, std::regex(" +"), ",");
  const std::string csv = read("solve.csv");
  EXPECT_EQ(header + ",cpu,isa,compiler,commit,gl_renderer,date", csv.substr(0, csv.find('\n')));
  EXPECT_EQ(std::ranges::count(table, '\n'), std::ptrdiff_t(rows.size() + 1));
  EXPECT_EQ(std::ranges::count(csv, '\n'), std::ptrdiff_t(rows.size() + 1));
  EXPECT_TRUE(read("solve.png").starts_with("\x89PNG"));
}

TEST_F(BenchMeasurement, SolveFindsTheErrorsThatTheHeadersState) {
  const Json rows = Json::parse(expect_done("solve --quick --format json").out)["rows"];
  const auto max_error_255 = [&](const std::string& method, const std::string& fog) {
    const auto row =
        std::find_if(rows.begin(), rows.end(), [&](const Json& r) { return r["method"] == method && r["fog"] == fog; });
    return row == rows.end() ? std::nan("") : (*row)["max_error_255"].get<double>();
  };
  for (const Json& row : rows) {
    const std::string method = row["method"];
    const bool is_float = row["precision"] == "float";
    const std::string name = row.dump();
    EXPECT_GT(row["ns_per_light"].get<double>(), 0) << name;
    EXPECT_LT(row["ns_per_light"].get<double>(), 1e9) << name;
    EXPECT_GE(row["ns_spread"].get<double>(), 0) << name;
    if (method.starts_with("memory-copy")) {
      EXPECT_TRUE(row["fog"].is_null() && row["max_ulp"].is_null() && row["max_error_255"].is_null()) << name;
      continue;
    }
    const double max_ulp = row["max_ulp"];
    const double max_255 = row["max_error_255"];
    EXPECT_TRUE(std::isfinite(max_ulp) && std::isfinite(max_255)) << name;
    EXPECT_GE(max_ulp, row["mean_ulp"].get<double>()) << name;
    EXPECT_GE(max_255, row["mean_error_255"].get<double>()) << name;
    if (method == "exact") {
      EXPECT_LE(max_ulp, is_float ? kIntensityMaxUlp<float> : kIntensityMaxUlp<double>) << name;
    }
    if (method.starts_with("batch")) {
      EXPECT_LE(max_ulp, kBatchIntensityMaxUlp) << name;
    }
    // The steps of 1/255 are those of ulps: an intensity is at most 1, so its ulp at most epsilon / 2.
    EXPECT_LE(max_255, max_ulp * 255 * (is_float ? 0x1p-24 : 0x1p-53) * 1.001) << name;
    // The search finds the range to 1e-8 of it, and the intensity of a peak at a knee is off by as much.
    if (method == "boost-brent") {
      EXPECT_LT(max_255, 1e-4) << name;
    }
  }
  for (const std::string fog : {"exp", "exp2"}) {
    for (const std::string samples : {"16", "64", "256", "1024"}) {
      const double scalar = max_error_255("hales-" + samples, fog);
      EXPECT_GT(scalar, 0.01) << "sampling has become exact: " << samples << ", " << fog;
      EXPECT_NEAR(max_error_255("hales-" + samples + "-simd", fog), scalar, 1e-3) << samples << ", " << fog;
    }
    EXPECT_LE(max_error_255("hales-1024", fog), max_error_255("hales-16", fog));
  }
}

TEST_F(BenchMeasurement, AirlightMeasuresEveryMethodOverTheRaysThatItKnows) {
  std::map<std::string, Json> found;
  for (const Json& row : measure("airlight --csv airlight.csv --plot airlight.svg", kAirlightColumns)) {
    const std::string nodes = row["nodes"].is_null() ? "" : "-" + std::to_string(row["nodes"].get<int>());
    const std::string name = row["method"].get<std::string>() + nodes + " " + row["fog"].get<std::string>() + " " +
                             row["lights"].get<std::string>() + " " + std::to_string(row["lamp_leg"].get<int>());
    EXPECT_TRUE(found.emplace(name, row).second) << name;
    EXPECT_GT(row["ns_per_ray"].get<double>(), 0) << name;
    EXPECT_GE(row["ns_spread"].get<double>(), 0) << name;
    const bool is_reference = row["method"] == "reference";
    EXPECT_EQ(row["max_error_255"].is_null(), is_reference) << name;
    EXPECT_EQ(row["p99_relative"].is_null(), is_reference) << name;
  }
  std::size_t count = 0;
  const auto expect_methods = [&](const std::string& rays, const std::vector<std::string>& methods) {
    for (const std::string& method : methods) EXPECT_TRUE(found.contains(method + rays)) << method << rays;
    count += methods.size();
  };
  for (const char* rays : {" exp point 0", " exp point 1", " exp2 point 0", " exp2 point 1", " exp g-0.85 0",
                           " exp g-0.85 1", " exp droplets 0", " exp droplets 1", " exp layers 0", " exp layers 1",
                           " exp any 0", " exp any 1", " exp2 any 0", " exp2 any 1"}) {
    expect_methods(
        rays, {"march-16", "march-32", "march-64", "march-128", "march-256", "march-clipped-16", "march-clipped-32",
               "march-clipped-64", "march-clipped-128", "march-clipped-256", "litfog", "reference"});
  }
  expect_methods(" exp inverse-square 0", {"arctangent", "litfog", "reference"});
  expect_methods(" exp inverse-square 1", {"arctangent", "pegoraro-2009", "sun-2005", "litfog", "reference"});
  EXPECT_EQ(found.size(), count);
  EXPECT_TRUE(has(read("airlight.svg"), "processor time of one thread per ray"));
}

TEST_F(BenchMeasurement, ScatteringTabulatesAllDepthsAndAngles) {
  const Json rows = measure("scattering");
  ASSERT_EQ(rows.size(), 2 * 16u);
  for (const Json& row : rows) {
    EXPECT_EQ(row.size(), 3 + 18 + 1u);
    EXPECT_GT(row["0.2 deg"].get<double>(), row["180 deg"].get<double>());
    EXPECT_LT(row["max_error"].get<double>(), 0.1) << row;
  }
  EXPECT_NEAR(rows[0]["0.2 deg"].get<double>(), 39.6, 0.2) << "isotropic, as by the random walk";
}

TEST_F(BenchMeasurement, GlowIsThatOfTheReferenceAndOfTheRandomWalk) {
#ifdef LITFOG_HAS_GL
  const std::string strip = " --strip strip.png";
#else
  const std::string strip;
#endif
  std::map<std::string, int> methods;
  for (const Json& row : measure("glow --plot glow.svg" + strip, kGlowColumns)) {
    const std::string method = row["method"];
    const double error = row["relative_error"];
    ++methods[method];
    EXPECT_EQ(row["glow_error"].is_null(), method != "walk") << row;
    EXPECT_EQ(row["ns_per_ray"].is_null(), method == "walk") << row;
    if (method == "reference") {
      EXPECT_EQ(error, 0) << row;
    } else if (method == "all") {
      EXPECT_LT(error, 0.02) << row;
    } else if (method == "walk") {
      // So short a walk has errors that are themselves uncertain.
      EXPECT_LT(error, 0.3 + 8 * row["glow_error"].get<double>() / row["glow"].get<double>()) << row;
    } else {
      EXPECT_GT(error, 0.01) << row;
    }
  }
  EXPECT_EQ(methods, (std::map<std::string, int>{{"reference", 24},
                                                 {"single", 24},
                                                 {"all", 24},
                                                 {"apsf-2003", 12},
                                                 {"gaussian-2004", 24},
                                                 {"octaves-2013", 24},
                                                 {"walk", 24}}));
  if (!strip.empty()) {
    EXPECT_TRUE(read("strip.png").starts_with("\x89PNG"));
  }
  EXPECT_TRUE(has(read("glow.svg"), "angle from the lamp (degrees)"));
}

#ifdef LITFOG_HAS_GL
TEST_F(BenchMeasurement, ScenesInAllOrdersAreNearTracedPaths) {
  const Json rows =
      measure("traced --strip traced.png",
              {"scene", "visibility_m", "fog_light", "ratio_p10", "ratio_p50", "ratio_p90", "noise_p50"}, true);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_LT(rows[0]["ratio_p50"].get<double>(), 0.85) << rows[0];
  EXPECT_NEAR(rows[1]["ratio_p50"].get<double>(), 1, 0.15) << rows[1];
  EXPECT_TRUE(read("traced.png").starts_with("\x89PNG"));
}
#endif

TEST_F(BenchMeasurement, RivalsOfTheAirlightConvergeToTheReference) {
  std::map<std::string, double> coarsest, finest;
  for (const Json& row : measure("airlight")) {
    const std::string method = row["method"];
    if (method == "reference") continue;
    const double error = row["max_error_255"];
    EXPECT_TRUE(std::isfinite(error)) << row;
    if (method == "sun-2005") {
      EXPECT_LT(error, 1) << row;
    }
    if (method == "pegoraro-2009") {
      EXPECT_LT(error, 1e-6) << row;
    }
    if (method == "arctangent") {
      EXPECT_GT(error, 1) << row;
    }
    if (row["nodes"].is_null()) continue;
    const std::string rays = method + row["fog"].get<std::string>() + row["lights"].get<std::string>() +
                             std::to_string(row["lamp_leg"].get<int>());
    coarsest.try_emplace(rays, error);
    finest[rays] = error;
  }
  EXPECT_EQ(finest.size(), 2u * 14);
  for (const auto& [rays, error] : finest) EXPECT_LT(error, coarsest[rays]) << rays;
}

TEST_F(BenchMeasurement, LampsStandBetweenPeakAndTheirReference) {
  std::map<std::string, int> visibilities;
  for (const Json& row : measure("lamps --csv lamps.csv --plot lamps.svg", kLampColumns)) {
    const auto value = [&](const char* column) { return row[column].get<double>(); };
    ++visibilities[row["lamp"].get<std::string>()];
    EXPECT_GE(value("airlight_k0"), value("peak")) << row;
    EXPECT_GT(value("airlight_k0"), value("airlight_k1")) << row;
    EXPECT_NEAR(value("airlight_k0"), value("reference_k0"), 1. / 255) << row;
    EXPECT_NEAR(value("airlight_k1"), value("reference_k1"), 1. / 255) << row;
    EXPECT_DOUBLE_EQ(value("max_error_255"), 255 * std::max(std::abs(value("airlight_k0") - value("reference_k0")),
                                                            std::abs(value("airlight_k1") - value("reference_k1"))))
        << row;
  }
  EXPECT_EQ(visibilities.size(), 4u);
  for (const auto& [lamp, count] : visibilities) EXPECT_EQ(count, visibilities.begin()->second) << lamp;
  EXPECT_TRUE(has(read("lamps.svg"), "visibility (m)"));
}

TEST_F(BenchMeasurement, UpdateStaysWithinItsBudget) {
  std::multiset<std::string> found;
  for (const Json& row : measure("update --csv update.csv", kUpdateColumns)) {
    const std::string method = row["method"];
    const std::string name = row.dump();
    found.insert(method + " " + row["fog"].get<std::string>());
    EXPECT_GT(row["lights"].get<double>(), row["kinds"].get<double>()) << name;
    EXPECT_GT(row["kinds"].get<double>(), 1) << name;
    EXPECT_GT(row["steps"].get<double>(), 1) << name;
    EXPECT_GT(row["ms_per_step"].get<double>(), 0) << name;
    EXPECT_GE(row["ms_spread"].get<double>(), 0) << name;
    const double kinds_bytes = 192 + (method == "updater-layers" ? 40 : 32) * row["kinds"].get<double>();
    const bool is_updater = method != "batch-of-all", skips = method == "updater" || method == "updater-layers";
    EXPECT_TRUE(is_updater ? row["bytes_per_step"] <= kinds_bytes : row["bytes_per_step"] > 10 * kinds_bytes) << name;
    const double skipped = row["skipped_share"];
    EXPECT_TRUE(skips ? skipped > 0 && skipped < 1 : skipped == 0) << name;
    EXPECT_LE(row["max_deviation_255"].get<double>(), skips ? 0.5 : 1e-3) << name;
  }
  EXPECT_EQ(found,
            (std::multiset<std::string>{"updater exp", "updater exp2", "updater-no-skip exp", "updater-layers exp",
                                        "updater-no-skip exp2", "batch-of-all exp", "batch-of-all exp2"}));
}

TEST_F(BenchMeasurement, LoadLeavesMemoryFlat) {
  const Json row = measure("load")[0];
  EXPECT_LE(row["ms_per_step"].get<double>(), row["ms_worst"].get<double>());
  EXPECT_LE(row["grown_mib"].get<double>(), 1) << row;
  EXPECT_LE(row["max_deviation_255"].get<double>(), 1e-3) << row;
}

#ifdef LITFOG_HAS_FIT
TEST_F(BenchMeasurement, FitFindsEveryOptimumToTheDigitsThatItStates) {
  const Json rows = measure("fit --csv fit.csv", kFitColumns);
  std::multiset<std::string> found;
  std::map<std::string, double> least_objective;
  for (const Json& row : rows) {
    const std::string problem = row["problem"];
    const double objective = row["objective"];
    least_objective.try_emplace(problem, objective);
    least_objective[problem] = std::min(least_objective[problem], objective);
  }
  for (const Json& row : rows) {
    const std::string name = row.dump(), problem = row["problem"], method = row["method"];
    found.insert(problem + " " + method);
    EXPECT_GT(row["ms"].get<double>(), 0) << name;
    EXPECT_GE(row["ms_spread"].get<double>(), 0) << name;
    EXPECT_GE(row["digits"].get<double>(), method == "litfog" ? 9 : 0) << name;
    if (method != "litfog") continue;
    EXPECT_EQ(row["solved_share"], 1) << name;
    EXPECT_LE(row["objective"].get<double>(), least_objective[problem] * (1 + 1e-9) + 1e-20) << name;
  }
  for (const char* problem : {"exact", "noise-2", "noise-20", "outliers", "clamped", "far", "near"}) {
    for (const char* method : {" litfog", " ceres"}) {
      EXPECT_EQ(found.count(std::string(problem) + method), 1u) << problem << method;
    }
  }
}
#else
TEST_F(BenchMeasurement, BuildWithoutFitsHasNoFitBenchmark) {
  EXPECT_ERROR(run("fit --quick"), kMissingCapability,
               "litfog-bench: this build has no litfog::fit; configure with -DLITFOG_BUILD_FIT=ON\n");
}
#endif

TEST_F(BenchMeasurement, IsaLimitsWhatBatchesUse) {
  const Outcome failed = run("update --quick --isa MMX");
  EXPECT_EQ(failed.status, kUsage);
  ASSERT_TRUE(failed.err.starts_with("litfog-bench: --isa = MMX: must be one of ")) << failed.err;
  std::string names = failed.err.substr(std::string("litfog-bench: --isa = MMX: must be one of ").size());
  names = names.substr(0, names.find(" on this machine"));
  std::istringstream list(names);
  for (std::string name; std::getline(list >> std::ws, name, ',');) {
    const Outcome outcome = run("solve --quick --format json --isa " + name);
    ASSERT_EQ(outcome.status, kDone) << name << ": " << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["machine"]["isa"], name);
  }
}

TEST_F(BenchMeasurement, UnwritableOutputIsAnErrorBeforeTheMeasurement) {
  EXPECT_ERROR(run("solve --json absent/x.json"), kCannotWrite,
               "litfog-bench: absent/x.json: cannot be written: no folder absent\n");
  EXPECT_ERROR(run("solve --csv ."), kCannotWrite, "litfog-bench: .: cannot be written: is a folder\n");
  EXPECT_ERROR(run("solve --csv /proc/a.csv"), kCannotWrite,
               "litfog-bench: /proc/a.csv: cannot be written: No such file or directory\n");
  EXPECT_ERROR(run("lamps --plot absent/x.png"), kCannotWrite,
               "litfog-bench: absent/x.png: cannot be written: no folder absent\n");
  EXPECT_ERROR(run("lamps --plot x.jpg"), kUsage, usage_message("--plot = x.jpg: must end in .png or .svg"));
  EXPECT_ERROR(run("update --plot x.png"), kUsage,
               usage_message("--plot cannot be given with update: it has no figure"));
  EXPECT_ERROR(run("glow --strip x.svg"), kUsage, usage_message("--strip = x.svg: must end in .png"));
  EXPECT_ERROR(run("lamps --strip x.png"), kUsage,
               usage_message("--strip cannot be given with lamps: it has no strip"));
  EXPECT_ERROR(run("solve --plot x.png", "PATH=/nowhere"), kMissingCapability,
               "litfog-bench: gnuplot cannot be run: No such file or directory; install gnuplot-nox\n");
  EXPECT_ERROR(run("solve --csv ''"), kUsage, usage_message("--csv = \"\": must not be empty"));
  EXPECT_ERROR(run("solve --csv a --json ./a"), kUsage, usage_message("--csv = a: must not be the file of --json"));
  EXPECT_ERROR(run("fit --isa AVX2"), kUsage, usage_message("--isa cannot be given with fit: it has no batches"));
  for (const auto& entry : std::filesystem::directory_iterator(directory())) {
    EXPECT_TRUE(entry.path().filename() == "out" || entry.path().filename() == "err") << entry.path();
  }
}

TEST_F(BenchMeasurement, FullDiskIsNoticed) {
  ASSERT_TRUE(std::filesystem::is_character_file("/dev/full"));
  for (const char* arguments : {"--json /dev/full", "--csv /dev/full", ">/dev/full"}) {
    const Outcome outcome = run(std::string("update --quick ") + arguments);
    EXPECT_EQ(outcome.status, kCannotWrite) << arguments;
    EXPECT_TRUE(has(outcome.err, "cannot be written: No space left on device"));
  }
}

TEST_F(BenchCommand, HelpNeedsNoReleaseBuild) {
  const Outcome help = expect_done("--help");
  for (const char* part : {"solve", "airlight", "lamps", "scattering", "glow", "update", "load", "fit", "--json",
                           "--csv", "--plot", "--quick", "Exit status:"}) {
    EXPECT_TRUE(has(help.out, part));
  }
  EXPECT_EQ(run("--version").status, kDone);
}

TEST_F(BenchCommand, WrongUsageIsAnError) {
  EXPECT_ERROR(run(""), kUsage, usage_message("benchmark is required"));
  EXPECT_ERROR(
      run("speed"), kUsage,
      usage_message("benchmark = speed: must be one of "
                    "solve|airlight|lamps|scattering|glow|traced|update|load|fit|render|frames|rejection|maps|city"));
  EXPECT_EQ(run("solve --quick --slow").status, kUsage);
  EXPECT_EQ(run("solve update").status, kUsage);
  EXPECT_EQ(run("solve --json").status, kUsage);
}

#ifndef NDEBUG
TEST_F(BenchCommand, DebugBuildDoesNotMeasure) {
  EXPECT_ERROR(run("solve --quick"), kMissingCapability,
               "litfog-bench: a Debug build is not measured; configure with -DCMAKE_BUILD_TYPE=Release\n");
}
#endif

#ifdef LITFOG_HAS_GL
const std::vector<std::string> kRenderColumns{"scene",
                                              "path",
                                              "fog_light",
                                              "lights",
                                              "size",
                                              "samples",
                                              "skip",
                                              "ms_per_frame",
                                              "ms_spread",
                                              "ratio_to_legacy",
                                              "ratio_to_two_light_legacy",
                                              "ratio_to_plain",
                                              "max_error_255",
                                              "mean_error_255",
                                              "excepted_pixels"};

TEST_F(BenchMeasurement, RenderMeasuresEveryPathBesideLegacyAndTheBareTexture) {
  std::map<int, std::map<std::string, Json>> by_lights;
  for (const Json& row : measure("render --csv render.csv --plot render.png", kRenderColumns, true)) {
    const bool is_peak = row["fog_light"] == "peak";
    EXPECT_TRUE(is_peak || row["fog_light"] == "airlight") << row;
    by_lights[row["lights"].get<int>()][row["path"].get<std::string>() + (is_peak ? "" : " airlight")] = row;
  }
  ASSERT_EQ(by_lights.size(), 2u);
  for (auto& [lights, paths] : by_lights) {
    EXPECT_EQ(paths.size(), 13u);
    const double plain = paths["plain"]["ms_per_frame"].get<double>();
    EXPECT_TRUE(paths.contains("unified airlight"));
    const double legacy = paths["legacy"]["ms_per_frame"].get<double>();
    // Two-light legacy is timed again among the frames of other numbers of lights.
    const double two_lights = legacy / paths["legacy"]["ratio_to_two_light_legacy"].get<double>();
    if (lights == 2) {
      EXPECT_DOUBLE_EQ(two_lights, legacy);
    }
    for (const auto& [path, row] : paths) {
      const double ms = row["ms_per_frame"].get<double>();
      EXPECT_GT(ms, 0) << path;
      EXPECT_DOUBLE_EQ(row["ratio_to_legacy"].get<double>(), ms / legacy) << path;
      EXPECT_NEAR(row["ratio_to_two_light_legacy"].get<double>() * two_lights / ms, 1, 1e-12) << path;
      EXPECT_DOUBLE_EQ(row["ratio_to_plain"].get<double>(), ms / plain) << path;
      EXPECT_EQ(row["max_error_255"].is_null(), path == "unlit" || path == "plain") << path;
    }
    EXPECT_LT(paths["unified"]["max_error_255"].get<double>(), 0.25);  // as ReferenceOfPath
    EXPECT_LT(paths["unified airlight"]["max_error_255"].get<double>(), 1);
  }
  EXPECT_TRUE(std::filesystem::exists(directory() / "render.png"));
}

TEST_F(BenchMeasurement, FramesTimeSingleScatteringAndAllOrdersBesidePeak) {
  const Json rows = measure("frames",
                            {"scene", "phase", "lights", "fog_light", "ms_per_frame", "ms_spread", "ratio_to_peak",
                             "ratio_to_single", "bytes_uploaded", "max_error_255", "mean_error_255"},
                            true);
  ASSERT_EQ(rows.size(), 3u);
  const std::string fog_lights[] = {"peak", "single", "all"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i]["fog_light"], fog_lights[i]);
    EXPECT_DOUBLE_EQ(rows[i]["ratio_to_peak"].get<double>(),
                     rows[i]["ms_per_frame"].get<double>() / rows[0]["ms_per_frame"].get<double>());
    EXPECT_DOUBLE_EQ(rows[i]["ratio_to_single"].get<double>(),
                     rows[i]["ms_per_frame"].get<double>() / rows[1]["ms_per_frame"].get<double>());
    EXPECT_LT(rows[i]["mean_error_255"].get<double>(), 0.5) << rows[i];
  }
}

TEST_F(BenchMeasurement, RejectionShadesFewerFragmentsAfterAPassOfDepths) {
  std::map<std::string, Json> rows;
  for (const Json& row : measure("rejection", {}, true)) {
    EXPECT_GT(row["ms_per_frame"].get<double>(), 0) << row;
    rows[row["samples"].dump() + " " + row["rejection"].get<std::string>()] = row;
  }
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows["1 none"]["ratio_to_none"], 1);
}

// Linear look-ups err by the square of the texels' distance; the pair has as many texels as the 3-D map, denser ones.
TEST_F(BenchMeasurement, MapsErrLessTheMoreTexelsTheyHave) {
  std::map<std::string, std::map<int, Json>> paths;
  for (const Json& row : measure("maps", {}, true)) paths[row["path"]][row["map_size"].get<int>()] = row;
  ASSERT_EQ(paths.size(), 2u);
  for (const auto& [path, rows] : paths) {
    const Json& coarse = rows.at(16);
    const Json& fine = rows.at(64);
    EXPECT_GT(coarse["mean_error_255"].get<double>(), 8 * fine["mean_error_255"].get<double>()) << path;
    EXPECT_EQ(fine["cone_kib"].get<double>(), 48) << path;
    EXPECT_NEAR(fine["range_kib"].get<double>(), 512, 1) << path;
  }
  EXPECT_LT(paths["lookup-2d"][64]["mean_error_255"].get<double>(),
            paths["lookup-3d"][64]["mean_error_255"].get<double>());
}

TEST_F(BenchMeasurement, CityMeasuresClustersAndFramesAtEveryVisibility) {
  std::map<std::string, int> rows;
  for (const Json& row : measure("city --csv city.csv", {}, true)) {
    const std::string method = row["method"];
    ++rows[method];
    EXPECT_GT(row["ms"].get<double>(), 0) << row;
    EXPECT_GE(row["worst_ratio"].get<double>(), 1) << row;
    EXPECT_TRUE(row["visibility_m"] == "inf" || row["visibility_m"] == 50) << row;
    if (method == "frame-flight") continue;
    EXPECT_LE(row["lights_that_matter"].get<double>(), row["lights"].get<double>()) << row;
    const bool is_compared = method == "frame";
    EXPECT_EQ(row["ratio_to_those"].is_number(), is_compared) << row;
    if (is_compared) {
      EXPECT_GT(row["ratio_to_those"].get<double>(), 0.5) << row;
      EXPECT_LE(row["max_error_255"].get<double>(), 2) << row;
    }
  }
  const std::map<std::string, int> expected{{"clusters", 4},      {"clusters-fog", 4},   {"clusters-one-light", 4},
                                            {"frame", 2},         {"frame-airlight", 2}, {"frame-flight", 2},
                                            {"frame-of-those", 2}};
  EXPECT_EQ(rows, expected);
}

TEST_F(BenchMeasurement, TargetOfTheBatchIsAnErrorForFrames) {
  EXPECT_ERROR(run("render --quick --isa AVX2"), kUsage,
               usage_message("--isa cannot be given with render: it has no batches"));
}
#endif

}  // namespace

}  // namespace litfog::test
