// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/headless_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "litfog/gl/unsupported.h"

namespace litfog::gl {
namespace {

bool can_load(const char* library) { return dlopen(library, RTLD_LAZY | RTLD_LOCAL) != nullptr; }  // for good

/// libepoxy opens these at the first call that needs them, and aborts where they are missing.
void expect_libraries() {
  if (!can_load("libEGL.so.1")) throw Unsupported("EGL is missing: libEGL.so.1 cannot be loaded (install libegl1)");
  if (!can_load("libOpenGL.so.0") && !can_load("libGL.so.1")) {
    throw Unsupported("OpenGL is missing: neither libOpenGL.so.0 nor libGL.so.1 can be loaded (install libgl1)");
  }
}

/// Displays to try, best first.
std::vector<EGLDisplay> candidate_displays() {
  std::vector<EGLDisplay> displays;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
      epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
    std::vector<EGLDeviceEXT> devices(16);
    EGLint count = 0;
    if (!eglQueryDevicesEXT(EGLint(devices.size()), devices.data(), &count)) count = 0;
    devices.resize(std::size_t(std::max(count, 0)));
    const auto is_hardware = [](EGLDeviceEXT device) {
      const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
      return !(extensions && std::string(extensions).find("EGL_MESA_device_software") != std::string::npos);
    };
    std::stable_partition(devices.begin(), devices.end(), is_hardware);
    for (EGLDeviceEXT device : devices) {
      displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
    }
  }
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  std::erase(displays, EGL_NO_DISPLAY);
  return displays;
}

/// A current 3.3 core context on an initialised display, or EGL_NO_CONTEXT.
EGLContext make_current_context(EGLDisplay display) {
  if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") ||
      !epoxy_has_egl_extension(display, "EGL_KHR_no_config_context") || !eglBindAPI(EGL_OPENGL_API)) {
    return EGL_NO_CONTEXT;
  }
  constexpr EGLint kAttributes[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
  if (context == EGL_NO_CONTEXT) return EGL_NO_CONTEXT;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return context;
  eglDestroyContext(display, context);
  return EGL_NO_CONTEXT;
}

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

HeadlessContext::HeadlessContext() {
  expect_libraries();
  if (!eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS)) {
    throw Unsupported("EGL without a display is missing: no EGL client extensions (is libEGL installed?)");
  }
  for (EGLDisplay display : candidate_displays()) {
    if (!eglInitialize(display, nullptr, nullptr)) continue;
    if (const EGLContext context = make_current_context(display); context != EGL_NO_CONTEXT) {
      display_ = display;
      context_ = context;
      return;
    }
    eglTerminate(display);
  }
  throw Unsupported("no EGL device gives an OpenGL 3.3 core context without a display (Mesa: install libgl1-mesa-dri)");
}

HeadlessContext::~HeadlessContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

std::string HeadlessContext::renderer() const { return gl_string(GL_RENDERER); }
std::string HeadlessContext::version() const { return gl_string(GL_VERSION); }

void check_errors(const char* place) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw std::logic_error("OpenGL error " + std::to_string(error) + " after " + place);
  }
}

}  // namespace litfog::gl
