// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/json_document.h"
#include "litfog/light.h"

namespace litfog::files {

/// A light within another file, in which "litfog", "version" and "name" may be left out. Throws InputError.
Light parse_light(const JsonValue& value);

/// Throws what check() finds wrong with a light, at the member it came from and in the file's terms.
///
/// light  an object with members of a light, which may be of another kind of file
[[noreturn]] void fail_light(const JsonValue& light, const ValueError& error);

/// The members that files of lights and of their specs begin with, for json_object().
std::vector<std::string> first_members(std::string_view kind, std::string_view name,
                                       const std::vector<std::string>& source);

/// The member "color".
std::string color_member(const glm::dvec3& color);

}  // namespace litfog::files
