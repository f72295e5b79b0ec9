// SPDX-License-Identifier: Apache-2.0
#include "litfog/input_error.h"

#include <utility>

namespace litfog {
namespace {

std::string sentence(std::string_view what, std::string_view value, std::string_view rule) {
  std::string text(what);
  if (!value.empty()) text.append(" = ").append(value);
  return text.append(": ").append(rule);
}

}  // namespace

std::string to_string(const InputLocation& location) {
  std::string text = location.file;
  if (location.line > 0) text += ":" + std::to_string(location.line);
  if (location.line > 0 && location.column > 0) text += ":" + std::to_string(location.column);
  return text;
}

InputError::InputError(InputLocation location, std::string_view message)
    : std::runtime_error(to_string(location).append(": ").append(message)),
      location_(std::make_shared<const InputLocation>(std::move(location))) {}

InputError::InputError(InputLocation location, std::string_view what, std::string_view value, std::string_view rule)
    : InputError(std::move(location), sentence(what, value, rule)) {}

InputError::InputError(InputLocation location, const ValueError& error)
    : InputError(std::move(location), to_string(error)) {}

}  // namespace litfog
