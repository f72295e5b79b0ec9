// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>
#include <sstream>
#include <thread>

#include "command/command_test.h"
#include "command/exit_status.h"
#include "files/json_document.h"
#include "litfog/attenuation.h"
#include "litfog/color_temperature.h"
#include "litfog/cone.h"
#include "litfog/files/light_file.h"
#include "litfog/fit/cone_fit.h"
#include "litfog/photometry/cookie_file.h"
#include "litfog/photometry/luminaire.h"
#include "photometry/zip_file.h"

namespace litfog::test {
using namespace command;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::numbers::pi;

/// A falloff table and a beam.
constexpr const char* kSpec = R"({"litfog": "light-spec", "version": 1, "name": "flood", "source": "a test",
  "color": [1, 0.5, 0.25], "density_scale": 0.4,
  "range": {"extent_m": 120, "samples": [{"range_m": 10, "attenuation": 0.9}, {"range_m": 20, "attenuation": 0.66},
            {"range_m": 40, "attenuation": 0.31}, {"range_m": 60, "attenuation": 0.17}]},
  "cone": {"samples": [{"angle_deg": 0, "intensity": 20}, {"angle_deg": 5, "intensity": 17},
           {"angle_deg": 10, "intensity": 9}, {"angle_deg": 15, "intensity": 2}, {"angle_deg": 20, "intensity": 0}]}})";

constexpr const char* kBeam = R"({"litfog": "light-spec", "version": 1, "range": {"extent_m": 100},
  "cone": {"beam_angle_deg": 11, "field_angle_deg": 22}})";

/// No attenuation with C = 1 is this bright at 90 m and ends at 100 m.
constexpr const char* kInfeasible = R"({"litfog": "light-spec", "version": 1,
  "range": {"extent_m": 100, "constant": 1, "samples": [{"range_m": 90, "attenuation": 0.5}]}})";

/// 100 cd on the axis, narrower towards 90 degrees.
constexpr const char* kIes = R"(IESNA:LM-63-2002
[LUMINAIRE] spot
TILT=NONE
1 -1 1 6 2 1 2 0 0 0
1 1 10
0 5 10 15 20 90
0 90
100 80 40 15 0 0
100 50 10 0 0 0
)";

/// An IES file of a round beam of candela, by its vertical angles.
std::string round_ies(const std::string& angles, const std::string& candela) {
  return fmt::format("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 {} 1 1 2 0 0 0\n1 1 10\n{}\n0\n{}\n",
                     std::ranges::count(angles, ' ') + 1, angles, candela);
}

std::string usage_message(const std::string& reason) { return "litfog-fit: " + reason + "; see litfog-fit --help\n"; }

class FitCommand : public CommandTest {
 protected:
  FitCommand() : CommandTest(LITFOG_FIT_PATH) {
    write("lamp.json", kSpec);
    write("beam.json", kBeam);
    write("spot.ies", kIes);
  }

  void write_spec(const std::string& name, const std::string& members) const {
    write(name, R"({"litfog": "light-spec", "version": 1, )" + members + "}");
  }

  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(directory())) {
      names.insert(fs::relative(entry.path(), directory()).string());
    }
    return names;
  }

  /// The arguments are a usage error, and nothing is written.
  void expect_usage_error(const std::string& arguments, const std::string& reason) const {
    SCOPED_TRACE(arguments);
    run("--version");  // makes the files of its own output
    const auto before = files();
    EXPECT_ERROR(run(arguments), kUsage, usage_message(reason));
    EXPECT_EQ(files(), before);
  }

  Light light(const std::string& name) const { return read_light((directory() / name).string()); }

  /// The JSON report on the first input.
  json report_on(const std::string& arguments) const { return json::parse(run(arguments + " --format json").out)[0]; }

  /// The JSON of an output.
  json written(const std::string& name) const { return json::parse(read(name)); }
};

// OpenImageIO brings some 230 libraries. They take a fifth of a second to load, and one of them starts a thread before
// main, which ends the program where no thread can start.
TEST_F(FitCommand, CommandsThatDrawNoSceneLoadNoImageLibrary) {
  for (const char* command : {LITFOG_FIT_PATH, LITFOG_SOLVE_PATH}) {
    ASSERT_EQ(std::system(("ldd " + std::string(command) + " >" + (directory() / "libraries").string()).c_str()), 0);
    const std::string libraries = read("libraries");
    EXPECT_TRUE(has(libraries, "libstdc++")) << command;
    EXPECT_FALSE(has(libraries, "OpenImageIO")) << command;
  }
}

TEST_F(FitCommand, HelpTeachesAndVersionSucceeds) {
  const Outcome help = expect_done("--help");
  for (const char* part : {"\"light-spec\"", "Examples:", "Exit status:", "1 lx", "--cookie", "field_angle_deg"}) {
    EXPECT_TRUE(has(help.out, part));
  }
  EXPECT_EQ(run("--version").out.substr(0, 11), "litfog-fit ");
}

TEST_F(FitCommand, ReportNamesTargetsFitErrorsAndCertificate) {
  const Outcome outcome = expect_done("lamp.json --details");
  EXPECT_EQ(outcome.err, "");
  for (const char* part :
       {"flood", "a test", "Range: optimal", "120 m", "held by", "KKT", "range_m", "Cone: ", "cosine", "smoothstep",
        "flux error", "50 % angle off", "10 % angle off", "none is below", "angle_deg", "uncertainty"}) {
    EXPECT_TRUE(has(outcome.out, part));
  }
}

TEST_F(FitCommand, ReportHasNoControlCharactersOfNames) {
  std::string ies = kIes;
  ies.replace(ies.find("[LUMINAIRE] spot"), 16, "[LUMINAIRE] a\x1B[31mb\n[MANUFAC] c\x1B]0;d\x07");
  write("e\x1B[2J.ies", ies);
  write_spec("esc.json", R"("name": "f\u001b[0m\ng", "source": "h\u009bi", "range": {"extent_m": 100})");
  for (const char* input : {"'e\x1B[2J.ies'", "esc.json", "'e\x1B[2J.ies' esc.json"}) {
    const Outcome outcome = expect_done(input);
    EXPECT_TRUE(std::ranges::none_of(outcome.out, [](char c) { return c >= 0 && c < 0x20 && c != '\n'; }))
        << outcome.out;
    EXPECT_FALSE(has(outcome.out, "\xC2\x9B"));
  }
  EXPECT_TRUE(has(run("esc.json").out, "f\\x1b[0m\\x0ag"));
}

TEST_F(FitCommand, LightIsReadBackAndMeetsItsTarget) {
  ASSERT_EQ(run("lamp.json -o light.json").status, kDone);
  const Light fitted = light("light.json");
  EXPECT_EQ(fitted.name, "flood");
  EXPECT_EQ(fitted.color, glm::dvec3(1, 0.5, 0.25));
  EXPECT_EQ(fitted.density_scale, 0.4);
  EXPECT_NEAR(compute_extent(fitted.attenuation, fitted.threshold), 120, 120 * 1e-12);
  EXPECT_NEAR(attenuation_at(fitted.attenuation, 40), 0.31, 0.02);
  EXPECT_NEAR(cone_at(fitted.cone, std::cos(pi / 18)), 0.45, 0.05);
  EXPECT_EQ(files::read_json((directory() / "light.json").string()).member("source").items()[0].string(), "a test");
}

TEST_F(FitCommand, SolveReadsTheLightUnchanged) {
  ASSERT_EQ(run("lamp.json -o light.json").status, kDone);
  const std::string solve = "cd " + directory().string() +
                            " && " LITFOG_SOLVE_PATH " --light light.json --visibility 200 --format json >solved 2>err";
  ASSERT_EQ(std::system(solve.c_str()), 0) << read("err");
  const json row = written("solved")[0];
  EXPECT_EQ(row["light"], "flood");
  EXPECT_EQ(row["constant"].get<double>(), light("light.json").attenuation.constant);
  EXPECT_EQ(row["quadratic"].get<double>(), light("light.json").attenuation.quadratic);
}

TEST_F(FitCommand, FitMemberHasTheProofOfBothFits) {
  ASSERT_EQ(run("lamp.json -o light.json").status, kDone);
  const auto fit = written("light.json")["fit"];
  for (const char* name :
       {"status", "objective", "rms", "largest_error", "active", "covariance", "kkt_residual", "iterations", "boxes"}) {
    EXPECT_TRUE(fit["range"].contains(name)) << name;
  }
  EXPECT_EQ(fit["range"]["active"], json({"extent"}));
  EXPECT_EQ(fit["range"]["covariance"].size(), 3u);
  EXPECT_EQ(fit["cone"]["profile"], written("light.json")["cone"]["profile"]);
  for (const char* profile : {"cosine", "smoothstep"}) {
    for (const char* name : {"cone", "status", "objective", "lower_bound", "rms", "largest_error", "flux_error",
                             "beam_angle_error", "field_angle_error", "active", "covariance", "kkt_residual"}) {
      EXPECT_TRUE(fit["cone"][profile].contains(name)) << profile << " " << name;
    }
  }
}

TEST_F(FitCommand, ProfileOptionWinsOverTheSpecs) {
  ASSERT_EQ(run("lamp.json -o a.json --profile cosine").status, kDone);
  EXPECT_EQ(light("a.json").cone.profile, ConeProfile::cosine);
  EXPECT_FALSE(written("a.json")["fit"]["cone"].contains("smoothstep"));
  ASSERT_EQ(run("lamp.json -o b.json --profile smoothstep").status, kDone);
  EXPECT_EQ(light("b.json").cone.profile, ConeProfile::smoothstep);
}

TEST_F(FitCommand, RobustFitLeavesAnOutlierAside) {
  // C = 1, L = 0.01, Q = 0.001 except for one sample.
  std::string samples;
  for (int range = 5; range <= 60; range += 5) {
    const double value = range == 30 ? 0.9 : 1 / (1 + 0.01 * range + 0.001 * range * range);
    samples += (samples.empty() ? "" : ", ") + ("{\"range_m\": " + std::to_string(range)) +
               ", \"attenuation\": " + std::to_string(value) + "}";
  }
  write_spec("measured.json", R"("range": {"samples": [)" + samples + "]}");
  const Outcome plain = run("measured.json -o plain.json");
  EXPECT_TRUE(has(plain.out, "try --robust"));
  ASSERT_EQ(run("measured.json -o robust.json --robust").status, kDone);
  const auto error = [this](const std::string& name) {
    return std::abs(attenuation_at(light(name).attenuation, 60) * (1 + 0.6 + 3.6) - 1);
  };
  EXPECT_LT(error("robust.json"), 0.02);
  EXPECT_LT(error("robust.json"), 0.5 * error("plain.json"));
}

TEST_F(FitCommand, InfeasibleTargetHasItsReasonAndStillALight) {
  write("far.json", kInfeasible);
  const Outcome outcome = run("far.json -o light.json");
  EXPECT_EQ(outcome.status, kNotToTolerance);
  EXPECT_TRUE(outcome.err.starts_with("far.json: range: infeasible: ")) << outcome.err;
  EXPECT_TRUE(has(run("far.json --details").out, "Range: infeasible"));
  const Light best = light("light.json");
  EXPECT_NEAR(compute_extent(best.attenuation, best.threshold), 100, 1e-10);
  EXPECT_EQ(written("light.json")["fit"]["range"]["status"], "infeasible");
}

TEST_F(FitCommand, JsonReportHoldsTheLights) {
  write("bad.json", "{}");
  const Outcome outcome = run("lamp.json bad.json --format json");
  EXPECT_EQ(outcome.status, kBadInput);
  const auto report = json::parse(outcome.out);
  ASSERT_EQ(report.size(), 2u);
  EXPECT_EQ(report[0]["input"], "lamp.json");
  EXPECT_EQ(report[0]["status"], "optimal");
  EXPECT_EQ(report[0]["light"]["litfog"], "light");
  EXPECT_TRUE(report[0]["reason"].is_null());
  EXPECT_EQ(report[1]["status"], "error");
  EXPECT_EQ(report[1]["reason"], "bad.json:1:1: litfog: must be given");
  EXPECT_TRUE(report[1]["light"].is_null());
}

TEST_F(FitCommand, SeveralInputsMakeALightEachATableAndTheWorstStatus) {
  fs::create_directory(directory() / "lights");
  write("bad.json", "{}");
  write("far.json", kInfeasible);
  const Outcome outcome = run("lamp.json far.json bad.json spot.ies -o lights");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_TRUE(has(outcome.err, "bad.json:1:1: litfog: must be given\n"));
  EXPECT_TRUE(has(outcome.err, "far.json: range: infeasible: "));
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 5);
  EXPECT_TRUE(outcome.out.starts_with("input "));
  for (const char* name : {"lights/lamp.json", "lights/far.json", "lights/spot.json"}) {
    EXPECT_TRUE(files().contains(name)) << name;
  }
  EXPECT_FALSE(files().contains("lights/bad.json"));
  EXPECT_EQ(run("lamp.json far.json").status, kNotToTolerance);
}

