// SPDX-License-Identifier: Apache-2.0
// litfog-demo window on a virtual X server, steered by its test events.

#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include "command/command_test.h"
#include "command/exit_status.h"
#include "litfog/runway_visual_range.h"

namespace litfog::test {
using namespace command;

namespace {

constexpr int kWidth = 960;
constexpr int kHeight = 480;

class WindowCommand : public CommandTest {
 protected:
  WindowCommand() : CommandTest(LITFOG_DEMO_PATH) {}
  ~WindowCommand() override {
    for (const int process : {window_, server_}) {
      if (process > 0) kill(process, SIGTERM);
    }
  }

  static bool can_be_steered() {
    const auto is_found = [](const std::string& path) { return !path.ends_with("NOTFOUND"); };
    return LITFOG_HAS_WINDOW && is_found(LITFOG_XVFB) && is_found(LITFOG_XDOTOOL);
  }

  /// Waits for a condition, a minute at most.
  template <typename Condition>
  static bool wait_for(const Condition& holds) {
    for (int i = 0; i < 1200; ++i) {
      if (holds()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return false;
  }

  /// Runs a line in a shell in the test's directory.
  int shell(const std::string& line) const {
    return std::system(("cd " + directory().string() + " && " + line).c_str());
  }

  /// Starts a program and returns its process.
  int start(const std::string& line) const {
    EXPECT_EQ(shell("{ " + line + " & echo $! >pid; }"), 0);
    return std::stoi(read("pid"));
  }

  void start_window(const std::string& arguments) {
    server_ = start(fmt::format("{} -displayfd 3 3>display -screen 0 {}x{}x24 -fbdir . -nolisten tcp >xvfb 2>&1",
                                LITFOG_XVFB, kWidth, kHeight));
    ASSERT_TRUE(wait_for([this] { return read("display").ends_with('\n'); })) << read("xvfb");
    start_on_display(arguments);
  }

  void start_on_display(const std::string& arguments) {
    window_ = start(fmt::format("XDG_CONFIG_HOME=$(pwd) DISPLAY=:{} {} window {} >said 2>window-errors",
                                read("display").substr(0, read("display").size() - 1), LITFOG_DEMO_PATH, arguments));
    steer("search --sync --onlyvisible --name litfog");
  }

  void end_window() {
    kill(window_, SIGTERM);
    const std::string search = "DISPLAY=:$(cat display) " LITFOG_XDOTOOL " search --onlyvisible --name litfog >xdotool";
    EXPECT_TRUE(wait_for([&] { return shell(search) != 0; }));
  }

  void steer(const std::string& events) const {
    ASSERT_EQ(shell("DISPLAY=:$(cat display) timeout 60 " LITFOG_XDOTOOL " " + events + " >xdotool 2>&1"), 0)
        << read("xdotool") << read("window-errors");
  }

  void click(int x, int y) const {
    steer(fmt::format("mousemove {} {} sleep 0.2 mousedown 1 sleep 0.2 mouseup 1 sleep 0.2", x, y));
  }

  /// The line that the window says next.
  std::string next_line() {
    const auto has_line = [this] { return read("said").find('\n', said_) != std::string::npos; };
    EXPECT_TRUE(wait_for(has_line)) << read("window-errors");
    const std::string said = read("said");
    const std::size_t end = std::min(said.find('\n', said_), said.size());
    std::string line = said.substr(said_, end - said_);
    said_ = end + 1;
    return line;
  }

  /// A pixel of the screen. Xvfb keeps it in a file of the format XWD.
  struct Screen {
    std::string file;

    std::uint32_t word(std::size_t index) const {
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::uint8_t(file.at(4 * index + i));
      return value;
    }
    /// RGB.
    std::array<int, 3> pixel(int x, int y) const {
      const std::size_t data = word(0) + 12 * word(19);  // the header, and the colour map's entries
      const std::size_t at = data + std::size_t(y) * word(12) + std::size_t(x) * 4;
      return {std::uint8_t(file.at(at + 2)), std::uint8_t(file.at(at + 1)), std::uint8_t(file.at(at))};
    }
  };
  Screen screen() const { return {read("Xvfb_screen0")}; }

  /// Levels of 1/255.
  std::vector<std::array<int, 3>> read_png(const std::string& name, int& width) const {
    OIIO::ImageBuf image((directory() / name).string());
    std::vector<std::array<int, 3>> pixels(std::size_t(image.spec().image_pixels()));
    std::vector<std::uint8_t> bytes(pixels.size() * 3);
    EXPECT_TRUE(image.get_pixels(image.roi(), OIIO::TypeDesc::UINT8, bytes.data())) << image.geterror();
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = {bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]};
    width = image.spec().width;
    return pixels;
  }

  /// Saves the window's picture, and expects it on the screen, and as the one that the window's command draws. Returns
  /// that.
  std::string expect_picture_of_command(const std::string& file) {
    steer("key ctrl+p");
    const std::string saved = next_line();
    steer("key ctrl+c");
    const std::string command = next_line();
    EXPECT_TRUE(saved.starts_with(file + ": ")) << saved;
    EXPECT_EQ(run(command.substr(command.find(' ')) + " -o headless.png").status, kDone) << command << read("err");
    int width = 0;
    int headless_width = 0;
    const auto window = read_png(file, width);
    const auto headless = read_png("headless.png", headless_width);
    EXPECT_EQ(window.size(), headless.size());
    EXPECT_EQ(width, headless_width);
    if (testing::Test::HasFailure()) return command;
    const Screen shown = screen();
    int largest = 0;
    int largest_shown = 0;
    int brightest = 0;
    for (std::size_t i = 0; i < headless.size(); ++i) {
      const int x = int(i) % width;
      const int y = int(i) / width;
      largest = std::max(largest, apart(window[i], headless[i]));
      largest_shown = std::max(largest_shown, apart(shown.pixel(kWidth - width + x, y), headless[i]));
      brightest = std::max(brightest, headless[i][0]);
    }
    EXPECT_LE(largest, 1);
    EXPECT_LE(largest_shown, 1);
    EXPECT_GT(brightest, 100);  // something is to be seen
    return command;
  }

  static int apart(const std::array<int, 3>& a, const std::array<int, 3>& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
  }

 private:
  int server_ = 0;
  int window_ = 0;
  std::size_t said_ = 0;
};

// Where the window shows the lamp of this scene at first.
constexpr int kLampX = 615;
constexpr int kLampY = 70;
constexpr const char* kScene = R"({"litfog": "scene", "version": 1, "name": "yard", "visibilities_m": [60],
  "camera": {"position": [0, 2, 9], "target": [0, 1.5, 0], "field_of_view_deg": 50},
  "environment": {"ambient": [0.1, 0.1, 0.12], "fog_color": [0.03, 0.03, 0.04], "sky_horizon": [0.1, 0.1, 0.1]},
  "lights": [{"light": {"name": "lamp", "attenuation": {"constant": 1, "quadratic": 0.05}},
              "position": [-1, 3, 0], "color": [3, 1.5, 0.5]}],
  "objects": [{"model": "box", "width_m": 2, "height_m": 1, "depth_m": 2, "position": [1, 0, 0]},
              {"model": "box", "width_m": 30, "height_m": 0.1, "depth_m": 30, "position": [0, -0.1, 0]}]})";

TEST_F(WindowCommand, SteeredWindowShowsAndSavesThePictureThatItsCommandDraws) {
  if (!can_be_steered()) GTEST_SKIP() << "litfog-window, Xvfb or xdotool is missing";
  write("yard.json", kScene);
  start_window(fmt::format("yard.json --size {}x{}", kWidth, kHeight));
  click(150, 144);        // the preset CAT II
  click(105, 398);        // scattering: single
  click(169, 423);        // shadows: surfaces
  click(kLampX, kLampY);  // which picks the lamp
  click(728, 334);        // its quadratic coefficient's slider
  click(338, 200);        // no lamp: nothing is marked any more
  steer("mousedown 1 mousemove 368 190 sleep 0.2 mousemove 408 185 sleep 0.2 mouseup 1");  // orbits
  steer("click 4 sleep 0.2 mousemove 20 470");  // approaches; then over nothing that is marked by it
  const std::string command = expect_picture_of_command("yard-1.png");
  const double cat_2 = visibility(fog_from_runway_visual_range(FogMode::exp, 300));
  ASSERT_TRUE(command.starts_with(
      fmt::format("litfog-demo yard.json --visibility {} --scattering single --shadows surfaces --camera ", cat_2)))
      << command;
  EXPECT_TRUE(has(command, " --set 'lights[0].attenuation.quadratic="));
}

TEST_F(WindowCommand, FalseColorsKeysAndThePickedLampAreDrawnAndTakenAway) {
  if (!can_be_steered()) GTEST_SKIP() << "litfog-window, Xvfb or xdotool is missing";
  write("yard.json", kScene);
  start_window(fmt::format("yard.json --size {}x{}", kWidth, kHeight));
  steer("mousemove 20 470 key ctrl+p");
  next_line();  // the whole picture is drawn
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const Screen plain = screen();
  // The fraction of the pixels about a point that are not as before.
  const auto changed = [&](int x, int y, int half_width, int half_height) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    const Screen now = screen();
    int count = 0;
    for (int j = y - half_height; j < y + half_height; ++j) {
      for (int i = x - half_width; i < x + half_width; ++i) count += apart(now.pixel(i, j), plain.pixel(i, j)) > 2;
    }
    return count / (4. * half_width * half_height);
  };
  const auto changed_picture = [&] { return changed(640, 108, 300, 100); };
  steer("key f");
  EXPECT_GT(changed_picture(), 0.9);
  steer("key f");
  EXPECT_EQ(changed_picture(), 0);
  steer("key F1");
  EXPECT_GT(changed_picture(), 0.1);
  steer("key F1");
  EXPECT_EQ(changed_picture(), 0);
  click(kLampX, kLampY);
  steer("mousemove 20 470");
  EXPECT_GT(changed(kLampX, kLampY, 60, 60), 0.01) << "its reach";
  EXPECT_GT(changed(700, 350, 200, 100), 0.05) << "its controls";
  EXPECT_GT(changed(925, 350, 25, 100), 0.01) << "what a ray gathers of it";
  click(338, 200);
  steer("mousemove 20 470");
  EXPECT_EQ(changed_picture(), 0);
}

