// SPDX-License-Identifier: Apache-2.0
#include "command/bundled_data.h"

namespace litfog::command {

std::filesystem::path bundled_folder(const std::string& name) {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path installed = (program.parent_path() / LITFOG_DATA_FROM_PROGRAM / name).lexically_normal();
  if (std::filesystem::is_directory(installed, error)) return installed;
  const std::filesystem::path sources = std::filesystem::path(LITFOG_SOURCE_DATA_DIR) / name;
  return std::filesystem::is_directory(sources, error) ? sources : installed;
}

}  // namespace litfog::command
