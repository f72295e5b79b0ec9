// SPDX-License-Identifier: Apache-2.0
#include "drawing/picture_file.h"

#include <filesystem>

#include "files/whole_file.h"
#include "image/image_library.h"
#include "image/png_text.h"
#include "litfog/files/output_error.h"
#include "render/display.h"

namespace litfog::drawing {
namespace {

enum class Format { png, exr, unknown };

Format format_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".png" ? Format::png : ending == ".exr" ? Format::exr : Format::unknown;
}

std::string text_of(const std::string& path, const render::Picture& picture, bool in_floats) {
  if (format_of(path) == Format::png) return png_text(picture);
  try {
    return image::image_library().exr_text(picture.width, picture.height, picture.rgb, in_floats);
  } catch (const image::ImageError& error) {
    throw OutputError(path + ": cannot be written: " + error.what());
  }
}

}  // namespace

void write_picture(const std::string& path, const render::Picture& picture, bool in_floats) {
  files::write_whole_file(path, text_of(path, picture, in_floats));
}

std::string png_text(const render::Picture& picture) {
  return image::png_text(picture.width, picture.height, shown_pixels(picture));
}

std::vector<std::uint8_t> shown_pixels(const render::Picture& picture) {
  std::vector<std::uint8_t> pixels(picture.rgb.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    pixels[i] = render::shown_level(picture.rgb[i], std::uint32_t(i));
  }
  return pixels;
}

bool is_picture_path(const std::string& path) { return format_of(path) != Format::unknown; }

bool holds_scene_light(const std::string& path) { return format_of(path) == Format::exr; }

}  // namespace litfog::drawing
