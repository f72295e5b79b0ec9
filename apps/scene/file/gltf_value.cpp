// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_value.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace litfog::scene {

std::size_t whole_number(const JsonValue& value) {
  const double number = value.number();
  if (!(number >= 0 && number == std::floor(number))) value.fail("must be a whole number >= 0");
  if (number > std::numeric_limits<int>::max()) value.fail("must be below 2^31");
  return std::size_t(number);
}

std::size_t whole_number_or(const JsonValue& object, std::string_view name, std::size_t absent) {
  const auto value = object.optional(name);
  return value ? whole_number(*value) : absent;
}

std::vector<double> numbers(const JsonValue& value, std::size_t count) {
  const auto items = value.items();
  if (items.size() != count) value.fail(fmt::format("must be {} numbers", count));
  std::vector<double> numbers;
  for (const JsonValue& item : items) numbers.push_back(item.number());
  return numbers;
}

std::vector<JsonValue> items_of(const JsonValue& object, std::string_view name) {
  const auto array = object.optional(name);
  return array ? array->items() : std::vector<JsonValue>{};
}

std::size_t index_in(const std::vector<JsonValue>& array, const JsonValue& index) {
  const std::size_t number = whole_number(index);
  if (array.empty()) index.fail("must not be given: there are none");
  if (number >= array.size()) index.fail(fmt::format("must be in [0, {}]", array.size() - 1));
  return number;
}

std::optional<JsonValue> extension_of(const JsonValue& object, std::string_view name) {
  const auto extensions = object.optional("extensions");
  return extensions ? extensions->optional(name) : std::nullopt;
}

}  // namespace litfog::scene
