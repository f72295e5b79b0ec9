// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace litfog {

/// A photometric file's bytes as UTF-8, without a byte order mark. They may be UTF-8, UTF-16 (with a byte order mark,
/// or known by its zero bytes), or text of a code page. No file names its code page. Western text has its accents
/// between plain letters, so it is Windows-1252 unless two of its bytes beyond ASCII adjoin; then the code page is
/// guessed from the frequencies of its letters. Bytes that a code page lacks make the whole text Latin-1, which lacks
/// none.
std::string utf8_from_bytes(std::string bytes);

/// A name as zip programs of western Windows store it. Nothing if the code page lacks one of its letters.
std::optional<std::string> code_page_850_from_utf8(std::string_view text);

}  // namespace litfog
