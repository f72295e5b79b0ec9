// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace litfog::command {

/// Escapes a text for HTML, between tags and in quoted attributes.
std::string html_text(std::string_view text);

/// A link to a file beside the page: everything except letters, digits, '-', '.', '_' and '~' as %XX (RFC 3986).
std::string html_link(std::string_view file);

/// A file embedded in the page, in base64 (RFC 4648, section 4).
///
/// type  "image/png"
std::string data_uri(std::string_view type, std::string_view bytes);

}  // namespace litfog::command
