// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "command/comma_locale.h"
#include "command/command_test.h"
#include "command/exit_status.h"
#include "litfog/airlight.h"
#include "litfog/runway_visual_range.h"
#include "litfog/solve.h"

namespace litfog::test {
using namespace command;

namespace {

using litfog::Attenuation;
using litfog::Fog;
using litfog::FogMode;

using litfog::test::Outcome;

class SolveCommand : public litfog::test::CommandTest {
 protected:
  SolveCommand() : CommandTest(LITFOG_SOLVE_PATH) {}

  /// The batch form over a file named rows.csv.
  Outcome run_batch(const std::string& rows) const {
    write("rows.csv", rows);
    return run("--csv rows.csv");
  }

  /// The rows of a run in JSON.
  nlohmann::json rows_of(const std::string& arguments) const {
    return nlohmann::json::parse(run(arguments + " --format json").out);
  }

  void expect_usage_error(const std::string& arguments, const std::string& reason) const {
    SCOPED_TRACE(arguments);
    EXPECT_ERROR(run(arguments), kUsage, "litfog-solve: " + reason + "; see litfog-solve --help\n");
  }

  std::string read_solved(const std::string& rows) const {
    write("rows.csv", rows);
    run("--csv rows.csv >solved.csv");
    return read("solved.csv");
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What is appended to the row exp,1,0,1,0,0.05. Inverse linear: the peak is at the knee, 1 m, where the attenuation
/// is 1.
const std::string kSolved =
    fmt::format(",20,1,{},{},ok", solve_fog_intensity(Attenuation{0, 1, 0}, Fog{FogMode::exp, 1}, 0.05).intensity,
                axial_airlight({0, 1, 0}, {FogMode::exp, 1}, 0.05));

constexpr const char* kHeader = "fog,density,constant,linear,quadratic,threshold\n";
constexpr const char* kSolvedHeader =
    "fog,density,constant,linear,quadratic,threshold,extent,peak_range,intensity,airlight,status\n";

TEST_F(SolveCommand, HelpAndVersionSucceed) {
  const Outcome help = expect_done("--help");
  EXPECT_EQ(help.err, "");
  for (const char* part : {"Computes how brightly", "Examples:", "Exit status:", "Units:", "--csv", "--visibility"}) {
    EXPECT_TRUE(has(help.out, part));
  }
  const Outcome version = expect_done("--version");
  EXPECT_TRUE(std::regex_match(version.out, std::regex("litfog-solve [0-9]+\\.[0-9]+\\.[0-9]+\n"))) << version.out;
}

TEST_F(SolveCommand, JsonReadsBackAsTheLibrarysResult) {
  const Outcome outcome = expect_done(
      "--constant 1 --linear 0.01 --quadratic 0.0002 --visibility 50,123.4 --fog exp2 --threshold 0.1 --format json");
  const auto rows = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(rows.size(), 2u);
  for (const auto& row : rows) {
    const Fog fog = Fog::from_visibility(FogMode::exp2, row["visibility_m"].get<double>());
    const auto expected = solve_fog_intensity(Attenuation{1, 0.01, 0.0002}, fog, 0.1);
    EXPECT_EQ(row["density"].get<double>(), fog.density);
    EXPECT_EQ(row["extent"].get<double>(), expected.extent);
    EXPECT_EQ(row["peak_range"].get<double>(), expected.peak_range);
    EXPECT_EQ(row["intensity"].get<double>(), expected.intensity);
    EXPECT_EQ(row["airlight"].get<double>(), axial_airlight({1, 0.01, 0.0002}, fog, 0.1));
    EXPECT_EQ(row["threshold"].get<double>(), 0.1);
    EXPECT_EQ(row["fog"], "exp2");
    EXPECT_EQ(row["status"], "ok");
    EXPECT_EQ(row["light"], "");
  }
  EXPECT_EQ(rows[0]["visibility_m"], 50);
  EXPECT_EQ(rows[1]["visibility_m"], 123.4);
}

TEST_F(SolveCommand, TableAndCsvHaveTheSameColumns) {
  // The intensity is 1 - e^-1.
  EXPECT_EQ(
      run("--linear 1 --density 1").out,
      "light  fog  density  constant  linear  quadratic  threshold  extent  peak_range  intensity  airlight  status\n"
      "-      exp        1         0       1          0       0.05      20           1   0.632121  0.851504  ok\n");
  EXPECT_EQ(run("--linear 1 --density 1 --format csv").out,
            "light,fog,density,constant,linear,quadratic,threshold,extent,peak_range,intensity,airlight,status\n"
            ",exp,1,0,1,0,0.05" +
                kSolved + "\n");
}

TEST_F(SolveCommand, InfinityIsWrittenAndRead) {
  EXPECT_EQ(run("--constant 2 --density inf,0.1 --format csv").out,
            "light,fog,density,constant,linear,quadratic,threshold,extent,peak_range,intensity,airlight,status\n"
            ",exp,inf,2,0,0,0.05,inf,0,0.5,0.5,ok\n"
            ",exp,0.1,2,0,0,0.05,inf,inf,0.5,0.5,ok\n");
  const auto rows = rows_of("--linear 1 --visibility inf,0");
  EXPECT_EQ(rows[0]["visibility_m"], "inf");
  EXPECT_EQ(rows[0]["density"], 0);
  EXPECT_EQ(rows[0]["intensity"], 0);
  EXPECT_EQ(rows[1]["density"], "inf");
  EXPECT_EQ(rows[1]["intensity"], 1);
}

TEST_F(SolveCommand, ContrastGivesVisibilityItsMeaning) {
  const auto density_of = [this](const std::string& contrast) {
    return rows_of("--linear 1 --visibility 100 " + contrast)[0]["density"].get<double>();
  };
  EXPECT_DOUBLE_EQ(density_of(""), -std::log(0.05) / 100);
  EXPECT_DOUBLE_EQ(density_of("--contrast mor"), -std::log(0.05) / 100);
  EXPECT_DOUBLE_EQ(density_of("--contrast koschmieder"), -std::log(0.02) / 100);
  EXPECT_DOUBLE_EQ(density_of("--contrast flightgear"), -std::log(0.01) / 100);
  EXPECT_DOUBLE_EQ(density_of("--contrast 0.5"), -std::log(0.5) / 100);
}

TEST_F(SolveCommand, RunwayVisualRangeGivesTheFogAndItsMeteorologicalOpticalRange) {
  const auto expect = [this](const std::string& options, FogMode mode, const RunwayLights& lights) {
    SCOPED_TRACE(options);
    const auto rows = rows_of("--linear 1 --rvr 550,50,inf,0 " + options);
    ASSERT_EQ(rows.size(), 4u);
    for (std::size_t i = 0; i < 2; ++i) {
      const Fog fog = fog_from_runway_visual_range(mode, i == 0 ? 550 : 50, lights);
      EXPECT_EQ(rows[i]["density"].get<double>(), fog.density);
      EXPECT_EQ(rows[i]["visibility_m"].get<double>(), visibility(fog));
    }
    EXPECT_EQ(rows[2]["visibility_m"], "inf");
    EXPECT_EQ(rows[3]["visibility_m"], 0);
  };
  expect("", FogMode::exp, {});
  expect("--lamp-cd 5000 --threshold-lx 1e-4 --fog exp2", FogMode::exp2, {5000, 1e-4});
  expect("--background-cd-m2 1000", FogMode::exp, {10'000, illuminance_threshold(1000)});
  const std::string by_visibility = run("--linear 1 --visibility 550").out;
  EXPECT_EQ(run("--linear 1 --rvr 550 --lamp-cd 0").out, by_visibility);  // by markings alone
  EXPECT_EQ(run("--linear 1 --rvr 2000 --threshold-lx 1e-3 --format csv").out.substr(0, 26),
            "light,fog,visibility_m,den");
}

TEST_F(SolveCommand, SampledMethodIsHalesWith64SamplesUnlessTold) {
  const auto intensity_of = [this](const std::string& method) {
    return rows_of("--constant 1 --quadratic 0.01 --density 0.03 " + method)[0]["intensity"].get<double>();
  };
  const Attenuation attenuation{1, 0, 0.01};
  const Fog fog{FogMode::exp, 0.03};
  EXPECT_EQ(intensity_of("--method exact"), solve_fog_intensity(attenuation, fog).intensity);
  EXPECT_EQ(intensity_of("--method sampled"), sample_fog_intensity(attenuation, fog, 0.05, 64).intensity);
  EXPECT_EQ(intensity_of("--method sampled --samples 3"), sample_fog_intensity(attenuation, fog, 0.05, 3).intensity);
  EXPECT_LT(intensity_of("--method sampled --samples 3"), intensity_of("--method exact"));
}

TEST_F(SolveCommand, EachLightFileIsARowSeenThroughItsOwnDensity) {
  write("a.json",
        R"({"litfog": "light", "version": 1, "name": "A", "attenuation": {"linear": 1}, "density_scale": 0.25})");
  write("b.json",
        R"({"litfog": "light", "version": 1, "attenuation": {"constant": 1, "linear": 2}, "threshold": 0.5})");
  const auto rows = rows_of("--light a.json b.json --density 4,2");
  ASSERT_EQ(rows.size(), 4u);
  const auto expect = [](const nlohmann::json& row, const char* name, const Attenuation& attenuation, double density,
                         double threshold) {
    EXPECT_EQ(row["light"], name);
    EXPECT_EQ(row["density"].get<double>(), density);
    EXPECT_EQ(row["intensity"].get<double>(),
              solve_fog_intensity(attenuation, Fog{FogMode::exp, density}, threshold).intensity);
  };
  expect(rows[0], "A", {0, 1, 0}, 1, 0.05);
  expect(rows[1], "A", {0, 1, 0}, 0.5, 0.05);
  expect(rows[2], "b", {1, 2, 0}, 4, 0.5);
  expect(rows[3], "b", {1, 2, 0}, 2, 0.5);
}

TEST_F(SolveCommand, ThresholdOptionWinsOverTheLights) {
  write("b.json",
        R"({"litfog": "light", "version": 1, "attenuation": {"constant": 1, "linear": 2}, "threshold": 0.5})");
  const auto extent_of = [this](const std::string& option) {
    return rows_of("--light b.json --density 1 " + option)[0]["extent"].get<double>();
  };
  EXPECT_EQ(extent_of(""), 0.5);
  EXPECT_EQ(extent_of("--threshold 0.25"), 1.5);
}

TEST_F(SolveCommand, ShippedLightsSolve) {
  const auto rows = rows_of("--light " LITFOG_DATA_DIR "/lights/*.json --visibility 200");
  EXPECT_GE(rows.size(), 12u);
  for (const auto& row : rows) {
    EXPECT_GT(row["intensity"].get<double>(), 0) << row;
    EXPECT_LT(row["intensity"].get<double>(), 1) << row;
  }
}

TEST_F(SolveCommand, WrongValuesAreUsageErrors) {
  for (const std::string bad : {"-1", "nan", "0x10", "+1", "1e999", "1m", "-inf", "inf"}) {
    expect_usage_error("--density 1 --constant " + bad, "--constant = " + bad + ": must be a finite number >= 0");
  }
  expect_usage_error("--density 1 --constant 1,5", "--constant = 1,5: must be a finite number >= 0");
  expect_usage_error("--density 1 --linear ''", "--linear = \"\": must be a finite number >= 0");
  expect_usage_error("--constant 1 --density 1,-2", "--density = -2: must be a number >= 0 or inf");
  expect_usage_error("--constant 1 --density 1,,2", "--density = \"\": must be a number >= 0 or inf");
  expect_usage_error("--constant 1 --density 1,", "--density = \"\": must be a number >= 0 or inf");
  expect_usage_error("--constant 1 --visibility ' 1'", "--visibility =  1: must be a number >= 0 or inf");
  expect_usage_error("--constant 1 --density 1 --threshold 1", "--threshold = 1: must be a number in (0, 1)");
  expect_usage_error("--constant 1 --density 1 --threshold 5",
                     "--threshold = 5: must be a number in (0, 1); 5 % is 0.05");
  expect_usage_error("--constant 1 --visibility 1 --contrast 5%",
                     "--contrast = 5%: must be mor, koschmieder, flightgear or a number in (0, 1); 5 % is 0.05");
  expect_usage_error("--constant 1 --visibility 1 --contrast haze",
                     "--contrast = haze: must be mor, koschmieder, flightgear or a number in (0, 1)");
  expect_usage_error("--constant 1 --visibility 1 --contrast 0",
                     "--contrast = 0: must be mor, koschmieder, flightgear or a number in (0, 1)");
  expect_usage_error("--constant 1 --rvr 550,-1", "--rvr = -1: must be a number >= 0 or inf");
  expect_usage_error(
      "--constant 1 --rvr 1000,1001 --lamp-cd 100 --threshold-lx 1e-4",
      "--rvr = 1001: must be at most sqrt(candela / illuminance_threshold), where the lamps are last seen in clear "
      "air");
  expect_usage_error("--constant 1 --rvr 550 --lamp-cd -1", "--lamp-cd = -1: must be a finite number >= 0");
  expect_usage_error("--constant 1 --rvr 550 --threshold-lx 0", "--threshold-lx = 0: must be a finite number > 0");
  expect_usage_error("--constant 1 --rvr 550 --background-cd-m2 inf",
                     "--background-cd-m2 = inf: must be a number in [0, 1e12]");
  expect_usage_error("--constant 1 --density 1 --fog exp3", "--fog = exp3: must be one of exp|exp2; did you mean exp?");
  expect_usage_error("--constant 1 --density 1 --fog 1", "--fog = 1: must be one of exp|exp2");
  expect_usage_error("--constant 1 --density 1 --format xml", "--format = xml: must be one of table|csv|json");
  expect_usage_error("--constant 1 --density 1 --method sampled --samples 0",
                     "--samples = 0: must be an integer from 1 to 1000000000");
  expect_usage_error("--constant 1 --density 1 --method sampled --samples 1e3",
                     "--samples = 1e3: must be an integer from 1 to 1000000000");
  expect_usage_error("--constant 0 --density 1", "--constant = 0: must be > 0 where linear and quadratic are 0");
}

TEST_F(SolveCommand, WrongFormsAreUsageErrors) {
  expect_usage_error("", "a light must be given: --constant, --linear, --quadratic or --light or --csv");
  expect_usage_error("--density 1", "a light must be given: --constant, --linear, --quadratic or --light or --csv");
  expect_usage_error("--constant 1", "a fog must be given: --visibility, --rvr or --density");
  expect_usage_error("--constant 1 --rvr 9 --visibility 1", "--rvr cannot be given with --visibility");
  expect_usage_error("--constant 1 --visibility 9 --lamp-cd 1", "--lamp-cd cannot be given with --visibility");
  expect_usage_error("--constant 1 --rvr 9 --density 1", "--rvr cannot be given with --density");
  expect_usage_error("--constant 1 --rvr 9 --contrast mor",
                     "--contrast cannot be given with --rvr: its visibility_m is always by mor");
  expect_usage_error("--constant 1 --rvr 9 --background-cd-m2 1 --threshold-lx 1",
                     "--background-cd-m2 cannot be given with --threshold-lx: it gives the threshold");
  expect_usage_error("--csv rows.csv --rvr 1", "--rvr cannot be given with --csv");
  expect_usage_error("--constant 1 --density 1 --visibility 1", "--visibility cannot be given with --density");
  expect_usage_error("--constant 1 --density 1 --contrast mor", "--contrast cannot be given with --density");
  expect_usage_error("--constant 1 --light a.json --density 1", "--constant cannot be given with --light");
  expect_usage_error("--constant 1 --density 1 --samples 9",
                     "--samples cannot be given with --method exact: it takes none");
  expect_usage_error("--csv rows.csv --format json", "--format cannot be given with --csv");
  expect_usage_error("--csv rows.csv --density 1", "--density cannot be given with --csv");
  expect_usage_error("--constant 1 --density 1 --colour red", "--colour: must be an option of this command");
  expect_usage_error("--constant 1 --density 1 surplus", "The following argument was not expected: surplus");
  expect_usage_error("--constant 1 --density 1 --density 2", "--density: At Most 1 required but received 2");
  expect_usage_error("--constant 1 --dens 1", "--dens: must be an option of this command; did you mean --density?");
  expect_usage_error("--constant 1 --density 1 --format jsn",
                     "--format = jsn: must be one of table|csv|json; did you mean json?");
}

TEST_F(SolveCommand, WrongLightFilesAreBadInputAndNothingIsPrinted) {
  write("good.json", R"({"litfog": "light", "version": 1, "attenuation": {"linear": 1}})");
  write("bad.json", "{\"litfog\": \"light\", \"version\": 1,\r\n\"attenuation\": {\"linear\": -1}}");
  write("empty.json", "");
  write("spec.json", R"({"litfog": "light-spec", "version": 1, "range": {"extent_m": 1}})");
  EXPECT_ERROR(run("--density 1 --light spec.json"), kBadInput,
               "spec.json:1:12: litfog = \"light-spec\": must be \"light\"; litfog-fit makes a light of a spec\n");
  EXPECT_ERROR(run("--density 1 --light good.json bad.json"), kBadInput,
               "bad.json:2:27: attenuation.linear = -1: must be finite and >= 0\n");
  EXPECT_ERROR(run("--density 1 --light empty.json"), kBadInput,
               "empty.json:1:1: end of file: must be an object, an array, a string, a number, true, false or null\n");
  EXPECT_ERROR(run("--density 1 --light absent.json"), kBadInput,
               "absent.json: cannot be read: No such file or directory\n");
  EXPECT_ERROR(run("--density 1 --light landing-lmp"), kBadInput,
               "landing-lmp: must be a file or a bundled light; did you mean landing-lamp?\n");
  EXPECT_ERROR(run("--density 1 --light ."), kBadInput, ".: cannot be read: Is a directory\n");
}

TEST_F(SolveCommand, OutputThatCannotBeWrittenIsStatusFour) {
  write("rows.csv", std::string(kHeader) + "exp,1,0,1,0,0.05\n");
  for (const char* arguments : {"--help", "--version", "--linear 1 --density 1", "--csv rows.csv"}) {
    SCOPED_TRACE(arguments);
    EXPECT_ERROR(run(std::string(arguments) + " >/dev/full"), kCannotWrite,
                 "litfog-solve: standard output cannot be written: No space left on device\n");
    EXPECT_ERROR(run(std::string(arguments) + " >&-"), kCannotWrite,
                 "litfog-solve: standard output cannot be written: Bad file descriptor\n");
  }
}

TEST_F(SolveCommand, ClosedReaderIsStatusFour) {
  std::string rows = kHeader;
  for (int i = 0; i < 20000; ++i) rows += "exp,1,0,1,0,0.05\n";
  write("rows.csv", rows);
  run("--csv rows.csv 2>left; echo $? >status; } | { head -c 10");
  EXPECT_EQ(read("status"), "4\n");
  EXPECT_EQ(read("left"), "litfog-solve: standard output cannot be written: Broken pipe\n");
}

TEST_F(SolveCommand, BatchSolvesRowsInPlace) {
  const Outcome outcome = run_batch(std::string(kHeader) +
                                    "exp,1,0,1,0,0.05\n"
                                    "exp2,inf,2,0,0.5,0.05\n"
                                    "exp,0,1,0,1,0.5");
  EXPECT_EQ(outcome.status, kDone);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, std::string(kSolvedHeader) + "exp,1,0,1,0,0.05" + kSolved +
                             "\n"
                             "exp2,inf,2,0,0.5,0.05,6,0,0.5,0.5,ok\n"
                             "exp,0,1,0,1,0.5,1,0,0,0,ok\n");
}

TEST_F(SolveCommand, BatchResultsReadBackAsTheLibrarys) {
  std::string rows = kHeader;
  for (int i = 0; i < 300; ++i) {
    rows += (i % 2 != 0 ? "exp," : "exp2,") + std::to_string(0.001 * (i + 1)) + ",1," + std::to_string(0.003 * i) +
            ",0.01,0.05\n";
  }
  std::istringstream lines(run_batch(rows).out);
  std::string line;
  std::getline(lines, line);
  int count = 0;
  for (; std::getline(lines, line); ++count) {
    std::vector<std::string> f;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) f.push_back(field);
    ASSERT_EQ(f.size(), 11u) << line;
    const auto expected =
        solve_fog_intensity(Attenuation{std::stod(f[2]), std::stod(f[3]), std::stod(f[4])},
                            Fog{f[0] == "exp" ? FogMode::exp : FogMode::exp2, std::stod(f[1])}, std::stod(f[5]));
    EXPECT_EQ(std::stod(f[6]), expected.extent);
    EXPECT_EQ(std::stod(f[7]), expected.peak_range);
    EXPECT_EQ(std::stod(f[8]), expected.intensity);
    EXPECT_GE(std::stod(f[9]), expected.intensity);
  }
  EXPECT_EQ(count, 300);
}

TEST_F(SolveCommand, BatchPassesOtherColumnsThroughAsWritten) {
  const Outcome outcome = run_batch(
      "\xEF\xBB\xBF\"my, id\",threshold,quadratic,linear,constant,density,\"fog\",\"note\"\r\n"
      "007,0.05,0,1,0,1,exp,\"say \"\"hi\"\",\r1.0\"\r\n"
      "\r\n"
      "\"1.50\",\"0.05\",0,1,0,1.0e0,exp,\xC3\xA4");
  EXPECT_EQ(outcome.status, kDone) << outcome.err;
  EXPECT_EQ(outcome.out,
            "\"my, "
            "id\",threshold,quadratic,linear,constant,density,\"fog\",\"note\",extent,peak_range,intensity,airlight,"
            "status\r\n"
            "007,0.05,0,1,0,1,exp,\"say \"\"hi\"\",\r1.0\"" +
                kSolved +
                "\r\n"
                "\r\n"
                "\"1.50\",\"0.05\",0,1,0,1.0e0,exp,\xC3\xA4" +
                kSolved + "\r\n");
}

TEST_F(SolveCommand, BatchReadsStandardInput) {
  write("rows.csv", std::string(kHeader) + "exp,1,0,1,0,0.05\nexp,x,0,1,0,0.05\n");
  const Outcome outcome = run("--csv - <rows.csv");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.out, std::string(kSolvedHeader) + "exp,1,0,1,0,0.05" + kSolved +
                             "\n"
                             "exp,x,0,1,0,0.05,,,,,\"density = \"\"x\"\": must be a number\"\n");
  EXPECT_EQ(outcome.err, "<stdin>:3:5: density = \"x\": must be a number\n");
}

TEST_F(SolveCommand, BatchKeepsBadRowsInPlaceWithTheirReason) {
  const Outcome outcome = run_batch(
      "id,fog,density,constant,linear,quadratic,threshold\n"
      "a,exp,1,0,1,0,0.05\n"
      "b,mist,1,0,1,0,0.05\n"
      "c,exp,nan,0,1,0,0.05\n"
      "d,exp,1, 0,1,0,0.05\n"
      "e,exp,-1,0,1,0,0.05\n"
      "f,exp,1,0,inf,0,0.05\n"
      "g,exp,1,0,0,0,0.05\n"
      "\"h,\",exp,1,0,1,0,1\n"
      "i,exp,1\n"
      "j,exp,1,0,1,0,0.05,8,9\n"
      "\"k\"k,exp,1,0,1,0,0.05\n"
      "l,exp,\"1,0,1,0,0.05\n"
      "m,exp,1,0,1,0,0.05\n"
      "\"n,exp,1,0,1,0,0.05\n");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.out,
            "id,fog,density,constant,linear,quadratic,threshold,extent,peak_range,intensity,airlight,status\n"
            "a,exp,1,0,1,0,0.05" +
                kSolved +
                "\n"
                "b,mist,1,0,1,0,0.05,,,,,\"fog = \"\"mist\"\": must be exp or exp2\"\n"
                "c,exp,nan,0,1,0,0.05,,,,,\"density = \"\"nan\"\": must be a number\"\n"
                "d,exp,1, 0,1,0,0.05,,,,,\"constant = \"\" 0\"\": must be a number\"\n"
                "e,exp,-1,0,1,0,0.05,,,,,\"density = \"\"-1\"\": must be >= 0\"\n"
                "f,exp,1,0,inf,0,0.05,,,,,\"linear = \"\"inf\"\": must be finite and >= 0\"\n"
                "g,exp,1,0,0,0,0.05,,,,,\"constant = \"\"0\"\": must be > 0 where linear and quadratic are 0\"\n"
                "\"h,\",exp,1,0,1,0,1,,,,,\"threshold = \"\"1\"\": must be in (0, 1)\"\n"
                "i,exp,1,,,,,,,,,number of fields = 3: must be 7 as in the header\n"
                "j,exp,1,0,1,0,0.05,,,,,number of fields = 9: must be 7 as in the header\n"
                "\"k\"k,exp,1,0,1,0,0.05,,,,,quoted field must end at its quote\n"
                "l,exp,\"1,0,1,0,0.05\",,,,,,,,,quote must be closed on its line\n"
                "m,exp,1,0,1,0,0.05" +
                kSolved +
                "\n"
                "\"n,exp,1,0,1,0,0.05\",,,,,,,,,,,quote must be closed on its line\n");
  EXPECT_EQ(outcome.err,
            "rows.csv:3:3: fog = \"mist\": must be exp or exp2\n"
            "rows.csv:4:7: density = \"nan\": must be a number\n"
            "rows.csv:5:9: constant = \" 0\": must be a number\n"
            "rows.csv:6:7: density = \"-1\": must be >= 0\n"
            "rows.csv:7:11: linear = \"inf\": must be finite and >= 0\n"
            "rows.csv:8:9: constant = \"0\": must be > 0 where linear and quadratic are 0\n"
            "rows.csv:9:18: threshold = \"1\": must be in (0, 1)\n"
            "rows.csv:10:7: number of fields = 3: must be 7 as in the header\n"
            "rows.csv:11:20: number of fields = 9: must be 7 as in the header\n"
            "rows.csv:12:4: quoted field must end at its quote\n"
            "rows.csv:13:7: quote must be closed on its line\n"
            "rows.csv:15:1: quote must be closed on its line\n");
}

TEST_F(SolveCommand, BatchSolvesEachRowWhateverByteAnotherHasInPlaceOfOne) {
  const std::vector<std::string> rows{"\"a\",exp,0.1,1,0.5,0.01,0.05\n", "b,exp2,0.02,0,1,0,0.05\n",
                                      "\"c \"\"1\"\"\",exp,0.03,1,0,0.02,0.01\n", "d,exp,0.1,2,0,0.3,0.2\n"};
  const std::string header = "id,fog,density,constant,linear,quadratic,threshold\n";
  const std::string good = read_solved(header + rows[0] + rows[1] + rows[2] + rows[3]);
  const std::vector<std::string> solved = lines_of(good);
  ASSERT_EQ(solved.size(), 1 + rows.size());
  // Each byte of the third row, its line feed included, and of the file all these at once.
  for (const char byte : {'"', ',', '\n', '\r', '\0', '\xFF', '1', 'x'}) {
    std::string all = header;
    for (std::size_t at = 0; at < rows[2].size(); ++at) {
      std::string changed = rows[2];
      changed[at] = byte;
      const bool is_merged = at + 1 == rows[2].size() && byte != '\n';
      all += rows[0] + rows[1] + changed + (is_merged ? "\n" : "") + rows[3];
    }
    std::map<std::string, std::size_t> times;
    for (const std::string& line : lines_of(read_solved(all))) ++times[line];
    for (const std::size_t row : {1u, 2u, 4u})
      EXPECT_EQ(times[solved[row]], rows[2].size()) << int(byte) << solved[row];
  }
}

TEST_F(SolveCommand, BatchKeepsTheRowsAroundAHugeOne) {
  const Outcome outcome =
      run_batch(std::string(kHeader) + "exp,1,0,1,0,0.05\n" + std::string(3 << 20, 'x') + "\nexp,1,0,1,0,0.05\n");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.out, std::string(kSolvedHeader) + "exp,1,0,1,0,0.05" + kSolved +
                             "\n"
                             ",,,,,,,,,,record must not be longer than 1 MiB\n"
                             "exp,1,0,1,0,0.05" +
                             kSolved + "\n");
  EXPECT_EQ(outcome.err, "rows.csv:3:1: record must not be longer than 1 MiB\n");
}

TEST_F(SolveCommand, BatchNamesTwentyBadRowsAndCountsTheRest) {
  std::string rows = kHeader;
  for (int i = 0; i < 23; ++i) rows += "exp,,0,1,0,0.05\n";
  const Outcome outcome = run_batch(rows);
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 24);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 21);
  EXPECT_TRUE(outcome.err.ends_with("rows.csv:21:5: density = \"\": must be a number\nrows.csv: 3 more bad rows\n"))
      << outcome.err;
}

