// SPDX-License-Identifier: Apache-2.0
#include "demo/jobs.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "command/exit_status.h"

namespace litfog::demo {
namespace {

/// Checks the libraries that only litfog-window links. The dynamic linker would name just the file.
void expect_libraries() {
  constexpr struct {
    const char* library;
    const char* package;
  } kNeeded[] = {{"libglfw.so.3", "libglfw3"}, {"libstb.so.0", "libstb0"}};
  for (const auto& [library, package] : kNeeded) {
    if (dlopen(library, RTLD_LAZY)) continue;
    throw command::MissingCapability(std::string("litfog-window needs ") + library +
                                     ", which cannot be loaded (install " + package + ")");
  }
}

}  // namespace

void become_window(const std::vector<std::string>& arguments) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  std::string window = (program.parent_path() / "litfog-window").string();
  std::vector<std::string> words{window};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  if (std::filesystem::exists(window, error)) expect_libraries();
  execv(window.c_str(), argv.data());
  throw command::MissingCapability(window + " cannot be started: " + std::strerror(errno) +
                                   " (it is built where libglfw3-dev and libimgui-dev are installed)");
}

}  // namespace litfog::demo
