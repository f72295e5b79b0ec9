// SPDX-License-Identifier: Apache-2.0
// The flux of every light written, integrated from its file and its cookie, against the report and the photometric
// file.

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "command/command_test.h"
#include "command/exit_status.h"
#include "litfog/photometry/cookie_file.h"
#include "litfog/photometry/cube_face.h"
#include "litfog/photometry/luminaire.h"
#include "photometry/zip_file.h"

namespace litfog::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using std::numbers::pi;

/// Largest relative error of the midpoint rules below.
constexpr double kIntegralMaxError = 0.005;

/// Flux of a shape over the sphere, about its axis or its poles.
double integral(int rise_steps, int turn_steps, const std::function<double(double angle, double turn)>& value) {
  double sum = 0;
  for (int i = 0; i < rise_steps; ++i) {
    const double angle = pi * (i + 0.5) / rise_steps;
    double belt = 0;
    for (int k = 0; k < turn_steps; ++k) belt += value(angle, 2 * pi * (k + 0.5) / turn_steps);
    sum += std::sin(angle) * belt;
  }
  return sum * (pi / rise_steps) * (2 * pi / turn_steps);
}

double flux_of(const IntensityDistribution& distribution) {
  return integral(540, 180, [&](double angle, double turn) {
    return intensity_at(distribution, direction_of(PhotometryType::c, turn, angle));
  });
}

/// Candela of a white light file's peak: a colour of 1 at an attenuation of 1 is 20 lx.
double candela_of(const json& light) {
  EXPECT_EQ(light["color"], json({1.0, 1.0, 1.0}));
  EXPECT_EQ(light["attenuation"]["constant"], 1.0);
  EXPECT_EQ(light["attenuation"]["linear"], 0.0);
  return 20 / light["attenuation"]["quadratic"].get<double>();
}

/// Candela of a light by its cone, at a cosine from the axis.
std::function<double(double cosine)> candela_by_cone(const json& light) {
  const json cone = light["cone"];
  const double peak = candela_of(light);
  const auto cosine_of = [&cone](const char* degrees) { return std::cos(cone[degrees].get<double>() * pi / 180); };
  if (cone["profile"] == "cosine") {
    return [peak, end = cosine_of("half_angle_deg"), exponent = cone["exponent"].get<double>()](double cosine) {
      return cosine > end ? peak * std::pow(std::max(cosine, 0.0), exponent) : 0;
    };
  }
  return [peak, outer = cosine_of("outer_deg"), inner = cosine_of("inner_deg")](double cosine) {
    const double t = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    return peak * t * t * (3 - 2 * t);
  };
}

/// Lumens of a light by its cone.
double flux_by_cone(const json& light) {
  const auto candela = candela_by_cone(light);
  return integral(9000, 1, [&](double angle, double) { return candela(std::cos(angle)); });
}

/// Lumens of a light by its cookie.
double flux_by_cookie(const json& light, const Cookie& cookie) {
  double sum = 0;
  for (std::size_t i = 0; i < cookie.texels.size(); ++i) {
    const int face = int(i) / (cookie.size * cookie.size), texel = int(i) % (cookie.size * cookie.size);
    const auto centre = [&cookie](int step) { return (2 * step + 1) / double(cookie.size) - 1; };
    const double distance =
        glm::length(cube_direction({face, centre(texel % cookie.size), centre(texel / cookie.size)}));
    sum += cookie.texels[i] / (distance * distance * distance);
  }
  return candela_of(light) * sum * 4 / (cookie.size * cookie.size);
}

/// Lights of both sides of a street: the largest intensity, 60 degrees off the vertical, is far above the mean over the
/// turn.
std::string street_lamp() {
  std::string text = "IESNA:LM-63-2002\n[LUMINAIRE] street lamp\nTILT=NONE\n1 -1 1 19 13 1 2 0 0 0\n1 1 100\n";
  for (int rise = 0; rise <= 90; rise += 5) text += std::to_string(rise) + " ";
  text += "\n";
  for (int turn = 0; turn <= 180; turn += 15) text += std::to_string(turn) + " ";
  for (int turn = 0; turn <= 180; turn += 15) {
    text += "\n";
    for (int rise = 0; rise <= 90; rise += 5) {
      const double along = std::pow(std::cos(turn * pi / 180), 6);
      const double wing = 2400 * along * std::exp(-std::pow((rise - 60) / 14., 2));
      text += std::to_string((600 + wing) * (rise < 90)) + " ";
    }
  }
  return text + "\n";
}

/// A round beam: a hot spot of 9000 cd in a spill of 1000 cd, which has most of the flux.
double spotlight(double degrees) {
  return 9000 * std::exp(-std::pow(degrees / 6, 2)) + 1000 * std::exp(-std::pow(degrees / 35, 4));
}

