// SPDX-License-Identifier: Apache-2.0
// Each path against the formulas that its own paper prints, written here from the papers alone, in double: a wall at
// z = -5 under lamps, pixel by pixel. Where a path works at vertices, the formulas are taken there and interpolated.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "gl/gl_test.h"
#include "render/pixel.h"
#include "render/renderer.h"
#include "render/surface/polygon_sort.h"
#include "render/wall.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace scene;
using namespace render;

namespace {

using glm::dvec3;

constexpr dvec3 kNormal(0, 0, 1);
constexpr dvec3 kTangent(1, 0, 0);
constexpr double kDensity = 0.09;
constexpr double kSmallAttenuation = 0.05;  // "a small attenuation value, a (e.g. 0.05)"

/// C, L, Q; the spot's direction, and its cone: HA and S, or the two cones' angles.
struct Lamp {
  dvec3 position;
  dvec3 direction;
  dvec3 color;
  double c, l, q;
  bool is_dual;
  double half_angle, exponent;  // or inner and outer
};

// Hales's cones have their edges beyond the wall: texels cannot hold the jump there.
std::vector<Lamp> lamps(bool is_dual) {
  const double first = is_dual ? 0.1 : 1.3;
  const double second = is_dual ? 0.7 : 4;
  return {{{-0.8, 0.3, -1}, glm::normalize(dvec3(0.1, -0.05, -1)), {0.9, 0.7, 0.5}, 1, 0, 0.3, is_dual, first, second},
          {{0.9, 0.2, -1.2}, glm::normalize(dvec3(-0.1, 0, -1)), {0.5, 0.6, 0.9}, 1, 0, 0.3, is_dual, first, second},
          {{0.1, -0.6, -2}, {0, 0, -1}, {0.4, 0.8, 0.3}, 0.6, 0.2, 0.2, is_dual, first, second}};
}

struct Setting {
  std::vector<Lamp> lamps;
  dvec3 texture{0.5, 0.4, 0.3};
  dvec3 ks{0.3, 0.25, 0.2};
  std::optional<dvec3> ka = std::nullopt;  ///< none: the texture
  double shininess = 20;
  double metal_roughness = 0;
  int cells = 1;
  double light_ambient = 0;
  Texels normal_map{1, 1, {128, 128, 255, 0}};
  dvec3 mapped_normal = kNormal;  ///< which it states
  double turn = 0;                ///< the wall's, about kTurnAxis through its middle, radians
};
const dvec3 kTurnAxis = glm::normalize(dvec3(1, -2, 0.5));

dvec3 wall_normal(const Setting& setting) { return dvec3(glm::rotate(glm::dmat4(1), setting.turn, kTurnAxis)[2]); }

Scene wall(const Setting& setting) {
  Scene scene = make_wall(setting.cells, "plain");
  scene.materials.push_back({.name = "plain",
                             .size_m = 1,
                             .albedo = nullptr,
                             .normal = std::make_shared<const Texels>(setting.normal_map),
                             .specular = setting.ks,
                             .shininess = float(setting.shininess),
                             .emissive = {},
                             .metal_roughness = float(setting.metal_roughness),
                             .plain_albedo = setting.texture,
                             .ambient = setting.ka});
  const glm::dmat4 turned = glm::rotate(glm::dmat4(1), setting.turn, kTurnAxis);
  const double scale = setting.turn == 0 ? 1 : 2;  // so that it still fills the picture
  scene.instances[0].world_from_model *= glm::scale(turned, dvec3(scale));
  for (const Lamp& lamp : setting.lamps) {
    const Cone cone =
        lamp.is_dual ? Cone::smoothstep(lamp.half_angle, lamp.exponent) : Cone::cosine(lamp.half_angle, lamp.exponent);
    scene.lights.push_back(
        {.light = {.name = "lamp", .color = lamp.color, .attenuation = {lamp.c, lamp.l, lamp.q}, .cone = cone},
         .position = lamp.position,
         .direction = lamp.direction,
         .carried = true});
  }
  return scene;
}

// --- Hales ---

/// "Solving the quadratic equation for R, where Q * R^2 + L * R + (C - 1/a) = 0".
double range_extent(const Lamp& lamp) {
  const double constant = lamp.c - 1 / kSmallAttenuation;
  return (-lamp.l + std::sqrt(lamp.l * lamp.l - 4 * lamp.q * constant)) / (2 * lamp.q);
}

double range_attenuation(const Lamp& lamp, double r) {
  if (r > range_extent(lamp)) return 0;
  return std::min(1.0, 1 / (lamp.c + lamp.l * r + lamp.q * r * r));
}

double angle_attenuation(const Lamp& lamp, const dvec3& v) {
  const dvec3 p = v - lamp.position;
  const double cosa = glm::dot(lamp.direction, p) / std::sqrt(glm::dot(p, p));
  if (!lamp.is_dual) return cosa > std::cos(lamp.half_angle) ? std::pow(cosa, lamp.exponent) : 0;
  // C5E9_dualConeSpotlight: smoothstep is -2 x^3 + 3 x^2.
  const double inner = std::cos(lamp.half_angle), outer = std::cos(lamp.exponent);
  const double x = std::clamp((cosa - outer) / (inner - outer), 0.0, 1.0);
  return -2 * x * x * x + 3 * x * x;
}

double fog_factor(double r) { return std::exp(-(kDensity * r) * (kDensity * r)); }  // ARB_fog_exp2

/// "Take samples across the extent of the light ... Take the maximum value".
double fog_color_intensity(const Lamp& lamp) {
  double most = 0;
  for (double r = 0; r <= range_extent(lamp); r += range_extent(lamp) / 2000) {
    most = std::max(most, (1 - fog_factor(r)) * range_attenuation(lamp, r));
  }
  return most;
}

using AngleLaw = std::function<double(const Lamp&, const dvec3&)>;

/// intensities  fog_color_intensity() of each lamp
dvec3 fragment_fog_color(const Setting& setting, const std::vector<double>& intensities, const dvec3& v,
                         const AngleLaw& angle) {
  dvec3 color = kAmbientFogColor;
  for (std::size_t i = 0; i < setting.lamps.size(); ++i) {
    color += setting.lamps[i].color * angle(setting.lamps[i], v) * intensities[i];
  }
  return color;
}

dvec3 directional(const dvec3& n = kNormal) {
  return kAmbientLight + kMoonColor * std::max(glm::dot(kMoonDirection, n), 0.0);
}

/// His I . N, by the direction to the light from each fragment.
double n_dot_l(const Lamp& lamp, const dvec3& v) {
  return std::max(glm::dot(kNormal, glm::normalize(lamp.position - v)), 0.0);
}

dvec3 hales(const Setting& setting, const dvec3& v) {
  dvec3 sum = directional();
  for (const Lamp& lamp : setting.lamps) {
    sum += range_attenuation(lamp, glm::distance(v, lamp.position)) * angle_attenuation(lamp, v) *
           (setting.light_ambient * lamp.color + n_dot_l(lamp, v) * lamp.color);
  }
  return sum * setting.texture;
}

/// "(RA * (AA1 + AA2) * lcol + f) * icol * tex1 * tex2", with MAD_SAT and MUL_SAT; both textures in one.
dvec3 hales_sample(const Setting& setting, const dvec3& v) {
  const Lamp& first = setting.lamps[0];
  const double ra = range_attenuation(first, glm::distance(v, first.position));
  double aa = 0;
  for (const Lamp& lamp : setting.lamps) aa += angle_attenuation(lamp, v);
  return glm::clamp(glm::clamp(ra * aa * first.color + directional(), 0.0, 1.0) * setting.texture, 0.0, 1.0);
}

// --- Frazier ---

dvec3 frazier_light(const Setting& setting, const dvec3& v, const AngleLaw& angle) {
  dvec3 sum(0.0);
  for (const Lamp& lamp : setting.lamps) {
    const dvec3 p = (v - lamp.position) / range_extent(lamp);
    sum += lamp.color * std::max(1 - p.x * p.x - p.y * p.y - p.z * p.z, 0.0) * angle(lamp, v);
  }
  return sum;
}

/// prepareLightForPlane: x and y after the plane's rotation to z = 0, and the square of the plane's distance.
dvec3 frazier_plane(const Setting& setting, const dvec3& v) {
  const dvec3 normal = wall_normal(setting), forward(0, 0, -1);
  const dvec3 axis = glm::cross(normal, forward);
  const double length = glm::length(axis);
  glm::dmat4 rotated(1);  // "we can leave the plane where it is"
  if (length > 0.00001) {
    double angle = std::asin(length);
    if (std::acos(glm::dot(normal, forward)) <= std::numbers::pi / 2) angle = std::numbers::pi - angle;
    rotated = glm::rotate(rotated, -angle, axis / length);
  }
  dvec3 sum(0.0);
  for (const Lamp& lamp : setting.lamps) {
    const double r = range_extent(lamp);
    const dvec3 xy = dvec3(rotated * glm::dvec4(v - lamp.position, 0)) / r;
    const double z = glm::dot(normal, lamp.position - v) / r;
    sum += lamp.color * std::max(1 - (xy.x * xy.x + xy.y * xy.y) - z * z, 0.0) * angle_attenuation(lamp, v);
  }
  return (sum + directional(normal)) * setting.texture;
}

/// A white circle on one side of the cube: scaled, it ends at the spot's angle.
double white_circle(const Lamp& lamp, const dvec3& v) {
  return glm::dot(glm::normalize(v - lamp.position), lamp.direction) > std::cos(lamp.exponent) ? 1 : 0;
}

// --- The Cg Tutorial and Lacroix ---

struct Sums {
  dvec3 diffuse{0.0};
  dvec3 specular{0.0};
};

/// C5E5_computeLighting.
void compute_lighting(const Setting& setting, const dvec3& l, const dvec3& color, const dvec3& p, Sums& sums) {
  const dvec3& n = setting.mapped_normal;
  const double diffuse = std::max(glm::dot(n, l), 0.0);
  const dvec3 h = glm::normalize(l + glm::normalize(-p));  // the eye is at the origin
  const double specular = diffuse <= 0 ? 0 : std::pow(std::max(glm::dot(n, h), 0.0), setting.shininess);
  sums.diffuse += color * diffuse;
  sums.specular += color * specular;
}

using Attenuate = double (*)(const Lamp&, double);

/// Example 5-6, and Lacroix's equation (3), whose clamp and end are Hales's.
double printed_attenuation(const Lamp& lamp, double d) { return 1 / (lamp.c + lamp.l * d + lamp.q * d * d); }

Sums basic_sums(const Setting& setting, const dvec3& p, Attenuate attenuate, const AngleLaw& angle) {
  Sums sums;
  compute_lighting(setting, kMoonDirection, kMoonColor, p, sums);
  for (const Lamp& lamp : setting.lamps) {
    const double factor = attenuate(lamp, glm::distance(p, lamp.position)) * angle(lamp, p);
    compute_lighting(setting, glm::normalize(lamp.position - p), factor * lamp.color, p, sums);
  }
  return sums;
}

dvec3 ambient(const Setting& setting) { return setting.ka.value_or(setting.texture) * kAmbientLight; }

dvec3 basic(const Setting& setting, const Sums& sums) {
  return ambient(setting) + setting.texture * sums.diffuse + setting.ks * sums.specular;
}

dvec3 unified(const Setting& setting, const dvec3& p) {
  return basic(setting, basic_sums(setting, p, range_attenuation, angle_attenuation));
}

/// The wall's triangle around a point, and the weights of its corners there.
struct Corners {
  std::array<dvec3, 3> at;
  dvec3 weights;

