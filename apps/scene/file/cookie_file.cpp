// SPDX-License-Identifier: Apache-2.0
#include "scene/file/cookie_file.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>

#include "command/exit_status.h"

namespace litfog::scene {
namespace {

constexpr int kMaxSize = 4096;  // texels along an edge: 400 MB as floats

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw command::BadInput(path + ": " + what);
}

}  // namespace

Cookie read_cookie(const std::string& path) {
  const auto input = OIIO::ImageInput::open(path);
  if (!input) refuse(path, "cannot be read as an image: " + OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.nchannels != 1) refuse(path, "channels = " + std::to_string(spec.nchannels) + ": must be 1");
  if (spec.width < 1 || spec.width > kMaxSize || spec.height != 6 * spec.width) {
    refuse(path, "size = " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                     ": must be N x 6 N, six faces in a column, N at most " + std::to_string(kMaxSize));
  }
  Cookie cookie{.size = spec.width, .texels = {}};
  cookie.texels.resize(6 * std::size_t(cookie.size) * std::size_t(cookie.size));
  if (!input->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, cookie.texels.data())) {
    refuse(path, "cannot be read as an image: " + input->geterror());
  }
  if (!std::ranges::all_of(cookie.texels, [](float share) { return share >= 0 && share <= 1; })) {
    refuse(path, "texels: must be shares in [0, 1]");
  }
  return cookie;
}

}  // namespace litfog::scene
