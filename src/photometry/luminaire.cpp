// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/luminaire.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include "litfog/photometry/eulumdat.h"
#include "litfog/photometry/gldf.h"
#include "litfog/photometry/ies.h"
#include "litfog/photometry/isocandela.h"
#include "litfog/photometry/tm33.h"
#include "model/float_limit.h"
#include "model/require.h"
#include "photometry/gldf_archive.h"
#include "photometry/luminaire_text.h"
#include "photometry/text_encoding.h"
#include "photometry/text_scanner.h"
#include "text/ascii_text.h"

namespace litfog {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kZip = "PK\x03\x04";

std::string ending_of(const fs::path& path) { return lower(path.extension().string()); }

/// Plain text of no known kind counts as what its ending says, for a better error.
bool is_named(const std::string& path, const char* ending, std::string_view text) {
  return ending_of(path) == ending && !text.starts_with('<') && text.find('\0') == text.npos;
}

struct PlainFormat {
  const char* ending;
  bool (*is_of_it)(std::string_view text);
  Luminaire (*parse)(std::string text, const std::string& name);
};
constexpr PlainFormat kPlainFormats[] = {
    {".ies", is_ies, parse_ies}, {".csv", is_isocandela, parse_isocandela}, {".ldt", is_eulumdat, parse_eulumdat}};

/// A container's only photometric file.
const std::string& single_file_of(const GldfContainer& container, const std::string& path) {
  const std::vector<std::string>& files = container.files();
  if (files.size() == 1) return files.front();
  constexpr std::size_t kMaxNamed = 8;
  std::string rule = "must be named where there are several:";
  for (std::size_t i = 0; i < std::min(files.size(), kMaxNamed); ++i) rule += " " + files[i];
  if (files.size() > kMaxNamed) rule += " and " + std::to_string(files.size() - kMaxNamed) + " more";
  throw InputError({.file = path}, "photometric file", "", rule);
}

/// The container that a path of list_gldf() leads into; nothing for other paths.
std::optional<std::string> gldf_of(const std::string& path) {
  std::error_code error;
  for (fs::path container = fs::path(path).parent_path(); container.has_relative_path();
       container = container.parent_path()) {
    if (ending_of(container) == ".gldf" && fs::is_regular_file(container, error)) return container.string();
  }
  return std::nullopt;
}

}  // namespace

Luminaire parse_luminaire(std::string bytes, const std::string& path) {
  std::string text = utf8_from_bytes(std::move(bytes));
  if (trimmed(text).empty()) throw InputError({.file = path}, "is empty");
  if (is_tm33(text)) return parse_tm33(std::move(text), path);
  for (const PlainFormat& format : kPlainFormats) {
    if (format.is_of_it(text)) return format.parse(std::move(text), path);
  }
  for (const PlainFormat& format : kPlainFormats) {
    if (is_named(path, format.ending, text)) return format.parse(std::move(text), path);
  }
  throw InputError({.file = path}, "not a photometric file", "",
                   "must be of IES LM-63 (with a line TILT=), EULUMDAT, TM-33 or GLDF, or an isocandela table");
}

std::optional<double> stated_flux(const Luminaire& luminaire) {
  if (!luminaire.lamp_flux || !luminaire.light_output_ratio) return std::nullopt;
  return *luminaire.lamp_flux * *luminaire.light_output_ratio;
}

double opening_radius(const LuminousOpening& opening) {
  double first = opening.width, second = opening.length;
  if (first == 0) std::swap(first, second);
  if (second == 0) second = first < 0 && opening.height >= 0 ? first : opening.height;
  const bool is_round = first < 0 && second < 0;
  const double radius =
      std::sqrt(std::abs(first)) * std::sqrt(std::abs(second)) / (is_round ? 2 : std::sqrt(std::numbers::pi));
  return radius < kMinOpeningRadius ? 0 : radius;
}

double tilt_factor(const LampTilt& tilt, double angle) {
  if (!is_within(angle, 0, std::numbers::pi)) require(ValueError{"angle", angle, "must be in [0, pi]"});
  const auto above = std::ranges::lower_bound(tilt.angles, angle);
  if (above == tilt.angles.begin()) return tilt.factors.front();
  if (above == tilt.angles.end()) return tilt.factors.back();
  const auto high = std::size_t(above - tilt.angles.begin());
  const double fraction = (angle - tilt.angles[high - 1]) / (*above - tilt.angles[high - 1]);
  return std::lerp(tilt.factors[high - 1], tilt.factors[high], fraction);
}

Luminaire read_luminaire(const std::string& path) {
  if (const auto gldf = gldf_of(path)) {
    return parse_luminaire(GldfArchive(*gldf).read(path.substr(gldf->size() + 1)), path);
  }
  std::string bytes = read_photometric_file(path);
  if (!bytes.starts_with(kZip)) return parse_luminaire(std::move(bytes), path);
  const GldfContainer container(path);
  return container.read(single_file_of(container, path));
}

}  // namespace litfog
