// SPDX-License-Identifier: Apache-2.0
#include "drawing/glare.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "model/parallel.h"

namespace litfog::drawing {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// The components f0, f1 and f2 of Spencer et al. over angles in degrees, times their weights in bright light.
constexpr double kPeak = 0.384 * 2.61e6;   // f0, times exp(-(angle / kWidth)^2)
constexpr double kCubic = 0.478 * 20.91;   // f1, over (angle + kWidth)^3
constexpr double kSquare = 0.138 * 72.37;  // f2, over (angle + kWidth)^2
constexpr double kWidth = 0.02;            // degrees

double square(double x) { return x * x; }

/// f1 + f2.
double tails(double degrees) {
  const double x = degrees + kWidth;
  return (kCubic / x + kSquare) / (x * x);
}

/// The integral of x tails(x) from 0 to a radius in degrees.
double tails_within(double radius) {
  const double x = radius / kWidth;
  return kCubic / kWidth * square(x / (1 + x)) / 2 + kSquare * (std::log1p(x) - x / (1 + x));
}

/// f0 is a product of a Gaussian of x and one of y. Returns the integrals of one Gaussian over the pixels at a distance
/// of 0, 1, 2, ... from the light's pixel.
std::vector<double> peak_factors(std::size_t count, double pixel) {
  std::vector<double> factors(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double from = (double(i) - 0.5) * pixel / kWidth;
    factors[i] = kWidth * std::sqrt(std::numbers::pi) / 2 * (std::erf(from + pixel / kWidth) - std::erf(from));
  }
  return factors;
}

/// The tails' integral over the light's own pixel, in polar coordinates over an eighth of it.
///
/// pixel  width in degrees, as below
double tails_in_own_pixel(double pixel) {
  constexpr int kSteps = 64;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += tails_within(pixel / 2 / std::cos((i + 0.5) * std::numbers::pi / 4 / kSteps));
  return 2 * std::numbers::pi * sum / kSteps;
}

/// The tails' integral over a pixel at a distance of x and y pixels from the light's.
double tails_in_pixel(std::size_t x, std::size_t y, double pixel) {
  constexpr std::size_t kNear = 24;  // pixels; beyond, the tails are constant within a pixel
  const std::size_t steps = 1 + kNear / std::max(x, y);
  double sum = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    for (std::size_t k = 0; k < steps; ++k) {
      sum += tails(pixel * std::hypot(double(x) - 0.5 + (double(i) + 0.5) / double(steps),
                                      double(y) - 0.5 + (double(k) + 0.5) / double(steps)));
    }
  }
  return pixel * pixel * sum / double(steps * steps);
}

/// The fractions of a pixel's light that the eye spreads into the pixels to its right and below, rows first. Beyond 90
/// degrees is behind the eye.
std::vector<double> fractions(std::size_t width, std::size_t height, double pixel) {
  const std::vector<double> peak_x = peak_factors(width, pixel);
  const std::vector<double> peak_y = peak_factors(height, pixel);
  std::vector<double> result(width * height);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      if (pixel * std::hypot(double(x), double(y)) > 90) continue;
      const double tail = x == 0 && y == 0 ? tails_in_own_pixel(pixel) : tails_in_pixel(x, y, pixel);
      result[y * width + x] = square(kDegree) * (kPeak * peak_x[x] * peak_y[y] + tail);
    }
  }
  return result;
}

using Transform = Eigen::FFT<double>;
using Wave = std::complex<double>;

/// Calls work(transform, i) for i in [0, count) on all cores. Each thread reuses one transform, because its first call
/// makes tables.
template <typename Work>
void for_each_by_transform(std::size_t count, const Work& work) {
  constexpr std::size_t kTogether = 32;
  for_each_in_parallel((count + kTogether - 1) / kTogether, [&](std::size_t turn) {
    Transform transform({}, Transform::Flag(Transform::Unscaled | Transform::HalfSpectrum));
    const std::size_t end = std::min(count, (turn + 1) * kTogether);
    for (std::size_t i = turn * kTogether; i < end; ++i) work(transform, i);
  });
}

