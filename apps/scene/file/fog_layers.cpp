// SPDX-License-Identifier: Apache-2.0
#include "scene/file/fog_layers.h"

#include <stdexcept>

namespace litfog::scene {
namespace {

FogLayer read_layer(const files::JsonValue& value) {
  value.allow_only({"base_m", "top_m", "transition_m", "visibility_m"});
  const FogLayer layer{.base = value.number_or("base_m", FogLayer{}.base),
                       .top = value.number_or("top_m", FogLayer{}.top),
                       .transition = value.number_or("transition_m", 0),
                       .visibility = value.member("visibility_m").number()};
  if (const auto error = find_error(layer)) value.member(std::string(error->field) + "_m").fail(error->rule);
  return layer;
}

}  // namespace

std::vector<FogLayer> read_fog_layers(const files::JsonValue& value) {
  std::vector<FogLayer> layers;
  for (const files::JsonValue& layer : value.items()) layers.push_back(read_layer(layer));
  try {
    make_density_profile(layers);
  } catch (const std::invalid_argument&) {  // no single layer is wrong
    value.fail("must have at most 8 heights at which its density bends: 4 a layer, 2 where it has no base or no top");
  }
  return layers;
}

std::vector<FogLayer> read_fog_layers(const std::string& path) { return read_fog_layers(files::read_json(path)); }

}  // namespace litfog::scene
