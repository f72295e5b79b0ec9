// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "litfog/phase.h"

namespace litfog::measure {

/// Largest relative error of RadialScattering's glow at depths of 0.02 to 30 and angles of 0.2 to 180 degrees, for
/// |g| <= 0.95 or Phase::droplets(): what `litfog-bench scattering` holds it to.
inline constexpr double kRadialScatteringMaxError = 0.003;

/// All orders of scattering of a point lamp in endless uniform fog of albedo 1 by discretisation, without chance: the
/// symmetry about the lamp leaves two variables, the depth from the lamp and the angle from the direction to it. The
/// random walk (scattering_walk.h) knows more, and takes hours for what this finds in seconds.
///
/// With S the light scattered into a direction for the second time or a later one, a length, F and M the light that
/// single and further scattering send to a point, along straight lines L and by the phase function K,
///   M = L S,  S = K (F + M).
/// S times the depth is a polynomial between nodes, of third degree in the logarithm of the depth and in a variable
/// that is logarithmic in small angles. Beyond the last node S falls as 1 / depth, as diffusion has it. The linear
/// system is solved by Henk van der Vorst 1992, "Bi-CGSTAB".
class RadialScattering {
 public:
  /// fineness  of the nodes; 1 is the usual one
  explicit RadialScattering(double fineness = 1);

  /// a(r) r^2 of a lamp at a depth from it; empty: 1.
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
    std::vector<double> source_;  // S times depth, at depths by angles
  };

  /// The result refers to this object.
  ///
  /// throws  std::runtime_error where the system does not converge
  Glow solve(const Phase& phase, const Law& law = {}) const;

 private:
  /// A point of a ray as its weights of 4 x 4 nodes.
  struct Sample {
    std::uint32_t first;  // depth's first node times angles plus the angle's first
    double depths[4], angles[4];
  };

  template <typename Use>
  void follow(double depth, double angle, const Use& use) const;
  std::vector<double> travel(const std::vector<double>& source) const;
  std::vector<double> redistribution(const Phase& phase) const;

  std::vector<double> log_depth_, angle_, stretched_;
  std::vector<Sample> samples_;
  std::vector<std::size_t> begins_;  // of the samples of a node's ray
};

}  // namespace litfog::measure
