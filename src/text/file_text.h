// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace litfog {

/// Opens a file or a pipe for reading. A pipe without a writer, which would block forever, is an error after a second.
///
/// throws  InputError
std::FILE* open_file(const std::string& path);

/// The bytes of a file or of a pipe; folders and devices are errors, since a device may have no end.
///
/// max_bytes  a larger file is an error, found without reading more of it
/// throws     InputError for the file as a whole
std::string read_file_text(const std::string& path, std::size_t max_bytes);
/// read_file_text(), but only the first bytes of a larger file.
std::string read_file_start(const std::string& path, std::size_t max_bytes);

}  // namespace litfog
