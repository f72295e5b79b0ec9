// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/animation.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <stdexcept>

#include "command/temporary_directory.h"
#include "drawing/picture_file.h"
#include "text/file_text.h"

namespace litfog::test {
namespace {

using demo::animated_png;

std::uint32_t number_at(const std::string& text, std::size_t at, int bytes = 4) {
  std::uint32_t number = 0;
  for (int i = 0; i < bytes; ++i) number = number * 256 + static_cast<unsigned char>(text.at(at + std::size_t(i)));
  return number;
}

struct Chunk {
  std::string type;
  std::string data;
};

/// All chunks of a file, their checksums tested.
std::vector<Chunk> chunks_of(const std::string& png) {
  std::vector<Chunk> chunks;
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  for (std::size_t at = 8; at < png.size();) {
    const std::uint32_t size = number_at(png, at);
    const std::string body = png.substr(at + 4, size + 4);
    EXPECT_EQ(number_at(png, at + 8 + size), crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
    chunks.push_back({body.substr(0, 4), body.substr(4)});
    at += size + 12;
  }
  return chunks;
}

/// The PNG file of one frame of an animation, as the chunks say it is.
std::string still(const std::vector<Chunk>& animation, std::uint32_t frame) {
  std::string file("\x89PNG\r\n\x1a\n");
  const auto add = [&file](const std::string& type, const std::string& data) {
    const std::string body = type + data;
    const auto sum = std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
    for (const std::uint32_t number : {std::uint32_t(data.size())}) {
      for (int shift = 24; shift >= 0; shift -= 8) file += char(number >> shift & 255);
    }
    file += body;
    for (int shift = 24; shift >= 0; shift -= 8) file += char(sum >> shift & 255);
  };
  std::uint32_t controls = 0;
  for (const auto& [type, data] : animation) {
    if (type == "fcTL") ++controls;
    if (type == "IDAT" && frame == 0) add("IDAT", data);
    if (type == "fdAT" && controls == frame + 1) add("IDAT", data.substr(4));
    if (type != "acTL" && type != "fcTL" && type != "fdAT" && type != "IDAT") add(type, data);
  }
  return file;
}

class Animation : public testing::Test {
 protected:
  /// The PNG of a picture of one colour in its left half.
  std::string frame(float red) const {
    render::Picture picture{64, 48, std::vector<float>(64 * 48 * 3, 0.25f)};
    for (std::size_t i = 0; i < picture.rgb.size(); i += 3) picture.rgb[i] = i / 3 % 64 < 32 ? red : 0.0f;
    const std::string path = (directory_.path() / "frame.png").string();
    drawing::write_picture(path, picture);
    return read_file_text(path, 1 << 20);
  }

  TemporaryDirectory directory_;
};

TEST_F(Animation, FramesOfAnAnimatedPngAreThePicturesToTheByte) {
  const std::vector<std::string> frames{frame(0), frame(0.5f), frame(1)};
  const std::vector<Chunk> chunks = chunks_of(animated_png(frames, 12));
  EXPECT_EQ(chunks.front().type, "IHDR");
  EXPECT_EQ(chunks.back().type, "IEND");
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(still(chunks, i), frames[i]) << i;
}

TEST_F(Animation, ChunksOfAnAnimatedPngAreNumberedAndStateItsPace) {
  std::uint32_t number = 0;
  std::size_t controls = 0;
  bool has_data = false;
  for (const auto& [type, data] : chunks_of(animated_png({frame(0), frame(1)}, 25))) {
    if (type == "acTL") {
      EXPECT_FALSE(has_data) << "acTL stands before IDAT";
      EXPECT_EQ(number_at(data, 0), 2u) << "frames";
      EXPECT_EQ(number_at(data, 4), 0u) << "without an end";
    }
    if (type == "fcTL") {
      ++controls;
      ASSERT_EQ(data.size(), 26u);
      EXPECT_EQ(number_at(data, 4), 64u);
      EXPECT_EQ(number_at(data, 8), 48u);
      EXPECT_EQ(number_at(data, 20, 2), 1u);
      EXPECT_EQ(number_at(data, 22, 2), 25u) << "of a second";
    }
    if (type == "fcTL" || type == "fdAT") {
      EXPECT_EQ(number_at(data, 0), number++);
    }
    if (type == "IDAT") has_data = true;
  }
  EXPECT_EQ(controls, 2u);
}

TEST_F(Animation, BrokenFramesAreErrors) {
  const std::string png = frame(0);
  for (const std::string& wrong : {std::string(), std::string("GIF89a"), png.substr(0, png.size() - 1), png + "x"}) {
    EXPECT_THROW(animated_png({wrong}, 12), std::invalid_argument);
  }
}

}  // namespace
}  // namespace litfog::test
