// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace litfog::files {

/// The file of a light that a user names: a path, or the name of a bundled one of that folder, such as landing-lamp,
/// where there is no such file. Throws InputError, with what the name may have meant, for a bare name of neither.
std::filesystem::path file_or_bundled(const std::filesystem::path& given, const std::filesystem::path& folder);

}  // namespace litfog::files
