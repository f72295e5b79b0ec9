// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

namespace litfog::c {

/// A caller's array, by its name in errors.
struct Column {
  template <typename T>
  Column(std::span<T> values, const char* its_name) : bytes(std::as_bytes(values)), name(its_name) {}

  std::span<const std::byte> bytes;
  const char* name;
};

/// Throws std::invalid_argument where a column of results shares memory with another or with one that is read.
/// Allocates only then.
void expect_apart(std::span<const Column> results, std::span<const Column> read);

}  // namespace litfog::c
