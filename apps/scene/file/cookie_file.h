// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "scene/cookie.h"

namespace litfog::scene {

/// Reads a cookie from an image of one channel, its faces in one column, as litfog-fit writes it. Throws BadInput.
Cookie read_cookie(const std::string& path);

}  // namespace litfog::scene
