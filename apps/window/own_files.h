// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace litfog::window {

// Files that the window keeps between runs, in $XDG_CONFIG_HOME/litfog, by default ~/.config/litfog.

/// The path of a file in that folder, which is made; empty if it cannot be made.
std::filesystem::path own_file(const std::string& name);

/// The scene files last opened that still exist, the newest first.
std::vector<std::string> recent_files();

/// Makes a file the newest of at most ten recent files. Does nothing if it cannot be stored.
void remember_file(const std::string& path);

}  // namespace litfog::window
