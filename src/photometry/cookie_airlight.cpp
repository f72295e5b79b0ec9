// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie_airlight.h"

#include <algorithm>
#include <cmath>

#include "airlight/airlight_quadrature.h"
#include "airlight/airlight_text.h"
#include "airlight/legendre.h"
#include "litfog/photometry/cube_face.h"
#include "model/require.h"
#include "model/unchecked.h"

namespace litfog {
namespace {

using airlight_text::Text;

/// A cookie on a ray.
struct CookieOnRay {
  const Cookie& cookie;
  glm::dvec3 offset;     ///< from the light to the closest approach
  glm::dvec3 direction;  ///< direction of the ray; both in the cookie's frame

  template <typename Real>
  Real operator()(Real along) const {
    const glm::dvec3 towards = offset + double(along) * direction;
    return Real(cookie_at(cookie, towards == glm::dvec3(0.0) ? direction : towards));
  }

  /// Texels' centre lines and faces' edges lie in planes c |i| = |j| through the light, i and j being two of the axes.
  template <typename Cuts>
  void append_kinks(Cuts& cuts) const {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (i == j) continue;
        for (int line = -1; line <= cookie.size; ++line) {
          const double c = line < 0 ? -1 : line == cookie.size ? 1 : (2 * line + 1) / double(cookie.size) - 1;
          const double slope = c * direction[i] - direction[j];
          if (slope != 0) cuts.push_back((offset[j] - c * offset[i]) / slope);
        }
      }
    }
  }
};

template <typename Real, typename Evaluate>
double evaluate(const PlacedLight& light, const Cookie& cookie, const glm::dmat3& cookie_from_world,
                const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg, const Evaluate& evaluate_text) {
  require(find_error(light));
  require(find_error(atmosphere));
  require(find_error(ray));
  const glm::dvec3 direction = glm::normalize(ray.direction);
  const glm::dvec3 to_light = light.position - ray.origin;
  const CookieOnRay on_ray{cookie, cookie_from_world * (glm::dot(to_light, direction) * direction - to_light),
                           cookie_from_world * direction};
  const auto layers = convert<Real>(atmosphere.profile);
  Text<Real, CookieOnRay> text{on_ray, layers};
  const double extent = unchecked::compute_extent(light.light.attenuation, light.light.threshold);
  auto air = text.seen_along(light, Real(extent), unchecked::scaled(atmosphere.fog, light.light.density_scale), ray,
                             lamp_leg, phase_text::pack<Real>(atmosphere.phase));
  air.profile = Real(LITFOG_PROFILE_COOKIE);
  return double(std::isinf(air.density) ? text.at_the_eye(air) : evaluate_text(text, air));
}

}  // namespace

double airlight(const PlacedLight& light, const Cookie& cookie, const glm::dmat3& cookie_from_world,
                const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg) {
  return evaluate<double>(light, cookie, cookie_from_world, atmosphere, ray, lamp_leg,
                          [](auto& text, const auto& air) { return text.litfog_airlight(air); });
}

double reference_airlight(const PlacedLight& light, const Cookie& cookie, const glm::dmat3& cookie_from_world,
                          const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg) {
  return evaluate<long double>(light, cookie, cookie_from_world, atmosphere, ray, lamp_leg,
                               [](auto& text, const auto& air) { return integrate_airlight(text, air); });
}

double picture_airlight(const PlacedLight& light, const Cookie& cookie, const glm::dmat3& cookie_from_world,
                        const Atmosphere& atmosphere, const EyeRay& ray, LampLeg lamp_leg) {
  return evaluate<double>(light, cookie, cookie_from_world, atmosphere, ray, lamp_leg, [](auto& text, const auto& air) {
    return integrate_airlight(text, air, kPictureAirlightMaxError);
  });
}

BeamMoments beam_moments(const Cookie& cookie) {
  // Samples along an edge of a face are the texels, or kFewest where there are fewer: a narrow beam would lie between
  // fewer samples. The samples of a cell share the polynomials of their mean cosine.
  constexpr int kFewest = 64;
  const int size = std::max(cookie.size, kFewest), cell = size / kFewest;
  BeamMoments moments{};
  double whole = 0;
  const auto add_cell = [&](int face, int first_row, int first_column) {
    double light = 0, cosines = 0;
    for (int row = first_row; row < std::min(first_row + cell, size); ++row) {
      for (int column = first_column; column < std::min(first_column + cell, size); ++column) {
        const glm::dvec3 direction = cube_direction({face, (2 * column + 1.0) / size - 1, (2 * row + 1.0) / size - 1});
        const double square = glm::dot(direction, direction), length = std::sqrt(square);
        const double fraction = size == cookie.size
                                    ? double(cookie.texels[std::size_t((face * size + row) * size + column)])
                                    : cookie_at(cookie, direction);
        whole += 1 / (square * length);
        light += fraction / (square * length);
        cosines -= fraction / (square * square) * direction.z;
      }
    }
    if (light == 0) return;
    for_each_polynomial<kBeamOrders>(
        cosines / light, [&](std::size_t order, double polynomial, double) { moments[order] += light * polynomial; });
  };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < size; row += cell) {
      for (int column = 0; column < size; column += cell) add_cell(face, row, column);
    }
  }
  for (double& moment : moments) moment /= whole;
  return moments;
}

}  // namespace litfog
