// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace litfog::command {

/// A folder of litfog's bundled data ("scenes", "lights"): installed, relative to the running program or the Python
/// extension, so that the installation may be moved; in a build tree, the sources'. Need not exist.
std::filesystem::path bundled_folder(const std::string& name);

/// A library that a command loads itself: installed, relative as above.
///
/// built  path in the build tree
std::filesystem::path bundled_plugin(const std::string& name, const std::string& built);

}  // namespace litfog::command