TEST_F(FitCommand, PhotometricFileIsALight) {
  ASSERT_EQ(run("spot.ies -o spot.json").status, kDone);
  const Light fitted = light("spot.json");
  EXPECT_EQ(fitted.name, "spot");
  EXPECT_EQ(fitted.color, glm::dvec3(1));
  EXPECT_EQ(fitted.attenuation.constant, 1);
  EXPECT_NEAR(candela(fitted).r, 100, 1e-12);
  EXPECT_EQ(fitted.source_radius, 0.05);
  const std::string report = run("spot.ies").out;
  EXPECT_TRUE(has(report, "The beam is not rotationally symmetric: --cookie keeps its shape, and is off by "));
  const std::string off = " % of the beam (rms)", together = ", asymmetry and cone together; the verdict judges each";
  EXPECT_TRUE(has(report, off + together));
  EXPECT_FALSE(has(run("spot.ies --cookie spot.exr --force").out, together)) << "a cookie has no asymmetry";
  const std::string details = run("spot.ies --details").out;
  EXPECT_TRUE(has(details, "down, the photometric axis; the peak is 0 deg off it"));
}

TEST_F(FitCommand, CookieIsTheDistributionByDirection) {
  ASSERT_EQ(run("spot.ies --cookie spot.exr --cookie-size 33").status, kDone);
  const auto& [size, texels] = read_cookie((directory() / "spot.exr").string());
  ASSERT_EQ(size, 33);
  const std::size_t last_face = 5 * 33 * 33;  // -z, the axis in its middle texel
  EXPECT_EQ(texels[last_face + 16 * 33 + 16], 1);
  const auto luminaire = read_luminaire((directory() / "spot.ies").string());
  EXPECT_EQ(texels, bake_cookie(luminaire.distribution, 33).texels);
}

TEST_F(FitCommand, CookiesAreTheSameToTheByteWheneverTheyAreWritten) {
  ASSERT_EQ(run("spot.ies --cookie a.exr --cookie-size 8").status, kDone);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // an EXR's date has seconds
  ASSERT_EQ(run("spot.ies --cookie b.exr --cookie-size 8").status, kDone);
  EXPECT_EQ(read("a.exr"), read("b.exr"));
}

TEST_F(FitCommand, PlotsArePicturesOfTheirEnding) {
  ASSERT_EQ(run("lamp.json --plot fit.png").status, kDone);
  EXPECT_EQ(read("fit.png").substr(1, 3), "PNG");
  ASSERT_EQ(run("beam.json --plot fit.svg").status, kDone);
  for (const char* label : {"range (m)", "angle from the axis (deg)", "smoothstep", "target", "error (%)",
                            "intensity (cd)", ">50 %<", ">10 %<", "threshold"}) {
    EXPECT_TRUE(has(read("fit.svg"), label));
  }
}

TEST_F(FitCommand, PlotNamesPlanesOfTheBeamAsItsDataSheetDoes) {
  write_spec("ellipse.json", R"("cone": {"beam_angle_deg": [24, 6]})");
  const auto expect_labels = [&](const std::string& arguments, const std::vector<const char*>& labels) {
    run(arguments + " --plot fit.svg");
    for (const char* label : labels) EXPECT_TRUE(has(read("fit.svg"), label)) << arguments;
  };
  expect_labels("spot.ies", {"intensity (cd)", ">C0-C180<", ">C90-C270<"});
  expect_labels("spot.ies --axis 0,5", {">turn 0-180°<", ">turn 90-270°<"});
  expect_labels("ellipse.json", {"intensity / peak", ">horizontal<", ">vertical<"});
}

TEST_F(FitCommand, PlotOfLightsOfOneNameHasTheNamesOfTheirFiles) {
  for (const char* name : {"white.json", "red.json"}) {
    write_spec(name, R"("name": "edge", "range": {"extent_m": 50})");
  }
  EXPECT_EQ(run("white.json --against red.json --plot both.svg").status, kDone);
  for (const char* label : {">white.json<", ">red.json<", ">white.json / red.json<"}) {
    EXPECT_TRUE(has(read("both.svg"), label));
  }
}

TEST_F(FitCommand, PlotOfLightsOfVeryDifferentReachHasALogarithmicRange) {
  write_spec("near.json", R"("range": {"extent_m": 50})");
  write_spec("far.json", R"("range": {"extent_m": 50000,
        "samples": [{"range_m": 0, "attenuation": 1}, {"range_m": 50000, "attenuation": 0.05}]})");
  write_spec("farther.json", R"("range": {"extent_m": 60000})");
  const auto has_thousand = [&](const std::string& lights) {
    EXPECT_EQ(run(lights + " --plot both.svg").status, kDone) << lights;
    return read("both.svg").find(">1000<") != std::string::npos;
  };
  EXPECT_TRUE(has_thousand("near.json --against far.json"));
  EXPECT_FALSE(has_thousand("farther.json --against far.json"));
}

TEST_F(FitCommand, ReportShowsNumbersAsTheyWereWritten) {
  write_spec("bright.json", R"("range": {"peak_cd": 1234567, "end_lx": 2.25})");
  EXPECT_TRUE(has(run("bright.json --details").out,
                  "sqrt((1 - 0.05) * 1234567 cd / 2.25 lx) = 721.985 m, where the light gives 2.25 lx."));
  write_spec("far.json", R"("range": {"extent_m": 450.123456, "threshold": 0.0123456})");
  EXPECT_TRUE(
      has(run("far.json --details").out, "450.123456 m, where the attenuation is 0.0123456 (wanted 450.123456 m)"));
  write_spec("beyond.json", R"("range": {"peak_cd": 12345.678, "constant": 20.1})");
  EXPECT_TRUE(has(run("beyond.json").err, " an extent of 108.298 m at threshold 0.05: from 0 to 19.99998 can\n"));
  EXPECT_TRUE(has(run("beyond.json").out, "poor: no attenuation has the extent and constant given"));
}

TEST_F(FitCommand, ReportHasNoErrorsThatAreRounding) {
  write_spec("one-angle.json", R"("cone": {"beam_angle_deg": 36})");
  const std::string report = run("one-angle.json --details").out;
  EXPECT_TRUE(has(report, "50 % angle off"));
  for (auto at = report.find(" %"); at != std::string::npos; at = report.find(" %", at + 1)) {
    EXPECT_NE(report.substr(at - 4, 2), "e-") << report.substr(at - 16, 20);
  }
}

TEST_F(FitCommand, AdviceNamesTheProfileWhoseFluxIsNearer) {
  const auto advice_on = [&](const std::string& angles, const std::string& candela) {
    write("lamp.ies", round_ies(angles, candela));
    return report_on("lamp.ies")["advice"].dump();
  };
  const std::string bright_to_the_end = advice_on("0 30 60 80 90", "100 95 80 70 60");
  EXPECT_TRUE(has(bright_to_the_end, "off by +24 %. With --profile cosine the flux is off by +1 %."));
  const std::string wide_spill = advice_on("0 5 10 15 90", "100 50 6 5 5");
  EXPECT_TRUE(has(wide_spill, "it leaves out much of the beam's spill"));
  EXPECT_FALSE(has(wide_spill, "--profile"));
}

TEST_F(FitCommand, LargeNumbersOfAReportHaveNoExponents) {
  write_spec("axis.json", R"("color": [12345678, 1, 1],
    "range": {"samples": [{"range_m": 1, "attenuation": 1}, {"range_m": 2, "attenuation": 1e-5},
                          {"range_m": 3, "attenuation": 1}]},
    "cone": {"samples": [{"angle_deg": 0, "intensity": 100}, {"angle_deg": 1, "intensity": 0},
                         {"angle_deg": 90, "intensity": 0}]})");
  const Outcome outcome = run("axis.json --details");
  EXPECT_TRUE(has(outcome.out, "degrees with 100 % of the peak"));
  for (const char* exponent : {"e+02", "e+03", "e+04", "e+05", "e+06", "e+07", "e+08"}) {
    EXPECT_FALSE(has(outcome.out + outcome.err, exponent));
  }
}

TEST_F(FitCommand, AdviceNamesASecondBeam) {
  const auto advice_on = [&](const std::string& candela, const std::string& options = "") {
    write("lamp.ies", round_ies("0 20 40 90 140 160 180", candela));
    return report_on("lamp.ies" + options)["advice"].dump();
  };
  EXPECT_TRUE(
      has(advice_on("100 50 5 0 5 40 80"), "A second beam, 80 % as bright, goes the other way: --axis up fits it"));
  EXPECT_TRUE(has(advice_on("100 50 5 0 5 40 80", " --axis up"), "--axis down fits it"));
  double both = 0;
  for (const char* axis : {"down", "up"}) {
    both += report_on(std::string("lamp.ies --axis ") + axis)["light_beam"]["flux_lm"].get<double>();
  }
  const std::string advice = run("lamp.ies").out;
  const auto at = advice.find("Both have ");
  ASSERT_NE(at, std::string::npos) << advice;
  EXPECT_NEAR(std::stod(advice.substr(at + 10)) / both, 1, 1e-3) << "of both lights as they are written";
  for (const char* candela : {"100 50 5 0 0 0 0", "100 50 5 0 0 5 10", "100 95 90 85 80 75 70"}) {
    EXPECT_FALSE(has(advice_on(candela), "second beam")) << candela;
  }
}

