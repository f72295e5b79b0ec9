// SPDX-License-Identifier: Apache-2.0
#include "render/compose/compositor.h"

#include <epoxy/gl.h>

#include "render/gpu/light_uniforms.h"
#include "render/gpu/render_shaders.h"
#include "render/gpu/uniform.h"

namespace litfog::render {

void bind_pane_airlight(const gl::Program& program, const PaneAirlight* airlight) {
  set_uniform(program, "airlight_count", airlight ? airlight->lights.single_count() : 0);
  PassTextures textures(program);
  if (airlight) {
    airlight->lights.bind_entries(textures);
    airlight->far.bind(program, textures);
  } else {  // samplers of two kinds may not share a unit
    textures.unit("airlight_entries");
  }
}

Compositor::Compositor() : program_("whole_picture.vert", "compose/compose_airlight.frag", render_shaders()) {}

void Compositor::begin_panes() {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
}

void Compositor::end_panes() { glDisable(GL_BLEND); }

void Compositor::add_airlight(const Framebuffer& framebuffer, const gl::TextureName& airlight, const FarAirlight& far,
                              const SeenRanges& seen, const View& view, bool has_panes) const {
  pass_.begin();
  glEnable(GL_BLEND);
  glBlendFunc(has_panes ? GL_DST_ALPHA : GL_ONE, GL_ONE);
  framebuffer.bind_resolved();
  program_.use();
  PassTextures textures(program_);
  textures.bind("airlight", airlight, GL_TEXTURE_RECTANGLE);
  seen.bind(textures);
  far.bind(program_, textures);
  set_uniform(program_, "eye", view.eye);
  set_uniform(program_, "direction_from_clip", view.direction_from_clip);
  set_uniform(program_, "pixel_size", 2.0f / glm::vec2(view.size));
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

}  // namespace litfog::render