std::string ies_of(const std::function<double(double degrees)>& candela) {
  std::string text = "IESNA:LM-63-2002\n[LUMINAIRE] spotlight\nTILT=NONE\n1 -1 1 91 1 1 2 -0.1 -0.1 0\n1 1 100\n";
  for (int rise = 0; rise <= 90; ++rise) text += std::to_string(rise) + " ";
  text += "\n0\n";
  for (int rise = 0; rise <= 90; ++rise) text += std::to_string(candela(rise)) + " ";
  return text + "\n";
}

class LightFlux : public CommandTest {
 protected:
  LightFlux() : CommandTest(LITFOG_FIT_PATH) {}

  /// The report on an input whose light was written to light.json.
  json report_on(const std::string& input, const std::string& options = "") const {
    const Outcome outcome = run("'" + input + "' --format json -o light.json " + options);
    EXPECT_TRUE(outcome.status == command::kDone || outcome.status == command::kNotToTolerance) << outcome.err;
    return json::parse(outcome.out)[0];
  }

  json light() const { return json::parse(read("light.json")); }

  void expect_near(double value, double expected, double tolerance) const {
    EXPECT_NEAR(value, expected, tolerance * std::abs(expected));
  }

  /// Expects the light by its cone and by its cookie to have the flux of the file or spec.
  void expect_fluxes(const std::string& input, double file_flux) const {
    SCOPED_TRACE(input);
    const json by_cone = report_on(input);
    expect_near(by_cone["beam"]["flux_lm"], file_flux, kIntegralMaxError);
    const double cone_flux = flux_by_cone(light());
    expect_near(by_cone["light_beam"]["flux_lm"], cone_flux, 1e-3);
    expect_near(by_cone["light_beam"]["peak_cd"], candela_of(light()), 1e-9);
    const double error = cone_flux / file_flux - 1;
    EXPECT_NEAR(by_cone["light_beam"]["flux_error"].get<double>(), error, (2 + error) * kIntegralMaxError);
    const std::string profile = light()["cone"]["profile"];
    EXPECT_NEAR(light()["fit"]["cone"][profile]["flux_error"].get<double>(), error, (2 + error) * kIntegralMaxError);
    const std::string verdict = by_cone["verdict"];
    const double bound = verdict == "good" ? 0.1 : verdict == "fair" ? 0.33 : HUGE_VAL;  // the help's limits
    EXPECT_LE(std::abs(error), bound);

    const json by_cookie = report_on(input, "--cookie cookie.exr --cookie-size 128");
    const double cookie_flux = flux_by_cookie(light(), read_cookie((directory() / "cookie.exr").string()));
    expect_near(by_cookie["light_beam"]["flux_lm"], cookie_flux, 1e-3);
    expect_near(cookie_flux, file_flux, 0.01);
  }

  double flux_of_file(const std::string& path) const {
    return flux_of(read_luminaire((directory() / path).string()).distribution);
  }
};

TEST_F(LightFlux, FluxOfEveryLightWrittenIsItsReportsAndThatOfItsFile) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(LITFOG_TEST_DATA_DIR "/photometry")) {
    constexpr std::array kEndings{".ies", ".ldt", ".csv"};
    if (std::ranges::find(kEndings, entry.path().extension().string()) == kEndings.end()) continue;
    expect_fluxes(entry.path().string(), flux_of_file(entry.path().string()));
    ++count;
  }
  std::vector<std::function<double(double degrees)>> beams;
  for (const double exponent : {1., 2., 5., 12., 30.}) {
    beams.emplace_back(
        [=](double degrees) { return 500 * std::pow(std::max(std::cos(degrees * pi / 180), 0.0), exponent); });
  }
  for (const double width : {8., 15., 25., 40.}) {
    beams.emplace_back([=](double degrees) { return 2000 * std::exp(-std::pow(degrees / width, 2)); });
  }
  for (const auto& beam : beams) {
    const std::string file = "beam" + std::to_string(count++) + ".ies";
    write(file, ies_of(beam));
    expect_fluxes(file, flux_of_file(file));
  }
  EXPECT_GE(count, 40u);
}

