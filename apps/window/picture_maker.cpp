// SPDX-License-Identifier: Apache-2.0
#include "window/picture_maker.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <utility>

#include "command/command.h"
#include "command/wall_timer.h"
#include "drawing/drawing.h"
#include "drawing/picture_file.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"
#include "render/renderer.h"

namespace litfog::window {
namespace {

/// A renderer that is kept as long as its settings stay, and its last state.
class KeptRenderer {
 public:
  /// Sets the renderer to draw an order.
  void set(const scene::Scene& scene, const PictureOrder& order, const drawing::DrawingOptions& options) {
    const render::RenderSettings settings = options.settings();
    if (!renderer_ || renderer_->settings() != settings) {
      renderer_.reset();  // frees its memory before another takes as much
      renderer_.emplace(scene, order.width, order.height, settings);
    } else {
      const bool has_size = renderer_->width() == order.width && renderer_->height() == order.height;
      if (!has_size) renderer_->set_size(order.width, order.height);
      const bool are_casters_stale =
          settings.shadows != render::Shadows::none && order.camera.position != camera_.position;
      if (order.lights != lights_ || scene.seconds != seconds_ || are_casters_stale) renderer_->set_lights();
    }
    seconds_ = scene.seconds;
    camera_ = order.camera;
    lights_ = order.lights;
    const Atmosphere atmosphere = options.atmosphere_of(scene, options.visibility_in(scene));
    if (atmosphere != renderer_->atmosphere()) renderer_->set_atmosphere(atmosphere);
  }

  /// is_unwanted  Renderer::interrupt_when
  DrawnPicture draw(const drawing::Display& display, bool is_sketch, std::function<bool()> is_unwanted) {
    renderer_->interrupt_when(std::move(is_unwanted));
    render::Exposure exposure = display.exposure;
    if (exposure.is_auto && is_sketch) {
      if (!chosen_) chosen_ = rough_exposure();
      renderer_->set_exposure({.ev = *chosen_});
      exposure.ev = *chosen_;
    } else {
      exposure = renderer_->set_exposure(exposure);
      if (exposure.is_auto) chosen_ = exposure.ev;
    }
    DrawnPicture drawn;
    drawn.display = {
        .exposure = exposure, .tone = display.tone, .glare = is_sketch ? drawing::Glare::none : display.glare};
    command::WallTimer timer;
    drawn.counts = renderer_->draw();
    drawn.milliseconds = timer.milliseconds();
    renderer_->interrupt_when({});  // an interruption would leave it drawing in floats
    drawn.light = renderer_->read();
    if (!is_sketch) drawn.light = drawing::whole_light(*renderer_, std::move(drawn.light));
    drawn.shown = drawing::displayed(drawn.light, camera_, drawn.display);
    drawn.pixels = drawing::shown_pixels(drawn.shown);
    return drawn;
  }

 private:
  /// The automatic exposure at a quarter of the width and height, but kLeastWidth at least, wrong by up to 0.1 EV.
  /// Saves a fifth of the first sketch's work.
  double rough_exposure() {
    const int width = renderer_->width(), height = renderer_->height();
    constexpr int kLeastWidth = 80;
    const int part = std::clamp(width / kLeastWidth, 1, 4);
    renderer_->set_size(std::max(width / part, 1), std::max(height / part, 1));
    const double ev = renderer_->set_exposure({.is_auto = true}).ev;
    renderer_->set_size(width, height);
    return ev;
  }

