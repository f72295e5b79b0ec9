// SPDX-License-Identifier: Apache-2.0
#include "litfog/multiple_scattering.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "airlight_text.h"
#include "model/level_range.h"
#include "model/require.h"
#include "model/unchecked.h"
#include "require_rays.h"

namespace litfog {
namespace {

using airlight_text::NoCookie;
using airlight_text::Text;
using std::clamp, std::exp, std::log, std::max, std::min;

/// 1/m: thinner fog has no light that is scattered twice. In it and in thicker fog than the other, squares have no
/// double.
constexpr double kThinnest = 1e-100, kThickest = 1e100;

/// The table of the shaders has this many steps to one of data/scattering/point.csv: between nodes that stand so close
/// bilinear interpolation does.
constexpr int kFineness = 4;
constexpr int kTabulatedDepths = (kScatteringDepths - 1) / kFineness + 1;
constexpr int kTabulatedAngles = (kScatteringAngles - 1) / kFineness + 1;

/// The difference of logarithms within which a table is that of a phase function.
constexpr double kTableAgreement = kScatteringMedianError / 2;

/// A row of data/scattering/point.csv.
struct Row {
  const char* phase;
  double numbers[kTabulatedAngles + 3];  // the phase function's parameter, the depth, M / (I d^2), their error

  double parameter() const { return numbers[0]; }
  double logarithm(int angle) const { return std::log(numbers[2 + angle]); }
};
constexpr Row kRows[] = {
#include "scattering_rows.inc"
};
static_assert(std::size(kRows) % kTabulatedDepths == 0);

/// The rows of phase functions of a kind, one table after the other, by rising parameters.
std::span<const Row> rows_of(char kind) {
  const auto is_kind = [&](const Row& row) { return row.phase[0] == kind; };
  const auto first = std::ranges::find_if(kRows, is_kind);
  return {first, std::ranges::find_if_not(first, std::end(kRows), is_kind)};
}

/// Where a phase function lies among those of the tables.
struct PhasePlace {
  std::span<const Row> rows;  // empty: nowhere
  double parameter;
};

PhasePlace place(const Phase& phase) {
  if (is_isotropic(phase)) return {rows_of('h'), 0};
  if (phase.weight == 1 && phase.first.alpha == 0) {
    const std::span<const Row> rows = rows_of('h');
    const double asymmetry = phase.first.asymmetry;
    return {asymmetry >= 0 && asymmetry <= rows.back().parameter() ? rows : std::span<const Row>(), asymmetry};
  }
  const std::optional<double> diameter = droplet_diameter(phase);
  return {diameter ? rows_of('d') : std::span<const Row>(), diameter.value_or(0)};
}

/// In which tables are interpolated.
double coordinate(const PhasePlace& of, double parameter) {
  return of.rows.front().phase[0] == 'h' ? -std::log1p(-parameter) : std::log(parameter);
}

/// The two tables of data/scattering/point.csv between which that of a phase function lies.
struct Neighbours {
  const Row* first;
  const Row* second;
  double fraction;  // of the second

  double logarithm(int depth, int angle) const {
    return std::lerp(first[depth].logarithm(angle), second[depth].logarithm(angle), fraction);
  }
};

Neighbours neighbours_of(const PhasePlace& at) {
  const std::size_t tables = at.rows.size() / kTabulatedDepths;
  const auto parameter = [&](std::size_t i) { return coordinate(at, at.rows[i * kTabulatedDepths].parameter()); };
  const double x = coordinate(at, at.parameter);
  std::size_t below = 0;
  while (below + 2 < tables && parameter(below + 1) <= x) ++below;
  const double fraction = std::clamp((x - parameter(below)) / (parameter(below + 1) - parameter(below)), 0.0, 1.0);
  return {&at.rows[below * kTabulatedDepths], &at.rows[(below + 1) * kTabulatedDepths], fraction};
}

/// A profile whose densities, times any height, are finite.
DensityProfile thinned(DensityProfile profile) {
  for (DensityKnot& knot : profile.knots) knot.density = std::min(knot.density, double(kMaxKnotDensity));
  return profile;
}

struct ScatteringText : Text<double, NoCookie> {
  struct LitfogScatteredBeam {
    double share, radial, turned, forward;
  };
  const ScatteringTable* table = nullptr;
  const ScatteredBeam* only_beam = nullptr;

