// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"
#include "litfog/c/litfog.h"
#include "litfog/light.h"

// Converts a caller's structs to C++. Numbers that are no enumerator throw std::invalid_argument; all other rules are
// those of the C++ calls, which check them.

namespace litfog::c {

/// An enumerator of C++.
///
/// count   number of enumerators, from 0
/// name    name of the parameter or member
/// throws  std::invalid_argument
void require_enumerator(std::int32_t value, int count, const char* name);

FogMode fog_mode(std::int32_t mode);
LampLeg lamp_leg(std::int32_t leg);
Fog fog(const litfog_fog* fog);
Atmosphere atmosphere(const litfog_atmosphere* atmosphere);
Light light(const litfog_light* light);
PlacedLight placed_light(const litfog_placed_light* light);

/// A light without its name.
litfog_light light_of(const Light& light);

/// Three numbers.
glm::dvec3 vector(const double* numbers, const char* name);

}  // namespace litfog::c
