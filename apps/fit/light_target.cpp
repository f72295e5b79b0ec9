// SPDX-License-Identifier: Apache-2.0
#include "fit/light_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>
#include <utility>

#include "files/angle_deg.h"
#include "litfog/input_error.h"
#include "litfog/light.h"
#include "litfog/photometry/axial_beam.h"
#include "litfog/photometry/elliptical_beam.h"
#include "model/float_limit.h"
#include "text/shown_number.h"

namespace litfog::fit {
namespace {

/// Illuminance at which a photometric file's light ends: 1 lx, as for the lights of data/lights.
constexpr double kEndIlluminance = 1;
constexpr double kHorizon = 1e-9;  // cosine from the photometric axis that is level within rounding
constexpr double kAimed = 0.5;     // fraction of the asymmetry about the axis, below which a beam is aimed at its peak

AxialBeam beam_about_best_axis(const IntensityDistribution& distribution, const glm::dvec3& peak) {
  const double cosine = glm::dot(peak, kPhotometricAxis);
  const glm::dvec3 axis = cosine < -kHorizon ? -kPhotometricAxis : kPhotometricAxis;
  AxialBeam about_axis(distribution, axis);
  const double asymmetry = about_axis.asymmetry();
  if (asymmetry <= kRoundBeam || peak == axis) return about_axis;
  AxialBeam about_peak(distribution, peak);
  return about_peak.asymmetry(kAimed * asymmetry) < kAimed * asymmetry ? std::move(about_peak) : std::move(about_axis);
}

/// The type whose angles name a luminaire's directions. An isocandela table has degrees to the right and above, though
/// the beam of its ellipses is kept about its axis.
PhotometryType angle_type_of(const Luminaire& luminaire) {
  return luminaire.is_isocandela ? PhotometryType::a : luminaire.distribution.type;
}

/// peak  direction of the largest intensity
AxialBeam beam_of(const Luminaire& luminaire, const glm::dvec3& peak, const AxisChoice& choice) {
  const IntensityDistribution& distribution = luminaire.distribution;
  switch (choice.kind) {
    case AxisChoice::Kind::best:
      break;
    case AxisChoice::Kind::peak:
      return AxialBeam(distribution, peak);
    case AxisChoice::Kind::down:
      return AxialBeam(distribution, kPhotometricAxis);
    case AxisChoice::Kind::up:
      return AxialBeam(distribution, -kPhotometricAxis);
    case AxisChoice::Kind::given:
      return AxialBeam(distribution, direction_of(angle_type_of(luminaire), choice.horizontal, choice.vertical));
  }
  return beam_about_best_axis(distribution, peak);
}

/// Multiplies the luminaire's intensities, whose product may leave their range.
///
/// what  names the factor in the error
void scale_luminaire(LightTarget& target, double factor, const char* what) {
  Luminaire& luminaire = *target.luminaire;
  for (double& candela : luminaire.distribution.intensity) candela *= factor;
  if (target.cone) {
    for (ConeSample& sample : target.cone->samples) sample.intensity *= factor;
  }
  if (find_error(luminaire.distribution)) {
    throw InputError(luminaire.peak_location, "largest intensity", shown_number(target.luminaire_peak.intensity),
                     fmt::format("must be in (0, 1e30] times the {} {}", what, shown_number(factor)));
  }
  target.luminaire_peak.intensity *= factor;
}

/// Lamps whose output depends on how they burn: their intensities as mounted.
void apply_tilt(LightTarget& target, double tilt) {
  const auto& data = target.luminaire->tilt;
  if (!data) return;
  const double factor = tilt_factor(*data, tilt);
  scale_luminaire(target, factor, "tilt factor");
  target.derived.push_back(
      fmt::format("Tilt: {} deg, where the lamps give {} of what they give as measured. --tilt changes it.",
                  files::shown_degrees(tilt), shown_number(factor)));
}

/// The luminaire as it is mounted, and its peak.
void set_luminaire(LightTarget& target, Luminaire luminaire, double tilt) {
  target.luminaire = std::move(luminaire);
  target.luminaire_peak = find_peak(target.luminaire->distribution);
  target.opening_radius = opening_radius(target.luminaire->opening);
  apply_tilt(target, tilt);
  target.peak = target.luminaire_peak.intensity;
}

/// The axis, the asymmetry about it, and the intensities that a cone about it is fitted to.
void set_beam(LightTarget& target, const AxisChoice& choice) {
  AxialBeam beam = beam_of(*target.luminaire, target.luminaire_peak.direction, choice);
  target.axis = beam.axis();
  target.asymmetry = beam.asymmetry();
  target.cone->samples = cone_samples(beam.profile());
}

/// Sets the light's peak. Where a luminaire's is not its largest intensity, the step is told.
void set_light_peak(LightTarget& target) {
  target.light_peak = target.peak;
  if (!target.luminaire) return;
  const double mean = peak_of(target.cone->samples);
  const double largest = target.luminaire_peak.intensity;
  constexpr double kSame = 1e-9;
  if (std::abs(mean / largest - 1) < kSame) return;
  if (target.cookie_size > 0) {
    target.derived.push_back(fmt::format(
        "Peak: {} cd, the largest intensity, of which the cookie has fractions. The light is for its cookie; by "
        "its cone, whose peak is {} cd, it is too bright.",
        shown_number(largest), shown_number(mean)));
    return;
  }
  target.light_peak = mean;
  target.derived.push_back(
      fmt::format("Peak: {} cd, the largest mean over the turn about the axis, which keeps the flux; the largest "
                  "intensity is {} cd.",
                  shown_number(mean), shown_number(largest)));
}

/// "what a pilot sees by night, ..." after a comma, of an illuminance that has a name.
std::string source_of(double end_illuminance) {
  const auto named = std::ranges::find(kVisualThresholds, end_illuminance, &VisualThreshold::illuminance);
  return named == kVisualThresholds.end() ? "" : fmt::format(", {}", named->source);
}

/// Ends a light of a known peak and range target where it gives an illuminance.
void set_end(LightTarget& target, double lux) {
  const double peak = *target.light_peak, threshold = target.range->threshold;
  const auto [size, extent] = compute_end(peak, lux, threshold);
  target.end_illuminance = lux;
  target.size = size;
  target.range->extent = extent;
  target.derived.push_back(fmt::format("Extent: sqrt((1 - {}) * {} cd / {} lx) = {} m, where the light gives {} lx{}.",
                                       shown_number(threshold), shown_number(peak), shown_number(lux),
                                       shown_number(extent), shown_number(lux), source_of(lux)));
  if (size == 1) return;
  target.derived.push_back(fmt::format("Color: times {} lx / ({} lx * {}) = {}, because 1 stands for {} lx.",
                                       shown_number(lux), kWhiteLux, shown_number(threshold), shown_number(size),
                                       kWhiteLux));
}

/// A luminaire's range without one that is stated. What is wrong is shown as the file's, which has intensities and no
/// extent.
void set_range_of_luminaire(LightTarget& target) {
  set_light_peak(target);
  target.range.emplace();
  set_end(target, kEndIlluminance);
  if (const auto error = find_error(*target.range)) {
    throw InputError(target.luminaire->peak_location, "largest intensity",
                     shown_number(target.luminaire_peak.intensity), "must give an extent: " + to_string(*error));
  }
}

std::string sentence_on_cone(const LightTarget& target) {
  return fmt::format("Cone: fitted to {}, the mean over the turn about its axis: {}.",
                     std::filesystem::path(target.luminaire->file).filename().string(),
                     describe_axis(*target.luminaire, target.axis));
}

/// What a fit does not take, at the value of the spec that it comes from.
///
/// part  the target's member of the spec: "range" or "cone"
InputError error_at(const LightSpec& spec, const char* part, const TargetError& error) {
  const std::string holder = error.sample ? fmt::format("{}.samples[{}]", part, *error.sample) : part;
  const auto& [field, value, rule] = error.error;
  constexpr double kMaxPercentage = 100;  // more is none, but may be lux
  const bool may_be_lux = field == std::string_view("attenuation") && value > kMaxPercentage;
  return spec.error_at(fmt::format("{}.{}", holder, field), fmt::format("{}", value),
                       std::string(rule) + (may_be_lux ? "; lx belong in illuminance" : ""));
}

AttenuationFamily family_of(RangeSpec::Family family) {
  switch (family) {
    case RangeSpec::Family::quadratic:
      break;
    case RangeSpec::Family::linear:
      return AttenuationFamily::linear;
    case RangeSpec::Family::mixed:
      return AttenuationFamily::mixed;
  }
  return AttenuationFamily::quadratic;
}

/// The flux of a light with 1 cd at its peak, and what has it: a luminaire, or the cone as it will be fitted.
struct UnitFlux {
  double flux;
  std::string of;
};

UnitFlux unit_flux_of(const LightTarget& target) {
  if (target.luminaire) {
    return {luminous_flux(target.luminaire->distribution) / target.luminaire_peak.intensity,
            std::filesystem::path(target.luminaire->file).filename().string()};
  }
  const Cone cone = target.cone ? fit_cone(*target.cone).best().cone : Cone{};
  return {flux_within(cone, std::numbers::pi), target.cone ? "the fitted cone" : "a point light"};
}

/// The candela whose inverse square is nearest to a table of illuminance, by the least squares of ln lx.
double peak_of_table(const std::vector<RangeSpec::Illuminance>& rows, LightTarget& target) {
  const auto candela_of = [](const RangeSpec::Illuminance& row) { return row.lux * row.range * row.range; };
  double sum = 0, farthest = 0;
  for (const auto& row : rows) sum += std::log(row.lux) + 2 * std::log(row.range);
  const double peak = std::exp(sum / double(rows.size()));
  for (const auto& row : rows) {
    const double error = peak / candela_of(row) - 1;
    if (std::abs(error) > std::abs(farthest)) farthest = error;
  }
  target.derived.push_back(fmt::format(
      "Peak: {} cd, the geometric mean of lx * m^2 in the {} rows of illuminance, from which it is off by {} % "
      "at most.",
      shown_number(peak), rows.size(), shown_change(100 * farthest, 3)));
  return peak;
}

/// The peak intensity that a spec's range states in one way or another, with the step that leads there.
std::optional<double> stated_peak(const RangeSpec& range, LightTarget& target) {
  if (range.illuminance.size() == 1) {
    const auto& [metres, lux] = range.illuminance.front();
    const double peak = lux * metres * metres;
    target.derived.push_back(
        fmt::format("Peak: {} lx * ({} m)^2 = {} cd.", shown_number(lux), shown_number(metres), shown_number(peak)));
    return peak;
  }
  if (!range.illuminance.empty()) return peak_of_table(range.illuminance, target);
  if (range.flux) {
    const UnitFlux unit = unit_flux_of(target);
    const double peak = *range.flux / unit.flux;
    target.derived.push_back(fmt::format("Peak: {} lm / {} sr = {} cd, with the flux of {} per candela.",
                                         shown_number(*range.flux), shown_number(unit.flux), shown_number(peak),
                                         unit.of));
    return peak;
  }
  return range.peak;
}

/// A luminaire's intensities made those of a light with another peak.
void scale_to_peak(const LightSpec& spec, LightTarget& target, double peak) {
  const double factor = peak / *target.peak;
  if (factor == 1) return;
  if (!(peak >= 1 / kMaxIntensity && peak <= kMaxIntensity)) {
    throw spec.error_at("range.peak", fmt::format("{} cd", shown_number(peak)), "must have a peak in [1e-30, 1e30] cd");
  }
  scale_luminaire(target, factor, "spec's factor");
  target.derived.push_back(fmt::format("Photometry: times {}, from its peak of {} cd to {} cd.", shown_number(factor),
                                       shown_number(*target.peak), shown_number(peak)));
}

/// Throws the error of a derived extent or colour that no light has, at the member that puts it there.
void expect_end(const LightSpec& spec, const LightTarget& target, double lux) {
  const RangeSpec& range = *spec.range;
  const auto end_at = [&](double end) { return compute_end(*target.light_peak, end, range.threshold); };
  const auto error_of = [&](double end) { return find_error(AttenuationTarget{.extent = end_at(end).extent}); };
  if (const auto error = error_of(lux)) {
    const char* const member = !error_of(kEndIlluminance)   ? "range.end_lx"
                               : !range.illuminance.empty() ? "range.illuminance"
                               : range.flux                 ? "range.flux_lm"
                                                            : "range.peak_cd";
    throw spec.error_at(member, "",
                        fmt::format("the extent that follows, {:.3g} m, {}", error->error.value, error->error.rule));
  }
  const glm::dvec3 color = end_at(lux).size * target.color;
  if (std::isfinite(color.r + color.g + color.b)) return;
  throw spec.error_at(range.end_illuminance ? "range.end_lx" : "range.threshold", "",
                      fmt::format("the color that follows, times {:.3g}, must be finite", end_at(lux).size));
}

/// The extent of a range that states where the light ends by its illuminance.
void derive_extent(const LightSpec& spec, LightTarget& target) {
  const RangeSpec& range = *spec.range;
  target.flux = range.flux;
  target.illuminance = range.illuminance;
  const auto peak = stated_peak(range, target);
  if (!peak && !range.end_illuminance) return;
  if (!peak && !target.peak) {
    throw spec.error_at("range.peak_cd", "",
                        "must be given, or illuminance, flux_lm or the cone's photometry, for end_lx");
  }
  if (peak && target.luminaire) scale_to_peak(spec, target, *peak);
  if (peak) target.peak = peak;
  set_light_peak(target);
  const double lux = range.end_illuminance.value_or(kEndIlluminance);
  expect_end(spec, target, lux);
  set_end(target, lux);
}

void set_range(const LightSpec& spec, LightTarget& light) {
  const RangeSpec& range = *spec.range;
  AttenuationTarget& target = light.range.emplace(
      AttenuationTarget{.threshold = range.threshold, .extent = range.extent, .constant = range.constant});
  for (const auto& sample : range.samples) {
    target.samples.push_back({.range = sample.range, .attenuation = sample.attenuation, .weight = sample.weight});
  }
  target.family = family_of(range.family);
  if (const auto error = find_error(AttenuationTarget{.threshold = range.threshold, .extent = 1})) {
    throw error_at(spec, "range", *error);
  }
  derive_extent(spec, light);
  if (!target.extent && target.samples.empty()) {
    throw spec.error_at("range.extent", "", "must be given, or peak_cd, illuminance, flux_lm or samples");
  }
  if (const auto error = find_error(target)) throw error_at(spec, "range", *error);
}

Luminaire read_luminaire_of(const LightSpec& spec) {
  try {
    return read_luminaire(*spec.cone->photometry);
  } catch (const InputError& error) {
    if (error.location().line > 0) throw;
    throw spec.error_at("cone.photometry", "", std::string("must be a photometric file: ") + error.what());
  }
}

/// The full angle of the circle that stands for an angle pair in a round cone.
std::optional<double> round_angle(const std::optional<FullAngles>& angles) {
  if (!angles) return std::nullopt;
  if (angles->is_round()) return angles->horizontal;
  return 2 * equal_circle(angles->horizontal / 2, angles->vertical / 2);
}

/// The ellipses of a cone of which at least one angle is a pair.
void set_ellipses(const LightSpec& spec, LightTarget& target) {
  struct Member {
    const char* name;
    const char* what;
    double level;
    const std::optional<FullAngles>& angles;
  };
  const ConeSpec& cone = *spec.cone;
  const std::array members{Member{"beam_angle", "Beam angle", 0.5, cone.beam_angle},
                           Member{"field_angle", "Field angle", 0.1, cone.field_angle}};
  if (std::ranges::all_of(members, [](const Member& m) { return !m.angles || m.angles->is_round(); })) return;
  FullAngles inner(0);
  for (const auto& [name, what, level, angles] : members) {
    if (!angles) continue;
    for (const auto& [index, angle, least] :
         {std::tuple(0, angles->horizontal, inner.horizontal), std::tuple(1, angles->vertical, inner.vertical)}) {
      if (angle > least && is_within(angle, 0, 2 * std::numbers::pi)) continue;
      const std::string field = fmt::format("cone.{}{}", name, angles->is_round() ? "" : fmt::format("[{}]", index));
      throw spec.error_at(field, "",
                          least == 0 ? "must be in (0, 2 pi]" : "must be above the beam angle, at most 2 pi");
    }
    target.ellipses.push_back({level, *angles});
    inner = *angles;
    if (angles->is_round()) continue;
    target.derived.push_back(fmt::format(
        "{}: {} x {} deg is {} deg round, by its solid angle.", what, files::shown_degrees(angles->horizontal),
        files::shown_degrees(angles->vertical), files::shown_degrees(*round_angle(angles))));
  }
}

ConeTarget cone_of(const LightSpec& spec) {
  const ConeSpec& cone = *spec.cone;
  ConeTarget target{.profile = cone.profile,
                    .half_angle = cone.half_angle,
                    .beam_angle = round_angle(cone.beam_angle),
                    .field_angle = round_angle(cone.field_angle)};
  for (const auto& sample : cone.samples) {
    target.samples.push_back({.angle = sample.angle, .intensity = sample.intensity, .weight = sample.weight});
  }
  return target;
}

void expect_fittable(const LightSpec& spec, const ConeTarget& target) {
  if (!target.beam_angle && !target.field_angle && target.samples.empty()) {
    throw spec.error_at("cone.beam_angle", "", "must be given, or field_angle_deg, samples or photometry");
  }
  const auto error = find_error(target);
  if (!error) return;
  if (error->sample && spec.cone->photometry) throw spec.error_at("cone.photometry", "", to_string(*error));
  throw error_at(spec, "cone", *error);
}

}  // namespace

LightTarget read_spec(const std::string& path, const FitChoices& choices) {
  const LightSpec spec = read_light_spec(path);
  LightTarget target{.file = spec.file,
                     .name = spec.name,
                     .source = spec.source,
                     .color = spec.color,
                     .density_scale = spec.density_scale,
                     .source_radius = spec.source_radius,
                     .source_radius_location = spec.error_at("source_radius_m", "", "").location(),
                     .flash = spec.flash,
                     .cookie_size = choices.cookie_size};
  if (spec.color_temperature) {
    target.derived.push_back(fmt::format("Color: {} K is {:.4g} {:.4g} {:.4g}, linear sRGB of luminance 1.",
                                         shown_number(*spec.color_temperature), spec.color.r, spec.color.g,
                                         spec.color.b));
  }
  if (spec.cone && spec.cone->photometry) set_luminaire(target, read_luminaire_of(spec), choices.tilt);
  if (spec.cone) {
    set_ellipses(spec, target);
    target.cone = cone_of(spec);
    if (target.luminaire) {
      set_beam(target, choices.axis);
      target.derived.push_back(sentence_on_cone(target));
    }
    if (choices.profile) target.cone->profile = *choices.profile;
    expect_fittable(spec, *target.cone);
  }
  if (spec.range) set_range(spec, target);
  if (target.range) target.range->is_robust = choices.is_robust;
  if (target.luminaire && !target.range) set_range_of_luminaire(target);
  return target;
}

LightTarget read_photometric_spec(const std::string& path, const FitChoices& choices) {
  return target_of(read_luminaire(path), path, choices);
}

LightTarget target_of(Luminaire stated, const std::string& path, const FitChoices& choices) {
  LightTarget target{
      .file = path, .name = std::filesystem::path(path).stem().string(), .cookie_size = choices.cookie_size};
  set_luminaire(target, std::move(stated), choices.tilt);
  const Luminaire& luminaire = *target.luminaire;
  target.cone = ConeTarget{.profile = choices.profile.value_or(std::nullopt)};
  set_beam(target, choices.axis);
  const std::string file = std::filesystem::path(path).filename().string();
  if (!luminaire.name.empty()) target.name = luminaire.name;
  target.source = {luminaire.manufacturer.empty() ? file : fmt::format("{}: {}", file, luminaire.manufacturer)};
  target.derived.push_back(sentence_on_cone(target));
  if (const auto error = find_error(*target.cone)) throw InputError({.file = path}, to_string(*error));
  set_range_of_luminaire(target);
  return target;
}

LightTarget part_of(const LightTarget& whole, const std::string& what, ConeTarget cone) {
  LightTarget part = whole;
  part.name += ", " + what;
  part.derived = {sentence_on_cone(whole), fmt::format("Light: the {} of this beam, one of two lights.", what)};
  part.peak = part.light_peak = peak_of(cone.samples);
  part.cone = std::move(cone);
  part.luminaire.reset();
  part.flux.reset();
  part.illuminance.clear();
  set_end(part, *whole.end_illuminance);
  return part;
}

bool hangs(const Luminaire& luminaire) {
  return luminaire.distribution.type == PhotometryType::c && !luminaire.is_isocandela;
}

std::string describe_axis(const Luminaire& luminaire, const glm::dvec3& axis) {
  if (axis == kPhotometricAxis) return fmt::format("{}, the photometric axis", hangs(luminaire) ? "down" : "ahead");
  if (axis == -kPhotometricAxis) {
    return fmt::format("{}, opposite to the photometric axis", hangs(luminaire) ? "up" : "behind");
  }
  const double angle = std::acos(std::clamp(glm::dot(axis, kPhotometricAxis), -1.0, 1.0));
  const auto [horizontal, vertical] = angles_of(angle_type_of(luminaire), axis);
  return fmt::format("{:.4g} deg from the photometric axis, --axis {:.4g},{:.4g}", files::degrees(angle),
                     files::degrees(horizontal), files::degrees(vertical));
}

}  // namespace litfog::fit