  template <typename Value>
  auto interpolated(const Value& value) const {
    return weights[0] * value(at[0]) + weights[1] * value(at[1]) + weights[2] * value(at[2]);
  }
};

Corners corners_around(const Mesh& mesh, const dvec3& p) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners.at[k] = dvec3(mesh.vertices[mesh.indices[i + k]].position) + dvec3(0, 0, kWallZ);
    }
    const auto twice_area = [](const dvec3& a, const dvec3& b, const dvec3& c) { return glm::cross(b - a, c - a).z; };
    const auto& [a, b, c] = corners.at;
    corners.weights = dvec3(twice_area(p, b, c), twice_area(a, p, c), twice_area(a, b, p)) / twice_area(a, b, c);
    if (glm::all(glm::greaterThanEqual(corners.weights, dvec3(-1e-9)))) return corners;
  }
  ADD_FAILURE() << "no triangle";
  return {};
}

/// Exercise 6: "compute just the specular contribution using the interpolated half-angle and normal vectors".
dvec3 mixed(const Setting& setting, const Corners& corners) {
  const auto sums = [&](const dvec3& v) { return basic_sums(setting, v, range_attenuation, angle_attenuation); };
  dvec3 color =
      ambient(setting) + setting.texture * corners.interpolated([&](const dvec3& v) { return sums(v).diffuse; });
  const auto add = [&](const auto& to_light, const auto& light) {
    const dvec3 h =
        corners.interpolated([&](const dvec3& v) { return glm::normalize(to_light(v) + glm::normalize(-v)); });
    color += setting.ks * corners.interpolated(light) *
             std::pow(std::max(glm::dot(kNormal, glm::normalize(h)), 0.0), setting.shininess);
  };
  add([](const dvec3&) { return kMoonDirection; }, [&](const dvec3&) { return kMoonColor; });
  for (const Lamp& lamp : setting.lamps) {
    add([&](const dvec3& v) { return glm::normalize(lamp.position - v); },
        [&](const dvec3& v) {
          return lamp.color * range_attenuation(lamp, glm::distance(v, lamp.position)) * angle_attenuation(lamp, v);
        });
  }
  return color;
}