  std::optional<render::Renderer> renderer_;
  scene::Camera camera_;
  std::shared_ptr<const std::vector<PlacedLight>> lights_;
  double seconds_ = 0;
  std::optional<double> chosen_;  // the last automatic exposure
};

/// The settings whose shaders compile soonest.
drawing::DrawingOptions roughened(drawing::DrawingOptions options) {
  options.render.path = render::find_lighting_path("vertex");
  options.render.shadows = render::Shadows::none;
  options.render.samples = 1;
  return options;
}

}  // namespace

PictureMaker::PictureMaker(scene::Scene scene, std::function<void()> deliver)
    : scene_(std::move(scene)), deliver_(std::move(deliver)), thread_([this] { work(); }) {}

PictureMaker::~PictureMaker() {
  {
    const std::lock_guard lock(mutex_);
    is_ended_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void PictureMaker::order(PictureOrder order) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(order);
  }
  wake_.notify_one();
}

std::optional<Delivery> PictureMaker::take() {
  const std::lock_guard lock(mutex_);
  if (end_) std::rethrow_exception(std::exchange(end_, nullptr));
  return std::exchange(delivery_, std::nullopt);
}

const measure::TriangleTree* PictureMaker::surfaces() const {
  const std::lock_guard lock(mutex_);
  const bool is_ready = surfaces_.valid() && surfaces_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  return is_ready ? &surfaces_.get() : nullptr;
}

bool PictureMaker::is_busy() const {
  const std::lock_guard lock(mutex_);
  return is_busy_ || next_;
}

bool PictureMaker::is_unwanted(const PictureOrder& begun) const {
  const std::lock_guard lock(mutex_);
  return is_ended_ || (next_ && next_->is_sketch && !begun.is_sketch);
}

std::string PictureMaker::gl_renderer() const {
  const std::lock_guard lock(mutex_);
  return gl_renderer_;
}

void PictureMaker::work() try {
  const gl::HeadlessContext context;
  std::shared_ptr<const std::vector<PlacedLight>> lights;
  scene::Scene& scene = scene_;
  const auto cookie_uses = scene.cookie_uses;
  std::deque<KeptRenderer> renderers;  // resizing a deque moves none
  std::unique_lock lock(mutex_);
  gl_renderer_ = context.renderer();
  while (true) {
    is_busy_ = false;
    wake_.wait(lock, [this] { return next_ || is_ended_; });
    if (is_ended_) return;
    Delivery delivery{.order = *std::exchange(next_, std::nullopt), .pictures = {}, .error = {}};
    is_busy_ = true;
    lock.unlock();

    command::WallTimer timer;
    const PictureOrder& order = delivery.order;
    if (const double seconds = order.settings[0].seconds; order.lights != lights || seconds != scene.seconds) {
      lights = order.lights;
      scene.lights = *lights;
      scene.cookie_uses = cookie_uses;
      scene::move_to_time(scene, seconds);
    }
    scene.camera = order.camera;
    const auto hand_over = [&](Delivery done) {
      done.milliseconds = timer.milliseconds();
      lock.lock();
      delivery_ = std::move(done);
      lock.unlock();
      deliver_();
    };
    const bool is_first_sketch = renderers.empty() && order.is_sketch;
    renderers.resize(order.settings.size());
    try {
      if (is_first_sketch) {
        Delivery rough{.order = order, .pictures = {}, .error = {}, .is_rough = true};
        try {
          for (const drawing::DrawingOptions& given : order.settings) {
            const drawing::DrawingOptions options = roughened(given);
            KeptRenderer renderer;
            renderer.set(scene, order, options);
            rough.pictures.push_back(renderer.draw(options.display.display_for(scene, options.settings().fog_lighting),
                                                   true, [this, &order] { return is_unwanted(order); }));
          }
          hand_over(std::move(rough));
        } catch (const gl::Unsupported&) {  // the final pictures may need less
        }
        timer = {};
      }
      for (std::size_t i = 0; i < renderers.size(); ++i) {
        const drawing::DrawingOptions& options = order.settings[i];
        renderers[i].set(scene, order, options);
        delivery.pictures.push_back(
            renderers[i].draw(options.display.display_for(scene, options.settings().fog_lighting), order.is_sketch,
                              [this, &order] { return is_unwanted(order); }));
      }
    } catch (const render::Interrupted&) {
      lock.lock();
      continue;
    } catch (const gl::Unsupported& missing) {  // other settings may work
      delivery.pictures.clear();
      delivery.error = missing.what();
      renderers.clear();
    } catch (const CLI::Error& wrong) {  // settings that exclude each other
      delivery.pictures.clear();
      delivery.error = wrong.what();
    }
    hand_over(std::move(delivery));
    lock.lock();
    // Reads only members of the scene that this thread does not change.
    if (!surfaces_.valid())
      surfaces_ = std::async(std::launch::async, [&scene] { return measure::TriangleTree(scene); });
  }
} catch (...) {
  {
    const std::lock_guard lock(mutex_);
    end_ = std::current_exception();
    is_busy_ = false;
  }
  deliver_();
}

}  // namespace litfog::window
