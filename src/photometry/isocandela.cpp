// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/isocandela.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "litfog/input_error.h"
#include "litfog/photometry/elliptical_beam.h"
#include "model/float_limit.h"
#include "photometry/text_encoding.h"
#include "photometry/text_scanner.h"
#include "text/ascii_text.h"
#include "text/csv.h"

namespace litfog {
namespace {

constexpr std::string_view kGrid = "vertical_deg";
constexpr std::string_view kEllipses = "candela,horizontal_deg,vertical_deg";
constexpr std::string_view kHeaderRule =
    "must be vertical_deg and the horizontal angles, or candela,horizontal_deg,vertical_deg, with commas or semicolons "
    "between";
constexpr std::string_view kPointRule =
    "must have no point, which may be between thousands; after a decimal point, write more or fewer than three digits";
constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr std::size_t kMaxCells = 1000;  // per row
constexpr std::size_t kMaxEllipses = 1000;

/// Whether a line is blank, or only separators (from spreadsheets), or a comment, which spreadsheets may quote.
bool is_passed_over(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r,;");
  return first == line.npos || line.substr(first).starts_with('#') || line.substr(first).starts_with("\"#");
}

/// Visits the lines that are not passed over.
///
/// use  takes a line, and returns whether it wants another
template <typename Use>
void for_each_line(std::string_view text, const Use& use) {
  for (bool goes_on = true; goes_on && !text.empty();) {
    const std::string_view line = text.substr(0, find_line_end(text));
    if (!is_passed_over(line)) goes_on = use(line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
}

/// The first line that is not passed over.
std::string_view header_line(std::string_view text) {
  std::string_view header;
  for_each_line(text, [&header](std::string_view line) {
    header = line;
    return false;
  });
  return header;
}

/// The header line without quotes.
std::string header_of(std::string_view text) {
  std::string header(header_line(text));
  std::erase(header, '"');
  return header;
}

/// "1.200" and "-1.234.567", but not "1.25" or "0.125": points that may stand between thousands.
bool may_have_thousands(std::string_view number) {
  constexpr std::string_view kDigits = "0123456789";
  number.remove_prefix(std::min(number.find_first_of("123456789"), number.size()));
  const std::size_t point = std::min(number.find_first_not_of(kDigits), number.size());
  if (point < 1 || point > 3 || point == number.size()) return false;
  number.remove_prefix(point);
  while (number.starts_with('.') && std::min(number.find_first_not_of(kDigits, 1), number.size()) == 4) {
    number.remove_prefix(4);
  }
  return number.empty();
}

/// Whether the points in a table with semicolons are decimal: one cannot stand between thousands, and there is no
/// comma.
bool has_decimal_points(std::string_view text) {
  bool has_comma = false, has_decimal = false;
  for_each_line(text, [&](std::string_view line) {
    has_comma = line.find(',') != line.npos;
    for (std::size_t begin = 0; begin < line.size() && !has_decimal;) {
      const std::size_t end = std::min(line.find_first_of(";\"", begin), line.size());
      const std::string_view cell = trimmed(line.substr(begin, end - begin));
      has_decimal = cell.find('.') != cell.npos && !may_have_thousands(cell);
      begin = end + 1;
    }
    return !has_comma;
  });
  return has_decimal && !has_comma;
}

struct Cell {
  std::string text;
  InputLocation location;
  bool is_missing = false;  ///< the file ended before it
};

[[noreturn]] void fail(const Cell& cell, std::string_view what, std::string_view rule) {
  fail_at(cell.location, what, cell.text, cell.is_missing, rule);
}

/// UTF-8 whose lines end in LF or CR LF.
std::string lines_of(std::string bytes) {
  std::string text = utf8_from_bytes(std::move(bytes));
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && text.compare(i, 2, "\r\n") != 0) text[i] = '\n';
  }
  return text;
}

/// A table's rows: its lines that are neither blank nor comments.
class Rows {
 public:
  Rows(std::string bytes, const std::string& name)
      : text_(lines_of(std::move(bytes))),
        header_(trimmed(header_line(text_))),
        separator_(header_.find(';') == std::string::npos ? ',' : ';'),
        has_decimal_points_(separator_ == ',' || has_decimal_points(text_)),
        file_(fmemopen(text_.data(), text_.size(), "r"), std::fclose),
        reader_(file_.get(), name, separator_) {}