/// Equations (1) to (4) of Lacroix; a framebuffer holds nothing below 0.
dvec3 lacroix(const Setting& setting, const dvec3& p) {
  dvec3 sum = kAmbientLight + kMoonColor * glm::dot(kNormal, kMoonDirection);
  for (const Lamp& lamp : setting.lamps) {
    const double dist = glm::length(p - lamp.position);
    const dvec3 l = (p - lamp.position) / dist;
    const double att = 1 / (lamp.c + lamp.l * dist + lamp.q * dist * dist);
    sum += lamp.color * angle_attenuation(lamp, p) * att * glm::dot(kNormal, -l);
  }
  return glm::max(setting.texture * sum, 0.0);
}

// --- textures ---

/// Stripes across u, each of two levels in turn.
constexpr int kTexelsAcross = 64, kStripe = 4;
constexpr std::array<std::uint8_t, 2> kStripeLevels{200, 90};

Texels stripes() {
  Texels texels{kTexelsAcross, kTexelsAcross, {}};
  for (int row = 0; row < kTexelsAcross; ++row) {
    for (int column = 0; column < kTexelsAcross; ++column) {
      const std::uint8_t level = kStripeLevels[std::size_t(column / kStripe % 2)];
      texels.rgba.insert(texels.rgba.end(), {level, level, level, 255});
    }
  }
  return texels;
}

