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

/// Every truncation, and thousands of random edits of one to four bytes: changed, dropped, doubled or made a token that
/// parsers trip over.
template <typename Parse>
void expect_mutations_read_or_fail(const std::string& text, int edits, std::uint64_t seed, const Parse& parse) {
  for (std::size_t size = 0; size < text.size(); ++size) expect_read_or_fail(text.substr(0, size), parse);
  Random random(seed);
  const std::vector<std::string> tokens{"-1",  "2147483648", "4294967297", "1e999", "1e-999", "nan",
                                        "inf", "0x10",       "",           "-0.",   "\xFF",   "\r",
                                        "\n",  ",",          "-",          "+",     "1e30",   "TILT="};
  for (int i = 0; i < edits; ++i) {
    std::string mutated = text;
    for (int left = 1 + int(random.uniform(0, 4)); left > 0 && !mutated.empty(); --left) {
      const auto at = std::size_t(random.uniform(0, double(mutated.size())));
      const auto length = std::size_t(random.uniform(0, 4));
      if (random.chance(0.3)) {
        mutated[at] = char(random.below(256));
      } else if (random.chance(0.3)) {
        mutated.erase(at, length);
      } else if (random.chance(0.3)) {
        mutated.insert(at, mutated.substr(at, length));
      } else {
        mutated.replace(at, length, random.pick(tokens));
      }
    }
    expect_read_or_fail(mutated, parse);
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
