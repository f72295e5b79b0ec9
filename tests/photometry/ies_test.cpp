// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/ies.h"

#include <cstdio>
#include <new>
#include <numbers>

#include "command/temporary_directory.h"
#include "photometry/memory_limit.h"
#include "photometry/photometric_file.h"
#include "reference/degree.h"

namespace litfog::test {
namespace {

using std::numbers::pi;

/// A sound file; each test spoils a part of it.
struct IesText {
  std::string label = "IESNA:LM-63-2002\n[TEST] 1\n";
  std::string tilt = "TILT=NONE\n";
  std::string lamps = "1 1000 1 ";
  std::string counts = "3 2 ";
  std::string type_and_units = "1 2 ";
  std::string dimensions = "0 0 0\n";
  std::string factors = "1 1 50\n";
  std::string vertical = "0 45 90\n";
  std::string horizontal = "0 90\n";
  std::string intensities = "100 50 0\n90 40 0\n";

  std::string str() const {
    return label + tilt + lamps + counts + type_and_units + dimensions + factors + vertical + horizontal + intensities;
  }
};

Luminaire parsed_ies(const std::string& text) { return parse_ies(text, "lamp.ies"); }
std::string ies_error(const std::string& text) {
  return photometry_error_of([&] { parsed_ies(text); });
}

/// What is wrong with the sound file with one part replaced.
std::string ies_error(std::string IesText::*part, const std::string& text) {
  IesText ies;
  ies.*part = text;
  return ies_error(ies.str());
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

// --- editions ---

TEST(Ies, FactorAfterTheBallastFactorMultipliesBefore1995Only) {
  for (const auto& [file, factor] : {std::pair{"edition_1986.ies", 2 * 0.9 * 0.5},
                                     {"edition_1991.ies", 2 * 0.9 * 0.5},
                                     {"edition_1995.ies", 2 * 0.9},
                                     {"edition_2002.ies", 2 * 0.9},
                                     {"edition_2019.ies", 2 * 0.9}}) {
    EXPECT_DOUBLE_EQ(find_peak(our_luminaire(file).distribution).intensity, 1000 * factor) << file;
  }
}

TEST(Ies, NumberOfLampsMultipliesTheirFluxButNoIntensity) {
  const Luminaire two = our_luminaire("edition_2002.ies");
  EXPECT_EQ(two.lamp_flux, 2000);
  EXPECT_FALSE(two.is_absolute);
  IesText three;
  three.lamps = "3 1000 1 ";
  EXPECT_EQ(parsed_ies(three.str()).lamp_flux, 3000);
  EXPECT_EQ(find_peak(parsed_ies(three.str()).distribution).intensity, 100);
}

TEST(Ies, LumensOfMinusOneAreAbsolutePhotometry) {
  const Luminaire absolute = our_luminaire("edition_2019.ies");
  EXPECT_TRUE(absolute.is_absolute);
  EXPECT_FALSE(absolute.lamp_flux);
  EXPECT_FALSE(stated_flux(absolute));
  IesText unknown;
  unknown.lamps = "1 0 1 ";
  EXPECT_FALSE(parsed_ies(unknown.str()).is_absolute);
  EXPECT_FALSE(parsed_ies(unknown.str()).lamp_flux);
}

TEST(Ies, FieldThatChangesNoIntensityMayBeAnyNumber) {
  const std::vector<double> intensity = parsed_ies(IesText().str()).distribution.intensity;
  const auto expect_read = [&](std::string IesText::*part, const std::string& text) {
    IesText ies;
    ies.*part = text;
    const Luminaire luminaire = parsed_ies(ies.str());
    EXPECT_EQ(luminaire.distribution.intensity, intensity) << text;
    return luminaire;
  };
  for (const char* lamps : {"0", "-1", "1.5", "4294967295", "1e300"}) {
    EXPECT_FALSE(expect_read(&IesText::lamps, std::string(lamps) + " 1000 1 ").lamp_flux) << lamps;
  }
  for (const char* lumens : {"0", "-2", "-1e300"}) {
    const Luminaire luminaire = expect_read(&IesText::lamps, std::string("1 ") + lumens + " 1 ");
    EXPECT_FALSE(luminaire.lamp_flux || luminaire.is_absolute) << lumens;
  }
  for (const char* sizes : {"-1 -2 -3\n", "1e300 0 -1e300\n"}) expect_read(&IesText::dimensions, sizes);
  for (const char* factors : {"1 0 0\n", "1 -1 -1\n", "1 4294967295 1e300\n"}) expect_read(&IesText::factors, factors);
}

TEST(Ies, LuminaireIsNamedByTheLabel) {
  EXPECT_EQ(our_luminaire("edition_1986.ies").name, "Round lamp");  // its first line, for want of keywords
  EXPECT_EQ(our_luminaire("edition_1991.ies").name, "Round lamp");
  EXPECT_EQ(our_luminaire("edition_1991.ies").manufacturer, "litfog");
  IesText ies;
  ies.label = "IESNA:LM-63-2002\n[LUMCAT] L 1\n[OTHER] x\n[MORE] y\n";
  EXPECT_EQ(parsed_ies(ies.str()).name, "L 1");
  ies.label += "[LUMINAIRE] Street\n[MORE] light\n[TEST] 1\n[MORE] 2\n[LUMINAIRE] tall\n";
  EXPECT_EQ(parsed_ies(ies.str()).name, "Street light tall");
}

TEST(Ies, NamesAreUtf8WhateverTheirCodePage) {
  const auto name_of = [](const std::string& maker, const std::string& name) {
    IesText ies;
    ies.label = "IESNA:LM-63-2002\n[MANUFAC] " + maker + "\n[LUMINAIRE] " + name + "\n";
    return parsed_ies(ies.str()).name;
  };
  EXPECT_EQ(name_of("litfog", "Spot \xF8 30\xB0"), "Spot \u00F8 30\u00B0");  // Windows-1252
  EXPECT_EQ(name_of("litfog",
                    "3 \x80, \x84"
                    "eng\x93"),
            "3 \u20AC, \u201Eeng\u201C");                                            // not Latin-1
  EXPECT_EQ(name_of("\xD1\xE2\xE5\xF2", "\xCF\xF0\xEE\xE6\xE5\xEA\xF2\xEE\xF0 50"),  // Windows-1251
            "\u041F\u0440\u043E\u0436\u0435\u043A\u0442\u043E\u0440 50");
  EXPECT_EQ(name_of("\xCE\xCE\xCE", "\xCF\xD0\xCE\xC6\xC5\xCA\xD2\xCE\xD0"),  // the same in capitals
            "\u041F\u0420\u041E\u0416\u0415\u041A\u0422\u041E\u0420");
  EXPECT_EQ(name_of("\xC9\xEE\xDB\xDA\xCA\xD0\xD5\xD5\xC3\xF7\xD3\xD0\xCF\xDE\xB9\xAB\xCB\xBE", "LED"), "LED");
  EXPECT_EQ(
      name_of("\xC9\xEE\xDB\xDA\xCA\xD0\xD5\xD5\xC3\xF7\xD3\xD0\xCF\xDE\xB9\xAB\xCB\xBE", "\xC9\xE4\xB5\xC6"),  // GBK
      "\u5C04\u706F");
  EXPECT_EQ(name_of("litfog", "\x81\x8D"), "\u0081\u008D");  // no letters of any code page
}

TEST(Ies, Utf16IsReadWithAndWithoutItsMark) {
  IesText ies;
  ies.label = "IESNA:LM-63-2002\n[LUMINAIRE] Lamp \xC3\xA4\n";
  const std::string text = ies.str();
  for (const bool is_little : {true, false}) {
    for (const bool has_mark : {true, false}) {
      std::string bytes = !has_mark ? "" : is_little ? "\xFF\xFE" : "\xFE\xFF";
      for (std::size_t i = 0; i < text.size(); ++i) {
        const char low = text[i] == '\xC3' ? text[++i] == '\xA4' ? '\xE4' : '?' : text[i];
        bytes += is_little ? std::string{low, '\0'} : std::string{'\0', low};
      }
      const Luminaire luminaire = parsed_ies(bytes);
      EXPECT_EQ(luminaire.name, "Lamp \xC3\xA4");
      expect_same_beam(luminaire, parsed_ies(text));
    }
  }
}

TEST(Ies, FortransExponentsAreRead) {
  IesText ies;
  ies.intensities = "1.0D+02 5d1 0.D0\n9D1 4.0d+01 0D-3\n";
  EXPECT_EQ(parsed_ies(ies.str()).distribution.intensity, (std::vector<double>{100, 50, 0, 90, 40, 0}));
  EXPECT_EQ(ies_error(&IesText::intensities, "1DD2 50 0\n90 40 0\n"), "8:1: intensity = 1DD2: must be a finite number");
}

TEST(Ies, IntensityARoundingBelowZeroIsDark) {
  IesText ies;
  ies.intensities = "-0.1 100 -0.0\n90 -0.01 0\n";
  EXPECT_EQ(parsed_ies(ies.str()).distribution.intensity, (std::vector<double>{0, 100, 0, 90, 0, 0}));
  EXPECT_EQ(ies_error(&IesText::intensities, "-0.11 -0.01 100\n90 40 0\n"),
            "8:1: intensity 1 of 6 = -0.11: must be >= 0");
  EXPECT_EQ(ies_error(&IesText::intensities, "-1 0 0\n0 0 0\n"), "8:1: intensity 1 of 6 = -1: must be >= 0");
}

TEST(Ies, TextThatIsNoUtf8IsTakenAsLatin1) {
  const Luminaire luminaire = our_luminaire("latin_1.ies");
  EXPECT_EQ(luminaire.name, "30\xC2\xB0 spot");
  EXPECT_EQ(luminaire.manufacturer, "W\xC3\xA4rmel\xC3\xA4mpchen");
}

TEST(Ies, OpeningIsInMetres) {
  const LuminousOpening feet = our_luminaire("latin_1.ies").opening;
  EXPECT_DOUBLE_EQ(feet.width, 0.3048);
  EXPECT_DOUBLE_EQ(feet.length, 0.6096);
  EXPECT_DOUBLE_EQ(feet.height, 0.9144);
  EXPECT_EQ(our_luminaire("spelling.ies").opening.width, -0.3);  // round
}

TEST(Ies, OpeningRadiusIsThatOfADiscOfItsArea) {
  EXPECT_DOUBLE_EQ(opening_radius({0.6, 1.2, 0}), std::sqrt(0.72 / pi)) << "rectangle";
  EXPECT_DOUBLE_EQ(opening_radius({0.6, 1.2, 0.1}), std::sqrt(0.72 / pi)) << "with luminous sides";
  EXPECT_DOUBLE_EQ(opening_radius({-0.3, -0.3, 0}), 0.15) << "circle";
  EXPECT_DOUBLE_EQ(opening_radius({-0.3, 0, 0}), 0.15) << "circle of the older editions";
  EXPECT_DOUBLE_EQ(opening_radius({-0.3, 0, 1}), 0.15) << "upright cylinder of the older editions";
  EXPECT_DOUBLE_EQ(opening_radius({-0.1, -0.4, 0}), 0.1) << "ellipse";
  EXPECT_DOUBLE_EQ(opening_radius({-0.3, -0.3, 1}), 0.15) << "upright cylinder";
  EXPECT_DOUBLE_EQ(opening_radius({-0.3, -0.3, -0.3}), 0.15) << "sphere";
  EXPECT_DOUBLE_EQ(opening_radius({-0.04, 1.2, -0.04}), std::sqrt(0.048 / pi)) << "lying cylinder";
  EXPECT_DOUBLE_EQ(opening_radius({-0.3, 0, -0.3}), 0.15) << "upright circle";
  EXPECT_DOUBLE_EQ(opening_radius({0, 0.5, 0.2}), std::sqrt(0.1 / pi)) << "upright rectangle";
  for (const LuminousOpening& none : {LuminousOpening{}, {0, 1.2, 0}, {0, 0, 0.5}, {1e-3, 1e-3, 0}, {1e-300, 1, 0}}) {
    EXPECT_EQ(opening_radius(none), 0) << none.width << " " << none.length << " " << none.height;
  }
  EXPECT_DOUBLE_EQ(opening_radius({-1e300, -1e300, 0}), 5e299);
}

TEST(Ies, NumbersAreReadHoweverTheyAreSpelled) {
  const Luminaire spelled = our_luminaire("spelling.ies");
  EXPECT_EQ(spelled.name, "Quadrant lamp");
  EXPECT_EQ(spelled.lamp_flux, 2500);
  expect_same_beam(spelled, our_luminaire("type_c_quadrant.ies"));
}

TEST(Ies, AllLineEndsAreKnown) {
  const std::string text = bytes_of(std::string(LITFOG_PHOTOMETRY_DIR) + "/type_c_quadrant.ies");
  for (const char* line_end : {"\r\n", "\r"}) {
    std::string changed;
    for (const char c : text) changed += c == '\n' ? line_end : std::string(1, c);
    expect_same_beam(parsed_ies(changed), parsed_ies(text));
    changed.replace(changed.find("2500"), 4, "x");
    EXPECT_EQ(ies_error(changed), "6:3: lumens per lamp = x: must be a finite number");
  }
}

TEST(Ies, FileIsKnownByItsLabelOrTiltLine) {
  EXPECT_TRUE(is_ies("IESNA91\n"));
  EXPECT_TRUE(is_ies("\xEF\xBB\xBFIES:LM-63-2019"));
  EXPECT_TRUE(is_ies("a lamp\r\n  tilt = NONE\r\n"));
  EXPECT_FALSE(is_ies("litfog\n1\n0\n24\n"));
  EXPECT_FALSE(is_ies("IESA Leuchten GmbH\n1\n0\n24\n")) << "a company, as EULUMDAT begins";
  EXPECT_FALSE(is_ies(""));
}

// --- symmetry and types ---

TEST(Ies, EverySymmetryGivesTheSameLamp) {
  const Luminaire quadrant = our_luminaire("type_c_quadrant.ies");
  for (const char* other : {"type_c_half.ies", "type_c_other_half.ies", "type_c_whole.ies", "type_c_open_whole.ies"}) {
    SCOPED_TRACE(other);
    expect_same_beam(quadrant, our_luminaire(other));
  }
  EXPECT_NEAR(intensity_at(quadrant.distribution, {0, -std::sin(30 * kDegree), -std::cos(30 * kDegree)}), 600, 1e-9);
}

TEST(Ies, PlanesMayBeCountedFromMinus180) {
  IesText positive, negative;
  positive.counts = negative.counts = "2 5 ";
  positive.vertical = negative.vertical = "0 90\n";
  positive.horizontal = "0 90 180 270 360\n";
  negative.horizontal = "-180 -90 0 90 180\n";
  positive.intensities = "9 1 9 2 9 3 9 4 9 1\n";
  negative.intensities = "9 3 9 4 9 1 9 2 9 3\n";
  expect_same_beam(parsed_ies(positive.str()), parsed_ies(negative.str()));
  negative.counts = "2 4 ";  // open
  negative.horizontal = "-180 -90 0 90\n";
  negative.intensities = "9 3 9 4 9 1 9 2\n";
  expect_same_beam(parsed_ies(positive.str()), parsed_ies(negative.str()));
  positive.counts = negative.counts = "2 3 ";  // mirrored
  positive.horizontal = "90 180 270\n";
  negative.horizontal = "-90 0 90\n";
  positive.intensities = "9 1 9 2 9 3\n";
  negative.intensities = "9 3 9 2 9 1\n";
  expect_same_beam(parsed_ies(positive.str()), parsed_ies(negative.str()));
}

TEST(Ies, AllThreeTypesAreRead) {
  const auto direction = [](double x, double y) {
    return glm::dvec3{std::sin(x * kDegree), std::sin(y * kDegree), -1};
  };
  const auto b = our_luminaire("type_b.ies").distribution;
  EXPECT_EQ(b.type, PhotometryType::b);
  EXPECT_NEAR(intensity_at(b, {0, 0, -1}), 900, 1e-9);
  EXPECT_NEAR(intensity_at(b, {0, 1, 0}), 250, 1e-9);   // V = 90 is up
  EXPECT_NEAR(intensity_at(b, {0, -1, 0}), 200, 1e-9);  // V = -90
  EXPECT_NEAR(intensity_at(b, {1, 0, -1e-9}), 150, 1e-6);
  const auto a = our_luminaire("type_a.ies").distribution;
  EXPECT_EQ(a.type, PhotometryType::a);
  EXPECT_NEAR(intensity_at(a, {std::sin(20 * kDegree), 0, -std::cos(20 * kDegree)}), 150, 1e-9);
  EXPECT_NEAR(intensity_at(a, {-std::sin(30 * kDegree), 0, -std::cos(30 * kDegree)}), 300, 1e-9);
  EXPECT_EQ(intensity_at(a, direction(0, 6)), 0);
  const auto quadrant = our_luminaire("type_b_quadrant.ies").distribution;
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      EXPECT_NEAR(intensity_at(quadrant, {x * std::sqrt(0.5), y * 0.5, -0.5}), 200, 1e-9);
    }
  }
}

TEST(Ies, WrittenNumbersAreReadBack) {
  Random random(1);
  for (const int type : {1, 2, 3}) {
    IntensityDistribution written{type == 1   ? PhotometryType::c
                                  : type == 2 ? PhotometryType::b
                                              : PhotometryType::a,
                                  {},
                                  {},
                                  {}};
    IesText ies;
    ies.type_and_units = std::to_string(type) + " 2 ";
    ies.counts = "19 13 ";
    ies.vertical = ies.horizontal = ies.intensities = "";
    for (int v = 0; v < 19; ++v) {
      const double deg = type == 1 ? 10 * v : -90 + 10 * v;
      ies.vertical += number(deg) + (v % 5 == 4 ? "\r\n" : ", ");
      written.vertical.push_back(deg * pi / 180);
    }
    for (int h = 0; h < 13; ++h) {
      const double deg = type == 1 ? 30 * h : -90 + 15 * h;
      ies.horizontal += number(deg) + "\n";
      written.horizontal.push_back(deg * pi / 180);
    }
    for (int i = 0; i < 19 * 13; ++i) {
      written.intensity.push_back(random.log_uniform(1e-3, 1e6));
      ies.intensities += number(written.intensity.back()) + " ";
    }
    const auto read = parsed_ies(ies.str()).distribution;
    EXPECT_EQ(read.type, written.type);
    EXPECT_EQ(read.intensity, written.intensity);
    for (std::size_t i = 0; i < 19; ++i) EXPECT_DOUBLE_EQ(read.vertical[i], written.vertical[i]);
    for (std::size_t i = 0; i < 13; ++i) EXPECT_DOUBLE_EQ(read.horizontal[i], written.horizontal[i]);
  }
}

// --- tilt ---

TEST(Ies, TiltFactorsAreStoredBesideTheIntensities) {
  for (const char* file : {"tilt_include.ies", "tilt_file.ies"}) {
    const Luminaire luminaire = our_luminaire(file);
    ASSERT_TRUE(luminaire.tilt) << file;
    EXPECT_EQ(luminaire.file, std::string(LITFOG_PHOTOMETRY_DIR "/") + file);
    EXPECT_EQ(luminaire.tilt->file, file == std::string("tilt_file.ies") ? LITFOG_PHOTOMETRY_DIR "/lamp.tlt" : "");
    EXPECT_EQ(luminaire.tilt->geometry, 2);
    EXPECT_EQ(luminaire.tilt->angles, (std::vector<double>{0, pi / 4, pi / 2}));
    EXPECT_EQ(luminaire.tilt->factors, (std::vector<double>{1, 0.95, 0.9}));
    EXPECT_EQ(find_peak(luminaire.distribution).intensity, 1000);
  }
  EXPECT_FALSE(our_luminaire("edition_1991.ies").tilt);
}

TEST(Ies, TiltFactorIsLinearBetweenItsAnglesAndConstantBeyondThem) {
  const LampTilt tilt{.angles = {0.5, 1, 2}, .factors = {0.9, 0.8, 0.4}};
  for (const auto& [angle, factor] :
       {std::pair{0.0, 0.9}, {0.5, 0.9}, {0.75, 0.85}, {1.0, 0.8}, {1.5, 0.6}, {pi, 0.4}}) {
    EXPECT_DOUBLE_EQ(tilt_factor(tilt, angle), factor) << angle;
  }
  for (const double angle : {-0.1, 3.2, std::nan("")}) {
    EXPECT_THROW(tilt_factor(tilt, angle), std::invalid_argument) << angle;
  }
}

TEST(Ies, TiltFileThatIsMissingBadOrElsewhereIsAnError) {
  const TemporaryDirectory directory;
  const auto error = [&](const std::string& tilt) {
    IesText ies;
    ies.tilt = "TILT=" + tilt + "\n";
    return photometry_error_of([&] { parse_ies(ies.str(), (directory.path() / "lamp.ies").string()); });
  };
  directory.write("good.tlt", "1 2\n0 90\n1 0.8\n");
  directory.write("bad.tlt", "1 2\n0 90\n1 dark\n");
  EXPECT_EQ(error("good.tlt"), "(accepted)");
  EXPECT_EQ(error("bad.tlt"), "3:3: tilt factor = dark: must be a finite number");
  const std::string location = "3:6: TILT = ";
  EXPECT_EQ(error("none.tlt"), location + "none.tlt: must be NONE, INCLUDE or a file in this one's folder");
  EXPECT_EQ(error("."), location + ".: must be NONE, INCLUDE or a file in this one's folder");
  EXPECT_EQ(error(""), "3:6: TILT: must be given");
  EXPECT_EQ(error("NONE 1 1000 1 3 2"), "3:11: text behind TILT=NONE = 1 1000 1 3 2: must begin on a line of its own");
  EXPECT_EQ(error("include\t1 2 0 90"), "3:14: text behind TILT=INCLUDE = 1 2 0 90: must begin on a line of its own");
  EXPECT_EQ(error("nonesuch"), location + "nonesuch: must be NONE, INCLUDE or a file in this one's folder");
  EXPECT_EQ(error("../good.tlt"), location + "../good.tlt: must name a file below this one's folder");
  EXPECT_EQ(error("/dev/zero"), location + "/dev/zero: must name a file below this one's folder");
  try {
    IesText ies;
    ies.tilt = "TILT=bad.tlt\n";
    parse_ies(ies.str(), (directory.path() / "lamp.ies").string());
  } catch (const InputError& thrown) {
    EXPECT_EQ(thrown.location().file, (directory.path() / "bad.tlt").string());
  }
}

TEST(Ies, BadTiltDataAreAnErrorAtTheirLocation) {
  const auto error = [](const std::string& tilt) { return ies_error(&IesText::tilt, "TILT=INCLUDE\n" + tilt + "\n"); };
  EXPECT_EQ(error("1 2 0 90 1 0.5"), "(accepted)");
  EXPECT_EQ(error("4 2 0 90 1 0.5"), "4:1: lamp to luminaire geometry = 4: must be an integer from 1 to 3");
  EXPECT_EQ(error("1 99999999 0"), "4:3: number of tilt angles = 99999999: must be an integer from 1 to 10000");
  EXPECT_EQ(error("1 2 90 0 1 1"), "4:8: tilt angle 2 of 2 = 0: must be greater than the one before, 90");
  EXPECT_EQ(error("1 2 0 181 1 1"), "4:7: tilt angle 2 of 2 = 181: must be in [0, 180]");
  EXPECT_EQ(error("1 2 0 90 1 0"), "4:12: tilt factor = 0: must be > 0");
}

// --- errors ---

TEST(Ies, BadValueIsAnErrorAtItsLocation) {
  const std::string kFinite = "must be a finite number";
  EXPECT_EQ(ies_error(IesText().str()), "(accepted)");
  EXPECT_EQ(ies_error(&IesText::lamps, "one 1000 1 "), "4:1: number of lamps = one: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::lamps, "1 nan 1 "), "4:3: lumens per lamp = nan: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::lamps, "1 1000 0 "), "4:8: candela multiplier = 0: must be > 0");
  EXPECT_EQ(ies_error(&IesText::lamps, "1 1000 inf "), "4:8: candela multiplier = inf: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::lamps, "1 1000 1e999 "), "4:8: candela multiplier = 1e999: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::type_and_units, "4 2 "), "4:14: photometric type = 4: must be an integer from 1 to 3");
  EXPECT_EQ(ies_error(&IesText::type_and_units, "1 3 "), "4:16: units type = 3: must be an integer from 1 to 2");
  EXPECT_EQ(ies_error(&IesText::dimensions, "0 0 wide\n"), "4:22: height = wide: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::factors, "-1 1 50\n"), "5:1: ballast factor = -1: must be > 0");
  EXPECT_EQ(ies_error(&IesText::factors, "1 x 50\n"), "5:3: field after the ballast factor = x: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::factors, "1 1 W\n"), "5:5: input watts = W: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::intensities, "100 50 0\n90 -40 0\n"), "9:4: intensity 5 of 6 = -40: must be >= 0");
  EXPECT_EQ(ies_error(&IesText::intensities, "100 5O 0\n90 40 0\n"), "8:5: intensity = 5O: " + kFinite);
  EXPECT_EQ(ies_error(&IesText::intensities, "100 1e31 0\n90 40 0\n"),
            "8:5: intensity 2 of 6 = 1e31: must be at most 1e30 candela, with all factors");
  EXPECT_EQ(ies_error(&IesText::intensities, "0 0 0\n0 0 0\n"),
            "9:5: intensity 6 of 6 = 0: must not be 0 as all others are");
  EXPECT_EQ(ies_error(&IesText::intensities, "100 50 0\n90 40 0\n9"),
            "10:1: number after the last intensity = 9: must not be there by the file's counts");
  EXPECT_EQ(ies_error(&IesText::intensities, "100 50 0\n90 40 0\nEND\n"), "(accepted)");
  IesText old;
  old.label = "IESNA91\n";
  old.factors = "1 0 50\n";
  EXPECT_EQ(ies_error(old.str()), "4:3: ballast-lamp photometric factor = 0: must be > 0");
}

