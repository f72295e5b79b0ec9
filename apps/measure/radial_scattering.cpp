// SPDX-License-Identifier: Apache-2.0
#include "measure/radial_scattering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "model/parallel.h"

namespace litfog::measure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using std::numbers::pi;
using Numbers = std::vector<double>;

constexpr double kNearest = 1e-5, kFarthest = 200;  // depths of the first and last node
constexpr double kLastDepth = 25;                   // along a ray; e^-depth hides everything beyond
constexpr double kSharpAngle = 5e-4;                // radians, below which nodes are no longer logarithmic

/// Gauss's rule on [0, 1].
constexpr std::array<std::array<double, 2>, 4> kGauss{{{0.06943184420297371, 0.1739274225687269},
                                                       {0.33000947820757187, 0.3260725774312731},
                                                       {0.6699905217924281, 0.3260725774312731},
                                                       {0.9305681557970262, 0.1739274225687269}}};

double stretch(double angle) { return std::asinh(angle / kSharpAngle) + angle; }

/// Lagrange weights of four neighbouring nodes; constant beyond the ends.
struct Cubic {
  std::size_t first;
  double weights[4];
};
Cubic cubic(const Numbers& nodes, double x) {
  x = std::clamp(x, nodes.front(), nodes.back());
  const auto above = std::size_t(std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin());
  Cubic result{std::min(std::max<std::size_t>(above, 2) - 2, nodes.size() - 4), {}};
  for (std::size_t i = 0; i < 4; ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == i) continue;
      weight *= (x - nodes[result.first + j]) / (nodes[result.first + i] - nodes[result.first + j]);
    }
    result.weights[i] = weight;
  }
  return result;
}

/// A lobe relative to isotropic, averaged around the axis from which both angles are measured. The substitution moves
/// the pole of its root as far from the real axis as possible.
double averaged(const PhaseLobe& lobe, double angle, double other) {
  const double g = std::abs(lobe.asymmetry);
  const double half = std::sin((angle - other) / 2), sines = std::sin(angle) * std::sin(other);
  const double near = (1 - g) * (1 - g) + 4 * g * half * half;
  const double shape = std::sqrt(near / (near + 4 * g * sines));
  constexpr int kAround = 24;
  const Phase phase{.first = lobe};
  double sum = 0;
  for (int i = 0; i < kAround; ++i) {
    const double tangent = std::tan(pi / 2 * (i + 0.5) / kAround);  // tangent of half the substitute
    const double mapped = shape * tangent;                          // tangent of half the azimuth
    const double square = mapped * mapped / (1 + mapped * mapped);
    const double slope = shape * (1 + tangent * tangent) / (1 + mapped * mapped);
    const double versine = std::min(2 * half * half + 2 * sines * square, 2.0);
    sum += phase_at(phase, 1 - versine) * slope;
  }
  return sum / kAround;
}

}  // namespace

RadialScattering::RadialScattering(double fineness) {
  for (double depth = kNearest; depth < kFarthest;) {
    log_depth_.push_back(std::log(depth));
    depth *= std::exp(0.25 / fineness / (1 + depth / (1 + depth / 12)));
  }
  const int angles = int(88 * fineness);
  for (int i = 0; i <= angles; ++i) {
    const double wanted = stretch(pi) * i / angles;
    double low = 0, high = pi;
    for (int k = 0; k < 60; ++k) (stretch((low + high) / 2) < wanted ? low : high) = (low + high) / 2;
    angle_.push_back(i == angles ? pi : i == 0 ? 0 : high);
    stretched_.push_back(wanted);
  }
  sines_ = Eigen::Map<const Eigen::ArrayXd>(angle_.data(), Index(angle_.size())).sin();
  for (const double depth : log_depth_) {
    for (const double angle : angle_) {
      begins_.push_back(samples_.size());
      if (angle == 0) continue;  // towards the lamp, where M is infinite and the angle's sine 0
      follow(std::exp(depth), angle, [&](const Cubic& at_depth, const Cubic& at_angle, double weight) {
        Sample sample{std::uint32_t(at_depth.first * angle_.size() + at_angle.first), {}, {}};
        for (std::size_t i = 0; i < 4; ++i) {
          sample.depths[i] = weight * at_depth.weights[i];
          sample.angles[i] = at_angle.weights[i];
        }
        samples_.push_back(sample);
      });
    }
  }
  begins_.push_back(samples_.size());
}

