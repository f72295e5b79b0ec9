// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace litfog::test {

/// How often operator new has been called in this process, on all threads.
std::size_t allocation_count();

/// Makes one operator new fail: that after `count` more. Returns whether the one chosen before has failed.
bool fail_allocation_after(std::size_t count);

/// Makes a call whose first operator new fails, then one whose second does, and so on until none fails; checks after
/// each but the last. The call catches what that throws. Returns how many failed.
template <typename Call, typename Check>
std::size_t fail_each_allocation(const Call& call, const Check& check) {
  for (std::size_t count = 0;; ++count) {
    fail_allocation_after(count);
    call();
    if (!fail_allocation_after(std::size_t(-1))) return count;
    check();
  }
}

}  // namespace litfog::test
