// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace litfog::scene {

/// Whether a path ends as glTF files do: .gltf or .glb, in letters of either case.
bool is_gltf_path(const std::string& path);

/// Reads a glTF 2.0 file with its buffers and pictures: the meshes, materials and lights of its scene (the default one,
/// else the first) in their rest pose, seen by the first perspective camera found. Animation, occlusion, points, lines,
/// meshes flattened by a scale of 0, all directional lights but the brightest, the camera's roll and extensions that
/// are not named here are left out: Scene::left_out counts what of these a file has. A file that requires such an
/// extension fails.
///
/// Meshes: triangles, their strips and fans; skins and morph targets as nodes and weights place them without animation;
/// sparse accessors; KHR_mesh_quantization (all its types, required or not),
/// KHR_draco_mesh_compression, EXT_meshopt_compression, EXT_mesh_gpu_instancing. A double-sided material's triangles
/// are there twice. A file is at most 1 GiB with its buffers, and so are its decoded views.
///
/// Pictures: PNG, JPEG and WebP (EXT_texture_webp), at most 16,384 pixels a side and 2^27 in all; KTX2
/// (KHR_texture_basisu) only where another picture stands beside it. Each texture has its own sampler, set of
/// coordinates and KHR_texture_transform, but for metallic-roughness: see below.
///
/// Materials, metallic-roughness to the Basic model: albedo = base colour (1 - metallic); specular = (n + 8) / 8 F with
/// F = mix(0.04, base colour, metallic), the lobe's energy (Akenine-Moller et al., "Real-Time Rendering", 3rd edition,
/// 7.8.1); shininess n = 2 / roughness^4 - 2 (Karis 2013, "Specular BRDF Reference"), in [1, 1000]. Specular and n are
/// one value a material here, so they take the mean of their textures (metallic-roughness, and base colour for F). The
/// albedo takes metallic texel by texel, before both are filtered, where its texture has the base colour's coordinates,
/// else its mean. COLOR_0 multiplies the base colour, but not F's. KHR_materials_unlit sends the base colour to the eye
/// through the fog and reflects nothing. Emission has its texels, times KHR_materials_emissive_strength, at most
/// 10,000. MASK leaves no surface below alphaCutoff. BLEND hides alpha of what is behind it, in
/// linear light; three.js blends so in a linear render target only, and on a canvas the values encoded for the display.
/// Its triangles are drawn from the farthest to the nearest middle, which is wrong where two cross and can be where a
/// large one is beside a small one, and lamps' points before it are dimmed like those behind it. Paths that draw a
/// surface in several passes draw it as MASK at 0.5.
///
/// Lights (KHR_lights_punctual): a white surface square to a light of I cd shows I / (pi r^2) of the display's white at
/// r metres, as in the Khronos sample viewer at exposure 1. This is Hales's attenuation with C = L = 0 and Q = 1/k^2,
/// that is 1 up to the knee k. There a white surface shows 16 times the display's white, k^2 = I / (16 pi), but k is at
/// most 1 m, or more only as far as no colour is beyond 10,000 (from 31,416 cd). The light ends at its range: threshold
/// k^2 / range^2; without one where it shows half of 1/256. A range within the knee puts the knee at half the range.
/// By airlight a light shines on beyond its range, which the extension calls a hint (render::SurfaceList::set_lights,
/// render::FarAirlight). Spots are smoothstep cones from their inner to their outer angle, at least 0.001 apart in the
/// cosine. Lights at the camera's node or below it are carried by the eye's vehicle.
///
/// Lamps light the fog by their colour times A (litfog/airlight.h), whose phase function is 1 where it is isotropic.
/// That is 4 times what a path tracer shows of the same lamps in fog that only scatters: I / pi where it has I / 4 pi.
///
/// The brightest directional light, of E lx, at most 205,786, is the moon of colour E / pi. It lights fog and sky as
/// isotropic fog without end does, E / 4 pi, and they light surfaces. Ambient light and fog are else a night's. The
/// surfaces of a file without lights are lit from over the viewer's shoulder, and by half as much ambient light.
///
/// Visibilities: 10, 3 and 1 times the distance d from the camera to the farthest corner of the scene's box, each
/// rounded up to two significant digits. At 3 d, at which a scene is drawn if none is given, at least 37 % of the
/// contrast of everything is left in exp fog.
///
/// throws  InputError
Scene read_gltf_scene(const std::string& path);

}  // namespace litfog::scene
