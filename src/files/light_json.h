// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "files/json_document.h"
#include "litfog/light.h"

namespace litfog::files {

/// A light within another file, in which "litfog", "version" and "name" may be left out. Throws InputError.
Light parse_light(const JsonValue& value);

/// The member "flash" of a light, not checked but for its number of flashes. Throws InputError.
Flash parse_flash(const JsonValue& value);

/// Throws what find_error() finds wrong with a light, at the member it came from and in the file's terms.
///
/// light  an object with members of a light, which may be of another kind of file
[[noreturn]] void fail_light(const JsonValue& light, const ValueError& error);

}  // namespace litfog::files
