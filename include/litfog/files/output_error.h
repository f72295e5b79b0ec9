// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace litfog {

/// Thrown where output could not be written. what() is the whole sentence: "a.json: cannot be written: No space left on
/// device". It quotes names as given: escape control characters before sending it to a terminal.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace litfog
