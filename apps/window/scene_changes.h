// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "litfog/light.h"
#include "scene/file/scene_file.h"
#include "scene/scene.h"

namespace litfog::window {

/// The changes of a scene file's member (Scene::light_members) that turn one light into another. Reading the file with
/// these changes gives that light, except for the last bits of its direction and of its cone's angles.
///
/// from, to  differ only in position, direction, attenuation, threshold, cone, colour and density scale
std::vector<scene::SceneChange> changes_of(const std::string& member, const PlacedLight& from, const PlacedLight& to);

/// scene::light_entry() on one line, without the members that only light files need.
std::string light_entry(const PlacedLight& light);

/// The text of a scene file with changes, for another path: changed light files are written out in it, and all other
/// files are named relative to the new path.
///
/// file     the scene's; not a glTF file
/// camera   replaces the file's
/// place    the new path
/// throws   InputError if the scene's file, or a changed light's, can no longer be read
std::string changed_scene(const std::string& file, const std::optional<scene::Camera>& camera,
                          const std::vector<scene::SceneChange>& changes, const std::string& place);

}  // namespace litfog::window
