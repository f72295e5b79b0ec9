// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog::bench {

/// The machine and the build of measured figures.
struct Machine {
  std::string cpu;          ///< the processor's own name
  std::string isa;          ///< SIMD target of the batch, in Highway's words: "AVX2"
  std::string compiler;     ///< "GCC 12.2.0"
  std::string commit;       ///< as configured; "unknown" outside a git checkout
  std::string gl_renderer;  ///< GL_RENDERER; "none" if nothing is drawn
  std::string date;         ///< UTC, ISO 8601
};

Machine this_machine(const std::string& gl_renderer);

/// As a JSON object.
std::string to_json(const Machine& machine);

/// False for a Debug build, whose times mean nothing.
bool is_measurable_build();

/// The SIMD target that a batch runs on now, in Highway's words: "AVX3", "AVX2", "SSE4".
std::string simd_target();

/// The SIMD targets that this machine can run, the widest first.
std::vector<std::string> simd_targets();

/// Limits batches to the named target, one of simd_targets(). Must not be called while a batch runs.
void limit_simd_target(const std::string& name);

}  // namespace litfog::bench
