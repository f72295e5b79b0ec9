// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "litfog/fit/attenuation_fit.h"
#include "litfog/fit/cone_fit.h"
#include "litfog/photometry/luminaire.h"

// clang-format off
/// Light-spec files, version 1: what a light's data sheet says, for litfog-fit to make a light of.
///
///     {
///       "litfog": "light-spec",
///       "version": 1,
///       "name": "landing lamp",                 optional: the file's name without its ending
///       "source": "where the figures are from", optional, or an array of such; the light's
///       "color": [1, 0.9, 0.8],                 optional: white; the light's
///       "density_scale": 0.4,                   optional: 1; the light's
///       "range": {                              optional, and each member of it, but not an extent and samples both
///         "threshold": 0.05,                    the light's
///         "extent_m": 120,                      where the attenuation is to be the threshold, met exactly
///         "constant": 1,                        C, to be kept
///         "family": "quadratic",                of an extent alone: quadratic, linear or mixed (half and half)
///         "samples": [{"range_m": 10, "attenuation": 0.8, "weight": 1}]      by increasing range; weight optional
///       },
///       "cone": {                               optional: a point light; each member optional, but not all angles,
///                                               samples and photometry
///         "profile": "best",                    best (of both), cosine or smoothstep
///         "half_angle_deg": 30,                 where the light ends
///         "beam_angle_deg": 11,                 full angle at 50 % of the peak
///         "field_angle_deg": 22,                full angle at 10 %
///         "samples": [{"angle_deg": 0, "intensity": 1, "weight": 1}],        by increasing angle; weight optional
///         "photometry": "lamp.ies"              in place of samples: IES LM-63 or EULUMDAT, relative to this file;
///                                               without a range the light ends where its peak gives 1 lx
///       }
///     }
///
/// It has a range, a cone or both.
// clang-format on

/// A light that is to be fitted.
struct LightSpec {
  std::string file = {};
  std::string name = {};
  std::vector<std::string> source = {};
  glm::dvec3 color{1.0};
  double density_scale = 1;
  std::optional<litfog::AttenuationTarget> range = std::nullopt;
  std::optional<litfog::ConeTarget> cone =
      std::nullopt;  ///< with the luminaire's profile as its samples, if there is a luminaire
  std::optional<litfog::Luminaire> luminaire = std::nullopt;
};

/// Reads a light-spec file. Throws BadInput, for what the fits would refuse, too.
///
/// profile  in place of the file's own, if any
LightSpec read_spec(const std::string& path, std::optional<litfog::ConeChoice> profile = std::nullopt);

/// A photometric file as a spec: the beam about its axis, white, and an extent by illuminance: C = 1, L = 0, and the
/// attenuation is the threshold where the peak intensity gives 1 lx. Throws BadInput.
LightSpec read_photometric_spec(const std::string& path, litfog::ConeChoice profile = litfog::ConeChoice::best);
