// SPDX-License-Identifier: Apache-2.0
#include "papers/opengl_pictures.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "litfog/cone.h"
#include "litfog/gl/check_errors.h"
#include "litfog/gl/gl_name.h"
#include "measure/frame_times.h"
#include "papers/figure.h"
#include "render/gpu/depth.h"
#include "render/gpu/framebuffer.h"
#include "render/gpu/texture.h"

namespace litfog::papers {
namespace {

/// A compatibility-profile context on the current context's display, current during this object's life.
class CompatibilityContext {
 public:
  CompatibilityContext() {
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                      EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    is_current_ =
        context_ != EGL_NO_CONTEXT && eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  ~CompatibilityContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, previous_);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
  }
  CompatibilityContext(const CompatibilityContext&) = delete;
  CompatibilityContext& operator=(const CompatibilityContext&) = delete;

  bool is_current() const { return is_current_; }

 private:
  EGLDisplay display_ = eglGetCurrentDisplay();
  EGLContext previous_ = eglGetCurrentContext();
  EGLContext context_ = EGL_NO_CONTEXT;
  bool is_current_ = false;
};

/// Sets one of OpenGL's lights, diffuse only.
///
/// position  homogeneous; in the current modelview matrix
void set_light(GLenum light, const glm::vec4& position, const glm::vec3& color) {
  constexpr glm::vec4 kNone(0, 0, 0, 1);
  glEnable(light);
  glLightfv(light, GL_POSITION, glm::value_ptr(position));
  glLightfv(light, GL_DIFFUSE, glm::value_ptr(glm::vec4(color, 1)));
  glLightfv(light, GL_SPECULAR, glm::value_ptr(kNone));
  glLightfv(light, GL_AMBIENT, glm::value_ptr(kNone));
}

void set_lamp(GLenum light, const PlacedLight& lamp) {
  set_light(light, glm::vec4(lamp.position, 1), lamp.light.color);
  glLightf(light, GL_CONSTANT_ATTENUATION, float(lamp.light.attenuation.constant));
  glLightf(light, GL_LINEAR_ATTENUATION, float(lamp.light.attenuation.linear));
  glLightf(light, GL_QUADRATIC_ATTENUATION, float(lamp.light.attenuation.quadratic));
  const double cutoff = cutoff_angle(lamp.light.cone);
  if (cutoff > std::numbers::pi / 2) return;
  glLightf(light, GL_SPOT_CUTOFF, float(cutoff / kDegree));
  glLightf(light, GL_SPOT_EXPONENT, std::min(float(lamp.light.cone.exponent), 128.0f));
  glLightfv(light, GL_SPOT_DIRECTION, glm::value_ptr(glm::vec3(lamp.direction)));
}

constexpr GLenum kArrays[] = {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY};
constexpr GLenum kStates[] = {GL_TEXTURE_2D, GL_LIGHTING, GL_FOG, GL_NORMALIZE};

/// A part of a model on the GPU.
struct Part {
  gl::BufferName vertices, indices;
  GLsizei index_count;
  const scene::Material* material;
  const render::Texture* texture;
};

class Pipeline {
 public:
  Pipeline(const scene::Scene& scene, const Fog& fog, int width, int height)
      : scene_(scene), fog_(fog), framebuffer_(width, height, render::Passes::one, 4) {
    for (const scene::Material& material : scene.materials) {
      textures_.emplace(material.name, material.plain_albedo
                                           ? render::Texture(glm::vec4(*material.plain_albedo, 1))
                                           : render::Texture(*material.albedo, render::Texture::Encoding::srgb));
    }
    for (const scene::Model& model : scene.models) {
      std::vector<Part>& parts = models_.emplace_back();
      for (const scene::Part& part : model) {
        const auto material = std::ranges::find(scene.materials, part.material, &scene::Material::name);
        parts.push_back({.vertices = {},
                         .indices = {},
                         .index_count = GLsizei(part.mesh.indices.size()),
                         .material = &*material,
                         .texture = &textures_.at(part.material)});
        glBindBuffer(GL_ARRAY_BUFFER, parts.back().vertices.id());
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(part.mesh.vertices.size() * sizeof(scene::Vertex)),
                     part.mesh.vertices.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, parts.back().indices.id());
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(part.mesh.indices.size() * sizeof(std::uint32_t)),
                     part.mesh.indices.data(), GL_STATIC_DRAW);
      }
    }
  }

  void draw() {
    const glm::vec3 background = scene_.atmosphere.ambient_fog_color;
    glBindVertexArray(0);
    glUseProgram(0);
    framebuffer_.bind();
    glClearColor(background.r, background.g, background.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    render::begin_depths();
    glEnable(GL_CULL_FACE);
    glClampColor(GL_CLAMP_VERTEX_COLOR, GL_FALSE);
    glClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(render::clip_from_view(scene_.camera, framebuffer_.aspect())));
    const auto view_from_world = scene::view_from_world<float>(scene_.camera);
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(glm::value_ptr(view_from_world));
    set_lights();
    set_fog();
    glActiveTexture(GL_TEXTURE0);
    glEnable(GL_TEXTURE_2D);
    for (const GLenum array : kArrays) glEnableClientState(array);
    for (const scene::Instance& instance : scene_.instances) {
      glMatrixMode(GL_MODELVIEW);
      glLoadMatrixf(glm::value_ptr(view_from_world * glm::mat4(instance.world_from_model)));
      for (const Part& part : models_[instance.model]) draw_part(part);
    }
    for (const GLenum array : kArrays) glDisableClientState(array);
    for (const GLenum state : kStates) glDisable(state);
    render::end_depths();
    framebuffer_.resolve();
    glFinish();
    gl::check_errors("drawing by the fixed pipeline");
  }
  render::Picture read() const { return framebuffer_.read(); }

 private:
  void set_lights() const {
    const scene::Environment& environment = scene_.environment;
    glEnable(GL_LIGHTING);
    glEnable(GL_NORMALIZE);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(glm::vec4(environment.ambient_light, 1)));
    const glm::vec4 white(1);
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, glm::value_ptr(white));
    set_light(GL_LIGHT0, glm::vec4(environment.moon_direction, 0), environment.moon_color);
    for (std::size_t i = 0; i < std::min<std::size_t>(scene_.lights.size(), 7); ++i) {
      set_lamp(GLenum(GL_LIGHT1 + i), scene_.lights[i]);
    }
  }

  void set_fog() const {
    if (!(fog_.density > 0)) return;
    glEnable(GL_FOG);
    glFogi(GL_FOG_MODE, fog_.mode == FogMode::exp ? GL_EXP : GL_EXP2);
    glFogf(GL_FOG_DENSITY, float(fog_.density));
    glFogfv(GL_FOG_COLOR, glm::value_ptr(glm::vec4(glm::vec3(scene_.atmosphere.ambient_fog_color), 1)));
  }

  static void draw_part(const Part& part) {
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glScalef(1 / part.material->size_m, 1 / part.material->size_m, 1);
    part.texture->bind(0);
    glMaterialfv(GL_FRONT, GL_EMISSION, glm::value_ptr(glm::vec4(part.material->emissive, 1)));
    glBindBuffer(GL_ARRAY_BUFFER, part.vertices.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, part.indices.id());
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    glVertexPointer(3, GL_FLOAT, sizeof(scene::Vertex), at(offsetof(scene::Vertex, position)));
    glNormalPointer(GL_FLOAT, sizeof(scene::Vertex), at(offsetof(scene::Vertex, normal)));
    glTexCoordPointer(2, GL_FLOAT, sizeof(scene::Vertex), at(offsetof(scene::Vertex, uv)));
    glDrawElements(GL_TRIANGLES, part.index_count, GL_UNSIGNED_INT, nullptr);
  }

  const scene::Scene& scene_;
  Fog fog_;
  render::Framebuffer framebuffer_;
  std::map<std::string, render::Texture> textures_;
  std::vector<std::vector<Part>> models_;
};

}  // namespace

std::optional<FixedPipeline> draw_by_fixed_pipeline(const scene::Scene& scene, const Fog& fog, int width, int height,
                                                    int frames) {
  const CompatibilityContext context;
  if (!context.is_current()) return std::nullopt;
  Pipeline pipeline(scene, fog, width, height);
  render::Renderer mimic(scene, width, height, along("legacy", {.skipping = render::Skipping::off}));
  mimic.set_atmosphere(scene.atmosphere.with(fog));
  const std::vector<measure::FrameTimes> times = measure::time_frames({measure::frames_of(mimic),
                                                                       [&] {
                                                                         pipeline.draw();
                                                                         return render::FrameCounts{};
                                                                       }},
                                                                      measure::FrameBudget::exactly(frames));
  return FixedPipeline{.picture = pipeline.read(), .mimic_ratio = times[0].median() / times[1].median()};
}

}  // namespace litfog::papers
