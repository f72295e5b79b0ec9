// SPDX-License-Identifier: Apache-2.0
// A host with a renderer of its own: litfog's shaders in its shader, the updater's ranges in its uniform buffer.
//
//     gl_host [PICTURE.ppm]
//
// draws a road, a wall, headlights and a street lamp in fog of three visibilities, and compares the sky's pixels with
// litfog::airlight. Ends with 1 where they differ or PICTURE cannot be written, with 3 where there is no OpenGL 3.3.
#include <epoxy/gl.h>
#include <litfog/airlight.h>
#include <litfog/gl/check_errors.h>
#include <litfog/gl/fog_light_buffer.h>
#include <litfog/gl/headless_context.h>
#include <litfog/gl/program.h>
#include <litfog/gl/unsupported.h>
#include <litfog/updater.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

constexpr int kWidth = 320, kHeight = 180;
constexpr glm::dvec2 kTangents{8 / 9., 0.5};  // half the picture's width and height
constexpr glm::dvec3 kEye{0, 2, 0};           // looks along -z
constexpr double kBackdrop = 1000;            // metres ahead, black: the sky
constexpr glm::dvec3 kFogColor{0.01, 0.012, 0.015};

constexpr litfog::gl::ShaderSource kShaders[] = {{"host.vert", R"(
uniform vec3 eye;
uniform vec2 tangents;
layout(location = 0) in vec3 corner;
layout(location = 1) in vec4 corner_normal;  // w: reflectance
out vec3 position;
flat out vec4 normal;
void main() {
  position = corner;
  normal = corner_normal;
  vec3 seen = corner - eye;
  const float near = 0.5, far = 2000.0;
  gl_Position = vec4(seen.xy / tangents, (-seen.z * (far + near) - 2.0 * far * near) / (far - near), -seen.z);
}
)"},
                                                 {"host.frag", R"(
#include "litfog/shaders/surface.glsl"
#include "litfog/shaders/light_airlight.glsl"
uniform vec3 eye;
in vec3 position;
flat in vec4 normal;
out vec4 color;
void main() {
  vec4 ray = litfog_ray(eye, position);
  LitfogSurface surface = LitfogSurface(position, normal.xyz, -ray.xyz, vec3(0.0), vec3(normal.w), vec3(normal.w),
                                        vec3(0.0), 1.0);
  vec3 lit = litfog_ambient(surface, vec3(0.02));
  vec3 airlight = vec3(0.0);
  for (int i = 0; i < int(litfog_fog.z); ++i) {
    LitfogLight light = litfog_block_light(i);
    lit += litfog_light_surface(surface, light) *
           litfog_lamp_factor(light, position.y, distance(light.position_extent.xyz, position));
    airlight += litfog_light_airlight(light, eye, ray.xyz, ray.w);
  }
  float opacity = litfog_fog_opacity(eye.y, position.y, ray.w, 1.0);
  color = vec4(lit * (1.0 - opacity) + litfog_ambient_fog_color.rgb * opacity + airlight, 1.0);
}
)"}};

/// Two triangles of a quad: position and normal with reflectance, seven floats a corner.
void add_quad(std::vector<float>& mesh, glm::vec3 corner, glm::vec3 u, glm::vec3 v, float reflectance) {
  const glm::vec3 n = glm::normalize(glm::cross(u, v));
  for (const glm::vec3 p : {corner, corner + u, corner + v, corner + v, corner + u, corner + u + v}) {
    mesh.insert(mesh.end(), {p.x, p.y, p.z, n.x, n.y, n.z, reflectance});
  }
}

/// How far the pixels of the sky are from the library's airlight, in 1/255.
double sky_error(const std::vector<std::uint8_t>& pixels, const std::vector<litfog::PlacedLight>& lights,
                 const litfog::Fog& fog) {
  double largest = 0;
  for (int y = kHeight - 20; y < kHeight; y += 5) {
    for (int x = 0; x < kWidth; x += 16) {
      const glm::dvec3 at{((x + 0.5) / kWidth * 2 - 1) * kTangents.x, ((y + 0.5) / kHeight * 2 - 1) * kTangents.y, -1};
      const litfog::EyeRay ray{kEye, glm::normalize(at), kBackdrop * glm::length(at)};
      glm::dvec3 sky = kFogColor * litfog::opacity_at(fog, ray.length);
      for (const auto& light : lights) {
        sky += litfog::kAirlightUnit * litfog::airlight(light, {fog}, ray) * light.light.color;
      }
      for (int i = 0; i < 3; ++i) {
        const double drawn = pixels[std::size_t((y * kWidth + x) * 3 + i)];
        largest = std::max(largest, std::abs(drawn - 255 * std::min(sky[i], 1.0)));
      }
    }
  }
  return largest;
}

int draw(const char* file) {
  const litfog::gl::HeadlessContext context;
  const litfog::gl::Program program("host.vert", "host.frag", kShaders);
  litfog::gl::check_fog_light_layout(program);
  litfog::gl::FogLightBuffer lights;
  lights.bind(program, 0);

  litfog::gl::TextureName texture;
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kWidth, kHeight, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  litfog::gl::RenderbufferName depth;
  glBindRenderbuffer(GL_RENDERBUFFER, depth.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kWidth, kHeight);
  litfog::gl::FramebufferName target;
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.id());

  std::vector<float> mesh;
  add_quad(mesh, {-2000, 0, 0}, {4000, 0, 0}, {0, 0, -kBackdrop}, 0.5f);   // road
  add_quad(mesh, {3, 0, -30}, {6, 0, 0}, {0, 4, 0}, 0.6f);                 // wall
  add_quad(mesh, {-2000, -9, -kBackdrop}, {4000, 0, 0}, {0, 2000, 0}, 0);  // sky
  litfog::gl::VertexArrayName array;
  litfog::gl::BufferName vertices;
  glBindVertexArray(array.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices.id());
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.size() * sizeof(float)), mesh.data(), GL_STATIC_DRAW);
  for (const GLuint i : {0u, 1u}) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, i == 0 ? 3 : 4, GL_FLOAT, GL_FALSE, 28, reinterpret_cast<const void*>(i * 12ul));
  }
  program.use();
  glUniform3f(program.uniform("eye"), float(kEye.x), float(kEye.y), float(kEye.z));
  glUniform2f(program.uniform("tangents"), float(kTangents.x), float(kTangents.y));
  glViewport(0, 0, kWidth, kHeight);
  glEnable(GL_DEPTH_TEST);

  const litfog::Light headlight{
      .color = glm::dvec3(1.5), .attenuation = {1, 0, 0.0004}, .cone = litfog::Cone::smoothstep(0.05, 0.3)};
  const litfog::Light street_lamp{.color = {4, 2.6, 1.4}, .attenuation = {1, 0, 0.02}};
  const std::vector<litfog::PlacedLight> placed = {
      {.light = headlight, .position = {-0.7, 0.7, -1}, .carried = true},
      {.light = headlight, .position = {0.7, 0.7, -1}, .carried = true},
      {.light = street_lamp, .position = {-6, 6, -30}, .direction = {0, -1, 0}}};
  litfog::FogUpdater updater;
  for (const litfog::PlacedLight& light : placed) updater.add(light);

  double largest_error = 0;
  std::vector<std::uint8_t> picture;
  for (const double visibility : {2000., 300., 60.}) {
    const auto fog = litfog::Fog::from_visibility(litfog::FogMode::exp, visibility);
    const litfog::FogLightChanges changes = updater.set_fog(fog);
    lights.upload(litfog::pack_fog_header({.fog = fog, .ambient_fog_color = kFogColor}, updater.instances().size()),
                  updater.kinds(), updater.instances(), changes);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(mesh.size() / 7));
    std::vector<std::uint8_t> pixels(kWidth * kHeight * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kWidth, kHeight, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    litfog::gl::check_errors("drawing");

    largest_error = std::max(largest_error, sky_error(pixels, placed, fog));
    for (int y = kHeight - 1; y >= 0; --y) {
      picture.insert(picture.end(), pixels.begin() + y * kWidth * 3, pixels.begin() + (y + 1) * kWidth * 3);
    }
    std::printf("visibility %4.0f m: %zu bytes uploaded, %zu kinds solved\n", visibility,
                updater.statistics().bytes_dirty, updater.statistics().kinds_solved);
  }
  if (file != nullptr) {
    std::ofstream output(file, std::ios::binary);
    output << "P6 " << kWidth << ' ' << 3 * kHeight << " 255\n" << std::string(picture.begin(), picture.end());
    if (!output.flush()) {
      std::fprintf(stderr, "%s: cannot be written\n", file);
      return 1;
    }
  }
  std::printf("sky within %.2f of 255\n", largest_error);
  return largest_error <= 2 ? 0 : 1;
}

int main(int count, char** arguments) {
  try {
    return draw(count > 1 ? arguments[1] : nullptr);
  } catch (const litfog::gl::Unsupported& reason) {
    std::fprintf(stderr, "%s\n", reason.what());
    return 3;
  }
}
