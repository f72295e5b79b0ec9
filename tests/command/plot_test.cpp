// SPDX-License-Identifier: Apache-2.0
#include "command/plot.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <CLI/Error.hpp>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/exit_status.h"
#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "litfog/files/output_error.h"

namespace litfog::test {
using namespace command;

namespace {

/// While it lives, programs are looked for in one folder alone.
class ProgramFolder {
 public:
  explicit ProgramFolder(const std::filesystem::path& folder) { setenv("PATH", folder.c_str(), 1); }
  ~ProgramFolder() { setenv("PATH", path_.c_str(), 1); }
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

 private:
  std::string path_ = std::getenv("PATH");
};

/// A shell script that can be run as a program.
void write_program(const std::filesystem::path& file, const std::string& script) {
  std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

Figure one_line() {
  Series series{.name = "falls", .points = {{1, 1000}, {10, 1}, {100, 1e-6, "here"}}};
  return {.title = "Title",
          .charts = {{.title = "Chart", .x = {"range (m)", true}, .y = {"attenuation", true}, .series = {series}}}};
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Plot, PngHasTheSizeAskedForAndContent) {
  Figure figure = one_line();
  figure.width = 640;
  figure.height = 320;
  const std::string png = draw_figure(figure, FigureFormat::png);
  ASSERT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1A\n");
  EXPECT_EQ(big_endian(png, 16), 640u);
  EXPECT_EQ(big_endian(png, 20), 320u);
  figure.charts[0].series[0].points = {{1, 1}, {1.5, 1}, {100, 1}};
  EXPECT_NE(draw_figure(figure, FigureFormat::png), png) << "the data leaves no trace";
}

TEST(Plot, SvgShowsEveryText) {
  Figure figure = one_line();
  figure.charts[0].y.label = "error (1/255), [5 %] 'a_b^2' #1; @7 $8 \\9 {x} \xC3\xA4";
  const std::string svg = draw_figure(figure, FigureFormat::svg);
  EXPECT_TRUE(contains(svg, "<svg"));
  for (const std::string& text : {std::string("Title"), std::string("Chart"), std::string("range (m)"),
                                  std::string("falls"), std::string("here"), figure.charts[0].y.label}) {
    EXPECT_TRUE(contains(svg, text)) << text << "\n" << svg;
  }
}

TEST(Plot, FiguresDrawnTogetherAreThoseDrawnAlone) {
  Figure polar = one_line();
  polar.charts[0].is_polar = true;
  polar.charts[0].y.most = 1000;
  const std::vector<Figure> figures{one_line(), polar, one_line()};
  const std::vector<std::string> together = draw_svg_figures(figures);
  ASSERT_EQ(together.size(), figures.size());
  for (std::size_t i = 0; i < figures.size(); ++i) {
    EXPECT_EQ(together[i], draw_figure(figures[i], FigureFormat::svg)) << i;
  }
  EXPECT_TRUE(draw_svg_figures({}).empty());
}

TEST(Plot, ChartsStandSideBySide) {
  Figure figure = one_line();
  figure.charts.push_back(figure.charts[0]);
  figure.charts[1].title = "Second";
  figure.charts[1].series.push_back({.name = "without points"});
  figure.charts.push_back({.title = "Empty", .x = {"x"}, .y = {"y"}, .series = {}});
  figure.columns = 2;
  const std::string svg = draw_figure(figure, FigureFormat::svg);
  EXPECT_TRUE(contains(svg, "Chart") && contains(svg, "Second"));
}

TEST(Plot, EveryStyleAndPositionIsDrawn) {
  const auto draw = [](SeriesStyle style, KeyPlace key) {
    Figure figure = one_line();
    figure.charts[0].key = key;
    figure.charts[0].series[0].style = style;
    return draw_figure(figure, FigureFormat::svg);
  };
  // A series' name is also the title of its group, which is not seen.
  const auto count_names = [](const std::string& svg) {
    int count = 0;
    for (auto at = svg.find("falls"); at != std::string::npos; at = svg.find("falls", at + 1)) ++count;
    return count;
  };
  for (const auto style : {SeriesStyle::line, SeriesStyle::points, SeriesStyle::line_and_points, SeriesStyle::dashes}) {
    const int unseen = count_names(draw(style, KeyPlace::none));
    for (const auto key :
         {KeyPlace::top_right, KeyPlace::bottom_left, KeyPlace::bottom_right, KeyPlace::above, KeyPlace::beside}) {
      EXPECT_EQ(count_names(draw(style, key)), unseen + 1);
    }
  }
  for (const auto place : {LabelPlace::right, LabelPlace::above, LabelPlace::below}) {
    Figure figure = one_line();
    figure.charts[0].series[0].points[0] = {1, 1, "label", place};
    EXPECT_TRUE(contains(draw_figure(figure, FigureFormat::svg), "label"));
  }
}

TEST(Plot, OutermostRingIsThatOfTheData) {
  Figure figure = one_line();
  figure.charts[0].is_polar = true;
  figure.charts[0].y.most = 1;
  const std::string svg = draw_figure(figure, FigureFormat::svg);
  EXPECT_TRUE(contains(svg, ">1<"));
  figure.charts[0].y.most = 1 + 1e-12;
  EXPECT_EQ(draw_figure(figure, FigureFormat::svg), svg) << "rounding";
  figure.charts[0].y.most = 1.1;
  EXPECT_TRUE(contains(draw_figure(figure, FigureFormat::svg), ">1.5<"));
}

TEST(Plot, LongNumbersBelowAnAxisStandApart) {
  Figure figure = one_line();
  figure.charts[0].x = {.label = "range (m)", .most = 174'000};
  const std::string svg = draw_figure(figure, FigureFormat::svg);
  for (const char* shown : {">0<", ">50000<", ">100000<", ">150000<"}) EXPECT_TRUE(contains(svg, shown)) << shown;
  EXPECT_FALSE(contains(svg, ">20000<"));
}

TEST(Plot, TextsAreNeverCommands) {
  const std::string file = testing::TempDir() + "litfog-plot-injected";
  for (const std::string& text :
       {"it's \"50 %\" \\n $series0 `touch " + file + "` {/=40 x}^2_3 @a\nset label 'injected'\n!touch " + file,
        std::string("'; !touch ") + file, std::string("END\n"), std::string("\xC3\xA4 \xE2\x82\xAC")}) {
    Figure figure = one_line();
    figure.title = figure.charts[0].title = figure.charts[0].x.label = figure.charts[0].y.label = text;
    figure.charts[0].series[0].name = figure.charts[0].series[0].points[0].label = text;
    const std::string svg = draw_figure(figure, FigureFormat::svg);
    EXPECT_FALSE(contains(svg, ">injected<")) << svg;
    EXPECT_NE(access(file.c_str(), F_OK), 0) << text;
  }
}

TEST(Plot, SvgOfAnyTextIsXml) {
  Figure figure = one_line();
  figure.title = "U+FFFE \xEF\xBF\xBE, no UTF-8 \xFF, bell \x07";
  const std::string svg = draw_figure(figure, FigureFormat::svg);
  EXPECT_TRUE(contains(svg, "U+FFFE \\ufffe, no UTF-8 \\xff, bell \\x07")) << svg;
  for (const char* forbidden : {"\xEF\xBF\xBE", "\xFF", "\x07"}) EXPECT_FALSE(contains(svg, forbidden));
}

TEST(Plot, ValueThatTheAxisCannotShowIsAnError) {
  const auto error_with = [](PlotPoint point) -> std::string {
    Figure figure = one_line();
    figure.charts[0].series[0].points[1] = point;
    return sentence_of<std::invalid_argument>([&] { draw_figure(figure, FigureFormat::svg); });
  };
  EXPECT_EQ(error_with({0, 1}), "range (m) = 0: must be finite and > 0 on a logarithmic axis");
  EXPECT_EQ(error_with({1, -1}), "attenuation = -1: must be finite and > 0 on a logarithmic axis");
  EXPECT_EQ(error_with({1, std::numeric_limits<double>::infinity()}),
            "attenuation = inf: must be finite and > 0 on a logarithmic axis");
  EXPECT_EQ(error_with({1, std::numeric_limits<double>::quiet_NaN()}),
            "attenuation = nan: must be finite and > 0 on a logarithmic axis");
  EXPECT_THROW(draw_figure({}, FigureFormat::png), std::invalid_argument);
  Figure without_points = one_line();
  without_points.charts[0].series[0].points.clear();
  EXPECT_THROW(draw_figure(without_points, FigureFormat::png), std::invalid_argument);
  Figure without_radius = one_line();
  without_radius.charts[0].is_polar = true;
  EXPECT_THROW(draw_figure(without_radius, FigureFormat::png), std::invalid_argument);
  without_radius.charts[0].y.most = 1;
  EXPECT_NO_THROW(draw_figure(without_radius, FigureFormat::png));
}

TEST(Plot, OtherFileNameEndingIsAnError) {
  EXPECT_EQ(figure_format_of("--plot", "a.b/c.png"), FigureFormat::png);
  EXPECT_EQ(figure_format_of("--plot", "c.svg"), FigureFormat::svg);
  for (const char* path : {"c.jpg", "c", "png", "c.PNG", ".png", ""}) {
    EXPECT_THROW(figure_format_of("--plot", path), CLI::ValidationError) << path;
  }
}

TEST(Plot, MissingGnuplotIsNamed) {
  {
    const ProgramFolder folder("/nowhere");
    EXPECT_THROW(require_plotter(), MissingCapability);
    EXPECT_THROW(draw_figure(one_line(), FigureFormat::svg), MissingCapability);
  }
  EXPECT_NO_THROW(require_plotter());
}

TEST(Plot, GnuplotThatEndsBetweenTwoFiguresIsAnError) {
  const TemporaryDirectory directory;
  const auto draw_by = [&directory](const std::string& script) {
    write_program(directory.path() / "gnuplot", script);
    const ProgramFolder folder(directory.path());
    return draw_svg_figures({one_line(), one_line()});
  };
  EXPECT_EQ(draw_by("echo '<svg></svg>'; echo; echo '<svg></svg>'"),
            (std::vector<std::string>{"<svg></svg>\n\n", "<svg></svg>\n"}));
  EXPECT_THROW(draw_by("echo '<svg></svg>'; echo '<svg>'"), OutputError) << "as with a full disk";
  EXPECT_THROW(draw_by("echo '<svg></svg>'; kill -9 $$"), MissingCapability);
}

}  // namespace

}  // namespace litfog::test
