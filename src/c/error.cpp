// SPDX-License-Identifier: Apache-2.0
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "c/call.h"
#include "litfog/input_error.h"

namespace litfog::c {
namespace {

/// The last error of a thread.
struct LastError {
  std::string text;
  const char* shown = "";

  litfog_status keep(litfog_status status, const char* what) noexcept {
    try {
      text = what;
      shown = text.c_str();
    } catch (const std::bad_alloc&) {
      shown = "out of memory for the text of an error";
    }
    return status;
  }
};
thread_local LastError last_error;

}  // namespace

litfog_status status_of_exception() noexcept {
  try {
    throw;
  } catch (const InputError& error) {
    return last_error.keep(LITFOG_BAD_FILE, error.what());
  } catch (const std::invalid_argument& error) {
    return last_error.keep(LITFOG_INVALID_ARGUMENT, error.what());
  } catch (const std::bad_alloc&) {
    return last_error.keep(LITFOG_OUT_OF_MEMORY, "out of memory");
    // GCOV_EXCL_START: no call that a test can make throws what is left
  } catch (const std::system_error& error) {
    const bool is_memory = error.code() == std::errc::not_enough_memory;
    return last_error.keep(is_memory ? LITFOG_OUT_OF_MEMORY : LITFOG_FAULT, error.what());
  } catch (const std::exception& error) {
    return last_error.keep(LITFOG_FAULT, error.what());
  } catch (...) {
    return last_error.keep(LITFOG_FAULT, "an exception of unknown type");
  }  // GCOV_EXCL_STOP
}

}  // namespace litfog::c

const char* litfog_last_error() { return litfog::c::last_error.shown; }

const char* litfog_version() { return LITFOG_VERSION; }
