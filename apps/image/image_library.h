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

/// The levels of a picture file: interleaved channels, top row first. 1 or 2 channels are grey; with 2 or 4 the last
/// one is alpha, not premultiplied.
struct Levels {
  int width = 0;
  int height = 0;
  std::size_t channels = 0;
  std::vector<std::uint8_t> values;
};

/// Thrown for invalid picture bytes, or for what cannot be drawn.
struct ImageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The commands' interface to OpenImageIO. Colours are linear RGB, top row first.
class ImageLibrary {
 public:
  /// Decodes a JPEG picture.
  ///
  /// accept  called with width and height before memory is allocated; may throw
  /// throws  ImageError
  virtual Levels decode_jpeg(std::string_view bytes, const std::function<void(int, int)>& accept) const = 0;

  /// The bytes of an .exr file: half floats, or floats if asked for or if a number exceeds half floats. Equal pictures
  /// give equal files. Throws ImageError.
  virtual std::string exr_text(int width, int height, std::span<const float> rgb, bool in_floats) const = 0;

  /// Averages a picture to a smaller size. Throws ImageError.
  virtual std::vector<float> resized(int width, int height, std::span<const float> rgb, int new_width,
                                     int new_height) const = 0;

  /// Draws a text as in drawing/lettering.h. Throws ImageError if no font is found.
  virtual void draw_text(int width, int height, std::span<float> rgb, int left, int baseline, const std::string& text,
                         int size, std::span<const float, 3> ink) const = 0;

  /// The width of a text, pixels.
  virtual int text_width(const std::string& text, int size) const = 0;

 protected:
  ~ImageLibrary() = default;
};

/// The library, loaded by the first call: OpenImageIO brings some 250 libraries, which take longer to load than a small
/// picture takes to draw. May be called from any thread.
///
/// throws  command::MissingCapability if it is not installed, or one of these libraries is missing
const ImageLibrary& image_library();

}  // namespace litfog::image
