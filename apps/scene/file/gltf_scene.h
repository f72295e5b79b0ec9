// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace litfog::scene {

/// Whether a path ends as glTF files do: .gltf or .glb, in letters of either case.
bool is_gltf_path(const std::string& path);

/// Reads a glTF 2.0 file with its buffers and pictures: the meshes, materials and lights of its scene (the default one,
/// else the first) in their rest pose, seen by the first perspective camera found. What is left out, Scene::left_out
/// counts. A file that requires an extension that is not named here fails.
///
/// | feature                             | what becomes of it                                                         |
/// |-------------------------------------|----------------------------------------------------------------------------|
/// | animation, occlusion, points, lines | left out                                                                   |
/// | meshes flattened by a scale of 0    | left out                                                                   |
/// | the camera's roll                   | left out                                                                   |
/// | other extensions                    | left out                                                                   |
/// | triangles, strips, fans             | taken, with sparse accessors; twice where the material is double-sided     |
/// | skins, morph targets                | as nodes and weights place them without animation                          |
/// | KHR_mesh_quantization               | taken, all its types, required or not                                      |
/// | KHR_draco_mesh_compression          | taken                                                                      |
/// | EXT_meshopt_compression             | taken                                                                      |
/// | EXT_mesh_gpu_instancing             | taken                                                                      |
/// | size                                | at most 1 GiB with its buffers; decoded views at most 1 GiB | | PNG, JPEG,
/// WebP (EXT_texture_webp)  | at most 16,384 pixels a side and 2^27 in all                               | | KTX2
/// (KHR_texture_basisu)           | refused, unless another picture stands beside it                           | |
/// textures                            | each its own sampler, coordinates and KHR_texture_transform                |
/// | base colour, metallic               | albedo = base colour (1 - metallic)                                        |
/// | base colour, metallic, roughness    | specular = (n + 8) / 8 F, F = mix(0.04, base colour, metallic) [1]         |
/// | roughness                           | shininess n = 2 / roughness^4 - 2, in [1, 1000] [2]                        |
/// | metallic-roughness texture          | its mean for specular and n, which are one value a material; see below     |
/// | COLOR_0                             | multiplies the base colour, but not F's                                    |
/// | KHR_materials_unlit                 | the base colour goes to the eye through the fog; nothing is reflected      |
/// | emission                            | its texels times KHR_materials_emissive_strength, at most 10,000           |
/// | MASK                                | no surface below alphaCutoff                                               |
/// | BLEND                               | hides alpha of what is behind it, in linear light; see below               |
/// | point and spot lights               | KHR_lights_punctual; see below                                             |
/// | the brightest directional light     | the moon, of colour E / 20 for E lx, at most 1,310,080; others left out | |
/// lights at or below the camera       | carried by the eye's vehicle                                               |
/// | no lights                           | lit from over the viewer's shoulder, and by half as much ambient light     |
///
/// [1] the lobe's energy: Akenine-Moller et al., "Real-Time Rendering", 3rd edition, 7.8.1
/// [2] Karis 2013, "Specular BRDF Reference"
///
/// Metallic: the albedo takes it texel by texel, before both are filtered, where its texture has the base colour's
/// coordinates, else its mean. F takes the mean of the base colour, too.
///
/// Blended surfaces: triangles are drawn from the farthest to the nearest middle, which is wrong where two cross and
/// can be where a large one is beside a small one. Lamps' points before them are dimmed like those behind them. Paths
/// that draw a surface in several passes draw it as MASK at 0.5. three.js blends in linear light in a linear render
/// target only; on a canvas it blends the values encoded for the display.
///
/// Lights: a light of I cd has its colour, C = 1 and Q = 20 lx / I, so that a white surface square to it shows
/// I / (20 lx r^2) of the display's white at r metres, as for any light of litfog (kWhiteLux); its source radius is
/// 0.05 m, or half of sqrt(I / 20 lx) where that is less. The light ends at its range, or without one where it shows
/// half of 1/256. By airlight a light shines on beyond its range, which the extension calls a hint
/// (render::SurfaceList::set_lights, render::FarAirlight). Spots are smoothstep cones from their inner to their outer
/// angle, at least 0.001 apart in the cosine.
///
/// Fog: the moon lights fog and sky as isotropic fog without end does, E / 4 pi, and they light surfaces. Ambient light
/// and fog are otherwise a night's. In exp fog the moon's airlight comes on top, and the fog's colour stands for light
/// scattered more than once.
///
/// Visibilities: 10, 3 and 1 times the distance d from the camera to the farthest corner of the scene's box, each
/// rounded up to two significant digits. At 3 d, at which a scene is drawn if none is given, at least 37 % of the
/// contrast of everything is left in exp fog.
///
/// throws  InputError
Scene read_gltf_scene(const std::string& path);

}  // namespace litfog::scene