TEST(Ies, BadAngleIsAnErrorAtItsLocation) {
  const std::string kTurn =
      "must be one of planes at 0, from 0 to 90, 180 or 360, from 90 to 270, from -90 to 90, or from -180 to 180";
  EXPECT_EQ(ies_error(&IesText::vertical, "0 45 181\n"), "6:6: vertical angle 3 of 3 = 181: must be in [0, 180]");
  EXPECT_EQ(ies_error(&IesText::vertical, "-1 45 90\n"), "6:1: vertical angle 1 of 3 = -1: must be in [0, 180]");
  EXPECT_EQ(ies_error(&IesText::vertical, "0 45 45\n"),
            "6:6: vertical angle 3 of 3 = 45: must be greater than the one before, 45");
  EXPECT_EQ(ies_error(&IesText::vertical, "0 29 29.000000000000004\n"),  // the same in radians
            "6:6: vertical angle 3 of 3 = 29.000000000000004: must be greater than the one before, 29");
  EXPECT_EQ(ies_error(&IesText::horizontal, "90 0\n"),
            "7:4: horizontal angle 2 of 2 = 0: must be greater than the one before, 90");
  EXPECT_EQ(ies_error(&IesText::horizontal, "0 361\n"), "7:3: horizontal angle 2 of 2 = 361: must be in [-180, 360]");
  EXPECT_EQ(ies_error(&IesText::horizontal, "-181 90\n"),
            "7:1: horizontal angle 1 of 2 = -181: must be in [-180, 360]");
  EXPECT_EQ(ies_error(&IesText::horizontal, "-180 -90\n"), "7:6: last horizontal angle = -90: " + kTurn);
  EXPECT_EQ(ies_error(&IesText::horizontal, "0 45\n"), "7:3: last horizontal angle = 45: " + kTurn);
  EXPECT_EQ(ies_error(&IesText::horizontal, "10 100\n"), "7:4: last horizontal angle = 100: " + kTurn);
  IesText open;
  open.counts = "2 4 ";
  open.vertical = "0 90\n";
  open.intensities = "1 1 1 1 1 1 1 1\n";
  open.horizontal = "0 90 180 270\n";
  EXPECT_EQ(ies_error(open.str()), "(accepted)");
  open.horizontal = "0 80 160 240\n";  // 120 degrees are missing
  EXPECT_EQ(ies_error(open.str()), "7:10: last horizontal angle = 240: " + kTurn);
  open.horizontal = "-180 0 180 181\n";  // one degree is there twice
  EXPECT_EQ(ies_error(open.str()), "7:12: last horizontal angle = 181: " + kTurn);

  IesText b;
  b.type_and_units = "2 2 ";
  EXPECT_EQ(ies_error(b.str()), "(accepted)");
  b.horizontal = "0 91\n";
  EXPECT_EQ(ies_error(b.str()), "7:3: horizontal angle 2 of 2 = 91: must be in [-90, 90]");
  b.horizontal = "0\n";
  b.counts = "3 1 ";
  EXPECT_EQ(ies_error(b.str()), "7:1: horizontal angle = 0: must not be the only one in types A and B");
  IesText a;
  a.type_and_units = "3 2 ";
  a.vertical = "-91 0 90\n";
  EXPECT_EQ(ies_error(a.str()), "6:1: vertical angle 1 of 3 = -91: must be in [-90, 90]");
}

