// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "files/json_document.h"

namespace litfog::scene {

using files::JsonValue;

inline constexpr std::string_view kMeshopt = "EXT_meshopt_compression";

/// The bytes of a buffer view that is compressed.
///
/// compression  the view's extension
/// bytes        the compressed ones
/// max_bytes    more decoded ones are an error
/// throws       InputError
std::string decode_meshopt(const JsonValue& compression, std::string_view bytes, std::size_t max_bytes);

}  // namespace litfog::scene