  /// The next row, with as many cells as the first, or a single missing cell at the end.
  std::vector<Cell> next() {
    while (reader_.read(record_)) {
      if (record_.error() != nullptr) {
        const std::string error = record_.error();  // "quote must be closed on its line"
        const std::size_t rule = error.find("must");
        throw InputError(located(record_.error_location()), error.substr(0, rule - 1), "", error.substr(rule));
      }
      const std::string_view line = record_.raw(record_.size());
      if (is_passed_over(line)) {
        note_comment(line);
        continue;
      }
      std::vector<Cell> cells;
      for (std::size_t i = 0; i < std::min(record_.size(), kMaxCells + 1); ++i) {
        const std::string_view field = record_.field(i), text = trimmed(field);
        cells.push_back({std::string(text), located(record_.location(i))});
        cells.back().location.column += text.empty() ? 0 : std::size_t(text.data() - field.data());
      }
      if (cells.size() > kMaxCells) fail(cells[kMaxCells], "cell", "must be one of at most 1000 in a row");
      if (count_ == 0) count_ = cells.size();
      if (cells.size() == count_) return cells;
      throw InputError(cells.back().location, "number of cells", std::to_string(cells.size()),
                       "must be " + std::to_string(count_) + ", as in the header");
    }
    return {{"", located(reader_.location()), true}};
  }

  double number(const Cell& cell, std::string_view what) const {
    const bool has_comma = cell.text.find(',') != std::string::npos;
    if (separator_ == ',' && has_comma) {
      fail(cell, what, "must have a decimal point where commas are between cells");
    }
    if (!has_decimal_points_ && may_have_thousands(cell.text.substr(0, cell.text.find(',')))) {
      fail(cell, what, kPointRule);
    }
    const auto number = TextScanner::number_if_any({cell.text, 0});
    if (!number) fail(cell, what, "must be a finite number");
    return *number;
  }

  const std::string& name() const { return name_; }      ///< the light's name
  const std::string& header() const { return header_; }  ///< as written

 private:
  InputLocation located(CsvLocation location) const {
    return {reader_.name(), std::size_t(location.line), std::size_t(location.column)};
  }
  void note_comment(std::string_view line) {
    line = trimmed(line.substr(0, line.find_last_not_of(std::string(" \t\"") + separator_) + 1));
    const std::size_t begin = line.find('#');
    if (name_.empty() && begin != line.npos) name_ = trimmed(line.substr(begin + 1));
  }

  std::string text_;
  std::string header_;
  char separator_;
  bool has_decimal_points_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  CsvReader reader_;
  CsvRecord record_;
  std::string name_;
  std::size_t count_ = 0;
};

double angle_deg(const Rows& rows, const Cell& cell, std::string_view what, double limit) {
  const double angle = snapped(rows.number(cell, what), -limit, limit);
  if (!(angle >= -limit && angle <= limit)) {
    fail(cell, what, limit == 180 ? "must be in [-180, 180]" : "must be in [-90, 90]");
  }
  return angle;
}

/// The table's lit cell with the most candela.
class Largest {
 public:
  void add(double candela, const Cell& cell) {
    if (candela <= candela_) return;
    candela_ = candela;
    location_ = cell.location;
  }
  /// Where the largest is. Fails at the last cell if all are dark.
  InputLocation location(const Cell& last) const {
    if (candela_ == 0) fail(last, "candela", "must not be 0 as all others are");
    return location_;
  }

