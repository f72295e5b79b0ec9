// SPDX-License-Identifier: Apache-2.0
// Prints why there is no context, or the renderer.
#include <cstdio>

#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"

int main() {
  try {
    const litfog::gl::HeadlessContext context;
    std::puts(context.renderer().c_str());
  } catch (const litfog::gl::Unsupported& error) {
    std::puts(error.what());
  }
}
