// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace litfog::window {

// What the window keeps between runs, in $XDG_CONFIG_HOME/litfog, by default ~/.config/litfog.

/// A file in that folder, which is made; an empty path where there is no such folder.
std::filesystem::path own_file(const std::string& name);

/// The scene files that were last opened and are there, the newest first.
std::vector<std::string> recent_files();

/// Makes a file the newest of them, of ten at most. Does nothing where it cannot be kept.
void remember_file(const std::string& path);

}  // namespace litfog::window
