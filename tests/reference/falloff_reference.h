// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "litfog/fit/attenuation_fit.h"
#include "reference/digits50.h"
#include "reference/random_light.h"

// The range fit's reference, by other means than the fit's: from many random starts in every face (which of C, L, Q are
// not 0) by Levenberg-Marquardt in the logarithms of the coefficients, with differences for derivatives; then Newton
// steps to 50 digits from the best point, where the conditions of optimality are checked.

namespace litfog::test {

struct FalloffReference {
  std::array<Digits50, 3> coefficients;  ///< C, L, Q
  Digits50 objective = 0;
  bool is_certified = false;  ///< slopes 0 to 1e-40 of their terms, and >= 0 where a coefficient is 0
};

class FalloffReferenceSearch {
 public:
  /// loss_scale  of the robust loss; infinity for squares
  FalloffReferenceSearch(const AttenuationTarget& target, double loss_scale) : target_(target), scale_(loss_scale) {
    std::erase_if(target_.samples, [](const AttenuationSample& sample) { return sample.weight == 0; });
    for (std::size_t j = 0; j < 3; ++j) {
      unit_[j] = std::numeric_limits<double>::infinity();
      for (const auto& [range, attenuation, weight] : target_.samples) {
        const double power = std::pow(range, double(j));
        if (power > 0) unit_[j] = std::min(unit_[j], 1 / attenuation / power);
      }
    }
  }

  template <typename Real>
  Real objective(const std::array<Real, 3>& q) const {
    Real sum = 0;
    for (const AttenuationSample& sample : target_.samples) {
      const Real root = root_of_cost(q, sample);
      sum += root * root;
    }
    return sum;
  }

  /// The best of `starts` descents in each face.
  std::array<double, 3> explore(Random& random, int starts) const {
    std::array<double, 3> best{};
    double least = std::numeric_limits<double>::infinity();
    for (unsigned face = 0; face < 8; ++face) {
      const bool has_constant = (face & 1) != 0;
      if (target_.constant ? has_constant || (face == 0 && target_.extent) : face == 0) continue;
      if (target_.extent && !target_.constant && face == 1) continue;  // constant attenuation has no extent
      for (int i = 0; i < (face == 0 ? 1 : starts); ++i) {
        const auto q = descend(face, random);
        const double value = objective(q);
        if (value < least * (1 - 1e-9) - 1e-26) {
          least = value;
          best = q;
        }
      }
    }
    return best;
  }

  /// The least objective of attenuations with the target's extent, on a grid of constants and of linear terms' shares.
  /// Without an extent, of those that meet one sample by one term.
  double least_on_grid() const {
    if (!target_.extent) return least_of_one_term();
    const double extent = *target_.extent, top = 1 / target_.threshold, largest = (1 - 0x1p-20) * top;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= (target_.constant ? 0 : 200); ++i) {  // evenly, then ever nearer to the largest
      const double fraction = i < 100 ? i / 100.0 : i < 200 ? -std::expm1((99 - i) / 7.0) : 1;
      const double constant = target_.constant.value_or(largest * fraction), rest = top - constant;
      for (const double share : {0.0, 1e-9, 1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1.0}) {
        const std::array q{constant, rest * share / extent, rest * (1 - share) / extent / extent};
        least = std::min(least, objective(q));
      }
    }
    return least;
  }

  /// The optimum in the face of a point near it.
  FalloffReference certify(const std::array<double, 3>& near) const {
    std::array<Digits50, 3> q{near[0], near[1], near[2]};
    std::vector<std::size_t> moving;
    for (std::size_t j = target_.constant ? 1 : 0; j < 3; ++j) {
      // What logarithms leave where the optimum is 0; the slopes below show whether it is.
      double largest_fraction = 0;
      for (const AttenuationSample& sample : target_.samples) {
        const double r = sample.range, d = near[0] + r * near[1] + r * r * near[2];
        largest_fraction = std::max(largest_fraction, near[j] * power(r, j) / std::max(1.0, d));
      }
      if (largest_fraction > 1e-6) {
        moving.push_back(j);
      } else {
        q[j] = 0;
      }
    }
    Digits50 multiplier = 0;
    for (int i = 0; i < 40 && !moving.empty(); ++i) {
      if (newton_step(moving, q, multiplier) < 1e-45) break;
    }
    FalloffReference result{q, objective(q), true};
    const auto [slope, size, curvature] = slopes(q);
    for (std::size_t j = target_.constant ? 1 : 0; j < 3; ++j) {
      const Digits50 at_end = target_.extent ? multiplier * power(Digits50(*target_.extent), j) : Digits50(0);
      const Digits50 left = (slope[j] - at_end) / (size[j] + abs(at_end) + Digits50("1e-300"));
      const bool is_moving = std::find(moving.begin(), moving.end(), j) != moving.end();
      if (is_moving ? !(abs(left) < 1e-40) || !(q[j] > 0) : !(left > -1e-40)) result.is_certified = false;
    }
    return result;
  }