  double litfog_scattering_log(double row, double column) const {
    const double y = std::clamp(row, 0.0, kScatteringDepths - 1.0),
                 x = std::clamp(column, 0.0, kScatteringAngles - 1.0);
    const auto i = std::min(std::size_t(y), std::size_t(kScatteringDepths - 2));
    const auto j = std::min(std::size_t(x), std::size_t(kScatteringAngles - 2));
    const auto along = [&](std::size_t depth) {
      return std::lerp(double(table->logs[depth][j]), double(table->logs[depth][j + 1]), x - double(j));
    };
    return std::lerp(along(i), along(i + 1), y - double(i));
  }

  LitfogScatteredBeam litfog_scattered_beam(double, double row, double column) const {
    const double y = std::clamp(row, 0.0, kBeamDepths - 1.0), x = std::clamp(column, 0.0, kBeamAngles - 1.0);
    const auto i = std::min(std::size_t(y), std::size_t(kBeamDepths - 2));
    const auto j = std::min(std::size_t(x), std::size_t(kBeamAngles - 2));
    const auto at = [&](float ScatteredBeam::Texel::*member) {
      const auto along = [&](std::size_t depth) {
        const auto& texels = only_beam->texels[depth];
        return std::lerp(double(texels[j].*member), double(texels[j + 1].*member), x - double(j));
      };
      return std::lerp(along(i), along(i + 1), y - double(i));
    };
    using Texel = ScatteredBeam::Texel;
    return {at(&Texel::share), at(&Texel::radial), at(&Texel::turned), at(&Texel::forward)};
  }

