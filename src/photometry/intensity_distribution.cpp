// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/intensity_distribution.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "circle_sampler.h"
#include "dark_edge.h"
#include "darkness.h"
#include "measured_angles.h"
#include "pole_coordinates.h"
#include "require.h"

namespace litfog {
namespace {

using std::numbers::pi;

constexpr int kAxialSteps = 720;  // of a quarter degree, from an axis to its opposite
constexpr double kAxialStep = pi / kAxialSteps;
constexpr double kLeastAxialStep = kAxialStep / 25;
constexpr int kFineSteps = 100;  // of a finer grid, from the axis

double sum_of(const glm::dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

// --- the measured grid ---

/// The measured angle that a turn of type C mirrors to.
double folded_turn(std::span<const double> turn, double angle) {
  if (turn.size() == 1) return turn.front();
  double offset = angle - turn.front();
  if (std::abs(offset) >= 2 * pi) offset = std::fmod(offset, 2 * pi);
  if (offset < 0) offset += 2 * pi;
  const int multiplicity = turn_multiplicity(turn);
  if (multiplicity >= 2) offset = std::min(offset, 2 * pi - offset);
  if (multiplicity == 4) offset = std::min(offset, pi - offset);
  return std::min(turn.front() + offset, turn.back());
}

double folded(std::span<const double> angles, double angle) { return is_mirrored(angles) ? std::abs(angle) : angle; }

/// The measured angles on both sides of an angle.
struct Bracket {
  std::size_t low, high;
  double fraction;
};

/// The first of two or more angles that is beyond an angle, but neither the first nor beyond the last of all.
std::size_t first_beyond(std::span<const double> angles, double angle) {
  const std::size_t last = angles.size() - 1;
  // Measured angles are mostly even, so that this holds mostly.
  const double even = (angle - angles.front()) / (angles.back() - angles.front()) * double(last);
  const auto guess = std::size_t(std::clamp(even, 0.0, double(last - 1))) + 1;
  if ((guess == 1 || angles[guess - 1] <= angle) && (guess == last || angles[guess] > angle)) return guess;
  return std::size_t(std::upper_bound(angles.begin() + 1, angles.end() - 1, angle) - angles.begin());
}

std::optional<Bracket> locate(std::span<const double> angles, double angle) {
  if (angles.size() == 1) return Bracket{0, 0, 0};
  if (!(angle >= angles.front() - kAngleTolerance && angle <= angles.back() + kAngleTolerance)) return std::nullopt;
  const std::size_t high = first_beyond(angles, angle);
  const double fraction = (angle - angles[high - 1]) / (angles[high] - angles[high - 1]);
  return Bracket{high - 1, high, std::clamp(fraction, 0.0, 1.0)};
}

/// The mean over a turn of type C.
///
/// between  mean between plane i - 1 and plane i
template <typename Between>
double mean_of_parts(std::span<const double> turn, const Between& between) {
  double sum = 0;
  for (std::size_t i = 1; i < turn.size(); ++i) sum += (turn[i] - turn[i - 1]) * between(i);
  return sum / (turn.back() - turn.front());
}

/// Of what is linear between the planes.
template <typename InPlane>
double mean_over_turn(std::span<const double> turn, const InPlane& in_plane) {
  if (turn.size() == 1) return in_plane(0);
  return mean_of_parts(turn, [&](std::size_t i) { return std::midpoint(in_plane(i - 1), in_plane(i)); });
}

/// Of the square of what is linear between the planes.
template <typename InPlane>
double mean_square_over_turn(std::span<const double> turn, const InPlane& in_plane) {
  if (turn.size() == 1) return in_plane(0) * in_plane(0);
  return mean_of_parts(turn, [&](std::size_t i) {
    const double a = in_plane(i - 1), b = in_plane(i);
    return (a * a + a * b + b * b) / 3;
  });
}

// --- integration ---

/// Weights of the trapezoidal rule: the integral of what is linear between the angles.
std::vector<double> trapezoidal_weights(std::span<const double> angles) {
  std::vector<double> weights(angles.size(), 0);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double half = (angles[i] - angles[i - 1]) / 2;
    weights[i - 1] += half;
    weights[i] += half;
  }
  return weights;
}

/// The same for an integral times the sine of the angle from the pole: with half width w about the middle m, an
/// interval's two weights have the sum 2 sin m sin w and the difference 2 cos m (sin w / w - cos w).
std::vector<double> polar_weights(std::span<const double> angles, double pole) {
  std::vector<double> weights(angles.size(), 0);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double half = (angles[i] - angles[i - 1]) / 2;
    const double middle = (angles[i] + angles[i - 1]) / 2 - pole;
    const double mean = std::sin(middle) * std::sin(half);
    const double skew = std::cos(middle) * (std::sin(half) / half - std::cos(half));
    weights[i - 1] += mean - skew;
    weights[i] += mean + skew;
  }
  return weights;
}

// --- circles about an axis ---

bool is_own_axis(const IntensityDistribution& distribution, const glm::dvec3& axis) {
  return distribution.type == PhotometryType::c && (axis == kPhotometricAxis || axis == -kPhotometricAxis);
}

/// Circles about an axis: about the grid's own from its planes, about another by even steps of the turn.
class AxisCircles {
 public:
  AxisCircles(const IntensityDistribution& distribution, const glm::dvec3& axis)
      : distribution_(distribution), is_up_(axis == -kPhotometricAxis) {
    if (!is_own_axis(distribution, axis)) {
      sampler_.emplace(distribution, axis);
      return;
    }
    for (std::size_t v = 0; v < distribution.vertical.size(); ++v) is_lit_.push_back(is_row_lit(distribution, v));
  }