TEST_F(WindowCommand, HistogramShowsTheLightOfThePictureThatItsCommandDraws) {
  if (!can_be_steered()) GTEST_SKIP() << "litfog-window, Xvfb or xdotool is missing";
  write("yard.json", kScene);
  start_window(fmt::format("yard.json --exposure 2 --size {}x{}", kWidth, kHeight));
  steer("key ctrl+p");
  next_line();  // the whole picture is drawn
  steer("mousemove 150 300 sleep 0.2 click --repeat 20 --delay 100 5 sleep 0.5 mousemove 20 470 sleep 0.5 key ctrl+c");
  std::string command = next_line();
  const std::string exposure = " --exposure 2";
  ASSERT_TRUE(has(command, exposure)) << command;
  command.erase(command.find(exposure), exposure.size());  // a file of light has none
  ASSERT_EQ(run(command.substr(command.find(' ')) + " -o light.exr").status, kDone) << command << read("err");
  OIIO::ImageBuf image((directory() / "light.exr").string());
  ASSERT_EQ(image.nchannels(), 3) << image.geterror();
  std::vector<float> light(std::size_t(image.spec().image_pixels()) * 3);
  ASSERT_TRUE(image.get_pixels(image.roi(), OIIO::TypeDesc::FLOAT, light.data())) << image.geterror();
  std::array<int, 64> counts{};  // a quarter of an EV each, from -12 to 4 EV above white
  for (std::size_t i = 0; i < light.size(); i += 3) {
    const double luminance = 0.2126 * double(light[i]) + 0.7152 * double(light[i + 1]) + 0.0722 * double(light[i + 2]);
    ++counts[std::size_t(std::clamp((std::log2(luminance) + 2 + 12) * 4, 0., 63.))];
  }
  const int most = std::ranges::max(counts);
  // Inside its frame, where the panel is scrolled to its end.
  constexpr double kLeft = 16, kRight = 295;
  constexpr int kTop = 246, kBottom = 282;
  const Screen shown = screen();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const int x = int(kLeft + (kRight - kLeft) * (double(i) + 0.5) / double(counts.size()));
    int height = 0;
    for (int y = kTop - 3; y < kBottom + 3; ++y) {
      const auto [red, green, blue] = shown.pixel(x, y);
      height += red > 150 && blue < 80;  // a bar's yellow
    }
    EXPECT_NEAR(height, (kBottom - kTop) * double(counts[i]) / most, 1.5) << "bar " << i;  // whole pixels at both ends
  }
  EXPECT_GT(std::ranges::count_if(counts, [most](int count) { return count > most / 10; }), 8) << "its bars differ";
}

