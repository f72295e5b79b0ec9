// SPDX-License-Identifier: Apache-2.0
#include "core/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> count = 0;
std::atomic<std::size_t> failing = std::size_t(-1);

}  // namespace

// The library's other forms (arrays, nothrow) call these. Aligned ones are not counted: nothing here uses them.
void* operator new(std::size_t size) {
  if (count++ == failing) throw std::bad_alloc();
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace litfog::test {

std::size_t allocation_count() { return count; }

bool fail_allocation_after(std::size_t more) {
  const std::size_t now = count;
  return failing.exchange(more == std::size_t(-1) ? more : now + more) < now;
}

}  // namespace litfog::test
