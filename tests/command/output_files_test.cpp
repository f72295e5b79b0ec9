// SPDX-License-Identifier: Apache-2.0
#include "command/output_files.h"

#include <gtest/gtest.h>

#include <CLI/Error.hpp>
#include <fstream>
#include <functional>

#include "command/exit_status.h"
#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "litfog/files/output_error.h"

namespace litfog::test {
using namespace command;

namespace {

namespace fs = std::filesystem;

class OutputFilesTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }
  void make(const std::string& name) const { std::ofstream(path(name)) << "text"; }

 private:
  TemporaryDirectory directory_;
};

std::string error_of(const std::function<void()>& run) { return sentence_of<CLI::ValidationError>(run); }

TEST_F(OutputFilesTest, NamesThatAreTooLongAreNotOneFile) {
  OutputFiles outputs;
  outputs.add("-o", path(std::string(300, 'a')));
  EXPECT_EQ(error_of([&] { outputs.add("-o", path(std::string(300, 'b'))); }), "no error");
}

TEST_F(OutputFilesTest, TemporariesOfKilledCommandsAreRemovedFromTheFoldersOfOutputs) {
  fs::create_directory(path("folder"));
  for (const char* name : {".litfog-0123456789abcdef", "folder/.litfog-0123456789abcdef"}) make(name);
  OutputFiles outputs;
  outputs.add("-o", path("folder/a"));
  EXPECT_FALSE(fs::exists(path("folder/.litfog-0123456789abcdef")));
  EXPECT_TRUE(fs::exists(path(".litfog-0123456789abcdef")));
}

TEST_F(OutputFilesTest, EmptyNamesAreUsageErrors) {
  OutputFiles outputs;
  EXPECT_EQ(error_of([&] { outputs.add("--stats", ""); }), "--stats = \"\": must not be empty");
}

TEST_F(OutputFilesTest, TwoOutputsOfOneFileAreUsageErrors) {
  fs::create_directory(path("folder"));
  fs::create_symlink("a.png", path("link"));
  for (const std::string other : {"a.png", "./a.png", "folder/../a.png", "link"}) {
    OutputFiles outputs;
    outputs.add("--output", path("a.png"));  // which is not there yet
    EXPECT_EQ(error_of([&] { outputs.add("--stats", path(other)); }),
              "--stats = " + path(other) + ": must not be the file of --output");
  }
  OutputFiles outputs;
  outputs.add("--output", path("a.png"));
  outputs.add("--stats", path("b.png"));
}

TEST_F(OutputFilesTest, InputsAreNotOverwritten) {
  make("scene.json");
  fs::create_hard_link(path("scene.json"), path("hard"));
  fs::create_symlink("scene.json", path("soft"));
  for (const std::string output : {"scene.json", "./scene.json", "hard", "soft"}) {
    OutputFiles outputs;
    outputs.add("--output", path(output));
    EXPECT_EQ(error_of([&] { outputs.expect_apart_from(path("scene.json")); }),
              "--output = " + path(output) + ": must not be a file that is read, " + path("scene.json"));
    outputs.expect_apart_from(path("other.json"));
  }
}

TEST_F(OutputFilesTest, DevicesAreNotFiles) {
  OutputFiles outputs;
  outputs.add("--output", "/dev/null");
  outputs.add("--stats", "/dev/null");
  outputs.expect_apart_from("/dev/null");
}

TEST_F(OutputFilesTest, OutputNeedsAnExistingFolder) {
  OutputFiles outputs;
  EXPECT_THROW(outputs.add("--output", path("none/a.png")), OutputError);
  EXPECT_THROW(outputs.add("--output", path("")), OutputError);
}

TEST_F(OutputFilesTest, DocumentsThatPeopleWriteAreNotReplaced) {
  for (const char* kind : {"light-spec", "light", "scene", "camera-path"}) {
    std::ofstream(path("stats.json")) << "{\"litfog\": \"" << kind << "\", \"version\": 1}";
    OutputFiles outputs;
    outputs.add("--stats", path("stats.json"));
    EXPECT_EQ(sentence_of<OutputError>([&] { outputs.expect_no_documents(); }),
              path("stats.json") + ": cannot be written: exists, and is a litfog document, a " + kind);
  }
  for (const char* text : {"", "text", "{\"frames\": 3}", "[]", "{\"litfog\": 1}"}) {
    std::ofstream(path("stats.json")) << text;
    OutputFiles outputs;
    outputs.add("--stats", path("stats.json"));
    outputs.expect_no_documents();
  }
}

}  // namespace

}  // namespace litfog::test
