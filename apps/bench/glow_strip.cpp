// SPDX-License-Identifier: Apache-2.0
#include "bench/benchmarks.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "command/progress.h"
#include "drawing/contact_sheet.h"
#include "drawing/lettering.h"
#include "drawing/picture_file.h"
#include "litfog/airlight.h"
#include "litfog/multiple_scattering.h"
#include "measure/inverse_square_lamp.h"
#include "measure/radial_scattering.h"
#include "render/display.h"

namespace litfog::bench {
namespace {

constexpr double kRange = 100;                                                // metres
constexpr std::array kVisibilities{1000.0, 300.0, 150.0, 100.0, 60.0, 30.0};  // metres
constexpr std::array kRows{"scattered once", "all orders, litfog", "all orders, reference"};
constexpr double kHalfView = std::numbers::pi / 6;  // to a picture's left or right edge
constexpr double kLampPixels = 2;                   // radius of the disc

/// A picture that is symmetric about its centre.
///
/// light_at  light by the angle from the centre, radians
render::Picture draw_around(int width, int height, const std::function<double(double)>& light_at) {
  const double focal = width / 2. / std::tan(kHalfView);
  std::vector<double> profile;  // by half pixels from the centre
  for (int i = 0; i <= width + height; ++i) profile.push_back(light_at(std::atan((i + 0.5) / 2 / focal)));
  render::Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double place = 2 * std::hypot(x + 0.5 - width / 2., y + 0.5 - height / 2.) - 0.5;
      const auto i = std::size_t(place);
      picture.rgb.insert(picture.rgb.end(), 3, float(std::lerp(profile[i], profile[i + 1], place - double(i))));
    }
  }
  return picture;
}

}  // namespace

std::string draw_glow_strip(bool quick) {
  const int width = quick ? 40 : 200, height = width * 3 / 4, margin = 4, line = 20, letters = 15;
  const glm::vec3 ink(0.75f);
  command::Progress progress;
  progress.show("the strip's reference");
  Atmosphere air{.fog = {FogMode::exp, 1}, .phase = Phase::droplets(10)};
  const measure::RadialScattering solver(quick ? 0.6 : 1);
  const auto reference = solver.solve(air.phase);
  const ScatteringTable table = make_scattering_table(air);

  render::Picture sheet{
      int(kVisibilities.size()) * (width + margin) + margin, line + int(kRows.size()) * (height + margin) + margin, {}};
  sheet.rgb.resize(std::size_t(sheet.width) * std::size_t(sheet.height) * 3);
  for (std::size_t column = 0; column < kVisibilities.size(); ++column) {
    progress.show(fmt::format("the strip at a visibility of {} m", kVisibilities[column]));
    air.fog = Fog::from_visibility(FogMode::exp, kVisibilities[column]);
    const PlacedLight lamp = lamp_ahead(kRange);
    const ScatteringSource source = scattering_source(lamp.light, air);
    const double depth = air.fog.density * kRange;
    const double disc = std::atan(kLampPixels * std::tan(kHalfView) / (width / 2.));
    // The direct light, spread over the disc.
    const double direct = 4 * std::exp(-depth) / (kRange * kRange * disc * disc);
    const auto draw = [&](const auto& higher) {
      return draw_around(width, height, [&](double angle) {
        const EyeRay ray = ray_beside(angle);
        return kQuadratic * airlight(lamp, air, ray) + higher(ray, angle) + (angle < disc ? direct : 0);
      });
    };
    const std::array pictures{draw([](const EyeRay&, double) { return 0.0; }), draw([&](const EyeRay& ray, double) {
                                return kQuadratic * multiple_scattering(lamp, source, air, table, ray);
                              }),
                              draw([&](const EyeRay&, double angle) {
                                return air.fog.density * air.fog.density * reference.at(depth, angle);
                              })};
    const int left = margin + int(column) * (width + margin);
    const render::Exposure exposure{.ev = render::auto_exposure(pictures.back())};
    for (std::size_t row = 0; row < pictures.size(); ++row) {
      drawing::paste(sheet, left, line + int(row) * (height + margin),
                     render::displayed(pictures[row], {.exposure = exposure}));
    }
    drawing::draw_text(sheet, left, line - 5,
                       drawing::fitted_text(fmt::format("{} m", kVisibilities[column]), letters, width), letters, ink);
  }
  for (std::size_t row = 0; row < kRows.size(); ++row) {
    const int baseline = line + int(row + 1) * (height + margin) - margin - 5;
    drawing::draw_text(sheet, 2 * margin, baseline, drawing::fitted_text(kRows[row], letters, width - margin), letters,
                       ink);
  }
  return drawing::png_text(sheet);
}

}  // namespace litfog::bench
