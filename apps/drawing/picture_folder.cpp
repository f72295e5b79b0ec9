// SPDX-License-Identifier: Apache-2.0
#include "drawing/picture_folder.h"

#include <memory>
#include <set>

#include "command/output_files.h"
#include "drawing/picture_file.h"
#include "litfog/files/output_error.h"
#include "litfog/input_error.h"

namespace litfog::drawing {

PictureFolder::PictureFolder(const std::string& path, const std::vector<std::string>& files,
                             const std::vector<std::string>& inputs)
    : path_(path) {
  std::set<std::string> names;
  for (const std::string& file : files) {
    if (!names.insert(file).second)
      throw InputError({.file = path_of(file)}, "would be a picture of two scenes: rename one");
  }
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) throw OutputError(path + ": cannot be made: " + error.message());
  command::OutputFiles outputs;
  for (const std::string& file : files) outputs.add("--output", path_of(file));
  for (const std::string& input : inputs) outputs.expect_apart_from(input);
}

void PictureFolder::write(const std::string& file, render::Picture picture) {
  finish();
  const auto write = [path = path_of(file), picture = std::make_shared<const render::Picture>(std::move(picture))] {
    write_picture(path, *picture);
  };
  // If no thread can start, finish() writes. The picture is copied, because libstdc++ would move it into a thread that
  // does not start.
  writing_ = std::async(std::launch::async | std::launch::deferred, write);
}

void PictureFolder::finish() {
  if (writing_.valid()) writing_.get();
}

}  // namespace litfog::drawing
