// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "files/json_document.h"

namespace litfog::scene {

using files::JsonValue;

// Values of glTF's JSON. Each function throws InputError at the wrong value.

/// A whole number that an int holds, as indices, counts and offsets are.
std::size_t whole_number(const JsonValue& value);
std::size_t whole_number_or(const JsonValue& object, std::string_view name, std::size_t absent);

/// An array of `count` numbers.
std::vector<double> numbers(const JsonValue& value, std::size_t count);

/// The items of an optional array.
std::vector<JsonValue> items_of(const JsonValue& object, std::string_view name);

/// An index into a file's array.
std::size_t index_in(const std::vector<JsonValue>& array, const JsonValue& index);

/// An extension of the file or of a part of it.
std::optional<JsonValue> extension_of(const JsonValue& object, std::string_view name);

}  // namespace litfog::scene
