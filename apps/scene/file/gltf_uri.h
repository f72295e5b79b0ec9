// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "files/json_document.h"

namespace litfog::scene {

using files::JsonValue;

/// The bytes of a picture that has a "uri": of a base64 data URI, or of a file whose path is relative to the glTF
/// file's folder.
///
/// max_bytes  a larger file is an error, found without reading more of it
/// throws     InputError at the picture or its uri
std::string read_gltf_picture(const JsonValue& picture, std::size_t max_bytes);
/// Likewise of a buffer: of more bytes the first ones, because a buffer may be shorter than what it refers to
/// (glTF 2.0, buffer.byteLength).
std::string read_gltf_buffer(const JsonValue& buffer, std::size_t max_bytes);

/// The path of the file that the "uri" of a buffer or picture names; nothing where there is no uri or it is a data URI.
///
/// throws  InputError
std::optional<std::string> gltf_uri_path(const JsonValue& owner);

/// Bytes from base64 (RFC 4648, section 4), or nothing if the text is not base64. The padding may be left out.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace litfog::scene
