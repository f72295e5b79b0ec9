// SPDX-License-Identifier: Apache-2.0
#include "files/json_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "text/code_points.h"

namespace litfog::files {
namespace {

std::string in_lines(const std::vector<std::string>& items, int depth) {
  const std::string end = "\n" + std::string(2 * std::size_t(depth), ' ');
  return end + "  " + fmt::format("{}", fmt::join(items, "," + end + "  ")) + end;
}

}  // namespace

std::string json_quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_object(const std::vector<std::string>& members, int depth) {
  return fmt::format("{{{}}}", in_lines(members, depth));
}

std::string json_array(const std::vector<std::string>& items, int depth) {
  return fmt::format("[{}]", in_lines(items, depth));
}

std::string_view start_of(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && !starts_code_point(text[most])) --most;
  return text.substr(0, most);
}

std::string quoted_excerpt(std::string_view text) {
  constexpr std::size_t kMaxShown = 40;
  return json_quoted(start_of(text, kMaxShown)) + (text.size() > kMaxShown ? "..." : "");
}

}  // namespace litfog::files
