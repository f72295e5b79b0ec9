// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "litfog/light.h"
#include "scene/scene.h"

namespace litfog::window {

/// A value in place of one that a scene file states of a light, or in addition to those: litfog-demo's --set.
struct SceneChange {
  std::size_t entry;   ///< of the file's "lights"
  std::string member;  ///< "color" of the entry, or a member of its light: "attenuation.quadratic", "cone"
  std::string value;   ///< JSON

  /// "lights[0].attenuation.quadratic=0.002"
  std::string text() const;
};

/// Which entry of its file's "lights" each light of a scene comes from: copies share one. Those of a generated city
/// and of a glTF file come from none, so that they cannot be changed.
///
/// throws  InputError where the file cannot be read any more
std::vector<std::optional<std::size_t>> entries_of_lights(const scene::Scene& scene);

/// What makes a light of one that the file states. Reading a changed file gives it back, its cone's angles but for
/// their last bits.
///
/// from, to  the same light but for attenuation, threshold, cone, colour and density scale
std::vector<SceneChange> changes_of(std::size_t entry, const Light& from, const Light& to);

/// The text of a scene file with changes, for a place of its own: lights that are changed are written out in it, and
/// all other files are named as seen from there.
///
/// file     of the scene: no glTF file
/// camera   in place of the file's
/// place    the path at which the text is going to be
/// throws   InputError where the scene's file, or a changed light's, cannot be read any more
std::string changed_scene(const std::string& file, const std::optional<scene::Camera>& camera,
                          const std::vector<SceneChange>& changes, const std::string& place);

}  // namespace litfog::window
