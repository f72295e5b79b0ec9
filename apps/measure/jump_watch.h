// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "measure/path_model.h"

namespace litfog::measure {

/// Finds the samples whose side of a jump of the model is decided by the rounding of floats: at a light's extent, at
/// the edge of a cosine cone, where a surface with highlights is just turned away, and where the fog seen from above
/// ends at the horizon; or by the texels of a shadow map, near the edge of a shadow (ReferenceShadows::kEdgeTexels).
/// Jumps too small to be seen do not count.
class JumpWatch {
 public:
  /// model  has to outlive this
  explicit JumpWatch(const PathModel& model) : model_(model) {}

  /// Whether the light that a surface sends to the eye jumps.
  bool is_at_jump(const SurfacePoint& point) const;
  /// Whether the fog before a position jumps.
  bool is_at_jump(const Veil& veil, const glm::dvec3& position) const;
  /// Whether the fog before the sky jumps in a direction, whose height decides the side of the horizon. The fog's top
  /// is `fog_above_eye` metres above the eye.
  bool is_at_fog_horizon(double fog_above_eye, const glm::dvec3& direction) const;

 private:
  bool is_at_jump(const SurfacePoint& point, const ReferenceLight& light, const LightRay& ray) const;
  bool is_at_shadow_edge(const SurfacePoint& point, const ReferenceLight& light, const LightRay& ray) const;

  const PathModel& model_;
};

}  // namespace litfog::measure
