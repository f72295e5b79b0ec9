// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/axial_beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "model/float_limit.h"
#include "model/require.h"
#include "photometry/angle_index.h"
#include "photometry/circle_sampler.h"
#include "photometry/darkness.h"

namespace litfog {
namespace {

using std::numbers::pi;

constexpr int kAxialSteps = 720;  // of a quarter degree, from an axis to its opposite
constexpr double kAxialStep = pi / kAxialSteps;
constexpr double kMinAxialStep = kAxialStep / 25;
constexpr int kFineSteps = 100;  // steps of the finer grid, from the axis

bool is_own_axis(const IntensityDistribution& distribution, const glm::dvec3& axis) {
  return distribution.type == PhotometryType::c && (axis == kPhotometricAxis || axis == -kPhotometricAxis);
}

// --- angles of a profile ---

/// Appends angles from the last one to pi in the last step. If the last one is lit, the dark begins beside it.
void extend_to_pi(std::vector<double>& angles, bool is_last_lit) {
  const double last = angles.back();
  const double step = last - angles.rbegin()[1];
  if (is_last_lit && last + kDarkEdge < pi) angles.push_back(last + kDarkEdge);
  for (int i = 1; last + i * step < pi - step / 2; ++i) {
    if (last + i * step > angles.back()) angles.push_back(last + i * step);
  }
  if (angles.back() < pi) angles.push_back(pi);
}

std::vector<double> supplements(std::vector<double> angles) {
  std::ranges::reverse(angles);
  for (double& angle : angles) angle = pi - angle;
  return angles;
}

/// The measured angles and those beyond them.
std::vector<double> own_angles(const IntensityDistribution& distribution, bool is_up) {
  std::vector<double> angles = distribution.vertical;
  extend_to_pi(angles, is_row_lit(distribution, angles.size() - 1));
  if (angles.front() > 0) {
    angles = supplements(angles);
    extend_to_pi(angles, is_row_lit(distribution, 0));
    angles = supplements(angles);
  }
  return is_up ? supplements(angles) : angles;
}

double least_difference(std::span<const double> angles) {
  double least = kAxialStep;
  for (std::size_t i = 1; i < angles.size(); ++i) least = std::min(least, angles[i] - angles[i - 1]);
  return least;
}

/// Angles from 0 to pi in quarters of a degree; near the axis in the grid's own steps, if finer, as for a narrow beam.
std::vector<double> even_angles(const IntensityDistribution& distribution) {
  double step = least_difference(distribution.vertical);
  if (distribution.type != PhotometryType::c) step = std::min(step, least_difference(distribution.horizontal));
  step = std::max(step, kMinAxialStep);
  std::vector<double> angles;
  for (int i = 0; step < kAxialStep && i < kFineSteps; ++i) angles.push_back(i * step);
  const double beyond = angles.empty() ? 0 : angles.back() + step / 2;
  for (int i = 0; i <= kAxialSteps; ++i) {
    if (const double angle = pi * i / kAxialSteps; angle >= beyond) angles.push_back(angle);
  }
  return angles;
}

std::vector<double> profile_angles(const IntensityDistribution& distribution, const glm::dvec3& axis) {
  if (is_own_axis(distribution, axis)) return own_angles(distribution, axis != kPhotometricAxis);
  return even_angles(distribution);
}

// --- the grid's own axis ---

double row_mean(const IntensityDistribution& distribution, std::size_t row) {
  const auto& [type, horizontal, vertical, intensity] = distribution;
  return mean_over_turn(horizontal, [&, rows = vertical.size()](std::size_t plane) {
    return distribution.intensity[plane * rows + row];
  });
}

AxialSample own_sample(const IntensityDistribution& distribution, double angle, bool is_up) {
  const std::vector<double>& vertical = distribution.vertical;
  const double gamma = is_up ? pi - angle : angle;
  const auto measured = std::ranges::lower_bound(vertical, gamma - kAngleTolerance);
  if (measured == vertical.end() || *measured > gamma + kAngleTolerance) return {angle, 0, 0};
  const auto row = std::size_t(measured - vertical.begin());
  const double mean = row_mean(distribution, row);
  if (angle == 0) return {angle, mean, 0};  // a single direction
  double deviation = 0;
  for (std::size_t i = row; i < distribution.intensity.size(); i += vertical.size()) {
    deviation = std::max(deviation, std::abs(distribution.intensity[i] - mean));
  }
  return {angle, mean, deviation};
}

// --- integrals of squares ---

/// Integrals of (1 - t)^2, 2 (1 - t) t and t^2, each times the sine of the angle from the pole, over an interval of
/// that angle in which t runs from 0 to 1, by Gauss's rule of five points.
struct SquareWeights {
  double low = 0, both = 0, high = 0;

