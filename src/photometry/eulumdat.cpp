// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/eulumdat.h"

#include <algorithm>

#include "photometry/photometric_grid.h"
#include "photometry/text_scanner.h"
#include "text/ascii_text.h"

namespace litfog {
namespace {

using Unit = TextScanner::Unit;
using Piece = TextScanner::Piece;

constexpr double kMetresPerMillimetre = 1e-3;
constexpr double kPercent = 1e-2;
constexpr double kKilolumen = 1e3;

/// Symmetry indicator Isym.
enum Symmetry { kNone = 0, kRound = 1, kAboutC0 = 2, kAboutC90 = 3, kAboutBoth = 4 };

/// The planes of the file's list whose intensities follow, in their order.
struct StoredPlanes {
  std::vector<double> angles;  // degrees; negative where they run through C270 to C0
  std::string_view rule;       // why the list does not fit the symmetry, or empty
};

StoredPlanes stored_planes(const std::vector<double>& listed, Symmetry symmetry) {
  const std::size_t count = listed.size(), half = count / 2, quarter = count / 4;
  switch (symmetry) {
    case kNone:
      if (count > 1 && !is_closed_turn(listed)) return {{}, "must be one of planes all round for Isym 0"};
      return {listed, ""};
    case kRound:
      return {{listed.front()}, ""};
    case kAboutC0:
      if (count % 2 != 0 || listed[0] != 0 || listed[half] != 180) break;
      return {{listed.begin(), listed.begin() + std::ptrdiff_t(half + 1)}, ""};
    case kAboutC90: {
      if (count % 4 != 0 || listed[0] != 0 || listed[quarter] != 90 || listed[count - quarter] != 270 ||
          listed.back() == 360) {
        break;
      }
      std::vector<double> angles(listed.end() - std::ptrdiff_t(quarter), listed.end());
      for (double& angle : angles) angle -= 360;
      angles.insert(angles.end(), listed.begin(), listed.begin() + std::ptrdiff_t(quarter + 1));
      return {angles, ""};
    }
    case kAboutBoth:
      if (count % 4 != 0 || listed[0] != 0 || listed[quarter] != 90) break;
      return {{listed.begin(), listed.begin() + std::ptrdiff_t(quarter + 1)}, ""};
  }
  return {{}, "must be one of planes all round that hold those of symmetry, as many on each side of them"};
}

}  // namespace

bool is_eulumdat(std::string_view text) {
  const auto next_line = [&text] {
    const std::size_t end = find_line_end(text);
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
    return line;
  };
  next_line();  // the company
  const auto is_digit = [](std::string_view line, char most) {
    const auto digit = line.find_first_not_of(" \t");
    return digit != line.npos && line[digit] >= '0' && line[digit] <= most &&
           line.find_first_not_of(" \t.,0", digit + 1) == line.npos;
  };
  return is_digit(next_line(), '3') && is_digit(next_line(), '4');
}

Luminaire parse_eulumdat(std::string text, const std::string& name) {
  TextScanner scanner(std::move(text), name);
  PhotometricGrid grid(scanner, Unit::line);
  const auto line = [&](std::string_view what) {
    const Piece piece = scanner.next(Unit::line);
    if (piece.is_missing) scanner.fail(piece, what, "");
    return piece;
  };
  const auto integer = [&](std::string_view what, int low, int high) {
    return scanner.integer(line(what), what, low, high);
  };
  const auto number_or_blank = [&](std::string_view what) {
    const Piece piece = line(what);
    return piece.text.empty() ? 0 : scanner.number(piece, what);
  };

  Luminaire luminaire;
  luminaire.file = name;
  luminaire.manufacturer = line("company").text;
  integer("type indicator Ityp", 0, 3);
  const auto symmetry = Symmetry(integer("symmetry indicator Isym", 0, 4));
  const int plane_count = grid.count("number of C planes Mc", 1);
  number_or_blank("distance of C planes Dc");
  const int gamma_count = grid.count("number of gamma angles Ng", 2);
  number_or_blank("distance of gamma angles Dg");
  line("report number");
  luminaire.name = line("luminaire name").text;
  for (const char* text_line : {"luminaire number", "file name", "date and user"}) line(text_line);
  for (const char* size : {"length", "width", "height"}) number_or_blank(size);
  const double length = kMetresPerMillimetre * number_or_blank("length of the luminous area");
  const double width = kMetresPerMillimetre * number_or_blank("width of the luminous area");
  luminaire.opening = width == 0 ? LuminousOpening{-length, -length, 0} : LuminousOpening{width, length, 0};
  for (const char* plane : {"C0", "C90", "C180", "C270"}) {
    const double height = number_or_blank(std::string("height of the luminous area in ") + plane);
    luminaire.opening.height = std::max(luminaire.opening.height, kMetresPerMillimetre * height);
  }
  number_or_blank("downward flux fraction");
  const double ratio = number_or_blank("light output ratio");
  if (ratio > 0) luminaire.light_output_ratio = kPercent * ratio;
  double factor = scanner.positive(line("conversion factor"), "conversion factor");
  number_or_blank("tilt during measurement");

  const int lamp_sets = integer("number of lamp sets", 1, 100);
  luminaire.is_absolute = number_or_blank("number of lamps") < 0;
  line("type of lamps");
  luminaire.lamp_flux = scanner.positive(line("flux of lamps"), "flux of lamps");
  factor *= *luminaire.lamp_flux / kKilolumen;
  constexpr int kLinesOfLampSet = 6;
  for (int left = kLinesOfLampSet * lamp_sets - 3; left > 0; --left) line("lamp set");
  for (int room = 0; room < 10; ++room) number_or_blank("direct ratio");

  const AngleLimits limits = limits_of(PhotometryType::c);
  const auto planes =
      stored_planes(grid.angles("C plane", plane_count, limits.least_horizontal, limits.most_horizontal), symmetry);
  if (planes.angles.empty()) scanner.fail(grid.last(), "last C plane", planes.rule);
  const auto gamma = grid.angles("gamma angle", gamma_count, limits.least_vertical, limits.most_vertical);
  auto horizontal = planes.angles;
  auto intensity = grid.intensities(horizontal.size() * gamma.size(), factor);
  luminaire.peak_location = scanner.location(grid.largest());
  scanner.expect_no_more_numbers();
  if (symmetry == kNone && horizontal.size() > 1) close_turn(horizontal, intensity);
  luminaire.distribution =
      distribution_of_degrees(PhotometryType::c, std::move(horizontal), gamma, std::move(intensity));
  return luminaire;
}

}  // namespace litfog
