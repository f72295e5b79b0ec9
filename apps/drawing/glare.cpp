// SPDX-License-Identifier: Apache-2.0
#include "drawing/glare.h"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <mutex>
#include <new>
#include <numbers>
#include <utility>
#include <vector>

namespace litfog::drawing {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

// The components f0, f1 and f2 of Spencer et al. by angles in degrees, times their weights in bright light.
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

/// The integral of tails(x) x over x from 0 to a radius in degrees.
double tails_within(double radius) {
  const double x = radius / kWidth;
  return kCubic / kWidth * square(x / (1 + x)) / 2 + kSquare * (std::log1p(x) - x / (1 + x));
}

/// f0 is a product of a Gaussian of x and one of y. These are the integrals of one over the pixels that are 0, 1, 2 and
/// so on off the light's.
std::vector<double> peak_factors(std::size_t count, double pixel) {
  std::vector<double> factors(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double from = (double(i) - 0.5) * pixel / kWidth;
    factors[i] = kWidth * std::sqrt(std::numbers::pi) / 2 * (std::erf(from + pixel / kWidth) - std::erf(from));
  }
  return factors;
}

/// The tails' integral over the light's own pixel, by polar coordinates over an eighth of it.
///
/// pixel  its width in degrees, as below
double tails_in_own_pixel(double pixel) {
  constexpr int kSteps = 64;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) sum += tails_within(pixel / 2 / std::cos((i + 0.5) * std::numbers::pi / 4 / kSteps));
  return 2 * std::numbers::pi * sum / kSteps;
}

/// The tails' integral over a pixel that is so many pixels off the light's.
double tails_in_pixel(std::size_t x, std::size_t y, double pixel) {
  constexpr std::size_t kNear = 24;  // pixels, from which on the tails are even within one
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

/// The fractions of a pixel's light that the eye brings into the pixels to its right and below, rows first. What is
/// beyond 90 degrees is behind the eye.
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

/// A transform by FFTW, whose planner serves one thread at a time.
class Transform {
 public:
  template <typename Make>
  explicit Transform(Make make) {
    const std::lock_guard lock(planner());
    plan_ = make();
    if (!plan_) throw std::bad_alloc();
  }
  ~Transform() {
    const std::lock_guard lock(planner());
    fftw_destroy_plan(plan_);
  }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;

  void run() const { fftw_execute(plan_); }

 private:
  static std::mutex& planner() {
    static std::mutex mutex;
    return mutex;
  }

  fftw_plan plan_ = nullptr;
};

/// The least number of at least a side's pixels whose double FFTW transforms quickly. With the double, glare that
/// leaves at one edge does not come in at the other.
std::size_t padded(int side) {
  for (std::size_t size = std::size_t(side);; ++size) {
    std::size_t rest = size;
    for (const std::size_t factor : {2u, 3u, 5u, 7u}) {
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
  const std::size_t columns = half_width + 1;  // of a real picture's spectrum
  const std::size_t rows = 2 * half_height;

  // Fractions are the same on all sides, and so a quarter of them has the spectrum of all. In doubles: beside a lamp of
  // 1e6 the rounding of floats would show as stripes. What stays in its pixel needs no transform.
  std::vector<double> factors = fractions(columns, half_height + 1, 1 / (kDegree * pixels_per_radian));
  const double staying = std::exchange(factors[0], 0);
  Transform([&] {
    return fftw_plan_r2r_2d(int(half_height + 1), int(columns), factors.data(), factors.data(), FFTW_REDFT00,
                            FFTW_REDFT00, FFTW_ESTIMATE);
  }).run();
  for (double& factor : factors) factor /= double(2 * half_width * rows);  // FFTW's transforms there and back multiply

  std::vector<std::complex<double>> spectrum(columns * rows);
  const auto values = reinterpret_cast<double*>(spectrum.data());  // 2 * columns a row
  const auto frequencies = reinterpret_cast<fftw_complex*>(spectrum.data());
  const Transform forward(
      [&] { return fftw_plan_dft_r2c_2d(int(rows), int(2 * half_width), values, frequencies, FFTW_ESTIMATE); });
  const Transform back(
      [&] { return fftw_plan_dft_c2r_2d(int(rows), int(2 * half_width), frequencies, values, FFTW_ESTIMATE); });
  render::Picture seen = picture;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    std::ranges::fill(spectrum, std::complex<double>());
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        values[y * 2 * columns + x] = spreading(picture.rgb[3 * (y * width + x) + channel]);
      }
    }
    forward.run();
    for (std::size_t y = 0; y < rows; ++y) {
      const double* const row = &factors[std::min(y, rows - y) * columns];
      for (std::size_t x = 0; x < columns; ++x) spectrum[y * columns + x] *= row[x];
    }
    back.run();
    for (std::size_t y = 0; y < height; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        float& light = seen.rgb[3 * (y * width + x) + channel];
        light = float(staying * double(light) + values[y * 2 * columns + x]);
      }
    }
  }
  return seen;
}

}  // namespace litfog::drawing
