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

/// Shared by all commands: strict options, standard output and exit.
///
///     int main(int argc, char** argv) {
///       expect_uncaught();
///       CLI::App app{"Computes this and that.", "litfog-this"};
///       double threshold = 0.05;
///       add_number(app, "--threshold", threshold, kOpenUnitInterval, "Attenuation at which a light ends");
///       return run_command(app, argc, argv, [&] { write_standard_output("done\n"); return kDone; });
///     }

/// The rule for an option's number, as a function and as text.
struct NumberRule {
  bool (*accepts)(double);
  const char* text;
  double least = -std::numeric_limits<double>::infinity();  ///< closed limits; also accept values rounded beyond them
  double most = std::numeric_limits<double>::infinity();
};
inline constexpr NumberRule kNotNegative{[](double x) { return x >= 0; }, "must be a number >= 0 or inf"};
inline constexpr NumberRule kFiniteNotNegative{[](double x) { return x >= 0 && x <= 1.7976931348623157e308; },
                                               "must be a finite number >= 0"};
inline constexpr NumberRule kOpenUnitInterval{[](double x) { return x > 0 && x < 1; }, "must be a number in (0, 1)"};

/// Parses a number that a rule accepts, or returns nothing.
std::optional<double> parse_number(std::string_view text, const NumberRule& rule);

/// Adds an option whose value is checked when parsed. A wrong one ends the command with status kUsage.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, NumberRule rule,
                        const std::string& description);
CLI::Option* add_integer(CLI::App& app, const std::string& name, int& target, int least, int most,
                         const std::string& description);
/// Adds an option of numbers separated by commas.
CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>& target, NumberRule rule,
                         const std::string& description);

/// Adds --contrast, which relates visibility and density (Fog::from_visibility).
CLI::Option* add_contrast(CLI::App& app, double& target);

/// Ends the command like fail_option, for a word that is none of the choices.
[[noreturn]] void fail_choice(const std::string& name, const std::string& word,
                              const std::vector<std::string_view>& choices);

/// Adds an option that takes one of a few words.
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

/// Prints "litfog-fit: out of memory" on standard error without allocating memory. Returns kInternalError.
ExitStatus say_out_of_memory();

/// Parses the command line, runs the command, and turns errors into one message on standard error and an exit status.
/// Adds --help and --version. Closes standard output at the end, so that a full disk is noticed.
int run_command(CLI::App& app, int argc, char** argv, const std::function<ExitStatus()>& run);

}  // namespace litfog::command