TEST_F(FitCommand, ReportHasFifteenLinesAtMostAndTheLightsCandelaBesideTheFiles) {
  write("wide.ies",
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 7 3 1 2 0 0 0\n1 1 10\n0 20 40 90 140 160 180\n0 90 180\n"
        "100 50 5 0 5 40 80\n10 90 60 20 5 40 80\n100 50 50 0 5 40 20\n");
  for (const char* input : {"wide.ies", "lamp.json", "beam.json", "spot.ies", "landing-lamp", "headlight-dipped"}) {
    const std::string report = run(input).out;
    EXPECT_LE(std::ranges::count(report, '\n'), 15) << report;
    const json whole = report_on(input);
    for (const auto& [name, member] : {std::pair("candela", "peak_cd"), {"lumens", "flux_lm"}}) {
      std::istringstream row(report.substr(report.find(std::string("\n  ") + name)));
      std::string word, data, light;
      row >> word >> data >> light;
      const auto expect_shown = [&, member = member](const std::string& shown, const char* beam) {
        if (whole[beam][member].is_null()) {
          EXPECT_EQ(shown, "-") << report;
        } else {
          EXPECT_NEAR(std::stod(shown) / whole[beam][member].get<double>(), 1, 1e-4) << report;
        }
      };
      expect_shown(data, "beam");
      expect_shown(light, "light_beam");
    }
    EXPECT_TRUE(has(report, whole["verdict"].get<std::string>() + ": " + whole["why"].get<std::string>() + "\n"));
  }
}

TEST_F(FitCommand, AxisIsAdvisedOnlyWhereItsConeIsNearerToTheBeam) {
  // Two wings of a street lamp: a cone about either is farther off than one about the axis between them.
  std::string wings =
      "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 10 5 1 2 0 0 0\n1 1 10\n0 10 20 30 40 50 60 70 80 90\n"
      "0 90 180 270 360\n";
  for (const char* plane : {"30 35 45 60 80 95 100 70 20 0\n", "30 28 25 20 15 10 5 2 1 0\n"}) wings += plane;
  wings += "30 35 45 60 80 95 100 70 20 0\n30 28 25 20 15 10 5 2 1 0\n30 35 45 60 80 95 100 70 20 0\n";
  write("street.ies", wings);
  // One wing in a dim surrounding, which keeps the axis down.
  write("aimed.ies",
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 10 5 1 2 0 0 0\n1 1 10\n0 10 20 30 40 50 60 70 80 90\n"
        "0 90 180 270 360\n95 100 95 70 40 20 10 5 0 0\n90 70 40 20 10 5 0 0 0 0\n"
        "90 60 30 10 5 0 0 0 0 0\n90 70 40 20 10 5 0 0 0 0\n95 100 95 70 40 20 10 5 0 0\n");
  const auto error_of = [&](const std::string& arguments) {
    return report_on(arguments)["light_beam"]["beam_error"].get<double>();
  };
  bool is_some_advised = false;
  for (const char* input : {"street.ies", "aimed.ies"}) {
    const double down = error_of(std::string(input) + " --axis down");
    const double peak = error_of(std::string(input) + " --axis peak");
    const std::string report = run(std::string(input) + " --axis down").out;
    const bool is_advised = report.find("--axis peak") != std::string::npos;
    EXPECT_EQ(is_advised, peak < 0.95 * down) << report << peak << " " << down;
    is_some_advised = is_some_advised || is_advised;
  }
  EXPECT_FALSE(has(run("street.ies").out, "--axis peak"));
  EXPECT_TRUE(is_some_advised);
}

TEST_F(FitCommand, AdviceNamesThePeakOfOneAngleAndColorsInBytes) {
  const auto has_advice = [&](const std::string& members, const std::string& part) {
    write_spec("spec.json", members);
    return report_on("spec.json")["advice"].dump().find(part) != std::string::npos;
  };
  const std::string of_flux = "the peak that follows from the flux";
  const std::string beam = R"("range": {"flux_lm": 900}, "cone": {"beam_angle_deg": 36)";
  EXPECT_TRUE(has_advice(beam + "}", of_flux));
  EXPECT_FALSE(has_advice(beam + R"(, "field_angle_deg": 60})", of_flux));
  EXPECT_TRUE(has_advice(R"("color": [255, 200, 100], "range": {"extent_m": 100})", "color reaches 255"));
  EXPECT_FALSE(has_advice(R"("color": [0, 0, 13.85], "range": {"extent_m": 100})", "color"));
  const std::string of_luminance = "color's luminance is 0.5";
  EXPECT_TRUE(has_advice(R"("color": [0.5, 0.5, 0.5], "range": {"peak_cd": 100})", of_luminance));
  EXPECT_FALSE(has_advice(R"("color": [0.5, 0.5, 0.5], "range": {"extent_m": 100})", of_luminance));
  write_spec("dim.json", R"("color": [0.5, 0.5, 0.5], "range": {"peak_cd": 100})");
  EXPECT_TRUE(run("dim.json").err.starts_with("dim.json: poor: intensity off by -50 %"));
  EXPECT_FALSE(has_advice(R"("color": [1.727, 0.864, 0.207], "range": {"peak_cd": 100})", "color"));
  const std::string of_size = "a source radius of 0.05 m is taken";
  EXPECT_TRUE(has_advice(R"("range": {"peak_cd": 100})", of_size));
  EXPECT_FALSE(has_advice(R"("source_radius_m": 0.05, "range": {"peak_cd": 100})", of_size));
  std::string wide = kIes;
  wide.replace(wide.find("1 2 0 0 0"), 9, "1 2 8 3 0");
  write("wide.ies", wide);
  EXPECT_TRUE(has_advice(R"("cone": {"photometry": "wide.ies"})", "2.76 m, of the luminous opening, is more than"));
}

TEST_F(FitCommand, ValuesOfAnotherKindAreAnsweredWithTheirRule) {
  const auto expect_rule = [&](const std::string& members, const std::string& end) {
    write_spec("spec.json", members);
    const std::string message = run("spec.json").err;
    EXPECT_TRUE(message.ends_with(end + "\n")) << message;
  };
  expect_rule(R"("range": {"extent_m": 9}, "power_w": 9)", "density_scale, source_radius_m, flash, range, cone");
  expect_rule(R"("range": {"samples": [{"range_m": 1, "attenuation": 900}, {"range_m": 2, "attenuation": 225}]})",
              "must be in [1e-100, 1]; lx belong in illuminance");
  expect_rule(R"("cone": {"beam_angle_deg": {"horizontal": 20, "vertical": 10}})",
              "must be a number, or an array of two: horizontal and vertical");
  expect_rule(R"("range": {"extent_m": 9,})", "must be a member's name in quotes; leave out the comma before it");
  expect_rule(R"("color": [1, 1, 1,], "range": {"extent_m": 9})", "; leave out the comma before it");
  write("header.csv", "candela,horizontal,vertical\n9,2,1\n");
  EXPECT_TRUE(has(run("header.csv").err, "header = candela,horizontal,vertical: must be "));
}

TEST_F(FitCommand, BadInputIsAnErrorAndNothingIsWritten) {
  write("bad.json", "{\"litfog\": \"light-spec\", \"version\": 1,\n \"range\": {\"samples\": []}}");
  const Outcome outcome = run("bad.json -o light.json --plot fit.svg");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("bad.json:2:23: range.extent_m: must be given, or ")) << outcome.err;
  write("hostile.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2147483648 2147483648 1 2 0 0 0\n1 1 10\n");
  const Outcome hostile = run("hostile.ies -o light.json");
  EXPECT_EQ(hostile.status, kBadInput);
  EXPECT_TRUE(hostile.err.starts_with("hostile.ies:3:")) << hostile.err;
  EXPECT_EQ(run("absent.json -o light.json").status, kBadInput);
  EXPECT_EQ(run("absent.ies -o light.json").status, kBadInput);
  EXPECT_EQ(run("lamp.json -o light.json --cookie c.exr").status, kBadInput);
  for (const char* name : {"light.json", "fit.svg", "c.exr"}) EXPECT_FALSE(files().contains(name)) << name;
}

TEST_F(FitCommand, EarlierLightStaysWhereTheSpecHasAnError) {
  write("light.json", "earlier");
  write("bad.json", "{");
  EXPECT_EQ(run("bad.json -o light.json").status, kBadInput);
  EXPECT_EQ(read("light.json"), "earlier");
}

TEST_F(FitCommand, FolderOfSeveralLightsIsMade) {
  EXPECT_EQ(run("lamp.json beam.json -o lights").status, kDone);
  EXPECT_TRUE(fs::exists(directory() / "lights" / "lamp.json"));
  EXPECT_TRUE(fs::exists(directory() / "lights" / "beam.json"));
  EXPECT_EQ(run("lamp.json beam.json -o none/lights").status, kCannotWrite);
  EXPECT_FALSE(fs::exists(directory() / "none"));
}

TEST_F(FitCommand, WrongUsageIsAnErrorBeforeAnyWork) {
  expect_usage_error("lamp.json beam.json -o light.json", "-o = light.json: must be a folder for several inputs");
  expect_usage_error("lamp.json beam.json --plot a.png",
                     "--plot cannot be given with several inputs: it shows a single light");
  expect_usage_error("lamp.json beam.json --cookie a.exr",
                     "--cookie cannot be given with several inputs: it shows a single light");
  expect_usage_error("lamp.json --plot a.pdf", "--plot = a.pdf: must end in .png or .svg");
  expect_usage_error("spot.ies --cookie a.png", "--cookie = a.png: must end in .exr");
  expect_usage_error("spot.ies --cookie-size 64", "--cookie-size requires --cookie");
  expect_usage_error("spot.ies --cookie a.exr --cookie-size 0", "--cookie-size = 0: must be an integer from 1 to 4096");
  expect_usage_error("lamp.json --profile round", "--profile = round: must be one of cosine|smoothstep|best");
  expect_usage_error("lamp.json -o lamp.json", "-o = lamp.json: must not be a file that is read, lamp.json");
  expect_usage_error("lamp.json -o .", "-o = ./lamp.json: must not be a file that is read, lamp.json");
  for (const char* option : {"-o", "--plot", "--cookie"}) {
    expect_usage_error(std::string("spot.ies ") + option + " ''", std::string(option) + " = \"\": must not be empty");
  }
  expect_usage_error("lamp.json ''", "input = \"\": must not be empty");
  EXPECT_EQ(run("").status, kUsage);
  EXPECT_EQ(run("lamp.json --colour").status, kUsage);
  fs::create_directory(directory() / "a");
  write("a/lamp.json", kBeam);
  fs::create_directory(directory() / "folder");
  expect_usage_error("lamp.json a/lamp.json -o folder", "-o = folder/lamp.json: must not be the file of two inputs");
  EXPECT_EQ(read("lamp.json"), kSpec);
}

