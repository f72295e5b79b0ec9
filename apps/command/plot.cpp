// SPDX-License-Identifier: Apache-2.0
#include "command/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "command/exit_status.h"
#include "command/option_rule.h"
#include "command/printable.h"
#include "command/program.h"
#include "litfog/files/output_error.h"

namespace litfog::command {

namespace {

/// Okabe and Ito, "Color Universal Design" (2008), the dark ones first; marks differ too.
constexpr std::array<const char*, 8> kPalette{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                              "#000000", "#56B4E9", "#E69F00", "#888888"};
constexpr std::array<int, 8> kMarks{7, 5, 9, 13, 11, 15, 6, 4};  // gnuplot's: disc, square, triangle, ...

/// Quotes a text for gnuplot. Special characters become octal codes, and so does a digit after a code, which would
/// extend it. The text is printable, so that an SVG file is valid XML.
std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  bool is_behind_code = false;
  for (const char c : printable(text)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_digit = c >= '0' && c <= '9';
    const bool is_plain = byte >= 0x80 || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == ' ';
    if (is_plain || (is_digit && !is_behind_code)) {
      result += c;
      is_behind_code = false;
    } else {
      result += fmt::format("\\{:03o}", byte);
      is_behind_code = true;
    }
  }
  return result + "\"";
}

void expect_shown(double value, const Axis& axis) {
  if (std::isfinite(value) && (!axis.is_log || value > 0)) return;
  throw std::invalid_argument(
      fmt::format("{} = {}: must be finite{}", axis.label, value, axis.is_log ? " and > 0 on a logarithmic axis" : ""));
}

void check(const Figure& figure) {
  std::size_t count = 0;
  for (const Chart& chart : figure.charts) {
    if (chart.is_polar && !(chart.y.most > 0)) throw std::invalid_argument("figure: a polar chart must have a radius");
    for (const Series& series : chart.series) {
      for (const PlotPoint& point : series.points) {
        expect_shown(point.x, chart.x);
        expect_shown(point.y, chart.y);
        ++count;
      }
    }
  }
  if (count == 0) throw std::invalid_argument("figure: must have points");
}

class Script {
 public:
  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The least step of 1, 2 or 5 times a power of ten of which at most `count` reach a value.
double round_step(double most, int count) {
  const double least = most / count;
  const double power = std::pow(10, std::floor(std::log10(least)));
  for (const double factor : {1, 2, 5}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

/// name  gnuplot's: x or y
void add_axis(Script& script, char name, const Axis& axis, const std::vector<Series>& series) {
  script.add("set {}label {} noenhanced", name, in_quotes(axis.label));
  script.add("{} logscale {}", axis.is_log ? "set" : "unset", name);
  if (axis.least == 0 && axis.most == 0) {
    script.add("set {}range [*:*]", name);
  } else {
    script.add("set {}range [{}:{}]", name, axis.least, axis.most);
  }
  // 1000 is easier to read than 10^3, and 10^-9 than 1e-09.
  double least = axis.least > 0 ? axis.least : 1;
  double most = axis.most > 0 ? axis.most : 1;
  for (const Series& one : series) {
    for (const PlotPoint& point : one.points) {
      least = std::min(least, name == 'x' ? point.x : point.y);
      most = std::max(most, name == 'x' ? point.x : point.y);
    }
  }
  const bool has_long_labels = name == 'x' && !axis.is_log && most >= 1e5;  // labels side by side
  script.add("set {}tics {}", name, has_long_labels ? fmt::format("{}", round_step(most, 4)) : "autofreq");
  const char* const format = axis.is_log && (least < 1e-4 || most > 1e5) ? "'10^{%T}'" : "'%g'";
  script.add("set format {} {}", name, axis.label.empty() ? "''" : format);
}

const char* key_command(KeyPlace place) {
  switch (place) {
    case KeyPlace::none:
      return "unset key";
    case KeyPlace::top_right:
      return "set key inside top right noenhanced";
    case KeyPlace::bottom_left:
      return "set key inside bottom left Left reverse noenhanced";
    case KeyPlace::bottom_right:
      return "set key inside bottom right noenhanced";
    case KeyPlace::above:
      return "set key outside top center horizontal Left reverse noenhanced";
    case KeyPlace::beside:
      break;
  }
  return "set key outside right center vertical Left reverse noenhanced";
}

const char* label_command(LabelPlace place) {
  switch (place) {
    case LabelPlace::right:
      return "left offset character 0.9, 0.4";
    case LabelPlace::above:
      return "center offset character 0, 0.9";
    case LabelPlace::below:
      break;
  }
  return "center offset character 0, -0.9";
}

std::string style_command(SeriesStyle style, std::size_t color) {
  const std::size_t round = color / kPalette.size();  // colours repeat with other marks
  const std::string line = fmt::format("lc rgb '{}' lw 2", kPalette[color % kPalette.size()]);
  const std::string mark = fmt::format("pt {} ps 1.1", kMarks[(color + round) % kMarks.size()]);
  switch (style) {
    case SeriesStyle::line:
      return "lines " + line;
    case SeriesStyle::points:
      return "points " + line + " " + mark;
    case SeriesStyle::line_and_points:
      return "linespoints " + line + " " + mark;
    case SeriesStyle::dashes:
      break;
  }
  return "lines dt 2 " + line;
}

/// Sets up rings and rays instead of axes.
void begin_polar(Script& script, const Axis& radius) {
  script.add("set polar; set angles degrees; set theta bottom cw");
  script.add("unset xlabel; unset ylabel; unset logscale; unset border; unset xtics; unset ytics; unset raxis");
  const double most = radius.most * (1 - 1e-9);  // so that rounding adds no ring
  const double step = round_step(most, 3), rings = std::ceil(most / step);
  script.add("set xrange [-{0}:{0}]; set yrange [-{0}:{0}]; set rrange [0:{0}]", step * rings);
  // Three rings are too close for 10000: it becomes 10k.
  script.add("set rtics scale 0 {}; set format r '{}'", step, rings > 2 && step >= 1000 ? "%.0s%c" : "%g");
  script.add("set grid polar 30 lt 1 lc rgb '#DDDDDD' lw 1");
  std::string tics;
  for (int angle = -150; angle <= 180; angle += 30) {
    if (angle == -90) continue;  // the rings' values are there
    tics += fmt::format("{}'{}°' {}", tics.empty() ? "" : ", ", std::abs(angle), angle);
  }
  script.add("set ttics scale 0 ({}); set size square; set tmargin 3; set bmargin 2", tics);
}

void end_polar(Script& script) {
  script.add("unset polar; unset ttics; unset rtics; set border; set xtics; set ytics; set size nosquare");
  script.add("unset tmargin; unset bmargin");
  script.add("set grid nopolar xtics ytics lt 1 lc rgb '#DDDDDD' lw 1");
}

void add_chart(Script& script, const Chart& chart) {
  // A polar chart's title fits above its rays' labels, clear of the figure's title.
  script.add("set title {} noenhanced offset character 0,{}", in_quotes(chart.is_polar ? chart.y.label : chart.title),
             chart.is_polar ? -0.7 : 0);
  if (chart.is_polar) {
    begin_polar(script, chart.y);
  } else {
    add_axis(script, 'x', chart.x, chart.series);
    add_axis(script, 'y', chart.y, chart.series);
  }
  script.add("{}", key_command(chart.key));
  script.add("unset label");
  std::string plots;
  std::size_t next_color = 0;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    const std::size_t color = series.color < 0 ? next_color++ : std::size_t(series.color);
    if (series.points.empty()) continue;
    script.add("$series{} << END", i);
    for (const PlotPoint& point : series.points) script.add("{} {}", point.x, point.y);
    script.add("END");
    for (const PlotPoint& point : series.points) {
      if (point.label.empty()) continue;
      script.add("set label {} at first {}, first {} {} noenhanced front textcolor rgb '{}'", in_quotes(point.label),
                 point.x, point.y, label_command(point.label_place), kPalette[color % kPalette.size()]);
    }
    plots += fmt::format("{} $series{} using 1:2 {} with {}", plots.empty() ? "plot" : ",", i,
                         series.name.empty() ? "notitle" : "title " + in_quotes(series.name),
                         style_command(series.style, color));
  }
  script.add("{}", plots.empty() ? "set multiplot next" : plots);
  if (chart.is_polar) end_polar(script);
}

std::string script_of(const Figure& figure, FigureFormat format) {
  const int columns = std::max(figure.columns, 1);
  const auto rows = (int(figure.charts.size()) + columns - 1) / columns;
  Script script;
  script.add("set encoding utf8");
  script.add("set terminal {} enhanced size {},{} font 'DejaVu Sans,12' background rgb 'white'",
             format == FigureFormat::png ? "pngcairo" : "svg", figure.width, figure.height);
  script.add("set output");  // standard output
  script.add("set grid lt 1 lc rgb '#DDDDDD' lw 1");
  // The title's second, empty line keeps it clear of the keys above the charts.
  script.add("set multiplot layout {},{} rowsfirst title {}.\"\\n\" noenhanced", rows, columns,
             in_quotes(figure.title));
  for (const Chart& chart : figure.charts) add_chart(script, chart);
  script.add("unset multiplot");
  return script.text();
}

/// Runs gnuplot and returns its standard output. No file name is involved, so that no text can be a command.
std::string run_gnuplot(const std::string& script) {
  // Ignores the user's start-up file. Gnuplot would read standard input byte by byte if it were not named as a file.
  return run_program({"gnuplot", "--default-settings", "/dev/stdin"}, script, "install gnuplot-nox");
}

/// Gnuplot's exit status does not show that the temporary folder is full.
[[noreturn]] void fail_unfinished() { throw OutputError("picture cannot be written: gnuplot did not finish it"); }

}  // namespace

FigureFormat figure_format_of(const std::string& option, const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".png") return FigureFormat::png;
  if (ending == ".svg") return FigureFormat::svg;
  fail_option(option, path, "must end in .png or .svg");
}

void require_plotter() { run_gnuplot("set terminal pngcairo\n"); }

std::string draw_figure(const Figure& figure, FigureFormat format) {
  if (format == FigureFormat::svg) return draw_svg_figures({figure}).front();
  check(figure);
  std::string picture = run_gnuplot(script_of(figure, format));
  if (!picture.ends_with(std::string_view("IEND\xAE\x42\x60\x82", 8))) fail_unfinished();
  return picture;
}

std::vector<std::string> draw_svg_figures(const std::vector<Figure>& figures) {
  std::string script;
  for (const Figure& figure : figures) {
    check(figure);
    script += "reset\n" + script_of(figure, FigureFormat::svg);
  }
  const std::string drawn = run_gnuplot(script);
  constexpr std::string_view kEnd = "</svg>";  // which no text contains: SVG escapes them
  std::vector<std::string> pictures;
  for (std::size_t begin = 0; pictures.size() < figures.size();) {
    const std::size_t end = drawn.find(kEnd, begin);
    if (end == drawn.npos) fail_unfinished();
    const std::size_t next = std::min(drawn.find_first_not_of('\n', end + kEnd.size()), drawn.size());
    pictures.push_back(drawn.substr(begin, next - begin));
    begin = next;
  }
  return pictures;
}

}  // namespace litfog::command
