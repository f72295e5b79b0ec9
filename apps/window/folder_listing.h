// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace litfog::window {

/// The folders in a folder, then the files that the window opens, each sorted by name. Hidden ones are left out.
struct FolderListing {
  struct Entry {
    std::string name;  ///< any bytes
    bool is_folder = false;
  };
  std::filesystem::path folder;  ///< absolute
  std::vector<Entry> entries;
  std::string error;  ///< why the folder, or the rest of it, cannot be read; else empty
};

/// Lists a folder.
///
/// endings  of the files, as ".json", in small letters; the files' may be in capitals
FolderListing list_folder(const std::filesystem::path& folder, std::span<const std::string> endings);

}  // namespace litfog::window
