// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace litfog::test {

/// How often operator new has been called in this process, on all threads.
std::size_t allocation_count();

}  // namespace litfog::test
