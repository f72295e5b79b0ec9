// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace litfog {

/// Calls work(i) for i in [0, count) on all cores, in that order. After an exception no other call begins, and the
/// exception is thrown once all begun calls have ended.
///
/// threads  0: one a core
template <typename Work>
void for_each_in_parallel(std::size_t count, const Work& work, std::size_t threads = 0) {
  std::atomic<std::size_t> next = 0;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> others;
  try {
    if (threads == 0) threads = std::thread::hardware_concurrency();
    threads = std::min(count, threads);
    for (std::size_t i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, run));
  } catch (const std::system_error&) {  // no more threads: those that started, and this one, do all the work
  } catch (const std::bad_alloc&) {     // no memory for more threads
  }
  run();
  for (std::future<void>& other : others) other.get();
}

}  // namespace litfog