/// What they reflect at a place in tiles, linear. NaN near the stripes' edges, which filtering blurs.
double stripe_at(double tiles) {
  const double column = (tiles - std::floor(tiles)) * kTexelsAcross;
  if (std::abs(std::remainder(column, kStripe)) < 0.6) return std::nan("");
  return std::pow((kStripeLevels[std::size_t(column / kStripe) % 2] / 255.0 + 0.055) / 1.055, 2.4);
}

// --- metals ---

using Reflect = dvec3 (*)(const Setting&, const dvec3& l, const dvec3& v);

/// Cook and Torrance 1982: F D G / (N.L N.V) / pi, times N.L, and pi as the Basic model has it; D by the angle itself.
dvec3 cook_torrance(const Setting& setting, const dvec3& l, const dvec3& v) {
  const dvec3 h = glm::normalize(l + v);
  const double delta = std::acos(glm::dot(kNormal, h));
  const double m = setting.metal_roughness;
  const double d = std::exp(-std::pow(std::tan(delta) / m, 2)) / (4 * m * m * std::pow(std::cos(delta), 4));
  const double vh = glm::dot(v, h);
  const double g =
      std::min({1.0, 2 * std::cos(delta) * glm::dot(kNormal, v) / vh, 2 * std::cos(delta) * glm::dot(kNormal, l) / vh});
  const dvec3 f = setting.texture + (1.0 - setting.texture) * std::pow(1 - vh, 5);
  return f * d * g / glm::dot(kNormal, v);
}

/// Heidrich and Seidel 1998, with the grooves' normals that they avoid to compute: perpendicular to the tangent, the
/// nearest to the light for diffuse light; half way between the light and the eye, seen along the groove, for the
/// mirror.
dvec3 brushed(const Setting& setting, const dvec3& l, const dvec3& v) {
  const auto across = [](const dvec3& d) { return glm::normalize(d - kTangent * glm::dot(d, kTangent)); };
  const dvec3 r = glm::reflect(-l, glm::normalize(across(l) + across(v)));
  return glm::dot(kNormal, l) * (setting.texture * glm::dot(across(l), l) +
                                 setting.ks * std::pow(std::max(glm::dot(v, r), 0.0), setting.shininess));
}

dvec3 metal(const Setting& setting, const dvec3& p, Reflect reflect) {
  const dvec3 v = glm::normalize(-p);
  dvec3 color = ambient(setting) + kMoonColor * reflect(setting, kMoonDirection, v);
  for (const Lamp& lamp : setting.lamps) {
    color += lamp.color * range_attenuation(lamp, glm::distance(p, lamp.position)) * angle_attenuation(lamp, p) *
             reflect(setting, glm::normalize(lamp.position - p), v);
  }
  return color;
}

// --- the comparison ---

using Formula = std::function<dvec3(const dvec3& point, const Corners& corners)>;  // before fog
enum class FogOf { hales, legacy, none };

