// SPDX-License-Identifier: Apache-2.0
#include "demo/picture_folder.h"

#include "command/exit_status.h"
#include "demo/picture_file.h"
#include "litfog/input_error.h"

namespace litfog::demo {

PictureFolder::PictureFolder(const std::string& path) : path_(path) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw command::CannotWrite(path + ": cannot be made: " + error.message());
}

void PictureFolder::write(const std::string& file, render::Picture picture) {
  if (!files_.insert(file).second)
    throw InputError({.file = path_of(file)}, "would be a picture of two scenes: rename one");
  finish();
  const auto anywhere = std::launch::async | std::launch::deferred;  // without a thread to spare, in finish()
  writing_ = std::async(anywhere,
                        [path = path_of(file), picture = std::move(picture)] { write_picture(path, picture); });
}

void PictureFolder::finish() {
  if (writing_.valid()) writing_.get();
}

}  // namespace litfog::demo