TEST_F(FitCommand, OptionWithoutEffectIsAnErrorBeforeAnythingIsWritten) {
  write_spec("reach.json", R"("range": {"extent_m": 100})");
  expect_usage_error("spot.ies --force", "--force cannot be given with no output: it replaces files");
  expect_usage_error("spot.ies beam.json --details",
                     "--details cannot be given with several inputs: it shows a single light");
  expect_usage_error("spot.ies --details --format csv",
                     "--details cannot be given with --format csv or json: json has all");
  expect_usage_error("spot.ies -o a.json --robust",
                     "--robust cannot be given with spot.ies: there is no falloff table");
  expect_usage_error("spot.ies beam.json --robust",
                     "--robust cannot be given with these inputs: there is no falloff table");
  EXPECT_EQ(run("spot.ies lamp.json --robust").status, kDone);
  expect_usage_error("reach.json -o a.json --profile best",
                     "--profile cannot be given with reach.json: there is no cone to fit");
  EXPECT_EQ(run("reach.json beam.json --profile best").status, kDone);
  // What is wrong with an input comes first.
  EXPECT_EQ(run("spot.ies absent.json --robust").status, kBadInput);
}

TEST_F(FitCommand, OutputThatReplacesAnInputOrAnotherOutputIsAnErrorBeforeAnythingIsWritten) {
  write_spec("spot.json", R"("cone": {"photometry": "tilted.ies"})");
  std::string tilted = kIes;
  tilted.replace(tilted.find("NONE"), 4, "lamp.tlt");
  write("tilted.ies", tilted);
  write("lamp.tlt", "1 2\n0 90\n1 0.8\n");
  expect_usage_error("spot.json -o tilted.ies", "-o = tilted.ies: must not be a file that is read, tilted.ies");
  expect_usage_error("spot.json -o lamp.tlt", "-o = lamp.tlt: must not be a file that is read, lamp.tlt");
  expect_usage_error("spot.json -o ./lamp.tlt", "-o = ./lamp.tlt: must not be a file that is read, lamp.tlt");
  expect_usage_error("spot.json -o a.svg --plot ./a.svg", "--plot = ./a.svg: must not be the file of -o");
  expect_usage_error("spot.json -o a.exr --cookie a.exr", "--cookie = a.exr: must not be the file of -o");
  EXPECT_EQ(read("tilted.ies"), tilted);
  EXPECT_EQ(read("lamp.tlt"), "1 2\n0 90\n1 0.8\n");
}

TEST_F(FitCommand, OutputReplacesNothingButALightThatWasFitted) {
  const std::string reason =
      ": cannot be written: exists, and is no light that litfog-fit has written; --force replaces it";
  const std::string by_hand = R"({"litfog": "light", "version": 1, "attenuation": {"constant": 1}})";
  for (const std::string& text : {std::string(kBeam), std::string(kIes), by_hand, std::string("{\"litfog\": \"light"),
                                  std::string(R"({"litfog": "scene", "version": 1, "fit": {}})")}) {
    write("earlier.json", text);
    EXPECT_ERROR(run("lamp.json -o earlier.json --plot earlier.svg"), kCannotWrite,
                 "lamp.json: earlier.json" + reason + "\n");
    EXPECT_EQ(read("earlier.json"), text);
    EXPECT_FALSE(files().contains("earlier.svg"));
  }
  write("earlier.json", "");
  EXPECT_EQ(run("spot.ies -o earlier.json").status, kDone) << "nothing is lost";
  const std::string spot = read("earlier.json");
  EXPECT_EQ(run("lamp.json -o earlier.json").status, kDone) << "a light that was fitted";
  EXPECT_NE(read("earlier.json"), spot);
  EXPECT_EQ(run("lamp.json -o /dev/stdout").status, kDone);

  write("earlier.ies", kIes);
  EXPECT_EQ(run("lamp.json -o earlier.ies").status, kCannotWrite);
  EXPECT_EQ(run("lamp.json -o earlier.ies --force").status, kDone);
  EXPECT_EQ(light("earlier.ies").name, "flood");

  fs::create_directory(directory() / "lights");
  write("lights/beam.json", kBeam);
  const Outcome outcome = run("lamp.json beam.json spot.ies -o lights");
  EXPECT_EQ(outcome.status, kCannotWrite);
  EXPECT_EQ(outcome.err, "beam.json: lights/beam.json" + reason + "\n");
  EXPECT_EQ(read("lights/beam.json"), kBeam);
  for (const char* other : {"lights/lamp.json", "lights/spot.json"}) EXPECT_TRUE(files().contains(other)) << other;
}

TEST_F(FitCommand, PictureReplacesNothingButAPictureOfItsKind) {
  for (const auto& [option, name] : {std::pair("--plot", "a.svg"), {"--plot", "a.png"}, {"--cookie", "a.exr"}}) {
    const std::string arguments = std::string("spot.ies ") + option + " " + name;
    const auto is_holiday = [&, name = name] { return read(name) == "holiday"; };
    write(name, "holiday");
    EXPECT_ERROR(run(arguments), kCannotWrite,
                 std::string("litfog-fit: ") + name + ": cannot be written: exists, and is no " +
                     std::string(name).substr(2) + " file; --force replaces it\n");
    EXPECT_TRUE(is_holiday());
    EXPECT_EQ(run(arguments + " --force").status, kDone);
    EXPECT_FALSE(is_holiday());
    EXPECT_EQ(run(arguments).status, kDone) << "its own kind";
  }
}

TEST_F(FitCommand, InputThatNoFitTakesIsNamedAndTheOthersAreFitted) {
  write("tiny.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1e-300 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n100 100\n");
  fs::create_directory(directory() / "lights");
  const Outcome outcome = run("beam.json tiny.ies spot.ies -o lights");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.err,
            "tiny.ies:7:1: largest intensity = 1e-298: must give an extent: extent = 9.746794344808963e-150: must be "
            "in [1e-30, 1e30]\n");
  EXPECT_TRUE(files().contains("lights/beam.json"));
  EXPECT_TRUE(files().contains("lights/spot.json"));
  EXPECT_FALSE(files().contains("lights/tiny.json"));
}

TEST_F(FitCommand, FactorThatTakesIntensitiesOutOfRangeIsAnErrorOfItsFileAlone) {
  std::string bright = kIes;
  bright.replace(bright.find("TILT=NONE"), 9, "TILT=INCLUDE\n1 2\n0 90\n1e300 1e300");
  write("bright.ies", bright);
  write("faint.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1e-300 2 1 1 2 0 0 0\n1 1 0\n0 90\n0\n100 100\n");
  write_spec("raised.json", R"("range": {"peak_cd": 1e30}, "cone": {"photometry": "faint.ies"})");
  fs::create_directory(directory() / "lights");
  const Outcome outcome = run("bright.ies raised.json spot.ies -o lights");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.err,
            "bright.ies:11:1: largest intensity = 100: must be in (0, 1e30] times the tilt factor 1e+300\n"
            "faint.ies:7:1: largest intensity = 1e-298: must be in (0, 1e30] times the spec's factor inf\n");
  EXPECT_TRUE(files().contains("lights/spot.json"));
  EXPECT_FALSE(files().contains("lights/bright.json"));
  EXPECT_FALSE(files().contains("lights/raised.json"));
}

TEST_F(FitCommand, OutputThatCannotBeWrittenIsItsOwnStatus) {
  const Outcome outcome = run("lamp.json -o absent/light.json");
  EXPECT_EQ(outcome.status, kCannotWrite);
  EXPECT_EQ(outcome.err, "litfog-fit: absent/light.json: cannot be written: no folder absent\n");
  EXPECT_EQ(run("lamp.json --plot absent/fit.svg").status, kCannotWrite);
  EXPECT_EQ(run("lamp.json >/dev/full").status, kCannotWrite);
}

TEST_F(FitCommand, PlotIsAMissingCapabilityWithoutGnuplot) {
  const Outcome outcome = run("lamp.json -o light.json --plot fit.svg", "PATH=/nowhere");
  EXPECT_EQ(outcome.status, kMissingCapability);
  EXPECT_FALSE(files().contains("light.json"));
}

// ---- what the report says is so ----

TEST_F(FitCommand, ReportHasTheIlluminanceOfTheLightNearAndFar) {
  write_spec("near.json", R"("source_radius_m": 0.5, "range": {"peak_cd": 1000})");
  const std::string report = run("near.json --details").out;
  EXPECT_TRUE(has(report, "  source radius   0.5 m\n"));
  EXPECT_TRUE(has(report, "\nIlluminance without the attenuation's clamp at 1\n"));
  std::istringstream rows(report.substr(report.find("range_m")));
  std::string columns;
  std::getline(rows, columns);
  for (const double range : {1., 3., 10., 30., 100.}) {
    double shown = 0, lux = 0, data = 0, error = 0;
    rows >> shown >> lux >> data >> error;
    EXPECT_EQ(shown, range);
    const double wanted = 1000 / (range * range + 0.25);
    EXPECT_NEAR(lux / wanted, 1, 1e-4) << range;
    EXPECT_NEAR(data, 1000 / (range * range), 1e-4 * data);
    EXPECT_NEAR(error, 100 * (wanted / data - 1), 0.005 * std::abs(error));
  }
  write_spec("reach.json", R"("range": {"extent_m": 100})");
  EXPECT_FALSE(has(run("reach.json --details").out, "data_lx")) << "nothing is stated";
  write_spec("clamped.json", R"("source_radius_m": 0, "range": {"peak_cd": 1000})");
  const std::string clamped = run("clamped.json --details").out;
  EXPECT_TRUE(has(clamped, "\nIlluminance\n"));
  EXPECT_FALSE(has(clamped, "without the"));
}

TEST_F(FitCommand, TableOfIlluminanceIsJudgedByItsLargestError) {
  const auto run_table = [this](const std::string& rows) {
    write_spec("table.json",
               R"("source_radius_m": 0.001, "range": {"illuminance": [{"range_m": 10, "lx": 100}, )" + rows + "]}");
    return run("table.json --details");
  };
  const Outcome outcome = run_table(R"({"range_m": 20, "lx": 1})");  // 2000 cd: 20 and 5 lx
  EXPECT_EQ(outcome.status, kNotToTolerance);
  EXPECT_EQ(outcome.err, "table.json: poor: illuminance at 20 m off by +400 %\n");
  EXPECT_TRUE(has(outcome.out, "it is that of 400 cd at 20 m and of 10000 cd at 10 m"));
  std::istringstream rows(outcome.out.substr(outcome.out.find("range_m  light_lx") + 40));
  std::string row;
  while (std::getline(rows, row) && !row.starts_with("       20")) continue;
  double range = 0, lux = 0, data = 0, error = 0;
  std::istringstream(row) >> range >> lux >> data >> error;
  EXPECT_NEAR(lux, 5, 1e-5);
  EXPECT_EQ(data, 1) << "the row's own";
  EXPECT_EQ(error, 400);
  const json report = report_on("table.json");
  EXPECT_NEAR(report["light_beam"]["illuminance_error"].get<double>(), 2000 / (400 + 1e-6) - 1, 1e-12);
  EXPECT_TRUE(has(run_table(R"({"range_m": 20, "lx": 25}, {"range_m": 40, "lx": 3})").err, "at 40 m off by +63.1 %"));
  EXPECT_TRUE(has(run_table(R"({"range_m": 20, "lx": 25})").out, "good: what is stated is met\n"));
}