class PaperFormula : public test::GlTest {
 protected:
  /// Largest difference of a path's picture from the formula, in the fog.
  static double error(const Setting& setting, const RenderSettings& settings, const Formula& formula,
                      FogOf fog_of = FogOf::hales, const AngleLaw& fog_angle = angle_attenuation,
                      const std::function<void(Material&)>& change = {}) {
    Scene scene = wall(setting);
    if (change) change(scene.materials[0]);
    Renderer renderer(scene, kWidth, kHeight, settings);
    renderer.set_atmosphere(renderer.scene().atmosphere.with({.mode = FogMode::exp2, .density = kDensity}));
    renderer.draw(LightPoints::off);
    const Picture picture = renderer.read();
    std::vector<double> intensities;
    for (const Lamp& lamp : setting.lamps) intensities.push_back(fog_color_intensity(lamp));
    double worst = 0;
    double brightest = 0;
    for (int y = 1; y < kHeight; y += 3) {
      for (int x = 1; x < kWidth; x += 3) {
        const dvec3 view = view_direction(scene.camera, kWidth, kHeight, x + 0.5, y + 0.5);
        const dvec3 point = view * (kWallZ * wall_normal(setting).z / glm::dot(wall_normal(setting), view));
        const bool is_turned = setting.turn != 0;
        dvec3 expected = formula(point, is_turned ? Corners{} : corners_around(scene.models[0][0].mesh, point));
        if (fog_of != FogOf::none) {
          const dvec3 fog =
              fog_of == FogOf::legacy ? kAmbientFogColor : fragment_fog_color(setting, intensities, point, fog_angle);
          expected = glm::mix(fog, expected, fog_factor(glm::length(point)));
        }
        if (std::isnan(expected.x)) continue;  // the formula's jump
        const dvec3 difference = glm::abs(pixel(picture, x, y) - expected);
        if (!std::isfinite(difference.x + difference.y + difference.z)) return std::nan("");
        worst = std::max({worst, difference.x, difference.y, difference.z});
        brightest = std::max(brightest, expected.x);
      }
    }
    EXPECT_GT(brightest, 0.2);
    std::printf("%-14s error %.3g\n", std::string(settings.path->name).c_str(), worst);
    return worst;
  }
  static RenderSettings along(std::string_view path, const PaperSettings& papers = {}) {
    return {.path = find_lighting_path(path), .papers = papers};
  }
};

constexpr double kHalfFloat = 0x1p-10;
constexpr double kVertices = 2 * kHalfFloat;  // a rasteriser places vertices to 1/256 of a pixel
constexpr double kTexels = 1.0 / 255;         // for 128 texels a side, in smooth light

TEST_F(PaperFormula, LookupPathsAreHalessEquation) {
  for (const char* path : {"lookup-3d", "lookup-2d"}) {
    for (const double light_ambient : {0.0, 0.4}) {
      const Setting setting{.lamps = lamps(false), .light_ambient = light_ambient};
      const Formula formula = [&](const dvec3& point, const Corners&) { return hales(setting, point); };
      EXPECT_LE(error(setting, along(path, {.light_ambient = light_ambient}), formula), kTexels) << path;
    }
  }
}

// Two lights alike in all but their positions, and bright enough for saturation.
TEST_F(PaperFormula, SampleIsHalessSampleProgram) {
  Setting setting{.lamps = lamps(false)};
  setting.lamps.pop_back();
  for (Lamp& lamp : setting.lamps) lamp.color = {2.2, 1.5, 0.8};
  const Formula formula = [&](const dvec3& point, const Corners&) { return hales_sample(setting, point); };
  EXPECT_LE(error(setting, along("sample"), formula), 2.2 * 2 * kTexels);
}

// "face texture 1 * face texture 2 (if any)": a plain one, and stripes in tiles of their own.
TEST_F(PaperFormula, SecondFaceTextureMultipliesTheFirst) {
  using Equation = dvec3 (*)(const Setting&, const dvec3&);
  constexpr double kTile = 7;  // metres
  Setting setting{.lamps = lamps(false), .texture = {1, 0.9, 0.8}};
  setting.lamps.pop_back();
  setting.lamps[1].color = setting.lamps[0].color;
  const auto add_stripes = [](Material& material) {
    material.second = std::make_shared<const Texels>(stripes());
    material.second_size_m = kTile;
  };
  for (const auto& [path, equation] :
       {std::pair<const char*, Equation>{"sample", hales_sample}, {"lookup-3d", hales}}) {
    const Formula formula = [&, &law = equation](const dvec3& point, const Corners&) {
      const double stripe = stripe_at((point.x + 6) / kTile);
      if (std::isnan(stripe)) return dvec3(stripe);
      Setting here = setting;
      here.texture *= stripe;
      return law(here, point);
    };
    EXPECT_LE(error(setting, along(path), formula, FogOf::hales, angle_attenuation, add_stripes), 2 * kTexels) << path;
  }
}

