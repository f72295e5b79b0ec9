// SPDX-License-Identifier: Apache-2.0
// A host with 5,000 lamps of 40 kinds, whose visibility changes in each frame: litfog finds the few that a pixel needs,
// and sums what all add to the fog farther away.
//
//     many_lights_host PICTURE.ppm [SIZE [LAMPS [all]]]
//
// draws four frames below each other, SIZE pixels wide, without a window. With `all` it draws each pixel by all lamps,
// for comparison: take at most 1,000, because Mesa's software rasteriser ends a pixel's loops after 65,535 rounds. Ends
// with 1 on a wrong command line, with 3 where there is no OpenGL 3.3, with 4 where PICTURE cannot be written.
#include <epoxy/gl.h>
#include <litfog/gl/check_errors.h>
#include <litfog/gl/far_airlight.h>
#include <litfog/gl/fog_light_buffer.h>
#include <litfog/gl/fog_light_tables.h>
#include <litfog/gl/headless_context.h>
#include <litfog/gl/light_cluster_tables.h>
#include <litfog/gl/program.h>
#include <litfog/gl/unsupported.h>
#include <litfog/updater.h>

#include <charconv>
#include <fstream>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>

constexpr litfog::gl::ShaderSource kShaders[] = {{"host.vert", R"(
out vec3 position;
void main() {  // the sky 1,000 m ahead, and over it the ground; the eye looks along -z
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  position = vec3(4000.0 * corner.x - 2000.0, 0.0, -1.0 - 999.0 * corner.y);
  if (gl_InstanceID == 0) position.yz = vec2(2000.0 * corner.y - 100.0, -1000.0);
  gl_Position = vec4(position.x, position.y - 12.0, 0.0, -position.z);
}
)"},
                                                 {"host.frag", R"(
#include "litfog/shaders/far_airlight.glsl"
#include "litfog/shaders/light_clusters.glsl"
const vec3 eye = vec3(0.0, 12.0, 0.0), up = vec3(0.0, 1.0, 0.0);
in vec3 position;
out vec4 color;
void main() {
  vec4 ray = litfog_ray(eye, position);
  vec2 place = 0.5 - 0.5 * (position - eye).xy / position.z;  // in the picture, from 0 to 1
  float depth = 1.0 / gl_FragCoord.w;
  vec3 airlight = litfog_listed_airlight(litfog_lights_along(place, depth), eye, ray.xyz, ray.w) +
                  litfog_far_airlight(place, eye, ray.xyz, ray.w);
  float albedo = position.y == 0.0 ? 0.5 : 0.0;  // the sky is black
  vec3 seen = albedo * litfog_listed_surface_light(litfog_lights_at(place, depth), position, up);
  color = vec4(seen * (1.0 - litfog_fog_opacity(eye.y, position.y, ray.w, 1.0)) + airlight, 1.0);
}
)"}};

int whole_number(const std::string& text, const std::string& name, int most) {
  int number = 0;
  const char* const end = text.data() + text.size();
  if (std::from_chars(text.data(), end, number).ptr == end && number >= 1 && number <= most) return number;
  throw std::invalid_argument(name + " = " + text + ": must be a whole number in [1, " + std::to_string(most) + "]");
}

int main(int count, char** arguments) try {
  const int size = whole_number(count > 2 ? arguments[2] : "180", "SIZE", 4096);
  const int lamp_count = whole_number(count > 3 ? arguments[3] : "5000", "LAMPS", 100'000);
  const litfog::gl::HeadlessContext context;
  const litfog::gl::RenderbufferName image;
  glBindRenderbuffer(GL_RENDERBUFFER, image.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size, size);
  const litfog::gl::FramebufferName target;
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, image.id());
  const litfog::gl::VertexArrayName no_vertices;
  glBindVertexArray(no_vertices.id());
  glViewport(0, 0, size, size);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);  // rows of any size

  litfog::FogUpdater lamps;
  std::mt19937 random;
  const auto pick = [&](double low, double high) { return low + (high - low) * double(random()) / 4294967296.; };
  for (int i = 0; i < lamp_count; ++i) {
    litfog::Light kind{.color = {pick(5, 20), pick(5, 15), pick(0, 10)},
                       .attenuation = {1, 0, 0.02 + 0.002 * (i % 40)}};
    if (i % 2 == 0) kind.cone = litfog::Cone::smoothstep(0.6, 1.2);
    lamps.add({.light = kind, .position = {pick(-1000, 1000), pick(3, 9), pick(-1000, -5)}, .direction = {0, -1, 0}});
  }
  const litfog::View view{.eye = {0, 12, 0}, .farthest = 1001};  // 90 degrees wide and high
  litfog::LightClusters clusters(count > 4 ? litfog::ClusterGrid{1, 1, 1} : litfog::ClusterGrid{});

  const litfog::gl::Program program("host.vert", "host.frag", kShaders);
  program.use();
  litfog::gl::FogLightBuffer fog_block;
  litfog::gl::FogLightTables tables;
  litfog::gl::LightClusterTables cluster_tables;
  litfog::gl::FarAirlight far;
  std::ofstream output(count > 1 ? arguments[1] : "many_lights.ppm", std::ios::binary);
  output << "P6 " << size << ' ' << 4 * size << " 255\n";
  for (const double visibility : {5000., 1000., 300., 100.}) {
    const litfog::Atmosphere air{.fog = litfog::Fog::from_visibility(litfog::FogMode::exp, visibility)};
    const litfog::FogLightChanges changes = lamps.set_fog(air.fog);
    tables.upload(lamps.kinds(), lamps.instances(), changes);
    lamps.bound_lights(clusters, air);
    for (std::size_t i = 0; count > 4 && i < clusters.size(); ++i) clusters.set_light(i, {});
    if (clusters.update(view)) cluster_tables.upload(clusters);
    far.draw(view, air, tables, lamps.instances().size());
    fog_block.upload(litfog::pack_fog_header(air, 0));
    fog_block.bind(program, 0);
    tables.bind_textures(program, 0, 1);
    cluster_tables.bind_texture(program, 2);
    far.bind(program, 3);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, 2);

    std::string pixels(std::size_t(3 * size * size), '\0');
    glReadPixels(0, 0, size, size, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    litfog::gl::check_errors("drawing");
    for (int y = size - 1; y >= 0; --y) output.write(&pixels[std::size_t(3 * size * y)], 3 * size);
    std::cout << visibility << " m: " << clusters.statistics().lights_in_view << " lamps in view\n";
  }
  return output.flush() ? 0 : 4;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return dynamic_cast<const litfog::gl::Unsupported*>(&error) != nullptr ? 3 : 1;
}
