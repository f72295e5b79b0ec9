// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "litfog/fog.h"
#include "render/light/light_groups.h"
#include "render/light/scene_lights.h"
#include "render/plan/lighting_path.h"
#include "scene/mesh.h"

namespace litfog::render {

/// About how much what a surface shows of a group as one light differs from what it shows of its lights: a fraction of
/// what one of them can give. Of random cases in which a surface faces all of them 99 in 100 stay below
/// (light_groups_test.cpp). Not a bound: where it turns away from some and not from the others, it may err by a whole
/// light.
///
/// The mean of their places takes the first order of the error away. Of a brightness b, half of spread^2 b'' is left.
/// Across the light's direction the edge of a cone bends by at most 6 / width^2 or by the exponent, a highlight by its
/// shininess, and the more, the more light and eye graze the surface: here as at 6 degrees. Along it 1 / r^2 bends by
/// 6 / r^2, exp fog of density d by d^2 and exp2 fog by at most 4 d^4 r^2.
///
/// fog    as the lights' class sees it
/// range  metres, from the group's place to the surface; nearer than twice the group's radius the error is infinite
double group_error(const LightGroup& group, const Cone& cone, const Fog& fog, double shininess, double range);

/// What picking groups has to know of a surface.
struct GroupedSurface {
  const scene::Bounds& bounds;
  double reflectance;  ///< SurfaceMaterial
  double shininess;
  double through;  ///< fraction of its light that the fog before it lets through, at most
};

/// Lists groups in place of their lights.
class GroupPicker {
 public:
  /// lights, path  have to outlive this
  GroupPicker(const SceneLights& lights, const LightingPath& path)
      : lights_(lights), path_(path), uses_(lights.groups().groups.size()) {}

  /// Takes the list of a surface from an entry on, all lights, and puts groups in their place: the largest of which no
  /// light errs by more than about a quarter of a step of the display, or gives more than four.
  ///
  /// list  becomes one of instances of SceneLights
  /// step  of the display: visible_step()
  void pick(std::vector<std::int32_t>& list, std::size_t first, const GroupedSurface& surface, const Fog& fog,
            double step);

 private:
  struct Use {
    std::size_t list = 0;  // number of the last list that asked
    bool is_near = false;  // too near the surface to be one light
    bool is_listed = false;
  };

  Use& use(std::int32_t group, const GroupedSurface& surface, const Fog& fog, double step);

  const SceneLights& lights_;
  const LightingPath& path_;
  std::vector<Use> uses_;  // of each group
  std::size_t list_number_ = 0;
};

}  // namespace litfog::render