TEST_F(PaperFormula, RadialPathsAreFraziersEquation) {
  const Setting setting{.lamps = lamps(true)};
  const Formula formula = [&](const dvec3& point, const Corners&) {
    return (directional() + frazier_light(setting, point, angle_attenuation)) * setting.texture;
  };
  EXPECT_LE(error(setting, along("radial"), formula), kTexels);
  EXPECT_LE(error(setting, along("accumulate"), formula), kTexels);
  const Formula by_plane = [&](const dvec3& point, const Corners&) { return frazier_plane(setting, point); };
  EXPECT_LE(error(setting, along("radial-plane"), by_plane), kTexels);
  const Formula untextured = [&](const dvec3& point, const Corners&) {
    return directional() + frazier_light(setting, point, angle_attenuation);
  };
  EXPECT_LE(error(setting, along("light-map"), untextured, FogOf::none), 3 * kTexels);
}

TEST_F(PaperFormula, RadialPlaneOfATurnedWallIsFraziersRotationToZ0) {
  for (const double turn : {-0.5, 0.3}) {
    const Setting setting{.lamps = lamps(true), .turn = turn};
    const Formula formula = [&](const dvec3& point, const Corners&) { return frazier_plane(setting, point); };
    EXPECT_LE(error(setting, along("radial-plane"), formula), kTexels) << turn;
    EXPECT_LE(error(setting, along("radial"), formula), kTexels) << turn;
  }
}

// Away from the circle's edge, which the texels blur.
TEST_F(PaperFormula, OneDiscIsFraziersWhiteCircleAtEveryAngle) {
  for (const double angle : {0.3, 0.785398, 1.2}) {
    Setting setting{.lamps = lamps(true)};
    for (Lamp& lamp : setting.lamps) lamp.exponent = angle, lamp.half_angle = angle / 2;
    const double texel = 2 * std::tan(angle) / 127;
    const Formula formula = [&](const dvec3& point, const Corners&) {
      for (const Lamp& lamp : setting.lamps) {
        const double u = std::acos(glm::dot(glm::normalize(point - lamp.position), lamp.direction));
        if (std::abs(std::tan(u) - std::tan(angle)) < 2 * texel) return dvec3(std::nan(""));
      }
      return (directional() + frazier_light(setting, point, white_circle)) * setting.texture;
    };
    EXPECT_LE(error(setting, along("radial", {.cone_maps = ConeMaps::one_disc}), formula, FogOf::hales, white_circle),
              kTexels)
        << angle;
  }
}

/// Of materials: the texture's, as a rule, and one of its own.
const std::array<std::optional<dvec3>, 2> kAmbientReflectances{std::nullopt, dvec3(0.9, 0.1, 0.6)};

TEST_F(PaperFormula, FragmentPathsAreTheBasicModel) {
  for (const std::optional<dvec3>& ka : kAmbientReflectances) {
    const Setting setting{.lamps = lamps(true), .ka = ka};
    const Formula formula = [&](const dvec3& point, const Corners&) { return unified(setting, point); };
    for (const char* path : {"unified", "tangent", "interpolated", "nested"}) {
      EXPECT_LE(error(setting, along(path), formula), kHalfFloat) << path;
    }
  }
}

// A map's red and green point where u and v grow, on the wall to +X and +Y.
TEST_F(PaperFormula, MappedNormalIsThatOfTheTangentSpace) {
  Setting setting{.lamps = lamps(true), .normal_map = {1, 1, {180, 100, 230, 0}}};
  setting.mapped_normal = glm::normalize(dvec3(180 - 128, 100 - 128, 230 - 128));
  const Formula formula = [&](const dvec3& point, const Corners&) { return unified(setting, point); };
  for (const char* path : {"unified", "tangent", "parallax"}) {
    EXPECT_LE(error(setting, along(path), formula), 2 * kHalfFloat) << path;
  }
  setting.mapped_normal = kNormal;
  EXPECT_LE(error(setting, along("interpolated"), formula), kHalfFloat);
}

// The map's levels are a direction in the model's own space.
TEST_F(PaperFormula, ObjectSpaceNormalTurnsWithItsModel) {
  for (const double turn : {0.0, 0.3}) {
    Setting setting{.lamps = lamps(true), .normal_map = {1, 1, {180, 100, 230, 0}}, .turn = turn};
    const glm::dmat3 turned(glm::rotate(glm::dmat4(1), turn, kTurnAxis));
    setting.mapped_normal = turned * glm::normalize(dvec3(180 - 128, 100 - 128, 230 - 128));
    const Formula formula = [&](const dvec3& point, const Corners&) { return unified(setting, point); };
    EXPECT_LE(error(setting, {.path = &object_space_path()}, formula), 2 * kHalfFloat) << turn;
  }
}

