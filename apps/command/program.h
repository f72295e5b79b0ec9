// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace litfog::command {

/// Runs another program to its end, without a shell, so that no text can become a command.
///
/// arguments  the program's name, looked up on the PATH, and its arguments
/// input      standard input
/// remedy     advice if it is missing: "install gnuplot-nox"
/// returns    standard output: a file without a name, in which the program may seek
/// throws     MissingCapability if it cannot be run, or fails, with its standard error; OutputError if temporary files
///            cannot be written
std::string run_program(const std::vector<std::string>& arguments, std::string_view input, const std::string& remedy);

}  // namespace litfog::command
