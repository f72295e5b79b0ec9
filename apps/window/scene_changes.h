// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "litfog/light.h"
#include "scene/file/scene_file.h"
#include "scene/scene.h"

namespace litfog::window {

/// What makes a light of the one that a member of a scene's file states (Scene::light_members). Reading the file with
/// these changes gives the light back, except for the last bits of its direction and of its cone's angles.
///
/// from, to  the same light except for position, direction, attenuation, threshold, cone, colour and density scale
std::vector<scene::SceneChange> changes_of(const std::string& member, const PlacedLight& from, const PlacedLight& to);

/// A light as an item of a scene file's "lights".
std::string light_entry(const PlacedLight& light);

/// The text of a scene file with changes, for a place of its own: light files of which members are changed are written
/// out in it, and all other files are named as seen from there.
///
/// file     of the scene: no glTF file
/// camera   replaces the file's
/// place    the path at which the text is going to be
/// throws   InputError where the scene's file, or a changed light's, cannot be read any more
std::string changed_scene(const std::string& file, const std::optional<scene::Camera>& camera,
                          const std::vector<scene::SceneChange>& changes, const std::string& place);

}  // namespace litfog::window
