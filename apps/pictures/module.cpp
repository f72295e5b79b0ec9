// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdint>

#include "command/option_rule.h"
#include "drawing/drawing.h"
#include "drawing/picture_file.h"
#include "drawing/picture_options.h"
#include "litfog/gl/headless_context.h"
#include "litfog/gl/unsupported.h"
#include "python/errors.h"
#include "python/module.h"
#include "render/plan/lighting_path.h"
#include "render/renderer.h"
#include "scene/file/scene_file.h"

namespace litfog::pictures {
namespace {

namespace py = pybind11;

std::string text_of(const py::handle& object) { return py::cast<std::string>(py::str(object)); }

/// A number as a command line has it, so that it reads back exactly.
std::string number_text(const py::handle& number) {
  if (PyIndex_Check(number.ptr())) return text_of(py::reinterpret_steal<py::object>(PyNumber_Index(number.ptr())));
  return text_of(py::repr(py::float_(py::reinterpret_borrow<py::object>(number))));
}

/// The value of an option: a word, a number, or numbers as the option separates them.
std::string value_text(const std::string& name, const py::handle& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  python::expect_plain_values(value, name);
  const bool is_number = PyNumber_Check(value.ptr()) && !py::isinstance<py::bool_>(value);
  if (is_number && !PySequence_Check(value.ptr())) return number_text(value);
  if (!PySequence_Check(value.ptr())) {
    throw py::type_error(name + ": must be a word, a number or a sequence of numbers, is of type " +
                         text_of(py::type::of(value).attr("__name__")));
  }
  std::string text;
  for (const py::handle& part : value) {
    if (!text.empty()) text += name == "size" ? 'x' : ',';
    text += PyNumber_Check(part.ptr()) ? number_text(part) : text_of(part);
  }
  return text;
}

/// Sets the options that keywords name, as a command line would.
void set_options(CLI::App& app, const py::kwargs& keywords) {
  const py::object json = py::module_::import("json").attr("dumps");
  for (const auto& [key, value] : keywords) {
    const std::string name = key.cast<std::string>();
    std::string option_name = "--" + name;
    std::ranges::replace(option_name, '_', '-');
    CLI::Option* const option = app.get_option_no_throw(option_name);
    if (option == nullptr || name.find('-') != name.npos) {
      throw py::type_error("render() got an unexpected keyword argument '" + name + "'");
    }
    if (value.is_none()) continue;
    if (name == "set") {
      if (!py::isinstance<py::dict>(value)) throw py::type_error("set: must be a dictionary of members and values");
      for (const auto& [member, change] : value.cast<py::dict>()) {
        const std::string to = py::isinstance<py::str>(change) ? change.cast<std::string>() : text_of(json(change));
        option->add_result(text_of(member) + "=" + to);
      }
    } else if (option->get_expected_max() == 0) {
      if (!py::isinstance<py::bool_>(value)) throw py::type_error(name + ": must be True or False");
      if (value.cast<bool>()) option->add_result("true");
    } else {
      option->add_result(value_text(name, value));
    }
    if (option->count() > 0) option->run_callback();
  }
}

/// A sentence on options with their names in Python: "--fov-deg = 0: must be ..." becomes "fov_deg = 0: must be ...".
std::string in_python(const std::string& sentence) {
  const py::cpp_function name = [](const py::object& match) { return match[py::int_(1)].attr("replace")("-", "_"); };
  return py::module_::import("re").attr("sub")("--([a-z-]+)", name, sentence).cast<std::string>();
}

/// A scene as a display would show it, and what it is made from.
struct Drawn {
  render::Picture light;
  std::vector<std::uint8_t> shown;
  double visibility;
  double exposure;
};

/// OpenGL's threads do not survive a fork: a child of a process that has drawn would wait for them for ever.
void expect_no_fork() {
  static std::atomic<pid_t> drawing_process = 0;
  pid_t process = 0;
  if (drawing_process.compare_exchange_strong(process, getpid()) || process == getpid()) return;
  throw gl::Unsupported(
      "this process was forked from one that has drawn, and OpenGL does not work in it: start processes by spawn or "
      "forkserver (multiprocessing.get_context(\"spawn\")), or draw in none before");
}

Drawn draw(const CLI::App& app, const drawing::SceneOptions& scene_options, const drawing::DrawingOptions& options) {
  scene::Scene scene = drawing::read_scene(scene_options);
  drawing::check_scene_options(app, scene);
  scene::move_to_time(scene, options.seconds);
  expect_no_fork();
  const gl::HeadlessContext context;
  render::Renderer renderer(scene, options.width, options.height, options.settings_of(*options.render.path));
  const auto [display, visibility] = drawing::set_fog_and_exposure(renderer, options);
  renderer.draw();
  Drawn drawn{.light = drawing::whole_light(renderer, renderer.read()),
              .shown = {},
              .visibility = visibility,
              .exposure = display.exposure.ev};
  drawn.shown = drawing::shown_pixels(drawing::displayed(drawn.light, scene.camera, display));
  return drawn;
}

py::object render(const py::object& picture_class, const py::object& scene, const py::kwargs& options) {
  CLI::App app;
  app.set_help_flag();
  drawing::SceneOptions scene_options;
  drawing::DrawingOptions drawing;
  drawing::add_picture_options(app, scene_options, drawing);
  scene_options.scene = py::module_::import("os").attr("fsencode")(scene).cast<std::string>();
  if (scene_options.scene.find('\0') != std::string::npos)
    throw py::value_error("scene: must not hold a null character");
  Drawn drawn;
  try {
    set_options(app, options);
    command::check_options(app, drawing::drawing_rules(drawing));
    const py::gil_scoped_release released;
    drawn = draw(app, scene_options, drawing);
  } catch (const CLI::ParseError& error) {
    throw py::value_error(in_python(error.what()));
  }
  const std::vector<py::ssize_t> shape{drawn.light.height, drawn.light.width, 3};
  return picture_class(python::own(std::move(drawn.light.rgb), py::dtype::of<float>(), shape),
                       python::own(std::move(drawn.shown), py::dtype::of<std::uint8_t>(), shape), drawn.visibility,
                       drawn.exposure);
}

std::vector<std::string> path_names() {
  std::vector<std::string> names;
  for (const render::LightingPath& path : render::all_paths()) names.emplace_back(path.name);
  return names;
}

}  // namespace
}  // namespace litfog::pictures

