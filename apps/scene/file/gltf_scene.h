// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/scene.h"

namespace litfog::scene {

/// Whether a path ends in .gltf or .glb, in letters of either case.
bool is_gltf_path(const std::string& path);

/// Reads a glTF 2.0 file with its buffers and pictures: the meshes, materials and lights of its scene (the default one,
/// else the first) in their rest pose, seen by the first perspective camera. Scene::left_out counts what is left out. A
/// file that requires an extension not named here fails.
///
/// | feature                             | what becomes of it                                                         |
/// |-------------------------------------|----------------------------------------------------------------------------|
/// | animation, occlusion, points, lines | left out                                                                   |
/// | meshes flattened by a scale of 0    | left out                                                                   |
/// | the camera's roll                   | left out                                                                   |
/// | other extensions                    | left out                                                                   |
/// | triangles, strips, fans             | drawn, with sparse accessors; twice if the material is double-sided        |
/// | skins, morph targets                | as nodes and weights place them without animation                          |
/// | KHR_mesh_quantization               | drawn, all its types, required or not                                      |
/// | KHR_draco_mesh_compression          | drawn                                                                      |
/// | EXT_meshopt_compression             | drawn                                                                      |
/// | EXT_mesh_gpu_instancing             | drawn                                                                      |
/// | size                                | at most 1 GiB with its buffers; decoded views at most 1 GiB                |
/// | PNG, JPEG, WebP (EXT_texture_webp)  | at most 16,384 pixels per side and 2^27 in all                             |
/// | KTX2 (KHR_texture_basisu)           | refused, unless there is another picture beside it                         |
/// | textures                            | each with its own sampler, coordinates and KHR_texture_transform           |
/// | base colour, metallic               | albedo = base colour (1 - metallic)                                        |
/// | base colour, metallic, roughness    | specular = (n + 8) / 8 F, F = mix(0.04, base colour, metallic) [1]         |
/// | roughness                           | shininess n = 2 / roughness^4 - 2, in [1, 1000] [2]                        |
/// | metallic-roughness texture          | its mean for specular and n, which are one value per material; see below   |
/// | COLOR_0                             | multiplies the base colour, but not F's                                    |
/// | KHR_materials_unlit                 | the base colour reaches the eye through the fog; nothing is reflected      |
/// | emission                            | its texels times KHR_materials_emissive_strength, at most 10,000           |
/// | MASK                                | no surface below alphaCutoff                                               |
/// | BLEND                               | hides the fraction alpha of what is behind it, in linear light; see below  |
/// | point and spot lights               | KHR_lights_punctual; see below                                             |
/// | the brightest directional light     | the moon, with colour E / 20 for E lx, at most 1,310,080                   |
/// | other directional lights            | left out                                                                   |
/// | lights at or below the camera       | carried by the eye's vehicle                                               |
/// | no lights                           | lit from over the viewer's shoulder, and by half as much ambient light     |
///
/// [1] the lobe's energy: Akenine-Moller et al., "Real-Time Rendering", 3rd edition, 7.8.1
/// [2] Karis 2013, "Specular BRDF Reference"
///
/// Metallic: if its texture has the base colour's coordinates, the albedo uses it texel by texel, before both are
/// filtered; otherwise its mean. F also uses the mean of the base colour.
///
/// Blended surfaces: triangles are drawn from the farthest to the nearest centre, which is wrong where two intersect
/// and can be wrong where a large one is beside a small one. Lamps' points in front of them are dimmed like those
/// behind them. Paths that draw a surface in several passes draw it as MASK at 0.5. three.js blends in linear light
/// only in a linear render target; on a canvas it blends the values encoded for the display.
///
/// Lights: a light of I cd has its colour, C = 1 and Q = 20 lx / I, so that a white surface that faces it shows
/// I / (20 lx r^2) of the display's white at r metres, like any light of litfog (kWhiteLux). Its source radius is
/// 0.05 m, or half of sqrt(I / 20 lx) if that is less. The light ends at its range, or without one where it shows
/// half of 1/256. By airlight a light continues beyond its range, which the extension calls a hint
/// (render::SurfaceList::set_lights, render::FarAirlight). Spots are smoothstep cones from their inner to their outer
/// angle, at least 0.001 apart in the cosine.
///
/// Fog: the moon lights fog and sky like endless isotropic fog, E / 4 pi, and they light surfaces. Ambient light and
/// fog are otherwise a night's. In exp fog the moon's airlight is added, and the fog's colour stands for light
/// scattered more than once.
///
/// Visibilities: 10, 3 and 1 times the distance d from the camera to the farthest corner of the scene's box, each
/// rounded up to two significant digits. The default is 3 d: in exp fog, everything keeps at least 37 % of its
/// contrast.
///
/// throws  InputError
Scene read_gltf_scene(const std::string& path);

}  // namespace litfog::scene
