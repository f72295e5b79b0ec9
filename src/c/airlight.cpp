// SPDX-License-Identifier: Apache-2.0
#include "litfog/airlight.h"

#include <array>

#include "c/call.h"
#include "c/convert.h"
#include "c/layout.h"
#include "litfog/directional_airlight.h"
#include "litfog/multiple_scattering.h"
#include "model/require.h"

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

litfog_status litfog_directional_airlight(const litfog_atmosphere* atmosphere, const double* to_light,
                                          const litfog_eye_ray* rays, size_t count, double* airlights) {
  return c::call([&] {
    const std::span<const litfog_eye_ray> from = c::array(rays, count, "rays");
    const std::span<double> results = c::array(airlights, count, "airlights");
    c::expect_apart(std::array{c::Column(results, "airlights")}, std::array{c::Column(from, "rays")});
    directional_airlight(c::atmosphere(atmosphere), c::vector(to_light, "to_light"), c::view_as_cpp(from), results);
  });
}

litfog_status litfog_directional_fog_factor(const litfog_atmosphere* atmosphere, const double* to_light, double height,
                                            double* factor) {
  return c::call([&] {
    c::at(factor, "factor") =
        directional_fog_factor(c::atmosphere(atmosphere), c::vector(to_light, "to_light"), height);
  });
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

litfog_status litfog_make_thin_beams(const litfog_atmosphere* atmosphere, const litfog_scattering_table* table,
                                     litfog_thin_beams* beams) {
  return c::call([&] {
    litfog_thin_beams& result = c::at(beams, "beams");
    result = c::to_c<litfog_thin_beams>(make_thin_beams(c::atmosphere(atmosphere), c::to_cpp(c::at(table, "table"))));
  });
}

litfog_status litfog_make_scattering_source(const litfog_light* light, const litfog_atmosphere* atmosphere,
                                            const litfog_thin_beams* beams, litfog_scattering_source* source) {
  return c::call([&] {
    litfog_scattering_source& result = c::at(source, "source");
    const ScatteringSource made =
        scattering_source(c::light(light), c::atmosphere(atmosphere), c::to_cpp(c::at(beams, "beams")));
    result = {.intensity = made.intensity,
              .soft_range = made.soft_range,
              .phase_cosine = made.phase_cosine,
              .is_cone = made.is_cone,
              .beam = c::to_c<litfog_scattered_beam>(made.beam)};
  });
}

litfog_status litfog_scattered_light(const litfog_placed_light* light, const litfog_scattering_source* source,
                                     const litfog_atmosphere* atmosphere, const double* positions, size_t count,
                                     litfog_diffuse_light* scattered) {
  return c::call([&] {
    static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
    const litfog_scattering_source& from = c::at(source, "source");
    const auto places = c::array(reinterpret_cast<const glm::dvec3*>(positions), count, "positions");
    const std::span<litfog_diffuse_light> results = c::array(scattered, count, "scattered");
    c::expect_apart(std::array{c::Column(results, "scattered")}, std::array{c::Column(places, "positions")});
    scattered_light(c::placed_light(light),
                    {.intensity = from.intensity,
                     .soft_range = from.soft_range,
                     .phase_cosine = from.phase_cosine,
                     .is_cone = from.is_cone != 0,
                     .beam = c::to_cpp(from.beam)},
                    c::atmosphere(atmosphere), places,
                    {reinterpret_cast<DiffuseLight*>(results.data()), results.size()});
  });
}

litfog_status litfog_irradiance(const litfog_diffuse_light* light, const double* normal, double* irradiance) {
  return c::call([&] {
    c::at(irradiance, "irradiance") = litfog::irradiance(c::to_cpp(c::at(light, "light")), c::vector(normal, "normal"));
  });
}
