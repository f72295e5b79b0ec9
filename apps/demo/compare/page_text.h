// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>

namespace litfog::demo {

/// A file of apps/demo/compare/page, embedded in the program. In an .html file {name} is a field (fmt::format).
struct PageText {
  std::string_view name;
  std::string_view text;
};

std::span<const PageText> page_texts();

/// The text of a file of apps/demo/compare/page without its first line, the licence.
std::string_view page_text(std::string_view name);

/// page_text() with its {fields} filled in.
template <typename... Arguments>
std::string filled(std::string_view name, const Arguments&... arguments) {
  return fmt::format(fmt::runtime(page_text(name)), arguments...);
}

/// Formats an error or a difference of pictures, in 1/255.
std::string error_text(double error);

/// The heat map's colours as a gradient of CSS.
std::string heat_gradient();

}  // namespace litfog::demo