TEST_F(FitCommand, ErrorsOfAFalloffTableAreTheSameSignedFractionsInTextAndJson) {
  write_spec("table.json", R"("range": {"constant": 1, "samples": [
    {"range_m": 1, "attenuation": 0.9}, {"range_m": 2, "attenuation": 0.7}, {"range_m": 4, "attenuation": 0.38},
    {"range_m": 6, "attenuation": 0.4}, {"range_m": 8, "attenuation": 0.14}]})");
  const json report = report_on("table.json");
  const auto& attenuation = report["light"]["attenuation"];
  const Attenuation fitted{attenuation["constant"], attenuation["linear"], attenuation["quadratic"]};
  const double error = attenuation_at(fitted, 6) / 0.4 - 1;
  ASSERT_LT(error, -0.2) << "the sample that is farthest off, too dark";
  EXPECT_NEAR(report["light"]["fit"]["range"]["largest_error"].get<double>(), error, 1e-12);
  EXPECT_LT(report["light"]["fit"]["range"]["rms"].get<double>(), -error);
  char percent[32];
  std::snprintf(percent, sizeof percent, "%.3g %%", 100 * error);
  const std::string text = run("table.json --details").out;
  EXPECT_TRUE(has(text, "largest " + std::string(percent)));
  EXPECT_TRUE(has(text, "by " + std::string(percent) + " at one sample"));
}

TEST_F(FitCommand, UplightsConePointsUp) {
  // The beam of a spot, turned over: measured from 90 to 180 degrees.
  write("up.ies", round_ies("90 150 160 165 170 175 180", "0 0 10 30 62 90 100"));
  write("down.ies", round_ies("0 5 10 15 20 30 90", "100 90 62 30 10 0 0"));
  const json up = report_on("up.ies"), down = report_on("down.ies");
  EXPECT_EQ(up["axis"], "up, opposite to the photometric axis");
  EXPECT_EQ(down["axis"], "down, the photometric axis");
  for (const char* angle : {"half_angle_deg", "exponent"}) {
    EXPECT_NEAR(up["light"]["cone"][angle].get<double>(), down["light"]["cone"][angle].get<double>(), 1e-6) << angle;
  }
  EXPECT_EQ(up["verdict"], "good") << up["why"];
  EXPECT_EQ(run("up.ies").status, kDone);
  EXPECT_EQ(run("up.ies --axis down").status, kNotToTolerance) << "nothing of the beam is about that axis";
}

TEST_F(FitCommand, AxisIsThePeakOfABeamAimedElsewhereOrAsAsked) {
  // 100 cd at C = 0, gamma = 40.
  std::string file = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 37 73 1 2 0 0 0\n1 1 10\n";
  for (int gamma = 0; gamma <= 180; gamma += 5) file += std::to_string(gamma) + "\n";
  for (int c = 0; c <= 360; c += 5) file += std::to_string(c) + "\n";
  for (int c = 0; c <= 360; c += 5) {
    for (int gamma = 0; gamma <= 180; gamma += 5) {
      const double cosine = std::sin(gamma * pi / 180) * std::cos(c * pi / 180) * std::sin(40 * pi / 180) +
                            std::cos(gamma * pi / 180) * std::cos(40 * pi / 180);
      file += std::to_string(100 * std::pow(std::max(0.0, cosine), 20)) + "\n";
    }
  }
  write("aimed.ies", file);
  const auto axis_of = [&](const std::string& options) {
    return report_on("aimed.ies " + options)["axis"].get<std::string>();
  };
  EXPECT_EQ(axis_of(""), "40 deg from the photometric axis, --axis 0,40") << "found by itself";
  EXPECT_EQ(axis_of("--axis peak"), axis_of(""));
  EXPECT_EQ(axis_of("--axis 0,40"), axis_of("")) << "as it was told";
  EXPECT_EQ(axis_of("--axis 90,25"), "25 deg from the photometric axis, --axis 90,25");
  EXPECT_EQ(axis_of("--axis down"), "down, the photometric axis");
  EXPECT_EQ(axis_of("--axis up"), "up, opposite to the photometric axis");
  EXPECT_EQ(run("aimed.ies").status, kDone);
  EXPECT_EQ(run("aimed.ies --axis down").status, kNotToTolerance);
  ASSERT_EQ(run("aimed.ies --cookie aimed.exr --cookie-size 33").status, kDone);
  const auto cookie = read_cookie((directory() / "aimed.exr").string());
  EXPECT_NEAR(cookie.texels[5 * 33 * 33 + 16 * 33 + 16], 1, 1e-6) << "the peak is on the cookie's axis";
  const std::string rule = "must be peak, down, up or two angles H,V in degrees, each from -360 to 360";
  for (const char* wrong : {"left", "3", "3,", ",3", "1,2,3", "nan,0", "0,361"}) {
    expect_usage_error(std::string("aimed.ies --axis ") + wrong, std::string("--axis = ") + wrong + ": " + rule);
  }
  expect_usage_error("lamp.json --axis up", "--axis cannot be given with lamp.json: there is no photometric file");
}

TEST_F(FitCommand, AxisOfANarrowBeamIsItsPeakHoweverNear) {
  std::string table = "# aimed 4 degrees up\nvertical_deg";
  for (int h = -16; h <= 16; ++h) table += "," + std::to_string(h / 2.0);
  for (int v = -10; v <= 26; ++v) {
    table += "\n" + std::to_string(v / 2.0);
    for (int h = -16; h <= 16; ++h) {
      table += "," + std::to_string(1000 * std::exp2(-(h * h + (v - 8) * (v - 8)) / 16.0));
    }
  }
  write("aimed.csv", table);
  const json report = report_on("aimed.csv");
  EXPECT_EQ(report["axis"], "4 deg from the photometric axis, --axis 0,4");
  EXPECT_EQ(report["verdict"], "good") << report["why"];
  EXPECT_NEAR(report["beam"]["beam_angle_deg"].get<double>(), 4, 0.05);
  EXPECT_EQ(report_on("aimed.csv --axis 0,4")["axis"], report["axis"]);
  EXPECT_EQ(report_on("aimed.csv --axis down")["axis"], "ahead, the photometric axis");
}

TEST_F(FitCommand, AxisOfAnIsocandelaTableIsToTheRightAndAbove) {
  write("ellipses.csv", "candela,horizontal_deg,vertical_deg\n5000,7,5\n500,11.5,6\n");
  write("grid.csv", "vertical_deg,-10,0,10\n10,10,20,10\n0,20,50,20\n-10,10,20,10\n");
  for (const char* table : {"ellipses.csv", "grid.csv"}) {
    const json report = report_on(std::string(table) + " --axis -5,2");
    EXPECT_EQ(report["axis"], "5.384 deg from the photometric axis, --axis -5,2") << table;
  }
}

TEST_F(FitCommand, ContoursAreFirstToldToBeMinima) {
  write("ellipses.csv", "candela;horizontal_deg;vertical_deg\n5000;7,5;5\n500;11,5;6\n");
  write("grid.csv", "vertical_deg,-10,0,10\n10,10,20,10\n0,20,50,20\n-10,10,20,10\n");
  const std::string advice = report_on("ellipses.csv")["advice"][0];
  EXPECT_TRUE(advice.starts_with("5000 cd is what the inner ellipse states. A standard's are minima")) << advice;
  EXPECT_FALSE(has(report_on("grid.csv")["advice"].dump(), "minima"));
}

TEST_F(FitCommand, DerivedFiguresAreToldWithTheirSteps) {
  write_spec("steps.json", R"("source": "maker", "color_temperature_k": 3200,
    "range": {"flux_lm": 900, "end_lx": "night"}, "cone": {"beam_angle_deg": [24, 6], "field_angle_deg": [48, 12]})");
  const json report = report_on("steps.json");
  ASSERT_EQ(report["derived"].size(), 6u) << "color, two angles, peak, extent, color";
  EXPECT_EQ(report["light"]["source"].size(), 7u) << "the maker's and the steps";
  EXPECT_EQ(report["beam"]["flux_lm"], 900);
  EXPECT_EQ(report["beam"]["beam_angle_deg"], json({24, 6}));
  EXPECT_EQ(report["beam"]["field_angle_deg"], json({48, 12}));
  EXPECT_EQ(report["verdict"], "poor") << "half of the beam is not round";
  const std::string text = run("steps.json --details").out;
  for (const auto& step : report["derived"]) EXPECT_TRUE(has(text, step.get<std::string>())) << step;
  EXPECT_TRUE(has(text, "24 deg horizontally, 6 deg vertically"));
  EXPECT_TRUE(has(text, "--cookie keeps its shape"));
}

TEST_F(FitCommand, CookieOfAnEllipticalBeamIsElliptical) {
  write_spec("oval.json", R"("range": {"extent_m": 9},
    "cone": {"beam_angle_deg": [60, 20], "field_angle_deg": [90, 30]})");
  run("oval.json --cookie oval.exr --cookie-size 65");
  const auto cookie = read_cookie((directory() / "oval.exr").string());
  const auto at = [&cookie](double horizontal_deg, double vertical_deg) {
    return cookie_at(cookie, direction_of(PhotometryType::a, horizontal_deg * pi / 180, vertical_deg * pi / 180));
  };
  EXPECT_NEAR(at(0, 0), 1, 0.01);
  EXPECT_NEAR(at(30, 0), 0.5, 0.05);
  EXPECT_NEAR(at(0, 10), at(30, 0), 0.01);
  EXPECT_NEAR(at(0, -15), at(-45, 0), 0.01);
  EXPECT_LT(at(0, 30), 0.001);
}

TEST_F(FitCommand, AnglesThatAFileDoesNotStateAreDarkInFitAndErrors) {
  // Still as bright as on the axis where the file ends, at 60 degrees.
  write("cut.ies", round_ies("0 5 10 15 20 25 30 35 40 45 50 55 60", "7 7 7 7 7 7 7 7 7 7 7 7 7"));
  const json report = report_on("cut.ies");
  EXPECT_NEAR(report["beam"]["flux_lm"].get<double>(), 7 * pi, 1e-9);
  const auto& fit = report["light"]["fit"]["cone"];
  for (const char* profile : {"cosine", "smoothstep"}) {
    const auto& given = fit[profile]["cone"];
    const auto radians = [&](const char* name) { return given[name].get<double>() * pi / 180; };
    const Cone cone = std::string(profile) == "cosine" ? Cone::cosine(radians("half_angle_deg"), given["exponent"])
                                                       : Cone::smoothstep(radians("inner_deg"), radians("outer_deg"));
    const double flux_error = flux_within(cone, pi) / pi - 1;
    EXPECT_LT(std::abs(flux_error), 0.01) << profile;
    EXPECT_NEAR(fit[profile]["flux_error"].get<double>(), flux_error, 1e-3) << profile;
  }
}

