// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::gl {

/// Throws where a GL error is pending, which is a bug of the caller. The error is no longer pending then.
///
/// action   what was done, for the message
/// throws   std::logic_error naming the error and `action`
/// threads  asks the calling thread's current context
void check_errors(const char* action);

}  // namespace litfog::gl