PYBIND11_MODULE(pictures, m) {
  namespace py = pybind11;
  using namespace litfog;
  m.doc() =
      "Pictures of scenes lit by lamps in fog as NumPy arrays, drawn without a display: what litfog-demo draws, by\n"
      "OpenGL 3.3 through EGL, on a GPU or in software.";
  const auto litfog = py::module_::import("litfog");
  python::translate_errors(litfog.attr("InputError"), litfog.attr("OutputError"));
  const py::exception<gl::Unsupported> unsupported =
      py::register_local_exception<gl::Unsupported>(m, "Unsupported", PyExc_RuntimeError);
  unsupported.attr("__doc__") = "This machine has no OpenGL 3.3 through EGL, or less of it than a picture needs.";

  const py::object picture_class =
      py::module_::import("collections")
          .attr("namedtuple")("Picture", "light shown visibility exposure", py::arg("module") = "litfog.pictures");
  picture_class.attr("__doc__") = "A picture that render() has drawn.";
  const auto document = [&picture_class](const char* field, const char* text) {
    picture_class.attr(field).attr("__doc__") = text;
  };
  document("light", "the scene's light, linear RGB: float32 of height, width and 3, the top row first");
  document(
      "shown",
      "the same as a display shows it, after the eye's glare, exposure, tone curve, sRGB and dither: uint8, as in the\n"
      "demo's .png");
  document("visibility", "metres; infinity in clear air");
  document("exposure", "EV by which shown is brighter than light");
  m.attr("Picture") = picture_class;
  m.def(
      "render",
      [picture_class](const py::object& scene, const py::kwargs& options) {
        return pictures::render(picture_class, scene, options);
      },
      py::arg("scene"),
      "Draws a scene: the name of one that comes with litfog (scenes()), or the path of a scene or glTF file. Returns\n"
      "a Picture.\n\n"
      "Keywords are the options of `litfog-demo SCENE` that change a picture, _ for -, with the same defaults, rules\n"
      "and meanings (`litfog-demo --help`): visibility=400, fog=\"exp2\", size=(640, 360), path=\"vertex\",\n"
      "camera=(2, 1.6, 4), exposure=\"auto\", no_skip=True. set takes a dictionary of members and values:\n"
      "set={\"lights[0].attenuation.quadratic\": 0.002}. None stands for the default.\n\n"
      "Each call reads the scene and compiles its shaders anew. Releases the GIL; calls may run on any threads at\n"
      "once, but not in a process that was forked from one that has drawn. ValueError with option, value and rule;\n"
      "InputError; Unsupported.");
  m.def("scenes", &scene::bundled_scenes, "Names of the scenes that come with litfog, sorted.");
  m.def("paths", &pictures::path_names, "Names of the lighting paths: the keyword path of render().");
}