  SquareWeights(double from, double to) {
    constexpr std::array kNodes{0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640, -0.9061798459386640};
    constexpr std::array kWeights{0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                                  0.2369268850561891};
    const double half = (to - from) / 2;
    for (std::size_t i = 0; i < kNodes.size(); ++i) {
      const double t = (1 + kNodes[i]) / 2, weight = half * kWeights[i] * std::sin(std::lerp(from, to, t));
      low += weight * (1 - t) * (1 - t);
      both += weight * 2 * (1 - t) * t;
      high += weight * t * t;
    }
  }
};

const std::vector<double>& angles_from_pole(const IntensityDistribution& distribution) {
  return distribution.type == PhotometryType::b ? distribution.horizontal : distribution.vertical;
}

/// The integral over the sphere of ((intensity - mean) / unit)^2, interpolated.
///
/// means  one for each angle from the pole
double square_integral(const IntensityDistribution& distribution, double unit, std::span<const double> means) {
  const auto& [type, horizontal, vertical, intensity] = distribution;
  const bool is_b = type == PhotometryType::b;
  const std::vector<double>& turn = is_b ? vertical : horizontal;
  const std::vector<double>& rise = angles_from_pole(distribution);
  const std::size_t turn_stride = is_b ? 1 : vertical.size(), rise_stride = is_b ? vertical.size() : 1;
  const double pole = type == PhotometryType::c ? 0 : -pi / 2;
  std::vector<SquareWeights> weights;
  for (std::size_t r = 1; r < rise.size(); ++r) weights.emplace_back(rise[r - 1] - pole, rise[r] - pole);
  const auto interval = [&, &grid = intensity](std::size_t before, std::size_t after, double width) {
    const auto value = [&](std::size_t plane, std::size_t r) {
      return (grid[plane * turn_stride + r * rise_stride] - means[r]) / unit;
    };
    double sum = 0, a = value(before, 0), b = value(after, 0);
    for (std::size_t r = 1; r < rise.size(); ++r) {
      const double c = value(before, r), d = value(after, r);
      const auto& [low, both, high] = weights[r - 1];
      sum += low * 2 * (a * a + a * b + b * b) + both * (2 * a * c + a * d + b * c + 2 * b * d) +
             high * 2 * (c * c + c * d + d * d);
      a = c;
      b = d;
    }
    return width / 6 * sum;
  };
  if (turn.size() == 1) return interval(0, 0, 2 * pi);
  double integral = 0;
  for (std::size_t t = 1; t < turn.size(); ++t) integral += interval(t - 1, t, turn[t] - turn[t - 1]);
  return measured_parts(distribution) * integral;
}

double total_square(const IntensityDistribution& distribution, double unit) {
  return square_integral(distribution, unit, std::vector<double>(angles_from_pole(distribution).size(), 0));
}

double own_asymmetry(const IntensityDistribution& distribution, double unit) {
  if (distribution.horizontal.size() == 1) return 0;
  std::vector<double> means;
  for (std::size_t row = 0; row < distribution.vertical.size(); ++row) means.push_back(row_mean(distribution, row));
  return std::min(1.0, std::sqrt(square_integral(distribution, unit, means) / total_square(distribution, unit)));
}

}  // namespace

/// The circles of a profile about an axis other than the grid's own.
class AxialBeam::Circles {
 public:
  Circles(const IntensityDistribution& distribution, const glm::dvec3& axis)
      : sampler_(distribution, axis), angles_(even_angles(distribution)), taken_(angles_.size()) {}

