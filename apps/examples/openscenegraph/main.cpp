// SPDX-License-Identifier: Apache-2.0
// litfog's fog in an OpenSceneGraph scene: an ordinary model, OpenSceneGraph's own objects for the tables, no window.
//
//     openscenegraph_host MODEL.osgt [PICTURE.ppm]
//
// draws the model in fog of three visibilities under 240 street lamps, and compares the sky's pixels with
// litfog::airlight. Ends with 1 where they differ or a file cannot be read or written, with 3 where EGL gives no
// OpenGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <litfog/airlight.h>
#include <litfog/c/litfog.h>
#include <litfog/updater.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <osg/BufferIndexBinding>
#include <osg/Program>
#include <osg/ShapeDrawable>
#include <osg/TextureBuffer>
#include <osgDB/ReadFile>
#include <osgViewer/Viewer>
#include <string>
#include <vector>

constexpr int kWidth = 320, kHeight = 180;
constexpr double kSky = 600;           // metres ahead, black
constexpr glm::dvec3 kEye{0, 1.7, 0};  // looks along -z, OpenSceneGraph's y
constexpr glm::dvec2 kTangents{0.8, 0.45};
constexpr glm::dvec3 kFogColor{0.01, 0.012, 0.015};

// OpenSceneGraph's z is up, litfog's y.
constexpr const char* kVertex = R"(#version 330 compatibility
uniform mat4 osg_ViewMatrixInverse;
out vec3 position;
out vec3 normal;
vec3 litfog_axes(vec3 v) { return vec3(v.x, v.z, -v.y); }
void main() {
  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
  gl_FrontColor = gl_Color;
  position = litfog_axes((osg_ViewMatrixInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz);
  normal = litfog_axes(mat3(osg_ViewMatrixInverse) * (gl_NormalMatrix * gl_Normal));
}
)";
constexpr const char* kFragment = R"(#version 330 compatibility
#include "litfog/shaders/light_clusters.glsl"
uniform vec3 eye;
uniform vec2 picture_size;
in vec3 position;
in vec3 normal;
void main() {
  vec4 ray = litfog_ray(eye, position);
  vec2 place = gl_FragCoord.xy / picture_size;
  float depth = 1.0 / gl_FragCoord.w;
  vec3 lit = litfog_listed_surface_light(litfog_lights_at(place, depth), position, normalize(normal));
  vec3 seen = mix(gl_Color.rgb * (0.01 + lit), litfog_ambient_fog_color.rgb,
                  litfog_fog_opacity(eye.y, position.y, ray.w, 1.0));
  vec3 airlight = litfog_listed_airlight(litfog_lights_along(place, depth), eye, ray.xyz, ray.w);
  gl_FragColor = vec4(seen + airlight, 1.0);
}
)";

/// A shader whose lines that include litfog's files are expanded.
osg::Shader* make_shader(osg::Shader::Type type, const char* source) {
  std::size_t length = 0;
  litfog_expand_shader(source, nullptr, 0, &length);
  std::string text(length + 1, '\0');
  if (litfog_expand_shader(source, text.data(), text.size(), &length) != LITFOG_OK) std::puts(litfog_last_error());
  return new osg::Shader(type, text.c_str());
}

/// Gives the shaders a table as a buffer texture: floats by fours, or words.
template <typename Array>
void set_table(osg::StateSet& state, unsigned unit, const char* sampler, GLint format, const void* data,
               std::size_t bytes) {
  osg::ref_ptr<Array> array = new Array(unsigned(bytes / sizeof(typename Array::ElementDataType)));
  std::memcpy(array->asVector().data(), data, bytes);
  auto* texture = new osg::TextureBuffer(array);
  texture->setInternalFormat(format);
  state.setTextureAttribute(unit, texture);
  state.addUniform(new osg::Uniform(sampler, int(unit)));
}

