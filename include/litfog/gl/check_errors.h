// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::gl {

/// Clears a pending GL error, which is a caller's bug, and throws.
///
/// action   what was done, for the message
/// throws   std::logic_error naming the error and `action`; std::bad_alloc if OpenGL has run out of memory
/// threads  asks the calling thread's current context
void check_errors(const char* action);

}  // namespace litfog::gl
