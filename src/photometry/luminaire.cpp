// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/luminaire.h"

#include <algorithm>
#include <filesystem>

#include "litfog/photometry/eulumdat.h"
#include "litfog/photometry/ies.h"
#include "litfog/photometry/isocandela.h"
#include "text_scanner.h"

namespace litfog {
namespace {

bool is_named(const std::string& path, std::string_view wanted) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return ending == wanted;
}

}  // namespace

std::optional<double> stated_flux(const Luminaire& luminaire) {
  if (!luminaire.lamp_flux || !luminaire.light_output_ratio) return std::nullopt;
  return *luminaire.lamp_flux * *luminaire.light_output_ratio;
}

Luminaire read_luminaire(const std::string& path) {
  std::string text = read_photometric_file(path);
  if (is_isocandela(text) || is_named(path, ".csv")) return parse_isocandela(std::move(text), path);
  return is_ies(text) || is_named(path, ".ies") ? parse_ies(std::move(text), path)
                                                : parse_eulumdat(std::move(text), path);
}

}  // namespace litfog
