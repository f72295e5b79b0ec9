// SPDX-License-Identifier: Apache-2.0
#include "image/png_text.h"

#include <png.h>

#include <stdexcept>

namespace litfog::image {
namespace {

constexpr int kCompressionLevel = 3;  // zlib's default, 6, takes three times as long for a tenth less

/// Instead of libpng's longjmp, which would skip destructors.
[[noreturn]] void fail(png_structp, png_const_charp words) {
  throw std::runtime_error(std::string("picture cannot be packed: ") + words);
}

void append(png_structp writer, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(writer))->append(reinterpret_cast<const char*>(bytes), count);
}

/// Owns libpng's state.
class PngWriter {
 public:
  explicit PngWriter(std::string& text) : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr)) {
    if (!png_) throw std::runtime_error("libpng is not the one compiled for, or memory is short");
    info_ = png_create_info_struct(png_);
    png_set_write_fn(png_, &text, append, [](png_structp) {});
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  void write(int width, int height, const std::vector<std::uint8_t>& levels) {
    png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(png_, kCompressionLevel);
    png_write_info(png_, info_);
    for (std::size_t y = 0; y < std::size_t(height); ++y) png_write_row(png_, &levels[y * std::size_t(width) * 3]);
    png_write_end(png_, nullptr);
  }

 private:
  png_structp png_;
  png_infop info_ = nullptr;
};

}  // namespace

std::string png_text(int width, int height, const std::vector<std::uint8_t>& levels) {
  std::string text;
  PngWriter(text).write(width, height, levels);
  return text;
}

}  // namespace litfog::image
