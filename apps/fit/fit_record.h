// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fit/light_fit.h"

namespace litfog::fit {

/// The member "fit" of a light file, which records how the light was fitted:
///
///     {"range": {"status": "optimal",           or unproven, infeasible
///                "objective": 0.01,             sum of weight * (ln a - ln attenuation)^2
///                "rms": 0.02, "largest_error": -0.05,           of the attenuation: -0.05 is 5 % too dark
///                "active": ["extent"],          the constraints that hold C, L, Q where they are
///                "covariance": [[...], ...],    of constant, linear, quadratic, or "not identifiable"
///                "kkt_residual": 1e-12,         how far from the conditions of optimality
///                "iterations": 12, "boxes": 40},
///      "cone": {"profile": "NAME",              the light's
///               "NAME": {                       each profile that was asked for
///                 "cone": {...},                as in the light
///                 "status": "optimal", "objective": 0.01, "lower_bound": 0.01,
///                 "rms": 0.02, "largest_error": -0.05, "largest_error_deg": 11,
///                 "flux_error": 0.01, "beam_angle_error": -0.01, "field_angle_error": 0.1,     relative, or null
///                 "active": [], "covariance": [[...], ...],      of the fitted parameters, angles in radians
///                 "kkt_residual": 0, "iterations": 5, "boxes": 99}},
///      "asymmetry": 0.02}                       of a measured or elliptical beam: what no cone follows
///
/// The same input gives the same text.
std::string fit_record(const LightFit& fit);

}  // namespace litfog::fit