// Welsh 2004: T_n = T_o + h V_xy. Stripes across, heights that rise with v; away from the stripes' edges.
TEST_F(PaperFormula, ParallaxShiftsTheTextureByHeightAlongTheView) {
  constexpr double kTile = 16, kRelief = 2;  // metres
  Setting setting{.lamps = lamps(true), .normal_map = {kTexelsAcross, kTexelsAcross, {}}};
  for (int row = 0; row < kTexelsAcross; ++row) {
    for (int column = 0; column < kTexelsAcross; ++column) {
      setting.normal_map.rgba.insert(setting.normal_map.rgba.end(), {128, 128, 255, std::uint8_t(2 * row)});
    }
  }
  const auto add_stripes = [&](Material& material) {
    material.size_m = kTile;
    material.relief_m = kRelief;
    material.plain_albedo.reset();
    material.albedo = std::make_shared<const Texels>(stripes());
  };
  const Formula formula = [&](const dvec3& point, const Corners&) {
    const dvec3 to_eye = glm::normalize(-point);
    const double row = (point.y + 4) / kTile * kTexelsAcross - 0.5;
    const double height = (2 * row / 254 - 0.5) * kRelief;
    Setting here = setting;
    here.texture = dvec3(stripe_at((point.x + 6 + height * to_eye.x) / kTile));
    return unified(here, point);
  };
  EXPECT_LE(error(setting, along("parallax"), formula, FogOf::hales, angle_attenuation, add_stripes), kTexels);
}

TEST_F(PaperFormula, VertexPathsAreTheirFormulasAtTheVertices) {
  for (const std::optional<dvec3>& ka : kAmbientReflectances) {
    const Setting setting{.lamps = lamps(true), .ka = ka, .cells = 6};
    const auto sums = [&](const dvec3& v) { return basic_sums(setting, v, range_attenuation, angle_attenuation); };
    const Formula vertex = [&](const dvec3&, const Corners& corners) {
      return basic(setting, {corners.interpolated([&](const dvec3& v) { return sums(v).diffuse; }),
                             corners.interpolated([&](const dvec3& v) { return sums(v).specular; })});
    };
    EXPECT_LE(error(setting, along("vertex"), vertex), kVertices);
    EXPECT_LE(
        error(setting, along("mixed"), [&](const dvec3&, const Corners& corners) { return mixed(setting, corners); }),
        kVertices);
    const Formula legacy = [&](const dvec3&, const Corners& corners) {
      return setting.texture * (kAmbientLight + corners.interpolated([&](const dvec3& v) { return sums(v).diffuse; }));
    };
    EXPECT_LE(error(setting, along("legacy"), legacy, FogOf::legacy), kVertices);
  }
}

// Lamps so near that the printed attenuation exceeds 1, and so dim that their extent ends on the wall.
TEST_F(PaperFormula, CgNeitherClampsNorCutsTheAttenuation) {
  Setting setting{.lamps = lamps(true), .ka = kAmbientReflectances[1]};
  setting.lamps[0].c = 0.05, setting.lamps[0].q = 0.02;
  setting.lamps[1].q = 2;
  const auto edge = [](auto shape) {
    return [shape](const Lamp& lamp, const dvec3& v) {
      const double cosa = glm::dot(glm::normalize(v - lamp.position), lamp.direction);
      return shape((cosa - std::cos(lamp.exponent)) / (std::cos(lamp.half_angle) - std::cos(lamp.exponent)));
    };
  };
  const std::pair<SpotEdge, AngleLaw> edges[] = {
      {SpotEdge::hard, edge([](double x) { return x < 0 ? 0.0 : 1.0; })},
      {SpotEdge::lerp, edge([](double x) { return std::clamp(x, 0.0, 1.0); })},
      {SpotEdge::smoothstep, angle_attenuation}};
  for (const auto& [spot_edge, angle] : edges) {
    const Formula formula = [&, &law = angle](const dvec3& point, const Corners&) {
      return basic(setting, basic_sums(setting, point, printed_attenuation, law));
    };
    EXPECT_LE(error(setting, along("cg", {.spot_edge = spot_edge}), formula), 8 * kHalfFloat) << int(spot_edge);
  }
}

// One lamp is so near that its attenuation exceeds 1, and one behind the wall takes away more than there is.
TEST_F(PaperFormula, LacroixClampsNeitherTheAttenuationNorTheCosine) {
  Setting setting{.lamps = lamps(true)};
  setting.lamps[0].c = 0.05, setting.lamps[0].q = 0.02;
  setting.lamps.push_back({{1.5, -0.5, -6.5}, {0, 0, 1}, {0.8, 0.9, 1}, 0, 1, 1e-3, true, 0.5, 1.2});
  double darkest = 1;
  const Formula formula = [&](const dvec3& point, const Corners&) {
    const dvec3 color = lacroix(setting, point);
    darkest = std::min(darkest, color.x);
    return color;
  };
  EXPECT_LE(error(setting, along("lacroix"), formula), 8 * kHalfFloat);
  EXPECT_EQ(darkest, 0);
}

