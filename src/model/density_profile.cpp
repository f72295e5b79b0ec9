// SPDX-License-Identifier: Apache-2.0
#include "litfog/density_profile.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/density_profile_text.h"
#include "model/require.h"

namespace litfog {
namespace {

constexpr const char* kHeightRule = "must be at most 16777216 in magnitude";
constexpr const char* kBandRule = "must be at most 16777216 in magnitude with its transition band";

struct KnotNames {
  const char* height;
  const char* density;
};
#define LITFOG_KNOT_NAMES(i) \
  { "profile.knots[" #i "].height", "profile.knots[" #i "].density" }
constexpr std::array<KnotNames, kMaxDensityKnots> kKnotNames{
    {LITFOG_KNOT_NAMES(0), LITFOG_KNOT_NAMES(1), LITFOG_KNOT_NAMES(2), LITFOG_KNOT_NAMES(3), LITFOG_KNOT_NAMES(4),
     LITFOG_KNOT_NAMES(5), LITFOG_KNOT_NAMES(6), LITFOG_KNOT_NAMES(7)}};
#undef LITFOG_KNOT_NAMES

/// The height of a layer's transition bands.
double band_of(const FogLayer& layer) { return std::max(layer.transition, kSharpestTransition); }

/// A layer's ramps: the density is 0 up to `first`, full from `base` to `top`, 0 from `last` on.
struct LayerRamps {
  double first, base, top, last;
  double density;

  LayerRamps(const FogLayer& layer, double contrast)
      : base(layer.base),
        top(layer.top),
        density(Fog::from_visibility(FogMode::exp, layer.visibility, contrast).density) {
    first = base - band_of(layer);
    last = top + band_of(layer);
  }

  double density_at(double height) const {
    if (height <= first || height >= last) return 0;
    if (height < base) return density * ((height - first) / (base - first));
    if (height > top) return density * ((last - height) / (last - top));
    return density;
  }
};

[[noreturn]] void fail_knot_count(std::size_t count) { fail_count("profile.count", count, "must be at most 8"); }

template <typename Choose>
double extreme_density(const DensityProfile& profile, double lowest, double highest, const Choose& choose) {
  double extreme = choose(profile_density_at(profile, lowest), profile_density_at(profile, highest));
  for (const DensityKnot& knot : profile.used()) {
    if (lowest < knot.height && knot.height < highest) extreme = choose(extreme, knot.density);
  }
  return extreme;
}

}  // namespace

DensityProfile make_density_profile(std::span<const DensityKnot> knots) {
  if (knots.size() > kMaxDensityKnots) fail_knot_count(knots.size());
  DensityProfile profile{.count = knots.size()};
  std::copy(knots.begin(), knots.end(), profile.knots.begin());
  require(find_error(profile));
  return profile;
}

std::optional<ValueError> find_error(const DensityProfile& profile) {
  if (profile.count > kMaxDensityKnots) return ValueError{"profile.count", double(profile.count), "must be at most 8"};
  for (std::size_t i = 0; i < profile.count; ++i) {
    const auto [height, density] = profile.knots[i];
    if (!is_within(height, -kMaxPosition, kMaxPosition)) return ValueError{kKnotNames[i].height, height, kHeightRule};
    if (i > 0 && !(height > profile.knots[i - 1].height)) {
      return ValueError{kKnotNames[i].height, height, "must be above the knot before"};
    }
    // Sums of as many densities stay within the range of doubles.
    if (!is_within(density, 0, 1e300)) return ValueError{kKnotNames[i].density, density, "must be in [0, 1e300]"};
  }
  return std::nullopt;
}

std::optional<ValueError> find_error(const FogLayer& layer) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (layer.base != -kInfinity && !is_within(layer.base, -kMaxPosition, kMaxPosition)) {
    return ValueError{"base", layer.base, kHeightRule};
  }
  if (layer.top != kInfinity && !is_within(layer.top, -kMaxPosition, kMaxPosition)) {
    return ValueError{"top", layer.top, kHeightRule};
  }
  if (!(layer.top > layer.base)) return ValueError{"top", layer.top, "must be above the base"};
  if (!is_finite_and_not_negative(layer.transition)) {
    return ValueError{"transition", layer.transition, "must be finite and >= 0"};
  }
  if (layer.base != -kInfinity && !(layer.base - band_of(layer) >= -kMaxPosition)) {
    return ValueError{"base", layer.base, kBandRule};
  }
  if (layer.top != kInfinity && !(layer.top + band_of(layer) <= kMaxPosition)) {
    return ValueError{"top", layer.top, kBandRule};
  }
  if (!(layer.visibility > 0)) return ValueError{"visibility", layer.visibility, "must be > 0"};
  if (layer.visibility < kLeastLayerVisibility) {
    return ValueError{"visibility", layer.visibility, "must be >= 1e-290"};
  }
  return std::nullopt;
}

DensityProfile make_density_profile(std::span<const FogLayer> layers, double contrast) {
  Fog::from_visibility(FogMode::exp, 1, contrast);  // refuses a contrast even where there are no layers
  std::vector<LayerRamps> ramps;
  std::vector<double> heights;
  for (const FogLayer& layer : layers) {
    require(find_error(layer));
    const LayerRamps& added = ramps.emplace_back(layer, contrast);
    if (added.density == 0) {
      ramps.pop_back();
      continue;
    }
    for (const double height : {added.first, added.base, added.top, added.last}) {
      if (std::isfinite(height)) heights.push_back(height);
    }
  }
  if (!ramps.empty() && heights.empty()) heights.push_back(0);  // no layer has a base or a top
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  std::vector<DensityKnot> knots;
  for (const double height : heights) {
    double density = 0;
    for (const LayerRamps& layer : ramps) density += layer.density_at(height);
    knots.push_back({height, density});
  }
  return make_density_profile(knots);
}

double profile_density_at(const DensityProfile& profile, double height) {
  return DensityProfileText<double>{profile}.litfog_profile_density(height);
}

double mean_density(const DensityProfile& profile, double height_a, double height_b) {
  return DensityProfileText<double>{profile}.litfog_mean_density(height_a, height_b);
}

double optical_depth(const DensityProfile& profile, double height_a, double height_b, double length) {
  return mean_density(profile, height_a, height_b) * length;
}

double optical_depth_to_sky(const DensityProfile& profile, double height, double slope) {
  return DensityProfileText<double>{profile}.litfog_profile_depth_to_sky(height, slope,
                                                                         std::numeric_limits<double>::infinity());
}

double largest_density(const DensityProfile& profile, double lowest, double highest) {
  return extreme_density(profile, lowest, highest, [](double a, double b) { return std::max(a, b); });
}

double smallest_density(const DensityProfile& profile, double lowest, double highest) {
  return extreme_density(profile, lowest, highest, [](double a, double b) { return std::min(a, b); });
}

double least_mean_density(const DensityProfile& profile, double height, double lowest, double highest) {
  double least = std::numeric_limits<double>::infinity();
  // Places between which the density is straight, on both sides of the height and away from it.
  std::array<double, kMaxDensityKnots + 3> places;
  std::size_t count = 0;
  const auto add_place = [&](double place) {
    if (count == 0 || place > places[count - 1]) places[count++] = place;
  };
  add_place(lowest);
  bool has_height = false;
  for (const DensityKnot& knot : profile.used()) {
    if (!has_height && knot.height >= height) {
      add_place(std::min(height, highest));
      has_height = true;
    }
    add_place(std::min(knot.height, highest));
  }
  if (!has_height) add_place(std::min(height, highest));
  add_place(highest);
  const auto mean_to = [&](double place) {
    const double mean =
        std::isfinite(place) ? mean_density(profile, height, place) : profile_density_at(profile, place);
    least = std::min(least, mean);
    return mean;
  };
  const auto between = [&](double near, double far) {
    const double density = profile_density_at(profile, near);
    const double excess = mean_to(near) - density;
    const double rise = (profile_density_at(profile, far) - density) / std::abs(far - near);
    if (!(excess > 0 && rise > 0)) return;
    // Where the density has risen to the mean, which falls up to there.
    const double from = std::abs(near - height);
    const double step = 2 * from * excess / rise / (from + std::sqrt(from * (from + 2 * excess / rise)));
    if (step < std::abs(far - near)) mean_to(near + std::copysign(step, far - near));
  };
  for (std::size_t i = 0; i + 1 < count; ++i) {
    places[i] >= height ? between(places[i], places[i + 1]) : between(places[i + 1], places[i]);
  }
  mean_to(lowest);
  mean_to(highest);
  return least;
}

DensityProfile scaled(const DensityProfile& profile, double density_scale) {
  DensityProfile result = profile;
  for (DensityKnot& knot : result.knots) knot.density *= density_scale;
  return result;
}

DensityProfileF to_floats(const DensityProfile& profile) {
  DensityProfileF result{.count = profile.count};
  for (std::size_t i = 0; i < profile.count; ++i) {
    const auto [height, density] = profile.knots[i];
    result.knots[i] = {float(height), float(std::min(density, double(kMaxKnotDensity)))};
  }
  return result;
}

}  // namespace litfog
