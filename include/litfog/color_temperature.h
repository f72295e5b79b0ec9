// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace litfog {

/// Range of colour temperatures, in kelvin.
inline constexpr double kMinColorTemperature = 1000;
inline constexpr double kMaxColorTemperature = 25000;

/// Largest error of chromaticity_of_temperature() in x and y.
inline constexpr double kChromaticityMaxError = 4e-4;

/// CIE 1931 chromaticity (x, y) of a light source of a correlated colour temperature: a black body up to 4000 K
/// (Krystek 1985, "An Algorithm to Calculate Correlated Colour Temperature"), daylight from 5000 K (CIE 15:2004,
/// section 3.1), and between them a proportional mix of both at one luminance (ANSI/IES TM-30-18).
///
/// kelvin     [kMinColorTemperature, kMaxColorTemperature]
/// max error  kChromaticityMaxError against published chromaticities         (color_temperature_test.cpp)
/// throws     std::invalid_argument naming field, value and rule
glm::dvec2 chromaticity_of_temperature(double kelvin);

/// A colour temperature as linear sRGB (IEC 61966-2-1) whose largest component is 1. Below 1900 K the colour is outside
/// sRGB: negative blue becomes 0.
///
/// throws     like chromaticity_of_temperature()
glm::dvec3 color_of_temperature(double kelvin);

/// Luminance of a linear sRGB colour (IEC 61966-2-1), relative to white.
constexpr double luminance(const glm::dvec3& color) { return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b; }

}  // namespace litfog
