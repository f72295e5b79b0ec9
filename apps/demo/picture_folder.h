// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <future>
#include <set>
#include <string>

#include "render/picture.h"

namespace litfog::demo {

/// A folder to fill with pictures of scenes.
class PictureFolder {
 public:
  /// Makes the folder where it is missing. Throws CannotWrite.
  explicit PictureFolder(const std::string& path);

  /// A file in the folder.
  std::string path_of(const std::string& file) const { return (path_ / file).string(); }

  /// Writes a picture (write_picture) while the caller goes on; what the picture before it met is thrown here. Throws
  /// InputError where the file has been written already: one scene may be named like another's picture.
  void write(const std::string& file, render::Picture picture);

  /// Waits until all is written. Throws what that met.
  void finish();

 private:
  std::filesystem::path path_;
  std::set<std::string> files_;
  std::future<void> writing_;
};

}  // namespace litfog::demo
