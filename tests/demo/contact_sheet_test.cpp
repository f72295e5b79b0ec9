// SPDX-License-Identifier: Apache-2.0
#include "drawing/contact_sheet.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace drawing;
using namespace render;

namespace {

Picture grey(int width, int height) {
  return {width, height, std::vector<float>(std::size_t(width) * std::size_t(height) * 3, 0.5f)};
}

TEST(ContactSheet, PictureIsFittedToTheCellsWidthInItsShape) {
  const Picture cell = fitted_to_cell(grey(1280, 720));
  EXPECT_EQ(cell.width, kSheetCellWidth);
  EXPECT_EQ(cell.height, 270);
}

TEST(ContactSheet, TallPictureIsFittedToTheCellsHeight) {
  const Picture cell = fitted_to_cell(grey(100, 1000));
  EXPECT_EQ(cell.width, 96);
  EXPECT_EQ(cell.height, kSheetCellHeight);
}

TEST(ContactSheet, PictureOneColumnWideIsNotMagnified) {
  const Picture cell = fitted_to_cell(grey(1, 16384));
  EXPECT_EQ(cell.width, 1);
  EXPECT_EQ(cell.height, kSheetCellHeight);
  EXPECT_NEAR(cell.rgb.front(), 0.5f, 1e-6f);
  const Picture sheet = make_contact_sheet({{{grey(1, 16384), {"test"}}}});
  EXPECT_LT(sheet.height, kSheetCellHeight + 100);
}

TEST(ContactSheet, PictureOneRowHighKeepsARow) { EXPECT_EQ(fitted_to_cell(grey(16384, 1)).height, 1); }

}  // namespace

}  // namespace litfog::test
