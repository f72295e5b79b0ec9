// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace litfog::render {

/// Linear RGB, top row first.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

}  // namespace litfog::render
