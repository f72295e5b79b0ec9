// SPDX-License-Identifier: Apache-2.0
#include "litfog/gl/headless_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <exception>
#include <initializer_list>
#include <latch>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

#include "litfog/gl/unsupported.h"

namespace litfog::gl {
namespace {

/// Loads, for good, the first library that can be loaded; null if there is none.
void* load(const char*& loaded, std::initializer_list<const char*> libraries) {
  for (const char* library : libraries) {
    loaded = library;
    if (void* const handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL)) return handle;
  }
  return nullptr;
}

void expect_functions(void* handle, const char* library, std::initializer_list<const char*> functions) {
  for (const char* function : functions) {
    if (!dlsym(handle, function)) throw Unsupported(std::string(library) + " is unusable: it lacks " + function);
  }
}

/// libepoxy opens these at the first call that needs them, and aborts if one of them or a function is missing.
void expect_libraries() {
  const char* library = nullptr;
  void* const egl = load(library, {"libEGL.so.1"});
  if (!egl) throw Unsupported("EGL is missing: libEGL.so.1 cannot be loaded (install libegl1)");
  expect_functions(egl, library,
                   {"eglBindAPI", "eglCreateContext", "eglDestroyContext", "eglGetCurrentContext",
                    "eglGetCurrentDisplay", "eglGetCurrentSurface", "eglGetError", "eglGetProcAddress", "eglInitialize",
                    "eglMakeCurrent", "eglQueryAPI", "eglQueryContext", "eglQueryString"});
  void* const gl = load(library, {"libOpenGL.so.0", "libGL.so.1"});
  if (!gl) throw Unsupported("OpenGL is missing: neither libOpenGL.so.0 nor libGL.so.1 can be loaded (install libgl1)");
  expect_functions(gl, library, {"glGetError", "glGetIntegerv", "glGetString"});
}

/// The number of threads that Mesa's software rasteriser starts (its src/gallium/drivers/llvmpipe/lp_screen.c).
std::size_t rasteriser_threads() {
  constexpr std::size_t kMost = 16;  // LP_MAX_THREADS
  const char* const asked = std::getenv("LP_NUM_THREADS");
  const std::size_t count = asked ? std::strtoul(asked, nullptr, 0) : std::thread::hardware_concurrency();
  return std::clamp(count, std::size_t{1}, kMost);
}

/// Mesa waits forever for the threads of its rasteriser if not all of them can start.
void expect_threads() {
  const std::size_t count = rasteriser_threads();
  std::vector<std::thread> threads;
  threads.reserve(count);
  std::latch end(1);
  std::string error;
  try {
    while (threads.size() < count) threads.emplace_back([&end] { end.wait(); });
  } catch (const std::exception& none) {
    error = none.what();
  }
  end.count_down();
  for (std::thread& thread : threads) thread.join();
  if (error.empty()) return;
  throw Unsupported("OpenGL needs " + std::to_string(count) + (count == 1 ? " thread, and " : " threads, and ") +
                    (threads.empty() ? "none" : "only " + std::to_string(threads.size())) + " can start: " + error);
}

/// Address space that Mesa takes to start, measured with Mesa 22.3 and LLVM 15 and rounded up.
constexpr std::size_t kDriverMiB = 320;

/// Mesa does not report that its driver lacks memory: it ends the process or reports that there is no driver.
class DriverMemory {
 public:
  DriverMemory() : space_(mmap(nullptr, kBytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {
    if (space_ != MAP_FAILED) return;
    throw Unsupported(
        "OpenGL needs " + std::to_string(kDriverMiB) +
        " MiB of memory to start, and this process cannot get them: " + std::generic_category().message(errno));
  }
  ~DriverMemory() { munmap(space_, kBytes); }
  DriverMemory(const DriverMemory&) = delete;
  DriverMemory& operator=(const DriverMemory&) = delete;

 private:
  static constexpr std::size_t kBytes = kDriverMiB << 20;
  void* space_;
};

/// Checks the memory for a context: the driver with the first one, threads with each.
void expect_room() {
  static std::atomic<bool> is_driver_loaded = false;
  std::optional<DriverMemory> memory;
  if (!is_driver_loaded) memory.emplace();
  expect_threads();  // their stacks take memory beside the driver's
  is_driver_loaded = true;
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

/// A current 3.3 core context on an initialised display, or EGL_NO_CONTEXT. Binds the OpenGL API.
///
/// is_refused  set if EGL gave a context but does not make it current on this thread
EGLContext make_current_context(EGLDisplay display, bool& is_refused) {
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
  is_refused = eglGetError() == EGL_BAD_ACCESS;
  eglDestroyContext(display, context);
  return EGL_NO_CONTEXT;
}

/// The thread's current API and context at construction.
struct Current {
  EGLenum api = eglQueryAPI();
  EGLDisplay display = eglGetCurrentDisplay();
  EGLContext context = eglGetCurrentContext();
  EGLSurface draw = eglGetCurrentSurface(EGL_DRAW);
  EGLSurface read = eglGetCurrentSurface(EGL_READ);

  void restore() const {
    eglBindAPI(api);
    if (context != EGL_NO_CONTEXT) eglMakeCurrent(display, draw, read, context);
  }
};

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

// A display is never terminated: the whole process shares it, and eglTerminate ends every context on it.
struct HeadlessContext::Egl {
  Egl() {
    bool is_refused = false;
    for (EGLDisplay candidate : candidate_displays()) {
      if (!eglInitialize(candidate, nullptr, nullptr)) continue;
      display = candidate;
      context = make_current_context(display, is_refused);
      if (context != EGL_NO_CONTEXT) return;
    }
    previous.restore();
    if (is_refused) throw Unsupported("EGL makes no context current on this thread, because it has one of GLX");
    throw Unsupported(
        "no EGL device gives an OpenGL 3.3 core context without a display (Mesa: install libgl1-mesa-dri)");
  }
  ~Egl() {
    if (eglGetCurrentContext() == context) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      previous.restore();
    }
    eglDestroyContext(display, context);
  }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;

  Current previous;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

HeadlessContext::HeadlessContext() {
  expect_room();
  expect_libraries();
  if (!eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS)) {
    throw Unsupported("EGL without a display is missing: no EGL client extensions (is libEGL installed?)");
  }
  egl_ = std::make_unique<Egl>();
}

HeadlessContext::~HeadlessContext() = default;

std::string HeadlessContext::renderer() const { return gl_string(GL_RENDERER); }
std::string HeadlessContext::version() const { return gl_string(GL_VERSION); }

}  // namespace litfog::gl
