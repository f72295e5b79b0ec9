// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "litfog/input_error.h"

namespace litfog::test {

/// What a fuzzer feeds with bytes: a reader, by the text of a file, or functions of numbers, by what
/// Random(std::string_view) draws. Expectations of GoogleTest say what has to hold, and end the program.
struct FuzzTarget {
  const char* name;
  void (*run)(std::string_view bytes);
  std::vector<std::string> folders = {};                                            ///< of seeds: all files in them
  std::vector<std::string> (*seeds)() = [] { return std::vector<std::string>{}; };  ///< more of them
};

/// All targets; each source file adds its own.
inline std::vector<FuzzTarget>& fuzz_targets() {
  static std::vector<FuzzTarget> targets;
  return targets;
}

struct AddFuzzTargets {
  AddFuzzTargets(std::initializer_list<FuzzTarget> targets) {
    fuzz_targets().insert(fuzz_targets().end(), targets.begin(), targets.end());
  }
};

/// Seeds of targets that take numbers.
inline std::vector<std::string> random_seeds() {
  std::mt19937_64 engine(44);
  std::vector<std::string> seeds(60);
  for (std::string& seed : seeds) {
    seed.resize(engine() % 1500);
    for (char& byte : seed) byte = char(engine());
  }
  return seeds;
}

/// A file in memory, for readers that take a path only.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view bytes) {
    std::ofstream(path_, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
  }
  ~MemoryFile() {
    std::filesystem::remove(path_);
    --files_;
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  static inline int files_ = 0;
  std::string path_ = "/dev/shm/litfog-fuzz-" + std::to_string(getpid()) + "-" + std::to_string(files_++);
};

/// Reads what may be anything: it is taken, or refused by one sentence at a location within the text. All else that may
/// be thrown ends the program.
///
/// name  of the text's file
template <typename Read>
void expect_read_or_refused(std::string_view text, const std::string& name, const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    const std::string_view sentence = error.what();
    EXPECT_FALSE(sentence.empty() || sentence.find('\n') != std::string_view::npos) << sentence;
    const auto& [file, line, column] = error.location();
    if (file != name) return;  // that it leads to
    const auto lines = std::ranges::count_if(text, [](char c) { return c == '\n' || c == '\r'; }) + 1;
    EXPECT_LE(line, lines) << sentence;
    EXPECT_LE(column, text.size() + 1) << sentence;
    EXPECT_EQ(line == 0, column == 0) << sentence;
  }
}

}  // namespace litfog::test
