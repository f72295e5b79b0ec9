// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace litfog::command {

/// Runs another program to its end, without a shell: no text can become a command.
///
/// arguments  its name, which is looked up on the PATH, and what follows it
/// input      its standard input
/// remedy     what helps where it is not there: "install gnuplot-nox"
/// returns    its standard output: a file without a name, which the program may seek in
/// throws     MissingCapability where it cannot be run, or fails, with its standard error; OutputError where temporary
///            files cannot be written
std::string run_program(const std::vector<std::string>& arguments, std::string_view input, const std::string& remedy);

}  // namespace litfog::command
