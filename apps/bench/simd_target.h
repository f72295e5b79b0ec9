// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace litfog::bench {

/// The SIMD target that a batch runs on now, in Highway's words: "AVX3", "AVX2", "SSE4".
std::string simd_target();

/// What this machine can run, the widest first.
std::vector<std::string> simd_targets();

/// Lets batches use nothing wider than the target named; it must be one of simd_targets(). Not while a batch runs.
void limit_simd_target(const std::string& name);

}  // namespace litfog::bench