TEST_F(FitCommand, VerdictTellsAPoorLightWhateverItsProof) {
  // A narrow beam in a wide spill that has most of the light.
  write("spill.ies", round_ies("0 1 2 3 4 5 30 60 90", "1000 900 500 200 60 30 30 30 0"));
  const Outcome outcome = run("spill.ies --format json -o light.json");
  EXPECT_EQ(outcome.status, kNotToTolerance);
  EXPECT_TRUE(outcome.err.starts_with("spill.ies: poor: flux off by -")) << outcome.err;
  const auto report = json::parse(outcome.out)[0];
  EXPECT_EQ(report["status"], "optimal");
  EXPECT_EQ(report["verdict"], "poor");
  EXPECT_EQ("spill.ies: poor: " + report["why"].get<std::string>() + "\n", outcome.err);
  EXPECT_TRUE(files().contains("light.json")) << "the best light";
  EXPECT_TRUE(has(run("spill.ies").out, "\n  poor: flux off by -"));
  // The same beam as a table of a spec.
  write_spec("spill.json", R"("range": {"peak_cd": 1000}, "cone": {"samples": [
      {"angle_deg": 0, "intensity": 1000}, {"angle_deg": 1, "intensity": 900}, {"angle_deg": 2, "intensity": 500},
      {"angle_deg": 3, "intensity": 200}, {"angle_deg": 4, "intensity": 60}, {"angle_deg": 5, "intensity": 30},
      {"angle_deg": 30, "intensity": 30}, {"angle_deg": 60, "intensity": 30}, {"angle_deg": 90, "intensity": 0}]})");
  EXPECT_TRUE(run("spill.json").err.starts_with("spill.json: poor: flux off by -"));
  const json exact = report_on("beam.json");
  EXPECT_EQ(exact["verdict"], "good");
  EXPECT_NEAR(exact["beam"]["beam_angle_deg"].get<double>(), 11, 1e-12);
  EXPECT_NEAR(exact["beam"]["field_angle_deg"].get<double>(), 22, 1e-12);
  EXPECT_TRUE(exact["beam"]["peak_cd"].is_null());
}

TEST_F(FitCommand, VerdictHasTheNumbersOfTheReport) {
  write_spec("rising.json", R"("range": {"samples": [
      {"range_m": 10, "attenuation": 0.1}, {"range_m": 20, "attenuation": 0.5}]})");
  const Outcome outcome = run("rising.json --details");
  EXPECT_EQ(outcome.err,
            "rising.json: poor: attenuation off by 95.7 % (rms); a sample of the attenuation off by +124 %\n");
  EXPECT_TRUE(has(outcome.out, "rms 95.7 %, largest +124 %, of the attenuation"));
}

TEST_F(FitCommand, ExponentAtItsBoundIsHeld) {
  write_spec("ring.json", R"("cone": {"profile": "cosine", "samples": [
      {"angle_deg": 0, "intensity": 10}, {"angle_deg": 30, "intensity": 100}, {"angle_deg": 60, "intensity": 10}]})");
  const std::string report = run("ring.json --details").out;
  EXPECT_TRUE(has(report, "held by         exponent = 0\n"));
  EXPECT_TRUE(has(report, "uncertainty     exponent held\n"));
}

TEST_F(FitCommand, BeamHasTwoAnglesWhereItIsNotRound) {
  const json beam = report_on("spot.ies")["beam"];
  EXPECT_NEAR(beam["peak_cd"].get<double>(), 100, 1e-9);
  ASSERT_EQ(beam["beam_angle_deg"].size(), 2u);
  EXPECT_NEAR(beam["beam_angle_deg"][0].get<double>(), 2 * 8.75, 1e-9);  // 80 at 5 degrees, 40 at 10
  EXPECT_NEAR(beam["beam_angle_deg"][1].get<double>(), 2 * 5, 1e-9);
}

TEST_F(FitCommand, FullAngleOfAnUnevenBeamIsTheSumOfItsHalves) {
  write("uneven.ies", R"(IESNA:LM-63-2002
TILT=NONE
1 -1 1 6 5 1 2 0 0 0
1 1 10
0 5 10 15 20 90
0 90 180 270 360
100 80 40 15 0 0
100 50 10 0 0 0
100 50 10 0 0 0
100 50 10 0 0 0
100 80 40 15 0 0
)");
  const json beam = report_on("uneven.ies --axis down")["beam"];
  ASSERT_EQ(beam["beam_angle_deg"].size(), 2u);
  EXPECT_NEAR(beam["beam_angle_deg"][0].get<double>(), 8.75 + 5, 1e-9);
  EXPECT_NEAR(beam["beam_angle_deg"][1].get<double>(), 5 + 5, 1e-9);
}

TEST_F(FitCommand, FilesOfOneNameAndTwoFormatsAreTwoLights) {
  fs::create_directory(directory() / "lights");
  fs::copy_file(LITFOG_TEST_DATA_DIR "/photometry/spelling.ldt", directory() / "spot.ldt");
  EXPECT_EQ(run("spot.ies spot.ldt beam.json -o lights").status, kDone);
  for (const char* name : {"lights/spot.ies.json", "lights/spot.ldt.json", "lights/beam.json"}) {
    EXPECT_TRUE(files().contains(name)) << name;
  }
}

// ---- many inputs ----

TEST_F(FitCommand, FilesInAContainerAreInputsNamedByTheirPathsInIt) {
  std::string product = "<Root><GeneralDefinitions><Files>";
  ZipEntries entries;
  for (const char* name : {"wide/lamp.ies", "narrow/lamp.ies", "spot.ies"}) {
    product += std::string("<File contentType=\"ldc/ies\" type=\"localFileName\">") + name + "</File>";
    entries.emplace_back(std::string("ldc/") + name, kIes);
  }
  entries.emplace_back("product.xml", product + "</Files></GeneralDefinitions></Root>");
  write_zip((directory() / "set.gldf").string(), entries);
  fs::create_directory(directory() / "lights");
  expect_done("set.gldf -o lights");
  for (const char* name : {"lights/set-wide-lamp.json", "lights/set-narrow-lamp.json", "lights/set-spot.json"}) {
    EXPECT_TRUE(files().contains(name)) << name;
  }
}

TEST_F(FitCommand, OutputThatAnotherInputReadsIsNotWritten) {
  fs::create_directory(directory() / "lights");
  write("lights/beam.json", kIes);
  write_spec("measured.json", R"("cone": {"photometry": "lights/beam.json"})");
  expect_usage_error("beam.json measured.json -o lights",
                     "-o = lights/beam.json: must not be a file that is read, lights/beam.json");
  EXPECT_EQ(read("lights/beam.json"), kIes);
}

/// The names in a table's first column.
std::vector<std::string> inputs_of(const std::string& csv) {
  std::vector<std::string> inputs;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) inputs.push_back(line.substr(0, line.find(',')));
  inputs.erase(inputs.begin());
  return inputs;
}

TEST_F(FitCommand, FolderStandsForTheSpecsAndPhotometricFilesInIt) {
  fs::create_directories(directory() / "lamps/deep");
  write("lamps/b.ies", kIes);
  write("lamps/deep/A.IES", kIes);
  write("lamps/beam.json", kBeam);
  write("lamps/LAMP.JSON", kBeam);
  write("lamps/light.json", R"({"litfog": "light", "version": 1})");
  write("lamps/notes.txt", "no lamp");
  write("lamps/page.xml", "<html/>");
  write("lamps/table.csv", "a,b\n1,2\n");
  const Outcome outcome = expect_done("lamps --format csv");
  EXPECT_EQ(inputs_of(outcome.out),
            (std::vector<std::string>{"lamps/LAMP.JSON", "lamps/b.ies", "lamps/beam.json", "lamps/deep/A.IES"}));
  fs::create_directory(directory() / "lights");
  EXPECT_EQ(run("lamps -o lights").status, kDone);
  for (const char* name : {"lights/LAMP.json", "lights/b.json", "lights/beam.json", "lights/deep-A.json"}) {
    EXPECT_TRUE(files().contains(name)) << name;
  }
  fs::create_directory(directory() / "empty");
  expect_usage_error("empty", "input = empty: must hold light specs or photometric files");
}

TEST_F(FitCommand, LinksThatLeadNowhereInAFolderArePassedOver) {
  fs::create_directory(directory() / "lamps");
  fs::create_symlink("loop.ies", directory() / "lamps/loop.ies");
  fs::create_symlink("gone", directory() / "lamps/gone.ies");
  fs::create_symlink(".", directory() / "lamps/same");
  write("lamps/spot.ies", kIes);
  const Outcome outcome = expect_done("lamps --format csv");
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(inputs_of(outcome.out), std::vector<std::string>{"lamps/spot.ies"});
}

TEST_F(FitCommand, WhatCannotBeReadInAFolderIsNamedAndTheOthersAreFitted) {
  using enum fs::perms;
  fs::permissions(directory(), owner_all | group_read | group_exec | others_read | others_exec);
  for (const char* folder : {"lamps/locked", "lamps/listed", "lamps/open"}) {
    fs::create_directories(directory() / folder);
    write(std::string(folder) + "/spot.ies", kIes);
    write(std::string(folder) + "/beam.json", kBeam);
  }
  write("lamps/secret.json", kBeam);
  write("lamps/secret.csv", "vertical_deg,0\n0,1\n");
  for (const char* file : {"secret.json", "secret.csv", "locked"}) fs::permissions(directory() / "lamps" / file, none);
  fs::permissions(directory() / "lamps/listed", owner_read | group_read | others_read);
  // No file is locked for root.
  const std::string user = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups" : "";
  const Outcome outcome = run("lamps spot.ies --format csv", user);
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.err,
            "lamps/listed/beam.json: cannot be read: Permission denied\n"
            "lamps/listed/spot.ies: cannot be read: Permission denied\n"
            "lamps/locked: cannot be searched: Permission denied\n"
            "lamps/secret.csv: cannot be read: Permission denied\n"
            "lamps/secret.json: cannot be read: Permission denied\n");
  for (const char* line : {"\nlamps/open/spot.ies,9.74679", "\nlamps/open/beam.json,100,", "\nspot.ies,9.74679"}) {
    EXPECT_TRUE(has(outcome.out, line));
  }
  const Outcome alone = run("lamps/locked spot.ies --format csv", user);
  EXPECT_EQ(alone.err, "lamps/locked: cannot be searched: Permission denied\n");
  EXPECT_TRUE(has(alone.out, "\nspot.ies,9.74679"));
  for (const char* folder : {"locked", "listed"}) fs::permissions(directory() / "lamps" / folder, owner_all);
}

TEST_F(FitCommand, InputOfAnyErrorIsNamedAndTheOthersAreFitted) {
  write("cut.xml", "<IESTM33-22><Header><Description>caf\xC3\xA9");  // an XML parser stops within the last character
  write_zip((directory() / "cut.gldf").string(), {{"product.xml", "<Root><a>\xC3\xA9"}});
  const Outcome outcome = run("cut.xml absent-light cut.gldf spot.ies --format csv");
  EXPECT_EQ(outcome.status, kBadInput);
  std::istringstream lines(outcome.err);
  std::string line;
  for (const char* begin :
       {"cut.xml:1:37: XML: must be well-formed: ", "absent-light: must be a file or a bundled light",
        "cut.gldf/product.xml:1:10: XML: must be well-formed: "}) {
    std::getline(lines, line);
    EXPECT_TRUE(line.starts_with(begin)) << line;
  }
  EXPECT_FALSE(std::getline(lines, line)) << line;
  EXPECT_EQ(inputs_of(outcome.out), (std::vector<std::string>{"cut.xml", "absent-light", "cut.gldf", "spot.ies"}));
  EXPECT_TRUE(has(outcome.out, "\nspot.ies,9.74679"));
}

