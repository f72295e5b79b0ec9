// SPDX-License-Identifier: Apache-2.0
#include "command/bundled_data.h"

#include <dlfcn.h>
#include <link.h>

namespace litfog::command {
namespace {

/// A path relative to the file that holds this code, a program or a Python extension, so that an installation may be
/// moved as a whole.
std::filesystem::path installed(const char* from_program, const char* from_extension) {
  static const char here = 0;
  Dl_info info;
  void* map = nullptr;
  const bool is_found = dladdr1(&here, &info, &map, RTLD_DL_LINKMAP) != 0;
  const std::filesystem::path library = is_found ? static_cast<const link_map*>(map)->l_name : "";
  if (!library.empty()) return library.parent_path() / from_extension;
  std::error_code error;  // dladdr gives a program no path
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / from_program;
}

}  // namespace

std::filesystem::path bundled_folder(const std::string& name) {
  std::error_code error;
  const std::filesystem::path data =
      (installed(LITFOG_DATA_FROM_PROGRAM, LITFOG_DATA_FROM_EXTENSION) / name).lexically_normal();
  if (std::filesystem::is_directory(data, error)) return data;
  const std::filesystem::path sources = std::filesystem::path(LITFOG_SOURCE_DATA_DIR) / name;
  return std::filesystem::is_directory(sources, error) ? sources : data;
}

std::filesystem::path bundled_plugin(const std::string& name, const std::string& built) {
  std::error_code error;
  const std::filesystem::path plugin =
      (installed(LITFOG_PLUGINS_FROM_PROGRAM, LITFOG_PLUGINS_FROM_EXTENSION) / name).lexically_normal();
  if (std::filesystem::exists(plugin, error) || !std::filesystem::exists(built, error)) return plugin;
  return built;
}

}  // namespace litfog::command