/// Makes OpenGL current without a window.
bool make_context() {
  const auto get_display = PFNEGLGETPLATFORMDISPLAYEXTPROC(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const EGLDisplay display =
      get_display ? get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr) : EGL_NO_DISPLAY;
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return false;
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
  return eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

/// How far the pixels of the sky are from the library's airlight, in 1/255.
double sky_error(const osg::Image& picture, const std::vector<litfog::PlacedLight>& lamps,
                 const litfog::Atmosphere& air) {
  double largest = 0;
  for (int y = kHeight - 40; y < kHeight; y += 8) {
    for (int x = kWidth / 2 - 60; x < kWidth / 2 + 60; x += 15) {
      const glm::dvec3 at{((x + 0.5) / kWidth * 2 - 1) * kTangents.x, ((y + 0.5) / kHeight * 2 - 1) * kTangents.y, -1};
      const litfog::EyeRay ray{kEye, glm::normalize(at), kSky * glm::length(at)};
      glm::dvec3 sky = kFogColor * litfog::opacity_at(air.fog, ray.length);
      for (const litfog::PlacedLight& lamp : lamps) {
        sky += litfog::airlight_unit(air) * litfog::airlight(lamp, air, ray) * lamp.light.color;
      }
      for (int i = 0; i < 3; ++i) {
        const double drawn = picture.data(unsigned(x), unsigned(y))[i];
        largest = std::max(largest, std::abs(drawn - 255 * std::min(sky[i], 1.0)));
      }
    }
  }
  return largest;
}

int main(int count, char** arguments) {
  if (!make_context()) return std::fprintf(stderr, "EGL gives no OpenGL without a window\n"), 3;
  const osg::ref_ptr<osg::Group> scene = new osg::Group;
  if (!scene->addChild(osgDB::readRefNodeFile(count > 1 ? arguments[1] : "street.osgt"))) return 1;
  const osg::ref_ptr<osg::ShapeDrawable> sky = new osg::ShapeDrawable(new osg::Box({0, kSky + 1, 0}, 4000, 2, 4000));
  sky->setColor({0, 0, 0, 1});
  scene->addChild(sky);

  osgViewer::Viewer viewer;
  viewer.setUpViewerAsEmbeddedInWindow(0, 0, kWidth, kHeight);
  viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
  const osg::ref_ptr<osg::Image> picture = new osg::Image;
  picture->allocateImage(kWidth, kHeight, 1, GL_RGBA, GL_UNSIGNED_BYTE);
  osg::Camera& camera = *viewer.getCamera();
  camera.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
  camera.attach(osg::Camera::COLOR_BUFFER, picture);
  camera.setClearColor({0, 0, 0, 1});
  camera.setProjectionMatrixAsFrustum(-0.08, 0.08, -0.045, 0.045, 0.1, 1000);
  camera.setViewMatrixAsLookAt({0, 0, 1.7}, {0, 1, 1.7}, {0, 0, 1});
  camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
  viewer.setSceneData(scene);

  osg::StateSet& state = *scene->getOrCreateStateSet();
  osg::ref_ptr<osg::Program> program = new osg::Program;
  program->addShader(make_shader(osg::Shader::VERTEX, kVertex));
  program->addShader(make_shader(osg::Shader::FRAGMENT, kFragment));
  program->addBindUniformBlock("LitfogLightBlock", 0);
  state.setAttribute(program);
  state.addUniform(new osg::Uniform("eye", osg::Vec3(0, 1.7f, 0)));
  state.addUniform(new osg::Uniform("picture_size", osg::Vec2(kWidth, kHeight)));

  litfog::PlacedLight lamp;
  lamp.light.color = {0.8, 0.5, 0.3};
  lamp.light.attenuation = {1, 0, 0.02};
  std::vector<litfog::PlacedLight> placed;
  litfog::FogUpdater lamps;
  for (int i = 0; i < 240; ++i) {
    lamp.position = {i % 2 == 0 ? -8 : 8, 6, -15 - 5 * (i / 2)};
    placed.push_back(lamp);
    lamps.add(lamp);
  }
  litfog::LightClusters clusters;
  litfog::View view{.eye = kEye};
  view.right = kTangents.x;
  view.left = -view.right;
  view.top = kTangents.y;
  view.bottom = -view.top;
  double largest_error = 0;
  std::string ppm = "P6 320 540 255\n";
  for (const double visibility : {2000., 300., 80.}) {
    litfog::Atmosphere air{.fog = litfog::Fog::from_visibility(litfog::FogMode::exp, visibility)};
    air.ambient_fog_color = kFogColor;
    const litfog::FogLightChanges changes = lamps.set_fog(air.fog);
    if (!changes.kinds.empty()) {
      set_table<osg::Vec4Array>(state, 4, "litfog_kind_buffer", GL_RGBA32F_ARB, lamps.kinds().data(),
                                lamps.kinds().size_bytes());
    }
    if (!changes.instances.empty()) {
      set_table<osg::Vec4Array>(state, 5, "litfog_instance_buffer", GL_RGBA32F_ARB, lamps.instances().data(),
                                lamps.instances().size_bytes());
    }
    lamps.bound_lights(clusters, air);
    if (clusters.update(view)) {
      set_table<osg::UIntArray>(state, 6, "litfog_cluster_buffer", GL_R32UI, clusters.table().data(),
                                clusters.table().size_bytes());
    }
    litfog::FogLightBlock block{};
    block.header = litfog::pack_fog_header(air, 0);
    osg::ref_ptr<osg::FloatArray> floats = new osg::FloatArray(sizeof block / sizeof(float));
    std::memcpy(floats->asVector().data(), &block, sizeof block);
    floats->setBufferObject(new osg::UniformBufferObject);
    state.setAttribute(new osg::UniformBufferBinding(0, floats, 0, sizeof block));

    viewer.frame();
    largest_error = std::max(largest_error, sky_error(*picture, placed, air));
    for (int y = kHeight - 1; y >= 0; --y) {
      for (int x = 0; x < kWidth; ++x) {
        ppm.append(reinterpret_cast<const char*>(picture->data(unsigned(x), unsigned(y))), 3);
      }
    }
  }
  if (count > 2 && !std::ofstream(arguments[2], std::ios::binary).write(ppm.data(), std::ssize(ppm)).flush()) return 1;
  std::printf("sky within %.2f of 255\n", largest_error);
  return largest_error <= 2 ? 0 : 1;
}
