// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "litfog/fit/attenuation_fit.h"
#include "litfog/fit/cone_fit.h"
#include "litfog/photometry/luminaire.h"

namespace litfog::fit {

/// A light that is to be fitted, from a light-spec file (litfog/files/light_spec_file.h) or a photometric file.
struct LightTarget {
  std::string file = {};
  std::string name = {};
  std::vector<std::string> source = {};
  glm::dvec3 color{1.0};
  double density_scale = 1;
  std::optional<AttenuationTarget> range = std::nullopt;
  /// With the luminaire's profile as its samples, if there is a luminaire.
  std::optional<ConeTarget> cone = std::nullopt;
  std::optional<Luminaire> luminaire = std::nullopt;
};

/// Reads a light-spec file and the photometric file that it names. Throws InputError, also for what the fits do not
/// take.
///
/// profile  replaces the file's own, if given
LightTarget read_spec(const std::string& path, std::optional<ConeChoice> profile = std::nullopt);

/// Reads a photometric file: the beam about its axis, white, and an extent by illuminance: C = 1, L = 0, and the
/// attenuation is the threshold where the peak intensity gives 1 lx. Throws InputError, also for what the fits do not
/// take.
LightTarget read_photometric_spec(const std::string& path, ConeChoice profile = ConeChoice::best);

}  // namespace litfog::fit
