// SPDX-License-Identifier: Apache-2.0
#include "demo/sheet/contact_sheet.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <array>

#include "demo/lettering.h"

namespace litfog::demo {
namespace {

constexpr int kMargin = 8;
constexpr int kLineHeight = 20;
constexpr int kCaptionMargin = 6;  // under the last line
constexpr int kFontSize = 15;
constexpr std::array<float, 3> kGround{0.012f, 0.012f, 0.014f};
constexpr glm::vec3 kInk{0.75f, 0.75f, 0.72f};
constexpr glm::vec3 kFaintInk{0.33f, 0.33f, 0.31f};

OIIO::ImageSpec spec_of(int width, int height) { return {width, height, 3, OIIO::TypeDesc::FLOAT}; }

render::Picture to_picture(const OIIO::ImageBuf& image) {
  render::Picture picture{image.spec().width, image.spec().height, {}};
  picture.rgb.resize(std::size_t(picture.width) * std::size_t(picture.height) * 3);
  image.get_pixels(image.roi(), OIIO::TypeDesc::FLOAT, picture.rgb.data());
  return picture;
}

OIIO::ImageBuf to_image(const render::Picture& picture) {
  OIIO::ImageBuf image(spec_of(picture.width, picture.height));
  image.set_pixels(image.roi(), OIIO::TypeDesc::FLOAT, picture.rgb.data());
  return image;
}

}  // namespace

render::Picture fitted_to_cell(const render::Picture& picture) {
  const double scale = std::min(double(kSheetCellWidth) / picture.width, double(kSheetCellHeight) / picture.height);
  const auto scaled = [scale](int size) { return std::max(1, int(size * scale + 0.5)); };
  const int width = scaled(picture.width);
  const int height = scaled(picture.height);
  return to_picture(
      OIIO::ImageBufAlgo::resize(to_image(picture), "box", 0, OIIO::ROI(0, width, 0, height, 0, 1, 0, 3)));
}

render::Picture make_contact_sheet(const std::vector<std::vector<SheetEntry>>& rows) {
  std::size_t columns = 1;
  int height = kMargin;
  std::vector<std::vector<render::Picture>> cells;
  std::vector<int> tops;
  for (const auto& row : rows) {
    columns = std::max(columns, row.size());
    int tallest = 0;
    std::size_t lines = 0;
    for (const SheetEntry& entry : row) {
      cells.resize(tops.size() + 1);
      cells.back().push_back(fitted_to_cell(entry.picture));
      tallest = std::max(tallest, cells.back().back().height);
      lines = std::max(lines, entry.caption.size());
    }
    tops.push_back(height);
    height += tallest + int(lines) * kLineHeight + kCaptionMargin + kMargin;
  }
  render::Picture sheet{int(columns) * (kSheetCellWidth + kMargin) + kMargin, height, {}};
  sheet.rgb.resize(std::size_t(sheet.width) * std::size_t(sheet.height) * 3);
  OIIO::ImageBuf image(spec_of(sheet.width, sheet.height), sheet.rgb.data());
  OIIO::ImageBufAlgo::fill(image, OIIO::cspan<float>(kGround.data(), 3));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const render::Picture& cell = cells[r][c];
      const int left = kMargin + int(c) * (kSheetCellWidth + kMargin);
      OIIO::ImageBufAlgo::paste(image, left, tops[r], 0, 0, to_image(cell));
      int baseline = tops[r] + cell.height - 2;
      for (const std::string& line : rows[r][c].caption) {
        const bool is_first = &line == &rows[r][c].caption.front();
        baseline += kLineHeight;
        draw_text(sheet, left + 2, baseline, fitted_text(line, kFontSize, kSheetCellWidth - 4), kFontSize,
                  is_first ? kInk : kFaintInk);
      }
    }
  }
  return sheet;
}

}  // namespace litfog::demo
