// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace litfog::scene {

/// Whether a path ends as glTF files do: .gltf or .glb.
bool is_gltf_path(const std::string& path);

/// Reads a glTF 2.0 file with its buffers and pictures: the meshes, materials and lights of its scene (the default one,
/// else the first) in their rest pose, seen by the first perspective camera found. Animation, skins, morph targets,
/// transparency, vertex colours and occlusion are left out: the demo's models have none.
///
/// Materials, metallic-roughness to the Basic model: albedo = base colour (1 - metallic); specular = (n + 8) / 8 F with
/// F = mix(0.04, base colour, metallic), the lobe's energy (Akenine-Moller et al., "Real-Time Rendering", 3rd edition,
/// 7.8.1); shininess n = 2 / roughness^4 - 2 (Karis 2013, "Specular BRDF Reference"), at most 1000. Specular, n and
/// emission are one value a material here, so they take the mean of their textures (metallic-roughness, emissive, and
/// base colour for F). Textures repeat.
///
/// Lights (KHR_lights_punctual): a white surface square to a light of I cd shows I / (pi r^2) of the display's white at
/// r metres, as in the Khronos sample viewer at exposure 1. This is Hales's attenuation with C = L = 0 and Q = 1/k^2,
/// that is 1 up to the knee k. There a white surface shows 16 times the display's white, k^2 = I / (16 pi), but k is at
/// most 1 m, or more only as far as no colour is beyond 10,000 (from 31,416 cd). The light ends at its range: threshold
/// k^2 / range^2; without one where it shows half of 1/256. A range within the knee puts the knee at half the range.
/// Spots are smoothstep cones from their inner to their outer angle. Lights at the camera's node or below it are
/// carried by the eye's vehicle. One directional light of E lx, at most 205,786, is the moon of colour E / pi. It
/// lights fog and sky as isotropic fog without end does, E / 4 pi, and they light surfaces. Ambient light and fog are
/// else a night's; in a file without lights the ambient light is bright.
///
/// Visibilities: 10, 3 and 1 times the distance d from the camera to the farthest corner of the scene's box, each
/// rounded up to two significant digits. At 3 d, at which a scene is drawn if none is given, at least 37 % of the
/// contrast of everything is left in exp fog.
///
/// throws  InputError
Scene read_gltf_scene(const std::string& path);

}  // namespace litfog::scene
