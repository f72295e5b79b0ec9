// SPDX-License-Identifier: Apache-2.0
#include "litfog/light.h"

#include <cmath>
#include <utility>

#include "c/call.h"
#include "c/convert.h"
#include "c/layout.h"
#include "litfog/fog.h"
#include "litfog/runway_visual_range.h"
#include "litfog/visual_threshold.h"
#include "model/require.h"

using namespace litfog;

namespace {

void write(const glm::dvec3& vector, double* numbers) {
  for (int i = 0; i < 3; ++i) numbers[i] = vector[i];
}

}  // namespace

litfog_light c::light_of(const Light& light) {
  litfog_light result{};
  write(light.color, result.color);
  result.attenuation = to_c<litfog_attenuation>(light.attenuation);
  result.threshold = light.threshold;
  result.cone = to_c<litfog_cone>(light.cone);
  result.density_scale = light.density_scale;
  result.source_radius = light.source_radius;
  result.flash = to_c<litfog_flash>(light.flash);
  return result;
}

litfog_status litfog_fog_from_visibility(int32_t mode, double metres, double contrast, litfog_fog* fog) {
  return c::call(
      [&] { c::at(fog, "fog") = c::to_c<litfog_fog>(Fog::from_visibility(c::fog_mode(mode), metres, contrast)); });
}

litfog_status litfog_phase_droplets(double micrometres, litfog_phase* phase) {
  return c::call([&] { c::at(phase, "phase") = c::to_c<litfog_phase>(Phase::droplets(micrometres)); });
}

litfog_status litfog_fog_from_runway_visual_range(int32_t mode, double metres, double candela,
                                                  double illuminance_threshold, litfog_fog* fog) {
  return c::call([&] {
    c::at(fog, "fog") =
        c::to_c<litfog_fog>(fog_from_runway_visual_range(c::fog_mode(mode), metres, {candela, illuminance_threshold}));
  });
}

litfog_status litfog_runway_visual_range(const litfog_fog* fog, double candela, double illuminance_threshold,
                                         double* metres) {
  return c::call([&] { c::at(metres, "metres") = runway_visual_range(c::fog(fog), {candela, illuminance_threshold}); });
}

litfog_status litfog_illuminance_threshold(double background, double* lux) {
  return c::call([&] {
    require_background(background);
    c::at(lux, "lux") = illuminance_threshold(background);
  });
}

litfog_status litfog_density_profile_from_layers(const litfog_fog_layer* layers, size_t count, double contrast,
                                                 litfog_density_profile* profile) {
  return c::call([&] {
    const auto stated = c::view_as_cpp<litfog_fog_layer>(c::array(layers, count, "layers"));
    c::at(profile, "profile") = c::to_c<litfog_density_profile>(make_density_profile(stated, contrast));
  });
}

litfog_status litfog_fog_between(const litfog_atmosphere* atmosphere, double height_a, double height_b,
                                 litfog_fog* fog) {
  return c::call([&] {
    const Atmosphere air = c::atmosphere(atmosphere);
    require(find_error(air));
    for (const auto& [name, height] : {std::pair("height_a", height_a), std::pair("height_b", height_b)}) {
      if (!std::isfinite(height)) require(ValueError{name, height, "must be finite"});
    }
    c::at(fog, "fog") = c::to_c<litfog_fog>(air.fog_between(height_a, height_b));
  });
}

litfog_status litfog_default_atmosphere(litfog_atmosphere* atmosphere) {
  return c::call([&] { c::at(atmosphere, "atmosphere") = c::to_c<litfog_atmosphere>(Atmosphere{}); });
}

litfog_status litfog_default_light(litfog_light* light) {
  return c::call([&] { c::at(light, "light") = c::light_of({}); });
}

litfog_status litfog_default_placed_light(litfog_placed_light* light) {
  return c::call([&] {
    const PlacedLight placed;
    litfog_placed_light result{};
    result.light = c::light_of(placed.light);
    write(placed.position, result.position);
    write(placed.direction, result.direction);
    result.carried = placed.carried;
    c::at(light, "light") = result;
  });
}

litfog_status litfog_photometric(const litfog_light* light, litfog_light* result) {
  return c::call([&] { c::at(result, "photometric") = c::light_of(photometric(c::light(light))); });
}

litfog_status litfog_candela(const litfog_light* light, double* result) {
  return c::call([&] { write(candela(c::light(light)), &c::at(result, "candela")); });
}

litfog_status litfog_flash_at(const litfog_flash* flash, double seconds, double* factor) {
  return c::call([&] {
    const Flash checked = c::to_cpp(c::at(flash, "flash"));
    require(find_error(checked));
    require_time(seconds);
    c::at(factor, "factor") = flash_at(checked, seconds);
  });
}

litfog_status litfog_check_fog(const litfog_fog* fog) {
  return c::call([&] { require(find_error(c::fog(fog))); });
}

litfog_status litfog_check_atmosphere(const litfog_atmosphere* atmosphere) {
  return c::call([&] { require(find_error(c::atmosphere(atmosphere))); });
}

litfog_status litfog_check_light(const litfog_light* light) {
  return c::call([&] { require(find_error(c::light(light))); });
}

litfog_status litfog_check_placed_light(const litfog_placed_light* light) {
  return c::call([&] { require(find_error(c::placed_light(light))); });
}