TEST(Ies, CountBeyondTheFileIsAnError) {
  EXPECT_EQ(ies_error(&IesText::counts, "2147483648 2 "),
            "4:10: number of vertical angles = 2147483648: must be an integer from 2 to 10000");
  EXPECT_EQ(ies_error(&IesText::counts, "3 2147483648 "),
            "4:12: number of horizontal angles = 2147483648: must be an integer from 1 to 10000");
  EXPECT_EQ(ies_error(&IesText::counts, "1 2 "),
            "4:10: number of vertical angles = 1: must be an integer from 2 to 10000");
  EXPECT_EQ(ies_error(&IesText::counts, "-3 2 "),
            "4:10: number of vertical angles = -3: must be an integer from 2 to 10000");
  EXPECT_EQ(ies_error(&IesText::intensities, "100 50 0\n"),
            "9:1: intensity 4 of 6: must be given, but the file ends here");  // a plane missing
  EXPECT_EQ(ies_error(&IesText::horizontal, ""),
            "7:5: horizontal angle 2 of 2 = 50: must be greater than the one before, 100");
}

TEST(Ies, TextOfAnotherKindIsAnError) {
  EXPECT_EQ(ies_error(""), "1:1: TILT: must be given, but the file ends here");
  EXPECT_EQ(ies_error("IESNA:LM-63-2002\n[TEST] 1\n"), "3:1: TILT: must be given, but the file ends here");
  EXPECT_EQ(ies_error("IESNA:LM-63-2002\n [LUMINAIRE] a Tilt=NONE \n1 1"),
            "2:2: line with TILT = [LUMINAIRE] a Tilt=NONE: must begin with TILT=");
  EXPECT_EQ(ies_error("IESNA:LM-63-2002\r\nTILT:NONE\r\n"), "2:1: line with TILT = TILT:NONE: must begin with TILT=");
  EXPECT_EQ(ies_error("IESNA:LM-63-2002\nTILT=NONE"), "2:10: number of lamps: must be given, but the file ends here");
  EXPECT_EQ(ies_error(std::string("TILT=NONE\n\0\0 1", 14)), "2:1: number of lamps = ??: must be a finite number");
}

