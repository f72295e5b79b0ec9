// SPDX-License-Identifier: Apache-2.0
#include "c/column.h"

#include <functional>
#include <stdexcept>
#include <string>

namespace litfog::c {
namespace {

bool overlap(std::span<const std::byte> a, std::span<const std::byte> b) {
  if (a.empty() || b.empty()) return false;
  constexpr std::less<const std::byte*> is_before{};  // orders pointers into different arrays, too
  return is_before(a.data(), b.data() + b.size()) && is_before(b.data(), a.data() + a.size());
}

void expect_apart(const Column& results, const Column& other) {
  if (!overlap(results.bytes, other.bytes)) return;
  throw std::invalid_argument(std::string(results.name) + ": must not overlap " + other.name);
}

}  // namespace

void expect_apart(std::span<const Column> results, std::span<const Column> read) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const Column& column : read) expect_apart(results[i], column);
    for (const Column& other : results.first(i)) expect_apart(results[i], other);
  }
}

}  // namespace litfog::c