TEST_F(WindowCommand, KeysFlyToAWallAndNotThroughIt) {
  if (!can_be_steered()) GTEST_SKIP() << "litfog-window, Xvfb or xdotool is missing";
  std::string walled = kScene;
  const std::string box = R"({"model": "box", "width_m": 2, "height_m": 1, "depth_m": 2, "position": [1, 0, 0]})";
  walled.replace(walled.find(box), box.size(),
                 R"({"model": "box", "width_m": 30, "height_m": 9, "depth_m": 0.1, "position": [0, 0, 3]})");
  write("yard.json", walled);
  start_window(fmt::format("yard.json --size {}x{}", kWidth, kHeight));
  steer("key ctrl+p");
  next_line();  // the whole picture is drawn, and the surfaces are known
  std::this_thread::sleep_for(std::chrono::seconds(1));
  steer("mousemove 600 150 sleep 0.2 keydown w sleep 4 keyup w sleep 0.2 key ctrl+c");  // 4.5 m a second at first
  const std::string command = next_line();
  const std::string option = "--camera ";
  ASSERT_TRUE(has(command, option));
  double x = 0, y = 0, z = 0;
  ASSERT_EQ(std::sscanf(command.c_str() + command.find(option) + option.size(), "%lf,%lf,%lf", &x, &y, &z), 3)
      << command;
  EXPECT_GT(z, 3.05);
  EXPECT_LT(z, 6) << "it has come near";
}

