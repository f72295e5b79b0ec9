// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdlib.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace litfog::test {

/// While it lives, programs are looked for in one folder alone.
class ProgramFolder {
 public:
  explicit ProgramFolder(const std::filesystem::path& folder) { setenv("PATH", folder.c_str(), 1); }
  ~ProgramFolder() { setenv("PATH", path_.c_str(), 1); }
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

 private:
  std::string path_ = std::getenv("PATH");
};

/// A shell script that can be run as a program.
inline void write_program(const std::filesystem::path& file, const std::string& script) {
  std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

}  // namespace litfog::test