TEST_F(FitCommand, LightThatCannotBeWrittenIsNamedAndTheOthersAreWritten) {
  const std::string lengthy(251, 'x');  // with .json beyond what a file's name may have
  const std::string other(251, 'y');
  for (const std::string& name : {lengthy, other}) write(name + ".ies", kIes);
  const Outcome outcome = run(lengthy + ".ies spot.ies beam.json " + other + ".ies -o lights");
  EXPECT_EQ(outcome.status, kCannotWrite);
  EXPECT_EQ(outcome.err, lengthy + ".ies: lights/" + lengthy + ".json: cannot be written: File name too long\n" +
                             other + ".ies: lights/" + other + ".json: cannot be written: File name too long\n");
  for (const char* name : {"lights/spot.json", "lights/beam.json"}) EXPECT_TRUE(files().contains(name)) << name;
}

TEST_F(FitCommand, BundledLightIsFoundByItsNameUnlessAFileHasIt) {
  EXPECT_ERROR(run("landing-lmap"), kBadInput,
               "landing-lmap: must be a file or a bundled light; did you mean landing-lamp?\n");
  EXPECT_TRUE(has(run("landing-lamp").out, "landing-lamp.json"));
  write("landing-lamp", kIes);
  EXPECT_TRUE(has(run("landing-lamp").out, "spot, from landing-lamp\n"));
  EXPECT_EQ(run("no-such-lamp").status, kBadInput);
}

TEST_F(FitCommand, TableHasTheErrorsOfEachLight) {
  write("bad.ies", "x");
  const Outcome outcome = run("lamp.json spot.ies bad.ies --format csv");
  EXPECT_EQ(outcome.status, kBadInput);
  std::istringstream lines(outcome.out);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line + ",");
    auto& row = rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  ASSERT_EQ(rows.size(), 4u);
  const auto cell = [&](std::size_t row, const std::string& column) {
    return rows[row][std::size_t(std::ranges::find(rows[0], column) - rows[0].begin())];
  };
  const auto report = json::parse(run("lamp.json spot.ies --format json").out);
  for (std::size_t i : {0u, 1u}) {
    const auto& fit = report[i]["light"]["fit"];
    const auto& cone = fit["cone"][fit["cone"]["profile"].get<std::string>()];
    EXPECT_DOUBLE_EQ(std::stod(cell(i + 1, "flux_%")), 100 * cone["flux_error"].get<double>());
    EXPECT_DOUBLE_EQ(std::stod(cell(i + 1, "rms_%")), 100 * cone["rms"].get<double>());
    const auto& beam = report[i]["light_beam"];
    EXPECT_DOUBLE_EQ(std::stod(cell(i + 1, "candela")), beam["peak_cd"].get<double>());
    EXPECT_DOUBLE_EQ(std::stod(cell(i + 1, "lumens")), beam["flux_lm"].get<double>());
    EXPECT_DOUBLE_EQ(std::stod(cell(i + 1, "50_%_deg")), beam["beam_angle_deg"].get<double>());
    EXPECT_EQ(cell(i + 1, "verdict"), report[i]["verdict"]);
    EXPECT_EQ(cell(i + 1, "advice"), std::to_string(report[i]["advice"].size()));
  }
  EXPECT_DOUBLE_EQ(std::stod(cell(1, "range_%")),
                   100 * report[0]["light"]["fit"]["range"]["largest_error"].get<double>());
  EXPECT_EQ(cell(2, "range_%"), "");
  EXPECT_DOUBLE_EQ(std::stod(cell(2, "data_cd")), 100);
  EXPECT_DOUBLE_EQ(std::stod(cell(2, "asymmetry")), report[1]["light"]["fit"]["asymmetry"].get<double>());
  EXPECT_EQ(cell(3, "status"), "error");
  EXPECT_EQ(cell(3, "verdict"), "");
}

TEST_F(FitCommand, LightsAreTheSameFromOneInputAndFromMany) {
  fs::create_directory(directory() / "lamps");
  fs::create_directory(directory() / "lights");
  for (int i = 0; i < 24; ++i) {
    std::string ies = kIes;
    ies.replace(ies.find("100 80"), 3, std::to_string(100 + i));
    write("lamps/" + std::to_string(i) + ".ies", ies);
  }
  ASSERT_EQ(run("lamps -o lights").status, kDone);
  for (const char* name : {"0", "7", "23"}) {
    ASSERT_EQ(run(std::string("lamps/") + name + ".ies -o one.json").status, kDone);
    EXPECT_EQ(read("one.json"), read(std::string("lights/") + name + ".json")) << name;
  }
}

TEST_F(FitCommand, LongNamesAreShortenedInPlots) {
  std::string name;
  for (int i = 0; i < 60; ++i) name += "é";
  write_spec("long.json", R"("name": ")" + name + R"(", "cone": {"beam_angle_deg": 20})");
  ASSERT_EQ(run("long.json --against beam.json --plot both.svg").status, kDone);
  const std::string svg = read("both.svg");
  EXPECT_TRUE(has(svg, ">" + name.substr(0, 2 * 40) + "…<"));
  EXPECT_FALSE(has(svg, name.substr(0, 2 * 55)));  // in the title
}

TEST_F(FitCommand, RingIsCalledOneAndNotABeamAimedElsewhere) {
  std::string ring = kIes;
  ring.replace(ring.find("100 80 40 15 0 0"), 16, "20 40 60 100 9 0");
  ring.replace(ring.find("100 50 10 0 0 0"), 15, "20 40 60 100 9 0");
  write("ring.ies", ring);
  const Outcome outcome = run("ring.ies");
  EXPECT_TRUE(has(outcome.out, "\n  on the axis, cd 20 ")) << outcome.out;
  EXPECT_TRUE(has(outcome.out, "The beam is a ring, brightest 15 degrees off the axis"));
  EXPECT_FALSE(has(outcome.out, "--axis peak"));
  EXPECT_FALSE(has(run("spot.ies").out, "ring"));
  EXPECT_FALSE(has(run("spot.ies").out, "on the axis"));
}

TEST_F(FitCommand, AdviceSaysThatARingsLightIsNearlyDark) {
  write("ring.ies", round_ies("0 10 20 30 40 50 60 65 70 90", "20 21 22 24 28 40 70 100 10 0"));
  const json report = report_on("ring.ies");
  const double flux = 100 * (1 + report["light_beam"]["flux_error"].get<double>());
  ASSERT_LT(flux, 10);
  const std::string advice = report["advice"].dump();
  EXPECT_TRUE(has(advice, fmt::format("The light is nearly dark: its cone has {:.2g} % of the beam's flux.", flux)))
      << advice;
  ASSERT_TRUE(has(advice, "--spill writes a second light for the rest."));
  const double both = std::stod(advice.substr(advice.find("Both have ") + 10));
  run("ring.ies -o light.json --spill spill.json");
  double written_flux = 0;
  for (const char* name : {"light.json", "spill.json"}) {
    const Light part = light(name);
    written_flux += candela(part).r * flux_within(part.cone, pi);
  }
  EXPECT_NEAR(both / written_flux, 1, 1e-3);
  write("spill.ies", round_ies("0 1 2 10 90", "1000 500 6 5 5"));
  EXPECT_TRUE(has(run("spill.ies").out, "The cone's flux is off by -")) << "a bright spot with little of the flux";
}

TEST_F(FitCommand, AdviceSaysThatAFileEndsWhereItsBeamIsBright) {
  const auto advice_on = [this](const std::string& name, const std::string& text) {
    write(name, text);
    return report_on(name)["advice"].dump();
  };
  const auto grid = [&](int edge) {
    return advice_on("grid.csv",
                     fmt::format("vertical_deg,-5,0,5\n-5,{0},{0},{0}\n0,{0},100,{0}\n5,{0},{0},{0}\n", edge));
  };
  EXPECT_TRUE(has(grid(80),
                  "The file ends where the beam has 80 % of its peak, and the light is dark beyond: the angles "
                  "at 50 % and 10 % may be those of the file's end."));
  EXPECT_TRUE(has(grid(40), "has 40 % of its peak, and the light is dark beyond: the angles at 10 % may be"));
  EXPECT_FALSE(has(grid(10), "The file ends"));
  EXPECT_TRUE(has(advice_on("mirrored.csv", "vertical_deg,0,5\n0,100,5\n5,70,5\n"), "has 70 % of its peak"));
  EXPECT_FALSE(has(advice_on("mirrored.csv", "vertical_deg,0,5\n0,100,5\n5,5,5\n"), "The file ends"));
  EXPECT_TRUE(has(advice_on("lamp.ies", round_ies("0 20 40", "100 90 60")), "has 60 % of its peak"));
  EXPECT_FALSE(has(advice_on("lamp.ies", round_ies("0 90 180", "100 100 100")), "The file ends"));
  EXPECT_FALSE(has(advice_on("spot.ies", kIes), "The file ends")) << "a quarter, which is mirrored";
  EXPECT_FALSE(
      has(advice_on("ellipse.csv", "candela,horizontal_deg,vertical_deg\n100,5,4\n50,6,5\n"), "The file ends"));
}

TEST_F(FitCommand, ReportSaysInLinesOf200LettersWhatAChangeImproves) {
  const std::string data = std::string("'") + LITFOG_TEST_DATA_DIR;
  EXPECT_TRUE(has(run(data + "/photometry/latin_1.ies'").out, "--profile smoothstep has none, and is no farther off."));
  for (const char* file : {"/photometry/position_light_left.csv'", "/../../data/specs/headlight-dipped.json'"}) {
    std::istringstream lines(run(data + file).out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 200u) << line;
  }
}

TEST_F(FitCommand, VerdictOfWhatIsMetNamesNoError) {
  write_spec("exact.json", R"("cone": {"beam_angle_deg": 24})");
  const Outcome outcome = run("exact.json");
  EXPECT_TRUE(has(outcome.out, "good: what is stated is met\n"));
}

TEST_F(FitCommand, TwoLightsAreInOneTableAndOnePlot) {
  const Outcome outcome = expect_done("spot.ies --against beam.json --format csv --plot both.svg");
  EXPECT_EQ(inputs_of(outcome.out), (std::vector<std::string>{"spot.ies", "beam.json"}));
  for (const char* label : {"spot / beam", ">spot<", ">beam<"}) {
    EXPECT_TRUE(has(read("both.svg"), label));
  }
  expect_usage_error("spot.ies --against lamp.json --details",
                     "--details cannot be given with --against: it shows a single light");
  expect_usage_error("spot.ies beam.json --against lamp.json",
                     "--against = lamp.json: must be one light, and so must the input");
}

TEST_F(FitCommand, TwoLightsStandSideBySideInCandelaAndLumens) {
  write_spec("twice.json", R"("range": {"peak_cd": 200}, "cone": {"photometry": "spot.ies"})");
  const std::string text = run("spot.ies --against twice.json").out;
  for (const char* name : {"candela", "lumens"}) {
    std::istringstream row(text.substr(text.find(std::string("  ") + name)));
    std::string word;
    double first = 0, second = 0;
    row >> word >> first >> second >> word;
    EXPECT_NEAR(second, 2 * first, 1e-3 * second) << text;
    EXPECT_GT(first, 0);
    EXPECT_EQ(word, "+100");
  }
}

