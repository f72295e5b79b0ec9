// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <system_error>

namespace litfog {

/// Why a call of the system failed, in its words: "No such file or directory".
///
/// error   errno, or what a function stored
/// throws  std::bad_alloc where memory was short, which is the fault of no file
std::string system_reason(int error);
std::string system_reason(const std::error_code& error);

}  // namespace litfog
