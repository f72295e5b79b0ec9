// SPDX-License-Identifier: Apache-2.0
#include "demo/window_job.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "command/exit_status.h"

namespace litfog::demo {

void become_window(const std::vector<std::string>& arguments) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  std::string window = (program.parent_path() / "litfog-window").string();
  std::vector<std::string> words{window};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(window.c_str(), argv.data());
  throw command::MissingCapability(window + " cannot be started: " + std::strerror(errno) +
                                   " (it is built where libglfw3-dev and libimgui-dev are installed)");
}

}  // namespace litfog::demo
