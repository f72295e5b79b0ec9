// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace litfog::demo {

/// A file of apps/demo/page, embedded in the program. In an .html file {name} is a field (fmt::format).
struct PageText {
  std::string_view name;
  std::string_view text;
};

std::span<const PageText> page_texts();

}  // namespace litfog::demo
