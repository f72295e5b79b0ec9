// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace litfog::scene {

// clang-format off
/// Scene files, version 1. Metres, Y up; colours are linear RGB.
///
///     {
///       "litfog": "scene",
///       "version": 1,
///       "name": "headlights",                             optional: the file's name without its ending
///       "description": "two headlights on a road",        optional
///       "camera": {"position": [0, 1.4, 0], "target": [0, 1, -20], "field_of_view_deg": 45},
///       "environment": {                                  optional, like each of its members
///         "ambient": [0.01, 0.01, 0.02], "fog_color": [0.02, 0.02, 0.03],
///         "sky_zenith": [0, 0, 0.01], "sky_horizon": [0.01, 0.01, 0.02], "stars": 0.8,
///         "moon": {"direction": [0.3, 0.5, -1], "color": [0.02, 0.02, 0.03]}
///       },
///       "visibilities_m": [500, 150, 50],                 optional: for the gallery; at most 16
///       "lit_at_vertices": true,                          optional: it shows light at vertices, and is drawn only by a
///                                                         gallery that names it; default: false
///       "fog_top_m": 120,                                 optional: the height at which rays to the sky leave the fog
///                                                         and moonlight enters it (Atmosphere::top_above() and
///                                                         light_top()); default: never, any fog hides the sky, and
///                                                         1200, from height 0 of the scene
///       "phase_g": 0.8,                                   optional: short for the phase hg:0.8; not beside
///                                                         atmosphere.phase
///       "atmosphere": {                                   optional: the air
///         "phase": "droplets:20",                         optional: the fog's phase function, named by kPhaseRule;
///                                                         default: droplets:10
///         "albedo": 0.9,                                  optional: the fog's scattering over extinction, in [0, 1];
///                                                         default: 1
///         "layers": [                                     optional: layers of fog (fog_layers.h)
///           {"base_m": 200, "top_m": 300,                 optional: without base or top
///            "transition_m": 40,                          optional: height of the bands outside it in which the
///                                                         density falls to 0; default: 0
///            "visibility_m": 150}]},                      within it; visibilities_m are those outside the layers
///       "display": {"exposure": "auto",                   optional: how its pictures are shown: EV, default 0, or auto;
///         "tone": "neutral"},                             or clip, each channel cut at white
///       "vehicle": {"position": [0, 33, 356],             optional: carries mounted lights
///         "heading_deg": 4, "pitch_deg": -3, "roll_deg": 2},  optional: 0; right, up in [-90, 90], right wing down
///       "lights": [{
///         "light": "../lights/headlight.json",            relative to this file, or a light written out here
///         "position": [-0.6, 0.7, 0],
///         "aim": [-0.6, 0, -30],                          a point, or "direction": [0, -0.02, -1]; default: down
///         "mount": {"azimuth_deg": 3,                     instead of these: its direction from the vehicle, to the
///                   "elevation_deg": -6},                 right, and up in [-90, 90]; "position" is then to the
///                                                         right of the vehicle's, up and back
///         "color": [2, 1.9, 1.6],                         optional: instead of the light's own
///         "cookie": {"image": "beam.exr",                 optional: instead of the light's cone, a cube map from
///                    "roll_deg": 20, "spin_deg_per_s": 90},  litfog-fit, or "pattern": "disco" or "beacon"; rolled
///                                                         about the axis, and spinning with --time
///         "turn_deg_per_s": 30,                           optional: the axis turns about the vertical with --time,
///                                                         like heading_deg: to the left if positive
///         "carried": true,                                optional: by the eye's vehicle; default: false
///         "repeat": [{"count": 41, "step": [0, 0, -60]}]  optional: copies at each step; the next step repeats them
///       }],
///       "city": {                                         optional: a generated city around the origin (model/city.h)
///         "lights": 1000, "seed": 1,                      how many shine, [1, 100000]; optional: 1000, 1
///         "without": [0, 17],                             optional: indices of lights that are switched off
///         "street_lamp": "../lights/street-lamp.json",    its kinds of lights, as above: also headlight, tail_lamp,
///         ...                                             shop_window, window, runway_edge, approach_light
///       },
///       "objects": [{                                     optional beside a city
///         "model": "spruce", "height_m": 9, "seed": 3,    a model of model_catalogue.h, its parameters
///         "position": [4, 0, -20], "heading_deg": 30, "scale": 1.1,      optional: the origin, 0, 1
///         "repeat": [...],                                as above, or
///         "scatter": {"count": 80, "area": [10, -200, 60, 0], "seed": 1, "scale": [0.8, 1.2]}
///       }]                                                area: x and z of two corners; headings at random
///     }
///
/// "aim" moves with a repeated light. A scene has at most 100,000 lights, 200 of them carried, and 50,000 objects; an
/// entry has at most 20,000 copies. Coordinates are within 10,000 km, colour components at most 10,000.
// clang-format on

