// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog::demo {

/// Becomes litfog-window, the program beside this one: windows need libraries that pictures do not.
///
/// throws  command::MissingCapability where it was not built, or one of those libraries is missing
[[noreturn]] void become_window(const std::vector<std::string>& arguments);

}  // namespace litfog::demo
