// SPDX-License-Identifier: Apache-2.0
#include "litfog/airlight.h"

#include <array>

#include "c/call.h"
#include "c/column.h"
#include "c/convert.h"
#include "c/layout.h"

using namespace litfog;

namespace {

LampLeg lamp_leg(int32_t leg) {
  c::require_enumerator(leg, 2, "lamp_leg");
  return LampLeg(leg);
}

}  // namespace

litfog_status litfog_airlight(const litfog_placed_light* light, const litfog_atmosphere* atmosphere,
                              const litfog_eye_ray* rays, size_t count, int32_t leg, double* airlights) {
  return c::call([&] {
    const std::span<const litfog_eye_ray> from = c::array(rays, count, "rays");
    const std::span<double> results = c::array(airlights, count, "airlights");
    c::expect_apart(std::array{c::Column(results, "airlights")}, std::array{c::Column(from, "rays")});
    airlight(c::placed_light(light), c::atmosphere(atmosphere), c::view_as_cpp(from), lamp_leg(leg), results);
  });
}

litfog_status litfog_axial_airlight(const litfog_light* light, const litfog_fog* fog, double* airlight) {
  return c::call([&] { c::at(airlight, "airlight") = axial_airlight(c::light(light), c::fog(fog)); });
}

litfog_status litfog_light_reach(const litfog_light* light, const litfog_fog* fog, double budget, int32_t leg,
                                 double* range) {
  return c::call([&] { c::at(range, "range") = light_reach(c::light(light), c::fog(fog), budget, lamp_leg(leg)); });
}
