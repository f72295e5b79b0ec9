// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "litfog/photometry/intensity_distribution.h"
#include "reference/degree.h"
#include "reference/random_light.h"

namespace litfog::test {

using Angles = std::vector<double>;

inline Angles degrees(double first, double last, double step) {
  Angles angles;
  const int count = int(std::lround((last - first) / step));
  for (int i = 0; i <= count; ++i) angles.push_back((first + (last - first) * i / count) * kDegree);
  return angles;
}

/// A distribution that holds a function of its two angles.
inline IntensityDistribution sampled(PhotometryType type, const Angles& horizontal, const Angles& vertical,
                                     const std::function<double(double, double)>& intensity) {
  IntensityDistribution distribution{type, horizontal, vertical, {}};
  for (const double h : horizontal) {
    for (const double v : vertical) distribution.intensity.push_back(intensity(h, v));
  }
  return distribution;
}

/// The direction of two angles by rotations of the axis, as the goniophotometer turns: the header's formulas otherwise.
inline glm::dvec3 turned(PhotometryType type, double horizontal, double vertical) {
  const auto up = [](glm::dvec3 d, double a) {  // about the horizontal axis x
    return glm::dvec3{d.x, d.y * std::cos(a) - d.z * std::sin(a), d.y * std::sin(a) + d.z * std::cos(a)};
  };
  const auto right = [](glm::dvec3 d, double a) {  // about the vertical axis y, clockwise from above
    return glm::dvec3{d.x * std::cos(a) - d.z * std::sin(a), d.y, d.x * std::sin(a) + d.z * std::cos(a)};
  };
  const auto round = [](glm::dvec3 d, double a) {  // about the photometric axis, counterclockwise from behind the light
    return glm::dvec3{d.x * std::cos(a) - d.y * std::sin(a), d.x * std::sin(a) + d.y * std::cos(a), d.z};
  };
  switch (type) {
    case PhotometryType::a:
      return right(up({0, 0, -1}, vertical), horizontal);
    case PhotometryType::b:
      return up(right({0, 0, -1}, horizontal), vertical);
    case PhotometryType::c:
      break;
  }
  return round(right({0, 0, -1}, vertical), horizontal);
}

inline Angles random_angles(Random& random, double low, double high) {
  Angles angles{low, high};
  for (int i = 0; i < 6; ++i) angles.push_back(random.uniform(low, high));
  std::ranges::sort(angles);
  return angles;
}

}  // namespace litfog::test
