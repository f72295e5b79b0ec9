// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "litfog/c/litfog.h"

namespace litfog::c {

/// The status of the exception being handled; its text becomes the thread's last error.
litfog_status status_of_exception() noexcept;

/// Runs the body of a C function. Whatever it throws ends here.
template <typename Body>
litfog_status call(const Body& body) noexcept {
  try {
    body();
    return LITFOG_OK;
  } catch (...) {
    return status_of_exception();
  }
}

/// The object behind a caller's pointer. Check pointers for results with it before creating anything that a throw would
/// lose.
///
/// name    name of the parameter or member, for the error
/// throws  std::invalid_argument if it is null
template <typename T>
T& at(T* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + ": must not be NULL");
  return *pointer;
}

/// A caller's array; may be null if empty.
///
/// throws  std::invalid_argument also for sizes beyond memory, such as another language's negative count
template <typename T>
std::span<T> array(T* first, std::size_t count, const char* name) {
  if (count > 0) at(first, name);
  constexpr std::size_t kMost = std::numeric_limits<std::ptrdiff_t>::max() / sizeof(T);
  if (count > kMost) {
    throw std::invalid_argument("size of " + std::string(name) + " = " + std::to_string(count) + ": must be at most " +
                                std::to_string(kMost));
  }
  return {first, count};
}

}  // namespace litfog::c
