// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace litfog::command {

/// The meaning of an exit status, the same for every command.
enum ExitStatus {
  kDone = 0,
  kUsage = 1,              ///< the command line was wrong: unknown option, missing or wrong value
  kBadInput = 2,           ///< a file was wrong; if the output has a row for each input, good rows are written
  kMissingCapability = 3,  ///< the machine lacks something: no GL, no extension
  kCannotWrite = 4,        ///< output could not be written
  kNotToTolerance = 5,  ///< solved, but not to the stated tolerance, or target infeasible; the best result is written
  kInternalError = 70,  ///< the program is at fault, or memory is short (EX_SOFTWARE of sysexits.h)
};

/// Thrown if the machine lacks a capability. what() names it.
struct MissingCapability : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace litfog::command
