// SPDX-License-Identifier: Apache-2.0
#include "image/png_text.h"

#include <png.h>

namespace litfog::image {
namespace {

constexpr int kCompressionLevel = 3;  // zlib's default, 6, takes three times as long for a tenth less

/// Replaces libpng's longjmp, which would skip destructors, and its line on standard error.
[[noreturn]] void fail(png_structp, png_const_charp words) { throw ImageError(words); }
void ignore_warning(png_structp, png_const_charp) {}

void* allocate(png_structp, png_alloc_size_t size) { return ::operator new(size); }
void release(png_structp, void* memory) { ::operator delete(memory); }

/// Reports another version of libpng than the one compiled for.
[[noreturn]] void fail_version() { throw ImageError("libpng is not the one compiled for"); }

void append(png_structp writer, png_bytep bytes, std::size_t count) {
  static_cast<std::string*>(png_get_io_ptr(writer))->append(reinterpret_cast<const char*>(bytes), count);
}

void take(png_structp reader, png_bytep bytes, std::size_t count) {
  auto& left = *static_cast<std::string_view*>(png_get_io_ptr(reader));
  if (left.copy(reinterpret_cast<char*>(bytes), count) < count) fail(reader, "it ends within its data");
  left.remove_prefix(count);
}

/// Owns libpng's state.
class PngWriter {
 public:
  explicit PngWriter(std::string& text)
      : png_(png_create_write_struct_2(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore_warning, nullptr, allocate,
                                       release)) {
    if (!png_) fail_version();
    png_set_write_fn(png_, &text, append, [](png_structp) {});
  }
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  void write(int width, int height, const std::vector<std::uint8_t>& levels) {
    info_ = png_create_info_struct(png_);
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

/// Owns libpng's state.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes)
      : bytes_(bytes),
        png_(png_create_read_struct_2(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore_warning, nullptr, allocate,
                                      release)) {
    if (!png_) fail_version();
    png_set_read_fn(png_, &bytes_, take);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  Levels read(const std::function<void(int, int)>& accept) {
    info_ = png_create_info_struct(png_);
    png_read_info(png_, info_);
    Levels levels{int(png_get_image_width(png_, info_)), int(png_get_image_height(png_, info_)), 0, {}};
    accept(levels.width, levels.height);
    png_set_expand(png_);    // palettes and less than 8 bits; a transparent colour becomes alpha
    png_set_scale_16(png_);  // rounds; png_set_strip_16 would truncate
    png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    levels.channels = png_get_channels(png_, info_);
    const std::size_t stride = std::size_t(levels.width) * levels.channels;
    levels.values.resize(stride * std::size_t(levels.height));
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < std::size_t(levels.height); ++y) rows.push_back(&levels.values[y * stride]);
    png_read_image(png_, rows.data());
    return levels;
  }

 private:
  std::string_view bytes_;
  png_structp png_;
  png_infop info_ = nullptr;
};

}  // namespace

std::string png_text(int width, int height, const std::vector<std::uint8_t>& levels) {
  std::string text;
  PngWriter(text).write(width, height, levels);
  return text;
}

Levels decode_png(std::string_view bytes, const std::function<void(int, int)>& accept) {
  return PngReader(bytes).read(accept);
}

}  // namespace litfog::image
