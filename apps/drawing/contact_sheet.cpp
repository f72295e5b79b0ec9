// SPDX-License-Identifier: Apache-2.0
#include "drawing/contact_sheet.h"

#include <algorithm>
#include <array>

#include "drawing/lettering.h"
#include "image/image_library.h"

namespace litfog::drawing {
namespace {

constexpr int kMargin = 8;
constexpr int kLineHeight = 20;
constexpr int kCaptionMargin = 6;  // pixels under the last line
constexpr int kFontSize = 15;
constexpr std::array<float, 3> kGround{0.012f, 0.012f, 0.014f};
constexpr glm::vec3 kInk{0.75f, 0.75f, 0.72f};
constexpr glm::vec3 kFaintInk{0.33f, 0.33f, 0.31f};

}  // namespace

void paste(render::Picture& sheet, int left, int top, const render::Picture& picture) {
  const std::size_t row = std::size_t(picture.width) * 3;
  for (int y = 0; y < picture.height; ++y) {
    const std::size_t to = std::size_t(top + y) * std::size_t(sheet.width) + std::size_t(left);
    std::copy_n(picture.rgb.begin() + std::ptrdiff_t(std::size_t(y) * row), row,
                sheet.rgb.begin() + std::ptrdiff_t(3 * to));
  }
}

render::Picture fitted_to_cell(const render::Picture& picture) {
  const double scale = std::min(double(kSheetCellWidth) / picture.width, double(kSheetCellHeight) / picture.height);
  const auto scaled = [scale](int size) { return std::max(1, int(size * scale + 0.5)); };
  const int width = scaled(picture.width);
  const int height = scaled(picture.height);
  return {width, height, image::image_library().resized(picture.width, picture.height, picture.rgb, width, height)};
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
  for (std::size_t i = 0; i < sheet.rgb.size(); ++i) sheet.rgb[i] = kGround[i % 3];
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      const render::Picture& cell = cells[r][c];
      const int left = kMargin + int(c) * (kSheetCellWidth + kMargin);
      paste(sheet, left, tops[r], cell);
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

}  // namespace litfog::drawing
