// SPDX-License-Identifier: Apache-2.0
#include "measure/path_model.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "litfog/color_temperature.h"
#include "litfog/directional_airlight.h"
#include "litfog/photometry/cookie_airlight.h"
#include "measure/reference_light.h"
#include "render/light/hidden_range.h"
#include "render/plan/fog_top.h"

namespace litfog::measure {
namespace {

/// The normal map's normal, from the interpolated tangent space into world space (Jason Lacroix 2005, "Let There Be
/// Light!: A Unified Lighting Technique for a New Generation of Games", listing 2.3). Material::normal says which level
/// means 0.
glm::dvec3 mapped_normal(const render::GeometrySample& sample, double scale) {
  const glm::dvec4 texel = sample.normal_texel;
  const glm::dvec3 bump = 2.0 * glm::dvec3(texel) - (256 - std::floor(texel.a + 0.5 / 255)) / 255;
  const glm::dvec3 n = glm::normalize(glm::dvec3(sample.normal));
  const glm::dvec3 t = glm::normalize(glm::dvec3(sample.tangent));
  const glm::dvec3 b = glm::normalize(glm::cross(n, t)) * double(sample.tangent.w);
  return glm::normalize((t * bump.x + b * bump.y) * scale + n * bump.z);
}

/// The atmosphere relative to the renderer's origin. Light from outside enters it at the same height as in the world.
Atmosphere moonlit_air(const render::Renderer& renderer) {
  Atmosphere air = renderer.atmosphere();
  air.top = air.light_top();
  return air.seen_from(renderer.origin().y);
}

}  // namespace

std::optional<LightRay> ray_within(double range, const ReferenceLight& light, const glm::dvec3& position) {
  const glm::dvec3 offset = position - light.placed.position;
  const double square = glm::dot(offset, offset);
  if (!(square > 0 && square <= range * range)) return std::nullopt;
  const double length = std::sqrt(square);
  return LightRay{offset / length, length};
}

PathModel::PathModel(const render::Renderer& renderer)
    : settings_(renderer.settings()),
      path_(*renderer.settings().path),
      environment_(renderer.scene().environment),
      atmosphere_(renderer.atmosphere().seen_from(renderer.origin().y)),
      materials_(renderer.materials()),
      lights_(reference_lights(renderer.scene(), renderer.atmosphere(), renderer.settings(), renderer.ends_exposure())),
      moonlit_air_(moonlit_air(renderer)),
      is_fog_moonlit_(render::is_fog_moonlit(environment_, atmosphere_, settings_.fog_lighting)),
      airlight_budget_(kAirlightBudget * std::exp2(-renderer.exposure())),
      eye_(renderer.scene().camera.position - renderer.origin()),
      forward_(axes_of(renderer.scene().camera).forward) {
  for (ReferenceLight& light : lights_) {
    light.placed.position = render::placed_relative_to(renderer.origin(), light.placed);
  }
  if (settings_.scattering == render::Scattering::all && !find_scattering_error(atmosphere_)) {
    scattering_ = make_scattering_table(atmosphere_);
    const ThinBeams beams = make_thin_beams(atmosphere_, *scattering_);
    std::map<const Cookie*, BeamMoments> of_cookies;
    const auto cookie_moments = [&](const Cookie* cookie) {
      const auto [found, is_new] = of_cookies.try_emplace(cookie);
      if (is_new) found->second = beam_moments(*cookie);
      return found->second;
    };
    for (ReferenceLight& light : lights_) {
      const BeamMoments shape = light.cookie ? cookie_moments(light.cookie) : beam_moments(light.placed.light.cone);
      light.source = scattering_source(light.placed.light, shape, atmosphere_, beams);
    }
  }
  if (!renderer.shadows()) return;
  shadows_.emplace(renderer);
  for (const render::ShadowCaster& caster : renderer.shadows()->casters()) {
    ReferenceLight& light = lights_[caster.scene_light];
    light.casts_shadows = true;
    if (settings_.shadows != render::Shadows::shafts) continue;
    light.fog_threshold = light.placed.light.threshold;  // beyond this, airlight has no shafts
    light.fog_extent = compute_extent(light.placed.light.attenuation, light.fog_threshold);
  }
}

SurfacePoint PathModel::surface_point(const render::GeometrySample& sample) const {
  const scene::Material& material = materials_[std::size_t(sample.material)];
  const glm::dvec3 position = sample.position;
  const bool is_basic = path_.surface == render::SurfaceModel::basic;
  return {.position = position,
          .normal = path_.has_normal_maps ? mapped_normal(sample, double(material.normal_scale))
                                          : glm::normalize(glm::dvec3(sample.normal)),
          .to_eye = settings_.papers.has_infinite_viewer ? -forward_ : glm::normalize(eye_ - position),
          .emissive = sample.emission,
          .ambient = material.ambient && is_basic ? *material.ambient : sample.albedo,
          .diffuse = sample.albedo,
          .specular = is_basic ? glm::dvec3(material.specular) * double(sample.gloss) : glm::dvec3(0.0),
          .shininess = material.shininess,
          .vertex_moon_cosine = glm::dot(glm::dvec3(sample.normal), glm::dvec3(environment_.moon_direction))};
}

glm::dvec3 PathModel::surface_color(const SurfacePoint& point) const {
  glm::dvec3 color = without_lamps(point);
  for (const ReferenceLight& light : lights_) {
    const auto ray = ray_within(light.extent, light, point.position);
    if (!ray) continue;
    const double arriving = light.emitted(ray->direction) * falloff(light, point.position.y, ray->range);
    if (arriving > 0 && !is_in_shadow(point, light))
      color += light.placed.light.color * arriving * reflectance(point, -ray->direction);
  }
  return color;
}

glm::dvec3 PathModel::without_lamps(const SurfacePoint& point) const {
  const glm::dvec3 color =
      point.emissive + point.ambient * glm::dvec3(environment_.ambient_light) + point.diffuse * scattered_light(point);
  const glm::dvec3 moonlit = moonlight(point);
  return moonlit == glm::dvec3(0.0) || is_in_moon_shadow(point) ? color : color + moonlit;
}

glm::dvec3 PathModel::scattered_light(const SurfacePoint& point) const {
  if (!scattering_ || !path_.takes_scattered_light) return glm::dvec3(0.0);
  glm::dvec3 all(0.0);
  DiffuseLight light;  // its luminance
  for (const ReferenceLight& lamp : lights_) {
    const glm::dvec3& color = lamp.placed.light.color;
    const DiffuseLight scattered = litfog::scattered_light(lamp.placed, lamp.source, atmosphere_, point.position);
    all += scattered.all * color;
    light += luminance(color) * scattered;
  }
  return light.all > 0 ? all * (irradiance(light, point.normal) / light.all) : glm::dvec3(0.0);
}

glm::dvec3 PathModel::moonlight(const SurfacePoint& point) const {
  const glm::dvec3 direction = glm::normalize(glm::dvec3(environment_.moon_direction));
  const glm::dvec3 moon_color =
      glm::dvec3(environment_.moon_color) *
      (is_fog_moonlit_ ? directional_fog_factor(moonlit_air_, direction, point.position.y) : 1.0);
  if (path_.evaluation == render::Evaluation::lookup) {  // Hales: the shading value, interpolated
    return moon_color * point.diffuse * std::clamp(point.vertex_moon_cosine, 0.0, 1.0);
  }
  return moon_color * reflectance(point, environment_.moon_direction);
}

double PathModel::falloff(const ReferenceLight& light, double height, double range) const {
  if (range > light.extent) return 0;
  const bool is_fogged = settings_.fog_lighting == render::FogLighting::airlight;
  const PlacedLight& placed = light.placed;
  const Fog fog = scaled(atmosphere_.fog_between(placed.position.y, height), placed.light.density_scale);
  const double through = is_fogged ? fog_factor_at(fog, range) : 1;
  if (path_.range == render::RangeLaw::attenuation) return through * attenuation_at(placed.light.attenuation, range);
  const double fraction = std::isinf(light.extent) ? 0 : range / light.extent;
  return through * (1 - fraction * fraction);
}

glm::dvec3 PathModel::reflectance(const SurfacePoint& point, const glm::dvec3& to_light) const {
  if (path_.surface == render::SurfaceModel::unshaded) return point.diffuse;
  const double cosine = glm::dot(point.normal, to_light);
  if (path_.surface == render::SurfaceModel::diffuse) {
    return point.diffuse * (settings_.papers.light_ambient + std::max(cosine, 0.0));
  }
  return cosine > 0 ? point.diffuse * cosine + highlight(point, to_light) : glm::dvec3(0.0);
}

glm::dvec3 PathModel::highlight(const SurfacePoint& point, const glm::dvec3& to_light) const {
  if (point.specular == glm::dvec3(0.0)) return glm::dvec3(0.0);
  const glm::dvec3 half_vector = glm::normalize(to_light + point.to_eye);
  return point.specular * std::pow(std::max(glm::dot(point.normal, half_vector), 0.0), point.shininess);
}

double PathModel::opacity_before(const glm::dvec3& position) const {
  return opacity_at(atmosphere_.fog_between(position.y, eye_.y), glm::distance(position, eye_));
}

/// Ambient fog + sum over the carried lights of color * cone * intensity (Steven Hales 2004, "Realtime Pixel Lighting
/// Using Fragment Programs", section "Lighting in Fog").
Veil PathModel::veil(const glm::dvec3& position) const {
  Veil veil{.color = atmosphere_.ambient_fog_color, .opacity = opacity_before(position)};
  if (veil.opacity <= 0) return veil;
  for (const ReferenceLight& light : lights_) {
    if (!lights_fog(light)) continue;
    const auto ray = ray_within(kAnyRange, light, position);
    if (ray) veil.color += light.placed.light.color * light.emitted(ray->direction) * light.fog_intensity;
  }
  return veil;
}

glm::dvec3 PathModel::moon_airlight(const glm::dvec3& position) const {
  const double range = glm::distance(position, eye_);
  if (!is_fog_moonlit_ || range == 0) return glm::dvec3(0.0);
  const EyeRay ray{.origin = eye_, .direction = (position - eye_) / range, .length = range};
  const glm::dvec3 to_moon = glm::normalize(glm::dvec3(environment_.moon_direction));
  return airlight_unit(atmosphere_) * directional_airlight(moonlit_air_, to_moon, ray) *
         glm::dvec3(environment_.moon_color);
}

glm::dvec3 PathModel::moon_airlight_before_sky(const glm::dvec3& direction, double range) const {
  if (direction.y > 0) range = std::min(range, std::max(moonlit_air_.light_top() - eye_.y, 0.0) / direction.y);
  return moon_airlight(eye_ + direction * range);
}

double PathModel::airlight(const ReferenceLight& light, const EyeRay& ray) const {
  if (!light.casts_shadows || settings_.shadows != render::Shadows::shafts) {
    return light.airlight(atmosphere_, ray);
  }
  double sum = 0;
  for (const auto& [from, to] : shadows_->lit_stretches(light, ray)) {
    EyeRay part = ray;
    part.length = to;
    sum += light.airlight(atmosphere_, part);
    part.length = from;
    sum -= light.airlight(atmosphere_, part);
  }
  return sum;
}

glm::dvec3 PathModel::airlight(const glm::dvec3& direction, double length) const {
  glm::dvec3 sum(0.0);
  if (settings_.fog_lighting != render::FogLighting::airlight) return sum;
  const EyeRay ray{.origin = eye_, .direction = direction, .length = length};
  struct Candidate {
    double most;  // upper bound, as a fraction of white
    const ReferenceLight* light;
  };
  std::vector<Candidate> candidates;
  const double unit = airlight_unit(atmosphere_);
  for (const ReferenceLight& light : lights_) {
    const double brightest = unit * render::largest_component(light.placed.light.color);
    const double most = brightest * airlight_bound(light, ray, atmosphere_);
    if (most > 0) candidates.push_back({most, &light});
  }
  std::ranges::sort(candidates, {}, &Candidate::most);
  double left_out = 0;
  for (const auto& [most, light] : candidates) {
    left_out += most;
    if (left_out > airlight_budget_) sum += unit * airlight(*light, ray) * light->placed.light.color;
  }
  if (!scattering_) return sum;
  for (const ReferenceLight& light : lights_) {
    sum += unit * multiple_scattering(light.placed, light.source, atmosphere_, *scattering_, ray) *
           light.placed.light.color;
  }
  return sum;
}

}  // namespace litfog::measure