TEST(Ies, ColumnsAreCodePointsWithoutTheByteOrderMark) {
  IesText ies;
  ies.label = "";
  ies.tilt = "\xEF\xBB\xBFTILT=NONE\n\xC3\xA4 ";
  EXPECT_EQ(ies_error(ies.str()), "2:1: number of lamps = \xC3\xA4: must be a finite number");
  ies.tilt = "TILT=NONE\n1 \xC3\xA4\xE2\x82\xAC x ";
  EXPECT_EQ(ies_error(ies.str()), "2:3: lumens per lamp = \xC3\xA4\xE2\x82\xAC: must be a finite number");
  ies.tilt = "TILT=NONE\n1 1\t\xE4 ";
  EXPECT_EQ(ies_error(ies.str()), "2:5: candela multiplier = \xC3\xA4: must be a finite number");
}

TEST(Ies, LongValueIsCutInMessages) {
  EXPECT_EQ(ies_error("TILT=NONE\n" + std::string(100, 'x')),
            "2:1: number of lamps = " + std::string(40, 'x') + "...: must be a finite number");
}

TEST(Ies, HostileTextTakesLinearTime) {
  const std::size_t kMany = 4'000'000;  // time that grows with the square would not end here
  EXPECT_EQ(ies_error(std::string(kMany, '\r')),
            std::to_string(kMany + 1) + ":1: TILT: must be given, but the file ends here");
  std::string more = "IESNA91\n[LUMINAIRE] x\n";
  while (more.size() < kMany) more += "[MORE] y\n[A" + std::to_string(more.size()) + "]\n";
  EXPECT_NE(ies_error(more).find("TILT: must be given"), std::string::npos);
  EXPECT_EQ(ies_error("TILT=NONE\n" + std::string(kMany, ',')),
            "2:4000001: number of lamps: must be given, but the file ends here");
  EXPECT_EQ(ies_error("TILT=NONE\n1 1 " + std::string(kMany, '1')),
            "2:5: candela multiplier = " + std::string(40, '1') + "...: must be a finite number");
  std::string zeros = "TILT=NONE\n1 1 1 10000 10000 1 1 0 0 0 1 1 1 ";
  while (zeros.size() < kMany) zeros += "0 ";
  EXPECT_EQ(ies_error(zeros), "2:37: vertical angle 2 of 10000 = 0: must be greater than the one before, 0");
}

