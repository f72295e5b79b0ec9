// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace litfog::files {

/// Writes a file atomically: a temporary file beside it is filled, is brought to the disk and then takes its name, so
/// that an earlier file stays as it was when anything fails, the power included. An earlier file's mode is kept, and a
/// link stays a link. A device, a pipe, and the file that standard output or standard error goes to cannot be replaced:
/// they are written directly. Throws OutputError.
void write_whole_file(const std::string& path, std::string_view text);

/// The file, existing or not, that a path leads to through links. Throws OutputError for links in a circle.
std::filesystem::path behind_links(std::filesystem::path path);

/// Throws OutputError if the path is a folder, or if write_whole_file() could not begin a file beside it: for commands
/// that work long before they write. Devices, pipes and the files of standard output and error are not tried.
void expect_writable(const std::string& path);

/// Removes from a folder the temporary files of processes that a signal ended during writing. Files that a process is
/// still writing are locked, and stay.
void remove_stale_temporaries(const std::filesystem::path& folder);

/// Whether write_whole_file() would replace an existing file that is not empty.
bool would_replace(const std::string& path);

}  // namespace litfog::files
