// SPDX-License-Identifier: Apache-2.0
#include "litfog/photometry/cookie_airlight.h"

#include <cmath>

#include "airlight/airlight_quadrature.h"
#include "airlight/airlight_text.h"
#include "airlight/legendre.h"
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
  constexpr int kSize = 64;  // directions along an edge of each face of a cube
  BeamMoments moments{};
  double whole = 0;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < kSize * kSize; ++i) {
      const double u = 2 * (i % kSize + 0.5) / kSize - 1, v = 2 * (i / kSize + 0.5) / kSize - 1;
      glm::dvec3 direction(0.0);
      direction[face / 2] = face % 2 == 0 ? 1 : -1;
      direction[(face / 2 + 1) % 3] = u;
      direction[(face / 2 + 2) % 3] = v;
      const double solid_angle = std::pow(1 + u * u + v * v, -1.5);
      const double part = solid_angle * cookie_at(cookie, direction);
      const double cosine = -direction.z / glm::length(direction);
      whole += solid_angle;
      for_each_polynomial<kBeamOrders>(
          cosine, [&](std::size_t order, double polynomial, double) { moments[order] += part * polynomial; });
    }
  }
  for (double& moment : moments) moment /= whole;
  return moments;
}

}  // namespace litfog