TEST_F(LightFlux, FluxOfLightsFromContainersAndTablesIsThatOfTheirFiles) {
  std::string tm33 = "<IESTM33-22><Version>1.1</Version><Header/><Emitter><LuminousData><LuminousIntensity>";
  for (const auto& [turn, low] : {std::pair("0", "40"), {"90", "160"}, {"180", "40"}, {"270", "160"}, {"360", "40"}}) {
    for (const auto& [rise, candela] : {std::pair("0", "100"), {"40", low}, {"60", "10"}, {"90", "0"}}) {
      tm33 += std::string("<IntData h=\"") + turn + "\" v=\"" + rise + "\">" + candela + "</IntData>\n";
    }
  }
  write("lamp.xml", tm33 + "</LuminousIntensity></LuminousData></Emitter></IESTM33-22>\n");
  write("ellipses.csv", "candela,horizontal_deg,vertical_deg\n5000,7,5\n2500,12,9\n500,20,15\n");
  write("grid.csv",
        "vertical_deg,-20,-10,0,10,20\n20,0,9,20,9,0\n10,9,700,1200,700,9\n0,20,900,2500,900,20\n"
        "-10,9,500,800,500,9\n-20,0,9,20,9,0\n");
  write_zip((directory() / "set.gldf").string(),
            {{"product.xml",
              "<Root><GeneralDefinitions><Files><File contentType=\"ldc/ies\" type=\"localFileName\">street.ies</File>"
              "</Files></GeneralDefinitions></Root>"},
             {"ldc/street.ies", street_lamp()}});
  for (const char* input : {"lamp.xml", "ellipses.csv", "grid.csv", "set.gldf"}) {
    expect_fluxes(input, flux_of_file(input));
  }
}

TEST_F(LightFlux, LightOfAStreetLampHasItsFluxAndIsCalledPoorWhereItIsTooDark) {
  write("street.ies", street_lamp());
  const double file_flux = flux_of_file("street.ies");
  expect_fluxes("street.ies", file_flux);
  const json report = report_on("street.ies");
  expect_near(flux_by_cone(light()), file_flux, 0.16);
  EXPECT_EQ(report["beam"]["peak_cd"], 3000);
  EXPECT_LT(report["light_beam"]["peak_error"].get<double>(), -0.33);
  EXPECT_EQ(report["verdict"], "poor");
  EXPECT_TRUE(has(report["why"].get<std::string>(), "% at the beam's peak")) << report["why"];
}

TEST_F(LightFlux, LightOfASpecThatScalesAStreetLampHasItsFlux) {
  write("street.ies", street_lamp());
  const double file_flux = flux_of_file("street.ies");
  for (const auto& [range, flux] : {std::pair(R"("peak_cd": 6000)", 2 * file_flux),
                                    {R"("flux_lm": 500)", 500.0},
                                    {R"("illuminance": {"range_m": 10, "lx": 15})", file_flux / 2},
                                    {R"("end_lx": 1)", file_flux}}) {
    write("spec.json", R"({"litfog": "light-spec", "version": 1, "cone": {"photometry": "street.ies"}, "range": {)" +
                           std::string(range) + "}}");
    expect_fluxes("spec.json", flux);
  }
}

TEST_F(LightFlux, HotSpotAndSpillAsTwoLightsHaveTheCandelaAndFluxThatOneLacks) {
  write("spot.ies", ies_of(spotlight));
  const double file_flux = flux_of_file("spot.ies");
  const json one = report_on("spot.ies");
  EXPECT_LT(one["light_beam"]["flux_error"].get<double>(), -0.3);
  EXPECT_EQ(one["verdict"], "poor");
  EXPECT_FALSE(one.contains("spill"));
  const std::string advice = one["advice"].dump();

  const json two = report_on("spot.ies", "--spill spill.json");
  EXPECT_EQ(two["verdict"], "good") << two["why"];
  const json spill = json::parse(read("spill.json"));
  EXPECT_EQ(two["light"], light());
  EXPECT_EQ(two["spill"], spill);
  const double flux = flux_by_cone(light()) + flux_by_cone(spill), peak = candela_of(light()) + candela_of(spill);
  expect_near(flux, file_flux, 0.03);
  expect_near(peak, spotlight(0), 1e-6);
  expect_near(candela_of(spill), 1000, 0.1);
  expect_near(two["light_beam"]["flux_lm"], flux, 1e-3);
  expect_near(two["light_beam"]["peak_cd"], peak, 1e-9);
  EXPECT_NEAR(two["light_beam"]["flux_error"].get<double>(), flux / file_flux - 1, 2 * kIntegralMaxError);
  for (const json& each : {light(), spill}) {
    EXPECT_EQ(each["threshold"], 0.05) << "either ends at 1 of 20 lx";
    EXPECT_EQ(each["source_radius_m"], 0.05) << "of the opening";
  }

  const auto hot_spot_candela = candela_by_cone(light()), spill_candela = candela_by_cone(spill);
  const auto square_of = [](const std::function<double(double cosine, double degrees)>& value) {
    return integral(9000, 1, [&](double angle, double) {
      return std::pow(value(std::cos(angle), std::min(angle * 180 / pi, 180.)), 2);
    });
  };
  const auto beam = [](double degrees) { return degrees < 90 ? spotlight(degrees) : 0; };
  const double error = std::sqrt(square_of([&](double cosine, double degrees) {
                                   return hot_spot_candela(cosine) + spill_candela(cosine) - beam(degrees);
                                 }) /
                                 square_of([&](double, double degrees) { return beam(degrees); }));
  EXPECT_NEAR(two["light_beam"]["beam_error"].get<double>(), error, 0.01);
  EXPECT_LT(error, 0.1);
  EXPECT_LT(error, 0.5 * one["light_beam"]["beam_error"].get<double>());
  // The advice states what the two lights then have.
  const auto shown = [](double value, int digits) {
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
  };
  EXPECT_TRUE(has(advice, "--spill writes a second light for the rest. Both have " +
                              shown(two["light_beam"]["flux_lm"].get<double>(), 4) + " of the file's "));
  EXPECT_TRUE(
      has(advice, "off by " + shown(100 * two["light_beam"]["beam_error"].get<double>(), 2) + " % of the beam"));
  EXPECT_EQ(two["advice"], json::array());

  const std::string text = run("spot.ies -o light.json --spill spill.json").out;
  for (const char* part : {"both lights", "\n  hot spot  ", "\n  spill  ", " lm, ", "\n  good: "}) {
    EXPECT_TRUE(has(text, part));
  }
  EXPECT_LE(std::ranges::count(text, '\n'), 15);
}

