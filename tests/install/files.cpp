// SPDX-License-Identifier: Apache-2.0
#include <litfog/files/light_file.h>
#include <litfog/files/light_spec_file.h>

#include <cstdio>

int main(int, char** arguments) {
  const litfog::Light light = litfog::read_light(arguments[1]);
  std::printf("%s", litfog::format_light(light).c_str());
  try {
    litfog::read_light_spec(arguments[1]);
  } catch (const litfog::InputError& error) {
    std::printf("%zu:%zu\n", error.location().line, error.location().column);
  }
}