  Circle at(double angle) { return sampler_ ? sampler_->at(angle) : own_circle(angle); }

 private:
  /// All directions lie between the same two vertical angles.
  Circle own_circle(double angle) {
    const auto& [type, horizontal, vertical, intensity] = distribution_;
    const auto v = locate(vertical, is_up_ ? pi - angle : angle);
    if (!v || !(is_lit_[v->low] || is_lit_[v->high])) return {};
    values_.clear();
    for (std::size_t plane = 0; plane < horizontal.size(); ++plane) {
      const double* const row = &intensity[plane * vertical.size()];
      values_.push_back(std::lerp(row[v->low], row[v->high], v->fraction));
    }
    const double mean = mean_over_turn(horizontal, [this](std::size_t i) { return values_[i]; });
    if (angle == 0) return {mean, 0, 0};  // a single direction
    const auto [least, largest] = std::ranges::minmax(values_);
    const double reach = std::max({0.0, mean - least, largest - mean});
    if (reach == 0) return {mean, 0, 0};
    const auto fraction = [&](std::size_t i) { return (values_[i] - mean) / reach; };
    return {mean, reach, reach * std::sqrt(mean_square_over_turn(horizontal, fraction))};
  }

  const IntensityDistribution& distribution_;
  bool is_up_;
  std::optional<CircleSampler> sampler_ = std::nullopt;  // of circles about another axis
  std::vector<bool> is_lit_ = {};                        // the rows, of circles about the grid's own
  std::vector<double> values_ = {};
};

/// Appends angles from the last one to pi in the last step; where the last one is lit, the dark begins beside it.
void extend_to_pi(std::vector<double>& angles, bool is_last_lit) {
  const double last = angles.back();
  const double step = last - angles.rbegin()[1];
  if (is_last_lit && last + kDarkEdge < pi) angles.push_back(last + kDarkEdge);
  for (int i = 1; last + i * step < pi - step / 2; ++i) {
    if (last + i * step > angles.back()) angles.push_back(last + i * step);
  }
  if (angles.back() < pi) angles.push_back(pi);
}

double least_difference(std::span<const double> angles) {
  double least = kAxialStep;
  for (std::size_t i = 1; i < angles.size(); ++i) least = std::min(least, angles[i] - angles[i - 1]);
  return least;
}

/// From 0 to pi in quarters of a degree; of a finer grid, which a narrow beam has, in its own steps near the axis.
std::vector<double> axial_angles(const IntensityDistribution& distribution) {
  double step = least_difference(distribution.vertical);
  if (distribution.type != PhotometryType::c) step = std::min(step, least_difference(distribution.horizontal));
  step = std::max(step, kLeastAxialStep);
  std::vector<double> angles;
  for (int i = 0; step < kAxialStep && i < kFineSteps; ++i) angles.push_back(i * step);
  const double beyond = angles.empty() ? 0 : angles.back() + step / 2;
  for (int i = 0; i <= kAxialSteps; ++i) {
    if (const double angle = pi * i / kAxialSteps; angle >= beyond) angles.push_back(angle);
  }
  return angles;
}

/// A belt between two circles about an axis.
struct Belt {
  double angle;  ///< of its middle
  double weight;
};

/// Those on which a beam's asymmetry is measured.
std::vector<Belt> belts_of(const IntensityDistribution& distribution) {
  const std::vector<double> angles = axial_angles(distribution);
  std::vector<Belt> belts;
  for (std::size_t i = 0; i + 1 < angles.size(); i += 2) {  // one for two steps: half the profile's angles are enough
    const double low = angles[i], high = angles[std::min(i + 2, angles.size() - 1)];
    const double middle = std::midpoint(low, high);
    belts.push_back({middle, std::sin(middle) * (high - low)});
  }
  return belts;
}

/// Of a belt's part of the sphere, but for a factor.
struct SquareIntegrals {
  double total;      ///< of (intensity / peak)^2
  double deviation;  ///< of ((intensity - mean over the turn) / peak)^2
};

SquareIntegrals square_integrals(AxisCircles& circles, const Belt& belt, double peak) {
  const Circle circle = circles.at(belt.angle);
  const double mean = circle.mean / peak, deviation = circle.rms_deviation / peak;
  return {belt.weight * (mean * mean + deviation * deviation), belt.weight * deviation * deviation};
}

std::vector<double> supplements(std::vector<double> angles) {
  std::ranges::reverse(angles);
  for (double& angle : angles) angle = pi - angle;
  return angles;
}

std::vector<double> profile_angles(const IntensityDistribution& distribution, const glm::dvec3& axis) {
  if (!is_own_axis(distribution, axis)) return axial_angles(distribution);
  std::vector<double> angles = distribution.vertical;
  extend_to_pi(angles, is_row_lit(distribution, angles.size() - 1));
  if (angles.front() > 0) {
    angles = supplements(angles);
    extend_to_pi(angles, is_row_lit(distribution, 0));
    angles = supplements(angles);
  }
  return axis == kPhotometricAxis ? angles : supplements(angles);
}

// --- checks ---

std::optional<ValueError> check_angles(const char* field, std::span<const double> angles, double low, double high) {
  if (angles.size() < 2) return ValueError{field, double(angles.size()), "must be at least two angles"};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (!(angles[i] >= low - kAngleTolerance && angles[i] <= high + kAngleTolerance)) {
      return ValueError{field, angles[i], "must be within the range of its photometry type"};
    }
    if (i > 0 && !(angles[i] > angles[i - 1])) return ValueError{field, angles[i], "must be in increasing order"};
  }
  return std::nullopt;
}

