// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/isocandela.h"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "litfog/photometry/elliptical_beam.h"
#include "model/float_limit.h"
#include "photometry/text_scanner.h"
#include "text/ascii_text.h"

namespace litfog {
namespace {

using Piece = TextScanner::Piece;

constexpr std::string_view kGrid = "vertical_deg";
constexpr std::string_view kEllipses = "candela,horizontal_deg,vertical_deg";
constexpr std::string_view kHeaderRule =
    "must be vertical_deg and the horizontal angles, or candela,horizontal_deg,vertical_deg, with commas between";
constexpr double kRadiansPerDegree = std::numbers::pi / 180;
constexpr std::size_t kMaxCells = 1000;  // a row

/// At most one more than a row may have.
std::vector<Piece> cells_of(const Piece& line) {
  std::vector<Piece> cells;
  for (std::size_t begin = 0; begin <= line.text.size() && cells.size() <= kMaxCells;) {
    const std::size_t end = std::min(line.text.find(',', begin), line.text.size());
    const std::string_view cell = trimmed(line.text.substr(begin, end - begin));
    cells.push_back({cell, line.offset + std::size_t(cell.data() - line.text.data())});
    begin = end + 1;
  }
  return cells;
}

/// A table's lines that are neither blank nor comments, a row each.
class Rows {
 public:
  Rows(std::string text, const std::string& name) : scanner_(std::move(text), name) {}

  /// The next row, of as many cells as the first, or a missing piece alone at the end.
  std::vector<Piece> next() {
    for (Piece line = scanner_.next(TextScanner::Unit::line);; line = scanner_.next(TextScanner::Unit::line)) {
      if (line.is_missing) return {line};
      if (line.text.empty()) continue;
      if (line.text.starts_with('#')) {
        if (name_.empty()) name_ = trimmed(line.text.substr(1));
        continue;
      }
      std::vector<Piece> cells = cells_of(line);
      if (cells.size() > kMaxCells) scanner_.fail(cells[kMaxCells], "cell", "must be one of at most 1000 in a row");
      if (count_ == 0) count_ = cells.size();
      if (cells.size() != count_) {
        throw InputError(scanner_.location(cells.back()), "number of cells", std::to_string(cells.size()),
                         "must be " + std::to_string(count_) + ", as in the header");
      }
      return cells;
    }
  }

  const TextScanner& scanner() const { return scanner_; }
  const std::string& name() const { return name_; }  ///< the light's name

 private:
  TextScanner scanner_;
  std::string name_;
  std::size_t count_ = 0;
};

double angle_deg(const TextScanner& scanner, const Piece& piece, std::string_view what, double limit) {
  const double angle = snapped(scanner.number(piece, what), -limit, limit);
  if (!(angle >= -limit && angle <= limit)) {
    scanner.fail(piece, what, limit == 180 ? "must be in [-180, 180]" : "must be in [-90, 90]");
  }
  return angle;
}

/// The table's lit cell with the most candela.
class Largest {
 public:
  void add(double candela, const Piece& piece) {
    if (candela <= candela_) return;
    candela_ = candela;
    piece_ = piece;
  }
  /// Fails at a piece if all are dark.
  InputLocation location(const TextScanner& scanner, const Piece& last) const {
    if (candela_ == 0) scanner.fail(last, "candela", "must not be 0 as all others are");
    return scanner.location(piece_);
  }

