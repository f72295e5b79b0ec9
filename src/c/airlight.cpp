// SPDX-License-Identifier: Apache-2.0
#include "litfog/airlight.h"

#include <array>

#include "c/call.h"
#include "c/column.h"
#include "c/convert.h"
#include "c/layout.h"
#include "litfog/multiple_scattering.h"

using namespace litfog;

litfog_status litfog_airlight(const litfog_placed_light* light, const litfog_atmosphere* atmosphere,
                              const litfog_eye_ray* rays, size_t count, int32_t leg, double* airlights) {
  return c::call([&] {
    const std::span<const litfog_eye_ray> from = c::array(rays, count, "rays");
    const std::span<double> results = c::array(airlights, count, "airlights");
    c::expect_apart(std::array{c::Column(results, "airlights")}, std::array{c::Column(from, "rays")});
    airlight(c::placed_light(light), c::atmosphere(atmosphere), c::view_as_cpp(from), c::lamp_leg(leg), results);
  });
}

litfog_status litfog_axial_airlight(const litfog_light* light, const litfog_fog* fog, double* airlight) {
  return c::call([&] { c::at(airlight, "airlight") = axial_airlight(c::light(light), c::fog(fog)); });
}

litfog_status litfog_light_reach(const litfog_light* light, const litfog_fog* fog, double budget, int32_t leg,
                                 double* range) {
  return c::call([&] { c::at(range, "range") = light_reach(c::light(light), c::fog(fog), budget, c::lamp_leg(leg)); });
}

litfog_status litfog_reach_budget(double step, size_t lights, double brightness, const litfog_atmosphere* atmosphere,
                                  double* budget) {
  return c::call([&] { c::at(budget, "budget") = reach_budget(step, lights, brightness, c::atmosphere(atmosphere)); });
}

litfog_status litfog_make_scattering_table(const litfog_atmosphere* atmosphere, litfog_scattering_table* table) {
  return c::call([&] {
    litfog_scattering_table& result = c::at(table, "table");
    result = c::to_c<litfog_scattering_table>(make_scattering_table(c::atmosphere(atmosphere)));
  });
}

litfog_status litfog_effective_intensity(const litfog_attenuation* attenuation, double density, double* intensity) {
  return c::call([&] {
    c::at(intensity, "intensity") = effective_intensity(c::to_cpp(c::at(attenuation, "attenuation")), density);
  });
}

litfog_status litfog_multiple_scattering(const litfog_placed_light* light, const litfog_atmosphere* atmosphere,
                                         const litfog_scattering_table* table, const litfog_eye_ray* rays, size_t count,
                                         double* scattered) {
  return c::call([&] {
    const std::span<const litfog_eye_ray> from = c::array(rays, count, "rays");
    const std::span<double> results = c::array(scattered, count, "scattered");
    c::expect_apart(std::array{c::Column(results, "scattered")}, std::array{c::Column(from, "rays")});
    multiple_scattering(c::placed_light(light), c::atmosphere(atmosphere), c::to_cpp(c::at(table, "table")),
                        c::view_as_cpp(from), results);
  });
}
