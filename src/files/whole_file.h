// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace litfog::files {

/// Writes a file atomically: a temporary file beside it is written, synced to disk and renamed, so that an earlier file
/// survives any failure, even of the power. An earlier file's mode is kept, and a link stays a link. A device, a pipe,
/// and the file of standard output or standard error cannot be replaced: they are written directly. Throws OutputError.
void write_whole_file(const std::string& path, std::string_view text);

/// The file, existing or not, that a path leads to through links. Throws OutputError for circular links.
std::filesystem::path behind_links(std::filesystem::path path);

/// Throws OutputError if the path is a folder, or if write_whole_file() could not create a file beside it. For commands
/// that work long before they write. Devices, pipes and the files of standard output and error are not tried.
void expect_writable(const std::string& path);

/// Removes temporary files from a folder that killed processes left. Files that a process is still writing are locked,
/// and stay.
void remove_stale_temporaries(const std::filesystem::path& folder);

/// Whether write_whole_file() would replace an existing file that is not empty.
bool would_replace(const std::string& path);

}  // namespace litfog::files
