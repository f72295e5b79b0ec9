// SPDX-License-Identifier: Apache-2.0
#include "system_reason.h"

#include <new>

namespace litfog {

std::string system_reason(int error) { return system_reason(std::error_code(error, std::generic_category())); }

std::string system_reason(const std::error_code& error) {
  if (error == std::errc::not_enough_memory) throw std::bad_alloc();
  return error.message();
}

}  // namespace litfog