  std::size_t count() const { return angles_.size(); }
  double angle(std::size_t i) const { return angles_[i]; }
  const Circle& at(std::size_t i) {
    if (!taken_[i]) taken_[i] = sampler_.at(angles_[i]);
    return *taken_[i];
  }

 private:
  CircleSampler sampler_;
  std::vector<double> angles_;
  std::vector<std::optional<Circle>> taken_;
};

AxialBeam::AxialBeam(const IntensityDistribution& distribution, const glm::dvec3& axis)
    : distribution_(&distribution), axis_(axis) {
  require(find_error(distribution));
  if (!is_own_axis(distribution, axis)) circles_ = std::make_unique<Circles>(distribution, axis);
}

AxialBeam::AxialBeam(AxialBeam&&) noexcept = default;
AxialBeam& AxialBeam::operator=(AxialBeam&&) noexcept = default;
AxialBeam::~AxialBeam() = default;

std::vector<AxialSample> AxialBeam::profile() {
  std::vector<AxialSample> profile;
  if (!circles_) {
    const bool is_up = axis_ != kPhotometricAxis;
    for (const double angle : own_angles(*distribution_, is_up)) {
      profile.push_back(own_sample(*distribution_, angle, is_up));
    }
    return profile;
  }
  for (std::size_t i = 0; i < circles_->count(); ++i) {
    const Circle& circle = circles_->at(i);
    profile.push_back({circles_->angle(i), circle.mean, circle.largest_deviation});
  }
  return profile;
}

double AxialBeam::asymmetry(double limit) {
  if (asymmetry_) return *asymmetry_;
  const double unit = std::ranges::max(distribution_->intensity);
  if (!circles_) return asymmetry_.emplace(own_asymmetry(*distribution_, unit));
  // Belts of two steps about every second circle, because half the profile's circles are enough.
  const double expected_total = std::isinf(limit) ? 1 : total_square(*distribution_, unit) / (2 * pi);
  const double end = limit * limit * expected_total;
  double total = 0, deviation = 0;
  for (std::size_t i = 1; i < circles_->count() && deviation <= end; i += 2) {
    const Circle& circle = circles_->at(i);
    const double width = circles_->angle(std::min(i + 1, circles_->count() - 1)) - circles_->angle(i - 1);
    const double area = std::sin(circles_->angle(i)) * width;
    const double mean = circle.mean / unit, rms_deviation = circle.rms_deviation / unit;
    total += area * (mean * mean + rms_deviation * rms_deviation);
    deviation += area * rms_deviation * rms_deviation;
  }
  if (deviation > end) return std::sqrt(deviation / expected_total);
  return asymmetry_.emplace(total == 0 ? 0 : std::min(1.0, std::sqrt(deviation / total)));
}

std::vector<AxialSample> plane_profile(const IntensityDistribution& distribution, double turn, const glm::dvec3& axis) {
  require(find_error(distribution));
  if (!std::isfinite(turn)) require(ValueError{"turn", turn, "must be finite"});
  const glm::dmat3 frame = luminaire_from_light(axis);
  std::vector<AxialSample> profile;
  for (const double angle : profile_angles(distribution, axis)) {
    profile.push_back({angle, intensity_at(distribution, frame * direction_of(PhotometryType::c, turn, angle)), 0});
  }
  return profile;
}

double half_angle(const std::vector<AxialSample>& profile, double fraction) {
  if (profile.empty()) require(ValueError{"profile", 0, "must have at least one sample"});
  if (!(fraction > 0 && is_within(fraction, 0, 1))) require(ValueError{"fraction", fraction, "must be in (0, 1]"});
  for (const AxialSample& sample : profile) {
    if (!is_finite_and_not_negative(sample.mean)) {
      require(ValueError{"profile.mean", sample.mean, "must be finite and >= 0"});
    }
  }
  const auto peak = std::ranges::max_element(profile, {}, &AxialSample::mean);
  const double level = snapped(fraction, 0, 1) * peak->mean;
  const auto below = std::find_if(peak, profile.end(), [&](const AxialSample& s) { return s.mean < level; });
  if (below == profile.end()) return profile.back().angle;
  const AxialSample& above = below[-1];  // the peak itself is not below
  return std::lerp(above.angle, below->angle, (above.mean - level) / (above.mean - below->mean));
}

}  // namespace litfog
