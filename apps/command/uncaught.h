// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace litfog::command {

/// Makes a command that runs out of memory say so and end with kInternalError where run_command() catches nothing: in
/// static initialisation, while options are added, in a thread, in a destructor. It is a constructor, ahead of all
/// others. main() calls it so that it is linked; it must not be linked into litfog.pictures, which is not a program.
[[gnu::constructor(101)]] void expect_uncaught();

}  // namespace litfog::command
