// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "command/temporary_directory.h"

namespace litfog::test {

struct Outcome {
  int status;
  std::string out;
  std::string err;
};

/// Runs a built command in a directory of the test's own.
class CommandTest : public testing::Test {
 protected:
  explicit CommandTest(std::string command) : command_(std::move(command)) {}

  const std::filesystem::path& directory() const { return directory_.path(); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(directory() / name, std::ios::binary) << text;
  }

  std::string read(const std::string& name) const {
    std::ifstream file(directory() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// arguments as in a shell, redirections in them win over the test's own; environment as in "NAME=value".
  Outcome run(const std::string& arguments, const std::string& environment = "") const {
    const std::string line = "cd " + directory().string() + " && { " + environment + " " + command_ + " " + arguments +
                             "; } </dev/null >out 2>err";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read("out"), read("err")};
  }

 private:
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
