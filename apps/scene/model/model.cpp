// SPDX-License-Identifier: Apache-2.0
#include "scene/model/model.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <type_traits>

#include "scene/model/airfield.h"
#include "scene/model/broadleaf.h"
#include "scene/model/car.h"
#include "scene/model/conifer.h"
#include "scene/model/forest.h"
#include "scene/model/furniture.h"
#include "scene/model/house.h"
#include "scene/model/primitive.h"
#include "scene/model/roadside.h"
#include "scene/model/rock.h"
#include "scene/model/room.h"
#include "scene/model/runway.h"
#include "scene/model/sign.h"
#include "scene/model/terrain.h"
#include "scene/model/tessellation.h"

namespace litfog::scene {
namespace {

/// The shortest decimal that gives the float, so that 0.12f is listed as 0.12.
double decimal(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", static_cast<double>(value));
  return std::stod(text);
}

/// A parameter of a builder: its default is the one in the builder's struct, and nowhere else.
template <typename Parameters>
struct Field {
  Field(std::string_view name, float Parameters::*member, double minimum, double maximum)
      : info{name, decimal(Parameters{}.*member), minimum, maximum, false},
        set([member](Parameters& to, double value) { to.*member = static_cast<float>(value); }) {}
  Field(std::string_view name, int Parameters::*member, double minimum, double maximum)
      : info{name, static_cast<double>(Parameters{}.*member), minimum, maximum, true},
        set([member](Parameters& to, double value) { to.*member = static_cast<int>(value); }) {}
  ParameterInfo info;
  std::function<void(Parameters&, double)> set;
};

struct Entry {
  ModelInfo info;
  std::function<Model(const ModelParameters&)> make;
};

/// What stands beside a bend must not reach its centre.
void check(const Path& path) {
  constexpr double kLeastRadius_m = 100.0;
  const double most = 0.5 * double{path.length_m} * double{path.length_m} / kLeastRadius_m;
  if (!(std::abs(double{path.bend_m}) <= most * (1.0 + 1e-6))) {
    throw std::invalid_argument("bend_m = " + std::to_string(path.bend_m) +
                                ": must be at most length_m^2 / 200 = " + std::to_string(most) + ", a radius of 100 m");
  }
}

template <typename Parameters>
Entry entry(std::string_view name, std::string_view description, Model (*make)(const Parameters&),
            std::vector<Field<Parameters>> fields) {
  Entry made{{name, description, {}}, {}};
  for (const Field<Parameters>& field : fields) made.info.parameters.push_back(field.info);
  made.make = [make, fields = std::move(fields)](const ModelParameters& given) {
    Parameters parameters{};
    for (const auto& [key, value] : given.values()) {
      for (const Field<Parameters>& field : fields) {
        if (field.info.name == key) field.set(parameters, value);
      }
    }
    if constexpr (std::is_base_of_v<Path, Parameters>) check(parameters);
    return make(parameters);
  };
  return made;
}

constexpr double kMostSeed = 1e6;

struct Box {
  float width_m = 1.0f;
  float height_m = 1.0f;
  float depth_m = 1.0f;
  float bevel_m = 0.0f;
};

Model make_box_model(const Box& box) {
  const glm::vec3 size(box.width_m, box.height_m, box.depth_m);
  const float bevel = std::min(box.bevel_m, 0.45f * std::min(size.x, std::min(size.y, size.z)));
  return {{"concrete", bevel > 0.0f ? make_bevelled_box(size, bevel) : make_box(size)}};
}

/// The parameters of a model that belong to its base: added to those of its own.
template <typename Parameters>
std::vector<Field<Parameters>> with_path(std::vector<Field<Parameters>> own) {
  own.insert(own.end(), {{"length_m", &Parameters::length_m, 10, 4000}, {"bend_m", &Parameters::bend_m, -200, 200}});
  return own;
}

template <typename Parameters>
std::vector<Field<Parameters>> with_row(std::vector<Field<Parameters>> own, double least_spacing) {
  own.insert(own.end(),
             {{"offset_m", &Parameters::offset_m, -80, 80}, {"spacing_m", &Parameters::spacing_m, least_spacing, 500}});
  return with_path(std::move(own));
}

template <typename Parameters>
std::vector<Field<Parameters>> with_plate(std::vector<Field<Parameters>> own) {
  own.insert(own.end(), {{"size_m", &Parameters::size_m, 0.2, 3}, {"height_m", &Parameters::height_m, 0.5, 8}});
  return own;
}

template <typename Parameters>
std::vector<Field<Parameters>> with_ground(std::vector<Field<Parameters>> own) {
  own.insert(own.end(), {{"relief_m", &Parameters::relief_m, 0, 10},
                         {"bank_m", &Parameters::bank_m, -10, 30},
                         {"corridor_m", &Parameters::corridor_m, 0, 500},
                         {"corridor_drop_m", &Parameters::corridor_drop_m, 0, 2},
                         {"ground_seed", &Parameters::ground_seed, 0, kMostSeed}});
  return with_path(std::move(own));
}

template <typename Parameters>
std::vector<Field<Parameters>> with_band(std::vector<Field<Parameters>> own) {
  own.insert(own.end(), {{"from_m", &Parameters::from_m, -4000, 4000},
                         {"to_m", &Parameters::to_m, -4000, 4000},
                         {"clear_m", &Parameters::clear_m, 0, 1000},
                         {"reach_m", &Parameters::reach_m, 0, 1000},
                         {"side", &Parameters::side, -1, 1},
                         {"seed", &Parameters::seed, 0, kMostSeed}});
  return with_ground(std::move(own));
}

std::vector<Entry> make_entries() {
  return {
      entry<Ground>("ground", "gently rolling grass with an optional flat corridor for a road from the origin to -Z",
                    make_ground,
                    with_ground<Ground>({{"width_m", &Ground::width_m, 1, 4000},
                                         {"depth_m", &Ground::depth_m, 1, 4000},
                                         {"centre_z_m", &Ground::centre_z_m, -4000, 4000},
                                         {"cell_m", &Ground::cell_m, 0.25, 100}})),
      entry<Road>("road", "an asphalt road with gravel shoulders from the origin to -Z", make_road,
                  with_path<Road>({{"width_m", &Road::width_m, 3, 20},
                                   {"shoulder_m", &Road::shoulder_m, 0.2, 5},
                                   {"camber", &Road::camber, 0, 0.08}})),
      entry<RoadMarkings>("road_markings", "edge lines and a dashed centre line; takes the road's parameters",
                          make_road_markings,
                          with_path<RoadMarkings>({{"width_m", &RoadMarkings::width_m, 3, 20},
                                                   {"camber", &RoadMarkings::camber, 0, 0.08},
                                                   {"dash_m", &RoadMarkings::dash_m, 1, 30},
                                                   {"gap_m", &RoadMarkings::gap_m, 0, 30},
                                                   {"line_m", &RoadMarkings::line_m, 0.05, 0.5},
                                                   {"lift_m", &RoadMarkings::lift_m, 0.002, 0.1}})),
      entry<Box>("box", "a box; bevel_m cuts its edges", make_box_model,
                 {{"width_m", &Box::width_m, 0.01, 1000},
                  {"height_m", &Box::height_m, 0.01, 1000},
                  {"depth_m", &Box::depth_m, 0.01, 1000},
                  {"bevel_m", &Box::bevel_m, 0, 1}}),
      entry<Spruce>("spruce", "a spruce with drooping branches", make_spruce,
                    {{"height_m", &Spruce::height_m, 1, 40},
                     {"spread", &Spruce::spread, 0.1, 0.5},
                     {"bare", &Spruce::bare, 0, 0.6},
                     {"whorls", &Spruce::whorls, 4, 40},
                     {"branches", &Spruce::branches, 3, 12},
                     {"twigs", &Spruce::twigs, 2, 8},
                     {"seed", &Spruce::seed, 0, kMostSeed}}),
      entry<BroadleafTree>("broadleaf_tree", "a forking tree with sprays of leaves; leaves 0 is a winter tree",
                           make_broadleaf_tree,
                           {{"height_m", &BroadleafTree::height_m, 1, 30},
                            {"spread", &BroadleafTree::spread, 0.2, 1},
                            {"leaves", &BroadleafTree::leaves, 0, 1},
                            {"leaf_m", &BroadleafTree::leaf_m, 0.05, 0.5},
                            {"forks", &BroadleafTree::forks, 2, 3},
                            {"seed", &BroadleafTree::seed, 0, kMostSeed}}),
      entry<Bush>("bush", "a leafy bush", make_bush,
                  {{"height_m", &Bush::height_m, 0.3, 4},
                   {"leaves", &Bush::leaves, 0, 1},
                   {"leaf_m", &Bush::leaf_m, 0.05, 0.5},
                   {"stems", &Bush::stems, 1, 16},
                   {"seed", &Bush::seed, 0, kMostSeed}}),
      entry<Forest>("forest",
                    "spruces and broadleaf trees beside the path, standing on the ground of the same parameters",
                    make_forest,
                    with_band<Forest>({{"trees", &Forest::trees, 0, 300},
                                       {"spacing_m", &Forest::spacing_m, 0, 20},
                                       {"least_height_m", &Forest::least_height_m, 1, 40},
                                       {"most_height_m", &Forest::most_height_m, 1, 40},
                                       {"broadleaf", &Forest::broadleaf, 0, 1},
                                       {"leaves", &Forest::leaves, 0, 1}})),
      entry<Grass>("grass", "tufts of grass beside the path, standing on the ground of the same parameters", make_grass,
                   with_band<Grass>({{"tufts", &Grass::tufts, 0, 20000},
                                     {"blades", &Grass::blades, 1, 16},
                                     {"height_m", &Grass::height_m, 0.03, 2}})),
      entry<Rock>("rock", "a boulder", make_rock,
                  {{"size_m", &Rock::size_m, 0.05, 10}, {"seed", &Rock::seed, 0, kMostSeed}}),
      entry<Rocks>("rocks", "boulders beside the path, lying on the ground of the same parameters", make_rocks,
                   with_band<Rocks>({{"rocks", &Rocks::rocks, 0, 200},
                                     {"least_size_m", &Rocks::least_size_m, 0.05, 10},
                                     {"most_size_m", &Rocks::most_size_m, 0.05, 10}})),
      entry<Fence>("fence", "a wooden fence along the path", make_fence,
                   with_row<Fence>({{"height_m", &Fence::height_m, 0.4, 3},
                                    {"rails", &Fence::rails, 1, 6},
                                    {"seed", &Fence::seed, 0, kMostSeed}},
                                   1)),
      entry<GuardRail>("guard_rail", "a steel crash barrier along the path, its beam towards the path's middle",
                       make_guard_rail, with_row<GuardRail>({}, 1)),
      entry<Delineator>("delineator", "a marker post with reflectors", make_delineator,
                        {{"height_m", &Delineator::height_m, 0.4, 2}}),
      entry<Delineators>("delineators", "marker posts on both sides of the path", make_delineators,
                         with_row<Delineators>({{"height_m", &Delineators::height_m, 0.4, 2}}, 2)),
      entry<SpeedSign>("speed_sign", "a round sign with a number, facing +Z", make_speed_sign,
                       with_plate<SpeedSign>({{"number", &SpeedSign::number, 1, 99}})),
      entry<Sign>("warning_sign", "a triangular sign with an exclamation mark, facing +Z", make_warning_sign,
                  with_plate<Sign>({})),
      entry<Sign>("direction_sign", "a blue rectangular sign with an arrow, facing +Z", make_direction_sign,
                  with_plate<Sign>({})),
      entry<Chevron>("chevron_sign", "red and white chevrons into a bend, facing +Z; left 1 turns them",
                     make_chevron_sign, with_plate<Chevron>({{"left", &Chevron::left, 0, 1}})),
      entry<StreetLamp>("street_lamp", "a mast with an arm to +X; its light leaves from (arm_m, height_m - 0.15, 0)",
                        make_street_lamp,
                        {{"height_m", &StreetLamp::height_m, 3, 15}, {"arm_m", &StreetLamp::arm_m, 0.6, 4}}),
      entry<UtilityPole>("utility_pole", "a wooden pole with a cross-arm", make_utility_pole,
                         {{"height_m", &UtilityPole::height_m, 4, 15}}),
      entry<PowerLine>("power_line", "utility poles with wires along the path", make_power_line,
                       with_row<PowerLine>({{"height_m", &PowerLine::height_m, 4, 15}}, 10)),
      entry<Car>("car", "a parked hatchback heading for -Z; paint 0 blue, 1 red, 2 white, 3 grey, 4 green", make_car,
                 {{"paint", &Car::paint, 0, 4}, {"lights", &Car::lights, 0, 1}, {"number", &Car::number, 0, 99}}),
      entry<House>("house", "a house with a pitched roof, its door to +Z; lit is the share of bright windows",
                   make_house,
                   {{"width_m", &House::width_m, 4, 40},
                    {"depth_m", &House::depth_m, 4, 20},
                    {"storeys", &House::storeys, 1, 4},
                    {"pitch_deg", &House::pitch_deg, 15, 60},
                    {"brick", &House::brick, 0, 1},
                    {"lit", &House::lit, 0, 1},
                    {"seed", &House::seed, 0, kMostSeed}}),
      entry<Room>("room", "a room seen from inside: barrel vault along Z, piers, niches, a door at -Z", make_room,
                  {{"width_m", &Room::width_m, 3, 30},
                   {"depth_m", &Room::depth_m, 4, 60},
                   {"wall_m", &Room::wall_m, 2.4, 10},
                   {"rise_m", &Room::rise_m, 0.3, 10},
                   {"bays", &Room::bays, 1, 40}}),
      entry<Panel>(
          "panel", "a square wall facing +Z in cells x cells squares; wire 1 shows its triangles' edges alone",
          make_panel_model,
          {{"size_m", &Panel::size_m, 0.1, 100}, {"cells", &Panel::cells, 1, 256}, {"wire", &Panel::wire, 0, 1}}),
      entry<Drum>("drum", "an upright cylinder in segments and rings; wire 1 shows its triangles' edges alone",
                  make_drum_model,
                  {{"radius_m", &Drum::radius_m, 0.1, 50},
                   {"height_m", &Drum::height_m, 0.1, 100},
                   {"segments", &Drum::segments, 3, 256},
                   {"rings", &Drum::rings, 1, 256},
                   {"wire", &Drum::wire, 0, 1}}),
      entry<Crate>("crate", "a wooden crate", make_crate, {{"size_m", &Crate::size_m, 0.2, 3}}),
      entry<Barrel>("barrel", "a wooden barrel", make_barrel, {{"height_m", &Barrel::height_m, 0.3, 3}}),
      entry<Table>("table", "a table, its length along X", make_table,
                   {{"length_m", &Table::length_m, 0.5, 5},
                    {"width_m", &Table::width_m, 0.4, 2},
                    {"height_m", &Table::height_m, 0.4, 1.2}}),
      entry<Chair>("chair", "a chair, its back at +Z", make_chair, {{"seat_m", &Chair::seat_m, 0.3, 0.8}}),
      entry<Shelf>("shelf", "a shelf with books, its front at +Z", make_shelf,
                   {{"width_m", &Shelf::width_m, 0.4, 4},
                    {"height_m", &Shelf::height_m, 0.6, 3},
                    {"books", &Shelf::books, 0, 1},
                    {"seed", &Shelf::seed, 0, kMostSeed}}),
      entry<Runway>("runway", "a runway of 45 m with its markings, from its threshold at the origin to -Z", make_runway,
                    {{"length_m", &Runway::length_m, 900, 4000},
                     {"number", &Runway::number, 1, 36},
                     {"shoulder_m", &Runway::shoulder_m, 1, 30},
                     {"lift_m", &Runway::lift_m, 0.005, 0.2}}),
      entry<PapiBox>("papi_box", "a unit of a PAPI, facing +Z; its light leaves from (0, 0.55, 0.42)", make_papi_box,
                     {{"white", &PapiBox::white, 0, 1}}),
      entry<ApproachLight>("approach_light", "lamps on a frangible mast, facing +Z, their middles at height_m",
                           make_approach_light,
                           {{"height_m", &ApproachLight::height_m, 0.4, 30},
                            {"lamps", &ApproachLight::lamps, 1, 11},
                            {"spacing_m", &ApproachLight::spacing_m, 0.3, 5},
                            {"red", &ApproachLight::red, 0, 1}}),
      entry<EdgeLight>("edge_light", "an elevated runway edge light; its light leaves from (0, 0.33, 0)",
                       make_edge_light, {{"red", &EdgeLight::red, 0, 1}}),
      entry<Hangar>("hangar", "an arched hangar, its doors to +Z, the front wall at z = 0", make_hangar,
                    {{"width_m", &Hangar::width_m, 8, 80},
                     {"depth_m", &Hangar::depth_m, 5, 120},
                     {"height_m", &Hangar::height_m, 4, 25},
                     {"lit", &Hangar::lit, 0, 1}}),
      entry<Tower>("tower", "a control tower, its door to +Z", make_tower,
                   {{"height_m", &Tower::height_m, 10, 60}, {"lit", &Tower::lit, 0, 1}}),
  };
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> kEntries = make_entries();
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

std::string refusal(const ParameterInfo& parameter, double value) {
  if (!(value >= parameter.minimum && value <= parameter.maximum)) {
    char text[96];
    std::snprintf(text, sizeof text, "must be in [%.7g, %.7g]", parameter.minimum, parameter.maximum);
    return text;
  }
  if (parameter.whole && value != std::floor(value)) return "must be a whole number";
  return {};
}

Model make_model(std::string_view name, const ModelParameters& parameters) {
  for (const Entry& each : entries()) {
    if (each.info.name != name) continue;
    for (const auto& [key, value] : parameters.values()) {
      const ParameterInfo* known = nullptr;
      for (const ParameterInfo& parameter : each.info.parameters) {
        if (parameter.name == key) known = &parameter;
      }
      if (known == nullptr) throw std::invalid_argument(each.info.name.data() + (": no parameter " + key));
      const std::string rule = refusal(*known, value);
      if (!rule.empty()) {
        throw std::invalid_argument(std::string(name) + ": " + key + " = " + std::to_string(value) + ": " + rule);
      }
    }
    return each.make(parameters);
  }
  throw std::invalid_argument("no model " + std::string(name));
}

}  // namespace litfog::scene
