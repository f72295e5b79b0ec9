// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pthread.h>

#include <cstddef>
#include <stdexcept>

namespace litfog::test {

/// While it lives no thread can start, as where a limit of processes is reached: its stack would not fit into memory.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    pthread_getattr_default_np(&usual_);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    constexpr std::size_t kBeyondAddressSpace = std::size_t{1} << 47;
    pthread_attr_setstacksize(&attributes, kBeyondAddressSpace);
    if (pthread_setattr_default_np(&attributes) != 0) throw std::runtime_error("no limit can be set");
    pthread_attr_destroy(&attributes);
  }
  ~NoMoreThreads() {
    pthread_setattr_default_np(&usual_);
    pthread_attr_destroy(&usual_);
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;

 private:
  pthread_attr_t usual_;
};

}  // namespace litfog::test
