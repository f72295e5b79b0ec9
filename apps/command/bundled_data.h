// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace litfog::command {

/// A folder of the data that comes with litfog ("scenes", "lights"): where an install put it, seen from the running
/// program or the extension of Python, so that the whole may be moved; in a build tree it is the sources'. It need not
/// exist.
std::filesystem::path bundled_folder(const std::string& name);

/// A library that a command loads itself: where an install put it, seen as above.
///
/// built  where it is in the build tree
std::filesystem::path bundled_plugin(const std::string& name, const std::string& built);

}  // namespace litfog::command
