// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

// The range fit in scaled coordinates. Internal.

namespace litfog {

/// C, L R, Q R^2 for the unit of length R.
using Coefficients = std::array<double, 3>;

/// D at x.
inline double denominator(const Coefficients& q, double x) { return q[0] + x * (q[1] + x * q[2]); }

/// The cost of a residual z: z^2, but linear beyond the scale s. (Soft L1; s = infinity is plain least squares. Even,
/// and with a single inflection as a function of the denominator, on which the search relies.)
class Loss {
 public:
  explicit Loss(double scale = std::numeric_limits<double>::infinity());

  double scale() const { return scale_; }
  bool is_plain() const { return is_plain_; }  ///< plain z^2: the scale is infinite

  template <typename Real>
  Real value(Real z) const {
    return 2 * z * z / (1 + stretch(z));
  }
  template <typename Real>
  Real slope(Real z) const {
    return 2 * z / stretch(z);
  }
  template <typename Real>
  Real curvature(Real z) const {
    const Real s = stretch(z);
    return 2 / (s * s * s);
  }
  /// Derivative of sqrt(value) by |z|; 1 if value is z^2.
  double root_slope(double z) const {
    const double s = stretch(z);
    return std::sqrt((1 + s) / 2) / s;
  }
  /// The residual >= 0 with the cost `value`.
  double residual(double value) const { return std::sqrt(value + value / scale_ * (value / scale_) / 4); }
  /// The z up to which value(ln D - y) is convex in D: where curvature = slope.
  double convex_limit() const { return convex_limit_; }

 private:
  template <typename Real>
  Real stretch(Real z) const {
    using std::sqrt;
    if (is_plain_) return Real(1);
    return sqrt(1.0 + z / scale_ * (z / scale_));
  }

  double scale_;
  bool is_plain_;
  double convex_limit_;
};

/// Upper bound of C, as a fraction of 1/threshold, if an extent is given.
inline constexpr double kMaxConstantFraction = 1 - 0x1p-20;

/// Minimise sum w loss(y - ln max(1, D)), D = q0 + q1 x + q2 x^2, over q >= 0.
struct Falloff {
  struct Sample {
    double x;       ///< range in units of R
    long double y;  ///< -ln of the attenuation, >= 0
    double weight;  ///< > 0, at most 1
  };

  std::vector<Sample> samples;  ///< at least one, x ascending
  std::optional<double> constant = {};
  /// Extent: D is `top` at x = `end`.
  struct End {
    double x;
    long double top;
  };
  std::optional<End> end = {};
  Loss loss = Loss();
  /// False: samples darker than 1 are compared with -ln D even where D < 1, as the search needs.
  bool is_clamped = true;

  double weight_sum() const;
  /// The objective of mere rounding: residuals of 1e-12.
  double negligible() const { return 1e-24 * weight_sum(); }
  double objective(const Coefficients& q) const;
  /// Largest C that leaves an extent; only with an end and without a constant.
  double largest_constant() const { return kMaxConstantFraction * double(end->top); }
  /// Whether the clamp holds the sample's attenuation at 1, so that its residual has no slope. At D = 1 the slope is
  /// that from above, which is 0 for a sample with attenuation 1.
  template <typename Real>
  bool is_level(Real d, const Sample& sample) const {
    return (is_clamped || sample.y == 0) && (sample.y > 0 ? d < 1 : d <= 1);
  }
  /// ln of the attenuation minus the sample's.
  double residual(const Coefficients& q, const Sample& sample) const {
    const double d = denominator(q, sample.x);
    return double(sample.y) - (is_level(d, sample) ? 0 : std::log(d));
  }
};

/// A local minimum.
struct FalloffMinimum {
  Coefficients coefficients = {};
  double objective = 0;
  std::size_t iterations = 0;
};

/// The minimum of the weighted linear least squares of D a - 1, which is the residual to first order.
Coefficients linear_start(const Falloff& falloff);

/// A point near the local minimum that a start leads to, by damped Newton steps (Levenberg and Marquardt; Nocedal and
/// Wright, "Numerical Optimization", 2nd edition, 10.3).
///
/// tolerance  fraction of the objective: the last step lowers it by less
FalloffMinimum approach(const Falloff& falloff, const Coefficients& start, double tolerance);

/// The minimum to all digits: approach(), then Newton steps in extended precision.
FalloffMinimum descend(const Falloff& falloff, const Coefficients& start);

/// Covariance of the coefficients at a minimum, row by row, with the residuals' own variance; 0 for coefficients that a
/// bound holds against a slope. Nothing if the samples do not identify the others: a rank below their count at the
/// working precision, or no residual to spare.
std::optional<std::array<double, 9>> covariance_of(const Falloff& falloff, const Coefficients& q);

/// Largest violation of the optimality conditions. A coefficient's slope is divided by its value for residuals that are
/// all 1 with the same sign.
double kkt_residual(const Falloff& falloff, const Coefficients& q);

/// A minimum, and how far it is known to be global.
struct FalloffSearch {
  FalloffMinimum minimum;
  std::size_t boxes = 0;
  bool is_proven = false;  ///< no coefficients have an objective smaller by more than 1e-7 of it
};

/// The global minimum, from a local one, by branch and bound over boxes of coefficients.
FalloffSearch search(const Falloff& falloff, const FalloffMinimum& local);

}  // namespace litfog
