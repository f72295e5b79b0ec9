// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/angle_deg.h"
#include "files/json_document.h"
#include "litfog/cone.h"
#include "litfog/light.h"
#include "text/shown_number.h"

namespace litfog::files {

/// A light within another file, in which "litfog", "version" and "name" may be left out. Throws InputError.
Light parse_light(const JsonValue& value);

/// The member "flash" of a light, unchecked except for its number of flashes. Throws InputError.
Flash parse_flash(const JsonValue& value);

/// Throws an error of find_error() for a light, at the member it came from and in the file's terms.
///
/// light  an object with members of a light, which may be of another kind of file
[[noreturn]] void fail_light(const JsonValue& light, const ValueError& error);

/// The profile that a value names; nothing for one of the other allowed words. Throws InputError.
std::optional<ConeProfile> parse_profile(const JsonValue& value, std::vector<std::string_view> words = {});

/// A cone's parameter as files have it.
inline double file_value(const Cone& cone, const ConeParameter& parameter) {
  return parameter.is_angle ? degrees(cone.*parameter.member) : cone.*parameter.member;
}

/// "half_angle_deg 30, exponent 4"
inline std::string shown_parameters(const Cone& cone) {
  std::string text;
  for (const ConeParameter& parameter : facts_of(cone.profile).parameters) {
    text +=
        std::string(text.empty() ? "" : ", ") + parameter.file_name + " " + shown_number(file_value(cone, parameter));
  }
  return text;
}

/// The member "cone" of a light file.
std::string cone_json(const Cone& cone);

}  // namespace litfog::files
