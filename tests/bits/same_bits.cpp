// SPDX-License-Identifier: Apache-2.0
// litfog_same_bits [COUNT]  hashes COUNT results of the solver, the batch and the airlight each, and COUNT / 1000 fits
//
// A line names a part and a SIMD target of this processor, and has hashes of the inputs and of the results. Ends with 1
// where four threads have other results than one, or where targets differ in what is no batch: batches begin with the
// processor's approximate reciprocals. ./run bits compares compilers and their optimisations.

#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "fit/random_target.h"
#include "litfog/airlight.h"
#include "litfog/batch.h"
#include "litfog/directional_airlight.h"
#include "litfog/intensity_bound.h"
#include "litfog/solve.h"
#include "model/parallel.h"
#include "reference/random_airlight.h"

namespace litfog::test {
namespace {

/// FNV-1a, 64 bits, over numbers by their bits.
class Hash {
 public:
  template <typename... Numbers>
  void add(Numbers... numbers) {
    (add_bits(numbers), ...);
  }
  std::uint64_t bits() const { return bits_; }

 private:
  void add_bits(double number) { add_bits(std::bit_cast<std::uint64_t>(number)); }
  void add_bits(float number) { add_bits(std::uint64_t{std::bit_cast<std::uint32_t>(number)}); }
  void add_bits(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) bits_ = (bits_ ^ (bits >> 8 * byte & 0xff)) * 0x100000001b3u;
  }

  std::uint64_t bits_ = 0xcbf29ce484222325;
};

struct Hashes {
  Hash inputs, results;

