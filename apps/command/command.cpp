// SPDX-License-Identifier: Apache-2.0
#include "command/command.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <regex>
#include <stdexcept>
#include <system_error>

#include "command/number.h"
#include "command/printable.h"
#include "files/hint.h"
#include "litfog/files/output_error.h"
#include "litfog/fog.h"
#include "litfog/input_error.h"
#include "model/float_limit.h"

namespace litfog::command {

namespace {

/// Occupies standard streams that the caller closed, so that no file opened later becomes one. Opens them in the wrong
/// mode, so that using them fails as before.
void occupy_closed_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    if (open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) != stream) std::abort();
  }
}

/// fail_option, with a hint what a wrong number may have meant.
[[noreturn]] void fail_number(const std::string& name, std::string_view text, std::string_view rule) {
  const auto number = parse_number(text);
  fail_option(name, text,
              std::string(rule) + (number ? files::hint_for_fraction(*number, rule) : files::hint_for_number(text)));
}

/// "; see litfog-demo compare --help": the help of the job asked for.
std::string see_help(const CLI::App& app) {
  std::string command = app.get_name();
  for (const CLI::App* job : app.get_subcommands()) command += " " + job->get_name();
  return "; see " + command + " --help";
}

/// "--visbility: must be an option; did you mean --visibility?"
std::string describe_extra(const CLI::App& app, const CLI::ExtrasError& error) {
  const std::vector<std::string> extras = app.remaining(true);
  const auto extra = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with("--"); });
  if (extra == extras.end()) return error.what();
  const CLI::App* part = &app;  // the job, which takes no options of the command itself
  while (!part->get_subcommands().empty()) part = part->get_subcommands().front();
  std::vector<std::string> names;
  for (const CLI::Option* option : part->get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  const std::string typed = extra->substr(0, extra->find('='));
  return typed + ": must be an option of this command" + files::hint_for_word(typed, {names.begin(), names.end()});
}

ExitStatus parse_and_run(CLI::App& app, int argc, char** argv, const std::function<ExitStatus()>& run) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    write_standard_output(std::regex_replace(app.help(), std::regex("\n{3}"), "\n\n"));  // one between groups, too
    return kDone;
  } catch (const CLI::CallForVersion&) {
    write_standard_output(app.get_name() + " " LITFOG_VERSION "\n");
    return kDone;
  }
  return run();
}

}  // namespace

ExitStatus say_out_of_memory() {
  std::fprintf(stderr, "%s: out of memory\n", program_invocation_short_name);  // stderr has no buffer
  return kInternalError;
}

void fail_choice(const std::string& name, const std::string& word, const std::vector<std::string_view>& choices) {
  fail_option(name, word,
              fmt::format("must be one of {}{}", fmt::join(choices, "|"), files::hint_for_word(word, choices)));
}

std::optional<double> parse_number(std::string_view text, const NumberRule& rule) {
  auto number = parse_number(text);
  if (number) number = snapped(*number, rule.least, rule.most);
  return number && rule.accepts(*number) ? number : std::nullopt;
}

CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, NumberRule rule,
                        const std::string& description) {
  const auto parse = [&target, name, rule](const CLI::results_t& values) {
    const auto number = parse_number(values.front(), rule);
    if (!number) fail_number(name, values.front(), rule.text);
    target = *number;
    return true;
  };
  return app.add_option(name, parse, description)->type_name("NUMBER");
}

CLI::Option* add_integer(CLI::App& app, const std::string& name, int& target, int least, int most,
                         const std::string& description) {
  const auto parse = [&target, name, least, most](const CLI::results_t& values) {
    const auto number = parse_integer(values.front());
    if (!number || *number < least || *number > most) {
      fail_option(name, values.front(),
                  "must be an integer from " + std::to_string(least) + " to " + std::to_string(most));
    }
    target = *number;
    return true;
  };
  return app.add_option(name, parse, description)->type_name("N");
}

CLI::Option* add_numbers(CLI::App& app, const std::string& name, std::vector<double>& target, NumberRule rule,
                         const std::string& description) {
  const auto parse = [&target, name, rule](const CLI::results_t& values) {
    target.clear();
    for (const std::string_view part : split_at_commas(values.front())) {
      const auto number = parse_number(part, rule);
      if (!number) fail_number(name, part, rule.text);
      target.push_back(*number);
    }
    return true;
  };
  return app.add_option(name, parse, description)->type_name("NUMBER[,...]");
}

CLI::Option* add_contrast(CLI::App& app, double& target) {
  const auto parse = [&target](const CLI::results_t& values) {
    const std::string& text = values.front();
    const auto number = text == "mor"           ? kContrastMor
                        : text == "koschmieder" ? kContrastKoschmieder
                        : text == "flightgear"  ? kContrastFlightgear
                                                : parse_number(text);
    if (!number || !kOpenUnitInterval.accepts(*number)) {
      fail_number("--contrast", text, "must be mor, koschmieder, flightgear or a number in (0, 1)");
    }
    target = *number;
    return true;
  };
  return app
      .add_option("--contrast", parse,
                  "Contrast left at the visibility: mor (0.05, the default), koschmieder (0.02), flightgear (0.01)")
      ->type_name("mor|koschmieder|flightgear|NUMBER");
}

int run_command(CLI::App& app, int argc, char** argv, const std::function<ExitStatus()>& run) {
  occupy_closed_standard_streams();
  // A closed pipe and a file beyond its size limit are then write errors: kCannotWrite.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  setenv("EGL_LOG_LEVEL", "fatal", 0);  // else Mesa's lines on standard error precede our one sentence
  app.option_defaults()->group("Options");
  app.set_version_flag("--version", "");

  const auto end = [&app](const std::string& message, ExitStatus status) {
    std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), printable(message).c_str());
    return status;
  };
  try {
    const ExitStatus status = parse_and_run(app, argc, argv, run);
    close_standard_output();
    return status;
  } catch (const CLI::ExtrasError& error) {
    return end(describe_extra(app, error) + see_help(app), kUsage);
  } catch (const CLI::ParseError& error) {
    return end(error.what() + see_help(app), kUsage);
  } catch (const InputError& error) {
    // Starts with the file's name, not the command's: editors can jump to it.
    std::fprintf(stderr, "%s\n", printable(error.what()).c_str());
    return kBadInput;
  } catch (const MissingCapability& error) {
    return end(error.what(), kMissingCapability);
  } catch (const OutputError& error) {
    return end(error.what(), kCannotWrite);
  } catch (const std::bad_alloc&) {
    return say_out_of_memory();
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::not_enough_memory) return say_out_of_memory();
    return end(error.what(), kMissingCapability);
  } catch (const std::invalid_argument& error) {  // an input error that no reader caught
    return end(error.what(), kBadInput);
  } catch (const std::logic_error& error) {
    return end(std::string("internal error: ") + error.what(), kInternalError);
  } catch (const std::exception& error) {  // a library refused what the input asks for
    return end(error.what(), kBadInput);
  }
}

}  // namespace litfog::command
