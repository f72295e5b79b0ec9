// SPDX-License-Identifier: Apache-2.0
// The page of settings in Chromium, where that is installed.

#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "command/temporary_directory.h"
#include "demo/picture_file.h"
#include "demo/settings_page.h"

namespace litfog::test {
namespace {

constexpr int kWindowWidth = 1000;
constexpr int kWindowHeight = 1000;

using Color = std::array<float, 3>;
constexpr Color kRed{1, 0, 0};
constexpr Color kGreen{0, 1, 0};
constexpr Color kBlue{0, 0, 1};

/// A page of a red and a green picture of 40x20 pixels, the red one with a corner of a pixel in blue; blue is their
/// difference.
class SettingsPageInABrowser : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v chromium >/dev/null") != 0) GTEST_SKIP() << "chromium is not installed";
    render::Picture red = picture(kRed);
    std::ranges::copy(kBlue, red.rgb.begin());
    const std::string html =
        demo::settings_page({.title = "test", .machine = "none", .width = 40, .height = 20, .frames = 1},
                            {{"red", 1, 0, demo::png_text(red)}, {"green", 1, 0, demo::png_text(picture(kGreen))}},
                            {{0, 1, 255, 255, demo::png_text(picture(kBlue))}});
    std::ofstream(directory_.path() / "index.html") << html;
  }

  static render::Picture picture(const Color& color) {
    render::Picture picture{40, 20, {}};
    for (int i = 0; i < 40 * 20; ++i) picture.rgb.insert(picture.rgb.end(), color.begin(), color.end());
    return picture;
  }

  /// Opens the page in a state from the disk.
  void browse(const std::string& state, const std::string& option) const {
    const std::string folder = directory_.path().string();
    const std::string command = fmt::format(
        "cd {0} && HOME={0} chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --window-size={1},{2} "
        "--user-data-dir={0}/profile --virtual-time-budget=2000 {3} 'file://{0}/index.html#{4}' >dom 2>messages",
        folder, kWindowWidth, kWindowHeight, option, state);
    ASSERT_EQ(std::system(command.c_str()), 0) << text("messages");
  }

  std::string text(const std::string& file) const {
    std::ifstream stream(directory_.path() / file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  TemporaryDirectory directory_;
};

TEST_F(SettingsPageInABrowser, WipesFromOnePictureToTheOtherAtPixelSize) {
  browse("mode=wipe&wipe=0.25&zoom=16&x=8&y=8", "--screenshot=shot.png");
  OIIO::ImageBuf shot((directory_.path() / "shot.png").string());
  ASSERT_EQ(shot.spec().width, kWindowWidth);
  // The stage is as wide as the page but for its margins; pictures are where all but one channel is dark.
  int red = 0;
  int green = 0;
  int blue = 0;
  for (int y = 0; y < kWindowHeight; ++y) {
    for (int x = 0; x < kWindowWidth; ++x) {
      const Color color{shot.getchannel(x, y, 0, 0), shot.getchannel(x, y, 0, 1), shot.getchannel(x, y, 0, 2)};
      red += color == kRed;
      green += color == kGreen;
      blue += color == kBlue;
    }
  }
  // At 16x, the picture begins 8 pixels left of the stage's middle, which is 0.25 of its width from the wipe's edge.
  EXPECT_EQ(blue, 0) << "the corner lies right of the edge, where the green picture is";
  EXPECT_GT(green, 16 * 16 * 100);
  EXPECT_EQ(red, 0);
  browse("mode=wipe&wipe=0.5&zoom=16&x=8&y=8", "--screenshot=shot.png");
  OIIO::ImageBuf half((directory_.path() / "shot.png").string());
  red = green = blue = 0;
  for (int y = 0; y < kWindowHeight; ++y) {
    for (int x = 0; x < kWindowWidth; ++x) {
      const Color color{half.getchannel(x, y, 0, 0), half.getchannel(x, y, 0, 1), half.getchannel(x, y, 0, 2)};
      red += color == kRed;
      green += color == kGreen;
      blue += color == kBlue;
    }
  }
  EXPECT_EQ(blue, 16 * 16) << "one pixel of the picture";
  EXPECT_GT(red, 16 * 16 * 100);
  EXPECT_GT(green, 16 * 16 * 100);
}

TEST_F(SettingsPageInABrowser, StatesThePairAndWhatIsShown) {
  browse("a=1&b=0&mode=difference", "--dump-dom");
  const std::string dom = text("dom");
  EXPECT_NE(dom.find(">Largest difference 255, mean 255 of 1/255</output>"), dom.npos) << dom.substr(0, 2000);
  EXPECT_NE(dom.find("data-mode=\"difference\" title=\"Key D\" aria-pressed=\"true\""), dom.npos);
  EXPECT_NE(dom.find("data-mode=\"wipe\" title=\"Key W\" aria-pressed=\"false\""), dom.npos);
}

}  // namespace
}  // namespace litfog::test
