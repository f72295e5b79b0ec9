// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>

#include "litfog/light.h"
#include "scene/scene.h"

namespace litfog::scene {

inline constexpr std::size_t kMaxCityLights = 100'000;

/// A city at night, a square kilometre and a half around the origin: streets every 90 m along X and Z with lamps and
/// cars, houses with shops and bright windows, and an airfield along -Z to the east of it.
///
/// Houses, streets and cars do not depend on the number of lights. Lights are the first ones of one list: lamps, shops,
/// cars and the airfield from the origin outwards, some 3,700, then windows in the same order.
struct City {
  std::size_t lights = 1000;  ///< [1, kMaxCityLights]
  std::uint32_t seed = 1;
  std::set<std::size_t> without = {};  ///< indices in that list of lights that are off
  Light street_lamp;                   ///< shines down
  Light headlight;                     ///< cars', like the tail lamp
  Light tail_lamp;
  Light shop_window;  ///< shines out of a house, as the window
  Light window;
  Light runway_edge;     ///< shines along the runway
  Light approach_light;  ///< before the runway's threshold
};

/// One of a city's kinds of lights.
struct CityLightKind {
  const char* name;  ///< in a scene file
  Light City::*light;
};

inline constexpr std::array kCityLightKinds{CityLightKind{"street_lamp", &City::street_lamp},
                                            CityLightKind{"headlight", &City::headlight},
                                            CityLightKind{"tail_lamp", &City::tail_lamp},
                                            CityLightKind{"shop_window", &City::shop_window},
                                            CityLightKind{"window", &City::window},
                                            CityLightKind{"runway_edge", &City::runway_edge},
                                            CityLightKind{"approach_light", &City::approach_light}};

/// Adds a city's models, instances and lights, and their members of a scene file. Deterministic.
///
/// throws  std::invalid_argument for more lights than the city has lamps
void add_city(Scene& scene, const City& city);

}  // namespace litfog::scene