// --- luminaires ---

class LuminaireFile : public testing::Test {
 protected:
  Luminaire read(const std::string& name, const std::string& bytes) const {
    return read_luminaire(directory_.write(name, bytes));
  }
  std::string ies_error(const std::string& name, const std::string& bytes) const {
    return photometry_error_of([&] { read(name, bytes); });
  }

  const TemporaryDirectory directory_;
};

TEST_F(LuminaireFile, FormatIsKnownByContentThenByEnding) {
  const std::string ours = LITFOG_PHOTOMETRY_DIR;
  EXPECT_EQ(read("a.LDT", IesText().str()).lamp_flux, 1000);
  EXPECT_EQ(read("b.IES", IesText().str()).lamp_flux, 1000);
  EXPECT_EQ(read("c", bytes_of(ours + "/isym_4.ldt")).lamp_flux, 2500);
  std::string company = bytes_of(ours + "/isym_4.ldt");
  company.replace(0, company.find_first_of("\r\n"), "IESA Leuchten GmbH");
  EXPECT_EQ(read("f.ldt", company).manufacturer, "IESA Leuchten GmbH");
  EXPECT_EQ(ies_error("d.Ies", "x\n"), "2:1: TILT: must be given, but the file ends here");
  EXPECT_EQ(ies_error("e.ldt", "x\n"), "2:1: type indicator Ityp: must be given, but the file ends here");
}

