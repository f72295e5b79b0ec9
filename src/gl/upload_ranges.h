// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>

#include "litfog/updater.h"

namespace litfog::gl {

/// Uploads ranges of a table into the buffer bound to a target. The table begins at an offset in bytes.
inline void upload_ranges(GLenum target, std::size_t offset, std::span<const std::byte> table, std::size_t entry_bytes,
                          std::span<const EntryRange> ranges) {
  for (const EntryRange& range : ranges) {
    const auto part = table.subspan(range.begin * entry_bytes, (range.end - range.begin) * entry_bytes);
    glBufferSubData(target, GLintptr(offset + range.begin * entry_bytes), GLsizeiptr(part.size()), part.data());
  }
}

}  // namespace litfog::gl