TEST_F(SolveCommand, BatchWithAWrongHeaderPrintsNothing) {
  const auto expect = [this](const std::string& header, const std::string& message) {
    SCOPED_TRACE(header);
    EXPECT_ERROR(run_batch(header + "\nexp,1,0,1,0,0.05\n"), kBadInput, "rows.csv:" + message + "\n");
  };
  expect("fog,density,constant,linear,quadratic", "1:1: column threshold: must be given in the header");
  expect("fog, density,constant,linear,quadratic,threshold",
         "1:5: column density: must be given in the header; is \" density\" meant?");
  expect("fog;density;constant;linear;quadratic;threshold",
         "1:1: column fog: must be given in the header, with commas between columns");
  expect("Fog,density,constant,linear,quadratic,threshold",
         "1:1: column fog: must be given in the header; is \"Fog\" meant?");
  expect("fog,density,constant,linear,\xC3\xA4,quadratic,threshold,density",
         "1:51: column density: must not be given twice");
  expect("fog,density,constant,linear,quadratic,threshold,status",
         "1:49: column status: must not be given, it is computed");
  expect("\"a,b\",extent,fog,density,constant,linear,quadratic,threshold",
         "1:7: column extent: must not be given, it is computed");
  expect("\"fog\"x,density,constant,linear,quadratic,threshold", "1:6: header: quoted field must end at its quote");
}

