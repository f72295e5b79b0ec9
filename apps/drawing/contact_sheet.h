// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/picture.h"

namespace litfog::drawing {

inline constexpr int kSheetCellWidth = 480;   ///< pixels: the width of a sheet's pictures
inline constexpr int kSheetCellHeight = 960;  ///< at most; a picture that would be taller is narrower instead

/// One picture of a sheet, as a display shows it (render::displayed), with the lines of text under it. Lines after the
/// first are fainter.
struct SheetEntry {
  render::Picture picture;
  std::vector<std::string> caption;
};

/// Rows of pictures, each fitted to a cell, with captions in a plain type, on a dark ground. Lines that are wider than
/// a cell are cut short.
/// throws image::ImageError where no font is found for the captions
render::Picture make_contact_sheet(const std::vector<std::vector<SheetEntry>>& rows);

/// A picture in the same shape as wide as a cell, or as tall if that makes it smaller; averaged. It is one that a
/// display shows, else a bright lamp would spread over its neighbours.
render::Picture fitted_to_cell(const render::Picture& picture);

/// Copies a picture into a larger one, its upper left corner at a pixel of it.
void paste(render::Picture& sheet, int left, int top, const render::Picture& picture);

}  // namespace litfog::drawing
