// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/far_airlight.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "litfog/gl/unsupported.h"
#include "model/require.h"

namespace litfog::gl {
namespace {

constexpr int kUnit = 14;             // the last two of a fragment shader's 16 texture units; hosts fill them from 0 on
constexpr int kBlockBinding = 35;     // its last binding point
constexpr int kSlabs = 8;             // litfog_far_slabs
constexpr double kHidden = 1e-3;      // the fog's transmittance to the end of the grid
constexpr int kLightsAtOnce = 64;     // instances of the triangle, which a GPU draws at the same time
constexpr double kLeastDepth = 1e-3;  // metres; depth of the grid in total fog

constexpr std::string_view kVertexShader = R"(
uniform int lights_at_once;
flat out int first;
void main() {
  first = gl_InstanceID * lights_at_once;
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";
constexpr std::string_view kFragmentShader = R"(
#include "litfog/shaders/far_airlight.glsl"
uniform int lights_at_once;
uniform int lights;
uniform float depth;
uniform vec3 eye;
uniform vec3 corner;  // of the view, 1 m ahead, and from texel to texel
uniform vec3 right;
uniform vec3 up;
flat in int first;
layout(location = 0) out vec4 layers[litfog_far_slabs];
void main() {
  vec2 texel = gl_FragCoord.xy - 0.5;
  vec3 direction = normalize(corner + texel.x * right + texel.y * up);
  vec4 sums[litfog_far_slabs];
  litfog_sum_far_airlight(first, min(lights - first, lights_at_once), eye, direction, depth, sums);
  for (int i = 0; i < litfog_far_slabs; ++i) layers[i] = sums[i];
}
)";

/// The forms of the fog as constants, which makes the program some six times as fast on llvmpipe.
std::string constants_of(const Atmosphere& atmosphere) {
  return "#define LITFOG_FOG_MODE " + std::to_string(int(atmosphere.fog.mode)) + ".0\n#define LITFOG_KNOT_COUNT " +
         std::to_string(atmosphere.profile.count) + "\n#define LITFOG_ISOTROPIC " +
         std::to_string(int(is_isotropic(atmosphere.phase))) + "\n";
}

glm::ivec2 checked(glm::ivec2 grid) {
  for (const int rays : {grid.x, grid.y}) {
    if (rays < 2 || rays > 512) require(ValueError{"grid", double(rays), "must be in [2, 512]"});
  }
  return grid;
}

}  // namespace

FarAirlight::FarAirlight(glm::ivec2 grid) : size_(checked(grid)) {
  glBindTexture(GL_TEXTURE_2D_ARRAY, grid_.id());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, size_.x, size_.y, kSlabs, 0, GL_RGBA, GL_FLOAT, nullptr);
  for (const int filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GLenum(filter), GL_LINEAR);
  }
  for (const int wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GLenum(wrap), GL_CLAMP_TO_EDGE);
  }
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
  std::array<GLenum, kSlabs> layers;
  for (int i = 0; i < kSlabs; ++i) {
    layers[std::size_t(i)] = GLenum(GL_COLOR_ATTACHMENT0 + i);
    glFramebufferTextureLayer(GL_DRAW_FRAMEBUFFER, layers[std::size_t(i)], grid_.id(), 0, i);
  }
  glDrawBuffers(kSlabs, layers.data());
  const bool is_complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound));
  if (!is_complete) throw Unsupported("the driver cannot draw into an array of textures of floats");
}

const Program& FarAirlight::program_for(const Atmosphere& atmosphere) {
  const std::string constants = constants_of(atmosphere);
  if (const auto found = programs_.find(constants); found != programs_.end()) return found->second;
  const std::string fragment_shader = constants + std::string(kFragmentShader);
  const ShaderSource shaders[] = {{"far.vert", kVertexShader}, {"far.frag", fragment_shader}};
  return programs_.emplace(constants, Program("far.vert", "far.frag", shaders)).first->second;
}

void FarAirlight::draw(const View& view, const Atmosphere& atmosphere, const FogLightTables& tables,
                       std::size_t lights) {
  require(find_error(view));
  fog_block_.upload(pack_fog_header(atmosphere, 0));
  const Fog thinnest = atmosphere.thinnest_fog();
  const double hidden_depth = -std::log(kHidden);  // optical depth
  const double hidden_range =
      (thinnest.mode == FogMode::exp ? hidden_depth : std::sqrt(hidden_depth)) / thinnest.density;
  const double edge = std::hypot(1, std::max(-view.left, view.right), std::max(-view.bottom, view.top));
  const double depth = std::max(std::min(view.farthest * edge, hidden_range), kLeastDepth);

  GLint program = 0;
  GLint bound = 0;
  GLint vertices = 0;
  GLint viewport[4];
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertices);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_VIEWPORT, viewport);
  const Program& sum = program_for(atmosphere);
  sum.use();
  const auto set = [&sum](const char* name, const glm::dvec3& value) {
    glUniform3f(sum.uniform(name), float(value.x), float(value.y), float(value.z));
  };
  const glm::dmat3 axes = axes_of(view);
  set("eye", view.eye);
  set("corner", axes[2] + view.left * axes[0] + view.bottom * axes[1]);
  set("right", (view.right - view.left) / (size_.x - 1) * axes[0]);
  set("up", (view.top - view.bottom) / (size_.y - 1) * axes[1]);
  glUniform1f(sum.uniform("depth"), float(depth));
  glUniform1i(sum.uniform("lights"), GLint(lights));
  glUniform1i(sum.uniform("lights_at_once"), kLightsAtOnce);
  tables.bind_textures(sum, kUnit, kUnit + 1);
  fog_block_.bind(sum, kBlockBinding);

  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
  glBindVertexArray(no_vertices_.id());
  glViewport(0, 0, size_.x, size_.y);
  constexpr GLfloat kEmpty[] = {0, 0, 0, 0};
  for (int i = 0; i < kSlabs; ++i) glClearBufferfv(GL_COLOR, i, kEmpty);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ZERO);  // alpha holds ranges, the same each time
  glDrawArraysInstanced(GL_TRIANGLES, 0, 3, GLsizei((lights + kLightsAtOnce - 1) / kLightsAtOnce));
  glDisable(GL_BLEND);
  glBindVertexArray(GLuint(vertices));
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(bound));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  if (glIsProgram(GLuint(program))) glUseProgram(GLuint(program));  // a host may have deleted it while it was in use
}

void FarAirlight::bind(const Program& program, unsigned unit) const {
  glUniform1i(program.uniform("litfog_far_airlight_grid"), GLint(unit));
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, grid_.id());
}

}  // namespace litfog::gl
