// SPDX-License-Identifier: Apache-2.0
#include "measure/reference_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <system_error>
#include <thread>

#include "litfog/fog_light_block.h"
#include "litfog/formulas.h"
#include "render/light_map.h"
#include "scene/light_frame.h"

namespace litfog::measure {
namespace {

/// A light with all that does not depend on the place it lights.
struct ReferenceLight {
  glm::dvec3 position;
  glm::dvec3 axis;
  glm::dvec3 color;
  Attenuation attenuation;
  double extent;
  double intensity;  ///< of the fog; 0 unless carried
  ConeProfile profile;
  double cos_outer;  ///< of the cosine cone's half angle
  double cos_inner;
  double exponent;
  double cone_texels;  ///< radians that a texel of its cone map spans at most, in shares of the map's texel

  const Cookie* cookie;  ///< in place of the cone; null: none
  glm::dmat3 cookie_from_world;

  ReferenceLight(const PlacedLight& placed, const Fog& fog, const scene::Scene& scene, const scene::CookieUse* use)
      : position(placed.position),
        axis(placed.direction),
        color(placed.light.color),
        attenuation(placed.light.attenuation),
        extent(litfog::compute_extent(attenuation, placed.light.threshold)),
        intensity(placed.carried ? solve_fog_intensity(placed.light, fog).intensity : 0),
        profile(placed.light.cone.profile),
        cos_outer(std::cos(cutoff_angle(placed.light.cone))),
        cos_inner(std::cos(placed.light.cone.inner)),
        exponent(placed.light.cone.exponent),
        // A face's diagonal; over the cone of a map that is drawn in (cone_map_scale), else over a quarter.
        cone_texels(std::numbers::sqrt2 / std::min(render::cone_map_scale(placed.light.cone), 1.0)),
        cookie(use ? &scene.cookies[use->cookie] : nullptr),
        cookie_from_world(use ? scene::cookie_from_world(placed.direction, use->roll) : glm::dmat3(1.0)) {}

  /// The share that goes into a unit direction.
  double share(const glm::dvec3& direction) const {
    return cookie ? cookie_at(*cookie, cookie_from_world * direction) : cone(glm::dot(axis, direction));
  }
  /// Whether a direction is seen within a texel of where two faces of the cookie meet.
  bool is_at_seam(const glm::dvec3& direction) const {
    glm::dvec3 a = glm::abs(cookie_from_world * direction);
    std::sort(&a.x, &a.x + 3);
    return (a.z - a.y) / a.z < 2.0 / cookie->size;
  }
  double cone(double cos_angle) const {
    switch (profile) {
      case ConeProfile::cosine:
        return formulas::litfog_cosine_cone(cos_angle, cos_outer, exponent);
      case ConeProfile::smoothstep:
        return formulas::litfog_smoothstep_cone(cos_angle, cos_inner, cos_outer);
      case ConeProfile::none:
        break;
    }
    return 1;
  }
};

/// A colour, the values between which light maps leave it, and whether a jump of the model lies within the rounding of
/// floats.
struct Shade {
  glm::dvec3 color{0.0};
  glm::dvec3 least{0.0};
  glm::dvec3 most{0.0};
  bool is_at_jump = false;

  void note_jump(const glm::dvec3& size) {
    constexpr double kShown = 1e-4;  // a third of a step on the display where it is darkest
    is_at_jump |= std::max({size.r, size.g, size.b}) > kShown;
  }
  void add(const glm::dvec3& light) {
    color += light;
    least += light;
    most += light;
  }
  void fade(const glm::dvec3& to, double share) {
    color += (to - color) * share;
    least += (to - least) * share;
    most += (to - most) * share;
  }
};

/// Relative rounding of a difference of two places, one of them stored as floats, and of what floats make of it: some
/// units of their last place, more where the places are far from the origin.
double rounding(const glm::dvec3& from, const glm::dvec3& to, double range) {
  constexpr double kUnit = 0x1p-22;
  const double size =
      std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z), std::abs(to.x), std::abs(to.y), std::abs(to.z)});
  return kUnit * (1 + size / std::max(range, 1e-30));
}

