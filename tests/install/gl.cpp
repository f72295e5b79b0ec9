// SPDX-License-Identifier: Apache-2.0
#include <litfog/gl/fog_light_tables.h>
#include <litfog/gl/headless_context.h>
#include <litfog/gl/program.h>
#include <litfog/gl/unsupported.h>

#include <cstdio>

int main() {
  for (const auto& source : litfog::gl::shader_library())
    std::printf("%.*s\n", int(source.name.size()), source.name.data());
  try {
    const litfog::gl::HeadlessContext context;
    std::printf("%s\n", context.renderer().c_str());
    litfog::gl::FogLightTables tables;
    tables.upload({}, {}, {});
  } catch (const litfog::gl::Unsupported& reason) {
    std::printf("%s\n", reason.what());
  }
}
