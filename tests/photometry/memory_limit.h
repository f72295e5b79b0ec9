// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/resource.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <stdexcept>

namespace litfog::test {

/// While it lives the process may take no more than so many bytes of address space on top of what it has.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t bytes) {
    getrlimit(RLIMIT_AS, &usual_);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit = usual_;
    limit.rlim_cur = pages * std::size_t(sysconf(_SC_PAGESIZE)) + bytes;
    if (pages == 0 || setrlimit(RLIMIT_AS, &limit) != 0) throw std::runtime_error("no limit can be set");
  }
  ~MemoryLimit() { setrlimit(RLIMIT_AS, &usual_); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  rlimit usual_{};
};

}  // namespace litfog::test
