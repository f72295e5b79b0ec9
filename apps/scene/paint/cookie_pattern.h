// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "litfog/photometry/cookie.h"

namespace litfog::scene {

/// Cookies that need no file: a mirror ball's spots all around, and a beacon's two beams across its axis.
inline constexpr std::string_view kCookiePatterns[] = {"disco", "beacon"};

/// Paints one of kCookiePatterns.
Cookie paint_cookie(std::string_view pattern);

}  // namespace litfog::scene
