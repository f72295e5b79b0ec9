// SPDX-License-Identifier: Apache-2.0
#include "bench/airlight_rival.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "model/packed_cone.h"

namespace litfog::bench {
namespace {

/// A stretch of a ray: metres from the closest approach to the lamp.
struct Stretch {
  double low;
  double high;
};

/// A lamp and the fog, as a ray sees them.
class Ray {
 public:
  explicit Ray(const test::AirlightCase& c)
      : attenuation_(c.light.light.attenuation),
        threshold_(c.light.light.threshold),
        cone_(packed_cone<double>(c.light.light.cone)),
        density_(c.atmosphere.fog.density * c.light.light.density_scale),
        is_exp_(c.atmosphere.fog.mode == FogMode::exp),
        is_fogged_(c.lamp_leg == LampLeg::fogged),
        phase_(c.atmosphere.phase),
        length_(c.ray.length) {
    const glm::dvec3 to_light = c.light.position - c.ray.origin;
    approach_ = glm::dot(to_light, c.ray.direction);
    const glm::dvec3 offset = approach_ * c.ray.direction - to_light;
    offset_ = glm::length(offset);
    axis_offset_ = glm::dot(offset, c.light.direction);
    axis_slope_ = glm::dot(c.ray.direction, c.light.direction);
  }

  double approach() const { return approach_; }
  double offset() const { return offset_; }
  double density() const { return density_; }
  double quadratic() const { return attenuation_.quadratic; }
  double range(double x) const { return std::hypot(x, offset_); }

  Stretch all() const { return {-approach_, length_ - approach_}; }

  /// What of a stretch lies before the fog leaves 1e-4.
  Stretch in_reach(const Stretch& stretch) const {
    constexpr double kDepth = 9.2;
    return {stretch.low, std::min(stretch.high, (is_exp_ ? kDepth : std::sqrt(kDepth)) / density_ - approach_)};
  }

  /// Inside the lamp's sphere and cone.
  Stretch lit() const {
    const double extent = compute_extent(attenuation_, threshold_);
    if (offset_ >= extent) return {0, 0};
    const double chord = std::sqrt((extent - offset_) * (extent + offset_));
    const Stretch cone = in_cone();
    return {std::max({-approach_, -chord, cone.low}), std::min({length_ - approach_, chord, cone.high})};
  }

  double opacity(double x) const {
    const double s = std::max(approach_ + x, 0.0);
    return formulas::opacity(depth(s));
  }

  /// What reaches a point of the ray and is scattered into the eye: the integrand without -f'(s).
  double source(double x) const {
    const double r = range(x);
    double value = formulas::attenuation(r, attenuation_.constant, attenuation_.linear, attenuation_.quadratic);
    if (value < threshold_) return 0;
    value *= formulas::litfog_cone_at(cone_.profile, (axis_offset_ + axis_slope_ * x) / r, cone_.x, cone_.y);
    if (is_fogged_) value *= std::exp(-depth(r));
    if (!is_isotropic(phase_)) value *= phase_at(phase_, -x / r);
    return value;
  }

 private:
  double depth(double range) const {
    return is_exp_ ? formulas::depth_exp(range, density_) : formulas::depth_exp2(range, density_);
  }

  Stretch in_cone() const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const double cos_outer = cone_.x;
    if (!formulas::litfog_has_cone(cone_.profile) || cos_outer <= 0) return {-kInfinity, kInfinity};
    // Inside where (axis_offset + axis_slope x)^2 > cos^2 r^2, on the axis's side of the lamp.
    const double a = axis_slope_ * axis_slope_ - cos_outer * cos_outer;
    const double b = axis_offset_ * axis_slope_;
    const double c = axis_offset_ * axis_offset_ - cos_outer * cos_outer * offset_ * offset_;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) return {0, 0};
    const double first = (-b - std::copysign(std::sqrt(discriminant), a)) / a;
    const double last = (-b + std::copysign(std::sqrt(discriminant), a)) / a;
    if (a > 0) return axis_slope_ > 0 ? Stretch{last, kInfinity} : Stretch{-kInfinity, first};
    return axis_offset_ + axis_slope_ * (first + last) / 2 > 0 ? Stretch{first, last} : Stretch{0, 0};
  }

  Attenuation attenuation_;
  double threshold_;
  PackedCone<double> cone_;
  double density_;
  bool is_exp_;
  bool is_fogged_;
  Phase phase_;
  double length_;
  double approach_;     // metres from the eye to the closest approach
  double offset_;       // metres from there to the lamp
  double axis_offset_;  // the part of offset_ along the cone's axis
  double axis_slope_;   // cosine between ray and axis
};

double march(const Ray& ray, const Stretch& stretch, int steps) {
  if (!(stretch.high > stretch.low)) return 0;
  const double step = (stretch.high - stretch.low) / steps;
  double sum = 0;
  double before = ray.opacity(stretch.low);
  for (int i = 0; i < steps; ++i) {
    const double behind = ray.opacity(stretch.low + (i + 1) * step);
    sum += (behind - before) * ray.source(stretch.low + (i + 0.5) * step);
    before = behind;
  }
  return sum;
}

constexpr int kTexels = 256;
constexpr double kMaxU = 10;
constexpr double kMaxV = std::numbers::pi / 2;

}  // namespace

double march_airlight(const test::AirlightCase& c, int steps) {
  const Ray ray(c);
  return march(ray, ray.in_reach(ray.all()), steps);
}

double march_lit_airlight(const test::AirlightCase& c, int steps) {
  const Ray ray(c);
  return march(ray, ray.in_reach(ray.lit()), steps);
}

double arctangent_airlight(const test::AirlightCase& c) {
  const Ray ray(c);
  const auto [low, high] = ray.lit();
  const double angle = std::atan(high / ray.offset()) - std::atan(low / ray.offset());
  return ray.density() / (ray.quadratic() * ray.offset()) * angle;
}

SunTable::SunTable() {
  values_.reserve(kTexels * kTexels);
  for (int i = 0; i < kTexels; ++i) {
    const double u = kMaxU * i / (kTexels - 1);
    double sum = 0;
    for (int j = 0; j < kTexels; ++j) {
      values_.push_back(sum);
      const double v = kMaxV * j / (kTexels - 1);
      sum += boost::math::quadrature::gauss<double, 7>::integrate([u](double x) { return std::exp(-u * std::tan(x)); },
                                                                  v, v + kMaxV / (kTexels - 1));
    }
  }
}

double SunTable::at(double u, double v) const {
  const double column = std::clamp(u / kMaxU, 0.0, 1.0) * (kTexels - 1);
  const double row = std::clamp(v / kMaxV, 0.0, 1.0) * (kTexels - 1);
  const int i = std::min(int(column), kTexels - 2);
  const int j = std::min(int(row), kTexels - 2);
  const double* const corner = &values_[std::size_t(i * kTexels + j)];
  return std::lerp(std::lerp(corner[0], corner[1], row - j), std::lerp(corner[kTexels], corner[kTexels + 1], row - j),
                   column - i);
}

double SunTable::airlight(const test::AirlightCase& c) const {
  const Ray ray(c);
  const auto [low, high] = ray.lit();
  const double u = ray.density() * ray.offset();
  const auto angle = [&](double x) { return std::numbers::pi / 4 + std::atan(x / ray.offset()) / 2; };
  return 2 * ray.density() / (ray.quadratic() * ray.offset()) * std::exp(-ray.density() * ray.approach()) *
         (at(u, angle(high)) - at(u, angle(low)));
}

}  // namespace litfog::bench