TEST_F(LuminaireFile, FileOfAnotherKindIsNoPhotometricFile) {
  const std::string rule =
      " not a photometric file: must be of IES LM-63 (with a line TILT=), EULUMDAT, TM-33 or GLDF, or an "
      "isocandela table";
  EXPECT_EQ(ies_error("picture.png", std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16)), rule);
  EXPECT_EQ(ies_error("picture.ies", std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16)), rule);
  EXPECT_EQ(ies_error("page.ldt", "<!DOCTYPE html>\n<html><body>404</body></html>\n"), rule);
  EXPECT_EQ(ies_error("notes.txt", "lamps\nthe first\n"), rule);
}

TEST_F(LuminaireFile, EmptyFileIsToldSo) {
  for (const char* name : {"empty", "empty.ies", "empty.ldt", "empty.csv", "empty.xml"}) {
    for (const char* text : {"", "\r\n \n"}) EXPECT_EQ(ies_error(name, text), " is empty") << name;
  }
}

TEST_F(LuminaireFile, MissingFileOrFolderIsAnError) {
  EXPECT_EQ(photometry_error_of([&] { read_luminaire((directory_.path() / "none.ies").string()); }),
            " cannot be read: No such file or directory");
  EXPECT_EQ(photometry_error_of([&] { read_luminaire(directory_.path().string()); }),
            " cannot be read: Is a directory");
}