  void add(const Hashes& other) {
    inputs.add(other.inputs.bits());
    results.add(other.results.bits());
  }
  bool operator==(const Hashes& other) const {
    return inputs.bits() == other.inputs.bits() && results.bits() == other.results.bits();
  }
};

/// Adds count results to the hashes.
using Part = void (*)(Random& random, int count, Hashes& hashes);

template <FogMode mode>
void solve(Random& random, int count, Hashes& hashes) {
  for (; count > 0; --count) {
    const SolveCase c = draw_ordinary_case(random, mode);
    hashes.inputs.add(c.attenuation.constant, c.attenuation.linear, c.attenuation.quadratic, c.fog.density,
                      c.threshold);
    const FogIntensity solved = solve_fog_intensity(c.attenuation, c.fog, c.threshold);
    hashes.results.add(solved.intensity, solved.peak_range, solved.extent,
                       IntensityBound(c.attenuation, c.threshold).at(c.fog));
  }
}

template <FogMode mode, typename Real>
void solve_batch(Random& random, int count, Hashes& hashes) {
  std::array<std::vector<Real>, 5> in;
  std::array<std::vector<Real>, 3> out;
  for (int i = 0; i < count; ++i) {
    const SolveCase c = draw_ordinary_case(random, mode);
    const std::array numbers{c.attenuation.constant, c.attenuation.linear, c.attenuation.quadratic, c.threshold,
                             c.fog.density};
    for (std::size_t k = 0; k < in.size(); ++k) {
      in[k].push_back(Real(numbers[k]));
      hashes.inputs.add(in[k].back());
    }
  }
  for (auto& column : out) column.resize(std::size_t(count));
  solve_fog_intensities(mode, BasicBatchLights<Real>{in[0], in[1], in[2], in[3], in[4]},
                        BasicBatchSolutions<Real>{out[0], out[1], out[2]});
  for (const auto& column : out) {
    for (const Real value : column) hashes.results.add(value);
  }
}

void add(Hash& hash, const glm::dvec3& vector) { hash.add(vector.x, vector.y, vector.z); }

void scatter(Random& random, int count, Hashes& hashes) {
  for (; count > 0; --count) {
    const FogMode mode = random.pick(kModes);  // by itself: compilers differ in the order of arguments
    AirlightCase c = draw_spot_airlight_case(random, mode, random.pick(kLampLegs));
    if (random.chance(0.3)) c.light.light.cone = {};
    if (random.chance(0.5)) c.atmosphere.phase = draw_phase(random);
    if (random.chance(0.3) && c.atmosphere.fog.mode == FogMode::exp) draw_layers(random, c);
    const Light& light = c.light.light;
    const Phase& phase = c.atmosphere.phase;
    add(hashes.inputs, c.light.position);
    add(hashes.inputs, c.light.direction);
    add(hashes.inputs, c.ray.origin);
    add(hashes.inputs, c.ray.direction);
    hashes.inputs.add(light.attenuation.constant, light.attenuation.linear, light.attenuation.quadratic,
                      light.threshold, light.cone.half_angle, light.cone.exponent, light.cone.inner, light.cone.outer,
                      c.atmosphere.fog.density, c.ray.length, phase.first.asymmetry, phase.first.alpha,
                      phase.second.asymmetry, phase.second.alpha, phase.weight);
    for (std::size_t i = 0; i < c.atmosphere.profile.count; ++i) {
      hashes.inputs.add(c.atmosphere.profile.knots[i].height, c.atmosphere.profile.knots[i].density);
    }
    hashes.results.add(airlight(c.light, c.atmosphere, c.ray, c.lamp_leg),
                       bound_airlight(c.light, c.atmosphere, c.ray.origin, c.ray.direction, 1e-9, c.lamp_leg));
    if (c.atmosphere.fog.mode == FogMode::exp) {
      hashes.results.add(directional_airlight(c.atmosphere, c.light.direction, c.ray));
    }
  }
}

void fit_falloff(Random& random, int count, Hashes& hashes) {
  for (count = (count + 999) / 1000; count > 0;) {
    const AttenuationTarget target = draw_attenuation_target(random);
    if (find_error(target)) continue;
    --count;
    for (const AttenuationSample& sample : target.samples) {
      hashes.inputs.add(sample.range, sample.attenuation, sample.weight);
    }
    hashes.inputs.add(target.threshold, target.extent.value_or(0), target.constant.value_or(-1));
    const AttenuationFit fit = fit_attenuation(target);
    hashes.results.add(fit.attenuation.constant, fit.attenuation.linear, fit.attenuation.quadratic, fit.objective);
  }
}

void fit_beam(Random& random, int count, Hashes& hashes) {
  for (count = (count + 999) / 1000; count > 0;) {
    const ConeTarget target{.samples = draw_cone_samples(random)};
    if (find_error(target)) continue;
    --count;
    for (const ConeSample& sample : target.samples) hashes.inputs.add(sample.angle, sample.intensity, sample.weight);
    for (const ConeProfileFit& fit : fit_cone(target).profiles) {
      hashes.results.add(fit.cone.half_angle, fit.cone.exponent, fit.cone.inner, fit.cone.outer, fit.objective);
    }
  }
}

enum class Targets { one, alike, different };

struct NamedPart {
  const char* name;
  Part run;
  Targets targets;
};

constexpr NamedPart kParts[]{{"solve exp", solve<FogMode::exp>, Targets::alike},
                             {"solve exp2", solve<FogMode::exp2>, Targets::alike},
                             {"batch exp double", solve_batch<FogMode::exp, double>, Targets::different},
                             {"batch exp2 double", solve_batch<FogMode::exp2, double>, Targets::different},
                             {"batch exp float", solve_batch<FogMode::exp, float>, Targets::different},
                             {"batch exp2 float", solve_batch<FogMode::exp2, float>, Targets::different},
                             {"airlight", scatter, Targets::one},
                             {"fit range", fit_falloff, Targets::one},
                             {"fit beam", fit_beam, Targets::one}};

Hashes run(Part part, std::size_t count, std::size_t threads) {
  constexpr std::size_t kTogether = 1000;
  std::vector<Hashes> turns((count + kTogether - 1) / kTogether);
  for_each_in_parallel(
      turns.size(),
      [&](std::size_t i) {
        Random random(i);
        part(random, int(std::min(kTogether, count - i * kTogether)), turns[i]);
      },
      threads);
  Hashes all;
  for (const Hashes& turn : turns) all.add(turn);
  return all;
}

/// Returns whether the hashes of a part are as they must be.
bool check(const NamedPart& part, std::size_t count) {
  bool is_right = true;
  const auto expect_equal = [&](const Hashes& a, const Hashes& b, const char* who) {
    if (a == b) return;
    std::printf("%s: %s differ\n", part.name, who);
    is_right = false;
  };
  std::optional<Hashes> first;
  for (std::int64_t targets = hwy::SupportedTargets(); targets != 0; targets &= targets - 1) {
    hwy::SetSupportedTargetsForTest(targets);
    const Hashes hashes = run(part.run, count, 1);
    std::printf("%-17s %-8s inputs %016llx results %016llx\n", part.name,
                part.targets == Targets::one ? "-" : hwy::TargetName(targets & -targets),
                static_cast<unsigned long long>(hashes.inputs.bits()),
                static_cast<unsigned long long>(hashes.results.bits()));
    std::fflush(stdout);
    expect_equal(hashes, run(part.run, count, 4), "one thread and four");
    if (part.targets == Targets::alike) expect_equal(first.value_or(hashes), hashes, "SIMD targets");
    first = hashes;
    if (part.targets == Targets::one) break;
  }
  hwy::SetSupportedTargetsForTest(0);
  return is_right;
}

}  // namespace
}  // namespace litfog::test

int main(int arguments, char** argument) {
  const std::size_t count = arguments > 1 ? std::strtoull(argument[1], nullptr, 10) : 3000;
  bool is_right = true;
  for (const auto& part : litfog::test::kParts) is_right = litfog::test::check(part, count) && is_right;
  return is_right ? 0 : 1;
}
