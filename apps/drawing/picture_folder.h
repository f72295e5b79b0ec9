// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <vector>

#include "render/picture.h"

namespace litfog::drawing {

/// A folder that is filled with pictures of scenes.
class PictureFolder {
 public:
  /// Makes the folder if it does not exist.
  ///
  /// files   names of all files to be written there; must be unique, because a scene may have the name of another's
  ///         picture
  /// inputs  files that the command reads, none of which may be replaced
  /// throws  InputError, CLI::ValidationError or OutputError, before anything is written
  PictureFolder(const std::string& path, const std::vector<std::string>& files, const std::vector<std::string>& inputs);

  /// The path of a file in the folder.
  std::string path_of(const std::string& file) const { return (path_ / file).string(); }

  /// Writes a picture (write_picture) in the background. Throws the error of the previous picture.
  void write(const std::string& file, render::Picture picture);

  /// Waits until all is written. Throws the last picture's error.
  void finish();

 private:
  std::filesystem::path path_;
  std::future<void> writing_;
};

}  // namespace litfog::drawing