/// The integral along a ray, over the hyperbolic angle from its point nearest to the lamp. The element of this angle
/// times the depth from the lamp is the element of length.
template <typename Use>
void RadialScattering::follow(double depth, double angle, const Use& use) const {
  const double offset = std::max(depth * std::sin(angle), 1e-12 * depth), approach = depth * std::cos(angle);
  const double end = std::asinh((kLastDepth - approach) / offset);
  for (double x = std::asinh(-approach / offset); x < end;) {
    const double range = offset * std::cosh(x);
    const double width = std::min({1.0, 1.5 / range, end - x});
    for (const auto& [node, weight] : kGauss) {
      const double at = x + node * width;
      const double place = offset * std::sinh(at);
      const double length = place + approach;
      if (length < 0) continue;
      const Cubic at_depth = cubic(log_depth_, std::log(offset * std::cosh(at)));
      const Cubic at_angle = cubic(stretched_, stretch(std::atan2(offset, -place)));
      use(at_depth, at_angle, weight * width * std::exp(-length));
    }
    x += width;
  }
}

MatrixXd RadialScattering::travel(const MatrixXd& source) const {
  const std::size_t angles = angle_.size();
  MatrixXd result(source.rows(), source.cols());
  for_each_in_parallel(log_depth_.size(), [&](std::size_t column) {
    for (std::size_t node = column * angles; node < (column + 1) * angles; ++node) {
      double sum = 0;
      for (std::size_t i = begins_[node]; i < begins_[node + 1]; ++i) {
        const Sample& sample = samples_[i];
        const double* at = &source.data()[sample.first];
        for (std::size_t k = 0; k < 4; ++k, at += angles) {
          sum += sample.depths[k] * (sample.angles[0] * at[0] + sample.angles[1] * at[1] + sample.angles[2] * at[2] +
                                     sample.angles[3] * at[3]);
        }
      }
      result.data()[node] = sum;
    }
  });
  return result;
}

/// K as a matrix over the angles, for light times the sine of its angle. Points are dense where the lobe is narrow.
MatrixXd RadialScattering::redistribution(const Phase& phase) const {
  const std::size_t angles = angle_.size();
  MatrixXd matrix = MatrixXd::Zero(Index(angles), Index(angles));
  for_each_in_parallel(angles, [&](std::size_t row) {
    const double angle = angle_[row];
    for (const bool is_first : {true, false}) {
      const PhaseLobe& lobe = is_first ? phase.first : phase.second;
      const double share = is_first ? phase.weight : 1 - phase.weight;
      if (share == 0) continue;
      const double narrow = 1 - std::abs(lobe.asymmetry);
      Eigen::VectorXd weights = Eigen::VectorXd::Zero(Index(angles));
      for (std::size_t cell = 0; cell + 1 < angles; ++cell) {
        for (double low = angle_[cell]; low < angle_[cell + 1];) {
          const double high = std::min(angle_[cell + 1], low + 0.3 * (narrow + std::abs(low - angle)));
          for (const auto& [node, weight] : kGauss) {
            const double other = low + node * (high - low);
            const double value = averaged(lobe, angle, other) / 2 * weight * (high - low);
            const Cubic at = cubic(stretched_, stretch(other));
            for (std::size_t i = 0; i < 4; ++i) weights[Index(at.first + i)] += value * at.weights[i];
          }
          low = high;
        }
      }
      // Light from all sides is conserved to the last digit: a loss of 1e-6 a scattering would show at 10 depths.
      matrix.row(Index(row)) += share / weights.dot(sines_) * weights.transpose();
    }
  });
  return matrix;
}

