// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

namespace litfog::scene {

/// How a texture is sampled: wrapping beyond [0, 1], and filters.
struct Sampling {
  enum class Wrap { repeat, mirror, clamp };
  enum class Filter { linear, nearest };
  enum class Mipmaps { linear, nearest, none };

  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  Filter magnified = Filter::linear;
  Filter minified = Filter::linear;
  Mipmaps mipmaps = Mipmaps::linear;

  auto operator<=>(const Sampling&) const = default;
};

/// A picture, RGBA8. Row 0 is v = 0 and texel 0 of a row is u = 0 (OpenGL's upload order).
struct Texels {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  Sampling sampling = {};
};

/// A texel's level for a fraction; and for a linear value, as sRGB (IEC 61966-2-1). Both clamp to [0, 1].
std::uint8_t level_of(float fraction);
std::uint8_t srgb_level_of(float linear);

}  // namespace litfog::scene
