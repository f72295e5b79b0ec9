// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/isocandela.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

#include "litfog/photometry/elliptical_beam.h"
#include "photometry/memory_limit.h"
#include "photometry/photometric_file.h"
#include "reference/degree.h"

namespace litfog::test {
namespace {

Luminaire parsed_isocandela(const std::string& text) { return parse_isocandela(text, "f.csv"); }
std::string isocandela_error(const std::string& text) {
  return photometry_error_of([&] { parsed_isocandela(text); });
}

double candela_at(const Luminaire& light, double horizontal_deg, double vertical_deg) {
  return intensity_at(light.distribution,
                      direction_of(PhotometryType::a, horizontal_deg * kDegree, vertical_deg * kDegree));
}

TEST(Isocandela, GridIsReadAsPrinted) {
  const Luminaire light = our_luminaire("position_light_left.csv");
  EXPECT_EQ(light.name, "position light, left");
  EXPECT_FALSE(find_error(light.distribution));
  EXPECT_NEAR(candela_at(light, 0, 0), 40, 1e-9);
  EXPECT_NEAR(candela_at(light, -10, 0), 40, 1e-9);
  EXPECT_NEAR(candela_at(light, -110, 0), 5, 1e-9);
  EXPECT_NEAR(candela_at(light, -15, 15), 24.5, 1e-9) << "linear between the angles";
  EXPECT_NEAR(candela_at(light, -20, -30), 9, 1e-9) << "mirrored, since the vertical angles begin at 0";
  EXPECT_EQ(candela_at(light, 1, 0), 0) << "beyond the table";
  EXPECT_EQ(to_string(light.peak_location).substr(to_string(light.peak_location).find(".csv")), ".csv:12:8");
}

TEST(Isocandela, RowsMayRiseOrFall) {
  const Luminaire rising = parsed_isocandela("vertical_deg,-5,0,5\n-2,1,2,3\n0,4,5,6\n3,7,8,9\n");
  const Luminaire falling = parsed_isocandela("vertical_deg, -5, 0, 5\r\n3, 7, 8, 9\r\n0, 4, 5, 6\r\n\r\n-2, 1, 2, 3");
  expect_same_beam(rising, falling);
  EXPECT_EQ(candela_at(rising, 5, 3), 9);
  EXPECT_NEAR(candela_at(rising, -5, -2), 1, 1e-9);
}

TEST(Isocandela, TablesOfSpreadsheetsAreReadAsThoseByHand) {
  const Luminaire plain = parsed_isocandela("# lamp, left\nvertical_deg,-2.5,0,5\n-2,1,2.5,3\n0,4,5,6000\n");
  for (const char* text :
       {"# lamp, left;;;\r\nvertical_deg;-2,5;0;5\r\n;;;\r\n-2;1;2,5;3\r\n0;4;5;6000\r\n",
        "\"# lamp, left\",,,\n\"vertical_deg\",\"-2.5\",\"0\",\"5\"\n,,,\n\"-2\",\"1\",\"2.5\",\"3\"\n0,4,5,6000\n",
        "# lamp, left\rvertical_deg;\"-2,5\";0;5\r-2;1;2.5;3\r0;4;5;6000"}) {
    const Luminaire light = parsed_isocandela(text);
    expect_same_beam(light, plain);
    EXPECT_EQ(light.name, "lamp, left");
    EXPECT_TRUE(is_isocandela(text));
  }
  EXPECT_EQ(isocandela_error("vertical_deg;-2,5;0\n0;1;x"), "2:5: candela = x: must be a finite number");
  EXPECT_TRUE(is_isocandela("\"candela\";\"horizontal_deg\";\"vertical_deg\"\n"));
}

TEST(Isocandela, PointsThatMayBeBetweenThousandsAreRefusedUnlessAnotherIsDecimal) {
  const std::string rule =
      ": must have no point, which may be between thousands; after a decimal point, write more or fewer than three "
      "digits";
  const std::string header = "# left, \nvertical_deg;-2,5;0\n";
  EXPECT_EQ(isocandela_error(header + "0;1.200;3\n1;2;3\n"), "3:3: candela = 1.200" + rule);
  EXPECT_EQ(isocandela_error("vertical_deg;-2;0\n0;-12.000;3\n1;2,5;3\n"), "2:3: candela = -12.000" + rule);
  EXPECT_EQ(isocandela_error("vertical_deg;-2;0\n0;1.200,5;3\n1;2;3\n"), "2:3: candela = 1.200,5" + rule);
  for (const char* decimal : {"1.2", "1.25", "0.125", "1200.125", "1.2000"}) {
    EXPECT_EQ(parsed_isocandela(header + "0;" + decimal + ";3000\n1;2;3\n").distribution.intensity[0],
              std::stod(decimal));
  }
  EXPECT_EQ(isocandela_error(header + "0;0.5;3\n1;1.200;3\n"), "4:3: candela = 1.200" + rule)
      << "both kinds of decimals";
  const std::string plain = "# 2,5 and 0.5\nvertical_deg;-2;0\n";
  EXPECT_EQ(isocandela_error(plain + "0;1.200;2.500\n1;2;3\n"), "3:3: candela = 1.200" + rule);
  EXPECT_EQ(isocandela_error(plain + "0;2000;3\n1;2;\"1.200\"\n"), "4:5: candela = 1.200" + rule);
  EXPECT_EQ(isocandela_error(plain + "0;1.234.567;3\n1;2;3\n"), "3:3: candela = 1.234.567" + rule);
  EXPECT_EQ(isocandela_error("vertical_deg;-2.500;0\n0;1;2\n1;2;3\n"), "1:14: horizontal angle = -2.500" + rule);
  for (const char* decimal : {"0.5", "12.25", "0.125", "\" 1200.125\"", "1.2e3", ".500"}) {
    EXPECT_EQ(parsed_isocandela(plain + "0;1.200;3\n1;2;" + decimal + "\n").distribution.intensity[0], 1.2) << decimal;
  }
  EXPECT_EQ(isocandela_error(plain + "0;1.234.567;0.5\n1;2;3\n"), "3:3: candela = 1.234.567: must be a finite number");
  EXPECT_EQ(parsed_isocandela("vertical_deg,-2,0\n0,1.200,3\n1,2,3\n").distribution.intensity[0], 1.2);
}

TEST(Isocandela, EllipsesAreReadAsDrawn) {
  const Luminaire light = our_luminaire("approach_side_row.csv");
  EXPECT_EQ(light.name, "approach side row light");
  const auto at = [&light](double turn, double angle_deg) {
    return intensity_at(light.distribution, direction_of(PhotometryType::c, turn, angle_deg * kDegree));
  };
  EXPECT_NEAR(at(0, 0), 5000, 1e-9);
  EXPECT_NEAR(at(0, 6.9), 5000, 1e-9);
  EXPECT_NEAR(at(std::numbers::pi, 11.5), 500, 5000 * kEllipticalBeamMaxError);
  EXPECT_NEAR(at(std::numbers::pi / 2, 6), 500, 5000 * kEllipticalBeamMaxError);
  EXPECT_GE(at(0, 16.4), 245);
  EXPECT_EQ(at(0, 17), 0);
  EXPECT_EQ(at(std::numbers::pi / 2, 8.5), 0);
}

TEST(Isocandela, TableIsKnownByItsHeaderOrItsName) {
  EXPECT_TRUE(is_isocandela("\n# a\n  \nvertical_deg,0,1\n"));
  EXPECT_TRUE(is_isocandela("candela,horizontal_deg,vertical_deg"));
  EXPECT_FALSE(is_isocandela("IESNA:LM-63-2002\nvertical_deg"));
  EXPECT_FALSE(is_isocandela("# only a comment"));
  EXPECT_FALSE(is_isocandela(""));
}

TEST(Isocandela, WrongTablesAreErrorsAtTheirCells) {
  const std::string header = "must be vertical_deg and the horizontal angles, or candela,horizontal_deg,vertical_deg, ";
  EXPECT_EQ(isocandela_error("vertical,1,2\n"),
            "1:1: header = vertical,1,2: " + header + "with commas or semicolons between");
  EXPECT_EQ(isocandela_error("vertical;1;2\n"),
            "1:1: header = vertical;1;2: " + header + "with commas or semicolons between");
  EXPECT_EQ(isocandela_error("vertical_deg\t1\t2\n"),
            "1:1: header = vertical_deg\t1\t2: " + header + "with commas or semicolons between");
  EXPECT_EQ(isocandela_error("range_m,lx\n10,100\n"),
            "1:1: header = range_m,lx: " + header +
                "with commas or semicolons between; a table of illuminance belongs in a light spec, as its range's "
                "illuminance");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,1,\"2\n"), "2:5: quote: must be closed on its line");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,1,\"1,200\"\n"),
            "2:5: candela = 1,200: must have a decimal point where commas are between cells");
  EXPECT_EQ(isocandela_error(""), "1:1: header: must be given");
  EXPECT_EQ(isocandela_error("vertical_deg,1\n"), "1:14: header = 1: must have at least two horizontal angles");
  EXPECT_EQ(isocandela_error("vertical_deg,1,1\n"), "1:16: horizontal angle = 1: must be greater than the one before");
  EXPECT_EQ(isocandela_error("vertical_deg,1,181\n"), "1:16: horizontal angle = 181: must be in [-180, 180]");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,1,1\n"),
            "3:1: second row of candela: must be given, but the file ends here");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,1\n"), "2:3: number of cells = 2: must be 3, as in the header");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,1,\n"), "2:5: candela: must be given");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,1,-1\n"), "2:5: candela = -1: must be in [0, 1e30]");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n91,1,1\n"), "2:1: vertical angle = 91: must be in [-90, 90]");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,1,1\n5,1,1\n4,1,1\n"),
            "4:1: vertical angle = 4: must rise from row to row, or fall from row to row");
  EXPECT_EQ(isocandela_error("vertical_deg,1,2\n0,0,0\n5,0,0\n"), "3:5: candela = 0: must not be 0 as all others are");
  const std::string ellipses = "candela,horizontal_deg,vertical_deg\n";
  EXPECT_EQ(isocandela_error(ellipses), "2:1: row of an ellipse: must be given, but the file ends here");
  EXPECT_EQ(isocandela_error(ellipses + "100,5,x\n"), "2:7: vertical half axis = x: must be a finite number");
  EXPECT_EQ(isocandela_error(ellipses + "0,5,5\n"), "2:1: candela = 0: must be > 0");
  EXPECT_EQ(isocandela_error(ellipses + "100,5,181\n"), "2:7: vertical half axis = 181: must be in [1e-4, 180]");
  EXPECT_EQ(isocandela_error(ellipses + "100,5,5\n90,6,5\n"),
            "3:6: vertical half axis = 5: must be greater than in the row before");
  EXPECT_EQ(isocandela_error(ellipses + "100,5,5\n101,6,6\n"),
            "3:1: candela = 101: must be at most that of the row before");
  EXPECT_EQ(isocandela_error("vertical_deg" + std::string(1000, ',')), "1:1013: cell: must be given");
}

#ifndef LITFOG_SANITIZED  // sanitizers' own memory would count
TEST(Isocandela, LineOfCommasTakesNoMemoryByTheirNumber) {
  const std::string text = "vertical_deg" + std::string(std::size_t{8} << 20, ',');
  const MemoryLimit limit(std::size_t{64} << 20);
  EXPECT_EQ(isocandela_error(text), "1:1: record: must not have more than 65,536 fields");
}
#endif

TEST(Isocandela, HostileTextTakesLinearTime) {
  const std::size_t kMany = 4'000'000;  // time that grows with the square would not end here
  EXPECT_EQ(isocandela_error("vertical_deg;0;5\n0;" + std::string(kMany, ';') + "1.200\n"),
            "2:1: record: must not have more than 65,536 fields");
  std::string ellipses = "candela,horizontal_deg,vertical_deg\n";
  for (int i = 1; i <= 1'000'000; ++i) {
    const std::string axis = std::to_string(i * 1e-4);
    ellipses += "1," + axis + "," + axis + "\n";
  }
  EXPECT_EQ(isocandela_error(ellipses), "1002:1: candela = 1: must not begin another ellipse after 1000");
}

}  // namespace
}  // namespace litfog::test
