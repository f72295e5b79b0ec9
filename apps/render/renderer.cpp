// SPDX-License-Identifier: Apache-2.0
#include "render/renderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <span>

#include "litfog/fog_light_block.h"
#include "litfog/gl/check_errors.h"
#include "render/gpu/light_uniforms.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/texture_unit.h"
#include "render/gpu/uniform.h"
#include "render/light/light_map_store.h"
#include "render/light/light_point.h"
#include "render/plan/fog_top.h"

namespace litfog::render {
namespace {

std::size_t entries_in(std::span<const EntryRange> ranges) {
  std::size_t entries = 0;
  for (const EntryRange& range : ranges) entries += range.end - range.begin;
  return entries;
}

/// Optionally times the stages of a frame.
class StageClock {
 public:
  explicit StageClock(StageTimes* times) : times_(times) {}

  /// Waits for the GPU to finish a stage, and records its time.
  void end(double StageTimes::*stage) {
    if (!times_) return;
    glFinish();
    const auto now = Clock::now();
    times_->*stage += std::chrono::duration<double, std::milli>(now - begin_).count();
    begin_ = now;
  }

 private:
  using Clock = std::chrono::steady_clock;
  StageTimes* times_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace

bool is_cut_off(const Picture& picture) {
  constexpr float kMaxHalf = 65'504;
  return std::ranges::any_of(picture.rgb, [](float light) { return light >= kMaxHalf; });
}

Renderer::Renderer(const scene::Scene& scene, int width, int height, const RenderSettings& settings)
    : scene_(scene),
      settings_(settings),
      framebuffer_(width, height, passes(), settings.samples),
      lights_(scene, settings),
      cookie_cones_(lights_.cookie_cones().data(), lights_.cookie_cones().size_bytes(), BufferTexture::Texel::float4),
      surfaces_(scene, lights_, fog_block_, settings),
      planner_(scene, lights_, surfaces_.surfaces(), settings),
      sky_(scene, fog_block_),
      light_point_program_(point_shaders(settings.fog_lighting).vertex, point_shaders(settings.fog_lighting).fragment,
                           scene_shaders(!scene.cookies.empty())) {
  gl::check_fog_light_layout(light_point_program_);
  if (settings.shadows != Shadows::none) {
    shadows_.emplace(scene, lights_, surfaces_.surfaces(), framebuffer_.aspect(), settings);
  }
  if (settings.fog_lighting == FogLighting::airlight) {
    airlight_.emplace(fog_block_, sampler_states_, framebuffer_.samples(), settings);
    airlight_->set_size({width, height});
  }
  if (!scene.cookies.empty()) cookies_ = upload_cookies(scene.cookies);
  set_atmosphere(scene.atmosphere);
  gl::check_errors("uploading the scene");
}

void Renderer::set_size(int width, int height) {
  set_framebuffer(width, height, passes());
  gl::check_errors("making a picture of another size");
}

void Renderer::set_framebuffer(int width, int height, Passes passes) {
  framebuffer_ = Framebuffer(width, height, passes, settings_.samples);
  if (airlight_) airlight_->set_size({width, height});
}

void Renderer::Airlight::set_size(glm::ivec2 size) {
  seen.set_size(size);
  pyramid.set_size(size);
}

Picture Renderer::draw_in_floats() {
  set_framebuffer(width(), height(), Passes::several);
  draw();
  Picture picture = read();
  set_framebuffer(width(), height(), passes());
  return picture;
}

void Renderer::set_lights() { set_lights_for(lights_.exposure()); }

void Renderer::set_lights_for(double ends_exposure) {
  lights_ = SceneLights(scene_, settings_, ends_exposure);
  light_tables_ = {};  // forces an upload of all tables
  cookie_cones_ =
      BufferTexture(lights_.cookie_cones().data(), lights_.cookie_cones().size_bytes(), BufferTexture::Texel::float4);
  surfaces_.set_lights();
  if (shadows_) shadows_.emplace(scene_, lights_, surfaces_.surfaces(), framebuffer_.aspect(), settings_);
  set_atmosphere(atmosphere_);
}

void Renderer::set_atmosphere(const Atmosphere& atmosphere) {
  const Atmosphere relative = atmosphere.seen_from(lights_.origin().y);  // heights as in shaders and plans
  const FogHeader header = pack_fog_header(relative, 0);
  atmosphere_ = atmosphere;
  solved_fog_ = fog_at_eye();
  const FogLightChanges changes = lights_.set_fog(solved_fog_);
  light_tables_.upload(lights_.kinds(), lights_.instances(), changes);
  fog_bytes_ = sizeof(FogHeader) + entries_in(changes.kinds) * sizeof(FogLightKind) +
               entries_in(changes.instances) * sizeof(FogLightInstance);
  fog_block_.upload(header);
  surfaces_.set_fog(atmosphere.profile.count);
  const bool has_shafts = settings_.shadows == Shadows::shafts;
  planner_.set_atmosphere(relative, !fog_lights(lights_, Skipping::on).empty(),
                          has_shafts ? shadows_->caster_of_lights() : std::span<const std::int32_t>());
}

Exposure Renderer::set_exposure(const Exposure& exposure) {
  exposure_ = exposure.ev;
  if (exposure.is_auto) {
    // Surfaces are drawn for the largest exposure. Airlight would take too long so: it is drawn for 0 EV and, if the
    // exposure found is higher, again for that exposure.
    draw_for({.surfaces = kMaxExposure, .airlight = 0}, LightPoints::off);
    exposure_ = auto_exposure(read());
    if (exposure_ > 0) {
      draw_for({.surfaces = kMaxExposure, .airlight = exposure_}, LightPoints::off);
      exposure_ = auto_exposure(read());
    }
  }
  // Lights end where the next whole EV requires, so that small changes of the exposure leave all lists as they are.
  const double ends_exposure = std::ceil(std::max(exposure_, 0.0));
  if (settings_.fog_lighting == FogLighting::airlight && ends_exposure != lights_.exposure()) {
    set_lights_for(ends_exposure);
  }
  return {.ev = exposure_, .is_auto = exposure.is_auto};
}

FrameLight Renderer::frame_light() const {
  return {.shadows = shadows(), .scattered = airlight_ && airlight_->scattered ? &*airlight_->scattered : nullptr};
}

View Renderer::view() const {
  View view = view_of(relative_to(lights_.origin(), scene_.camera), {width(), height()},
                      atmosphere_.top_above(scene_.camera.position.y));
  view.is_fog_moonlit = is_fog_moonlit(scene_.environment, atmosphere_, settings_.fog_lighting);
  view.light_top = atmosphere_.light_top() - lights_.origin().y;
  return view;
}

FrameView Renderer::frame_view(const View& view, const FrameExposures& exposures) const {
  const scene::Camera camera = relative_to(lights_.origin(), scene_.camera);
  constexpr double kRight = std::numbers::pi / 2;
  const double pitch = std::asin(std::clamp(axes_of(camera).forward.y, -1.0, 1.0));
  return {.camera = camera,
          .clip_from_world = view.clip_from_world,
          .highest_slope = std::sin(std::min(pitch + double(camera.field_of_view) / 2, kRight)),
          .picture_size = {width(), height()},
          .pixels_per_radian = view.pixels_per_radian,
          .exposures = exposures};
}

void Renderer::follow_camera() {
  if (scene::local_origin(scene_.camera.position) != lights_.origin()) {
    set_lights();
  } else if (fog_at_eye() != solved_fog_) {
    set_atmosphere(atmosphere_);
  }
}

FrameStatistics Renderer::draw_and_measure() {
  follow_camera();
  FrameStatistics statistics;
  statistics.fog_bytes_uploaded = fog_bytes_;
  planner_.forget();
  statistics.counts = draw_stages({exposure_, exposure_}, LightPoints::on, &statistics);
  // Counted last: the driver frees the counts' picture in the next draw, which would add to a stage's time.
  statistics.lights_per_fragment = count_lights_per_fragment();
  return statistics;
}

double Renderer::count_lights_per_fragment() {
  const View view = this->view();
  FramePlan plan = planner_.plan(frame_view(view, {exposure_, exposure_}));
  for (PlannedSurface& surface : plan.surfaces) surface.is_fog_alone = false;
  const Framebuffer counts(width(), height(), Passes::several, samples());  // floats, because half floats end at 65,504
  begin_frame(counts, glm::vec3(0));
  Interruption whole;
  surfaces_.draw(light_count_path(), plan, view, {}, whole);
  end_depths();
  counts.resolve();
  const Picture counted = counts.read();
  double lights = 0;
  double fragments = 0;
  for (std::size_t i = 0; i < counted.rgb.size(); i += 3) {
    lights += double(counted.rgb[i]);
    fragments += double(counted.rgb[i + 1]);
  }
  return fragments > 0 ? lights / fragments : 0;
}

void Renderer::begin_frame(const Framebuffer& framebuffer, const glm::vec3& background) {
  framebuffer.bind();
  glClearColor(background.r, background.g, background.b, 1);
  glEnable(GL_CULL_FACE);
  glClear(GL_COLOR_BUFFER_BIT);
  begin_depths();
}

std::size_t Renderer::upload_lists(const FramePlan& plan) {
  const std::size_t bytes = std::span(plan.light_list).size_bytes();
  light_list_.emplace(plan.light_list.data(), bytes, BufferTexture::Texel::int1);
  if (!airlight_) return bytes;
  airlight_->lights.set(plan.airlights, plan.airlight_tiles);
  airlight_->higher_orders.set(plan.higher_orders);
  airlight_->far.set_list(plan.far_airlights, airlight_->higher_orders);
  return bytes + std::span(plan.airlights.entries).size_bytes() + std::span(plan.airlight_tiles.lists).size_bytes() +
         std::span(plan.far_airlights.lights).size_bytes();
}

FrameCounts Renderer::draw_stages(const FrameExposures& exposures, LightPoints light_points,
                                  FrameStatistics* statistics) {
  follow_camera();
  StageClock clock(statistics ? &statistics->times : nullptr);
  const View view = this->view();
  const FramePlan& plan = planner_.plan(frame_view(view, exposures));
  FrameCounts counts = plan.counts;
  if (planner_.has_changed()) counts.bytes_uploaded += upload_lists(plan);
  clock.end(&StageTimes::plan);
  if (shadows_) counts.shadow_maps_drawn = shadows_->draw(framebuffer_.aspect());
  light_tables_.bind_textures(kKindBufferUnit, kInstanceBufferUnit);
  light_list_->bind(kLightListUnit);
  if (cookies_) cookies_->bind(kCookieUnit);
  cookie_cones_.bind(kCookieConeUnit);
  if (shadows_) shadows_->bind();
  clock.end(&StageTimes::surfaces);
  framebuffer_.bind();
  sampler_states_.set();
  if (airlight_) airlight_->far.draw({width(), height()}, view, atmosphere_);
  if (airlight_ && airlight_->scattered) {
    airlight_->scattered->draw({width(), height()}, view, atmosphere_, airlight_->far, airlight_->higher_orders);
  }
  clock.end(&StageTimes::airlight);
  framebuffer_.bind();
  sampler_states_.set();
  begin_frame(framebuffer_, atmosphere_.ambient_fog_color);  // SkyDrawing::background
  Interruption interruption(is_unwanted_);
  counts.bytes_uploaded += surfaces_.draw(*settings_.path, plan, view, frame_light(), interruption);
  if (interruption.has_come()) {
    end_depths();
    throw Interrupted{};
  }
  clock.end(&StageTimes::surfaces);
  glDepthMask(GL_FALSE);
  sky_.draw(view, counts.sky, lights_.carried_count());
  clock.end(&StageTimes::sky);
  if (light_points == LightPoints::on) draw_light_points(view, plan);
  clock.end(&StageTimes::points);
  if (has_panes()) counts.bytes_uploaded += draw_panes(view, plan);
  end_depths();
  clock.end(&StageTimes::panes);
  framebuffer_.resolve();
  clock.end(&StageTimes::resolve);
  if (airlight_ && (airlight_->lights.size() > 0 || !airlight_->far.is_empty())) {
    draw_airlight(view, exposures.airlight, interruption);
    if (interruption.has_come()) throw Interrupted{};
  }
  clock.end(&StageTimes::airlight);
  glFinish();
  gl::check_errors("drawing a frame");
  if (statistics) statistics->lights = planner_.count_lights();
  return counts;
}

void Renderer::draw_geometry(const GeometryBuffer& geometry) {
  follow_camera();
  geometry.begin();
  glEnable(GL_CULL_FACE);
  Interruption whole;
  const View view = this->view();
  surfaces_.draw(geometry_path(*settings_.path), planner_.plan_geometry(view.clip_from_world), view, {}, whole);
  geometry.end();
  gl::check_errors("drawing the geometry");
}

void Renderer::draw_pane_geometry(const GeometryBuffer& geometry, int layer) {
  follow_camera();
  geometry.begin_layer(layer);
  glEnable(GL_CULL_FACE);
  const View view = this->view();
  surfaces_.draw_panes(geometry_path(*settings_.path), planner_.plan_geometry(view.clip_from_world), view, {}, nullptr);
  geometry.end();
  gl::check_errors("drawing the geometry of panes");
}

std::size_t Renderer::draw_panes(const View& view, const FramePlan& plan) {
  const auto airlight = airlight_ ? std::optional(PaneAirlight{airlight_->lights, airlight_->far}) : std::nullopt;
  Compositor::begin_panes();
  const std::size_t bytes =
      surfaces_.draw_panes(*settings_.path, plan, view, frame_light(), airlight ? &*airlight : nullptr);
  Compositor::end_panes();
  return bytes;
}

void Renderer::draw_airlight(const View& view, double exposure, Interruption& interruption) {
  airlight_->seen.draw(framebuffer_, view);
  airlight_->pyramid.draw({.lights = airlight_->lights,
                           .higher_orders = airlight_->higher_orders,
                           .seen = airlight_->seen,
                           .view = view,
                           .atmosphere = atmosphere_,
                           .exposure = exposure},
                          interruption);
  compositor_.add_airlight(framebuffer_, airlight_->pyramid.airlight(), airlight_->far, airlight_->seen, view,
                          has_panes());
}

void Renderer::draw_light_points(const View& view, const FramePlan& plan) {
  if (plan.point_count == 0) return;
  light_point_program_.use();
  bind_lights(light_point_program_, fog_block_);
  set_uniform(light_point_program_, "light_list", kLightListUnit);
  if (airlight_) set_uniform(light_point_program_, "first_radius", plan.point_first + plan.point_count);
  render::draw_light_points(light_point_program_, view, settings_.fog_lighting, plan.point_first, plan.point_count);
}

}  // namespace litfog::render
