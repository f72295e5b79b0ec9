// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "command/exit_status.h"
#include "command/option_rule.h"
#include "command/standard_output.h"

namespace litfog::command {

/// What all commands share: their options' strictness, their standard output and the way they end.
///
///     int main(int argc, char** argv) {
///       expect_uncaught();
///       CLI::App app{"Computes this and that.", "litfog-this"};
///       double threshold = 0.05;
///       add_number(app, "--threshold", threshold, kOpenUnitInterval, "Attenuation at which a light ends");
///       return run_command(app, argc, argv, [&] { write_standard_output("done\n"); return kDone; });
///     }

/// Which numbers an option takes, and the text of that rule.
struct NumberRule {
  bool (*accepts)(double);
  const char* text;
  double least = -std::numeric_limits<double>::infinity();  ///< closed limits, which take what floats round beyond them
  double most = std::numeric_limits<double>::infinity();
};
inline constexpr NumberRule kNotNegative{[](double x) { return x >= 0; }, "must be a number >= 0 or inf"};
inline constexpr NumberRule kFiniteNotNegative{[](double x) { return x >= 0 && x <= 1.7976931348623157e308; },
                                               "must be a finite number >= 0"};
inline constexpr NumberRule kOpenUnitInterval{[](double x) { return x > 0 && x < 1; }, "must be a number in (0, 1)"};

/// The number of a text that a rule takes, or nothing.
std::optional<double> parse_number(std::string_view text, const NumberRule& rule);

/// Options whose value is checked as it is parsed; a wrong one ends the command with status kUsage.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, NumberRule rule,
                        const std::string& description);
CLI::Option* add_integer(CLI::App& app, const std::string& name, int& target, int least, int most,
                         const std::string& description);
/// Numbers with commas between them.
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>& target, NumberRule rule,
                         const std::string& description);

/// --contrast, by which a visibility means a density (Fog::from_visibility).
CLI::Option* add_contrast(CLI::App& app, double& target);

/// Ends the command as fail_option does, for a word that is none of the choices.
[[noreturn]] void fail_choice(const std::string& name, const std::string& word,
                              const std::vector<std::string_view>& choices);

/// An option that takes one of a few words.
template <typename Choice>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Choice& target,
                        std::vector<std::pair<std::string, Choice>> choices, const std::string& description) {
  std::string words;
  for (const auto& choice : choices) words += (words.empty() ? "" : "|") + choice.first;
  const auto parse = [&target, name, words, choices = std::move(choices)](const CLI::results_t& values) {
    for (const auto& [word, choice] : choices) {
      if (word == values.front()) {
        target = choice;
        return true;
      }
    }
    std::vector<std::string_view> known;
    for (const auto& choice : choices) known.push_back(choice.first);
    fail_choice(name, values.front(), known);
  };
  return app.add_option(name, parse, description)->type_name(words);
}

/// "litfog-fit: out of memory" on standard error. Takes none. Returns kInternalError.
ExitStatus say_out_of_memory();

/// Parses the command line, runs the command, and turns whatever comes of it into one message on standard error and an
/// exit status. Adds --help and --version. Standard output is closed at the end, so that a full disk is noticed.
int run_command(CLI::App& app, int argc, char** argv, const std::function<ExitStatus()>& run);

}  // namespace litfog::command
