// SPDX-License-Identifier: Apache-2.0
#include "litfog/scattered_beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "legendre.h"
#include "litfog/airlight.h"
#include "litfog/multiple_scattering.h"
#include "model/require.h"

namespace litfog {
namespace {

using std::numbers::pi;

constexpr double kFirstDepth = 0.02, kLastDepth = 12;
/// A beam is blurred by a normal distribution of 1 / kSharpness radians about two axes, since its polynomials end.
constexpr double kSharpness = 12.5;

double depth_of(int row) { return kFirstDepth * std::pow(kLastDepth / kFirstDepth, double(row) / (kBeamDepths - 1)); }

/// A point lamp of 1 / (Q r^2), r in depths.
constexpr double kQuadratic = 1e12;
PlacedLight lamp_at(double depth) {
  Light light;
  light.attenuation = {.constant = 0, .linear = 0, .quadratic = kQuadratic};
  light.threshold = 1e-17;
  return {.light = light, .position = {0, 0, -depth}};
}

ThinBeams::Row make_row(double depth, const Atmosphere& atmosphere, const ScatteringTable& table) {
  ThinBeams::Row row{};
  double outward = 0;
  double from = 0;
  const PlacedLight lamp = lamp_at(depth);
  for (double to = 0.01; from < pi; from = to, to = std::min(2 * to, pi)) {
    add_gauss(from, to, [&](double angle, double size) {
      const double cosine = std::cos(angle), sine = std::sin(angle);
      const double single = airlight(lamp, atmosphere, {.direction = {sine, 0, -cosine}}) * kQuadratic;
      const double light = size * sine / 2 * (single + scattered_at(table, depth, angle));
      const double length = std::sqrt(1 + kApparentStart * (kApparentStart - 2 * cosine));
      const double radial = light * (1 - kApparentStart * cosine) / length;
      const double turned = light * kApparentStart * sine / length;
      outward += radial;
      for_each_polynomial<kBeamOrders>(cosine, [&](std::size_t order, double polynomial, double slope) {
        row.share[order] += light * polynomial;
        row.radial[order] += radial * polynomial;
        if (order > 0) row.turned[order] -= turned * sine * slope / double(order * (order + 1));
      });
    });
  }
  const double whole = row.share[0];
  // What of a lamp's light has been scattered flows through a sphere around it: albedo 1 loses none.
  row.forward = std::min(-std::expm1(-depth) / (depth * depth * whole), 0.99);
  for (std::size_t order = 0; order < kBeamOrders; ++order) {
    const double blur =
        (2 * double(order) + 1) * std::exp(-double(order * (order + 1)) / (2 * kSharpness * kSharpness));
    row.share[order] *= blur / whole;
    row.radial[order] *= blur / outward;
    row.turned[order] *= blur / outward;
  }
  return row;
}

}  // namespace

BeamMoments beam_moments(const Cone& cone) {
  require(find_error(cone));
  BeamMoments moments{};
  if (cone.is_point_light()) {
    moments[0] = 1;
    return moments;
  }
  double from = 0;
  const double end = std::min(cutoff_angle(cone), pi);
  for (double to = 1e-3; from < end; from = to, to = std::min({1.5 * to, to + 0.1, end})) {
    add_gauss(from, std::min(to, end), [&](double angle, double size) {
      const double cosine = std::cos(angle);
      const double part = size * std::sin(angle) / 2 * cone_at(cone, cosine);
      for_each_polynomial<kBeamOrders>(
          cosine, [&](std::size_t order, double polynomial, double) { moments[order] += part * polynomial; });
    });
  }
  return moments;
}

ThinBeams make_thin_beams(const Atmosphere& atmosphere, const ScatteringTable& table) {
  require(find_error(atmosphere));
  require(find_error(table, atmosphere));
  Atmosphere air = atmosphere;
  air.fog.density = 1;
  air.profile = {};
  ThinBeams beams;
  for (int row = 0; row < kBeamDepths; ++row) beams.rows[std::size_t(row)] = make_row(depth_of(row), air, table);
  return beams;
}

std::optional<ValueError> find_error(const ThinBeams& beams) {
  for (const ThinBeams::Row& row : beams.rows) {
    if (!(row.forward > 0 && row.forward <= 1)) return ValueError{"beams.forward", row.forward, "must be in (0, 1]"};
    const auto find = [](const BeamMoments& moments, const char* field) -> std::optional<ValueError> {
      for (const double each : moments) {
        if (!(std::abs(each) <= 1e3)) return ValueError{field, each, "must be at most 1000 in magnitude"};
      }
      return std::nullopt;
    };
    if (const auto error = find(row.share, "beams.share")) return error;
    if (const auto error = find(row.radial, "beams.radial")) return error;
    if (const auto error = find(row.turned, "beams.turned")) return error;
  }
  return std::nullopt;
}

ScatteredBeam make_scattered_beam(const BeamMoments& moments, const ThinBeams& beams) {
  ScatteredBeam beam{};
  for (int column = 0; column < kBeamAngles; ++column) {
    const double angle = pi * column / (kBeamAngles - 1);
    for (int row = 0; row < kBeamDepths; ++row) {
      const ThinBeams::Row& thin = beams.rows[std::size_t(row)];
      double share = 0, radial = 0, turned = 0;
      for_each_polynomial<kBeamOrders>(std::cos(angle), [&](std::size_t order, double polynomial, double slope) {
        share += moments[order] * thin.share[order] * polynomial;
        radial += moments[order] * thin.radial[order] * polynomial;
        turned -= moments[order] * thin.turned[order] * slope * std::sin(angle);
      });
      beam.texels[std::size_t(row)][std::size_t(column)] = {float(std::clamp(share, 1e-6, 1.0)), float(radial),
                                                            float(turned), float(thin.forward)};
    }
  }
  return beam;
}

}  // namespace litfog
