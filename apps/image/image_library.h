// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace litfog::image {

/// The levels of a picture in a file: channels beside each other, rows from the top. Of 1 or 2 channels it is grey; of
/// 2 and 4 the last is alpha, by which colours are not multiplied.
struct Levels {
  int width = 0;
  int height = 0;
  std::size_t channels = 0;
  std::vector<std::uint8_t> values;
};

/// What is wrong with a picture's bytes, or with what is to be drawn.
struct ImageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What OpenImageIO does for the commands. Colours are linear RGB, rows from the top.
class ImageLibrary {
 public:
  /// Decodes a JPEG picture.
  ///
  /// accept  is called with width and height before memory for the levels is taken; what it throws is passed on
  /// throws  ImageError
  virtual Levels decode_jpeg(std::string_view bytes, const std::function<void(int, int)>& accept) const = 0;

  /// The bytes of an .exr file: of half floats, or of floats where those are asked for or a number is beyond half
  /// floats. The same picture is the same file. Throws ImageError.
  virtual std::string exr_text(int width, int height, std::span<const float> rgb, bool in_floats) const = 0;

  /// Averaged to a smaller size. Throws ImageError.
  virtual std::vector<float> resized(int width, int height, std::span<const float> rgb, int new_width,
                                     int new_height) const = 0;

  /// Draws a text, as demo/lettering.h says. Throws ImageError where no font is found.
  virtual void draw_text(int width, int height, std::span<float> rgb, int left, int baseline, const std::string& text,
                         int size, std::span<const float, 3> ink) const = 0;

  /// Pixels.
  virtual int text_width(const std::string& text, int size) const = 0;

 protected:
  ~ImageLibrary() = default;
};

/// Loaded by the first call: OpenImageIO brings some 250 libraries, which take longer to load than a small picture
/// takes to draw. From any thread.
///
/// throws  command::MissingCapability where it is not installed, or one of those libraries is missing
const ImageLibrary& image_library();

}  // namespace litfog::image
