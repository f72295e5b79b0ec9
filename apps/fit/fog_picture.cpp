// SPDX-License-Identifier: Apache-2.0
#include "fit/light_pictures.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <new>
#include <vector>

#include "litfog/airlight.h"

namespace litfog::fit {
namespace {

constexpr double kEyeDistance = 30;     // metres from the beam
constexpr double kLampPosition = 0.15;  // fraction of the width, from the left
constexpr double kExposure = 16;        // 4 EV
constexpr int kGap = 2;                 // pixels between the views
constexpr int kViews = int(kFogPictureVisibilities.size());
constexpr int kRowPixels = kViews * kFogPictureWidth + (kViews - 1) * kGap;
constexpr int kChannels = 3;

/// Rays through the pixels of the upper half, rows from the top: the light at the origin shines to the right, and the
/// lower half mirrors the upper.
std::vector<EyeRay> rays_of_view() {
  constexpr double kMetresPerPixel = kFogPictureMetres / kFogPictureWidth;
  const double left = -kLampPosition * kFogPictureMetres;
  const glm::dvec3 eye{left + kFogPictureMetres / 2, 0, kEyeDistance};
  std::vector<EyeRay> rays;
  for (int y = 0; y < kFogPictureHeight / 2; ++y) {
    for (int x = 0; x < kFogPictureWidth; ++x) {
      const glm::dvec3 point{left + (x + 0.5) * kMetresPerPixel, (kFogPictureHeight / 2. - y - 0.5) * kMetresPerPixel,
                             0};
      rays.push_back({.origin = eye, .direction = glm::normalize(point - eye)});
    }
  }
  return rays;
}

std::uint16_t linear_level(double value) { return std::uint16_t(std::lround(65535 * std::clamp(value, 0.0, 1.0))); }

/// The PNG of linear pixels, which the library converts to sRGB.
std::string png_of(const std::vector<std::uint16_t>& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = kRowPixels;
  image.height = kFogPictureHeight;
  image.format = PNG_FORMAT_LINEAR_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string png(size, '\0');
  // With a valid picture and room for any PNG of its size, only memory can be short.
  if (png_image_write_to_memory(&image, png.data(), &size, 1, pixels.data(), 0, nullptr) == 0) throw std::bad_alloc();
  png.resize(size);
  return png;
}

}  // namespace

std::string draw_fog_picture(const Light& light) {
  const PlacedLight placed{.light = photometric(light), .position = {}, .direction = {1, 0, 0}};
  const std::vector<EyeRay> rays = rays_of_view();
  std::vector<double> airlights(rays.size());
  std::vector<std::uint16_t> pixels(std::size_t(kRowPixels) * kFogPictureHeight * kChannels, 65535);
  for (int view = 0; view < kViews; ++view) {
    const Fog fog = Fog::from_visibility(FogMode::exp, kFogPictureVisibilities[std::size_t(view)]);
    airlight(placed, {fog}, rays, LampLeg::fogged, airlights);
    for (int y = 0; y < kFogPictureHeight; ++y) {
      const int mirrored = std::min(y, kFogPictureHeight - 1 - y);
      for (int x = 0; x < kFogPictureWidth; ++x) {
        const double value = kExposure * kAirlightUnit * airlights[std::size_t(mirrored * kFogPictureWidth + x)];
        const int column = view * (kFogPictureWidth + kGap) + x;
        std::uint16_t* const pixel = &pixels[std::size_t((y * kRowPixels + column) * kChannels)];
        for (int i = 0; i < kChannels; ++i) pixel[i] = linear_level(value * placed.light.color[i]);
      }
    }
  }
  return png_of(pixels);
}

}  // namespace litfog::fit
