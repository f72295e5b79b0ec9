// SPDX-License-Identifier: Apache-2.0
#include "files/bundled_name.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "files/hint.h"
#include "litfog/input_error.h"

namespace litfog::files {

std::filesystem::path file_or_bundled(const std::filesystem::path& given, const std::filesystem::path& folder) {
  std::error_code error;
  if (given.has_parent_path() || std::filesystem::exists(given, error)) return given;
  const std::filesystem::path bundled = folder / (given.string() + ".json");
  if (std::filesystem::exists(bundled, error)) return bundled;
  if (given.has_extension()) return given;  // its reader says that it cannot be read
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  throw InputError({.file = given.string()},
                   "must be a file or a bundled light" + hint_for_word(given.string(), {names.begin(), names.end()}));
}

}  // namespace litfog::files
