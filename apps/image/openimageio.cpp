// SPDX-License-Identifier: Apache-2.0
// A library of its own, which image_library() loads.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "image/image_library.h"

namespace litfog::image {
namespace {

constexpr const char* kFont = "DejaVuSans";
constexpr float kMaxHalf = 65'504;

OIIO::ImageSpec float_spec(int width, int height) { return {width, height, 3, OIIO::TypeDesc::FLOAT}; }

/// The first line of OpenImageIO's last error.
std::string error_of(const OIIO::ImageInput& input) {
  const std::string lines = input.geterror();
  return lines.substr(0, lines.find('\n'));
}

class OpenImageIo final : public ImageLibrary {
  Levels decode_jpeg(std::string_view bytes, const std::function<void(int, int)>& accept) const override {
    OIIO::Filesystem::IOMemReader reader(const_cast<char*>(bytes.data()), bytes.size());
    const auto input = OIIO::ImageInput::create("jpeg");
    OIIO::ImageSpec spec;
    if (!input) throw ImageError("this OpenImageIO does not read its kind: " + OIIO::geterror());
    if (!input->set_ioproxy(&reader) || !input->open("picture.jpeg", spec)) {
      throw ImageError(error_of(*input));
    }
    accept(spec.width, spec.height);
    Levels levels{spec.width, spec.height, std::size_t(spec.nchannels), {}};
    levels.values.resize(spec.image_pixels() * levels.channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, levels.values.data())) {
      throw ImageError(error_of(*input));
    }
    return levels;
  }

  std::string exr_text(int width, int height, std::span<const float> rgb, bool in_floats) const override {
    const bool is_half =
        !in_floats && std::ranges::all_of(rgb, [](float value) { return !(std::abs(value) > kMaxHalf); });
    OIIO::ImageSpec spec(width, height, 3, is_half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", 0);  // no time, so that equal pictures give equal files
    OIIO::attribute("debug", 0);    // or it would report the missing date on standard error
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("exr");
    if (!output) throw ImageError(OIIO::geterror());
    if (!output->set_ioproxy(&memory) || !output->open("picture.exr", spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()) || !output->close()) {
      throw ImageError(output->geterror());
    }
    return {bytes.begin(), bytes.end()};
  }

  std::vector<float> resized(int width, int height, std::span<const float> rgb, int new_width,
                             int new_height) const override {
    const OIIO::ImageBuf image(float_spec(width, height), const_cast<float*>(rgb.data()));  // only read
    std::vector<float> pixels(std::size_t(new_width) * std::size_t(new_height) * 3);
    OIIO::ImageBuf small(float_spec(new_width, new_height), pixels.data());
    if (!OIIO::ImageBufAlgo::resize(small, image, "box")) throw ImageError(small.geterror());
    return pixels;
  }

  void draw_text(int width, int height, std::span<float> rgb, int left, int baseline, const std::string& text, int size,
                 std::span<const float, 3> ink) const override {
    OIIO::ImageBuf image(float_spec(width, height), rgb.data());  // draws into the picture's own pixels
    if (!OIIO::ImageBufAlgo::render_text(image, left, baseline, text, size, kFont, OIIO::cspan<float>(ink.data(), 3))) {
      throw ImageError("text cannot be drawn: " + image.geterror());
    }
  }

  int text_width(const std::string& text, int size) const override {
    return OIIO::ImageBufAlgo::text_size(text, size, kFont).width();
  }
};

}  // namespace
}  // namespace litfog::image

extern "C" const litfog::image::ImageLibrary* litfog_image_library();
extern "C" const litfog::image::ImageLibrary* litfog_image_library() {
  static const litfog::image::OpenImageIo library;
  return &library;
}
