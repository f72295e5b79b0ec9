// SPDX-License-Identifier: Apache-2.0
#include "window/picture_maker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "command/progress.h"
#include "drawing/drawing.h"
#include "drawing/picture_file.h"
#include "gl/gl_test.h"
#include "render/plan/lighting_path.h"
#include "scene/file/scene_file.h"

namespace litfog::test {
using namespace window;

namespace {

class PictureMakerTest : public GlTest {
 protected:
  PictureMakerTest() : scene_(scene::read_scene(scene::bundled_scene_path("room"))) {}

  PictureOrder order(int width, int height) const {
    PictureOrder order{.settings = {{}},
                       .camera = scene_.camera,
                       .lights = std::make_shared<const std::vector<PlacedLight>>(scene_.lights),
                       .width = width,
                       .height = height};
    order.settings[0].visibility = 40;
    order.settings[0].display.exposure = render::Exposure{};  // one that no earlier picture decides
    return order;
  }

  /// The next delivery that is not rough.
  static Delivery wait(PictureMaker& maker) {
    while (true) {
      if (auto delivery = maker.take(); delivery && !delivery->is_rough) return *delivery;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  /// As litfog-demo writes it, a sketch without glare.
  std::vector<std::uint8_t> drawn_by_demo(const PictureOrder& order, std::size_t which) const {
    scene::Scene scene = scene_;
    scene.camera = order.camera;
    scene.lights = *order.lights;
    drawing::DrawingOptions options = order.settings[which];
    if (order.is_sketch) options.display.glare = drawing::Glare::none;
    options.width = order.width;
    options.height = order.height;
    scene::move_to_time(scene, options.seconds);
    command::Progress progress;
    const drawing::Drawn drawn = drawing::draw(scene, options, {}, progress, 1, false, false);
    return drawing::shown_pixels(drawing::displayed(drawn.picture, scene.camera, drawn.display));
  }

  scene::Scene scene_;
};

TEST_F(PictureMakerTest, SketchNeedNotWaitForTheWholePictureBefore) {
  PictureMaker maker(scene_, [] {});
  maker.order(order(8, 8));
  wait(maker);  // all is uploaded
  maker.order(order(2400, 1350));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // it takes seconds
  PictureOrder sketch = order(48, 27);
  sketch.is_sketch = true;
  maker.order(sketch);
  const Delivery delivery = wait(maker);
  EXPECT_TRUE(delivery.order.is_sketch);
  EXPECT_EQ(delivery.pictures[0].pixels, drawn_by_demo(sketch, 0));
  EXPECT_FALSE(maker.is_busy());
}

TEST_F(PictureMakerTest, RoughPictureByVertexPrecedesTheFirstSketch) {
  std::vector<Delivery> taken;
  PictureMaker* self = nullptr;
  PictureMaker maker(scene_, [&] { taken.push_back(*self->take()); });
  self = &maker;
  PictureOrder sketch = order(48, 27);
  sketch.is_sketch = true;
  for (std::size_t done = 1; done <= 2; ++done) {
    maker.order(sketch);
    while (maker.is_busy()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ASSERT_EQ(taken.size(), done + 1);
    EXPECT_FALSE(taken.back().is_rough);
    EXPECT_EQ(taken.back().pictures[0].pixels, drawn_by_demo(sketch, 0));
  }
  EXPECT_TRUE(taken[0].is_rough);
  EXPECT_EQ(taken[0].order, sketch);
  PictureOrder by_vertex = sketch;
  by_vertex.settings[0].render.path = render::find_lighting_path("vertex");
  by_vertex.settings[0].render.samples = 1;
  EXPECT_EQ(taken[0].pictures[0].pixels, drawn_by_demo(by_vertex, 0));
}

TEST_F(PictureMakerTest, SurfacesAreKnownAfterTheFirstPicture) {
  PictureMaker maker(scene_, [] {});
  EXPECT_EQ(maker.surfaces(), nullptr);
  maker.order(order(8, 8));
  wait(maker);
  while (!maker.surfaces()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const glm::dvec3 eye = scene_.camera.position, forward = axes_of(scene_.camera).forward;
  const auto hit = maker.surfaces()->nearest(eye, forward, 0, 1e6);
  const auto expected = measure::TriangleTree(scene_).nearest(eye, forward, 0, 1e6);
  ASSERT_TRUE(hit && expected);
  EXPECT_EQ(hit->distance, expected->distance);
}

TEST_F(PictureMakerTest, PicturesAreThoseOfLitfogDemoWhateverHasBeenChanged) {
  PictureMaker maker(scene_, [] {});
  PictureOrder next = order(48, 27);
  const auto expect_same = [&](const char* change) {
    maker.order(next);
    const Delivery delivery = wait(maker);
    ASSERT_EQ(delivery.error, "") << change;
    ASSERT_EQ(delivery.pictures.size(), next.settings.size()) << change;
    for (std::size_t i = 0; i < next.settings.size(); ++i) {
      EXPECT_EQ(delivery.pictures[i].pixels, drawn_by_demo(next, i)) << change << ", " << i;
    }
  };
  expect_same("nothing");
  next.settings[0].visibility = 15;
  next.settings[0].phase = "hg:0.7";
  next.camera.position.y += 0.5f;
  next.camera.field_of_view = 0.6f;
  expect_same("fog and camera");
  next.width = 40;
  auto lights = *next.lights;
  lights[0].light.attenuation = {0.5, 0.1, 0.05};
  lights[0].light.color *= 2;
  next.lights = std::make_shared<const std::vector<PlacedLight>>(lights);
  next.settings[0].display = {.exposure = render::Exposure{.is_auto = true}, .tone = render::ToneCurve::clip};
  expect_same("size, a light and display");
  lights[1].light.color = glm::dvec3(0);
  lights.push_back(lights[0]);
  lights.back().position.x += 1;
  next.lights = std::make_shared<const std::vector<PlacedLight>>(lights);
  expect_same("a light more, and one removed");
  next.settings.push_back(next.settings[0]);
  next.settings[1].fog_light = render::FogLighting::peak;
  next.settings[1].fog = FogMode::exp2;
  next.settings[1].contrast = kContrastFlightgear;
  expect_same("two settings");
}

TEST_F(PictureMakerTest, TimeTurnsCookiesAsLitfogDemoDoes) {
  scene_ = scene::read_scene(scene::bundled_scene_path("cookies"));
  PictureMaker maker(scene_, [] {});
  PictureOrder next = order(48, 27);
  std::vector<std::uint8_t> before;
  for (const double seconds : {0.0, 3.0, 1.0}) {
    next.settings[0].seconds = seconds;
    maker.order(next);
    const auto pixels = wait(maker).pictures[0].pixels;
    EXPECT_EQ(pixels, drawn_by_demo(next, 0)) << seconds;
    EXPECT_NE(pixels, before);
    before = pixels;
  }
}

TEST_F(PictureMakerTest, SettingsThatExcludeEachOtherAreToldAndOthersAreDrawn) {
  PictureMaker maker(scene_, [] {});
  PictureOrder next = order(16, 9);
  next.settings[0].fog = FogMode::exp2;
  next.settings[0].layers = std::vector{FogLayer{.base = 0, .top = 5, .visibility = 20}};
  maker.order(next);
  EXPECT_NE(wait(maker).error.find("--fog = exp2: must be exp"), std::string::npos);
  next.settings[0].fog = FogMode::exp;
  maker.order(next);
  EXPECT_EQ(wait(maker).pictures[0].pixels, drawn_by_demo(next, 0));
}

TEST_F(PictureMakerTest, SketchKeepsTheAutomaticExposure) {
  PictureMaker maker(scene_, [] {});
  PictureOrder next = order(32, 18);
  next.settings[0].display.exposure = render::Exposure{.is_auto = true};
  maker.order(next);
  const double chosen = wait(maker).pictures[0].display.exposure.ev;
  next.settings[0].visibility = 3;
  next.is_sketch = true;
  maker.order(next);
  EXPECT_EQ(wait(maker).pictures[0].display.exposure.ev, chosen);
  next.is_sketch = false;
  maker.order(next);
  EXPECT_NE(wait(maker).pictures[0].display.exposure.ev, chosen);
}

TEST_F(PictureMakerTest, FirstSketchHasNearlyTheExposureOfTheWholePicture) {
  PictureMaker maker(scene_, [] {});
  PictureOrder next = order(160, 90);
  next.settings[0].display.exposure = render::Exposure{.is_auto = true};
  next.is_sketch = true;
  maker.order(next);
  const Delivery sketch = wait(maker);
  EXPECT_EQ(sketch.pictures[0].light.width, 160);
  next.is_sketch = false;
  maker.order(next);
  const double chosen = wait(maker).pictures[0].display.exposure.ev;
  EXPECT_NE(chosen, 0);
  EXPECT_NEAR(sketch.pictures[0].display.exposure.ev, chosen, 0.1);
}

TEST_F(PictureMakerTest, OrderThatHasNotBegunIsForgottenForTheNext) {
  std::atomic<int> deliveries = 0;
  PictureMaker maker(scene_, [&] { ++deliveries; });
  for (int width = 16; width <= 64; width += 2) maker.order(order(width, 9));
  while (wait(maker).order.width != 64) continue;
  EXPECT_LE(deliveries, 4);
  EXPECT_FALSE(maker.take());
}

TEST_F(PictureMakerTest, DragOfALightGivesUpTheWholePictureAndEndsWithTheLastLight) {
  std::atomic<int> deliveries = 0;
  PictureMaker maker(scene_, [&] { ++deliveries; });
  maker.order(order(8, 8));
  wait(maker);  // all is uploaded
  maker.order(order(2400, 1350));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // it takes seconds
  const auto with_light = [this](int step) {
    PictureOrder dragged = order(48, 27);
    auto lights = *dragged.lights;
    lights[0].light.attenuation.quadratic = 0.01 * step;
    lights[0].light.color *= 1 + step;
    dragged.lights = std::make_shared<const std::vector<PlacedLight>>(std::move(lights));
    return dragged;
  };
  constexpr int kSteps = 25;
  for (int step = 1; step <= kSteps; ++step) {
    PictureOrder sketch = with_light(step);
    sketch.is_sketch = true;
    maker.order(sketch);
  }
  const Delivery dragged = wait(maker);
  EXPECT_TRUE(dragged.order.is_sketch) << dragged.order.width;
  const PictureOrder last = with_light(kSteps);
  maker.order(last);
  Delivery shown = wait(maker);
  while (shown.order.is_sketch) shown = wait(maker);
  EXPECT_EQ(shown.pictures[0].pixels, drawn_by_demo(last, 0));
  EXPECT_NE(shown.pictures[0].pixels, drawn_by_demo(with_light(kSteps - 1), 0));
  EXPECT_LE(deliveries, 5);  // for 28 orders
  EXPECT_FALSE(maker.take());
  EXPECT_FALSE(maker.is_busy());
}

TEST_F(PictureMakerTest, SettingsThatTheMachineCannotDrawAreToldAndOthersAreDrawnAfterwards) {
  PictureMaker maker(scene_, [] {});
  maker.order(order(1'000'000, 9));
  const Delivery refused = wait(maker);
  EXPECT_NE(refused.error.find("this driver draws at most"), std::string::npos) << refused.error;
  EXPECT_TRUE(refused.pictures.empty());
  maker.order(order(16, 9));
  EXPECT_EQ(wait(maker).pictures.size(), 1u);
  EXPECT_EQ(maker.gl_renderer(), context().renderer());
}

}  // namespace

}  // namespace litfog::test