TEST_F(FitCommand, TiltFactorMultipliesTheIntensities) {
  std::string tilted = kIes;
  tilted.replace(tilted.find("TILT=NONE"), 9, "TILT=INCLUDE\n1 3\n0 45 90\n0.9 0.8 0.4");
  write("tilted.ies", tilted);
  for (const auto& [option, peak] : {std::pair{"", 90.0}, {" --tilt 45", 80.0}, {" --tilt 60", 80 - 40 / 3.}}) {
    const json report = report_on(std::string("tilted.ies") + option);
    EXPECT_NEAR(report["beam"]["peak_cd"].get<double>(), peak, 1e-9) << option;
    EXPECT_TRUE(report["derived"][0].get<std::string>().starts_with("Tilt: ")) << report["derived"];
  }
  expect_usage_error("beam.json --tilt 5", "--tilt cannot be given with beam.json: there is no photometric file");
  expect_usage_error("tilted.ies --tilt 181", "--tilt = 181: must be a number from 0 to 180");
}

// ---- catalogues ----

TEST_F(FitCommand, CatalogueHasAPageWithEachLightAndItsPictures) {
  write("bad.ies", "x");
  std::string ies = kIes;
  ies.replace(ies.find("spot"), 4, "<b>&");
  write("a b.ies", ies);
  const Outcome outcome = run("lamp.json 'a b.ies' bad.ies --catalogue cat");
  EXPECT_EQ(outcome.status, kBadInput);
  const std::string page = read("cat/index.html");
  for (const char* part :
       {"<h1>2 lights of 3 files</h1>", "&lt;b&gt;&amp;", "href=\"lamps/a%20b.json\"", "src=\"lamps/a%20b.svg\"",
        "src=\"lamps/a%20b.png\"", "src=\"lamps/lamp.svg\"",
        "<td><img loading=\"lazy\" alt=\"\" src=\"lamps/lamp.png\"></td>", "<td data-value=\"100\">100</td>",
        "<td>no light</td>", "<p class=\"poor\">bad.ies:1:2: TILT: must be given, but the file ends here</p>"}) {
    EXPECT_TRUE(has(page, part));
  }
  for (const char* part : {"<script src", "http:", "https:", "//", "<b>"}) {
    EXPECT_FALSE(has(page, part));
  }
  for (const char* name : {"a b", "lamp"}) {
    const std::string file = std::string("cat/lamps/") + name;
    EXPECT_EQ(read(file + ".png").substr(1, 3), "PNG");
    EXPECT_TRUE(has(read(file + ".svg"), "</svg>"));
    EXPECT_GT(light(file + ".json").attenuation.quadratic, 0);
  }
  EXPECT_FALSE(files().contains("cat/lamps/bad.json"));
}

TEST_F(FitCommand, CatalogueIsMadeAnewByEachRun) {
  run("lamp.json --catalogue cat --profile cosine");
  write("cat/lamps/lamp.svg", "half");
  EXPECT_EQ(run("lamp.json --catalogue cat --profile smoothstep").status, kDone);
  EXPECT_TRUE(has(read("cat/lamps/lamp.svg"), "</svg>"));
  EXPECT_EQ(light("cat/lamps/lamp.json").cone.profile, ConeProfile::smoothstep);
}

TEST_F(FitCommand, LampsOfOneNameAreOneInACatalogueAndTheLaterIsAnError) {
  fs::create_directories(directory() / "lamps/s");
  for (const char* name : {"lamps/s/lamp.ies", "lamps/s-lamp.ies", "lamps/other.ies"}) write(name, kIes);
  const Outcome outcome = run("lamps --catalogue cat");
  EXPECT_EQ(outcome.status, kBadInput);
  EXPECT_EQ(outcome.err, "lamps/s-lamp.ies: name in the catalogue = s-lamp: must not be that of lamps/s/lamp.ies\n");
  for (const char* name : {"cat/lamps/s-lamp.png", "cat/lamps/other.png"}) EXPECT_TRUE(files().contains(name)) << name;
  EXPECT_TRUE(has(read("cat/index.html"), "<h1>2 lights of 3 files</h1>"));
}

TEST_F(FitCommand, LampWhoseFilesCannotBeWrittenIsNamedAndTheOthersAreInTheCatalogue) {
  fs::create_directory(directory() / "lamps");
  const std::string lengthy(251, 'x');  // with .json beyond what a file's name may have
  write("lamps/" + lengthy + ".ies", kIes);
  const std::string other(251, 'y');
  write("lamps/" + other + ".ies", kIes);
  for (int i = 0; i < 40; ++i) write("lamps/" + std::to_string(i) + ".ies", kIes);  // some have one run of gnuplot
  const Outcome outcome = run("lamps --catalogue cat");
  EXPECT_EQ(outcome.status, kCannotWrite);
  EXPECT_EQ(outcome.err, "lamps/" + lengthy + ".ies: cat/lamps/" + lengthy +
                             ".json: cannot be written: File name too long\n" + "lamps/" + other + ".ies: cat/lamps/" +
                             other + ".json: cannot be written: File name too long\n");
  EXPECT_TRUE(has(read("cat/index.html"), "<h1>40 lights of 42 files</h1>"));
  for (int i = 0; i < 40; ++i) EXPECT_TRUE(files().contains("cat/lamps/" + std::to_string(i) + ".json")) << i;
}

TEST_F(FitCommand, CatalogueRemovesWhatAKilledOneLeft) {
  run("spot.ies --catalogue cat");
  for (const char* name : {"cat/.litfog-0123456789abcdef", "cat/lamps/.litfog-0123456789abcdef"}) write(name, "half");
  EXPECT_EQ(run("spot.ies --catalogue cat").status, kDone);
  for (const std::string& name : files()) EXPECT_FALSE(has(name, ".litfog-"));
}

TEST_F(FitCommand, CatalogueReplacesNoFilesButItsOwn) {
  fs::create_directories(directory() / "cat/lamps");
  write("cat/lamps/spot.png", "holiday");
  const auto expect_refusal = [&](const std::string& file, const std::string& reason) {
    const auto before = files();
    EXPECT_ERROR(run("beam.json spot.ies --catalogue cat"), kCannotWrite,
                 "litfog-fit: " + file + ": cannot be written: " + reason + "\n");
    EXPECT_EQ(files(), before);
  };
  run("--version");  // makes the files of its own output
  expect_refusal("cat/lamps/spot.png", "exists, and cat has no catalogue's page");
  EXPECT_EQ(read("cat/lamps/spot.png"), "holiday");
  fs::remove(directory() / "cat/lamps/spot.png");
  write("cat/index.html", "<!DOCTYPE html>\n<p>holiday");
  expect_refusal("cat/index.html", "exists, and is no catalogue's page");
  fs::remove(directory() / "cat/index.html");
  EXPECT_EQ(run("beam.json spot.ies --catalogue cat").status, kDone);
  EXPECT_EQ(run("spot.ies --catalogue cat").status, kDone) << "its own files";
}

TEST_F(FitCommand, CatalogueTakesNoOptionThatItsFolderMakesVoid) {
  for (const char* option : {"-o a.json", "--plot a.svg", "--cookie a.exr", "--against beam.json"}) {
    const std::string name(option, std::string_view(option).find(' '));
    expect_usage_error(std::string("spot.ies --catalogue cat ") + option,
                       name + " cannot be given with --catalogue: its folder holds the lights and their pictures");
  }
  EXPECT_EQ(run("spot.ies --catalogue absent/cat").status, kCannotWrite);
  EXPECT_EQ(run("spot.ies --catalogue cat", "PATH=/nowhere").status, kMissingCapability);
}

// ---- the lights that come with litfog ----

TEST_F(FitCommand, ShippedLightsAreWhatTheirSpecsGive) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(LITFOG_DATA_DIR "/specs")) {
    const std::string name = entry.path().filename().string();
    SCOPED_TRACE(name);
    ++count;
    const bool has_cookie = fs::exists(LITFOG_DATA_DIR "/lights/" + entry.path().stem().string() + ".exr");
    const Outcome outcome = run(entry.path().string() + " -o light.json" + (has_cookie ? " --cookie beam.exr" : ""));
    ASSERT_EQ(outcome.status, has_cookie ? kNotToTolerance : kDone) << "a cookie's beam is none of a cone";
    const Light made = light("light.json");
    const Light shipped = read_light(LITFOG_DATA_DIR "/lights/" + name);
    EXPECT_EQ(made.name, shipped.name);
    EXPECT_EQ(made.color, shipped.color);
    EXPECT_EQ(made.threshold, shipped.threshold);
    EXPECT_EQ(made.density_scale, 1);
    EXPECT_EQ(made.density_scale, shipped.density_scale);
    EXPECT_EQ(made.source_radius, shipped.source_radius);
    EXPECT_GT(made.source_radius, 0);
    const auto spec = json::parse(std::ifstream(LITFOG_DATA_DIR "/specs/" + name));
    if (!has_cookie) {
      const double stated = spec["range"]["peak_cd"];
      EXPECT_NEAR(luminance(candela(made)) / stated, 1, 2e-4) << "luminance of its color";
    }
    // Another compiler's mathematics may differ in the last digits.
    const auto expect_near = [](double a, double b) { EXPECT_NEAR(a, b, 1e-9 * std::abs(b)); };
    expect_near(made.attenuation.constant, shipped.attenuation.constant);
    expect_near(made.attenuation.linear, shipped.attenuation.linear);
    expect_near(made.attenuation.quadratic, shipped.attenuation.quadratic);
    EXPECT_EQ(made.cone.profile, shipped.cone.profile);
    expect_near(made.cone.half_angle, shipped.cone.half_angle);
    expect_near(made.cone.exponent, shipped.cone.exponent);
    expect_near(made.cone.inner, shipped.cone.inner);
    expect_near(made.cone.outer, shipped.cone.outer);
    const auto lines = json::parse(std::ifstream(LITFOG_DATA_DIR "/lights/" + name))["source"];
    ASSERT_GT(lines.size(), spec["source"].size()) << "and what was derived";
    EXPECT_TRUE(std::equal(spec["source"].begin(), spec["source"].end(), lines.begin()));
  }
  EXPECT_GE(count, 20u);
}

#ifdef LITFOG_SHORT_MEMORY
TEST_F(FitCommand, ShortMemoryIsToldWhereverItRunsOut) {
  expect_words_where_memory_is_short("lamp.json", LITFOG_SHORT_MEMORY);
}

TEST_F(FitCommand, InputThatTakesTooMuchMemoryStopsNoOther) {
  write("large.json", R"({"name": ")" + std::string(20 << 20, 'x') + "\"}");
  const Outcome outcome =
      run("large.json lamp.json -o lights", "LITFOG_LARGEST_ALLOCATION=10000000 LD_PRELOAD=" LITFOG_SHORT_MEMORY);
  EXPECT_EQ(outcome.status, kInternalError);
  EXPECT_EQ(outcome.err, "large.json: out of memory\n");
  EXPECT_TRUE(fs::exists(directory() / "lights" / "lamp.json"));
}
#endif

}  // namespace

}  // namespace litfog::test
