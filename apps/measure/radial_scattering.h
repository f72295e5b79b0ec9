// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "litfog/phase.h"

namespace litfog::measure {

/// Largest relative error of RadialScattering's glow at depths of 0.02 to 30 and angles of 0.2 to 180 degrees, for
/// |g| <= 0.95 or Phase::droplets(). `litfog-bench scattering` checks it.
inline constexpr double kRadialScatteringMaxError = 0.003;

/// All orders of scattering of a point lamp in endless uniform fog of albedo 1, by deterministic discretisation:
/// symmetry about the lamp leaves two variables, the optical depth from the lamp and the angle from the direction to
/// it. The random walk (scattering_walk.h) is more general, but takes hours for what this finds in seconds.
///
/// S is the light scattered for the second or a later time into a direction, per length. F and M are the light that
/// single and higher-order scattering send to a point. With straight lines L and the phase function K,
///   M = L S,  S = K (F + M).
/// S times the depth is a polynomial between nodes, of third degree in the logarithm of the depth and in a variable
/// that is logarithmic in small angles. Beyond the last node S falls as 1 / depth, as in diffusion. The linear system
/// is solved by Henk van der Vorst 1992, "Bi-CGSTAB".
class RadialScattering {
 public:
  /// fineness  density of the nodes, usually 1
  explicit RadialScattering(double fineness = 1);

  /// A lamp's a(r) r^2 at a depth from it; empty: 1.
  using Law = std::function<double(double)>;

  /// M in a direction from a point, in the unit of airlight(), for a lamp with a law, r in depths.
  class Glow {
   public:
    /// depth  from lamp to eye, [0.001, 30]
    /// angle  between the ray and the direction to the lamp, radians, (0, pi]
    double at(double depth, double angle) const;

   private:
    friend RadialScattering;
    const RadialScattering* nodes_ = nullptr;
    Eigen::MatrixXd source_;  // S times depth, a column for each depth
  };

  /// The result refers to this object.
  ///
  /// throws  std::runtime_error if the system does not converge
  Glow solve(const Phase& phase, const Law& law = {}) const;

 private:
  /// A point of a ray as weights of 4 x 4 nodes.
  struct Sample {
    std::uint32_t first;  // depth's first node times angles plus the angle's first
    double depths[4], angles[4];
  };

  template <typename Use>
  void follow(double depth, double angle, const Use& use) const;
  Eigen::MatrixXd travel(const Eigen::MatrixXd& source) const;
  Eigen::MatrixXd redistribution(const Phase& phase) const;
  Eigen::MatrixXd single_scattering(const Phase& phase, const Law& law) const;

  std::vector<double> log_depth_, angle_, stretched_;
  Eigen::VectorXd sines_;  // of the angles
  std::vector<Sample> samples_;
  std::vector<std::size_t> begins_;  // first sample of each node's ray
};

}  // namespace litfog::measure
