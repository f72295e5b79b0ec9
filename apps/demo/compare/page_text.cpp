// SPDX-License-Identifier: Apache-2.0
#include "demo/compare/page_text.h"

#include <algorithm>

#include "drawing/heat_map.h"
#include "scene/texels.h"

namespace litfog::demo {

std::string_view page_text(std::string_view name) {
  const auto texts = page_texts();
  const std::string_view text = std::ranges::find(texts, name, &PageText::name)->text;
  return text.substr(text.find('\n') + 1);
}

std::string error_text(double error) { return fmt::format("{:.3g}", error); }

std::string heat_gradient() {
  constexpr int kSteps = 24;
  std::string stops;
  for (int i = 0; i <= kSteps; ++i) {
    const glm::vec3 color = drawing::heat_color(double(i) / kSteps);
    stops += fmt::format(", #{:02x}{:02x}{:02x}", scene::srgb_level_of(color.r), scene::srgb_level_of(color.g),
                         scene::srgb_level_of(color.b));
  }
  return "linear-gradient(to right" + stops + ")";
}

}  // namespace litfog::demo
