// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/elliptical_beam.h"

#include <cmath>
#include <numbers>

#include "model/float_limit.h"
#include "model/require.h"
#include "photometry/darkness.h"

namespace litfog {
namespace {

using std::numbers::pi;

constexpr double kLeastAxis = 1e-100;  // radians: squares do not underflow
constexpr double kMostEdge = 1e-3;     // of a beam's width, the edge of a narrow one
constexpr int kAngles = 512;           // from the axis to a line, in steps of those between it and the line within
constexpr int kDarkAngles = 32;        // from there to 180 degrees
constexpr int kPlanes = 180;           // in a quarter turn
constexpr int kCircleSteps = 512;      // in a quarter turn

/// Angle from the axis of an ellipse's direction.
double angle_at(double horizontal, double vertical, double turn) {
  return horizontal * vertical / std::hypot(vertical * std::cos(turn), horizontal * std::sin(turn));
}

/// Intensities at increasing angles from the axis along one half plane.
void add_half_plane(const std::vector<IsocandelaEllipse>& ellipses, double turn, IntensityDistribution& beam) {
  auto line = ellipses.begin();  // the first that is not within the angle
  double inner_edge = 0, inner_intensity = line->intensity;
  double edge = angle_at(line->horizontal, line->vertical, turn);
  for (const double angle : beam.vertical) {
    while (line != ellipses.end() && angle > edge) {
      inner_edge = edge;
      inner_intensity = line->intensity;
      if (++line != ellipses.end()) edge = angle_at(line->horizontal, line->vertical, turn);
    }
    const bool is_dark = line == ellipses.end();
    const double t = (angle - inner_edge) / (edge - inner_edge);
    beam.intensity.push_back(is_dark ? 0 : std::lerp(inner_intensity, line->intensity, t));
  }
}

/// A quarter turn in steps that are dense where an ellipse's angle changes most.
std::vector<double> turns_of(const IsocandelaEllipse& ellipse) {
  std::vector<double> turns;
  for (int i = 0; i < kPlanes; ++i) {
    const double t = pi / 2 * i / kPlanes;
    turns.push_back(std::atan2(ellipse.vertical * std::sin(t), ellipse.horizontal * std::cos(t)));
  }
  turns.push_back(pi / 2);
  return turns;
}

}  // namespace

std::optional<ValueError> find_error(const std::vector<IsocandelaEllipse>& ellipses) {
  if (ellipses.empty()) return ValueError{"ellipses", 0, "must be at least one"};
  if (ellipses.front().intensity == 0) return ValueError{"intensity", 0, "must be > 0 in the first ellipse"};
  IsocandelaEllipse inner{kMaxIntensity, 0, 0};
  for (const IsocandelaEllipse& ellipse : ellipses) {
    const auto& [intensity, horizontal, vertical] = ellipse;
    if (!(intensity >= 0 && intensity <= inner.intensity)) {
      return ValueError{"intensity", intensity, "must be in [0, 1e30] and at most that of the ellipse within"};
    }
    if (!(horizontal > inner.horizontal && is_within(horizontal, kLeastAxis, pi))) {
      return ValueError{"horizontal", horizontal,
                        "must be in [1e-100, pi] and greater than that of the ellipse within"};
    }
    if (!(vertical > inner.vertical && is_within(vertical, kLeastAxis, pi))) {
      return ValueError{"vertical", vertical, "must be in [1e-100, pi] and greater than that of the ellipse within"};
    }
    inner = ellipse;
  }
  return std::nullopt;
}

IntensityDistribution elliptical_beam(const std::vector<IsocandelaEllipse>& ellipses) {
  require(find_error(ellipses));
  const IsocandelaEllipse& outermost = ellipses.back();
  IntensityDistribution beam{
      .type = PhotometryType::c, .horizontal = turns_of(outermost), .vertical = {}, .intensity = {}};
  beam.vertical.push_back(0);
  for (const auto& [intensity, horizontal, vertical] : ellipses) {
    const double width = std::min(std::max(horizontal, vertical), pi), inner = beam.vertical.back();
    for (int i = 1; i <= kAngles; ++i) {
      if (const double angle = width * i / kAngles; angle > inner) beam.vertical.push_back(angle);
    }
  }
  const double end = beam.vertical.back(), dark = end + std::min(kDarkEdge, kMostEdge * end);
  for (int i = 0; dark < pi && i <= kDarkAngles; ++i) {  // so that a profile does not continue in the beam's steps
    beam.vertical.push_back(std::lerp(dark, pi, double(i) / kDarkAngles));
  }
  for (const double turn : beam.horizontal) add_half_plane(ellipses, turn, beam);
  return beam;
}

double equal_circle(double horizontal, double vertical) {
  // 1 - cos of the circle is the mean of 1 - cos over the ellipse's turn, both as 2 sin^2 of half the angle; 1 + cos
  // likewise as 2 cos^2. Together they are exact at 0 and at pi.
  double sines = 0, cosines = 0;
  for (int i = 0; i < kCircleSteps; ++i) {
    const double half = angle_at(horizontal, vertical, pi / 2 * (i + 0.5) / kCircleSteps) / 2;
    const double sine = std::sin(half), cosine = std::cos(half);
    sines += sine * sine;
    cosines += cosine * cosine;
  }
  return 2 * std::atan2(std::sqrt(sines), std::sqrt(cosines));
}

}  // namespace litfog
