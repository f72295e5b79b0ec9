// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "litfog/light.h"
#include "scene/file/scene_file.h"
#include "scene/scene.h"

namespace litfog::window {

/// Which entry of its file's "lights" each light of a scene comes from: copies share one. Those of a generated city and
/// of a glTF file come from none.
std::vector<std::optional<std::size_t>> entries_of_lights(const scene::Scene& scene);

/// What makes a light of the one that an entry of a scene file states. Reading the file with these changes gives the
/// light back, its cone's angles but for their last bits.
///
/// from, to  the same light but for attenuation, threshold, cone, colour and density scale
std::vector<scene::SceneChange> changes_of(std::size_t entry, const Light& from, const Light& to);

/// The text of a scene file with changes, for a place of its own: light files of which members are changed are written
/// out in it, and all other files are named as seen from there.
///
/// file     of the scene: no glTF file
/// camera   in place of the file's
/// place    the path at which the text is going to be
/// throws   InputError where the scene's file, or a changed light's, cannot be read any more
std::string changed_scene(const std::string& file, const std::optional<scene::Camera>& camera,
                          const std::vector<scene::SceneChange>& changes, const std::string& place);

}  // namespace litfog::window
