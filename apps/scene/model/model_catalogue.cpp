// SPDX-License-Identifier: Apache-2.0
#include "scene/model/model_catalogue.h"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>

#include "scene/model/airfield.h"
#include "scene/model/band.h"
#include "scene/model/coast.h"
#include "scene/model/house.h"
#include "scene/model/road.h"
#include "scene/model/roadside.h"
#include "scene/model/room.h"
#include "scene/model/street_life.h"
#include "scene/model/terrain.h"
#include "scene/model/tessellation.h"
#include "scene/model/tree.h"

namespace litfog::scene {
namespace {

struct Entry {
  ModelInfo info;
  std::function<Model(const ModelParameters&)> make;
};

/// A model whose parameters, members of a struct, become those of the catalogue.
template <typename Parameters>
Entry entry(std::string_view name, std::string_view description, Model (*make)(const Parameters&)) {
  Parameters defaults;
  ParameterList list;
  defaults.describe(list);
  return {{name, description, list.infos()}, [make](const ModelParameters& given) {
            Parameters parameters;
            ParameterList members;
            parameters.describe(members);
            members.set(given);
            return make(parameters);
          }};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> kEntries{
      entry("ground", "gently rolling grass with an optional flat corridor for a road from the origin to -Z",
            make_ground),
      entry("road", "an asphalt road with gravel shoulders from the origin to -Z", make_road),
      entry("road_markings", "edge lines and a dashed centre line; takes the road's parameters", make_road_markings),
      entry("zebra_crossing", "bars of a pedestrian crossing over a level road along Z", make_zebra_crossing),
      entry("box", "a box; bevel_m cuts its edges", make_block),
      entry("spruce", "a spruce with drooping branches", make_spruce),
      entry("broadleaf_tree", "a forking tree with sprays of leaves; leaves 0 is a winter tree", make_broadleaf_tree),
      entry("bush", "a leafy bush", make_bush),
      entry("forest", "spruces and broadleaf trees beside the path, standing on the ground of the same parameters",
            make_forest),
      entry("grass", "tufts of grass beside the path, standing on the ground of the same parameters", make_grass),
      entry("rock", "a boulder", make_rock),
      entry("rocks", "boulders beside the path, lying on the ground of the same parameters", make_rocks),
      entry("fence", "a wooden fence along the path", make_fence),
      entry("delineator", "a marker post with reflectors", make_delineator),
      entry("delineators", "marker posts on both sides of the path", make_delineators),
      entry("speed_sign", "a round sign with a number, facing +Z", make_speed_sign),
      entry("warning_sign", "a triangular sign with an exclamation mark, facing +Z", make_warning_sign),
      entry("street_lamp", "a mast with an arm to +X; its light leaves from (arm_m, height_m - 0.15, 0)",
            make_street_lamp),
      entry("utility_pole", "a wooden pole with a cross-arm", make_utility_pole),
      entry("power_line", "utility poles with wires along the path", make_power_line),
      entry("car", "a parked hatchback heading for -Z; paint 0 blue, 1 red, 2 white, 3 grey, 4 green", make_car),
      entry("house", "a house with a pitched roof, its door to +Z; lit is the fraction of bright windows", make_house),
      entry("apartment_house", "a flat-roofed town house, shops on its front to +Z; lit as the house's",
            make_apartment_house),
      entry("person", "a person in a coat, facing -Z; walks 1 in mid-step; coat as the car's paint", make_person),
      entry("room", "a room seen from inside: barrel vault along Z, piers, niches, a door at -Z", make_room),
      entry("panel", "a square wall facing +Z in cells x cells squares; wire 1 shows its triangles' edges alone",
            make_panel_model),
      entry("drum", "an upright cylinder in segments and rings; wire 1 shows its triangles' edges alone",
            make_drum_model),
      entry("crate", "a wooden crate", make_crate),
      entry("barrel", "a wooden barrel", make_barrel),
      entry("table", "a table, its length along X", make_dining_table),
      entry("chair", "a chair, its back at +Z", make_chair),
      entry("shelf", "a shelf with books, its front at +Z", make_shelf),
      entry("runway", "a runway of 45 m with its markings, from its threshold at the origin to -Z", make_runway),
      entry("papi_box", "a unit of a PAPI, facing +Z; its light leaves from (0, 0.55, 0.42)", make_papi_box),
      entry("approach_light", "lamps on a frangible mast, facing +Z, their middles at height_m", make_approach_light),
      entry("edge_light", "an elevated runway edge light; its light leaves from (0, 0.33, 0)", make_edge_light),
      entry("hangar", "an arched hangar, its doors to +Z, the front wall at z = 0", make_hangar),
      entry("tower", "a control tower, its door to +Z", make_tower),
      entry("lighthouse", "a round tower, its door to +Z; its light leaves from (0, height_m, 0)", make_lighthouse),
      entry("sea", "open water at y = 0", make_sea),
      entry("island", "a rocky island in a sea at y = 0, its middle level at height_m", make_island),
  };
  return kEntries;
}

}  // namespace

std::span<const ModelInfo> models() {
  static const std::vector<ModelInfo> kInfos = [] {
    std::vector<ModelInfo> infos;
    for (const Entry& each : entries()) infos.push_back(each.info);
    return infos;
  }();
  return kInfos;
}

const ModelInfo* find_model(std::string_view name) {
  for (const ModelInfo& info : models()) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

Model make_model(std::string_view name, const ModelParameters& parameters) {
  for (const Entry& each : entries()) {
    if (each.info.name == name) return each.make(parameters);
  }
  throw std::invalid_argument(fmt::format("model = {}: must be one of the catalogue", name));
}

}  // namespace litfog::scene