  static double acos(double x) { return std::acos(x); }
  static double atan(double y, double x) { return std::atan2(y, x); }
  static double pow(double x, double y) { return std::pow(x, y); }
  static double sin(double x) { return std::sin(x); }
  static double cos(double x) { return std::cos(x); }

#define LITFOG_REAL double
#define LITFOG_CONSTANT static constexpr
#define litfog_expm1 std::expm1
#define LITFOG_FUNCTION static
#include "litfog/shaders/diffuse_light.glsl"  // undefines LITFOG_REAL
#define LITFOG_REAL double
#include "litfog/shaders/multiple_scattering.glsl"  // undefines both
#define LITFOG_REAL double
#define LITFOG_CONSTANT static constexpr
#include "litfog/shaders/layered_scattering.glsl"  // undefines both
#undef litfog_expm1
};

/// Number i of the fine ones: Edwin Catmull and Raphael Rom's cubic between tabulated numbers, of which the outermost
/// go on as a parabola.
template <std::size_t kCount>
double cubic_at(const std::array<double, kCount>& numbers, int i) {
  const auto first = std::min(std::size_t(i / kFineness), kCount - 2);
  const double t = double(i) / kFineness - double(first);
  const auto at = [&](std::size_t k) { return numbers[k]; };
  const double b = at(first), c = at(first + 1);
  const double a = first > 0 ? at(first - 1) : 3 * b - 3 * c + at(first + 2);
  const double d = first + 2 < kCount ? at(first + 2) : 3 * c - 3 * b + at(first - 1);
  return b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

constexpr std::size_t kNodes = 36;

/// A trapezoidal rule for integrals of e^-y / D(y) over y > 0, where D has no zero with Re y > 0: in u, y = e^t and
/// t = u - e^(-0.35 u). In t, the integrand is analytic in a strip of half width pi / 2. Small y, where t takes the
/// longest steps, weigh little.
struct IntensityRule {
  std::array<double, kNodes> depths, inverses, roots, weights;  // roots of the inverses
};

IntensityRule make_intensity_rule() {
  constexpr double kFirst = -7.1, kStep = 0.3;  // y from 5e-9 to 22
  constexpr double kBend = 0.35;
  IntensityRule rule;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const double u = kFirst + kStep * double(i);
    const double bent = exp(-kBend * u);
    const double depth = exp(u - bent);
    rule.depths[i] = depth;
    rule.inverses[i] = 1 / depth;
    rule.roots[i] = std::sqrt(rule.inverses[i]);
    rule.weights[i] = kStep * (1 + kBend * bent) * depth * exp(-depth);
  }
  return rule;
}

/// The integral of x^power e^-x from 0 to an end: the lower incomplete gamma function, by its series.
///
/// last  end^(power + 1) e^-end
double integrate_plateau(double power, double end, double last) {
  constexpr double kWhole = 60;  // from where on the rest is below 1e-20
  if (end > kWhole) return std::tgamma(power + 1);
  double term = last / (power + 1), sum = 0;
  for (double n = power + 2; term > 1e-17 * sum; ++n) {
    sum += term;
    term *= end / n;
  }
  return sum;
}

/// Integrals over the depth x = d r, where all that light is scattered for the first time.
struct LawIntegrals {
  double intensity;  // of d e^-x r^2 a(r) dr: effective_intensity()
  double roots;      // the same times x^(-1/2)
};

/// With the depth k of the knee and x = k + y, for powers of 0 and -1/2,
///   (1 / d^2) integral of x^(2 + power) e^-x from 0 to k
///     +  e^-k integral of (k + y)^power e^-y / ((C / r + L) / r + Q) over y > 0.
LawIntegrals integrate_law(const Attenuation& attenuation, double density) {
  static const IntensityRule rule = make_intensity_rule();
  density = std::clamp(density, kThinnest, kThickest);
  constexpr double kDarkDepth = 700;
  const bool has_knee = attenuation.constant < 1;
  const double knee = has_knee ? min(density * unchecked::compute_extent(attenuation, 1), kDarkDepth) : 0;
  const auto sum_over = [&](const auto& inverse_depth, const auto& inverse_root) {
    double sums[4] = {}, roots[4] = {};  // which compilers turn into vectors
    for (std::size_t i = 0; i < kNodes; i += 4) {
      for (std::size_t j = 0; j < 4; ++j) {
        const double inverse = density * inverse_depth(i + j);
        const double part = rule.weights[i + j] /
                            ((attenuation.constant * inverse + attenuation.linear) * inverse + attenuation.quadratic);
        sums[j] += part;
        roots[j] += part * inverse_root(i + j);
      }
    }
    return LawIntegrals{(sums[0] + sums[1]) + (sums[2] + sums[3]), (roots[0] + roots[1]) + (roots[2] + roots[3])};
  };
  if (!has_knee) {
    return sum_over([&](std::size_t i) { return rule.inverses[i]; }, [&](std::size_t i) { return rule.roots[i]; });
  }
  const double left = exp(-knee), root = std::sqrt(knee), square = density * density;
  const LawIntegrals plateau{integrate_plateau(2, knee, knee * knee * knee * left) / square,
                             integrate_plateau(1.5, knee, knee * knee * root * left) / square};
  if (knee == kDarkDepth) return plateau;
  const auto inverse_depth = [&](std::size_t i) { return 1 / (knee + rule.depths[i]); };
  const LawIntegrals beyond = sum_over(inverse_depth, [&](std::size_t i) { return std::sqrt(inverse_depth(i)); });
  return {plateau.intensity + left * beyond.intensity, plateau.roots + left * beyond.roots};
}

double soft_range_of(const LawIntegrals& law, double density, double phase_cosine) {
  // Of a lamp with 1 / r^2 the mean of depth^(-1/2) is the root of pi.
  const double x = std::sqrt(std::numbers::pi) * law.intensity / law.roots - 1;
  if (!(x > 0)) return 0;
  return (1 + phase_cosine) * x * x / (std::sqrt(0.3 + 1.3 * x) * std::clamp(density, kThinnest, kThickest));
}

}  // namespace

std::optional<ValueError> find_scattering_error(const Atmosphere& atmosphere) {
  if (atmosphere.fog.mode != FogMode::exp) {
    return ValueError{"fog.mode", double(atmosphere.fog.mode), "must be exp for all orders of scattering"};
  }
  if (atmosphere.albedo != 1) return ValueError{"albedo", atmosphere.albedo, "must be 1 for all orders of scattering"};
  if (place(atmosphere.phase).rows.empty()) {
    return ValueError{
        "phase.first.asymmetry", atmosphere.phase.first.asymmetry,
        "must be of one lobe with alpha 0 and g in [0, 0.95], or of droplets, for all orders of scattering"};
  }
  return std::nullopt;
}

std::optional<ValueError> find_error(const ScatteringTable& table, const Atmosphere& atmosphere) {
  if (const auto error = find_scattering_error(atmosphere)) return error;
  for (const auto& row : table.logs) {
    const auto is_fit = [](float each) { return std::abs(each) <= 100; };
    int fit = 0;
    for (const float each : row) fit += is_fit(each);  // without a branch, which compilers turn into vectors
    if (fit == kScatteringAngles) continue;
    return ValueError{"table", *std::ranges::find_if_not(row, is_fit), "must be at most 100 in magnitude"};
  }
  const Neighbours expected = neighbours_of(place(atmosphere.phase));
  for (const auto& [depth, angle] :
       {std::pair(0, 0), std::pair(0, kTabulatedAngles - 1), std::pair(kTabulatedDepths - 1, 0)}) {
    const float log = table.logs[std::size_t(depth * kFineness)][std::size_t(angle * kFineness)];
    if (!(std::abs(log - expected.logarithm(depth, angle)) <= kTableAgreement)) {
      return ValueError{"table", log, "must be of make_scattering_table for the atmosphere's phase function"};
    }
  }
  return std::nullopt;
}

ScatteringTable make_scattering_table(const Atmosphere& atmosphere) {
  require(find_error(atmosphere));
  require(find_scattering_error(atmosphere));
  const Neighbours neighbours = neighbours_of(place(atmosphere.phase));
  std::array<std::array<double, kTabulatedAngles>, kTabulatedDepths> logs;
  for (int i = 0; i < kTabulatedDepths; ++i) {
    for (int j = 0; j < kTabulatedAngles; ++j) logs[std::size_t(i)][std::size_t(j)] = neighbours.logarithm(i, j);
  }
  ScatteringTable table;
  for (int j = 0; j < kScatteringAngles; ++j) {
    std::array<double, kTabulatedDepths> column;
    for (std::size_t i = 0; i < kTabulatedDepths; ++i) column[i] = cubic_at<kTabulatedAngles>(logs[i], j);
    for (int i = 0; i < kScatteringDepths; ++i) {
      table.logs[std::size_t(i)][std::size_t(j)] = float(cubic_at<kTabulatedDepths>(column, i));
    }
  }
  return table;
}

double scattered_at(const ScatteringTable& table, double depth, double angle) {
  const NoCookie no_cookie;
  return ScatteringText{{no_cookie}, &table}.litfog_scattered_at(depth, angle);
}

namespace {

void require_density(double density) {
  if (!(density > 0 && std::isfinite(density))) {
    require(ValueError{"density", density, "must be finite and > 0"});
  }
}

}  // namespace

double effective_intensity(const Attenuation& attenuation, double density) {
  require(find_error(attenuation));
  require_density(density);
  return integrate_law(attenuation, density).intensity;
}

double soft_range(const Attenuation& attenuation, double density, const Phase& phase) {
  require(find_error(attenuation));
  require(find_error(phase));
  require_density(density);
  return soft_range_of(integrate_law(attenuation, density), density, mean_cosine(phase));
}

unchecked::PointSource unchecked::point_source(const Attenuation& attenuation, const Fog& seen_fog,
                                               double phase_cosine) {
  if (!(seen_fog.density > kThinnest) || std::isinf(seen_fog.density) || seen_fog.mode != FogMode::exp) return {};
  const LawIntegrals law = integrate_law(attenuation, seen_fog.density);
  return {law.intensity, law.intensity > 0 ? soft_range_of(law, seen_fog.density, phase_cosine) : 0};
}

double source_intensity(const Light& light, const Atmosphere& atmosphere) {
  return scattering_source(light, atmosphere).intensity;
}

ScatteringSource scattering_source(const Light& light, const Atmosphere& atmosphere) {
  require(find_error(light));
  require(find_error(atmosphere));
  const double cosine = mean_cosine(atmosphere.phase);
  const Fog fog = unchecked::scaled(atmosphere.thickest_fog(), light.density_scale);
  const auto [intensity, soft_range] = unchecked::point_source(light.attenuation, fog, cosine);
  return {.intensity = intensity, .soft_range = soft_range, .phase_cosine = cosine};
}

ScatteringSource scattering_source(const Light& light, const BeamMoments& shape, const Atmosphere& atmosphere,
                                   const ThinBeams& beams) {
  require(find_error(beams));
  ScatteringSource source = scattering_source(light, atmosphere);
  source.is_cone = shape[0] < 1;
  source.beam = make_scattered_beam(shape, beams);
  return source;
}

ScatteringSource scattering_source(const Light& light, const Atmosphere& atmosphere, const ThinBeams& beams) {
  return scattering_source(light, beam_moments(light.cone), atmosphere, beams);
}

namespace {

double scattered_along(const PlacedLight& light, const ScatteringSource& source, const Atmosphere& atmosphere,
                       const ScatteringTable& table, const EyeRay& ray) {
  if (!(source.intensity > 0)) return 0;
  Fog fog = unchecked::scaled(atmosphere.fog, light.light.density_scale);
  fog.density = std::min(fog.density, kThickest);
  const NoCookie no_cookie;
  const DensityProfile layers = thinned(atmosphere.profile);
  ScatteringText text{{no_cookie, layers}, &table, &source.beam};
  const auto air = text.seen_along(light, 0, fog, ray, LampLeg::fogged, phase_text::pack<double>(atmosphere.phase));
  if (text.litfog_airlight_is_layered(air)) {
    return source.intensity *
           text.litfog_layered_scattering(air, source.soft_range, source.is_cone ? 0 : -1, source.phase_cosine);
  }
  return source.intensity * (source.is_cone
                                 ? text.litfog_multiple_scattering(air, source.soft_range, 0, source.phase_cosine)
                                 : text.litfog_multiple_scattering(air, source.soft_range));
}

}  // namespace

double multiple_scattering(const PlacedLight& light, const ScatteringSource& source, const Atmosphere& atmosphere,
                           const ScatteringTable& table, const EyeRay& ray) {
  require(find_error(light));
  require(find_error(atmosphere));
  require(find_error(ray));
  require(find_scattering_error(atmosphere));
  return scattered_along(light, source, atmosphere, table, ray);
}

std::optional<ValueError> find_error(const DiffuseLight& light) {
  constexpr double kMost = 1e100;  // its square is a finite double
  if (!(light.all >= 0 && light.all <= kMost)) return ValueError{"all", light.all, "must be in [0, 1e100]"};
  for (int i = 0; i < 3; ++i) {
    constexpr const char* kFields[] = {"flow.x", "flow.y", "flow.z"};
    if (!(std::abs(light.flow[i]) <= kMost)) {
      return ValueError{kFields[i], light.flow[i], "must be at most 1e100 in magnitude"};
    }
  }
  return std::nullopt;
}

void scattered_light(const PlacedLight& light, const ScatteringSource& source, const Atmosphere& atmosphere,
                     std::span<const glm::dvec3> positions, std::span<DiffuseLight> scattered) {
  assert(positions.size() == scattered.size());
  require(find_error(light));
  require(find_error(atmosphere));
  require(find_scattering_error(atmosphere));
  if (const double share = source.beam.texels[0][0].share; source.intensity > 0 && !(share > 0)) {
    require(ValueError{"source.beam", share, "must be the light's, made with ThinBeams"});
  }
  for (const glm::dvec3& position : positions) {
    require(find_position_error(position, {"position.x", "position.y", "position.z"}));
  }
  const NoCookie no_cookie;
  const DensityProfile layers = thinned(atmosphere.profile);
  ScatteringText text{{no_cookie, layers}, nullptr, &source.beam};
  ScatteringText::LitfogAirlight air{};
  air.density = unchecked::scaled(atmosphere.fog, light.light.density_scale).density;
  air.layer_scale = atmosphere.profile.count > 0 ? light.light.density_scale : 0;
  air.lamp_height = light.position.y;
  const double phase_cosine = mean_cosine(atmosphere.phase);
  const glm::dvec3 axis = glm::normalize(light.direction);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 offset = positions[i] - light.position;
    const double range = glm::length(offset);
    scattered[i] = {};
    if (!(source.intensity > 0) || !(range > 0)) continue;
    const glm::dvec3 away = offset / range;
    const double cosine = std::clamp(glm::dot(away, axis), -1.0, 1.0);
    const glm::dvec3 turned = away * cosine - axis;
    const double sine = glm::length(turned);
    const auto found =
        text.litfog_airlight_is_layered(air)
            ? text.litfog_scattered_light_in_layers(air, positions[i].y, range, source.soft_range, 0, cosine,
                                                    phase_cosine)
            : text.litfog_scattered_light(air.density, range, source.soft_range, 0, cosine, phase_cosine);
    const glm::dvec3 flow = found.radial * away + (sine > 0 ? found.turned / sine * turned : glm::dvec3(0.0));
    scattered[i] = source.intensity * DiffuseLight{.all = found.all, .flow = flow};
  }
}

double irradiance(const DiffuseLight& light, const glm::dvec3& normal) {
  require(find_error(light));
  require(find_direction_error(normal, "normal"));
  return ScatteringText::litfog_diffuse_irradiance(light.all, glm::length(light.flow), -glm::dot(light.flow, normal));
}

void multiple_scattering(const PlacedLight& light, const Atmosphere& atmosphere, const ScatteringTable& table,
                         std::span<const EyeRay> rays, std::span<double> scattered) {
  assert(rays.size() == scattered.size());
  require(find_error(light));
  require(find_error(atmosphere));
  require(find_error(table, atmosphere));
  require_rays(rays);
  const ScatteringSource source = light.light.cone.is_point_light()
                                      ? scattering_source(light.light, atmosphere)
                                      : scattering_source(light.light, atmosphere, make_thin_beams(atmosphere, table));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    scattered[i] = scattered_along(light, source, atmosphere, table, rays[i]);
  }
}

}  // namespace litfog