TEST_F(SolveCommand, BatchWithMoreThan1024ColumnsPrintsNothing) {
  const auto header = [](std::size_t columns) {
    return "fog,density,constant,linear,quadratic,threshold" + std::string(columns - 6, ',');
  };
  EXPECT_EQ(run_batch(header(1024) + "\nx\n").status, kBadInput);
  EXPECT_ERROR(run_batch(header(1025) + "\nx\n"), kBadInput,
               "rows.csv:1:1067: header: must not have more than 1024 columns\n");
}

TEST_F(SolveCommand, BatchIsNotAppendedToItsOwnRows) {
  const std::string rows = std::string(kHeader) + "exp,1,0,1,0,0.05\n";
  write("rows.csv", rows);
  const Outcome outcome = run("--csv rows.csv >>rows.csv");
  EXPECT_EQ(outcome.status, kUsage);
  EXPECT_TRUE(outcome.err.ends_with("rows.csv: must not be a file that is read, rows.csv; see litfog-solve --help\n"))
      << outcome.err;
  EXPECT_EQ(read("rows.csv"), rows);
}

TEST_F(SolveCommand, BatchSendsATerminalNoCommands) {
  const Outcome outcome = run_batch("fog,density,constant,linear,quadratic,threshold\n\x1B[2J,1,1,1,1,0.5\n");
  EXPECT_EQ(outcome.err.find('\x1B'), outcome.err.npos) << outcome.err;
}

