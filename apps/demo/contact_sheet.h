// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/picture.h"

namespace litfog::demo {

inline constexpr int kSheetCellWidth = 480;  ///< pixels: the common width of a sheet's pictures

/// One picture of a sheet with the lines of words under it, of which those after the first are fainter.
struct SheetEntry {
  render::Picture picture;
  std::vector<std::string> caption;
};

/// Rows of pictures, each reduced to a common width, with captions in a plain type, on a dark ground. Lines that are
/// wider than a picture are cut short.
/// throws std::runtime_error where no font is found for the captions
render::Picture make_contact_sheet(const std::vector<std::vector<SheetEntry>>& rows);

/// A picture at another width in the same shape, averaged.
render::Picture reduced(const render::Picture& picture, int width);

}  // namespace litfog::demo
