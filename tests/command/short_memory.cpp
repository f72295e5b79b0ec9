// SPDX-License-Identifier: Apache-2.0
// Preloaded into a command (LD_PRELOAD), it makes memory short once libraries are loaded: from the
// LITFOG_FAILING_ALLOCATION-th allocation on there is none, or none for more than LITFOG_LARGEST_ALLOCATION bytes.
#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
}

namespace {

std::size_t failing = std::size_t(-1);
std::size_t largest = std::size_t(-1);
std::atomic<std::size_t> count = 0;

bool is_short(std::size_t size) {
  if (++count < failing && size <= largest) return false;
  errno = ENOMEM;
  return true;
}

void read_limit(std::size_t& limit, const char* variable) {
  if (const char* const text = std::getenv(variable)) limit = std::strtoul(text, nullptr, 10);
}

}  // namespace

extern "C" {
void* malloc(std::size_t size) { return is_short(size) ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t n, std::size_t size) { return is_short(n * size) ? nullptr : __libc_calloc(n, size); }
void* realloc(void* memory, std::size_t size) { return is_short(size) ? nullptr : __libc_realloc(memory, size); }

/// What a program begins with, before it makes what is static.
int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*unload)(), void* stack_end) {
  const auto start = reinterpret_cast<decltype(&__libc_start_main)>(dlsym(RTLD_NEXT, "__libc_start_main"));
  count = 0;
  read_limit(failing, "LITFOG_FAILING_ALLOCATION");
  read_limit(largest, "LITFOG_LARGEST_ALLOCATION");
  return start(main, argc, argv, init, fini, unload, stack_end);
}
}
