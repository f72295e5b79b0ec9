// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "drawing/drawing_options.h"
#include "litfog/light.h"
#include "measure/triangle_tree.h"
#include "render/display.h"
#include "render/picture.h"
#include "render/plan/frame_counts.h"
#include "scene/scene.h"

namespace litfog::window {

/// An order for pictures of one view: one for each of a list of settings.
struct PictureOrder {
  std::vector<drawing::DrawingOptions> settings;  ///< all at one time; sizes are ignored
  scene::Camera camera;
  /// Replaces the scene's lights at time 0, in their order, with added ones at the end; never null.
  std::shared_ptr<const std::vector<PlacedLight>> lights;
  int width = 0;  ///< pixels
  int height = 0;
  bool is_sketch = false;  ///< soon replaced: an automatic exposure stays, or begins rough; no glare

  friend bool operator==(const PictureOrder&, const PictureOrder&) = default;
};

/// A picture as litfog-demo draws it.
struct DrawnPicture {
  render::Picture light;             ///< the scene's, before glare and exposure
  render::Picture shown;             ///< what a display shows, for drawing::write_picture
  std::vector<std::uint8_t> pixels;  ///< drawing::shown_pixels of `shown`
  drawing::Display display;          ///< an automatic exposure has been chosen
  render::FrameCounts counts;
  double milliseconds = 0;  ///< drawing alone, without changing settings and reading back
};

/// The result of an order.
struct Delivery {
  PictureOrder order;
  std::vector<DrawnPicture> pictures;  ///< one for each of the order's settings
  std::string error;                   ///< why there are no pictures; else empty
  double milliseconds = 0;             ///< total time
  bool is_rough = false;               ///< drawn by the path whose shaders compile soonest; final pictures follow
};

/// Draws pictures of a scene on its own thread, with its own GL context and without a display, so that a window stays
/// responsive however long a picture takes.
class PictureMaker {
 public:
  /// scene    as read, at time 0
  /// deliver  called on that thread when take() has a delivery
  PictureMaker(scene::Scene scene, std::function<void()> deliver);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// Draws these pictures next. An order not yet begun is dropped. A sketch also interrupts a full picture, so that a
  /// view that begins to move need not wait for it. A rough picture precedes the first sketch.
  void order(PictureOrder order);
  /// The last delivery, once. Throws what ended the thread: gl::Unsupported if there is no OpenGL 3.3.
  std::optional<Delivery> take();
  bool is_busy() const;
  /// The scene's surfaces. Null until some time after the first delivery, because a tree of millions of triangles takes
  /// seconds.
  const measure::TriangleTree* surfaces() const;
  /// GL_RENDERER, empty until the first delivery.
  std::string gl_renderer() const;

 private:
  void work();
  bool is_unwanted(const PictureOrder& begun) const;

  scene::Scene scene_;  // changed only by the thread
  std::function<void()> deliver_;
  mutable std::mutex mutex_;  // guards everything below except the thread
  std::condition_variable wake_;
  std::optional<PictureOrder> next_;
  std::optional<Delivery> delivery_;
  std::shared_future<measure::TriangleTree> surfaces_;
  std::exception_ptr end_;
  std::string gl_renderer_;
  bool is_busy_ = false;
  bool is_ended_ = false;
  std::thread thread_;  // last, because it uses the others
};

}  // namespace litfog::window