TEST_F(WindowCommand, LampsAreAddedMovedRemovedAndAllOfItIsUndone) {
  if (!can_be_steered()) GTEST_SKIP() << "litfog-window, Xvfb or xdotool is missing";
  write("yard.json", kScene);
  start_window(fmt::format("yard.json --size {}x{}", kWidth, kHeight));
  click(348, 279);  // the lamp's line in the list
  click(495, 260);  // adds a copy of it
  steer(
      "mousemove 600 150 sleep 0.2 keydown ctrl mousedown 1 mousemove 620 140 sleep 0.2 mousemove 690 110 sleep 0.2 "
      "mouseup 1 keyup ctrl");
  click(348, 279);
  steer("key Delete sleep 0.2 mousemove 20 470");
  const std::string command = expect_picture_of_command("yard-1.png");
  EXPECT_TRUE(has(command, R"( --set 'lights[1]={"light":{"name":"lamp",)"));
  EXPECT_TRUE(has(command, " --set 'lights[0]=null'"));
  steer("key ctrl+z sleep 0.2 key ctrl+z sleep 0.2 key ctrl+z sleep 0.2 key ctrl+c");
  EXPECT_FALSE(has(next_line(), "--set"));
}

TEST_F(WindowCommand, ScenesAreOpenedAndReadAgainAndPanelsKeepTheirSizes) {
  if (!can_be_steered()) GTEST_SKIP() << "litfog-window, Xvfb or xdotool is missing";
  const auto scene = [](const std::string& name, const std::string& color) {
    std::string text = kScene;
    text.replace(text.find("yard"), 4, name);
    return text.replace(text.find("[3, 1.5, 0.5]"), 13, color);
  };
  write("yard.json", kScene);
  write("other.json", scene("other", "[0.5, 1.5, 3]"));
  start_window(fmt::format("yard.json --size {}x{}", kWidth, kHeight));
  click(100, 20);  // the list of scenes
  click(100, 48);  // the field in it for a path
  steer("type other.json");
  steer("sleep 1 key Return");  // at once, slow frames would lose it
  EXPECT_TRUE(wait_for([this] {
    steer("key ctrl+c");
    return next_line().starts_with("litfog-demo other.json");
  }));
  EXPECT_TRUE(read("litfog/recent").ends_with("/yard.json\n")) << read("litfog/recent");
  EXPECT_TRUE(has(read("litfog/recent"), "/other.json\n"));

  std::filesystem::create_directory(directory() / "deep");
  write("deep/deep.json", scene("deep", "[1, 1, 1]"));
  click(100, 20);
  click(100, 73);  // browses files
  click(236, 91);  // the first folder
  click(236, 91);  // its only file
  EXPECT_TRUE(wait_for([this] {
    steer("key ctrl+c");
    return has(next_line(), "/deep/deep.json ");
  }));
  click(100, 20);
  click(100, 73);
  click(236, 72);   // the folder above
  click(236, 129);  // a file in it, after the folders deep and litfog
  EXPECT_TRUE(wait_for([this] {
    steer("key ctrl+c");
    return has(next_line(), "/other.json ");
  }));

  write("other.json", scene("other", "[3, 0.5, 0.5]"));
  std::this_thread::sleep_for(std::chrono::seconds(3));  // it looks twice a second
  steer("mousemove 20 470");
  expect_picture_of_command("other-1.png");

  steer(
      "mousemove 321 200 sleep 0.2 mousedown 1 sleep 0.2 mousemove 350 200 sleep 0.2 mousemove 371 200 sleep 0.2 "
      "mouseup 1");
  EXPECT_TRUE(wait_for([this] { return read("litfog/window.ini").find("Size=37") != std::string::npos; }))
      << read("litfog/window.ini");
}