std::optional<ValueError> check_turn(std::span<const double> turn) {
  constexpr const char* kField = "distribution.horizontal";
  if (turn.size() == 1 && std::isfinite(turn.front())) return std::nullopt;
  if (const auto error = check_angles(kField, turn, -2 * pi, 4 * pi)) return error;
  const double span = turn.back() - turn.front();
  for (const int multiplicity : {1, 2, 4}) {
    if (std::abs(span - 2 * pi / multiplicity) <= kAngleTolerance) return std::nullopt;
  }
  return ValueError{kField, span, "must span pi / 2, pi or 2 pi"};
}

void require_axis(const glm::dvec3& axis) {
  const double size = sum_of(axis);
  if (!(size > 0 && std::isfinite(size))) require(ValueError{"axis", size, "must be finite and not 0"});
}

}  // namespace

PhotometricAngles angles_of(PhotometryType type, const glm::dvec3& direction) {
  const auto [pole, ahead, aside] = pole_coordinates(type, direction);
  const double turn = std::atan2(aside, ahead), radius = std::hypot(ahead, aside);
  if (type == PhotometryType::c) return {turn, std::atan2(radius, pole)};
  const double rise = std::atan2(pole, radius);
  return type == PhotometryType::a ? PhotometricAngles{turn, rise} : PhotometricAngles{rise, turn};
}

glm::dvec3 direction_of(PhotometryType type, double horizontal, double vertical) {
  const double sin_h = std::sin(horizontal), cos_h = std::cos(horizontal);
  const double sin_v = std::sin(vertical), cos_v = std::cos(vertical);
  switch (type) {
    case PhotometryType::a:
      return {cos_v * sin_h, sin_v, -cos_v * cos_h};
    case PhotometryType::b:
      return {sin_h, cos_h * sin_v, -cos_h * cos_v};
    case PhotometryType::c:
      break;
  }
  return {sin_v * cos_h, sin_v * sin_h, -cos_v};
}

