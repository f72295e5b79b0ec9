// SPDX-License-Identifier: Apache-2.0
#include "drawing/display_options.h"

#include <fmt/format.h>

#include <cmath>

#include "command/command.h"
#include "command/number.h"
#include "render/plan/view.h"

namespace litfog::drawing {
namespace {

render::Exposure parse_exposure(const std::string& text) {
  if (text == "auto") return {.is_auto = true};
  const auto ev = command::parse_number(text);
  if (!ev || !(std::abs(*ev) <= render::kMaxExposure)) {
    command::fail_option("--exposure", text,
                         fmt::format("must be auto or a number in [-{0}, {0}]", render::kMaxExposure));
  }
  return {.ev = *ev};
}

}  // namespace

Glare DisplayOptions::glare_of(render::FogLighting fog_lighting) const {
  return glare.value_or(fog_lighting == render::FogLighting::airlight ? Glare::eye : Glare::none);
}

render::ToneCurve DisplayOptions::tone_of(const scene::Scene& scene) const {
  return tone.value_or(scene.display.is_clipped ? render::ToneCurve::clip : render::ToneCurve::neutral);
}

Display DisplayOptions::display_for(const scene::Scene& scene, render::FogLighting fog_lighting) const {
  const render::Exposure stated{.ev = scene.display.exposure.value_or(0), .is_auto = !scene.display.exposure};
  return {.exposure = exposure.value_or(stated), .tone = tone_of(scene), .glare = glare_of(fog_lighting)};
}

void add_display(CLI::App& app, DisplayOptions& options) {
  app.option_defaults()->group("Display");
  app.add_option_function<std::string>(
         "--exposure", [&options](const std::string& text) { options.exposure = parse_exposure(text); },
         "EV by which a .png is brighter than the scene's light; auto chooses it from the picture (default the "
         "scene's; auto for glTF files)")
      ->type_name("EV|auto");
  command::add_choice(
      app, "--tone", options.tone, kTones,
      "How a .png shows light beyond its white: neutral keeps the hue (Khronos PBR Neutral), clip cuts each channel "
      "(default the scene's, else neutral)");
  command::add_choice(app, "--glare", options.glare, kGlares,
                      "Whether a .png has the glare of the eye's optics (Spencer et al. 1995), so that brighter lamps "
                      "look larger (default eye with airlight, none with peak)");
}

std::string display_in_words(const Display& display) {
  std::string words;
  const render::Exposure& exposure = display.exposure;
  if (exposure.is_auto || exposure.ev != 0)
    words = fmt::format("EV {}{}", exposure.ev, exposure.is_auto ? " (auto)" : "");
  if (display.tone != render::ToneCurve::neutral) {
    words += fmt::format("{}tone {}", words.empty() ? "" : ", ", command::word_of(kTones, display.tone));
  }
  return words;
}

render::Picture displayed(const render::Picture& picture, const scene::Camera& camera, const Display& display) {
  const render::Display shown{.exposure = display.exposure, .tone = display.tone};
  if (display.glare == Glare::none) return render::displayed(picture, shown);
  return render::displayed(with_glare(picture, render::pixels_per_radian(camera, picture.height)), shown);
}

}  // namespace litfog::drawing