TEST_F(LuminaireFile, FileBeyond64MebibytesIsAnError) {
  const std::string path = directory_.write("large.ies", "TILT=NONE\n");
  std::filesystem::resize_file(path, (std::size_t{64} << 20) + 1);
  EXPECT_EQ(photometry_error_of([&] { read_luminaire(path); }), " file: must not be larger than 67108864 bytes");
}

#ifndef LITFOG_SANITIZED  // sanitizers' own memory would count
TEST_F(LuminaireFile, FilesOfTheLargestSizeAreReadWithinTheStatedMemory) {
  const auto write = [this](const char* name, const auto& print) {
    const std::string path = (directory_.path() / name).string();
    std::ofstream file(path, std::ios::binary);
    print(file);
    EXPECT_LE(file.tellp(), std::streamoff{64} << 20);
    return path;
  };
  // A turn that is to be closed by a copy of its first plane.
  constexpr int kVertical = 3'300;
  constexpr int kHorizontal = 10'000;
  const std::string numbers = write("numbers.ies", [&](std::ostream& file) {
    file << "TILT=NONE\n1 1000 1 " << kVertical << " " << kHorizontal << " 1 2 0 0 0\n1 1 50\n";
    for (int i = 0; i < kVertical; ++i) file << i * 0.05 << "\n";
    for (int i = 0; i < kHorizontal; ++i) file << i * 0.036 << "\n";
    for (int i = 0; i < kVertical * kHorizontal; ++i) file << "1\n";
  });
  // Every byte of the names takes two in UTF-8.
  const std::string words = write("words.ies", [](std::ostream& file) {
    file << "IESNA:LM-63-2002\n[LUMINAIRE]\n";
    for (int i = 0; i < 60; ++i) file << "[MORE] " << std::string(std::size_t{1} << 20, '\xE9') << "\n";
    file << "TILT=words.tlt\n1 1000 1 2 1 1 2 0 0 0\n1 1 50\n0 90\n0\n100 50\n";
  });
  write("words.tlt", [](std::ostream& file) {
    file << "1 2\n0 90\n1 0.8\n" << std::string(std::size_t{63} << 20, '\xE9');
  });

  const MemoryLimit limit(kMaxLuminaireMemory);
  EXPECT_EQ(read_luminaire(numbers).distribution.intensity.size(), std::size_t{kVertical} * (kHorizontal + 1));
  EXPECT_GT(read_luminaire(words).name.size(), std::size_t{120} << 20);
  EXPECT_THROW(std::string(2 * kMaxLuminaireMemory, ' '), std::bad_alloc);  // the limit is one
}
#endif

}  // namespace
}  // namespace litfog::test
