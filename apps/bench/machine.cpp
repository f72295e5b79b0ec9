// SPDX-License-Identifier: Apache-2.0
#include "bench/machine.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
// highway.h says which targets are compiled.
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <cassert>
#include <ctime>
#include <fstream>

#include "files/json_text.h"

namespace litfog::bench {
namespace {

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string compiler_name() {
#ifdef __clang__
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

}  // namespace

Machine this_machine(const std::string& gl_renderer) {
  return {.cpu = cpu_name(),
          .isa = simd_target(),
          .compiler = compiler_name(),
          .commit = LITFOG_COMMIT,
          .gl_renderer = gl_renderer,
          .date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))};
}

std::string to_json(const Machine& machine) {
  return fmt::format(R"({{"cpu": {}, "isa": {}, "compiler": {}, "commit": {}, "gl_renderer": {}, "date": {}}})",
                     files::json_quoted(machine.cpu), files::json_quoted(machine.isa),
                     files::json_quoted(machine.compiler), files::json_quoted(machine.commit),
                     files::json_quoted(machine.gl_renderer), files::json_quoted(machine.date));
}

bool is_measurable_build() {
#ifdef NDEBUG
  return true;
#else
  return false;
#endif
}

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const auto target : hwy::SupportedAndGeneratedTargets()) names.emplace_back(hwy::TargetName(target));
  return names;
}

std::string simd_target() { return simd_targets().front(); }

void limit_simd_target(const std::string& name) {
  for (const auto target : hwy::SupportedAndGeneratedTargets()) {
    if (hwy::TargetName(target) != name) continue;
    hwy::DisableTargets(target - 1);  // better targets are lower bits
    return;
  }
  assert(false);
}

}  // namespace litfog::bench