TEST_F(LightFlux, BeamThatOneConeFollowsHasNoAdviceOnASecondLightButOneAgainstIt) {
  write("cosine.ies", ies_of([](double degrees) { return 500 * std::pow(std::cos(degrees * pi / 180), 40); }));
  EXPECT_FALSE(has(report_on("cosine.ies")["advice"].dump(), "--spill"));
  EXPECT_TRUE(
      has(report_on("cosine.ies", "--spill spill.json")["advice"].dump(), "Two lights are hardly better than one"));
}

TEST_F(LightFlux, TwoLightsOfASpecHaveItsPeakAndEndWhereItSays) {
  write("spot.ies", ies_of(spotlight));
  write("spec.json", R"({"litfog": "light-spec", "version": 1, "name": "lamp", "cone": {"photometry": "spot.ies"},
    "range": {"peak_cd": 20000, "end_lx": 1, "threshold": 0.05}})");
  const json report = report_on("spec.json", "--spill spill.json");
  expect_near(candela_of(light()) + candela_of(json::parse(read("spill.json"))), 20'000, 1e-6);
  EXPECT_EQ(light()["name"], "lamp, hot spot");
  EXPECT_EQ(json::parse(read("spill.json"))["name"], "lamp, spill");
}

TEST_F(LightFlux, TwoLightsOfWhatHasNoSpillAreRefusedInOneLine) {
  write("spot.ies", ies_of(spotlight));
  write("level.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 180\n0\n9 9\n");
  write("extent.json", R"({"litfog": "light-spec", "version": 1, "cone": {"photometry": "spot.ies"},
    "range": {"extent_m": 100}})");
  write("angles.json", R"({"litfog": "light-spec", "version": 1, "cone": {"beam_angle_deg": 20}, "range":
    {"peak_cd": 100}})");
  for (const auto& [input, reason] : {std::pair("level.ies", "level.ies: must have a beam with a spill for two lights"),
                                      {"extent.json", "must be given for two lights, with a range that states no"},
                                      {"angles.json", "must be given for two lights, with a range that states no"}}) {
    const Outcome outcome = run(std::string(input) + " -o light.json --spill spill.json");
    EXPECT_EQ(outcome.status, command::kBadInput) << input;
    EXPECT_TRUE(has(outcome.err, reason));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    EXPECT_FALSE(fs::exists(directory() / "light.json") || fs::exists(directory() / "spill.json")) << input;
  }
  write("spill.json", "{}");
  EXPECT_EQ(run("spot.ies -o light.json --spill spill.json").status, command::kCannotWrite) << "no fitted light";
  EXPECT_EQ(read("spill.json"), "{}");
  EXPECT_EQ(run("spot.ies -o light.json --spill light.json").status, command::kUsage);
  EXPECT_EQ(run("spot.ies --spill spill.json").status, command::kUsage);
  EXPECT_EQ(run("spot.ies level.ies -o . --spill spill.json").status, command::kUsage);
  EXPECT_EQ(run("spot.ies -o light.json --spill spill.json --cookie a.exr").status, command::kUsage);
}

}  // namespace
}  // namespace litfog::test