TEST_F(SolveCommand, BatchOfAnEmptyFileOrOfGarbageIsBadInput) {
  EXPECT_ERROR(run_batch(""), kBadInput, "rows.csv:1:1: header: must be given\n");
  EXPECT_ERROR(run_batch("\xEF\xBB\xBF"), kBadInput, "rows.csv:1:1: header: must be given\n");
  EXPECT_ERROR(run_batch(std::string("\x7F\x45LF\0\0\xFF\n,,\"", 11)), kBadInput,
               "rows.csv:1:1: column fog: must be given in the header\n");
  EXPECT_ERROR(run_batch(std::string(3 << 20, ',')), kBadInput,
               "rows.csv:1:1: header: record must not have more than 65,536 fields\n");
  EXPECT_ERROR(run_batch(std::string(3 << 20, 'x')), kBadInput,
               "rows.csv:1:1: header: record must not be longer than 1 MiB\n");
  EXPECT_ERROR(run("--csv absent.csv"), kBadInput, "absent.csv: cannot be read: No such file or directory\n");
  EXPECT_ERROR(run("--csv ."), kBadInput, ".: cannot be read: Is a directory\n");
  EXPECT_ERROR(run("--csv - <&-"), kBadInput, "<stdin>: cannot be read: Bad file descriptor\n");
}

