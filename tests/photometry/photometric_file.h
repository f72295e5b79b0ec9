// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

#include "litfog/input_error.h"
#include "litfog/photometry/luminaire.h"
#include "reference/random_light.h"

namespace litfog::test {

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/// A file of our own making.
inline Luminaire our_luminaire(const std::string& name) {
  return read_luminaire(std::string(LITFOG_PHOTOMETRY_DIR) + "/" + name);
}

/// What is wrong with a photometric text or file, "line:column: sentence", without the file's name.
inline std::string photometry_error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return std::string(error.what()).substr(error.location().file.size() + 1);
  }
  return "(accepted)";
}

/// Text that is read gives a sound distribution; text that is not is an error at a location within it. Whatever else
/// happens fails the test, or the sanitizer.
template <typename Parse>
void expect_read_or_fail(const std::string& text, const Parse& parse) {
  try {
    const Luminaire luminaire = parse(text);
    EXPECT_FALSE(find_error(luminaire.distribution)) << text;
    EXPECT_TRUE(std::isfinite(luminous_flux(luminaire.distribution))) << text;
  } catch (const InputError& error) {
    const auto& [file, line, column] = error.location();
    const auto lines = std::size_t(std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; })) + 1;
    EXPECT_TRUE(line >= 1 && line <= lines && column >= 1) << error.what() << "\n" << text;
    EXPECT_NE(std::string(error.what()).find(": must "), std::string::npos) << error.what();
  }
}

/// Both shine alike in every direction.
inline void expect_same_beam(const Luminaire& a, const Luminaire& b) {
  Random random(17);
  const double peak = find_peak(a.distribution).intensity;
  for (int i = 0; i < 3000; ++i) {
    const double z = random.uniform(-1, 1), turn = random.uniform(0, 6.283);
    const double side = std::sqrt(1 - z * z);
    const glm::dvec3 direction{side * std::cos(turn), side * std::sin(turn), z};
    EXPECT_NEAR(intensity_at(a.distribution, direction), intensity_at(b.distribution, direction), 1e-9 * peak);
  }
  const double flux = luminous_flux(a.distribution);
  EXPECT_NEAR(luminous_flux(b.distribution), flux, 1e-9 * flux);
}

}  // namespace litfog::test