/// A value that replaces or adds a member of a scene file. The change comes before parsing, so all rules of the file
/// hold.
///
///     {"lights[0].carried", "true"}
///     {"lights[0].attenuation.quadratic", "0.002"}      the light's, even if lights[0].light is a file's name; other
///     {"city.window.threshold", "0.1"}                  lights from that file do not change
///     {"lights[1].threshold", "0.1"}                    in a glTF file: its second light, as if an entry stated it
///     {"lights[3]", "{\"light\": ...}"}                 adds a light to a file that has three
///     {"lights[0].aim", "null"}                         removes it; {"lights[0]", "null"}: the others move up
///
/// An entry of "lights" with copies changes all of them.
struct SceneChange {
  std::string member;  ///< as error messages name members
  std::string value;   ///< JSON, or a word that stands for a string: ../lights/street-lamp.json
};

/// The location in errors of a change.
inline constexpr const char* kChangePlace = "--set";

/// The member of the file that a change means: an entry's own, or its light's, which then comes after ".light". Throws
/// InputError if an entry has no such member.
std::string changed_member(const std::string& member);

/// The parts of a scene file that take long to make, kept from one reading for the next. The files of cookies and glTF
/// scenes are not read again, so changes to them go unnoticed.
struct SceneParts {
  std::map<std::string, Model> models = {};                     ///< by name and parameters
  std::map<std::string, Material> materials = {};               ///< by name
  std::map<std::pair<bool, std::string>, Cookie> cookies = {};  ///< by whether they are patterns, and name or path
  std::map<std::string, Scene> gltf_scenes = {};                ///< by path, without changes
};

/// Reads a scene file, or by its ending a glTF file (gltf_scene.h), and reports what is left out of that in one line on
/// standard error. Throws InputError, with the file kChangePlace if a change is wrong.
///
/// city_lights  replaces the number of lights in the scene's city; no effect without a city
/// changes      in the order given; for a glTF file only of "lights", each with "light", "position", "direction" and,
///              if true, "carried"
/// kept         parts of an earlier reading, copied if the scene has them, then replaced by this one's; null: none
Scene read_scene(const std::string& path, std::optional<std::size_t> city_lights = {},
                 const std::vector<SceneChange>& changes = {}, SceneParts* kept = nullptr);

/// A light as an item of a scene file's "lights". Its numbers read back, except for the last bits of its direction and
/// of its cone's angles.
std::string light_entry(const PlacedLight& light);

/// Reads scenes whose pictures go into one folder. Throws InputError, also if two scenes, and so their pictures, have
/// the same name.
std::vector<Scene> read_scenes(const std::vector<std::string>& paths);

/// The bundled scenes: names of files in data/scenes, sorted. Throws InputError if there are none.
std::vector<std::string> bundled_scenes();

/// Path of a bundled scene's file, which need not exist.
std::string bundled_scene_path(const std::string& name);

}  // namespace litfog::scene
