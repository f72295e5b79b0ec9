// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <functional>
#include <utility>

namespace litfog::render {

/// Thrown instead of finishing a frame that is no longer wanted.
struct Interrupted {};

/// Whether a frame is still wanted while it is drawn.
class Interruption {
 public:
  /// is_unwanted  polled during drawing; not called again after it returns true; empty: always wanted
  explicit Interruption(std::function<bool()> is_unwanted = {}) : is_unwanted_(std::move(is_unwanted)) {}

  bool can_come() const { return bool(is_unwanted_); }
  /// Waits for the GPU before it polls: drawing is asynchronous, and without waiting all of a frame would be queued
  /// before the first poll.
  bool has_come() {
    if (!is_unwanted_ || has_come_) return has_come_;
    glFinish();
    return has_come_ = is_unwanted_();
  }

 private:
  std::function<bool()> is_unwanted_;
  bool has_come_ = false;
};

}  // namespace litfog::render
