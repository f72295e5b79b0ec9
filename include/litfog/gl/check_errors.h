// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::gl {

/// Throws where a GL error is pending, for one is a defect of the caller. The error is no longer pending then.
///
/// place    what was done, for the message
/// throws   std::logic_error naming the error and `place`
/// threads  asks the calling thread's current context
void check_errors(const char* place);

}  // namespace litfog::gl
