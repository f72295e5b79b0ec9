// SPDX-License-Identifier: Apache-2.0
#include "demo/sequence/animation.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string_view>

#include "command/program.h"

namespace litfog::demo {
namespace {

constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr const char* kRemedy = "install ffmpeg";

/// A number in the byte order of PNG.
std::string big_endian(std::uint32_t number, int bytes) {
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) text += char(number >> shift & 255);
  return text;
}

std::string chunk(std::string_view type, std::string_view data) {
  const std::string body = std::string(type) + std::string(data);
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()));
  return big_endian(std::uint32_t(data.size()), 4) + body + big_endian(std::uint32_t(sum), 4);
}

struct Chunk {
  std::string_view type;
  std::string_view data;
};

std::vector<Chunk> chunks_of(std::string_view png) {
  const auto expect = [](bool is_whole) {
    if (!is_whole) throw std::invalid_argument("frame: must be a PNG file");
  };
  expect(png.starts_with(kSignature));
  std::vector<Chunk> chunks;
  for (std::size_t at = kSignature.size(); at < png.size();) {
    expect(png.size() - at >= 12);
    std::uint32_t size = 0;
    for (const char byte : png.substr(at, 4)) size = size << 8 | static_cast<unsigned char>(byte);
    expect(png.size() - at - 12 >= size);
    chunks.push_back({png.substr(at + 4, 4), png.substr(at + 8, size)});
    at += 12 + size;
  }
  expect(!chunks.empty() && chunks.front().type == "IHDR" && chunks.front().data.size() == 13);
  return chunks;
}

}  // namespace

std::string animated_png(const std::vector<std::string>& frames, int frames_per_second) {
  std::string file(kSignature);
  std::uint32_t number = 0;  // fcTL and fdAT chunks so far
  for (const std::string& frame : frames) {
    const bool is_first = &frame == &frames.front();
    const std::vector<Chunk> chunks = chunks_of(frame);
    const std::string_view size = chunks.front().data.substr(0, 8);
    // At the picture's origin; each frame replaces the one before.
    const std::string control = std::string(size) + std::string(8, '\0') + big_endian(1, 2) +
                                big_endian(std::uint32_t(frames_per_second), 2) + std::string(2, '\0');
    bool has_control = false;
    for (const auto& [type, data] : chunks) {
      if (type == "IEND" || (type != "IDAT" && !is_first)) continue;
      if (type == "IDAT" && !has_control) {
        // Played without an end.
        if (is_first) file += chunk("acTL", big_endian(std::uint32_t(frames.size()), 4) + big_endian(0, 4));
        file += chunk("fcTL", big_endian(number++, 4) + control);
        has_control = true;
      }
      file +=
          type != "IDAT" || is_first ? chunk(type, data) : chunk("fdAT", big_endian(number++, 4) + std::string(data));
    }
  }
  return file + chunk("IEND", "");
}

bool is_film_path(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".mp4" || ending == ".webm";
}

void require_film_maker() { command::run_program({"ffmpeg", "-version"}, "", kRemedy); }

std::string film(const std::string& path, const std::vector<std::string>& frames, int frames_per_second) {
  const bool is_webm = std::filesystem::path(path).extension() == ".webm";
  std::vector<std::string> arguments{"ffmpeg",
                                     "-v",
                                     "error",
                                     "-f",
                                     "image2pipe",
                                     "-framerate",
                                     fmt::format("{}", frames_per_second),
                                     "-c:v",
                                     "png",
                                     "-i",
                                     "pipe:0",
                                     "-vf",
                                     "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                     "-pix_fmt",
                                     "yuv420p"};
  const std::vector<std::string> coding =
      is_webm ? std::vector<std::string>{"-c:v", "libvpx-vp9", "-b:v", "0", "-crf", "24", "-f", "webm"}
              : std::vector<std::string>{"-c:v", "libx264", "-crf", "16", "-f", "mp4"};
  arguments.insert(arguments.end(), coding.begin(), coding.end());
  arguments.insert(arguments.end(), {"-y", "/dev/stdout"});  // a file, in which ffmpeg can seek
  std::string input;
  for (const std::string& frame : frames) input += frame;
  return command::run_program(arguments, input, kRemedy);
}

}  // namespace litfog::demo
