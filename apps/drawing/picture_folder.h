// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "render/picture.h"

namespace litfog::drawing {

/// A folder to fill with pictures of scenes.
class PictureFolder {
 public:
  /// Makes the folder if it does not exist.
  ///
  /// files   names of the pictures, and of what else is written there; each must be another: one scene may be named
  ///         like another's picture
  /// inputs  files that the command reads, none of which may be replaced
  /// throws  InputError, CLI::ValidationError or OutputError, before anything is written
  PictureFolder(const std::string& path, const std::vector<std::string>& files, const std::vector<std::string>& inputs);

  /// A file in the folder.
  std::string path_of(const std::string& file) const { return (path_ / file).string(); }

  /// Writes a picture (write_picture) while the caller goes on. Throws the error of the picture before it.
  void write(const std::string& file, render::Picture picture);

  /// Waits until all is written. Throws the last picture's error.
  void finish();

 private:
  std::filesystem::path path_;
  std::future<void> writing_;
};

}  // namespace litfog::drawing