/// Single scattering times the sine of its angle, by an integral over the angle at the lamp.
MatrixXd RadialScattering::single_scattering(const Phase& phase, const Law& law) const {
  const std::size_t angles = angle_.size();
  MatrixXd single(angles, log_depth_.size());
  for_each_in_parallel(log_depth_.size(), [&](std::size_t column) {
    const double depth = std::exp(log_depth_[column]);
    for (std::size_t i = 0; i < angles; ++i) {
      const double angle = angle_[i];
      const double begin = stretch(angle), end = stretch(pi);
      const int panels = int(std::ceil((end - begin) * 3)) + 1;
      double sum = 0;
      for (int panel = 0; panel < panels && angle < pi; ++panel) {
        for (const auto& [node, weight] : kGauss) {
          const double wanted = begin + (end - begin) * (panel + node) / panels;
          double at = kSharpAngle * std::sinh(std::min(wanted, 9.4));  // inverse of stretch by Newton's method
          at = std::clamp(at, angle, pi);
          for (int k = 0; k < 30; ++k) {
            at -= (stretch(at) - wanted) / (1 / std::hypot(kSharpAngle, at) + 1);
            at = std::clamp(at, angle, pi);
          }
          const double legs = depth * (std::sin(angle) + std::sin(at - angle)) / std::sin(at);
          const double weakened = law ? law(depth * std::sin(angle) / std::sin(at)) : 1;
          const double half = std::sin(at / 2);
          sum += weight * (end - begin) / panels / (1 / std::hypot(kSharpAngle, at) + 1) * weakened *
                 phase_at(phase, 1 - 2 * half * half) * std::exp(-legs);
        }
      }
      single(Index(i), Index(column)) = sum / depth;
    }
  });
  return single;
}

RadialScattering::Glow RadialScattering::solve(const Phase& phase, const Law& law) const {
  const MatrixXd matrix = redistribution(phase);
  const Eigen::VectorXd depths = Eigen::Map<const Eigen::ArrayXd>(log_depth_.data(), Index(log_depth_.size())).exp();
  // Light times the sine of its angle, scattered, times the depth.
  const auto scatter = [&](const MatrixXd& light) -> MatrixXd { return matrix * light * depths.asDiagonal(); };
  const auto apply = [&](const MatrixXd& x) -> MatrixXd { return x - scatter(sines_.asDiagonal() * travel(x)); };
  const auto dot = [](const MatrixXd& a, const MatrixXd& b) { return a.cwiseProduct(b).sum(); };
  const MatrixXd right = scatter(single_scattering(phase, law));
  MatrixXd x = right, residual = right - apply(x);
  const MatrixXd shadow = residual;
  MatrixXd direction = MatrixXd::Zero(x.rows(), x.cols()), image = direction;
  double rho = 1, alpha = 1, omega = 1;
  // Far from the lamp there is 1e-5 of the light near it, and a residual of 1e-7 would show there.
  const double enough = 1e-22 * right.squaredNorm();
  for (int iteration = 0; residual.squaredNorm() > enough; ++iteration) {
    if (iteration == 400) throw std::runtime_error("the radial solution does not converge");
    const double next = dot(shadow, residual), beta = next / rho * alpha / omega;
    rho = next;
    direction = residual + beta * (direction - omega * image);
    image = apply(direction);
    alpha = rho / dot(shadow, image);
    residual -= alpha * image;
    const MatrixXd turned = apply(residual);
    omega = dot(turned, residual) / turned.squaredNorm();
    x += alpha * direction + omega * residual;
    residual -= omega * turned;
  }
  Glow glow;
  glow.nodes_ = this;
  glow.source_ = std::move(x);
  return glow;
}

double RadialScattering::Glow::at(double depth, double angle) const {
  double sum = 0;
  nodes_->follow(depth, angle, [&](const Cubic& at_depth, const Cubic& at_angle, double weight) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        sum += weight * at_depth.weights[i] * at_angle.weights[j] *
               source_(Index(at_angle.first + j), Index(at_depth.first + i));
      }
    }
  });
  return sum;
}

}  // namespace litfog::measure
