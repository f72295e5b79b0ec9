// SPDX-License-Identifier: Apache-2.0
#include "render/surface/surface_programs.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "gl/gl_test.h"

namespace litfog::test {
using namespace render;

namespace {

class SurfaceProgramsTest : public GlTest {};

/// The text of a program's vertex shader.
std::string vertex_shader_of(const gl::Program& program) {
  std::array<GLuint, 3> shaders{};
  GLsizei count = 0;
  glGetAttachedShaders(program.id(), GLsizei(shaders.size()), &count, shaders.data());
  for (GLsizei i = 0; i < count; ++i) {
    GLint stage = 0;
    glGetShaderiv(shaders[std::size_t(i)], GL_SHADER_TYPE, &stage);
    if (stage != GL_VERTEX_SHADER) continue;
    GLint length = 0;
    glGetShaderiv(shaders[std::size_t(i)], GL_SHADER_SOURCE_LENGTH, &length);
    std::string text(std::size_t(length), '\0');
    glGetShaderSource(shaders[std::size_t(i)], length, nullptr, text.data());
    return text;
  }
  return {};
}

/// How many vectors a vertex shader passes on, each varying taken as a whole vector; 0 where the driver refuses it.
int varying_vectors(const std::string& vertex_shader) {
  const char* const text = vertex_shader.c_str();
  const GLuint program = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &text);
  GLint outputs = 0;
  glGetProgramInterfaceiv(program, GL_PROGRAM_OUTPUT, GL_ACTIVE_RESOURCES, &outputs);
  int vectors = 0;
  for (GLint i = 0; i < outputs; ++i) {
    std::string name(100, '\0');
    GLsizei length = 0;
    glGetProgramResourceName(program, GL_PROGRAM_OUTPUT, GLuint(i), GLsizei(name.size()), &length, name.data());
    const GLenum property = GL_ARRAY_SIZE;
    GLint size = 0;
    glGetProgramResourceiv(program, GL_PROGRAM_OUTPUT, GLuint(i), 1, &property, 1, nullptr, &size);
    if (!name.starts_with("gl_")) vectors += size;
  }
  glDeleteProgram(program);
  return vectors;
}

TEST_F(SurfaceProgramsTest, VerticesPassOnAsManyLightsAsTheDriverHasVaryingsFor) {
  if (!epoxy_has_gl_extension("GL_ARB_program_interface_query") ||
      !epoxy_has_gl_extension("GL_ARB_separate_shader_objects")) {
    GTEST_SKIP() << "this OpenGL does not say what a vertex shader passes on";
  }
  GLint components = 0;
  glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &components);
  const scene::Scene scene;
  SurfacePrograms programs(scene, {});
  const SurfacePass& pass = lighting_paths().front().passes.front();
  for (const bool has_details : {false, true}) {
    const MaterialFeatures material{.has_details = has_details};
    const std::size_t lights = programs.most_vertex_lights(material);
    const ShaderVariant variant{.pass = &pass,
                                .material = material,
                                .lights = {.count = kMaxUniformLights},
                                .takes_constants_from_vertices = true,
                                .vertex_lights = lights};
    const int vectors = varying_vectors(vertex_shader_of(programs.program(variant).program));
    EXPECT_GE(vectors, int(kPackedVectors * lights));
    EXPECT_LE(vectors, components / 4) << "details: " << has_details;
    EXPECT_GT(vectors + int(kPackedVectors), components / 4) << "one light more has room, details: " << has_details;
  }
}

}  // namespace

}  // namespace litfog::test
