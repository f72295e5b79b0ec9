// SPDX-License-Identifier: Apache-2.0
#include "drawing/display_options.h"

#include <fmt/format.h>

#include <cmath>

#include "command/command.h"
#include "command/number.h"

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

render::Display DisplayOptions::display_for(const scene::Scene& scene) const {
  const render::Exposure stated{.ev = scene.display.exposure.value_or(0), .is_auto = !scene.display.exposure};
  return {.exposure = exposure.value_or(stated), .tone = tone};
}

void add_display(CLI::App& app, DisplayOptions& options) {
  app.add_option_function<std::string>(
         "--exposure", [&options](const std::string& text) { options.exposure = parse_exposure(text); },
         "EV by which a .png is brighter than the scene's light; auto chooses it from the picture (default the "
         "scene's; auto for glTF files)")
      ->type_name("EV|auto");
  command::add_choice<render::ToneCurve>(
      app, "--tone", options.tone, {{"neutral", render::ToneCurve::neutral}, {"clip", render::ToneCurve::clip}},
      "How a .png shows light beyond its white: neutral keeps the hue (Khronos PBR Neutral), clip cuts each channel "
      "(default neutral)");
}

const char* tone_name(render::ToneCurve tone) { return tone == render::ToneCurve::neutral ? "neutral" : "clip"; }

std::string display_in_words(const render::Display& display) {
  std::string words;
  const render::Exposure& exposure = display.exposure;
  if (exposure.is_auto || exposure.ev != 0)
    words = fmt::format("EV {}{}", exposure.ev, exposure.is_auto ? " (auto)" : "");
  if (display.tone != render::ToneCurve::neutral) {
    words += fmt::format("{}tone {}", words.empty() ? "" : ", ", tone_name(display.tone));
  }
  return words;
}

}  // namespace litfog::drawing