TEST_F(SolveCommand, BatchOfOnlyAHeaderIsOnlyAHeader) {
  const Outcome outcome = run_batch(kHeader);
  EXPECT_EQ(outcome.status, kDone);
  EXPECT_EQ(outcome.out, kSolvedHeader);
}

TEST_F(SolveCommand, BatchTakesTheMethod) {
  write("rows.csv", std::string(kHeader) + "exp,0.03,1,0,0.01,0.05\n");
  const auto expected = sample_fog_intensity(Attenuation{1, 0, 0.01}, Fog{FogMode::exp, 0.03}, 0.05, 3);
  const std::string out = run("--csv rows.csv --method sampled --samples 3").out;
  const std::size_t airlight = out.rfind(',', out.rfind(',') - 1);
  const std::size_t intensity = out.rfind(',', airlight - 1) + 1;
  EXPECT_EQ(std::stod(out.substr(intensity, airlight - intensity)), expected.intensity);
}

#ifdef LITFOG_SHORT_MEMORY
TEST_F(SolveCommand, ShortMemoryIsToldWhereverItRunsOut) {
  write("lamp.json", R"({"litfog": "light", "version": 1, "attenuation": {"quadratic": 1}})");
  write("rows.csv", std::string(kHeader) + "exp,0.03,1,0,0.01,0.05\n");
  expect_words_where_memory_is_short("--light lamp.json --visibility 100", LITFOG_SHORT_MEMORY);
  expect_words_where_memory_is_short("--csv rows.csv", LITFOG_SHORT_MEMORY);
}
#endif

// The command never sets a locale; this holds it to that.
TEST_F(SolveCommand, NumbersDoNotDependOnTheLocale) {
  const CommaLocale comma;
  setenv("LC_ALL", "comma", 1);
  const Outcome outcome = run("--linear 1 --density 1.0 --format csv");
  unsetenv("LC_ALL");
  EXPECT_EQ(outcome.status, kDone) << outcome.err;
  EXPECT_TRUE(outcome.out.ends_with(",exp,1,0,1,0,0.05" + kSolved + "\n")) << outcome.out;
}

}  // namespace

}  // namespace litfog::test