TEST_F(WindowCommand, WindowOpensInTheSizeThatItLastHadOrInTheOneGiven) {
  if (!can_be_steered()) GTEST_SKIP() << "litfog-window, Xvfb or xdotool is missing";
  write("yard.json", kScene);
  const auto has_size = [this](const std::string& size) {
    return wait_for([&] {
      steer("search --onlyvisible --name litfog getwindowgeometry");
      return has(read("xdotool"), "Geometry: " + size + "\n");
    });
  };
  start_window("yard.json --size 900x440");
  EXPECT_TRUE(has_size("900x440")) << read("xdotool");
  steer("search --onlyvisible --name litfog windowsize 700 400");
  EXPECT_TRUE(wait_for([this] { return has(read("litfog/window.ini"), "Size=700,400\n"); }))
      << read("litfog/window.ini");
  end_window();
  start_on_display("yard.json");
  EXPECT_TRUE(has_size("700x400")) << read("xdotool");
  end_window();
  start_on_display("yard.json --size 640x360");
  EXPECT_TRUE(has_size("640x360")) << read("xdotool");
}

TEST_F(WindowCommand, WindowWithoutADisplayIsAMissingCapability) {
  if (!LITFOG_HAS_WINDOW) GTEST_SKIP() << "litfog-window was not built";
  write("yard.json", kScene);
  EXPECT_ERROR(run("window yard.json", "env -u WAYLAND_DISPLAY -u DISPLAY"), kMissingCapability,
               "litfog-window: a window needs a display: X11: The DISPLAY environment variable is missing\n");
}

TEST_F(WindowCommand, MissingLibraryOfTheWindowIsNamedWithItsPackage) {
  if (!LITFOG_HAS_WINDOW) GTEST_SKIP() << "litfog-window was not built";
  write("libglfw.so.3", "no library");
  EXPECT_ERROR(run("window yard.json", "LD_LIBRARY_PATH=."), kMissingCapability,
               "litfog-demo: litfog-window needs libglfw.so.3, which cannot be loaded (install libglfw3)\n");
}

TEST_F(WindowCommand, WrongSceneAndWrongOptionsAreToldBeforeAWindowOpens) {
  if (!LITFOG_HAS_WINDOW) GTEST_SKIP() << "litfog-window was not built";
  write("wrong.json", R"({"litfog": "scene", "version": 1})");
  EXPECT_EQ(run("window wrong.json").status, kBadInput);
  EXPECT_EQ(run("window wrong.json --visibility -1").status, kUsage);
  EXPECT_EQ(run("window").status, kUsage);
}

TEST_F(WindowCommand, HelpIsThatOfTheProgramThatHasTheOptions) {
  if (!LITFOG_HAS_WINDOW) GTEST_SKIP() << "litfog-window was not built";
  const Outcome help = expect_done("window --help");
  EXPECT_TRUE(has(help.out, "litfog-window [OPTIONS]"));
  EXPECT_TRUE(has(help.out, "--visibility NUMBER"));
}

TEST_F(WindowCommand, CommandWithoutItsWindowSaysSo) {
  std::filesystem::copy_file(LITFOG_DEMO_PATH, directory() / "litfog-demo");
  ASSERT_EQ(shell("{ ./litfog-demo window room; echo $? >status; } >out 2>err"), 0);
  EXPECT_EQ(read("status"), fmt::format("{}\n", int(kMissingCapability)));
  EXPECT_TRUE(has(read("err"),
                  "litfog-window cannot be started: No such file or directory (it is built where "
                  "libglfw3-dev and libimgui-dev are installed)"));
}

}  // namespace

}  // namespace litfog::test
