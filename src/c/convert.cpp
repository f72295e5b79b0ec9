// SPDX-License-Identifier: Apache-2.0
#include "c/convert.h"

#include <functional>
#include <stdexcept>
#include <string>

#include "c/call.h"
#include "c/layout.h"

namespace litfog::c {

void require_enumerator(std::int32_t value, int count, const char* name) {
  if (value >= 0 && value < count) return;
  throw std::invalid_argument(std::string(name) + " = " + std::to_string(value) + ": must be in [0, " +
                              std::to_string(count - 1) + "]");
}

FogMode fog_mode(std::int32_t mode) {
  require_enumerator(mode, 2, "fog.mode");
  return FogMode(mode);
}

LampLeg lamp_leg(std::int32_t leg) {
  require_enumerator(leg, 2, "lamp_leg");
  return LampLeg(leg);
}

Fog fog(const litfog_fog* fog) {
  fog_mode(at(fog, "fog").mode);
  return to_cpp(*fog);
}

Atmosphere atmosphere(const litfog_atmosphere* atmosphere) {
  fog_mode(at(atmosphere, "atmosphere").fog.mode);
  return to_cpp(*atmosphere);
}

Light light(const litfog_light* light) {
  require_enumerator(at(light, "light").cone.profile, int(kConeProfiles.size()), "cone.profile");
  return {.name = {},
          .color = vector(light->color, "color"),
          .attenuation = to_cpp(light->attenuation),
          .threshold = light->threshold,
          .cone = to_cpp(light->cone),
          .density_scale = light->density_scale,
          .source_radius = light->source_radius,
          .flash = to_cpp(light->flash)};
}

PlacedLight placed_light(const litfog_placed_light* placed) {
  return {.light = light(&at(placed, "light").light),
          .position = vector(placed->position, "position"),
          .direction = vector(placed->direction, "direction"),
          .carried = placed->carried != 0};
}

glm::dvec3 vector(const double* numbers, const char* name) {
  at(numbers, name);
  return {numbers[0], numbers[1], numbers[2]};
}

namespace {

bool overlap(std::span<const std::byte> a, std::span<const std::byte> b) {
  if (a.empty() || b.empty()) return false;
  constexpr std::less<const std::byte*> is_before{};  // orders pointers into different arrays, too
  return is_before(a.data(), b.data() + b.size()) && is_before(b.data(), a.data() + a.size());
}

void expect_apart(const Column& results, const Column& other) {
  if (!overlap(results.bytes, other.bytes)) return;
  throw std::invalid_argument(std::string(results.name) + ": must not overlap " + other.name);
}

}  // namespace

void expect_apart(std::span<const Column> results, std::span<const Column> read) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const Column& column : read) expect_apart(results[i], column);
    for (const Column& other : results.first(i)) expect_apart(results[i], other);
  }
}

}  // namespace litfog::c
