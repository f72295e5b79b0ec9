// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/eulumdat.h"

#include <vector>

#include "command/temporary_directory.h"
#include "photometry/photometric_file.h"

namespace litfog::test {
namespace {

/// A sound file of one plane and two gamma angles, line by line as numbered in the format's description; each test
/// spoils a line of it.
struct EulumdatText {
  std::vector<std::string> lines{
      "company", "1",    "1",      "1",    "0",    "2",  "0",             // to 7: Ityp, Isym, Mc, Dc, Ng, Dg
      "report",  "name", "number", "file", "date",                        // to 12
      "100",     "100",  "10",     "90",   "0",    "1",  "2",  "3", "4",  // to 21: sizes in mm
      "100",     "80",   "1",      "0",                                   // to 25: DFF, LORL, conversion factor, tilt
      "1",       "2",    "lamp",   "1000", "warm", "1B", "40",            // to 32: one set of lamps
      "1",       "1",    "1",      "1",    "1",    "1",  "1",  "1", "1", "1",  // to 42: direct ratios
      "0",       "0",    "90",     "500",  "100"};  // to 47: C plane, gamma angles, intensities

  std::string str() const {
    std::string text;
    for (const auto& line : lines) text += line + "\n";
    return text;
  }
};

Luminaire parsed_eulumdat(const std::string& text) { return parse_eulumdat(text, "lamp.ldt"); }

/// What is wrong with the sound file with one line replaced.
std::string eulumdat_error(std::size_t line, const std::string& text) {
  EulumdatText eulumdat;
  eulumdat.lines[line - 1] = text;
  return photometry_error_of([&] { parsed_eulumdat(eulumdat.str()); });
}

TEST(Eulumdat, IntensitiesAreScaledByTheFluxOfTheLamps) {
  EulumdatText eulumdat;
  EXPECT_EQ(parsed_eulumdat(eulumdat.str()).distribution.intensity, (std::vector<double>{500, 100}));
  eulumdat.lines[28] = "2500";
  eulumdat.lines[23] = "0.5";
  const Luminaire luminaire = parsed_eulumdat(eulumdat.str());
  EXPECT_EQ(luminaire.distribution.intensity, (std::vector<double>{625, 125}));
  EXPECT_EQ(luminaire.lamp_flux, 2500);
  EXPECT_EQ(luminaire.light_output_ratio, 0.8);
  EXPECT_EQ(stated_flux(luminaire), 2000);
  EXPECT_FALSE(luminaire.is_absolute);
}

TEST(Eulumdat, FileIsKnownByItsTextWhateverItsEnding) {
  const TemporaryDirectory directory;
  for (const char* name : {"lamp.ies", "lamp.csv", "lamp.LDT", "lamp"}) {
    EXPECT_EQ(read_luminaire(directory.write(name, EulumdatText().str())).name, "name") << name;
  }
}

TEST(Eulumdat, FirstOfSeveralSetsOfLampsIsTaken) {
  const Luminaire luminaire = our_luminaire("absolute.ldt");  // the second set has twice the flux
  EXPECT_EQ(luminaire.lamp_flux, 2500);
  EXPECT_EQ(find_peak(luminaire.distribution).intensity, 1000);
}

TEST(Eulumdat, NegativeNumberOfLampsIsAbsolutePhotometry) {
  EXPECT_TRUE(our_luminaire("absolute.ldt").is_absolute);
  EXPECT_FALSE(our_luminaire("isym_4.ldt").is_absolute);
}

TEST(Eulumdat, EverySymmetryGivesTheSameLamp) {
  const Luminaire quadrant = our_luminaire("type_c_quadrant.ies");
  for (const char* file :
       {"isym_0.ldt", "isym_2.ldt", "isym_3.ldt", "isym_4.ldt", "uneven.ldt", "spelling.ldt", "absolute.ldt"}) {
    SCOPED_TRACE(file);
    expect_same_beam(quadrant, our_luminaire(file));
  }
  IntensityDistribution round = quadrant.distribution;
  round.horizontal = {0};
  round.intensity.resize(4);
  expect_same_beam({.name = "",
                    .manufacturer = "",
                    .distribution = round,
                    .peak_location = {},
                    .lamp_flux = {},
                    .light_output_ratio = {},
                    .opening = {},
                    .tilt = {}},
                   our_luminaire("isym_1.ldt"));
}

/// Isym 2 mirrors at C0-C180, so that it knows left from right; Isym 3 mirrors at C90-C270.
TEST(Eulumdat, HalfIsMirroredAtThePlaneOfItsSymmetry) {
  EulumdatText half;
  half.lines[2] = "2";
  half.lines[3] = "4";
  half.lines.erase(half.lines.begin() + 42, half.lines.end());
  for (const char* line : {"0", "90", "180", "270", "0", "90", "9", "1", "9", "2", "9", "3"})
    half.lines.push_back(line);
  const auto at = [](const EulumdatText& text, double x, double y) {
    return intensity_at(parsed_eulumdat(text.str()).distribution, {x, y, 0});
  };
  EXPECT_DOUBLE_EQ(at(half, 1, 0), 1);
  EXPECT_DOUBLE_EQ(at(half, 0, 1), 2);
  EXPECT_DOUBLE_EQ(at(half, 0, -1), 2);
  EXPECT_DOUBLE_EQ(at(half, -1, 0), 3);
  half.lines[2] = "3";  // the planes are now C270, C0 and C90
  EXPECT_DOUBLE_EQ(at(half, 0, -1), 1);
  EXPECT_DOUBLE_EQ(at(half, 1, 0), 2);
  EXPECT_DOUBLE_EQ(at(half, -1, 0), 2);
  EXPECT_DOUBLE_EQ(at(half, 0, 1), 3);
}

TEST(Eulumdat, DecimalCommasAndLatin1AreRead) {
  const Luminaire luminaire = our_luminaire("spelling.ldt");
  EXPECT_EQ(luminaire.name, "Quadrant l\xC3\xA4mp");
  EXPECT_EQ(luminaire.manufacturer, "litfog");
  EXPECT_EQ(eulumdat_error(29, "1,000.5"), "29:1: flux of lamps = 1,000.5: must be a finite number");
  EXPECT_EQ(eulumdat_error(29, "1,000,5"), "29:1: flux of lamps = 1,000,5: must be a finite number");
}

TEST(Eulumdat, OpeningIsInMetres) {
  const LuminousOpening round = parsed_eulumdat(EulumdatText().str()).opening;
  EXPECT_DOUBLE_EQ(round.length, -0.09);
  EXPECT_DOUBLE_EQ(round.width, -0.09);
  EXPECT_DOUBLE_EQ(round.height, 0.004);
  EulumdatText box;
  box.lines[16] = "50";
  EXPECT_DOUBLE_EQ(parsed_eulumdat(box.str()).opening.length, 0.09);
  EXPECT_DOUBLE_EQ(parsed_eulumdat(box.str()).opening.width, 0.05);
  EXPECT_DOUBLE_EQ(opening_radius(round), 0.045);
  EulumdatText none;
  none.lines[15] = "0";
  EXPECT_EQ(opening_radius(parsed_eulumdat(none.str()).opening), 0);
}

TEST(Eulumdat, UnusedLinesMayBeBlank) {
  EulumdatText eulumdat;
  for (const int line :
       {1, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 25, 27, 28, 30, 31, 32, 33, 42}) {
    eulumdat.lines[std::size_t(line - 1)] = "";
  }
  const Luminaire luminaire = parsed_eulumdat(eulumdat.str());
  EXPECT_EQ(luminaire.distribution.intensity, (std::vector<double>{500, 100}));
  EXPECT_FALSE(stated_flux(luminaire));
}

TEST(Eulumdat, FieldThatChangesNoIntensityMayBeBlankOrAnyNumber) {
  const std::vector<double> intensity = parsed_eulumdat(EulumdatText().str()).distribution.intensity;
  std::vector<std::size_t> fields{5, 7, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 25, 27};
  for (std::size_t room = 33; room <= 42; ++room) fields.push_back(room);
  for (const std::size_t line : fields) {
    for (const char* text : {"", "0", "-1", "1.5", "4294967295", "-1e300"}) {
      EulumdatText eulumdat;
      eulumdat.lines[line - 1] = text;
      EXPECT_EQ(parsed_eulumdat(eulumdat.str()).distribution.intensity, intensity) << line << ": " << text;
    }
  }
  EulumdatText negative;
  negative.lines[22] = "-1";
  EXPECT_FALSE(stated_flux(parsed_eulumdat(negative.str())));
}

TEST(Eulumdat, BadValueIsAnErrorAtItsLocation) {
  const std::string kFinite = "must be a finite number";
  EXPECT_EQ(eulumdat_error(1, "another company"), "(accepted)");
  EXPECT_EQ(eulumdat_error(2, "4"), "2:1: type indicator Ityp = 4: must be an integer from 0 to 3");
  EXPECT_EQ(eulumdat_error(3, "5"), "3:1: symmetry indicator Isym = 5: must be an integer from 0 to 4");
  EXPECT_EQ(eulumdat_error(3, ""), "3:1: symmetry indicator Isym: must be given");
  EXPECT_EQ(eulumdat_error(4, "2147483648"),
            "4:1: number of C planes Mc = 2147483648: must be an integer from 1 to 10000");
  EXPECT_EQ(eulumdat_error(6, "-2"), "6:1: number of gamma angles Ng = -2: must be an integer from 2 to 10000");
  EXPECT_EQ(eulumdat_error(6, "two"), "6:1: number of gamma angles Ng = two: " + kFinite);
  EXPECT_EQ(eulumdat_error(13, "long"), "13:1: length = long: " + kFinite);
  EXPECT_EQ(eulumdat_error(23, "most"), "23:1: light output ratio = most: " + kFinite);
  EXPECT_EQ(eulumdat_error(24, "0"), "24:1: conversion factor = 0: must be > 0");
  EXPECT_EQ(eulumdat_error(26, "0"), "26:1: number of lamp sets = 0: must be an integer from 1 to 100");
  EXPECT_EQ(eulumdat_error(29, "0"), "29:1: flux of lamps = 0: must be > 0");
  EXPECT_EQ(eulumdat_error(29, "inf"), "29:1: flux of lamps = inf: " + kFinite);
  EXPECT_EQ(eulumdat_error(33, "x"), "33:1: direct ratio = x: " + kFinite);
  EXPECT_EQ(eulumdat_error(43, "361"), "43:1: C plane 1 of 1 = 361: must be in [-180, 360]");
  EXPECT_EQ(eulumdat_error(45, "180.5"), "45:1: gamma angle 2 of 2 = 180.5: must be in [0, 180]");
  EXPECT_EQ(eulumdat_error(45, "0"), "45:1: gamma angle 2 of 2 = 0: must be greater than the one before, 0");
  EXPECT_EQ(eulumdat_error(46, "-1"), "46:1: intensity 1 of 2 = -1: must be >= 0");
  EXPECT_EQ(eulumdat_error(47, " nan"), "47:2: intensity = nan: " + kFinite);
  EXPECT_EQ(eulumdat_error(47, "100\n5"),
            "48:1: number after the last intensity = 5: must not be there by the file's counts");
  EXPECT_EQ(eulumdat_error(47, ""), "47:1: intensity 2 of 2: must be given");
}

TEST(Eulumdat, PlanesThatDoNotFitTheSymmetryAreAnError) {
  const auto error = [](const char* symmetry, std::vector<std::string> planes) {
    EulumdatText eulumdat;
    eulumdat.lines[2] = symmetry;
    eulumdat.lines[3] = std::to_string(planes.size());
    eulumdat.lines.erase(eulumdat.lines.begin() + 42);
    eulumdat.lines.insert(eulumdat.lines.begin() + 42, planes.begin(), planes.end());
    const std::string text = photometry_error_of([&] { parsed_eulumdat(eulumdat.str()); });
    return text.substr(0, text.find(':', text.find('=')));
  };
  EXPECT_EQ(error("0", {"0", "90", "180"}), "45:1: last C plane = 180");
  EXPECT_EQ(error("0", {"-180", "0", "180", "360"}), "46:1: last C plane = 360") << "more than a turn";
  EXPECT_EQ(error("2", {"0", "90", "170", "270"}), "46:1: last C plane = 270");
  EXPECT_EQ(error("2", {"0", "120", "240"}), "45:1: last C plane = 240");
  EXPECT_EQ(error("3", {"0", "90", "180", "280"}), "46:1: last C plane = 280");
  EXPECT_EQ(error("3", {"0", "45", "90", "120", "180", "200", "270", "360"}), "50:1: last C plane = 360") << "C0 again";
  EXPECT_EQ(error("4", {"0", "180"}), "44:1: last C plane = 180");
  EXPECT_EQ(error("4", {"0", "80", "180", "270"}), "46:1: last C plane = 270");
}

TEST(Eulumdat, MissingPlaneIsAnError) {
  std::string text = bytes_of(std::string(LITFOG_PHOTOMETRY_DIR) + "/isym_0.ldt");
  for (int line = 0; line < 4; ++line) text.erase(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_NE(photometry_error_of([&] {
              parsed_eulumdat(text);
            }).find("intensity 29 of 32: must be given, but the file ends here"),
            std::string::npos);
  EulumdatText cut;
  cut.lines.resize(42);
  EXPECT_EQ(photometry_error_of([&] { parsed_eulumdat(cut.str()); }),
            "43:1: C plane 1 of 1: must be given, but the file ends here");
}

}  // namespace
}  // namespace litfog::test
