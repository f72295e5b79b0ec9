// SPDX-License-Identifier: Apache-2.0
#include "window/own_files.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "files/whole_file.h"
#include "litfog/files/output_error.h"

namespace litfog::window {

namespace fs = std::filesystem;

fs::path own_file(const std::string& name) {
  const char* const stated = std::getenv("XDG_CONFIG_HOME");
  const char* const home = std::getenv("HOME");
  fs::path folder = stated && fs::path(stated).is_absolute() ? fs::path(stated)
                    : home                                   ? fs::path(home) / ".config"
                                                             : fs::path();
  if (folder.empty()) return {};
  folder /= "litfog";
  std::error_code error;
  fs::create_directories(folder, error);
  return error ? fs::path() : folder / name;
}

std::vector<std::string> recent_files() {
  std::vector<std::string> files;
  std::ifstream list(own_file("recent"));
  std::error_code error;
  for (std::string line; std::getline(list, line);) {
    if (fs::exists(line, error)) files.push_back(line);
  }
  return files;
}

void remember_file(const std::string& path) {
  constexpr std::size_t kMost = 10;
  std::error_code error;
  const std::string whole = fs::absolute(path, error).lexically_normal().string();
  const fs::path list = own_file("recent");
  if (list.empty() || whole.find('\n') != whole.npos) return;
  std::vector<std::string> files = recent_files();
  std::erase(files, whole);
  files.insert(files.begin(), whole);
  files.resize(std::min(files.size(), kMost));
  std::string text;
  for (const std::string& file : files) text += file + "\n";
  try {
    files::write_whole_file(list.string(), text);
  } catch (const OutputError&) {  // a convenience, not worth a message
  }
}

}  // namespace litfog::window
