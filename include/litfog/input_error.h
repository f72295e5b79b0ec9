// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "litfog/value_error.h"

namespace litfog {

/// A location in a text file.
struct InputLocation {
  std::string file;        ///< path as the caller gave it
  std::size_t line = 0;    ///< from 1; 0: the file as a whole
  std::size_t column = 0;  ///< from 1, in code points; 0: the line as a whole
};

/// "file:line:column"; numbers that are 0 are left out.
std::string to_string(const InputLocation& location);

/// Thrown for a file that cannot be used. what() is the whole sentence: "lamps.json:7:12: threshold = 7: must be in (0,
/// 1)". It quotes names and values from the file unchanged: escape control characters before sending it to a terminal.
class InputError : public std::runtime_error {
 public:
  /// "location: message"
  InputError(InputLocation location, std::string_view message);
  /// "location: what = value: rule"; an empty value is left out, with its " = ".
  InputError(InputLocation location, std::string_view what, std::string_view value, std::string_view rule);
  InputError(InputLocation location, const ValueError& error);

  const InputLocation& location() const { return *location_; }

 private:
  std::shared_ptr<const InputLocation> location_;  // shared: copying an exception must not throw
};

}  // namespace litfog
