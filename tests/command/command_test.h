// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "command/temporary_directory.h"

namespace litfog::test {

struct Outcome {
  int status;
  std::string out;
  std::string err;
};

/// Whether a text has a part.
inline testing::AssertionResult has(const std::string& text, const std::string& part) {
  const bool is_there = text.find(part) != text.npos;
  return (is_there ? testing::AssertionSuccess() : testing::AssertionFailure()) << "\"" << part << "\" in: " << text;
}

/// Runs a built command in a directory of the test's own.
class CommandTest : public testing::Test {
 protected:
  explicit CommandTest(std::string command) : command_(std::move(command)) {}

  const std::filesystem::path& directory() const { return directory_.path(); }

  void write(const std::string& name, const std::string& text) const { directory_.write(name, text); }

  std::string read(const std::string& name) const {
    std::ifstream file(directory() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Runs the command again and again, with memory for a tenth more allocations each time, until there is enough. While
  /// there is not, it must say so and nothing else.
  ///
  /// library  the path of command/short_memory.cpp
  void expect_words_where_memory_is_short(const std::string& arguments, const std::string& library) const {
    Outcome outcome{-1, "", ""};
    for (int i = 1; outcome.status != 0 && i < 1'000'000; i += 1 + i / 10) {
      outcome = run(arguments, "LITFOG_FAILING_ALLOCATION=" + std::to_string(i) + " LD_PRELOAD=" + library);
      if (outcome.status == 0) break;
      ASSERT_EQ(outcome.status, 70) << i << ": " << outcome.err;
      ASSERT_TRUE(outcome.err.ends_with(": out of memory\n")) << i << ": " << outcome.err;
      ASSERT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
      ASSERT_EQ(outcome.out, "") << i;
    }
    EXPECT_EQ(outcome.status, 0);
  }

  /// arguments as in a shell, redirections in them win over the test's own; environment as in "NAME=value".
  Outcome run(const std::string& arguments, const std::string& environment = "") const {
    const std::string line = "cd " + directory().string() + " && { " + environment + " " + command_ + " " + arguments +
                             "; } </dev/null >out 2>err";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out"), without_progress(read("err"))};
  }

  /// Runs the command, which has to succeed.
  Outcome expect_done(const std::string& arguments, const std::string& environment = "") const {
    const Outcome outcome = run(arguments, environment);
    EXPECT_EQ(outcome.status, 0) << arguments << "\n" << outcome.err;
    return outcome;
  }

 private:
  /// Lines such as "room: loading (5 s)", which a slow machine has.
  static std::string without_progress(const std::string& text) {
    return std::regex_replace(text, std::regex("[^\n]* \\([0-9]+ s\\)\n"), "");
  }

  std::string command_;
  TemporaryDirectory directory_;
};

}  // namespace litfog::test

#define EXPECT_ERROR(outcome, expected_status, message) \
  do {                                                  \
    const litfog::test::Outcome failed = (outcome);     \
    EXPECT_EQ(failed.status, expected_status);          \
    EXPECT_EQ(failed.out, "");                          \
    EXPECT_EQ(failed.err, message);                     \
  } while (false)
