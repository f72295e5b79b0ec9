// SPDX-License-Identifier: Apache-2.0
#include <litfog/files/light_file.h>
#include <litfog/files/light_spec_file.h>

#include <cstdio>
#include <fstream>
#include <string>

int main(int, char** arguments) {
  const litfog::Light light = litfog::read_light(arguments[1]);
  std::printf("%s", litfog::format_light(light).c_str());
  const std::string spec = std::string(arguments[1]) + ".spec";
  std::ofstream(spec) << R"({"litfog": "light-spec", "version": 1, "range": {"extent_m": 120}})";
  std::printf("%g\n", *litfog::read_light_spec(spec).range->extent);
  litfog::write_light(arguments[1], light);
  try {
    litfog::read_light_spec(arguments[1]);
  } catch (const litfog::InputError& error) {
    std::printf("%zu:%zu\n", error.location().line, error.location().column);
  }
}
