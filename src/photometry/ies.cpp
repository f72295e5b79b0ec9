// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/ies.h"

#include <utf8.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "photometry/photometric_grid.h"
#include "photometry/text_scanner.h"
#include "text/ascii_text.h"

namespace litfog {
namespace {

using Unit = TextScanner::Unit;
using Piece = TextScanner::Piece;

constexpr double kMetresPerFoot = 0.3048;
constexpr int kNoLabel = 1986;  // the first edition had none

std::string upper(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return result;
}

/// Year of the edition by the first line: "IESNA91", "IESNA:LM-63-1995", "IES:LM-63-2019".
int edition_of(std::string_view first_line) {
  const std::string label = upper(first_line.substr(0, 32));
  if (!label.starts_with("IES")) return kNoLabel;
  if (label.starts_with("IESNA91")) return 1991;
  if (label.starts_with("IESNA86")) return 1986;
  const auto year = label.find("63-");
  if (year == label.npos || label.size() < year + 5) return 2002;
  const std::string_view digits = std::string_view(label).substr(year + 3, 4);
  if (digits.starts_with("86") || digits == "1986") return 1986;
  if (digits.starts_with("91") || digits == "1991") return 1991;
  return 2002;  // 1995, 2002 and 2019 differ in no number that is read here
}

/// The text after "TILT=" on a line, if the line begins with it.
std::optional<std::string_view> tilt_of(std::string_view line) {
  if (!line.starts_with('T') && !line.starts_with('t')) return std::nullopt;  // early exit for almost all lines
  if (upper(line.substr(0, 4)) != "TILT") return std::nullopt;
  const std::string_view rest = trimmed(line.substr(4));
  if (!rest.starts_with('=')) return std::nullopt;
  return trimmed(rest.substr(1));
}

/// The lines before TILT=.
struct Label {
  int edition = kNoLabel;
  std::string first_line;
  /// The keywords of interest. A [MORE] line continues the previous keyword, and so does a repeated keyword.
  std::map<std::string, std::string, std::less<>> keywords{{"LUMINAIRE", ""}, {"LUMCAT", ""}, {"MANUFAC", ""}};
  Piece tilt;  // what follows TILT=
};

/// Fails for a text without a line TILT=, at the first line that has the word elsewhere.
[[noreturn]] void fail_without_tilt(const TextScanner& scanner, const Piece& end) {
  const std::string_view text = scanner.text();
  const std::size_t at = upper(text).find("TILT");
  if (at == text.npos) scanner.fail(end, "TILT", "");
  const std::size_t begin = text.find_last_of("\r\n", at) + 1;  // npos + 1 is 0
  const std::string_view line = trimmed(text.substr(begin, find_line_end(text, begin) - begin));
  scanner.fail({line, std::size_t(line.data() - text.data())}, "line with TILT", "must begin with TILT=");
}

Label read_label(TextScanner& scanner) {
  Label label;
  auto open = label.keywords.end();
  for (bool is_first = true;;) {
    const Piece line = scanner.next(Unit::line);
    if (line.is_missing) fail_without_tilt(scanner, line);
    if (const auto tilt = tilt_of(line.text)) {
      label.tilt = {*tilt, line.offset + std::size_t(tilt->data() - line.text.data())};
      return label;
    }
    if (is_first && !line.text.empty()) {
      is_first = false;
      label.edition = edition_of(line.text);
      label.first_line = line.text;
    }
    const auto end = line.text.find(']');
    if (!line.text.starts_with('[') || end == line.text.npos) continue;
    if (const auto keyword = upper(line.text.substr(1, end - 1)); keyword != "MORE")
      open = label.keywords.find(keyword);
    const std::string_view value = trimmed(line.text.substr(end + 1));
    if (open == label.keywords.end() || value.empty()) continue;
    if (!open->second.empty()) open->second += ' ';
    open->second += value;
  }
}

std::string name_of(const Label& label) {
  for (const char* keyword : {"LUMINAIRE", "LUMCAT"}) {
    if (const auto& name = label.keywords.at(keyword); !name.empty()) return name;
  }
  return label.edition == kNoLabel ? label.first_line : "";
}

LampTilt read_tilt(TextScanner& scanner) {
  PhotometricGrid grid(scanner, Unit::token);
  LampTilt tilt;
  tilt.geometry = scanner.integer(scanner.next(Unit::token), "lamp to luminaire geometry", 1, 3);
  const int count = grid.count("number of tilt angles", 1);
  tilt.angles = radians_from_degrees(grid.angles("tilt angle", count, 0, 180));
  for (int i = 0; i < count; ++i) {
    tilt.factors.push_back(scanner.positive(scanner.next(Unit::token), "tilt factor"));
  }
  return tilt;
}

/// Fails if text follows NONE or INCLUDE on its line.
void expect_word_alone(const TextScanner& scanner, const Piece& tilt) {
  for (const std::string word : {"NONE", "INCLUDE"}) {
    if (!upper(tilt.text.substr(0, word.size())).starts_with(word)) continue;
    const std::string_view rest = tilt.text.substr(word.size());
    const std::string_view text = rest.substr(std::min(rest.find_first_not_of(" \t,;"), rest.size()));
    if (text.empty() || text.size() == rest.size()) continue;
    scanner.fail({text, tilt.offset + std::size_t(text.data() - tilt.text.data())}, "text behind TILT=" + word,
                 "must begin on a line of its own");
  }
}

/// Reads a file's tilt data. Their path must be below the file's folder, so that a file cannot make us read others.
LampTilt read_tilt_file(const TextScanner& scanner, const Label& label) {
  const std::filesystem::path named{std::string(label.tilt.text)};
  const bool leaves = named.is_absolute() || std::ranges::find(named, "..") != named.end();
  if (leaves) scanner.fail(label.tilt, "TILT", "must name a file below this one's folder");
  const auto path = std::filesystem::path(scanner.name()).parent_path() / named;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    expect_word_alone(scanner, label.tilt);
    scanner.fail(label.tilt, "TILT", "must be NONE, INCLUDE or a file in this one's folder");
  }
  TextScanner tilt_scanner(read_photometric_file(path.string()), path.string());
  LampTilt tilt = read_tilt(tilt_scanner);
  tilt.file = path.string();
  return tilt;
}

PhotometryType type_of(int number) {
  return number == 1 ? PhotometryType::c : number == 2 ? PhotometryType::b : PhotometryType::a;
}

}  // namespace

