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
  std::string label;    ///< with its unit, "time (ns)"; empty: its values mean nothing, and are not written
  bool is_log = false;  ///< then every value must be > 0
  double least = 0;     ///< least and most shown; where both are 0, what the data needs
  double most = 0;
};

/// Where a label stands, seen from its point.
enum class LabelPlace { right, above, below };

struct PlotPoint {
  double x;  ///< finite
  double y;  ///< finite
  std::string label = {};
  LabelPlace label_place = LabelPlace::right;
};

enum class SeriesStyle { line, points, line_and_points, dashes };

struct Series {
  std::string name = {};  ///< for the key; without a name it is not in it
  std::vector<PlotPoint> points = {};
  SeriesStyle style = SeriesStyle::line;
  int color = -1;  ///< one of eight that colour-blind readers can tell apart, each with its mark, and again with other
                   ///< marks; -1: the next
};

enum class KeyPlace { none, top_right, bottom_left, bottom_right, above, beside };

struct Chart {
  std::string title = {};
  Axis x;
  Axis y;
  std::vector<Series> series = {};
  KeyPlace key = KeyPlace::top_right;
  /// As a luminaire's intensities are drawn: x is an angle in degrees from straight down, y >= 0 the distance from the
  /// middle. y.most, within the outermost ring, must be given; y.label becomes the title.
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

/// The format that a file's ending asks for. Any other ending than .png or .svg is the option's wrong usage.
FigureFormat figure_format_of(const std::string& option, const std::string& path);

/// Throws MissingCapability where gnuplot is not installed: for commands that work long before they draw.
void require_plotter();

/// The figure as the bytes of a PNG or SVG file. Throws MissingCapability where gnuplot is not installed, and
/// std::invalid_argument for a figure without points, or a value that its axis cannot show.
std::string draw_figure(const Figure& figure, FigureFormat format);

/// The bytes of an SVG file each, as draw_figure's, by one run of gnuplot: its start takes longer than a figure.
std::vector<std::string> draw_svg_figures(const std::vector<Figure>& figures);

}  // namespace litfog::command
