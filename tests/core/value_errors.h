// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace litfog::test {

/// The sentence of the error that a call throws.
template <typename Error, typename Call>
std::string sentence_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

template <typename Call>
std::string error_of(const Call& call) {
  return sentence_of<std::invalid_argument>(call);
}

}  // namespace litfog::test
