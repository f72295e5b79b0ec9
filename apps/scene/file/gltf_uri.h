// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "files/json_document.h"

namespace litfog::scene {

using files::JsonValue;

/// The bytes of a picture with a "uri": a base64 data URI, or a file's path relative to the glTF file's folder.
///
/// max_bytes  a larger file is an error, found without reading more of it
/// throws     InputError at the picture or its uri
std::string read_gltf_picture(const JsonValue& picture, std::size_t max_bytes);
/// The first max_bytes bytes of a buffer with a "uri". The file may be longer than the buffer (glTF 2.0,
/// buffer.byteLength).
std::string read_gltf_buffer(const JsonValue& buffer, std::size_t max_bytes);

/// The path of the file that the "uri" of a buffer or picture names; nothing for no uri or a data URI.
///
/// throws  InputError
std::optional<std::string> gltf_uri_path(const JsonValue& owner);

/// Decodes base64 (RFC 4648, section 4) with or without padding; nothing if the text is not base64.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace litfog::scene