glm::dmat3 luminaire_from_light(const glm::dvec3& axis) {
  require_axis(axis);
  const glm::dvec3 forward = glm::normalize(axis / sum_of(axis));
  const bool is_upright = std::abs(forward.y) > 1 - 1e-12;
  const glm::dvec3 right = glm::normalize(glm::cross(forward, is_upright ? kPhotometricAxis : glm::dvec3{0, 1, 0}));
  return {right, glm::cross(right, forward), -forward};
}

std::optional<ValueError> check(const IntensityDistribution& distribution) {
  const auto& [type, horizontal, vertical, intensity] = distribution;
  const bool is_c = type == PhotometryType::c;
  const double vertical_limit = type == PhotometryType::a ? pi / 2 : pi;
  const double horizontal_limit = type == PhotometryType::a ? pi : pi / 2;
  if (auto error = is_c ? check_turn(horizontal)
                        : check_angles("distribution.horizontal", horizontal, -horizontal_limit, horizontal_limit)) {
    return error;
  }
  if (auto error = check_angles("distribution.vertical", vertical, is_c ? 0 : -vertical_limit, vertical_limit)) {
    return error;
  }
  constexpr const char* kField = "distribution.intensity";
  if (intensity.size() != horizontal.size() * vertical.size()) {
    return ValueError{kField, double(intensity.size()), "must be as many as pairs of angles"};
  }
  const auto is_wrong = [](double candela) { return !(candela >= 0 && candela <= kMaxIntensity); };
  std::int64_t wrong = 0;  // counted first, which compilers do several at a time
  for (const double candela : intensity) wrong += is_wrong(candela) ? 1 : 0;
  if (wrong > 0) {
    return ValueError{kField, *std::ranges::find_if(intensity, is_wrong), "must be in [0, 1e30]"};
  }
  if (std::ranges::all_of(intensity, [](double candela) { return candela == 0; })) {
    return ValueError{kField, 0, "must not be 0 everywhere"};
  }
  return std::nullopt;
}

double intensity_at(const IntensityDistribution& distribution, const glm::dvec3& direction) {
  const auto& [type, horizontal, vertical, intensity] = distribution;
  const bool is_c = type == PhotometryType::c;
  const PhotometricAngles angles = angles_of(type, direction);
  const auto v = locate(vertical, is_c ? angles.vertical : folded(vertical, angles.vertical));
  if (!v) return 0;
  const auto in_plane = [&, &grid = intensity, rows = vertical.size()](std::size_t plane) {
    return std::lerp(grid[plane * rows + v->low], grid[plane * rows + v->high], v->fraction);
  };
  if (horizontal.size() == 1) return in_plane(0);
  const bool is_on_pole = is_c && direction.x == 0 && direction.y == 0;  // the line where all planes meet
  if (is_on_pole) return mean_over_turn(horizontal, in_plane);
  const double turn = angles.horizontal;
  const auto h = locate(horizontal, is_c ? folded_turn(horizontal, turn) : folded(horizontal, turn));
  return h ? std::lerp(in_plane(h->low), in_plane(h->high), h->fraction) : 0;
}

double luminous_flux(const IntensityDistribution& distribution) {
  require(check(distribution));
  const auto& [type, horizontal, vertical, intensity] = distribution;
  std::vector<double> horizontal_weights, vertical_weights;
  double multiplicity = 1;
  if (type == PhotometryType::c) {
    vertical_weights = polar_weights(vertical, 0);
    if (horizontal.size() == 1) {
      horizontal_weights = {2 * pi};
    } else {
      horizontal_weights = trapezoidal_weights(horizontal);
      multiplicity = turn_multiplicity(horizontal);
    }
  } else {
    const bool is_a = type == PhotometryType::a;
    horizontal_weights = is_a ? trapezoidal_weights(horizontal) : polar_weights(horizontal, -pi / 2);
    vertical_weights = is_a ? polar_weights(vertical, -pi / 2) : trapezoidal_weights(vertical);
    multiplicity = (is_mirrored(horizontal) ? 2 : 1) * (is_mirrored(vertical) ? 2 : 1);
  }
  double flux = 0;
  for (std::size_t h = 0; h < horizontal.size(); ++h) {
    double plane = 0;
    for (std::size_t v = 0; v < vertical.size(); ++v) {
      plane += vertical_weights[v] * intensity[h * vertical.size() + v];
    }
    flux += horizontal_weights[h] * plane;
  }
  return multiplicity * flux;
}

