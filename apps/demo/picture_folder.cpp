// SPDX-License-Identifier: Apache-2.0
#include "picture_folder.h"

#include <fmt/format.h>

#include "exit_status.h"

namespace litfog::demo {

PictureFolder::PictureFolder(const std::string& path) : path_(path) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw CannotWrite(path + ": cannot be made: " + error.message());
}

void PictureFolder::add_scene(const std::string& name, const std::string& file) {
  const auto [earlier, is_new] = scenes_.try_emplace(name, file);
  if (!is_new) throw BadInput(fmt::format("{}: name = {}: must not be that of {} too", file, name, earlier->second));
}

void PictureFolder::write(const std::string& file, Picture picture) {
  if (!files_.insert(file).second) throw BadInput(path_of(file) + ": would be a picture of two scenes: rename one");
  finish();
  writing_ = std::async(std::launch::async,
                        [path = path_of(file), picture = std::move(picture)] { write_picture(path, picture); });
}

void PictureFolder::finish() {
  if (writing_.valid()) writing_.get();
}

}  // namespace litfog::demo
