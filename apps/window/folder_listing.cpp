// SPDX-License-Identifier: Apache-2.0
#include "window/folder_listing.h"

#include <algorithm>
#include <tuple>

namespace litfog::window {

namespace fs = std::filesystem;

FolderListing list_folder(const fs::path& folder, std::span<const std::string> endings) {
  std::error_code error;
  FolderListing listing{.folder = fs::absolute(folder, error).lexically_normal(), .entries = {}, .error = {}};
  if (!listing.folder.has_filename()) listing.folder = listing.folder.parent_path();  // "/home/" is "/home"
  const auto ends_so = [&endings](const fs::path& name) {
    std::string ending = name.extension().string();
    for (char& letter : ending) letter = letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
    return std::ranges::find(endings, ending) != endings.end();
  };
  for (fs::directory_iterator at(listing.folder, error); !error && at != fs::end(at); at.increment(error)) {
    const fs::path name = at->path().filename();
    std::error_code unknown;  // a link that leads nowhere is neither
    const bool is_folder = at->is_directory(unknown);
    const bool is_shown = is_folder || (ends_so(name) && at->is_regular_file(unknown));
    if (is_shown && !name.string().starts_with('.')) listing.entries.push_back({name.string(), is_folder});
  }
  if (error) listing.error = "cannot be read: " + error.message();
  std::ranges::sort(listing.entries, [](const FolderListing::Entry& a, const FolderListing::Entry& b) {
    return std::tie(b.is_folder, a.name) < std::tie(a.is_folder, b.name);
  });
  return listing;
}

}  // namespace litfog::window
