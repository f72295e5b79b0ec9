// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "litfog/airlight.h"
#include "litfog/atmosphere.h"
#include "litfog/c/litfog.h"
#include "litfog/light.h"

// Converts a caller's structs to C++. Numbers that are not enumerators throw std::invalid_argument; the C++ calls check
// all other rules.

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

/// A caller's array, by its name in errors.
struct Column {
  template <typename T>
  Column(std::span<T> values, const char* its_name) : bytes(std::as_bytes(values)), name(its_name) {}

  std::span<const std::byte> bytes;
  const char* name;
};

/// Throws std::invalid_argument if a column of results shares memory with another or with one that is read. Allocates
/// only then.
void expect_apart(std::span<const Column> results, std::span<const Column> read);

}  // namespace litfog::c