/// Replaces values, a step apart, by the spectrum of the values and their mirror image, which is real.
void transform_mirrored(Transform& transform, double* values, std::size_t count, std::size_t step) {
  std::vector<double> mirrored(2 * (count - 1));
  for (std::size_t i = 0; i < mirrored.size(); ++i) mirrored[i] = values[std::min(i, mirrored.size() - i) * step];
  std::vector<Wave> waves(count);
  transform.fwd(waves.data(), mirrored.data(), Eigen::Index(mirrored.size()));
  for (std::size_t i = 0; i < count; ++i) values[i * step] = waves[i].real();
}

/// The least even number, at least a side's pixels, whose double Eigen transforms quickly. With the double, glare that
/// leaves at one edge does not enter at the other.
std::size_t padded(int side) {
  for (auto size = std::size_t(side + side % 2);; size += 2) {
    std::size_t rest = size;
    for (const std::size_t factor : {2u, 3u, 5u}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return size;
  }
}

double spreading(float light) {
  return light > 0 && light < std::numeric_limits<float>::infinity() ? double(light) : 0;
}

}  // namespace

double eye_spread(double angle) {
  const double degrees = angle / kDegree;
  return kPeak * std::exp(-square(degrees / kWidth)) + tails(degrees);
}

render::Picture with_glare(const render::Picture& picture, double pixels_per_radian) {
  const auto width = std::size_t(picture.width);
  const auto height = std::size_t(picture.height);
  const std::size_t half_width = padded(picture.width);
  const std::size_t half_height = padded(picture.height);
  const std::size_t columns = half_width + 1;  // in the spectrum of a real picture
  const std::size_t rows = 2 * half_height;

  // Fractions are the same on all sides, so a quarter of them has the spectrum of all. In doubles: beside a lamp of 1e6
  // the rounding of floats would show as stripes. Light that stays in its pixel needs no transform.
  std::vector<double> factors = fractions(columns, half_height + 1, 1 / (kDegree * pixels_per_radian));
  const double staying = std::exchange(factors[0], 0);
  for_each_by_transform(half_height + 1, [&](Transform& transform, std::size_t y) {
    transform_mirrored(transform, &factors[y * columns], columns, 1);
  });
  for_each_by_transform(columns, [&](Transform& transform, std::size_t x) {
    transform_mirrored(transform, &factors[x], half_height + 1, columns);
  });

  const double scale = 1 / double(2 * half_width * rows);  // transforms there and back multiply by its inverse
  std::vector<Wave> spectrum(columns * height);            // spectra of rows; rows below the picture are black
  render::Picture seen = picture;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    for_each_by_transform(height, [&](Transform& transform, std::size_t y) {
      std::vector<double> row(2 * half_width);
      for (std::size_t x = 0; x < width; ++x) row[x] = scale * spreading(picture.rgb[3 * (y * width + x) + channel]);
      transform.fwd(&spectrum[y * columns], row.data(), Eigen::Index(row.size()));
    });
    for_each_by_transform(columns, [&](Transform& transform, std::size_t x) {
      std::vector<Wave> column(rows);
      std::vector<Wave> waves(rows);
      for (std::size_t y = 0; y < height; ++y) column[y] = spectrum[y * columns + x];
      transform.fwd(waves.data(), column.data(), Eigen::Index(rows));
      for (std::size_t y = 0; y < rows; ++y) waves[y] *= factors[std::min(y, rows - y) * columns + x];
      transform.inv(column.data(), waves.data(), Eigen::Index(rows));
      for (std::size_t y = 0; y < height; ++y) spectrum[y * columns + x] = column[y];
    });
    for_each_by_transform(height, [&](Transform& transform, std::size_t y) {
      std::vector<double> row(2 * half_width);
      transform.inv(row.data(), &spectrum[y * columns], Eigen::Index(row.size()));
      for (std::size_t x = 0; x < width; ++x) {
        float& light = seen.rgb[3 * (y * width + x) + channel];
        light = float(staying * double(light) + row[x]);
      }
    });
  }
  return seen;
}

}  // namespace litfog::drawing
