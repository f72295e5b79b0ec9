// SPDX-License-Identifier: Apache-2.0
#include "command/standard_output.h"

#include <cerrno>
#include <cstdio>

#include "command/printable.h"
#include "command/progress.h"
#include "litfog/files/output_error.h"
#include "text/system_reason.h"

namespace litfog::command {
namespace {

[[noreturn]] void fail_to_write() { throw OutputError("standard output cannot be written: " + system_reason(errno)); }

}  // namespace

void write_standard_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) fail_to_write();
}

void report(std::string_view text) {
  Progress::clear();
  write_standard_output(printable_lines(text));
  if (std::fflush(stdout) != 0) fail_to_write();
}

void close_standard_output() {
  if (std::fclose(stdout) != 0) fail_to_write();
}

}  // namespace litfog::command