class ReferenceShading {
 public:
  ReferenceShading(const render::RenderSettings& settings, const scene::Scene& scene, const Fog& fog,
                   const std::vector<scene::Material>& materials, int width, int height)
      : settings_(settings),
        path_(*settings.path),
        environment_(scene.environment),
        fog_(fog),
        materials_(materials),
        eye_(scene.camera.position) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      const PlacedLight& light = scene.lights[i];
      const auto use = scene.cookie_uses.find(i);
      lights_.emplace_back(light, fog, scene, use == scene.cookie_uses.end() ? nullptr : &use->second);
      if (light.carried && path_.has_lit_fog) carried_.push_back(lights_.back());
    }
    if (path_.maps != render::LightMapSet::none) texel_ = 2.0 / (settings.map_size - 1);
    forward_ = glm::normalize(glm::dvec3(scene.camera.target) - eye_);
    const double half_height = std::tan(double(scene.camera.field_of_view) / 2);
    const glm::dvec3 right = glm::normalize(glm::cross(forward_, glm::dvec3(0, 1, 0)));
    right_ = right * (2 * half_height / height);
    up_ = glm::cross(right, forward_) * (2 * half_height / height);
    middle_ = {width / 2.0, height / 2.0};
  }

  /// The mean of a pixel's samples.
  Shade pixel(std::span<const render::GeometrySample> samples, int x, int y) const {
    Shade sum;
    Shade last;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (i == 0 || !(samples[i] == samples[i - 1])) {
        last = samples[i].material < 0 ? sky(x, y) : surface(samples[i]);
      }
      const double share = 1.0 / double(samples.size());
      sum.color += last.color * share;
      sum.least += last.least * share;
      sum.most += last.most * share;
      sum.is_at_jump |= last.is_at_jump;
    }
    return sum;
  }

 private:
  Shade surface(const render::GeometrySample& sample) const {
    const scene::Material& material = materials_[std::size_t(sample.material)];
    const glm::dvec3 position = sample.position;
    const bool is_basic = path_.surface == render::SurfaceModel::basic;
    const SurfacePoint point{
        .position = position,
        .normal = path_.has_normal_maps ? sample.mapped_normal : glm::normalize(sample.normal),
        .to_eye = settings_.has_infinite_viewer ? -forward_ : glm::normalize(eye_ - position),
        .diffuse = sample.albedo,
        .specular = is_basic ? glm::dvec3(material.specular) * double(sample.gloss) : glm::dvec3(0.0),
        .shininess = double(material.shininess)};
    Shade shade;
    shade.add(glm::dvec3(material.emissive) + point.diffuse * glm::dvec3(environment_.ambient_light));
    const glm::dvec3 moon = environment_.moon_direction;
    if (path_.evaluation == render::Evaluation::lookup) {  // Hales: the vertices' shading value, interpolated
      const double shading = std::clamp(glm::dot(glm::dvec3(sample.normal), moon), 0.0, 1.0);
      shade.add(point.diffuse * glm::dvec3(environment_.moon_color) * shading);
    } else {
      const glm::dvec3 color = environment_.moon_color;
      shade.add(color * reflected(shade, point, moon, color, 0x1p-22));
    }
    for (const ReferenceLight& light : lights_) add_light(shade, point, light);
    add_fog(shade, position);
    return shade;
  }

  struct SurfacePoint {  ///< the Cg Tutorial's Basic model (5.2)
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec3 to_eye;
    glm::dvec3 diffuse;
    glm::dvec3 specular;
    double shininess;
  };

  /// The share of a light of a colour from a unit direction that the surface reflects.
  static glm::dvec3 reflected(Shade& shade, const SurfacePoint& point, const glm::dvec3& to_light,
                              const glm::dvec3& color, double rounding) {
    const double diffuse = glm::dot(point.normal, to_light);
    const double facing = std::max(glm::dot(point.normal, glm::normalize(to_light + point.to_eye)), 0.0);
    const glm::dvec3 highlight = point.specular * std::pow(facing, point.shininess);
    if (std::abs(diffuse) < rounding) shade.note_jump(color * highlight);
    return diffuse > 0 ? point.diffuse * diffuse + highlight : glm::dvec3(0.0);
  }

  /// The light's range law, 0 beyond its extent.
  double falloff(const ReferenceLight& light, double range) const {
    if (range > light.extent) return 0;
    if (path_.range == render::RangeLaw::radial) return 1 - (range / light.extent) * (range / light.extent);
    const auto& [constant, linear, quadratic] = light.attenuation;
    return formulas::litfog_attenuation(range, constant, linear, quadratic);
  }

  void add_light(Shade& shade, const SurfacePoint& point, const ReferenceLight& light) const {
    const glm::dvec3 offset = point.position - light.position;
    const double square = glm::dot(offset, offset);
    // Texels around a place: within a cell of the 3-D map, or one of each of the 2-D maps, of sides E * texel.
    const double around = texel_ > 0 ? 3 * texel_ * light.extent : 0;
    const double reach = light.extent + around;
    if (square > reach * reach * (1 + 1e-3)) return;
    const double range = std::sqrt(square);
    if (!(range > 0)) return;
    const glm::dvec3 direction = offset / range;
    const double error = rounding(point.position, light.position, range);
    const double cos_angle = glm::dot(light.axis, direction);
    const double cone = light.share(direction);
    const bool is_at_edge = light.profile == ConeProfile::cosine && std::abs(cos_angle - light.cos_outer) < error;
    const bool is_at_extent = std::abs(range - light.extent) < error * range;
    const double arriving = cone * falloff(light, range);
    double least = arriving;
    double most = arriving;
    if (texel_ > 0) {
      const double angle = std::acos(std::clamp(cos_angle, -1.0, 1.0));
      const double turned = light.cone_texels * texel_;
      double dimmest = light.cone(std::cos(std::min(angle + turned, std::numbers::pi)));
      double brightest = light.cone(std::cos(std::max(angle - turned, 0.0)));
      if (light.cookie) {  // whose own texels its cube map holds, but interpolated across the seams of the faces
        const bool is_at_seam = light.is_at_seam(direction);
        dimmest = is_at_seam ? 0 : cone;
        brightest = is_at_seam ? 1 : cone;
      }
      least = dimmest * falloff(light, range + around);
      most = brightest * falloff(light, std::max(range - around, 0.0));
    }
    if (most <= 0 && !is_at_edge && !is_at_extent) return;
    const glm::dvec3 share = light.color * (path_.surface == render::SurfaceModel::unshaded
                                                ? point.diffuse
                                                : reflected(shade, point, -direction, light.color * arriving, error));
    const double within = falloff(light, std::min(range, light.extent));
    if (is_at_edge) shade.note_jump(share * (light.cone(light.cos_outer + error) * within));
    if (is_at_extent) shade.note_jump(share * (cone * within));
    shade.color += share * arriving;
    shade.least += share * least;
    shade.most += share * most;
  }

  /// mix(fog, surface, f) with fog = ambient fog + sum of colour * cone * intensity (Hales 2004, "Lighting in Fog").
  void add_fog(Shade& shade, const glm::dvec3& position) const {
    const double share = opacity_at(fog_, glm::distance(position, eye_));
    if (share <= 0) return;
    glm::dvec3 fog_color = environment_.ambient_fog_color;
    for (const ReferenceLight& light : carried_) {
      const double range = glm::distance(position, light.position);
      if (light.intensity <= 0 || !(range > 0)) continue;
      const glm::dvec3 direction = (position - light.position) / range;
      const double cos_angle = glm::dot(light.axis, direction);
      fog_color += light.color * (light.share(direction) * light.intensity);
      const double error = rounding(position, light.position, range);
      if (light.profile == ConeProfile::cosine && std::abs(cos_angle - light.cos_outer) < error) {
        shade.note_jump(light.color * (light.cone(light.cos_outer + error) * light.intensity * share));
      }
    }
    shade.fade(fog_color, share);
  }

  Shade sky(int x, int y) const {
    const glm::dvec3 direction =
        glm::normalize(forward_ + right_ * (x + 0.5 - middle_.x) + up_ * (middle_.y - y - 0.5));
    const double height = std::max(direction.y, 0.0);
    Shade shade;
    shade.add(glm::mix(glm::dvec3(environment_.sky_horizon), glm::dvec3(environment_.sky_zenith),
                       1 - std::pow(1 - height, 4)));
    shade.add(glm::dvec3(double(environment_.star_brightness) * star(direction) * glm::smoothstep(0.0, 0.25, height)));
    if (environment_.moon_color != glm::vec3(0.0f)) {
      const double off = glm::distance(direction, glm::dvec3(environment_.moon_direction));
      const double disc = 1 - glm::smoothstep(0.0045, 0.0053, off);
      shade.add(glm::normalize(glm::dvec3(environment_.moon_color)) * (disc + 0.05 * std::exp(-off * 40)));
    }
    add_fog(shade, eye_ + direction * double(render::kSkyDistance));
    return shade;
  }

  static double star(const glm::dvec3& direction) {
    const glm::dvec3 a = glm::abs(direction);
    const glm::ivec3 cell(glm::round(direction / std::max({a.x, a.y, a.z}) * 90.0));
    const double presence = hash(cell).x;
    if (presence < 0.94) return 0;
    const double angle = glm::distance(glm::normalize(glm::dvec3(cell) + 0.4 * hash(cell + 1000) - 0.2), direction);
    const double size = (presence - 0.94) / 0.06;
    return size * size * std::exp(-angle * angle * 3.0e6);
  }

  static glm::dvec3 hash(const glm::ivec3& cell) {
    glm::uvec3 v = glm::uvec3(cell) * 1664525u + 1013904223u;
    for (const unsigned shift : {16u, 8u}) {
      v.x += v.y * v.z;
      v.y += v.z * v.x;
      v.z += v.x * v.y;
      v = shift == 16 ? v ^ (v >> shift) : v >> shift;
    }
    return glm::dvec3(v) / 16777216.0;
  }

  render::RenderSettings settings_;
  const render::LightingPath& path_;
  const scene::Environment& environment_;
  Fog fog_;
  const std::vector<scene::Material>& materials_;
  glm::dvec3 eye_;
  std::vector<ReferenceLight> lights_;
  std::vector<ReferenceLight> carried_;
  glm::dvec3 forward_;
  glm::dvec3 right_;  // a pixel's width
  glm::dvec3 up_;
  glm::dvec2 middle_;  // pixels
  double texel_ = 0;   // of the light maps, whose coordinates run from -1 to 1; 0 without maps
};

}  // namespace

