// SPDX-License-Identifier: Apache-2.0
#include "core/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> count = 0;

}  // namespace

// The library's other forms (arrays, nothrow) call these. Aligned ones are not counted: nothing here uses them.
void* operator new(std::size_t size) {
  ++count;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace litfog::test {

std::size_t allocation_count() { return count; }

}  // namespace litfog::test
