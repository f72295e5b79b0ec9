// SPDX-License-Identifier: Apache-2.0
#include "command/option_rule.h"

#include <CLI/CLI.hpp>

#include "files/json_text.h"

namespace litfog::command {

void check_options(const CLI::App& app, const std::vector<OptionRule>& rules) {
  for (const OptionRule& rule : rules) {
    if (!rule.applies) continue;
    for (const std::string& option : rule.excluded) {
      const CLI::Option* const given = app.get_option_no_throw(option);  // null: jobs that lack it share the rules
      if (given == nullptr || given->count() == 0) continue;
      throw CLI::ValidationError(option + " cannot be given with " + rule.condition +
                                 (rule.reason.empty() ? "" : ": " + rule.reason));
    }
  }
}

void fail_option(const std::string& name, std::string_view value, std::string_view rule) {
  constexpr std::size_t kMaxShown = 200;
  std::string shown(value.empty() ? "\"\"" : files::start_of(value, kMaxShown));
  if (value.size() > kMaxShown) shown += "...";
  throw CLI::ValidationError(name + " = " + shown + ": " + std::string(rule));
}

}  // namespace litfog::command