 private:
  double candela_ = 0;
  InputLocation location_;
};

double candela_of(const Rows& rows, const Cell& cell) {
  const double candela = snapped(rows.number(cell, "candela"), 0, kMaxIntensity);
  if (!(candela >= 0 && candela <= kMaxIntensity)) fail(cell, "candela", "must be in [0, 1e30]");
  return candela;
}

struct GridRow {
  double vertical;  // radians
  std::vector<double> candela;
};

/// Whether an angle continues the direction of the angles before it.
bool goes_on(const std::vector<GridRow>& table, double vertical) {
  if (table.empty()) return true;
  const double last = table.back().vertical;
  if (table.size() == 1) return vertical != last;
  return table[1].vertical > table[0].vertical ? vertical > last : vertical < last;
}

std::vector<GridRow> parse_grid_rows(Rows& rows, Luminaire& luminaire) {
  std::vector<GridRow> table;
  Largest largest;
  Cell last;
  for (auto cells = rows.next();; cells = rows.next()) {
    if (cells.front().is_missing) {
      if (table.size() < 2) fail(cells.front(), "second row of candela", "");
      break;
    }
    const double vertical = angle_deg(rows, cells[0], "vertical angle", 90) * kRadiansPerDegree;
    if (!goes_on(table, vertical)) {
      fail(cells[0], "vertical angle", "must rise from row to row, or fall from row to row");
    }
    GridRow& row = table.emplace_back(GridRow{vertical, {}});
    for (std::size_t i = 1; i < cells.size(); ++i) {
      row.candela.push_back(candela_of(rows, cells[i]));
      largest.add(row.candela.back(), cells[i]);
    }
    last = cells.back();
  }
  luminaire.peak_location = largest.location(last);
  if (table[1].vertical < table[0].vertical) std::ranges::reverse(table);
  return table;
}

void parse_grid(Rows& rows, const std::vector<Cell>& header, Luminaire& luminaire) {
  IntensityDistribution& grid = luminaire.distribution;
  grid.type = PhotometryType::a;
  if (header.size() < 3) fail(header.back(), "header", "must have at least two horizontal angles");
  for (std::size_t i = 1; i < header.size(); ++i) {
    const double angle = angle_deg(rows, header[i], "horizontal angle", 180) * kRadiansPerDegree;
    if (i > 1 && !(angle > grid.horizontal.back())) {
      fail(header[i], "horizontal angle", "must be greater than the one before");
    }
    grid.horizontal.push_back(angle);
  }
  const std::vector<GridRow> table = parse_grid_rows(rows, luminaire);
  for (const GridRow& row : table) grid.vertical.push_back(row.vertical);
  for (std::size_t h = 0; h < grid.horizontal.size(); ++h) {
    for (const GridRow& row : table) grid.intensity.push_back(row.candela[h]);
  }
}

double half_axis(const Rows& rows, const Cell& cell, std::string_view what) {
  constexpr double kLeast = 1e-4;
  const double angle = snapped(rows.number(cell, what), kLeast, 180);
  if (!(angle >= kLeast && angle <= 180)) fail(cell, what, "must be in [1e-4, 180]");
  return std::min(angle * kRadiansPerDegree, std::numbers::pi);
}

void parse_ellipses(Rows& rows, Luminaire& luminaire) {
  constexpr std::string_view kHorizontal = "horizontal half axis", kVertical = "vertical half axis";
  std::vector<IsocandelaEllipse> ellipses;
  for (auto cells = rows.next();; cells = rows.next()) {
    if (cells.front().is_missing) {
      if (ellipses.empty()) fail(cells.front(), "row of an ellipse", "");
      break;
    }
    if (ellipses.size() == kMaxEllipses) fail(cells[0], "candela", "must not begin another ellipse after 1000");
    if (ellipses.empty()) luminaire.peak_location = cells[0].location;
    ellipses.push_back({.intensity = candela_of(rows, cells[0]),
                        .horizontal = half_axis(rows, cells[1], kHorizontal),
                        .vertical = half_axis(rows, cells[2], kVertical)});
    const auto error = find_error(ellipses);
    if (!error) continue;
    const std::string_view field = error->field;
    if (field == "horizontal") fail(cells[1], kHorizontal, "must be greater than in the row before");
    if (field == "vertical") fail(cells[2], kVertical, "must be greater than in the row before");
    fail(cells[0], "candela", ellipses.size() == 1 ? "must be > 0" : "must be at most that of the row before");
  }
  luminaire.distribution = elliptical_beam(ellipses);
}

}  // namespace

bool is_isocandela(std::string_view text) {
  const std::string header = header_of(text);
  return header.starts_with(kGrid) || header.starts_with("candela,") || header.starts_with("candela;");
}

Luminaire parse_isocandela(std::string text, const std::string& name) {
  Rows rows(std::move(text), name);
  Luminaire luminaire;
  luminaire.file = name;
  luminaire.is_absolute = true;
  luminaire.is_isocandela = true;
  const std::vector<Cell> header = rows.next();
  std::string names;
  for (const Cell& cell : header) names += (names.empty() ? "" : ",") + cell.text;
  if (header.front().text == kGrid) {
    parse_grid(rows, header, luminaire);
  } else if (names == kEllipses) {
    parse_ellipses(rows, luminaire);
  } else {
    const bool is_of_range = lower(rows.header()).find("lx") != std::string::npos ||
                             lower(rows.header()).find("illuminance") != std::string::npos;
    fail({rows.header(), header.front().location}, "header",
         std::string(kHeaderRule) + (is_of_range ? "; a table of illuminance belongs in a light spec, "
                                                   "as its range's illuminance"
                                                 : ""));
  }
  luminaire.name = rows.name();
  return luminaire;
}

}  // namespace litfog
