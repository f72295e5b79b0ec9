// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::command {

/// From here on a command that runs out of memory says so and ends with kInternalError also where run_command() catches
/// nothing: while it makes what is static or its options, in a thread, in a destructor. It is a constructor, ahead of
/// all others; main() calls it so that it is linked, as it must not be into litfog.pictures, which is no program.
[[gnu::constructor(101)]] void expect_uncaught();

}  // namespace litfog::command
