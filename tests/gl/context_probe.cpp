// SPDX-License-Identifier: Apache-2.0
// Prints why there is no context, or the renderer. An object that the context takes along has to end without it, though
// libepoxy has loaded no function to delete it.
#include <cstdio>
#include <optional>

#include "litfog/gl/gl_name.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"

int main() {
  std::optional<litfog::gl::BufferName> buffer;
  std::optional<litfog::gl::ProgramName> program;
  try {
    const litfog::gl::HeadlessContext context;
    buffer.emplace();
    program.emplace();
    std::puts(context.renderer().c_str());
  } catch (const litfog::gl::Unsupported& error) {
    std::puts(error.what());
  }
}
