// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/intensity_distribution.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "model/float_limit.h"
#include "model/require.h"
#include "model/versine.h"
#include "photometry/angle_index.h"
#include "photometry/pole_coordinates.h"

namespace litfog {
namespace {

using std::numbers::pi;

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

/// The first of two or more angles that is beyond an angle, limited to the second up to the last one.
std::size_t first_beyond(std::span<const double> angles, double angle) {
  const std::size_t last = angles.size() - 1;
  // Measured angles are mostly even, so this guess is mostly right.
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

// --- integration ---

/// Weights of the trapezoidal rule: exact for values that are linear between the angles.
std::vector<double> trapezoidal_weights(std::span<const double> angles) {
  std::vector<double> weights(angles.size(), 0);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double half = (angles[i] - angles[i - 1]) / 2;
    weights[i - 1] += half;
    weights[i] += half;
  }
  return weights;
}

/// Weights for an integral times the sine of the angle from the pole: with half width w about the middle m, an
/// interval's two weights have the sum 2 sin m sin w and the difference 2 cos m (sin w / w - cos w).
std::vector<double> polar_weights(std::span<const double> angles, double pole) {
  std::vector<double> weights(angles.size(), 0);
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double half = (angles[i] - angles[i - 1]) / 2;
    const double middle = (angles[i] + angles[i - 1]) / 2 - pole;
    const double mean = std::sin(middle) * std::sin(half);
    const double skew = std::cos(middle) * mean_cosine_excess(half);
    weights[i - 1] += mean - skew;
    weights[i] += mean + skew;
  }
  return weights;
}

// --- checks ---

std::optional<ValueError> check_angles(const char* field, std::span<const double> angles, double low, double high) {
  if (angles.size() < 2) return ValueError{field, double(angles.size()), "must be at least two angles"};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (!is_within(angles[i], low - kAngleTolerance, high + kAngleTolerance)) {
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
    if (is_float_of(2 * pi / multiplicity, span)) return std::nullopt;
  }
  return ValueError{kField, span, "must span pi / 2, pi or 2 pi"};
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
  const double size = std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z);
  if (!(size > 0 && std::isfinite(size))) require(ValueError{"axis", size, "must be finite and not 0"});
  const glm::dvec3 forward = glm::normalize(axis / size);
  const bool is_upright = std::abs(forward.y) > 1 - 1e-12;
  const glm::dvec3 right = glm::normalize(glm::cross(forward, is_upright ? kPhotometricAxis : glm::dvec3{0, 1, 0}));
  return {right, glm::cross(right, forward), -forward};
}

std::optional<ValueError> find_error(const IntensityDistribution& distribution) {
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
  const auto is_wrong = [](double candela) { return !is_within(candela, 0, kMaxIntensity); };
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
  require(find_error(distribution));
  const auto& [type, horizontal, vertical, intensity] = distribution;
  std::vector<double> horizontal_weights, vertical_weights;
  if (type == PhotometryType::c) {
    vertical_weights = polar_weights(vertical, 0);
    horizontal_weights = horizontal.size() == 1 ? std::vector{2 * pi} : trapezoidal_weights(horizontal);
  } else {
    const bool is_a = type == PhotometryType::a;
    horizontal_weights = is_a ? trapezoidal_weights(horizontal) : polar_weights(horizontal, -pi / 2);
    vertical_weights = is_a ? polar_weights(vertical, -pi / 2) : trapezoidal_weights(vertical);
  }
  double flux = 0;
  for (std::size_t h = 0; h < horizontal.size(); ++h) {
    double plane = 0;
    for (std::size_t v = 0; v < vertical.size(); ++v) {
      plane += vertical_weights[v] * intensity[h * vertical.size() + v];
    }
    flux += horizontal_weights[h] * plane;
  }
  return measured_parts(distribution) * flux;
}

IntensityPeak find_peak(const IntensityDistribution& distribution) {
  require(find_error(distribution));
  const auto& [type, horizontal, vertical, intensity] = distribution;
  // A flat beam has its peak at thousands of angles. The cosine from the axis of each is a product of two of these.
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

}  // namespace litfog