 private:
  double candela_ = 0;
  Piece piece_{};
};

double candela_of(const TextScanner& scanner, const Piece& piece) {
  const double candela = snapped(scanner.number(piece, "candela"), 0, kMaxIntensity);
  if (!(candela >= 0 && candela <= kMaxIntensity)) scanner.fail(piece, "candela", "must be in [0, 1e30]");
  return candela;
}

struct GridRow {
  double vertical;  // radians
  std::vector<double> candela;
};

/// Whether an angle goes on from those before it the way they went.
bool goes_on(const std::vector<GridRow>& table, double vertical) {
  if (table.empty()) return true;
  const double last = table.back().vertical;
  if (table.size() == 1) return vertical != last;
  return table[1].vertical > table[0].vertical ? vertical > last : vertical < last;
}

std::vector<GridRow> parse_grid_rows(Rows& rows, Luminaire& luminaire) {
  const TextScanner& scanner = rows.scanner();
  std::vector<GridRow> table;
  Largest largest;
  Piece last{};
  for (auto cells = rows.next();; cells = rows.next()) {
    if (cells.front().is_missing) {
      if (table.size() < 2) scanner.fail(cells.front(), "second row of candela", "");
      break;
    }
    const double vertical = angle_deg(scanner, cells[0], "vertical angle", 90) * kRadiansPerDegree;
    if (!goes_on(table, vertical)) {
      scanner.fail(cells[0], "vertical angle", "must rise from row to row, or fall from row to row");
    }
    GridRow& row = table.emplace_back(GridRow{vertical, {}});
    for (std::size_t i = 1; i < cells.size(); ++i) {
      row.candela.push_back(candela_of(scanner, cells[i]));
      largest.add(row.candela.back(), cells[i]);
    }
    last = cells.back();
  }
  luminaire.peak_location = largest.location(scanner, last);
  if (table[1].vertical < table[0].vertical) std::ranges::reverse(table);
  return table;
}

void parse_grid(Rows& rows, const std::vector<Piece>& header, Luminaire& luminaire) {
  const TextScanner& scanner = rows.scanner();
  IntensityDistribution& grid = luminaire.distribution;
  grid.type = PhotometryType::a;
  if (header.size() < 3) scanner.fail(header.back(), "header", "must have at least two horizontal angles");
  for (std::size_t i = 1; i < header.size(); ++i) {
    const double angle = angle_deg(scanner, header[i], "horizontal angle", 180) * kRadiansPerDegree;
    if (i > 1 && !(angle > grid.horizontal.back())) {
      scanner.fail(header[i], "horizontal angle", "must be greater than the one before");
    }
    grid.horizontal.push_back(angle);
  }
  const std::vector<GridRow> table = parse_grid_rows(rows, luminaire);
  for (const GridRow& row : table) grid.vertical.push_back(row.vertical);
  for (std::size_t h = 0; h < grid.horizontal.size(); ++h) {
    for (const GridRow& row : table) grid.intensity.push_back(row.candela[h]);
  }
}

double half_axis(const TextScanner& scanner, const Piece& piece, std::string_view what) {
  const double angle = snapped(scanner.number(piece, what), 0, 180);
  if (!(angle > 0 && angle <= 180)) scanner.fail(piece, what, "must be in (0, 180]");
  return std::min(angle * kRadiansPerDegree, std::numbers::pi);
}

void parse_ellipses(Rows& rows, Luminaire& luminaire) {
  constexpr std::string_view kHorizontal = "horizontal half axis", kVertical = "vertical half axis";
  const TextScanner& scanner = rows.scanner();
  std::vector<IsocandelaEllipse> ellipses;
  for (auto cells = rows.next();; cells = rows.next()) {
    if (cells.front().is_missing) {
      if (ellipses.empty()) scanner.fail(cells.front(), "row of an ellipse", "");
      break;
    }
    if (ellipses.empty()) luminaire.peak_location = scanner.location(cells[0]);
    ellipses.push_back({.intensity = candela_of(scanner, cells[0]),
                        .horizontal = half_axis(scanner, cells[1], kHorizontal),
                        .vertical = half_axis(scanner, cells[2], kVertical)});
    const auto error = find_error(ellipses);
    if (!error) continue;
    const std::string_view field = error->field;
    if (field == "horizontal") scanner.fail(cells[1], kHorizontal, "must be greater than in the row before");
    if (field == "vertical") scanner.fail(cells[2], kVertical, "must be greater than in the row before");
    scanner.fail(cells[0], "candela", ellipses.size() == 1 ? "must be > 0" : "must be at most that of the row before");
  }
  luminaire.distribution = elliptical_beam(ellipses);
}

/// The first line that is neither blank nor a comment.
std::string_view header_of(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, find_line_end(text));
    if (line.find_first_not_of(" \t") != line.npos && !line.starts_with('#')) return line;
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return {};
}

}  // namespace

bool is_isocandela(std::string_view text) {
  const std::string_view header = header_of(text);
  return header.starts_with(kGrid) || header.starts_with("candela,");
}

Luminaire parse_isocandela(std::string text, const std::string& name) {
  Rows rows(std::move(text), name);
  Luminaire luminaire;
  luminaire.file = name;
  luminaire.is_absolute = true;
  luminaire.is_isocandela = true;
  const std::vector<Piece> header = rows.next();
  std::string names;
  for (const Piece& cell : header) names += (names.empty() ? "" : ",") + std::string(cell.text);
  if (header.front().text == kGrid) {
    parse_grid(rows, header, luminaire);
  } else if (names == kEllipses) {
    parse_ellipses(rows, luminaire);
  } else {
    const std::string_view last = header.back().text;
    const std::size_t length = header.back().offset + last.size() - header.front().offset;
    rows.scanner().fail({{header.front().text.data(), length}, header.front().offset}, "header", kHeaderRule);
  }
  luminaire.name = rows.name();
  return luminaire;
}

}  // namespace litfog
