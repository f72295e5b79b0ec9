// SPDX-License-Identifier: Apache-2.0
// litfog_fog_intensity_generator FILE: writes tests/data/fog_intensity.json, lights in fog with their extent, peak
// range and intensity to 60 digits.
//
// The figures come from the definitions alone: plain formulas, bisection on the sign of the derivative, and enough
// digits that cancellation does not matter. Nothing of litfog's solver or of the tests' other reference is used.

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <ios>
#include <stdexcept>
#include <string>

#include "reference/double_limits.h"
#include "reference/random_light.h"

namespace litfog::test {
namespace {

/// 60 digits, 120 more that cancel where an optical depth is 1e-120, and some to spare.
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200>, boost::multiprecision::et_off>;

struct Solution {
  Real extent;
  Real peak_range;
  Real intensity;
};

class Problem {
 public:
  explicit Problem(const SolveCase& c)
      : constant_(c.attenuation.constant),
        linear_(c.attenuation.linear),
        quadratic_(c.attenuation.quadratic),
        density_(c.fog.density),
        threshold_(c.threshold),
        mode_(c.fog.mode) {}

  Solution solve() const {
    const Real extent = range_of_denominator(1 / threshold_);
    if (extent == 0) return {0, 0, 0};
    const Real peak = find_peak(range_of_denominator(1), extent);
    return {extent, peak, opacity(peak) / std::max(denominator(peak), Real(1))};
  }

 private:
  Real denominator(const Real& r) const { return constant_ + linear_ * r + quadratic_ * r * r; }

  Real depth(const Real& r) const { return mode_ == FogMode::exp ? density_ * r : density_ * r * density_ * r; }

  Real opacity(const Real& r) const { return depth(r) > 1000 ? Real(1) : Real(1 - exp(-depth(r))); }

  /// The root of C + L r + Q r^2 = value; 0 where it starts there or beyond.
  Real range_of_denominator(const Real& value) const {
    const Real excess = value - constant_;
    if (excess <= 0) return 0;
    return 2 * excess / (linear_ + sqrt(linear_ * linear_ + 4 * quadratic_ * excess));
  }

  /// Whether the derivative of opacity / denominator is positive: opacity' D > opacity D', times e^depth.
  bool is_rising(const Real& r) const {
    const Real x = depth(r);
    if (x > 1000) return false;  // e^1000 outgrows the coefficients that are drawn below
    const Real depth_slope = mode_ == FogMode::exp ? density_ : Real(2 * density_ * density_ * r);
    return depth_slope * denominator(r) > (exp(x) - 1) * (linear_ + 2 * quadratic_ * r);
  }

  Real find_peak(const Real& knee, const Real& extent) const {
    if (is_rising(extent)) return extent;
    if (knee > 0 && !is_rising(knee)) return knee;
    Real low = knee > 0 ? knee : Real(extent * Real("1e-100"));
    Real high = extent;
    if (!is_rising(low)) throw std::logic_error("no bracket");
    while (high - low > low * Real("1e-70")) {
      const Real middle = high > 2 * low ? Real(sqrt(low * high)) : Real((low + high) / 2);
      (is_rising(middle) ? low : high) = middle;
    }
    return low;
  }

  Real constant_, linear_, quadratic_, density_, threshold_;
  FogMode mode_;
};

/// To nine digits, so that logarithms and powers of another C library draw the same.
double rounded(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.8e", x);
  return std::strtod(text, nullptr);
}

double draw(Random& random, double low, double high) { return rounded(random.log_uniform(low, high)); }

double draw_density(Random& random) { return draw(random, 1e-6, 10); }

double draw_threshold(Random& random) {
  return random.chance(0.5) ? random.pick(std::array{0.05, 0.01, 1 / 255., 0.3, 0.001}) : draw(random, 1e-4, 0.99);
}

SolveCase draw_case(const std::string& tag, Random& random, FogMode mode) {
  SolveCase c{{1, draw(random, 1e-6, 1), draw(random, 1e-9, 1)}, {mode, draw_density(random)}, draw_threshold(random)};
  auto& [constant, linear, quadratic] = c.attenuation;
  if (tag == "wide") {
    c.attenuation = {draw(random, 1e-3, 1e3), draw(random, 1e-9, 1e3), draw(random, 1e-12, 1e3)};
  } else if (tag == "clamped") {
    constant = random.chance(0.3) ? 1 - draw(random, 1e-16, 0.1) : rounded(random.uniform(0, 1));
  } else if (tag == "linear") {
    c.attenuation = {random.chance(0.2) ? 1 : draw(random, 1e-6, 10), draw(random, 1e-9, 1e3), 0};
  } else if (tag == "quadratic") {
    c.attenuation = {random.chance(0.2) ? 1 : draw(random, 1e-6, 10), 0, draw(random, 1e-12, 1e3)};
  } else if (tag == "no constant") {
    constant = 0;
    if (random.chance(0.3)) linear = 0;
  } else if (tag == "barely lit") {  // C next to 1/t
    constant = random.chance(0.5) ? std::nextafter(1 / c.threshold, 0.0)
                                  : rounded((1 - random.log_uniform(1e-8, 1e-3)) / c.threshold);
  } else if (tag == "thin fog") {
    c.fog.density = draw(random, 1e-20, 1e-6);
  } else if (tag == "thick fog") {
    c.fog.density = draw(random, 10, 1e10);
  } else if (tag == "extreme") {
    c = {{random.pick(std::array{0., 1e-8, 1., 3.}), draw(random, 1e-30, 1e12), draw(random, 1e-60, 1e20)},
         {mode, draw(random, 1e-30, 1e15)},
         draw(random, 1e-12, 0.9)};
  }
  return c;
}

std::string shortest(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

std::string sixty_digits(const Real& x) { return x.str(60, std::ios_base::scientific); }

void write_cases(std::ostream& out) {
  Random random(60);
  const char* separator = "[\n";
  for (const char* const tag : {"ordinary", "wide", "clamped", "linear", "quadratic", "no constant", "barely lit",
                                "thin fog", "thick fog", "extreme"}) {
    for (const FogMode mode : kModes) {
      for (int i = 0; i < 20; ++i) {
        const SolveCase c = draw_case(tag, random, mode);
        const Solution solution = Problem(c).solve();
        out << separator << R"({"tag": ")" << tag << R"(", "mode": ")" << name_of(mode) << R"(", "density": )"
            << shortest(c.fog.density) << R"(, "C": )" << shortest(c.attenuation.constant) << R"(, "L": )"
            << shortest(c.attenuation.linear) << R"(, "Q": )" << shortest(c.attenuation.quadratic)
            << R"(, "threshold": )" << shortest(c.threshold) << R"(, "extent": ")" << sixty_digits(solution.extent)
            << R"(", "peak_range": ")" << sixty_digits(solution.peak_range) << R"(", "intensity": ")"
            << sixty_digits(solution.intensity) << "\"}";
        separator = ",\n";
      }
    }
  }
  out << "\n]\n";
}

}  // namespace
}  // namespace litfog::test

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: litfog_fog_intensity_generator FILE\n");
    return 1;
  }
  std::ofstream out(argv[1]);
  litfog::test::write_cases(out);
  out.close();
  if (out) return 0;
  std::fprintf(stderr, "%s: cannot be written\n", argv[1]);
  return 4;
}