// Shaders are compiled for some numbers of lights only: black ones make up the rest, whose attenuation is not clamped.
TEST_F(PaperFormula, UnclampedAttenuationIsRightForAnyNumberOfLights) {
  for (const std::size_t count : {std::size_t{7}, std::size_t{13}}) {
    Setting setting{.lamps = {}};
    for (std::size_t i = 0; i < count; ++i) {
      setting.lamps.push_back(lamps(true)[i % 3]);
      setting.lamps.back().color *= 3.0 / double(count);
    }
    const Formula cg = [&](const dvec3& point, const Corners&) {
      return basic(setting, basic_sums(setting, point, printed_attenuation, angle_attenuation));
    };
    EXPECT_LE(error(setting, along("cg"), cg), 2 * kHalfFloat) << count;
    const Formula printed = [&](const dvec3& point, const Corners&) { return lacroix(setting, point); };
    EXPECT_LE(error(setting, along("lacroix"), printed), 2 * kHalfFloat) << count;
  }
}

// Surfaces have lamps of their own: what one leaves in the arrays behind the last flag does not light the next.
TEST_F(PaperFormula, NestedFlagsEndTheLightsOfEachSurface) {
  for (const char* name : {"room", "street"}) {
    const Scene scene = read_scene(bundled_scene_path(name));
    std::vector<Picture> pictures;
    for (const char* path : {"unified", "nested"}) {
      Renderer renderer(scene, 2 * kWidth, 2 * kHeight, along(path));
      renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp2, 100.0)));
      renderer.draw();
      pictures.push_back(renderer.read());
    }
    EXPECT_LE(largest_difference(pictures[0], pictures[1]), 8 * kHalfFloat) << name;
  }
}

// The last lamp grazes the wall, whose facets then mask its light if they are rough.
TEST_F(PaperFormula, MetalsAreTheirPapersModels) {
  Setting setting{.lamps = lamps(true), .metal_roughness = 0.3};
  setting.lamps.push_back(
      {{-3, 0.5, -4.5}, glm::normalize(dvec3(1, -0.1, -0.05)), {4, 4.5, 5}, 1, 0, 0.3, true, 0.1, 0.7});
  for (const auto& [path, reflect] :
       {std::pair<const char*, Reflect>{"cook-torrance", cook_torrance}, {"anisotropic", brushed}}) {
    const Formula formula = [&, model = reflect](const dvec3& point, const Corners&) {
      return metal(setting, point, model);
    };
    for (const double roughness : {0.3, 0.9}) {
      setting.metal_roughness = roughness;
      EXPECT_LE(error(setting, along(path), formula), 2 * kHalfFloat) << path << ", " << roughness;
    }
  }
  Setting plain = setting;
  plain.metal_roughness = 0;
  const Formula basic_model = [&](const dvec3& point, const Corners&) { return unified(plain, point); };
  EXPECT_LE(error(plain, along("cook-torrance"), basic_model), kHalfFloat);
  EXPECT_LE(error(plain, along("anisotropic"), basic_model), kHalfFloat);
}

// Drawn without lights, the polygons out of every light's reach look the same, up to the roundings of other passes.
TEST_F(PaperFormula, SortedPolygonsMakeTheSamePicture) {
  const Scene scene = read_scene(bundled_scene_path("headlights"));
  const Scene sorted = sort_polygons(scene, along("lookup-2d"));
  std::size_t triangles = 0;
  std::size_t beyond = 0;
  for (const Instance& instance : sorted.instances) {
    const std::size_t count = triangle_count(sorted.models[instance.model]);
    triangles += count;
    if (instance.is_beyond_lights) beyond += count;
  }
  std::size_t before = 0;
  for (const Instance& instance : scene.instances) before += triangle_count(scene.models[instance.model]);
  EXPECT_EQ(triangles, before);
  EXPECT_GT(5 * beyond, triangles);
  EXPECT_LT(beyond, triangles);
  std::vector<Picture> pictures;
  for (const Scene* drawn : {&scene, &sorted}) {
    Renderer renderer(*drawn, 2 * kWidth, 2 * kHeight, along("lookup-2d"));
    renderer.set_atmosphere(renderer.scene().atmosphere.with(Fog::from_visibility(FogMode::exp2, 100.0)));
    renderer.draw();
    pictures.push_back(renderer.read());
  }
  EXPECT_LE(largest_difference(pictures[0], pictures[1]), 8 * kHalfFloat);
}

}  // namespace

}  // namespace litfog::test