IntensityPeak find_peak(const IntensityDistribution& distribution) {
  require(check(distribution));
  const auto& [type, horizontal, vertical, intensity] = distribution;
  // A flat beam has its peak at thousands of angles. The cosine of each from the axis is a product of two of these.
  std::vector<double> horizontal_cosines(horizontal.size(), 1), vertical_cosines;
  for (std::size_t h = 0; type != PhotometryType::c && h < horizontal.size(); ++h) {
    horizontal_cosines[h] = std::cos(horizontal[h]);
  }
  for (const double angle : vertical) vertical_cosines.push_back(std::cos(angle));
  double most = 0, most_cosine = 0;
  std::size_t peak_h = 0, peak_v = 0;
  const double* candela = intensity.data();
  for (std::size_t h = 0; h < horizontal.size(); ++h) {
    for (std::size_t v = 0; v < vertical.size(); ++v, ++candela) {
      if (*candela < most) continue;
      const double cosine = horizontal_cosines[h] * vertical_cosines[v];
      if (*candela == most && cosine <= most_cosine) continue;
      most = *candela;
      most_cosine = cosine;
      peak_h = h;
      peak_v = v;
    }
  }
  return {most, direction_of(type, horizontal[peak_h], vertical[peak_v])};
}

std::vector<AxialSample> axial_profile(const IntensityDistribution& distribution, const glm::dvec3& axis) {
  require(check(distribution));
  require_axis(axis);
  AxisCircles circles(distribution, axis);
  std::vector<AxialSample> profile;
  for (const double angle : profile_angles(distribution, axis)) {
    const Circle circle = circles.at(angle);
    profile.push_back({angle, circle.mean, circle.largest_deviation});
  }
  return profile;
}

std::vector<AxialSample> plane_profile(const IntensityDistribution& distribution, double turn, const glm::dvec3& axis) {
  require(check(distribution));
  require_axis(axis);
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
  if (!(fraction > 0 && fraction <= 1)) require(ValueError{"fraction", fraction, "must be in (0, 1]"});
  for (const AxialSample& sample : profile) {
    if (!is_finite_and_not_negative(sample.mean)) {
      require(ValueError{"profile.mean", sample.mean, "must be finite and >= 0"});
    }
  }
  const auto peak = std::ranges::max_element(profile, {}, &AxialSample::mean);
  const double level = fraction * peak->mean;
  const auto below = std::find_if(peak, profile.end(), [&](const AxialSample& s) { return s.mean < level; });
  if (below == profile.end()) return profile.back().angle;
  const AxialSample& above = below[-1];  // the peak itself is not below
  return std::lerp(above.angle, below->angle, (above.mean - level) / (above.mean - below->mean));
}

double asymmetry(const IntensityDistribution& distribution, const glm::dvec3& axis, double limit) {
  const double peak = find_peak(distribution).intensity;
  require_axis(axis);
  if (distribution.horizontal.size() == 1 && is_own_axis(distribution, axis)) return 0;
  const bool has_own_axis = distribution.type == PhotometryType::c;
  const glm::dvec3 total_axis = has_own_axis ? kPhotometricAxis : axis;
  const std::vector<Belt> belts = belts_of(distribution);
  std::optional<AxisCircles> circles(std::in_place, distribution, total_axis);
  double total = 0;
  std::vector<double> deviations;  // of the belts about that axis
  for (const Belt& belt : belts) {
    const auto [belt_total, belt_deviation] = square_integrals(*circles, belt, peak);
    total += belt_total;
    deviations.push_back(belt_deviation);
  }
  if (total == 0) return 0;
  const bool is_same = axis == total_axis;
  if (!is_same) circles.emplace(distribution, axis);
  double deviation = 0;
  for (std::size_t i = 0; i < belts.size() && deviation <= limit * limit * total; ++i) {
    deviation += is_same ? deviations[i] : square_integrals(*circles, belts[i], peak).deviation;
  }
  return std::min(1.0, std::sqrt(deviation / total));
}

}  // namespace litfog