bool is_ies(std::string_view text) {
  if (utf8::starts_with_bom(text)) text.remove_prefix(std::size(utf8::bom));
  const std::string label = upper(text.substr(0, 9));
  if (label.starts_with("IESNA") || label == "IES:LM-63") return true;
  while (!text.empty()) {
    const std::size_t end = find_line_end(text);
    if (tilt_of(trimmed(text.substr(0, end)))) return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

Luminaire parse_ies(std::string text, const std::string& name) {
  TextScanner scanner(std::move(text), name);
  const Label label = read_label(scanner);
  Luminaire luminaire;
  luminaire.file = name;
  luminaire.name = name_of(label);
  luminaire.manufacturer = label.keywords.at("MANUFAC");
  if (const std::string tilt = upper(label.tilt.text); tilt == "INCLUDE") {
    luminaire.tilt = read_tilt(scanner);
  } else if (tilt != "NONE") {
    luminaire.tilt = read_tilt_file(scanner, label);
  }

  const auto token = [&scanner] { return scanner.next(Unit::token); };
  const auto number = [&](std::string_view what) { return scanner.number(token(), what); };
  PhotometricGrid grid(scanner, Unit::token);

  const double lamps = number("number of lamps");
  const double lumens = number("lumens per lamp");
  luminaire.is_absolute = lumens == -1;
  luminaire.lamp_flux = lamp_flux_of(lamps, lumens);
  double factor = scanner.positive(token(), "candela multiplier");
  const int vertical_count = grid.count("number of vertical angles", 2);
  const int horizontal_count = grid.count("number of horizontal angles", 1);
  const auto type = type_of(scanner.integer(token(), "photometric type", 1, 3));
  const double unit = scanner.integer(token(), "units type", 1, 2) == 1 ? kMetresPerFoot : 1;
  luminaire.opening = {unit * number("width"), unit * number("length"), unit * number("height")};
  factor *= scanner.positive(token(), "ballast factor");
  const Piece factor_piece = token();
  if (label.edition < 1995) {
    factor *= scanner.positive(factor_piece, "ballast-lamp photometric factor");
  } else {
    scanner.number(factor_piece, "field after the ballast factor");
  }
  number("input watts");

  const bool is_c = type == PhotometryType::c;
  const AngleLimits limits = limits_of(type);
  const auto vertical = grid.angles("vertical angle", vertical_count, limits.least_vertical, limits.most_vertical);
  auto horizontal = grid.angles("horizontal angle", horizontal_count, limits.least_horizontal, limits.most_horizontal);
  if (is_c && !is_turn(horizontal)) {
    scanner.fail(grid.last(), "last horizontal angle", std::string("must be one of ") + kTurns);
  }
  if (!is_c && horizontal_count == 1) {
    scanner.fail(grid.last(), "horizontal angle", "must not be the only one in types A and B");
  }
  auto intensity = grid.intensities(std::size_t(vertical_count) * std::size_t(horizontal_count), factor);
  luminaire.peak_location = scanner.location(grid.largest());
  scanner.expect_no_more_numbers();
  if (is_c && horizontal.back() - horizontal.front() > 180) close_turn(horizontal, intensity);
  luminaire.distribution = distribution_of_degrees(type, std::move(horizontal), vertical, std::move(intensity));
  return luminaire;
}

}  // namespace litfog
