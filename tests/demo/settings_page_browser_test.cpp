// SPDX-License-Identifier: Apache-2.0
// The page of settings in Chromium; built where that is installed.

#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "command/temporary_directory.h"
#include "demo/compare/pages.h"
#include "drawing/picture_file.h"

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
    render::Picture red = picture(kRed);
    std::ranges::copy(kBlue, red.rgb.begin());
    const std::string html = demo::settings_page(
        {.title = "test", .machine = "none", .width = 40, .height = 20, .frames = 1},
        {{"red", 1, 0, drawing::png_text(red)}, {"green", 1, 0, drawing::png_text(picture(kGreen))}},
        {{0, 1, 255, 255, drawing::png_text(picture(kBlue))}});
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

  /// Adds to the page what runs after its own script.
  void add_script(const std::string& script) const {
    std::string html = text("index.html");
    html.insert(html.rfind("</body>"), "<script>" + script + "</script>");
    std::ofstream(directory_.path() / "index.html") << html;
  }

  /// How many pixels of the screenshot are of a colour.
  int count(const Color& color) const {
    OIIO::ImageBuf shot((directory_.path() / "shot.png").string());
    EXPECT_TRUE(shot.read(0, 0, true, OIIO::TypeDesc::FLOAT)) << shot.geterror();
    int found = 0;
    for (OIIO::ImageBuf::ConstIterator<float> pixel(shot); !pixel.done(); ++pixel) {
      found += Color{pixel[0], pixel[1], pixel[2]} == color;
    }
    return found;
  }

  std::string text(const std::string& file) const {
    std::ifstream stream(directory_.path() / file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  TemporaryDirectory directory_;
};

TEST_F(SettingsPageInABrowser, WipesFromOnePictureToTheOtherAtPixelSize) {
  // At 16x the red picture begins 8 of its pixels, 128, left of the stage's middle: right of the first edge, and left
  // of the second.
  browse("mode=wipe&wipe=0.25&zoom=16&x=8&y=8", "--screenshot=shot.png");
  EXPECT_EQ(count(kRed), 0);
  EXPECT_EQ(count(kBlue), 0);
  EXPECT_GT(count(kGreen), 16 * 16 * 100);
  browse("mode=wipe&wipe=0.5&zoom=16&x=8&y=8", "--screenshot=shot.png");
  EXPECT_EQ(count(kBlue), 16 * 16) << "one pixel of the picture";
  EXPECT_GT(count(kRed), 16 * 16 * 100);
  EXPECT_GT(count(kGreen), 16 * 16 * 100);
}

TEST_F(SettingsPageInABrowser, FollowsKeysWheelAndPointer) {
  add_script(R"(
    const told = [];
    const tell = (what) => told.push(`${what}: ${state.mode} ${state.wipe.toFixed(2)} ${state.zoom}`);
    const box = () => stage.getBoundingClientRect();
    const pointer = (type, x, y) => stage.dispatchEvent(new PointerEvent(type, {clientX: x, clientY: y, bubbles: true}));
    stage.setPointerCapture = () => {};  // which takes no pointer that is none
    const key = (name) => document.body.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true}));
    const quarter = () => box().left + box().width / 4;
    pointer('pointerdown', quarter(), box().top + 5);
    pointer('pointerup', quarter(), box().top + 5);
    tell('click');
    key('d'); tell('d');
    key(' '); tell('space');
    key(' '); tell('space again');
    const middle = [box().left + box().width / 2, box().top + box().height / 2];
    stage.dispatchEvent(new WheelEvent('wheel', {deltaY: -1, clientX: middle[0], clientY: middle[1], cancelable: true}));
    tell('wheel');
    pointer('pointerdown', ...middle);
    pointer('pointermove', middle[0] + 64, middle[1]);
    pointer('pointerup', middle[0] + 64, middle[1]);
    told.push(`dragged to ${Math.round(state.x)}`);
    key('0'); tell('0');
    pointer('pointermove', box().left + 3, box().top + 3);
    setTimeout(() => {
      pointer('pointermove', box().left + 3, box().top + 3);
      const result = document.createElement('pre');
      result.textContent = told.concat(byId('pixel').value).join('|');
      document.body.append(result);
    }, 500);
  )");
  browse("", "--dump-dom");
  const std::string dom = text("dom");
  EXPECT_NE(
      dom.find("<pre>click: wipe 0.25 0|d: difference 0.25 0|space: a 0.25 0|space again: b 0.25 0|wheel: b 0.25 32|"
               "dragged to 18|0: b 0.25 0|pixel 0, 0: A 0 0 255, B 0 255 0</pre>"),
      dom.npos)
      << dom.substr(std::min(dom.rfind("<pre>"), dom.size()));
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