ReferencePicture shade_reference(render::Renderer& renderer, const Progress& progress) {
  const render::GeometryBuffer geometry(renderer.width(), renderer.height());
  renderer.draw_geometry(geometry);
  const int width = geometry.width();
  const int height = geometry.height();
  const auto samples = std::size_t(geometry.samples());
  const std::vector<scene::Material> materials = renderer.materials();
  const ReferenceShading shading(renderer.settings(), renderer.scene(), renderer.fog(), materials, width, height);
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  const render::Picture empty{width, height, std::vector<float>(3 * pixels)};
  ReferencePicture reference{empty, empty, empty, std::vector<std::uint8_t>(pixels)};
  for (int first = 0; first < height; first += render::GeometryBuffer::kMostRows) {
    const int count = std::min(render::GeometryBuffer::kMostRows, height - first);
    const std::vector<render::GeometrySample> rows = geometry.read_rows(first, count);
    std::atomic<int> next = 0;
    const auto shade_rows = [&] {
      for (int row = next++; row < count; row = next++) {
        for (int x = 0; x < width; ++x) {
          const std::size_t at = std::size_t(row) * std::size_t(width) + std::size_t(x);
          const Shade shade = shading.pixel(std::span(rows).subspan(at * samples, samples), x, first + row);
          const std::size_t pixel = at + std::size_t(first) * std::size_t(width);
          for (int channel = 0; channel < 3; ++channel) {
            const std::size_t i = 3 * pixel + std::size_t(channel);
            reference.picture.rgb[i] = float(shade.color[channel]);
            reference.least.rgb[i] = float(shade.least[channel]);
            reference.most.rgb[i] = float(shade.most[channel]);
          }
          reference.is_at_jump[pixel] = shade.is_at_jump;
        }
      }
    };
    {
      std::vector<std::jthread> threads(std::max(1u, std::thread::hardware_concurrency()) - 1);
      try {
        for (std::jthread& thread : threads) thread = std::jthread(shade_rows);
      } catch (const std::system_error&) {  // those that have started, and this one, shade all
      }
      shade_rows();
    }
    if (progress) progress(fmt::format("shading the reference: {:.0f} %", 100.0 * (first + count) / height));
  }
  return reference;
}

}  // namespace litfog::measure
