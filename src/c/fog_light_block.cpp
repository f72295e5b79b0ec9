// SPDX-License-Identifier: Apache-2.0
#include "litfog/fog_light_block.h"

#include <vector>

#include "c/call.h"
#include "c/convert.h"
#include "c/layout.h"
#include "model/require.h"
#include "tables/fog_light_count.h"

using namespace litfog;

litfog_status litfog_pack_fog_header(const litfog_atmosphere* atmosphere, size_t instances, litfog_fog_header* header) {
  return c::call([&] {
    c::at(header, "header") = c::to_c<litfog_fog_header>(pack_fog_header(c::atmosphere(atmosphere), instances));
  });
}

litfog_status litfog_pack_fog_light_block(const litfog_atmosphere* atmosphere, const litfog_placed_light* lights,
                                          size_t count, litfog_fog_light_block* block) {
  return c::call([&] {
    require_fog_light_count("count", count);  // before any light is read
    const Atmosphere in = c::atmosphere(atmosphere);
    std::vector<PlacedLight> placed;
    std::vector<FogIntensity> solutions;
    for (const litfog_placed_light& light : c::array(lights, count, "lights")) {
      placed.push_back(c::placed_light(&light));
      solutions.push_back(solve_fog_intensity(placed.back().light, in.fog));
    }
    c::at(block, "block") = c::to_c<litfog_fog_light_block>(pack_fog_light_block(in, placed, solutions));
  });
}
