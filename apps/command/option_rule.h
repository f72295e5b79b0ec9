// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace litfog::command {

/// A condition under which other options would have no effect. These are then usage errors, so that no option is
/// silently ignored.
struct OptionRule {
  std::string condition;              ///< as typed: "--fog none"
  bool applies;                       ///< whether it holds for the command line
  std::vector<std::string> excluded;  ///< the options without effect
  std::string reason = {};            ///< "there is nothing to see through"; may be left out
};

/// Throws the usage error of the first option that is given although it is excluded: "--visibility cannot be given with
/// --fog none: there is nothing to see through".
void check_options(const CLI::App& app, const std::vector<OptionRule>& rules);

/// Throws the usage error of an option's value: "--name = value: rule". Also for rules that need the parsed options.
[[noreturn]] void fail_option(const std::string& name, std::string_view value, std::string_view rule);

}  // namespace litfog::command
