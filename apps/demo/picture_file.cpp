// SPDX-License-Identifier: Apache-2.0
#include "demo/picture_file.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>

#include "files/whole_file.h"
#include "litfog/files/output_error.h"

namespace litfog::demo {
namespace {

enum class Format { png, exr, unknown };

Format format_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".png" ? Format::png : ending == ".exr" ? Format::exr : Format::unknown;
}

/// A file's bytes, made in memory: OIIO's PNG writer does not notice a full disk. Throws OutputError naming the path.
std::vector<unsigned char> encoded(const std::string& path, const OIIO::ImageSpec& spec,
                                   const std::vector<float>& pixels) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  OIIO::attribute("debug", 0);  // which would tell on standard error that a date is left out
  const auto output = OIIO::ImageOutput::create(path);
  if (!output) throw OutputError(path + ": cannot be written: " + OIIO::geterror());
  if (!output->set_ioproxy(&memory) || !output->open(path, spec) ||
      !output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) || !output->close()) {
    throw OutputError(path + ": cannot be written: " + output->geterror());
  }
  return bytes;
}

constexpr unsigned kDitherSeed = 1;  // of OIIO: an output's attribute oiio:dither

std::vector<float> srgb_values(const render::Picture& picture) {
  std::vector<float> values = picture.rgb;
  for (float& value : values) value = OIIO::linear_to_sRGB(std::clamp(value, 0.0f, 1.0f));
  return values;
}

std::string text_of(const std::string& path, const render::Picture& picture) {
  const bool is_png = format_of(path) == Format::png;
  OIIO::ImageSpec spec(picture.width, picture.height, 3, is_png ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::HALF);
  spec.attribute("oiio:ColorSpace", is_png ? "sRGB" : "Linear");
  if (is_png) {
    spec.attribute("oiio:dither", int(kDitherSeed));
    spec.attribute("png:compressionLevel", 3);
  } else {
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", 0);  // no time: the same picture is the same file
  }
  const std::vector<unsigned char> bytes = encoded(path, spec, is_png ? srgb_values(picture) : picture.rgb);
  return {bytes.begin(), bytes.end()};
}

}  // namespace

void write_picture(const std::string& path, const render::Picture& picture) {
  files::write_whole_file(path, text_of(path, picture));
}

std::string png_text(const render::Picture& picture) { return text_of("picture.png", picture); }

std::vector<std::uint8_t> shown_pixels(const render::Picture& picture) {
  std::vector<float> values = srgb_values(picture);
  const auto row = OIIO::stride_t(sizeof(float)) * 3 * picture.width;
  OIIO::add_dither(3, picture.width, picture.height, 1, values.data(), 3 * sizeof(float), row, row * picture.height,
                   1.0f / 255, -1, -1, kDitherSeed);
  std::vector<std::uint8_t> pixels(values.size());
  std::ranges::transform(values, pixels.begin(),
                         [](float value) { return std::uint8_t(std::clamp(value * 255.0f + 0.5f, 0.0f, 255.0f)); });
  return pixels;
}

bool is_picture_path(const std::string& path) { return format_of(path) != Format::unknown; }

bool holds_scene_light(const std::string& path) { return format_of(path) == Format::exr; }

}  // namespace litfog::demo
