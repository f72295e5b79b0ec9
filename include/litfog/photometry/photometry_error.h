// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace litfog {

/// Thrown for a photometric file that cannot be used. what() is the sentence without its place, "what = value: rule".
struct PhotometryError : std::runtime_error {
  PhotometryError(std::string the_file, std::size_t the_line, std::size_t the_column, const std::string& sentence)
      : std::runtime_error(sentence), file(std::move(the_file)), line(the_line), column(the_column) {}

  std::string file;    ///< as given by the caller, or the file with tilt data that it names
  std::size_t line;    ///< from 1; 0 where the file as a whole is refused: it cannot be read, or it is too large
  std::size_t column;  ///< from 1, in code points; a byte order mark is none
};

}  // namespace litfog