 private:
  double least_of_one_term() const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [range, attenuation, weight] : target_.samples) {
      for (std::size_t j = target_.constant ? 1 : 0; j < 3; ++j) {
        std::array q{target_.constant.value_or(0), 0.0, 0.0};
        const double unit = power(range, j);
        if (unit > 0) q[j] = std::max(0.0, 1 / attenuation - q[0]) / unit;
        least = std::min(least, objective(q));
      }
    }
    return least;
  }

  template <typename Real>
  static Real power(const Real& x, std::size_t j) {
    return j == 0 ? Real(1) : j == 1 ? x : Real(x * x);
  }

  template <typename Real>
  Real root_of_cost(const std::array<Real, 3>& q, const AttenuationSample& sample) const {
    using std::log, std::sqrt;
    const Real r = sample.range, d = q[0] + r * q[1] + r * r * q[2];
    const Real z = (d > 1 ? Real(log(d)) : Real(0)) + Real(log(Real(sample.attenuation)));
    const Real root = z * Real(sqrt(Real(sample.weight)));
    if (std::isinf(scale_)) return root;
    const Real u = z / scale_;
    return root * Real(sqrt(Real(2 / (1 + Real(sqrt(Real(1 + u * u)))))));
  }

  /// Coefficients from the logarithms of those of a face: in units of the sample that they would meet alone or, with an
  /// extent, as fractions of what is left there.
  std::array<double, 3> from_logs(unsigned face, const Eigen::Vector3d& logs) const {
    std::array<double, 3> q{target_.constant.value_or(0), 0, 0};
    double sum = 0;
    for (std::size_t j = 0; j < 3; ++j) sum += (face >> j & 1) != 0 ? std::exp(logs[Eigen::Index(j)]) : 0;
    for (std::size_t j = 0; j < 3; ++j) {
      if ((face >> j & 1) == 0) continue;
      const double part = std::exp(logs[Eigen::Index(j)]);
      q[j] = target_.extent
                 ? part / sum * (1 / target_.threshold - target_.constant.value_or(0)) / power(*target_.extent, j)
                 : part * unit_[j];
    }
    return q;
  }

  std::array<double, 3> descend(unsigned face, Random& random) const {
    Eigen::Vector3d logs(random.uniform(-8, 1), random.uniform(-8, 1), random.uniform(-8, 1));
    const auto count = Eigen::Index(target_.samples.size());
    const auto residuals_at = [&](const Eigen::Vector3d& at) {
      Eigen::VectorXd residuals(count);
      const auto q = from_logs(face, at);
      for (Eigen::Index i = 0; i < count; ++i) residuals[i] = root_of_cost(q, target_.samples[std::size_t(i)]);
      return residuals;
    };
    Eigen::VectorXd residuals = residuals_at(logs);
    double damping = 1e-2;
    for (int i = 0; i < 100 && damping < 1e12; ++i) {
      Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(count, 3);
      for (Eigen::Index j = 0; j < 3; ++j) {
        if ((face >> j & 1) == 0) continue;
        const Eigen::Vector3d change = 1e-6 * Eigen::Vector3d::Unit(j);
        jacobian.col(j) = (residuals_at(logs + change) - residuals_at(logs - change)) / 2e-6;
      }
      const Eigen::Matrix3d normal = jacobian.transpose() * jacobian;
      const Eigen::Vector3d slope = jacobian.transpose() * residuals;
      bool has_moved = false;
      for (; damping < 1e12 && !has_moved; damping *= 8) {
        Eigen::Matrix3d damped = normal;
        damped.diagonal() *= 1 + damping;
        damped.diagonal().array() += 1e-30;
        const Eigen::Vector3d next = (logs - damped.ldlt().solve(slope)).cwiseMax(-300).cwiseMin(50);
        const Eigen::VectorXd there = residuals_at(next);
        if (!(there.squaredNorm() < residuals.squaredNorm())) continue;
        has_moved = true;
        const bool is_done = there.squaredNorm() > residuals.squaredNorm() * (1 - 1e-13);
        logs = next;
        residuals = there;
        if (is_done) return from_logs(face, logs);
        damping /= 64;
      }
    }
    return from_logs(face, logs);
  }

  struct Slopes {
    std::array<Digits50, 3> slope{};
    std::array<Digits50, 3> size{};  ///< sum of the terms' magnitudes
    std::array<std::array<Digits50, 3>, 3> curvature{};
  };

  Slopes slopes(const std::array<Digits50, 3>& q) const {
    Slopes result;
    for (const AttenuationSample& sample : target_.samples) {
      const Digits50 r = sample.range, d = q[0] + r * q[1] + r * r * q[2];
      if (d < 1) continue;
      const Digits50 z = log(d) + log(Digits50(sample.attenuation));
      const Digits50 stretch = std::isinf(scale_) ? Digits50(1) : Digits50(sqrt(1 + z / scale_ * (z / scale_)));
      const Digits50 first = sample.weight * 2 * z / stretch;
      const Digits50 second = sample.weight * 2 / (stretch * stretch * stretch);
      for (std::size_t j = 0; j < 3; ++j) {
        result.slope[j] += first / d * power(r, j);
        result.size[j] += (abs(first) + sample.weight) / d * power(r, j);
        for (std::size_t k = 0; k < 3; ++k) {
          result.curvature[j][k] += (second - first) / (d * d) * power(r, j) * power(r, k);
        }
      }
    }
    return result;
  }

  /// One Newton step relative to the coefficients; its length.
  Digits50 newton_step(const std::vector<std::size_t>& moving, std::array<Digits50, 3>& q, Digits50& multiplier) const {
    const Slopes at = slopes(q);
    const std::size_t count = moving.size(), size = count + (target_.extent ? 1 : 0);
    std::vector<std::vector<Digits50>> rows(size, std::vector<Digits50>(size + 1));
    for (std::size_t j = 0; j < count; ++j) {
      for (std::size_t k = 0; k < count; ++k) {
        rows[j][k] = q[moving[j]] * q[moving[k]] * at.curvature[moving[j]][moving[k]];
      }
      rows[j][size] = -q[moving[j]] * at.slope[moving[j]];
    }
    if (target_.extent) {
      Digits50 sum = target_.constant.value_or(0);
      for (std::size_t j = 0; j < count; ++j) {
        const Digits50 term = q[moving[j]] * power(Digits50(*target_.extent), moving[j]);
        rows[j][count] = -term;
        rows[count][j] = term;
        sum += term;
      }
      rows[count][size] = 1 / Digits50(target_.threshold) - sum;
    }
    for (std::size_t j = 0; j < size; ++j) {  // Gauss, with the largest pivot
      std::size_t pivot = j;
      for (std::size_t i = j; i < size; ++i) {
        if (abs(rows[i][j]) > abs(rows[pivot][j])) pivot = i;
      }
      std::swap(rows[j], rows[pivot]);
      if (rows[j][j] == 0) return 1;
      for (std::size_t i = 0; i < size; ++i) {
        if (i == j) continue;
        const Digits50 factor = rows[i][j] / rows[j][j];
        for (std::size_t k = j; k <= size; ++k) rows[i][k] -= factor * rows[j][k];
      }
    }
    Digits50 length = 0;
    for (std::size_t j = 0; j < count; ++j) {
      const Digits50 step = rows[j][size] / rows[j][j];
      length = std::max(length, Digits50(abs(step)));
      q[moving[j]] *= 1 + step;
    }
    if (target_.extent) multiplier = rows[count][size] / rows[count][count];
    return length;
  }

  AttenuationTarget target_;
  double scale_;
  std::array<double, 3> unit_;
};

}  // namespace litfog::test
