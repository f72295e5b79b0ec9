// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <system_error>

namespace litfog {

/// Why a system call failed, in the system's words: "No such file or directory".
///
/// error   errno, or the error that a function stored
/// throws  std::bad_alloc if memory was short, which is the fault of no file
std::string system_reason(int error);
std::string system_reason(const std::error_code& error);

}  // namespace litfog
