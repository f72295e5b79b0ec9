// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog::command {

/// Charts as PNG or SVG, drawn by gnuplot (the program, Debian's gnuplot-nox); no display is needed.
///
///     const Figure figure{.title = "Landing lamp",
///                         .charts = {{.x = {"range (m)"}, .y = {"attenuation"}, .series = {{"fit", points}}}}};
///     files::write_whole_file(path, draw_figure(figure, figure_format_of("--plot", path)));

struct Axis {
  std::string label;    ///< with its unit, "time (ns)"; empty: values are meaningless and not shown
  bool is_log = false;  ///< then every value must be > 0
  double least = 0;     ///< least and most shown; both 0: as the data need
  double most = 0;
};

/// The position of a label relative to its point.
enum class LabelPlace { right, above, below };

struct PlotPoint {
  double x;  ///< finite
  double y;  ///< finite
  std::string label = {};
  LabelPlace label_place = LabelPlace::right;
};

enum class SeriesStyle { line, points, line_and_points, dashes };

struct Series {
  std::string name = {};  ///< in the key; empty: not in the key
  std::vector<PlotPoint> points = {};
  SeriesStyle style = SeriesStyle::line;
  int color = -1;  ///< one of eight that colour-blind readers can tell apart, each with its mark, then repeated with
                   ///< other marks; -1: the next
};

enum class KeyPlace { none, top_right, bottom_left, bottom_right, above, beside };

struct Chart {
  std::string title = {};
  Axis x;
  Axis y;
  std::vector<Series> series = {};
  KeyPlace key = KeyPlace::top_right;
  /// A polar chart of a luminaire's intensities: x is an angle in degrees from straight down, y >= 0 the distance from
  /// the centre. y.most, within the outermost ring, must be given; y.label becomes the title.
  bool is_polar = false;
};

/// One or more charts, in rows of `columns`, filled from the left.
struct Figure {
  std::string title = {};
  std::vector<Chart> charts = {};
  int columns = 1;
  int width = 900;  ///< pixels
  int height = 600;
};

enum class FigureFormat { png, svg };

/// The format of a file's ending. Endings other than .png and .svg are usage errors of the option.
FigureFormat figure_format_of(const std::string& option, const std::string& path);

/// Throws MissingCapability if gnuplot is not installed. For commands that work long before they draw.
void require_plotter();

/// The figure as the bytes of a PNG or SVG file. Throws MissingCapability if gnuplot is not installed, and
/// std::invalid_argument for a figure without points, or a value that its axis cannot show.
std::string draw_figure(const Figure& figure, FigureFormat format);

/// draw_figure() for several SVG files by one run of gnuplot, because its start takes longer than a figure.
std::vector<std::string> draw_svg_figures(const std::vector<Figure>& figures);

}  // namespace litfog::command
