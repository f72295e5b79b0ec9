// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::gl {

/// Throws if a GL error is pending, which is a bug of the caller's, and clears it.
///
/// action   what was done, for the message
/// throws   std::logic_error naming the error and `action`; std::bad_alloc where OpenGL has run out of memory
/// threads  asks the calling thread's current context
void check_errors(const char* action);

}  // namespace litfog::gl
