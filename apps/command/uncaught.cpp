// SPDX-License-Identifier: Apache-2.0
#include "command/uncaught.h"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>

#include "command/command.h"

namespace litfog::command {
namespace {

[[noreturn]] void end_uncaught() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    _exit(say_out_of_memory());
  } catch (...) {
    __gnu_cxx::__verbose_terminate_handler();
  }
  std::abort();
}

}  // namespace

void expect_uncaught() { std::set_terminate(end_uncaught); }

}  // namespace litfog::command
