// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/picture.h"

namespace litfog::drawing {

inline constexpr int kSheetCellWidth = 480;   ///< pixels: the width of a sheet's pictures
inline constexpr int kSheetCellHeight = 960;  ///< pixels, at most; taller pictures are made narrower instead

/// One picture of a sheet, as a display shows it (render::displayed), with the lines of text under it. Lines after the
/// first are fainter.
struct SheetEntry {
  render::Picture picture;
  std::vector<std::string> caption;
};

/// Rows of pictures, each fitted to a cell, with captions, on a dark background. Lines wider than a cell are cut short.
///
/// throws  image::ImageError if no font is found for the captions
render::Picture make_contact_sheet(const std::vector<std::vector<SheetEntry>>& rows);

/// Scales a picture to fit a cell, by averaging. It must be as a display shows it (render::displayed), or bright lamps
/// would spread over their neighbours.
render::Picture fitted_to_cell(const render::Picture& picture);

/// Copies a picture into a larger one, with its upper left corner at (left, top).
void paste(render::Picture& sheet, int left, int top, const render::Picture& picture);

}  // namespace litfog::drawing
