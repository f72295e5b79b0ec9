// SPDX-License-Identifier: Apache-2.0
#include "measure/scattering_walk.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "litfog/attenuation.h"
#include "litfog/cone.h"
#include "litfog/density_profile.h"
#include "model/parallel.h"
#include "model/phase_text.h"
#include "model/require.h"

namespace litfog::measure {
namespace {

using std::numbers::pi;
using Vector = glm::dvec3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastOffset = 1e-14;  // metres from lamp to leg; below, the angle at the lamp is a step

/// SplitMix64 (Guy Steele, Doug Lea and Christine Flood 2014, "Fast Splittable Pseudorandom Number Generators"): hashes
/// of a counter.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream) : counter_(mix(mix(seed) + stream)) {}
  /// A number in (0, 1).
  double unit() { return (double(mix(counter_ += 0x9E3779B97F4A7C15u) >> 12) + 0.5) * 0x1p-52; }

 private:
  static std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t counter_;
};

/// A unit vector perpendicular to an axis.
Vector across(const Vector& axis) {
  const Vector other = std::abs(axis.x) < 0.5 ? Vector(1, 0, 0) : Vector(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

/// A direction at an angle from an axis, at a random angle about it.
Vector turned(const Vector& axis, double cosine, double sine, Random& random) {
  const Vector u = across(axis);
  const Vector v = glm::cross(axis, u);
  const double around = 2 * pi * random.unit();
  return glm::normalize(axis * cosine + (u * std::cos(around) + v * std::sin(around)) * sine);
}

/// The phase function, and how to sample it.
class Scatterer {
 public:
  explicit Scatterer(const Phase& phase) : phase_(phase), packed_(phase_text::pack<double>(phase)) {
    for (std::size_t i = 0; i <= kCells; ++i) {
      const double x = double(i) / kCells;
      angle_[i] = pi * x * x * x * x;
    }
    double mean_cosine = 0;
    for (std::size_t i = 0; i < kCells; ++i) {
      const double width = angle_[i + 1] - angle_[i];
      double sum = 0;
      for (const auto& [node, weight] :
           {std::pair{0.1127016653792583, 5 / 18.}, {0.5, 8 / 18.}, {0.8872983346207417, 5 / 18.}}) {
        const double angle = angle_[i] + node * width;
        const double sine = std::sin(angle / 2);
        const double value = weight * phase_text::litfog_phase(packed_, 2 * sine * sine);
        sum += value;
        mean_cosine += value * width * std::sin(angle) * std::cos(angle) / 2;
      }
      below_[i + 1] = below_[i] + sum * width;
    }
    mean_cosine_ = mean_cosine;
    for (std::size_t i = 0; i < kCells; ++i) {
      const double above = below_[kCells] - (below_[i] + below_[i + 1]) / 2;
      towards_[i + 1] = towards_[i] + above * (angle_[i + 1] - angle_[i]);
    }
  }

  double mean_cosine() const { return mean_cosine_; }

  /// The phase function relative to isotropic.
  double value(double versine) const { return phase_text::litfog_phase(packed_, versine); }

  /// Draws a direction by the phase function.
  Vector draw(const Vector& direction, Random& random) const {
    const PhaseLobe& lobe = random.unit() < phase_.weight ? phase_.first : phase_.second;
    double cosine = 0;
    do {
      cosine = draw_henyey_greenstein(lobe.asymmetry, random.unit());
    } while (lobe.alpha > 0 && random.unit() * (1 + lobe.alpha) > 1 + lobe.alpha * cosine * cosine);
    return turned(direction, cosine, std::sqrt(std::max(0.0, 1 - cosine * cosine)), random);
  }

  /// The integral of the phase function over the angle, piecewise linear.
  double integral(double angle) const {
    const std::size_t i = cell(angle);
    return below_[i] + (below_[i + 1] - below_[i]) * (angle - angle_[i]) / (angle_[i + 1] - angle_[i]);
  }
  double integral_slope(double angle) const {
    const std::size_t i = cell(angle);
    return (below_[i + 1] - below_[i]) / (angle_[i + 1] - angle_[i]);
  }
  double angle_at_integral(double integral) const { return inverse(below_, integral); }

  /// Draws an angle from the direction to the lamp in proportion to single scattering from there, which is proportional
  /// to (integral(pi) - integral(angle)) / sine.
  double draw_towards(Random& random) const { return inverse(towards_, random.unit() * towards_[kCells]); }
  /// The density of draw_towards() over solid angle.
  double density_towards(double angle, double sine) const {
    const std::size_t i = cell(angle);
    return (towards_[i + 1] - towards_[i]) / ((angle_[i + 1] - angle_[i]) * towards_[kCells] * 2 * pi * sine);
  }

 private:
  static constexpr std::size_t kCells = 1024;
  using Table = std::array<double, kCells + 1>;

  /// Draws a cosine by Louis Henyey and Jesse Greenstein's function: its inverse.
  static double draw_henyey_greenstein(double g, double unit) {
    if (std::abs(g) < 1e-4) return 1 - 2 * unit + (unit - unit * unit) * 6 * g;
    const double x = (1 - g * g) / (1 - g + 2 * g * unit);
    return std::clamp((1 + g * g - x * x) / (2 * g), -1.0, 1.0);
  }
  std::size_t cell(double angle) const {
    std::size_t i = std::min(std::size_t(kCells * std::sqrt(std::sqrt(std::max(angle, 0.0) / pi))), kCells - 1);
    while (i > 0 && angle < angle_[i]) --i;
    while (i + 1 < kCells && angle >= angle_[i + 1]) ++i;
    return i;
  }
  double inverse(const Table& table, double value) const {
    const auto above = std::upper_bound(table.begin() + 1, table.end() - 1, value);
    const auto i = std::size_t(above - table.begin()) - 1;
    const double fraction = (value - table[i]) / (table[i + 1] - table[i]);
    return angle_[i] + (angle_[i + 1] - angle_[i]) * std::clamp(fraction, 0.0, 1.0);
  }

  Phase phase_;
  phase_text::PackedPhase<double> packed_;
  double mean_cosine_ = 0;
  Table angle_{}, below_{}, towards_{};
};

/// The density of the fog, and optical depths along straight lines.
struct Air {
  double uniform;  // 1/m
  DensityProfile layers;

  bool is_uniform() const { return layers.count == 0; }
  double density(double height) const { return is_uniform() ? uniform : uniform + profile_density_at(layers, height); }
  double depth(double height_a, double height_b, double length) const {
    if (is_uniform()) return uniform * length;
    return length * (uniform + mean_density(layers, height_a, height_b));
  }
  /// Optical depth of a line from a point; its length may be infinite.
  double depth_along(const Vector& from, const Vector& direction, double length) const {
    if (length < kInfinity) return depth(from.y, from.y + direction.y * length, length);
    if (uniform > 0) return kInfinity;
    return is_uniform() ? 0 : optical_depth_to_sky(layers, from.y, std::clamp(direction.y, -1.0, 1.0));
  }
  /// The length at which a line reaches an optical depth, which must exist: bracketed Newton's method.
  double length_at_depth(const Vector& from, const Vector& direction, double wanted) const {
    if (is_uniform()) return wanted / uniform;
    const auto depth_at = [&](double length) { return depth_along(from, direction, length); };
    double low = 0, high = 1 / (uniform + largest_density(layers));
    while (depth_at(high) < wanted) {
      low = high;
      high *= 2;
      if (!(high < 1e12)) return high;
    }
    double length = (low + high) / 2;
    for (int i = 0; i < 60; ++i) {
      const double miss = depth_at(length) - wanted;
      (miss < 0 ? low : high) = length;
      const double next = length - miss / density(from.y + direction.y * length);
      const double last = length;
      length = next > low && next < high ? next : (low + high) / 2;
      if (std::abs(length - last) <= 1e-14 * length) break;
    }
    return length;
  }
};

/// A straight line on which light is scattered, and the segment of it that the lamp lights.
struct Leg {
  Vector origin, direction;
  double length;       // metres, up to what it hits
  double approach;     // metres from the origin to the point nearest to the lamp
  double offset;       // metres from that point to the lamp
  Vector nearest;      // unit vector from the lamp to that point
  double first, last;  // lit segment, metres from that point; none unless first < last
  double angle() const { return std::atan2(offset, approach); }  // from the direction to the lamp
};

/// A point of a path.
struct Vertex {
  enum class Kind { fog, surface };
  Vector position;
  Vector direction;   // fog: of the incoming leg; surface: its normal
  double albedo = 1;  // of a surface
  Kind kind;
};

/// Sums over paths.
struct Sums {
  double first = 0, second = 0, higher = 0;
};

}  // namespace

/// The walk's fixed data and its steps.
class ScatteringPaths::Walk {
 public:
  Walk(const PlacedLight& placed, const Atmosphere& atmosphere, const Vector& eye, const Surroundings* surroundings)
      : position_(placed.position),
        axis_(placed.direction),
        law_(placed.light.attenuation),
        cone_(placed.light.cone),
        cos_cutoff_(std::cos(cutoff_angle(placed.light.cone))),
        extent_(compute_extent(law_, placed.light.threshold)),
        air_{atmosphere.fog.density * placed.light.density_scale,
             scaled(atmosphere.profile, placed.light.density_scale)},
        albedo_(atmosphere.albedo),
        scatterer_(atmosphere.phase),
        surroundings_(surroundings) {
    const double thickest = air_.uniform + (air_.is_uniform() ? 0 : largest_density(air_.layers));
    free_path_ = 1 / thickest;
    // There the law changes from inverse-square to flat.
    soft_ = std::max(std::min(compute_knee(law_), extent_),
                     law_.quadratic > 0 ? std::sqrt(law_.constant / law_.quadratic) : 0) /
            2;
    is_spot_ = !cone_.is_point_light();
    const double transport = 1 / (1 - scatterer_.mean_cosine());
    const Vector to_lamp = position_ - eye;
    const double depth = thickest * glm::length(to_lamp);
    is_endless_ = air_.is_uniform() && air_.uniform > 0 && albedo_ == 1 && !surroundings_;
    inner_ = free_path_ * std::max(8 + 6 * transport, depth + 4);
    drift_ = free_path_ * scatterer_.mean_cosine() * transport;
    const double transport_depth = depth / transport;
    plain_orders_ = (8 + transport_depth * transport_depth) * transport;
  }

  Leg leg_along(const EyeRay& ray) const { return leg_from(ray.origin, ray.direction, ray.length); }

  /// What is scattered once.
  void add_first(const Leg& eye_leg, Random& random, Sums& sums) const {
    if (!(eye_leg.first < eye_leg.last)) return;
    double density = 0;
    const double place = draw_on(eye_leg, random, density);
    sums.first += source(eye_leg, place) / density;
  }

  void add_path(const Leg& eye_leg, Random& random, Sums& sums) const {
    double weight = 0;
    const double length = draw_first_vertex(eye_leg, random, weight);
    if (!(weight > 0)) return;
    follow({.position = eye_leg.origin + eye_leg.direction * length,
            .direction = eye_leg.direction,
            .kind = Vertex::Kind::fog},
           weight, random, sums);
  }

  void add_path(const Vector& position, const Vector& normal, Random& random, Sums& sums) const {
    follow({.position = position, .direction = normal, .kind = Vertex::Kind::surface}, 1, random, sums);
  }

 private:
  /// Adds what a vertex and all that follow it send on of the light that reaches them over one more scattering.
  ///
  /// first_weight  least where scattered light counts most; paths end by what follows it alone
  void follow(Vertex vertex, double first_weight, Random& random, Sums& sums) const {
    if (albedo_ == 0) return;
    double weight = 1;
    for (int order = 1;; ++order) {
      weight *= vertex.kind == Vertex::Kind::fog ? albedo_ : vertex.albedo;
      if (!survives(weight, order, random)) return;
      add(sums, order, first_weight * weight * connect(vertex, random));
      Vector direction = draw_direction(vertex, order, random, weight);
      if (!(weight > 0)) return;
      for (;;) {
        const std::optional<Surroundings::Hit> hit = hit_from(vertex.position, direction);
        const double total = air_.depth_along(vertex.position, direction, hit ? hit->distance : kInfinity);
        const double depth = -std::log(random.unit());
        if (depth >= total) {
          if (!hit) return;
          assert(hit->albedo >= 0 && hit->albedo <= 1);
          vertex = {.position = vertex.position + direction * hit->distance,
                    .direction = hit->normal,
                    .albedo = hit->albedo,
                    .kind = Vertex::Kind::surface};
          add(sums, order, first_weight * weight * vertex.albedo * lit_surface(vertex));
          break;
        }
        const double free = air_.length_at_depth(vertex.position, direction, depth);
        vertex = {.position = vertex.position + direction * free, .direction = direction, .kind = Vertex::Kind::fog};
        if (!is_endless_ || !is_far(vertex)) break;
        if (!bring_back(vertex, direction, random)) return;
      }
    }
  }

  /// Adds a path with some vertices that is lit over one more scattering.
  static void add(Sums& sums, int vertices, double value) {
    if (vertices == 1) sums.second += value;
    sums.higher += value;
  }

  std::optional<Surroundings::Hit> hit_from(const Vector& origin, const Vector& direction) const {
    return surroundings_ ? surroundings_->nearest(origin, direction) : std::nullopt;
  }
  bool is_hidden(const Vector& position, bool is_on_surface) const {
    return surroundings_ && surroundings_->is_hidden(position_, position, is_on_surface);
  }

  /// A leg up to the first surface.
  Leg leg_from(const Vector& origin, const Vector& direction) const {
    const std::optional<Surroundings::Hit> hit = hit_from(origin, direction);
    return leg_from(origin, direction, hit ? hit->distance : kInfinity);
  }
  Leg leg_from(const Vector& origin, const Vector& direction, double length) const {
    Leg leg{};
    leg.origin = origin;
    leg.direction = direction;
    leg.length = length;
    const Vector to_lamp = position_ - origin;
    leg.approach = glm::dot(to_lamp, direction);
    const Vector away = leg.approach * direction - to_lamp;
    const double offset = glm::length(glm::cross(to_lamp, direction));
    leg.offset = std::max(offset, kLeastOffset);
    leg.nearest = offset > kLeastOffset ? away / glm::length(away) : across(direction);
    leg.first = -leg.approach;
    leg.last = leg.length - leg.approach;
    if (extent_ < kInfinity) {
      if (leg.offset >= extent_) return dark(leg);
      const double half = std::sqrt((extent_ - leg.offset) * (extent_ + leg.offset));
      leg.first = std::max(leg.first, -half);
      leg.last = std::min(leg.last, half);
    }
    if (is_spot_) clip_to_cone(leg);
    return leg;
  }
  static Leg dark(Leg leg) {
    leg.first = 0;
    leg.last = 0;
    return leg;
  }
  /// Limits the lit segment to the cone. In the plane of lamp and leg, the cosine from the axis is proportional to the
  /// cosine of an angle at the lamp.
  void clip_to_cone(Leg& leg) const {
    const double along = glm::dot(axis_, leg.direction), off = glm::dot(axis_, leg.nearest);
    const double size = std::hypot(along, off);
    if (cos_cutoff_ >= size) {
      leg = dark(leg);
      return;
    }
    if (cos_cutoff_ <= -size) return;
    const double middle = std::atan2(along, off), half = std::acos(cos_cutoff_ / size);
    double low = kInfinity, high = -kInfinity;
    for (const double turn : {-2 * pi, 0.0, 2 * pi}) {
      const double begin = std::max(middle - half + turn, -pi / 2), end = std::min(middle + half + turn, pi / 2);
      if (begin >= end) continue;
      low = std::min(low, begin);
      high = std::max(high, end);
    }
    if (!(low < high)) {
      leg = dark(leg);
      return;
    }
    if (low > -pi / 2) leg.first = std::max(leg.first, leg.offset * std::tan(low));
    if (high < pi / 2) leg.last = std::min(leg.last, leg.offset * std::tan(high));
  }

  /// Draws a position on the lit segment of a leg, by the angle at the lamp, which is the angle of scattering.
  double draw_on(const Leg& leg, Random& random, double& density) const {
    const double offset = soft_ > leg.offset && random.unit() < 0.5 ? soft_ : sharp_offset(leg);
    const double low = scatterer_.integral(std::atan2(offset, -leg.first));
    const double high = scatterer_.integral(std::atan2(offset, -leg.last));
    const double angle = scatterer_.angle_at_integral(low + (high - low) * random.unit());
    const double place = std::clamp(-offset / std::tan(angle), leg.first, leg.last);
    density = density_on(leg, place);
    return place;
  }
  double density_on(const Leg& leg, double place) const {
    if (!(place >= leg.first && place <= leg.last)) return 0;
    const double sharp = density_on(leg, place, sharp_offset(leg));
    return soft_ > leg.offset ? (sharp + density_on(leg, place, soft_)) / 2 : sharp;
  }
  /// The leg's offset, or a larger one if the lit segment is not near the lamp, so that angles keep their digits.
  static double sharp_offset(const Leg& leg) {
    return std::max(leg.offset, leg.first > 0 ? 0.1 * leg.first : -1e-6 * leg.last);
  }
  double density_on(const Leg& leg, double place, double offset) const {
    const double all =
        scatterer_.integral(std::atan2(offset, -leg.last)) - scatterer_.integral(std::atan2(offset, -leg.first));
    return scatterer_.integral_slope(std::atan2(offset, -place)) * offset / ((offset * offset + place * place) * all);
  }

  /// Light that is scattered once at a position on a leg, per metre.
  double source(const Leg& leg, double place) const {
    const double range = std::hypot(place, leg.offset);
    const double from_origin = place + leg.approach;
    if (!(range < 1e100) || !(from_origin >= 0)) return 0;
    double value = attenuation(range);
    if (is_spot_) {
      value *= cone_at(
          cone_, std::clamp(glm::dot(axis_, leg.nearest * leg.offset + leg.direction * place) / range, -1.0, 1.0));
    }
    if (value == 0 || is_hidden(leg.origin + leg.direction * from_origin, false)) return 0;
    const double versine = place < 0 ? leg.offset * leg.offset / (range * (range - place)) : 1 + place / range;
    const double height = leg.origin.y + leg.direction.y * from_origin;
    const double depth = air_.depth(leg.origin.y, height, from_origin) + air_.depth(height, position_.y, range);
    return value * air_.density(height) * std::exp(-depth) * scatterer_.value(std::min(versine, 2.0));
  }
  double attenuation(double range) const { return range > extent_ ? 0 : attenuation_at(law_, range); }

  /// Draws the first vertex on the eye's ray: by free paths, by the distance to the lamp, or by the angle at the lamp.
  double draw_first_vertex(const Leg& leg, Random& random, double& weight) const {
    const double total = air_.depth_along(leg.origin, leg.direction, leg.length);
    const double opacity = -std::expm1(-total);
    if (!(opacity > 0)) {
      weight = 0;
      return 0;
    }
    const double near_end = std::min(leg.length, std::hypot(leg.approach, leg.offset) + 4 * free_path_);
    const double begin = std::asinh(-leg.approach / leg.offset),
                 end = std::asinh((near_end - leg.approach) / leg.offset);
    const bool is_lit = leg.first < leg.last;
    const double by_free_path = 0.4, by_distance = is_lit ? 0.3 : 0.6, by_angle = is_lit ? 0.3 : 0;
    const double choice = random.unit();
    double length = 0;
    if (choice < by_free_path) {
      length = air_.length_at_depth(leg.origin, leg.direction, -std::log1p(-opacity * random.unit()));
      length = std::min(length, leg.length);
    } else if (choice < by_free_path + by_distance) {
      length = leg.approach + leg.offset * std::sinh(begin + (end - begin) * random.unit());
      length = std::clamp(length, 0.0, near_end);
    } else {
      double density = 0;
      length = std::max(0.0, draw_on(leg, random, density) + leg.approach);
    }
    if (!(length < 1e100)) {
      weight = 0;
      return 0;
    }
    const double place = length - leg.approach;
    const double height = leg.origin.y + leg.direction.y * length;
    const double wanted = air_.density(height) * std::exp(-air_.depth(leg.origin.y, height, length));
    double density = by_free_path * wanted / opacity;
    if (length <= near_end) density += by_distance / (std::hypot(place, leg.offset) * (end - begin));
    if (is_lit) density += by_angle * density_on(leg, place);
    weight = wanted / density;
    return length;
  }

  /// Phase function or reflection of a vertex into a direction, per steradian.
  double scattered(const Vertex& vertex, const Vector& direction) const {
    if (vertex.kind == Vertex::Kind::surface) return std::max(0.0, glm::dot(vertex.direction, direction)) / pi;
    const Vector difference = vertex.direction - direction;
    return scatterer_.value(glm::dot(difference, difference) / 2) / (4 * pi);
  }
  Vector draw_scattered(const Vertex& vertex, Random& random) const {
    if (vertex.kind == Vertex::Kind::fog) return scatterer_.draw(vertex.direction, random);
    const double square = random.unit();
    return turned(vertex.direction, std::sqrt(1 - square), std::sqrt(square), random);
  }
  Vector draw_towards(const Vector& position, Random& random) const {
    const double angle = scatterer_.draw_towards(random);
    return turned(glm::normalize(position_ - position), std::cos(angle), std::sin(angle), random);
  }

  /// Light that reaches a vertex over one more scattering: one sample over all of space.
  double connect(const Vertex& vertex, Random& random) const {
    const double range = glm::distance(vertex.position, position_);
    double chance = 1;
    if (air_.is_uniform() && range > 6 * free_path_) {
      chance = std::exp(-(range / free_path_ - 6) / 2);
      if (random.unit() >= chance) return 0;
    }
    const double into_beam = is_spot_ ? 0.4 : 0, towards = is_spot_ ? 0.3 : 0.5;
    const double scale = std::min(range, free_path_);
    const double beam = 2 * pi * (1 - cos_cutoff_);
    const double choice = random.unit();
    Leg leg{};
    double place = 0;
    if (choice < into_beam) {
      const double cosine = 1 - (1 - cos_cutoff_) * random.unit();
      const double unit = random.unit();
      const double from_lamp = scale * unit / (1 - unit);
      const Vector point =
          position_ + turned(axis_, cosine, std::sqrt(std::max(0.0, 1 - cosine * cosine)), random) * from_lamp;
      const Vector way = point - vertex.position;
      const double length = glm::length(way);
      if (!(length > 0)) return 0;
      leg = leg_from(vertex.position, way / length);
      if (length > leg.length) return 0;
      place = length - leg.approach;
    } else {
      const Vector direction =
          choice < into_beam + towards ? draw_towards(vertex.position, random) : draw_scattered(vertex, random);
      leg = leg_from(vertex.position, direction);
      if (!(leg.first < leg.last)) return 0;
      double density = 0;
      place = draw_on(leg, random, density);
    }
    const double phase = scattered(vertex, leg.direction);
    if (phase == 0) return 0;
    const double value = phase * source(leg, place);
    if (value == 0) return 0;
    double density =
        towards * scatterer_.density_towards(leg.angle(), leg.offset / range) + (1 - towards - into_beam) * phase;
    if (leg.first < leg.last)
      density *= density_on(leg, place);
    else
      density = 0;
    if (is_spot_) {
      const double from_lamp = std::hypot(place, leg.offset), length = place + leg.approach;
      const double radial = scale / ((scale + from_lamp) * (scale + from_lamp));
      density += into_beam * radial / (beam * from_lamp * from_lamp) * length * length;
    }
    return value / (density * chance);
  }

  /// Draws the next direction: by the phase function, and at first also towards the lamp. The fraction towards the lamp
  /// falls so that weights grow no faster than the square root of the order.
  Vector draw_direction(const Vertex& vertex, int order, Random& random, double& weight) const {
    const double towards = 0.5 / (order + 1);
    const Vector direction =
        random.unit() < towards ? draw_towards(vertex.position, random) : draw_scattered(vertex, random);
    const Vector to_lamp = position_ - vertex.position;
    const double sine = std::max(glm::length(glm::cross(to_lamp, direction)), 1e-300);
    const double angle = std::atan2(sine, glm::dot(to_lamp, direction));
    const double phase = scattered(vertex, direction);
    const double guided = scatterer_.density_towards(angle, std::max(sine / glm::length(to_lamp), 1e-300));
    weight *= phase / (towards * guided + (1 - towards) * phase);
    return direction;
  }

  /// Russian roulette. In endless fog, walks return ever more rarely, so the fraction followed falls with the order.
  bool survives(double& weight, int order, Random& random) const {
    double least = 1;
    if (order > plain_orders_) {
      least = std::pow(order / plain_orders_, 0.75) * std::exp(std::max(0.0, order / (50 * plain_orders_) - 1));
    }
    if (weight >= least / 4) return true;
    if (random.unit() * least >= weight) return false;
    weight = least;
    return true;
  }

  /// The mean position of a path from a vertex once its direction is forgotten, relative to the lamp.
  Vector forgotten(const Vertex& vertex) const { return vertex.position + vertex.direction * drift_ - position_; }
  bool is_far(const Vertex& vertex) const {
    const Vector from_lamp = vertex.position - position_;
    const Vector drifted = forgotten(vertex);
    const double far = 1.5 * inner_;
    return glm::dot(from_lamp, from_lamp) > far * far && glm::dot(drifted, drifted) > far * far;
  }
  /// A walk from a far point hits the inner sphere with probability inner / range, with a density proportional to the
  /// inverse cube of the distance from the far point (the exterior Poisson kernel).
  bool bring_back(Vertex& vertex, Vector& direction, Random& random) const {
    const Vector far = forgotten(vertex);
    const double range = glm::length(far);
    if (random.unit() * range >= inner_) return false;
    const double nearest = 1 / (range - inner_), farthest = 1 / (range + inner_);
    const double distance = 1 / (farthest + (nearest - farthest) * random.unit());
    const double cosine =
        std::clamp((range * range + inner_ * inner_ - distance * distance) / (2 * range * inner_), -1.0, 1.0);
    vertex.position = position_ + inner_ * turned(far / range, cosine, std::sqrt(1 - cosine * cosine), random);
    const double up = 2 * random.unit() - 1;
    direction = turned({0, 1, 0}, up, std::sqrt(1 - up * up), random);
    return true;
  }

  /// Radiance of a white surface lit by the lamp, in the unit of airlight.
  double lit_surface(const Vertex& vertex) const {
    const Vector from_lamp = vertex.position - position_;
    const double range = glm::length(from_lamp);
    const double cosine = -glm::dot(from_lamp, vertex.direction) / range;
    if (!(cosine > 0) || is_hidden(vertex.position, true)) return 0;
    return 4 / albedo_ * cosine * attenuation(range) *
           cone_at(cone_, std::clamp(glm::dot(axis_, from_lamp) / range, -1.0, 1.0)) *
           std::exp(-air_.depth(vertex.position.y, position_.y, range));
  }

  Vector position_, axis_;
  Attenuation law_;
  Cone cone_;
  double cos_cutoff_, extent_;
  Air air_;
  double albedo_;
  Scatterer scatterer_;
  const Surroundings* surroundings_;
  double free_path_ = 0, soft_ = 0;
  bool is_spot_ = false, is_endless_ = false;
  double inner_ = 0;         // radius of the sphere on which far paths come back, metres
  double drift_ = 0;         // mean distance, metres, that a path goes on in its direction before it forgets it
  double plain_orders_ = 0;  // orders followed without roulette
};

namespace {

Estimate estimate(const std::array<Sums, kScatteringBatches>& batches, double Sums::*member, double paths) {
  constexpr double count = kScatteringBatches;
  double sum = 0, squares = 0;
  for (const Sums& batch : batches) sum += batch.*member / paths;
  const double mean = sum / count;
  for (const Sums& batch : batches) squares += (batch.*member / paths - mean) * (batch.*member / paths - mean);
  return {mean, std::sqrt(squares / (count * (count - 1)))};
}

}  // namespace

ScatteringPaths::ScatteringPaths(const PlacedLight& light, const Atmosphere& atmosphere, const glm::dvec3& eye,
                                 const Surroundings* surroundings) {
  require(find_error(light));
  require(find_error(atmosphere));
  if (atmosphere.fog.mode != FogMode::exp) {
    require(ValueError{"fog.mode", double(atmosphere.fog.mode), "must be exp"});
  }
  if (!(atmosphere.fog.density <= std::numeric_limits<double>::max())) {
    require(ValueError{"fog.density", atmosphere.fog.density, "must be finite"});
  }
  walk_ = std::make_unique<const Walk>(light, atmosphere, eye, surroundings);
}
ScatteringPaths::~ScatteringPaths() = default;
ScatteringPaths::ScatteringPaths(ScatteringPaths&&) noexcept = default;
ScatteringPaths& ScatteringPaths::operator=(ScatteringPaths&&) noexcept = default;

double ScatteringPaths::scattered(const EyeRay& ray, std::uint64_t seed, std::uint64_t path) const {
  Random random(seed, path);
  Sums sums;
  walk_->add_path(walk_->leg_along(ray), random, sums);
  return sums.higher;
}

double ScatteringPaths::reflected(const glm::dvec3& position, const glm::dvec3& normal, std::uint64_t seed,
                                  std::uint64_t path) const {
  Random random(seed, path);
  Sums sums;
  walk_->add_path(position, normal, random, sums);
  return sums.higher;
}

ScatteredLight walk_scattering(const PlacedLight& light, const Atmosphere& atmosphere, const EyeRay& ray,
                               const ScatteringWalk& walk) {
  require(find_error(ray));
  if (walk.paths == 0) fail_count("paths", 0, "must be at least 1");
  const ScatteringPaths steps(light, atmosphere, ray.origin, walk.surroundings);
  const Leg eye_leg = steps.walk_->leg_along(ray);
  const std::uint64_t paths = (walk.paths + kScatteringBatches - 1) / kScatteringBatches;
  std::array<Sums, kScatteringBatches> batches;
  for_each_in_parallel(
      kScatteringBatches,
      [&](std::size_t batch) {
        Random random(walk.seed, batch);
        Sums sums;
        for (std::uint64_t i = 0; i < paths; ++i) {
          steps.walk_->add_first(eye_leg, random, sums);
          steps.walk_->add_path(eye_leg, random, sums);
        }
        batches[batch] = sums;
      },
      walk.threads);
  const auto of = [&](double Sums::*member) { return estimate(batches, member, double(paths)); };
  return {of(&Sums::first), of(&Sums::second), of(&Sums::higher)};
}

}  // namespace litfog::measure
