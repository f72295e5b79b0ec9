// SPDX-License-Identifier: Apache-2.0
#include "bench/airlight_rival.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <complex>
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
        density_scale_(c.light.light.density_scale),
        density_(c.atmosphere.fog.density * density_scale_),
        air_(c.atmosphere),
        is_layered_(c.atmosphere.profile.count > 0),
        eye_height_(c.ray.origin.y),
        lamp_height_(c.light.position.y),
        slope_(c.ray.direction.y),
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

  /// The part of a stretch before the transmittance is 1e-4; with layers by the thinnest fog, and before 100 km.
  Stretch in_reach(const Stretch& stretch) const {
    constexpr double kDepth = 9.2, kFarPlane = 1e5;
    const double density =
        is_layered_ ? std::max(air_.thinnest_fog().density * density_scale_, kDepth / kFarPlane) : density_;
    return {stretch.low, std::min(stretch.high, (is_exp_ ? kDepth : std::sqrt(kDepth)) / density - approach_)};
  }

  /// The stretch inside the lamp's sphere and cone.
  Stretch lit() const {
    const double extent = compute_extent(attenuation_, threshold_);
    if (offset_ >= extent) return {0, 0};
    const double chord = std::sqrt((extent - offset_) * (extent + offset_));
    const Stretch cone = in_cone();
    return {std::max({-approach_, -chord, cone.low}), std::min({length_ - approach_, chord, cone.high})};
  }

  double opacity(double x) const {
    const double s = std::max(approach_ + x, 0.0);
    return formulas::opacity(depth(s, eye_height_, eye_height_ + slope_ * s));
  }

  /// Light that reaches a point of the ray and is scattered into the eye: the integrand without -f'(s).
  double source(double x) const {
    const double r = range(x);
    double value = formulas::attenuation(r, attenuation_.constant, attenuation_.linear, attenuation_.quadratic);
    if (value < threshold_) return 0;
    value *= formulas::litfog_cone_at(cone_.profile, (axis_offset_ + axis_slope_ * x) / r, cone_.x, cone_.y);
    if (is_fogged_) value *= std::exp(-depth(r, lamp_height_, eye_height_ + slope_ * (approach_ + x)));
    if (!is_isotropic(phase_)) value *= phase_at(phase_, -x / r);
    return value;
  }

 private:
  /// Optical depth of a line between two heights.
  double depth(double range, double height_a, double height_b) const {
    if (is_layered_) return air_.fog_between(height_a, height_b).density * density_scale_ * range;
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
  double density_scale_;
  double density_;
  const Atmosphere& air_;
  bool is_layered_;
  double eye_height_;
  double lamp_height_;
  double slope_;  // height per length of the ray
  bool is_exp_;
  bool is_fogged_;
  Phase phase_;
  double length_;
  double approach_;     // metres from the eye to the closest approach
  double offset_;       // metres from there to the lamp
  double axis_offset_;  // component of the offset along the cone's axis
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

/// E1(z), the integral of e^-t / t from z, for Re z >= 0: by its series near 0 and its continued fraction elsewhere
/// (Milton Abramowitz and Irene Stegun 1964, "Handbook of Mathematical Functions", 5.1.11 and 5.1.22, contracted).
std::complex<double> exponential_integral(std::complex<double> z) {
  constexpr int kMostTerms = 500;
  constexpr double kSmallest = 1e-17;
  if (std::abs(z) < 3) {
    std::complex<double> sum = -std::numbers::egamma - std::log(z), power = 1;
    for (int k = 1; k < kMostTerms && std::abs(power) > kSmallest; ++k) {
      power *= -z / double(k);
      sum -= power / double(k);
    }
    return sum;
  }
  // William Press et al. 2007, "Numerical Recipes", section 6.3: Lentz's method.
  std::complex<double> b = z + 1.0, d = 1.0 / b, value = d, c = 1e300;
  for (int k = 1; k < kMostTerms; ++k) {
    const double a = -double(k) * k;
    b += 2.0;
    d = 1.0 / (a * d + b);
    c = b + a / c;
    value *= c * d;
    if (std::abs(c * d - 1.0) < 1e-15) break;
  }
  return value * std::exp(-z);
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

double pegoraro_airlight(const test::AirlightCase& c) {
  const Ray ray(c);
  const auto [low, high] = ray.lit();
  const double h = ray.offset(), depth = ray.density() * h;
  // With v = (x + r) / h both legs are e^(-depth v), and dx / r^2 is 2 / h dv / (1 + v^2). 1 / (1 + v^2) is the
  // imaginary part of 1 / (v - i), whose integral with e^(-depth v) is an E1.
  const auto integral_from = [&](double x) {
    const double r = ray.range(x), v = x < 0 ? h / (r - x) : (x + r) / h;
    if (!std::isfinite(v)) return 0.0;
    return std::imag(std::polar(1.0, -depth) * exponential_integral(depth * std::complex<double>(v, -1)));
  };
  return 2 * ray.density() / (ray.quadratic() * h) * std::exp(-ray.density() * ray.approach()) *
         (integral_from(low) - integral_from(high));
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
