// SPDX-License-Identifier: Apache-2.0
#include "python/module.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "airlight/require_rays.h"
#include "litfog/airlight.h"
#include "litfog/attenuation.h"
#include "litfog/batch.h"
#include "litfog/color_temperature.h"
#include "litfog/cone.h"
#include "litfog/directional_airlight.h"
#include "litfog/flash.h"
#include "litfog/fog.h"
#include "litfog/multiple_scattering.h"
#include "litfog/runway_visual_range.h"
#include "litfog/scattered_beam.h"
#include "litfog/solve.h"
#include "litfog/updater.h"
#include "model/float_limit.h"

namespace litfog::python {
namespace {

std::string name_of(const py::object& object) { return "litfog." + str_of(object.attr("__class__").attr("__name__")); }

/// "mode=litfog.FogMode.exp, density=0.5"
std::string fields_text(const py::object& object, const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& field : fields) {
    const py::object value = object.attr(field.c_str());
    // The repr() of an enumerator, "<FogMode.exp: 0>", does not read back; its str() does.
    const bool is_enumerator = py::hasattr(py::type::of(value), "__members__");
    text += (text.empty() ? "" : ", ") + field + "=";
    text += is_enumerator ? "litfog." + str_of(value) : str_of(py::repr(value));
  }
  return text;
}

template <typename Function>
void add_method(const py::object& type, const char* name, const Function& method, const char* text = "") {
  type.attr(name) = py::cpp_function(method, py::name(name), py::is_method(type), text);
}

py::tuple values_of(const py::object& record, const std::vector<std::string>& fields) {
  py::tuple values(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i) values[i] = record.attr(fields[i].c_str());
  return values;
}

PyTypeObject* instance_base() { return reinterpret_cast<PyTypeObject*>(py::detail::get_internals().instance_base); }

/// pybind11's tp_new under another address, because Python compares a class's with its base's.
PyObject* new_instance(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  return instance_base()->tp_new(type, arguments, keywords);
}

/// tp_new of the base of all bound classes, which pybind11 shares among extensions and answers by abort() where it has
/// no C++ class to construct: litfog.Light.__base__(), or a Python class of that base.
newfunc base_tp_new = nullptr;
PyObject* new_bound_instance(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  if (!py::detail::all_type_info(type).empty()) return base_tp_new(type, arguments, keywords);
  PyErr_Format(PyExc_TypeError, "cannot create '%s' instances", type->tp_name);
  return nullptr;
}

/// The enumerator of a value, as enum.Enum has it, or of a name; pybind11 would make one of any number.
PyObject* enumerator_of(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  static const char* const kNames[] = {"value", nullptr};
  PyObject* value = nullptr;
  if (!PyArg_ParseTupleAndKeywords(arguments, keywords, "O", const_cast<char**>(kNames), &value)) return nullptr;
  try {
    const py::handle given(value);
    const bool is_of_another = Py_TYPE(value) != type && py::hasattr(given, "__members__");
    const bool is_number = PyIndex_Check(value) != 0 && !is_of_another;
    const bool is_name = PyUnicode_Check(value) != 0;
    std::string known;
    const py::handle enumeration(reinterpret_cast<PyObject*>(type));
    for (const auto& [name, value_of_name] : enumeration.attr("__members__").cast<py::dict>()) {
      auto member = py::reinterpret_borrow<py::object>(value_of_name);
      const py::int_ number(member);
      if (is_name ? given.equal(name)
                  : is_number && number.equal(py::int_(py::reinterpret_borrow<py::object>(given)))) {
        return member.release().ptr();
      }
      known += known.empty() ? "" : is_name ? " or " : ", ";
      const auto word = name.cast<std::string>();
      known += is_name ? '"' + word + '"' : str_of(number) + " (" + word + ")";
    }
    PyErr_Format(PyExc_ValueError, is_name ? "%s = %R: must be %s" : "%s = %R: must be one of %s", type->tp_name, value,
                 known.c_str());
  } catch (py::error_already_set& error) {
    error.restore();
  }
  return nullptr;
}

/// Makes errors of two ways to an instance whose C++ value was never constructed, which pybind11 would read:
/// Fog.__new__(Fog), which Python refuses where the class has another tp_new than its base; and object.__reduce__(),
/// which calls it.
void close_classes(const py::module_& m) {
  if (instance_base()->tp_new != &new_bound_instance) {
    base_tp_new = std::exchange(instance_base()->tp_new, &new_bound_instance);
  }
  for (const auto& [name, value] : m.attr("__dict__").cast<py::dict>()) {
    if (!PyType_Check(value.ptr())) continue;
    auto* type = reinterpret_cast<PyTypeObject*>(value.ptr());
    if (!PyType_IsSubtype(type, instance_base())) continue;
    type->tp_new = &new_instance;
    const auto type_object = py::reinterpret_borrow<py::object>(value);
    if (py::hasattr(type_object, "__members__")) {
      type->tp_new = &enumerator_of;
      add_method(type_object, "__reduce__", [](const py::object& self) {
        return py::make_tuple(self.attr("__class__"), py::make_tuple(py::int_(self)));
      });
    } else if (!type_object.attr("__dict__").contains("__reduce__")) {
      add_method(type_object, "__reduce__", [](const py::object& self) -> py::object {
        throw py::type_error("cannot pickle a " + name_of(self));
      });
    }
  }
}

}  // namespace

void make_record(const py::object& type, std::initializer_list<const char*> names) {
  const std::vector<std::string> fields(names.begin(), names.end());
  add_method(type, "__eq__", [fields](const py::object& self, const py::object& other) -> py::object {
    if (!py::type::of(self).is(py::type::of(other))) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
    return py::bool_(values_of(self, fields).equal(values_of(other, fields)));
  });
  add_method(type, "__hash__", [fields](const py::object& self) { return py::hash(values_of(self, fields)); });
  add_method(type, "__repr__",
             [fields](const py::object& self) { return name_of(self) + "(" + fields_text(self, fields) + ")"; });
  add_method(
      type, "replace",
      [fields](const py::object& self, const py::kwargs& changes) {
        py::dict values;
        for (const std::string& field : fields) values[field.c_str()] = self.attr(field.c_str());
        for (const auto& [field, value] : changes) {
          if (!values.contains(field)) throw py::type_error(name_of(self) + " has no field " + str_of(py::str(field)));
          values[field] = value;
        }
        return py::type::of(self)(**values);
      },
      "A copy with other values of the fields named, checked like a new one.");
  make_picklable(type, names);
}

void make_picklable(const py::object& type, std::initializer_list<const char*> names) {
  const std::vector<std::string> fields(names.begin(), names.end());
  add_method(type, "__reduce__", [fields](const py::object& self) {
    return py::make_tuple(self.attr("__class__"), values_of(self, fields));
  });
}

void show_fields(const py::object& type, std::initializer_list<const char*> names) {
  const std::vector<std::string> fields(names.begin(), names.end());
  add_method(type, "__repr__",
             [fields](const py::object& self) { return "<" + name_of(self) + ": " + fields_text(self, fields) + ">"; });
}

py::dtype make_dtype(std::initializer_list<Member> members) {
  py::list description;
  for (const Member& member : members) {
    description.append(member.width == 1 ? py::make_tuple(member.name, member.format)
                                         : py::make_tuple(member.name, member.format, py::make_tuple(member.width)));
  }
  return py::dtype::from_args(description);
}

py::array view(const py::dtype& dtype, std::vector<py::ssize_t> shape, const void* data, const py::object& owner) {
  py::array array(dtype, std::move(shape), {}, data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

namespace {

/// An argument as the array that it must be: of this dtype. Results are written where they lie, so that an array for
/// them has to be contiguous.
py::array take_array(const py::object& object, const std::string& name, const py::dtype& dtype, bool is_written) {
  const auto refuse_type = [&name, &dtype](const std::string& what_it_is) {
    throw py::type_error(name + ": must be a NumPy array of " + str_of(dtype) + ", is " + what_it_is);
  };
  if (!py::isinstance<py::array>(object)) {
    refuse_type("of type " + str_of(py::type::of(object).attr("__name__")));
  }
  expect_plain_values(object, name);
  auto array = py::reinterpret_borrow<py::array>(object);
  if (!array.dtype().equal(dtype)) refuse_type("one of " + str_of(array.dtype()));
  constexpr int kNeeded = int(py::array::c_style) | int(py::detail::npy_api::NPY_ARRAY_ALIGNED_);
  if (!is_written) return py::array::ensure(array, kNeeded);
  if ((array.flags() & kNeeded) != kNeeded) throw py::value_error(name + ": must be contiguous and aligned");
  if (!array.writeable()) throw py::value_error(name + ": must be writeable");
  return array;
}

/// The bytes of arrays that a call reads and writes. No result may overlap any other array of the call.
class Overlaps {
 public:
  void add(const py::array& array, const std::string& name, bool is_written) {
    const auto* begin = static_cast<const std::byte*>(array.data());
    const Bytes bytes{begin, begin + array.nbytes(), name, is_written};
    for (const Bytes& other : arrays_) {
      if ((bytes.is_written || other.is_written) && bytes.begin < other.end && other.begin < bytes.end) {
        throw py::value_error(name + ": must not overlap " + other.name);
      }
    }
    arrays_.push_back(bytes);
  }

 private:
  struct Bytes {
    const std::byte* begin;
    const std::byte* end;
    std::string name;
    bool is_written;
  };
  std::vector<Bytes> arrays_;
};

// --- batch ---

/// Where a batch's results go: arrays, or None for what is not computed. The intensity always is.
struct Solutions {
  py::object intensity;
  py::object peak_range = py::none();
  py::object extent = py::none();
  py::object status = py::none();
  std::size_t invalid_count = 0;
};

/// Numbers of a batch's lights as Python has them.
struct LightColumn {
  const char* name;
  py::object numbers;
};
enum : std::size_t { kConstant, kLinear, kQuadratic, kDensity, kThreshold, kColumns };
using Lights = std::array<LightColumn, kColumns>;

/// Whether lights are solved in floats: all arrays among their columns are.
bool are_floats(const Lights& lights) {
  const auto is_array = [](const LightColumn& column) { return py::isinstance<py::array>(column.numbers); };
  const auto is_other = [&](const LightColumn& column) {
    return is_array(column) && !py::reinterpret_borrow<py::array>(column.numbers).dtype().equal(py::dtype::of<float>());
  };
  return std::ranges::any_of(lights, is_array) && std::ranges::none_of(lights, is_other);
}

template <typename Real>
void solve_columns(FogMode mode, const Lights& lights, std::optional<Solutions>& out) {
  std::array<Numbers<Real>, kColumns> numbers;
  std::optional<py::ssize_t> array_size;
  const auto check = [](const py::array& column, const std::string& name, py::ssize_t size) {
    if (column.ndim() != 1) {
      throw py::value_error(name + ": must have one dimension, has " + std::to_string(column.ndim()));
    }
    if (column.size() != size) {
      throw py::value_error(name + ": must have " + std::to_string(size) + " values, has " +
                            std::to_string(column.size()));
    }
  };
  for (std::size_t i = 0; i < kColumns; ++i) {
    numbers[i] = take_numbers<Real>(lights[i].numbers, lights[i].name);
    if (numbers[i].ndim() == 0) continue;  // one number for all lights
    if (!array_size) array_size = numbers[i].size();
    check(numbers[i], lights[i].name, *array_size);
  }
  const py::ssize_t size = array_size.value_or(1);
  Overlaps overlaps;
  const auto column = [&](std::size_t i) {
    if (numbers[i].ndim() == 0 && i < kDensity) {
      Numbers<Real> repeated(size);
      std::fill_n(repeated.mutable_data(), size, *numbers[i].data());
      numbers[i] = std::move(repeated);
    }
    overlaps.add(numbers[i], lights[i].name, false);
    return std::span(numbers[i].data(), std::size_t(numbers[i].size()));
  };
  const BasicBatchLights<Real> taken{.constant = column(kConstant),
                                     .linear = column(kLinear),
                                     .quadratic = column(kQuadratic),
                                     .threshold = column(kThreshold),
                                     .density = column(kDensity)};
  if (!out) {
    const auto empty = [size](const py::dtype& dtype) { return py::array(dtype, std::vector{size}); };
    const auto real = py::dtype::of<Real>();
    out = Solutions{empty(real), empty(real), empty(real), empty(py::dtype::of<std::uint8_t>())};
  }
  const auto take_result = [&]<typename T>(const py::object& object, const std::string& name, std::span<T>& result) {
    const py::array array = take_array(object, name, py::dtype::of<T>(), true);
    check(array, name, size);
    overlaps.add(array, name, true);
    result = {static_cast<T*>(const_cast<void*>(array.data())), std::size_t(size)};
  };
  BasicBatchSolutions<Real> results;
  std::span<std::uint8_t> status;
  take_result(out->intensity, "out.intensity", results.intensity);
  if (!out->peak_range.is_none()) take_result(out->peak_range, "out.peak_range", results.peak_range);
  if (!out->extent.is_none()) take_result(out->extent, "out.extent", results.extent);
  if (!out->status.is_none()) take_result(out->status, "out.status", status);
  static_assert(sizeof(BatchStatus) == 1);
  results.status = {reinterpret_cast<BatchStatus*>(status.data()), status.size()};
  const py::gil_scoped_release released;
  out->invalid_count = solve_fog_intensities(mode, taken, results);
}

/// out  a Solutions, which is returned, or None
py::object solve_batch(const Lights& lights, FogMode mode, const py::object& out) {
  std::optional<Solutions> solutions;
  if (!out.is_none()) {
    if (!py::isinstance<Solutions>(out)) {
      throw py::type_error("out: must be a BatchSolutions, is of type " + str_of(py::type::of(out).attr("__name__")));
    }
    solutions = out.cast<Solutions>();
  }
  (are_floats(lights) ? solve_columns<float> : solve_columns<double>)(mode, lights, solutions);
  if (out.is_none()) return py::cast(std::move(*solutions));
  out.cast<Solutions&>().invalid_count = solutions->invalid_count;
  return out;
}

// --- airlight ---

static_assert(sizeof(EyeRay) == 7 * sizeof(double) && offsetof(EyeRay, direction) == 3 * sizeof(double) &&
              offsetof(EyeRay, length) == 6 * sizeof(double));

py::dtype eye_ray_dtype() { return make_dtype({{"origin", "f8", 3}, {"direction", "f8", 3}, {"length", "f8", 1}}); }

/// Whether an object is a ray as a tuple of its origin, direction and length, or a list of those.
bool are_ray_tuples(const py::handle& rays) {
  if (py::isinstance<py::tuple>(rays)) return py::len(rays) == 3;
  if (!py::isinstance<py::list>(rays)) return false;
  const auto list = rays.cast<py::list>();
  return std::all_of(list.begin(), list.end(), &are_ray_tuples);
}

py::array take_rays(const py::object& rays) {
  expect_plain_values(rays, "rays");
  const py::dtype dtype = eye_ray_dtype();
  if (py::hasattr(rays, "dtype")) return take_array(py::array::ensure(rays), "rays", dtype, false);
  try {
    if (are_ray_tuples(rays)) return py::module_::import("numpy").attr("array")(rays, dtype);
  } catch (const py::error_already_set&) {
  }
  throw py::type_error("rays: must be an array of EYE_RAY, or tuples of an origin, a direction and a length");
}

/// Numbers along rays, a plain one of a single ray: call takes both spans without the GIL.
template <typename Call>
py::object along_rays(const py::object& rays, const py::object& out, const Call& call) {
  const py::array ray_array = take_rays(rays);
  const std::vector<py::ssize_t> shape{ray_array.shape(), ray_array.shape() + ray_array.ndim()};
  py::array numbers =
      out.is_none() ? py::array_t<double>(shape) : take_array(out, "out", py::dtype::of<double>(), true);
  if (!std::equal(shape.begin(), shape.end(), numbers.shape(), numbers.shape() + numbers.ndim())) {
    throw py::value_error("out: must have the shape " + str_of(py::tuple(py::cast(shape))) + ", has " +
                          str_of(numbers.attr("shape")));
  }
  Overlaps overlaps;
  overlaps.add(ray_array, "rays", false);
  overlaps.add(numbers, "out", true);
  const std::span rays_read(static_cast<const EyeRay*>(ray_array.data()), std::size_t(ray_array.size()));
  const std::span results(static_cast<double*>(numbers.mutable_data()), rays_read.size());
  {
    const py::gil_scoped_release released;
    call(rays_read, results);
  }
  return out.is_none() && shape.empty() ? numbers.attr("item")() : numbers;
}

py::object airlights_of(const PlacedLight& light, const Atmosphere& atmosphere, const py::object& rays,
                        LampLeg lamp_leg, const py::object& out) {
  return along_rays(rays, out, [&](auto from, auto to) { airlight(light, atmosphere, from, lamp_leg, to); });
}

py::object reference_airlights_of(const PlacedLight& light, const Atmosphere& atmosphere, const py::object& rays,
                                  LampLeg lamp_leg, const py::object& out) {
  return along_rays(rays, out, [&](auto from, auto to) {
    require_rays(from);
    std::ranges::transform(from, to.begin(),
                           [&](const EyeRay& ray) { return reference_airlight(light, atmosphere, ray, lamp_leg); });
  });
}

py::object directional_airlights_of(const Atmosphere& atmosphere, const Given<glm::dvec3>& to_light,
                                    const py::object& rays, const py::object& out) {
  const glm::dvec3 direction = to_light.value("to_light");
  return along_rays(rays, out, [&](auto from, auto to) { directional_airlight(atmosphere, direction, from, to); });
}

py::array_t<float> scattering_table_of(const Atmosphere& atmosphere) {
  const ScatteringTable table = make_scattering_table(atmosphere);
  return py::array_t<float>({kScatteringDepths, kScatteringAngles}, table.logs[0].data());
}

ScatteringTable take_table(const py::object& table) {
  const py::array given = take_array(table, "table", py::dtype::of<float>(), false);
  if (given.ndim() != 2 || given.shape(0) != kScatteringDepths || given.shape(1) != kScatteringAngles) {
    throw py::value_error("table: must be one of make_scattering_table, has the shape " + str_of(given.attr("shape")));
  }
  ScatteringTable copy;
  std::memcpy(&copy, given.data(), sizeof copy);
  return copy;
}

py::object scattering_along(const PlacedLight& light, const Atmosphere& atmosphere, const py::object& table,
                            const py::object& rays, const py::object& out) {
  const ScatteringTable copy = take_table(table);
  return along_rays(rays, out, [&](auto from, auto to) { multiple_scattering(light, atmosphere, copy, from, to); });
}

static_assert(sizeof(ThinBeams::Row) == (3 * kBeamOrders + 1) * sizeof(double) &&
              sizeof(ScatteredBeam::Texel) == 4 * sizeof(float) && sizeof(DiffuseLight) == 4 * sizeof(double));

py::dtype thin_beam_dtype() {
  return make_dtype({{"share", "f8", kBeamOrders},
                     {"radial", "f8", kBeamOrders},
                     {"turned", "f8", kBeamOrders},
                     {"forward", "f8", 1}});
}

py::array thin_beams_of(const Atmosphere& atmosphere, const py::object& table) {
  const ThinBeams beams = make_thin_beams(atmosphere, take_table(table));
  return py::array(thin_beam_dtype(), std::vector<py::ssize_t>{kBeamDepths}, beams.rows.data());
}

ScatteringSource source_of(const Light& light, const Atmosphere& atmosphere, const py::object& beams) {
  const py::array given = take_array(beams, "beams", thin_beam_dtype(), false);
  if (given.ndim() != 1 || given.size() != kBeamDepths) {
    throw py::value_error("beams: must be those of make_thin_beams, has the shape " + str_of(given.attr("shape")));
  }
  ThinBeams copy;
  std::memcpy(&copy, given.data(), sizeof copy);
  return scattering_source(light, atmosphere, copy);
}

/// Numbers whose last axis is a vector.
Numbers<double> take_vectors(const py::object& object, const std::string& name, py::ssize_t size) {
  Numbers<double> vectors = take_numbers(object, name);
  if (vectors.ndim() == 0 || vectors.shape(vectors.ndim() - 1) != size) {
    throw py::value_error(name + ": must have a last axis of " + std::to_string(size) + ", has the shape " +
                          str_of(vectors.attr("shape")));
  }
  return vectors;
}

py::array_t<double> scattered_lights_of(const PlacedLight& light, const ScatteringSource& source,
                                        const Atmosphere& atmosphere, const py::object& positions) {
  const Numbers<double> from = take_vectors(positions, "positions", 3);
  std::vector<py::ssize_t> shape{from.shape(), from.shape() + from.ndim()};
  shape.back() = 4;
  py::array_t<double> lights(shape);
  const std::span places(reinterpret_cast<const glm::dvec3*>(from.data()), std::size_t(from.size() / 3));
  const std::span results(reinterpret_cast<DiffuseLight*>(lights.mutable_data()), places.size());
  const py::gil_scoped_release released;
  scattered_light(light, source, atmosphere, places, results);
  return lights;
}

py::object irradiances_of(const py::object& light, const py::object& normal) {
  const auto call = [](double all, double x, double y, double z, double normal_x, double normal_y, double normal_z) {
    return irradiance({all, {x, y, z}}, {normal_x, normal_y, normal_z});
  };
  const py::array lights = take_vectors(light, "light", 4), normals = take_vectors(normal, "normal", 3);
  const auto part = [](const py::array& of, int i) {
    return py::array_t<double>(of[py::make_tuple(py::ellipsis(), i)]);
  };
  return py::vectorize(call)(part(lights, 0), part(lights, 1), part(lights, 2), part(lights, 3), part(normals, 0),
                             part(normals, 1), part(normals, 2));
}

// --- the updater ---

py::dtype kind_dtype() { return make_dtype({{"attenuation_extent", "f4", 4}, {"cone_scale_intensity", "f4", 4}}); }
py::dtype instance_dtype() {
  return make_dtype({{"position_kind", "f4", 4}, {"axis_profile", "f4", 4}, {"color", "f4", 4}});
}

py::dtype source_dtype() { return make_dtype({{"intensity", "f4", 1}, {"soft_range", "f4", 1}}); }

/// An updater whose tables stay where they are while arrays show them, as a bytearray does with its buffers. Only
/// adding and changing lights can move them. Its calls keep the GIL, which makes them safe on any thread.
struct Updater : FogUpdater {
  using FogUpdater::FogUpdater;

  void require_no_views() const {
    if (views != 0) {
      throw py::buffer_error("views of the updater's tables exist: a light can be added or changed once they are gone");
    }
  }

  std::size_t views = 0;
};

template <typename Entry>
py::array view_table(const std::shared_ptr<Updater>& updater, std::span<const Entry> table, const py::dtype& dtype) {
  const py::capsule owner(new std::shared_ptr<Updater>(updater), [](void* pointer) {
    const std::unique_ptr<std::shared_ptr<Updater>> held(static_cast<std::shared_ptr<Updater>*>(pointer));
    --(*held)->views;
  });
  ++updater->views;
  return view(dtype, {py::ssize_t(table.size())}, table.data(), owner);
}

struct Changes {
  py::list kinds, instances, sources;
};

py::list slices(std::span<const EntryRange> ranges) {
  py::list list;
  for (const EntryRange& range : ranges) list.append(py::slice(py::ssize_t(range.begin), py::ssize_t(range.end), 1));
  return list;
}

Changes changes_of(const FogLightChanges& found) {
  return {slices(found.kinds), slices(found.instances), slices(found.sources)};
}

/// A value that keeps its rule. C++ leaves that to the caller, in functions for inner loops.
double require_rule(bool is_kept, const char* field, double value, const char* rule) {
  if (!is_kept) require(ValueError{field, value, rule});
  return value;
}

double require_within(double low, double high, const char* field, double value, const char* rule) {
  return snapped(require_rule(is_within(value, low, high), field, value, rule), low, high);
}

double require_range(double range) { return require_rule(range >= 0, "range", range, "must be >= 0"); }

/// function(value, number) for a number or for each of an array of them, which is the argument of this name.
template <typename Value, typename Function>
auto over_numbers(const char* name, const Function& function) {
  return [name, function](const Value& value, const py::object& numbers) {
    const auto of_number = [&](double number) { return function(value, number); };
    return py::vectorize(of_number)(take_numbers(numbers, name));
  };
}

/// A struct with which find_error() finds nothing wrong.
template <typename T>
const T& require_checked(const T& value) {
  require(find_error(value));
  return value;
}

void bind_lights(py::module_& m) {
  py::enum_<FogMode>(m, "FogMode", "How the fog factor f falls with range.")
      .value("exp", FogMode::exp, "f(r) = e^(-d r)")
      .value("exp2", FogMode::exp2, "f(r) = e^(-(d r)^2)");
  m.attr("CONTRAST_MOR") = kContrastMor;
  m.attr("CONTRAST_KOSCHMIEDER") = kContrastKoschmieder;
  m.attr("CONTRAST_FLIGHTGEAR") = kContrastFlightgear;
  m.attr("DEFAULT_THRESHOLD") = kDefaultThreshold;

  bind_record<Fog>(m, "Fog", "Homogeneous fog. density: 1/m, >= 0; 0 is clear air, infinity total fog.",
                   field("mode", &Fog::mode, "FogMode"), field("density", &Fog::density, "1/m, >= 0"))
      .def_static(
          "from_visibility",
          [](FogMode mode, const Given<double>& metres, const Given<double>& contrast) {
            return Fog::from_visibility(mode, metres.value("metres"), contrast.value("contrast"));
          },
          py::arg("mode"), py::arg("metres"), py::arg("contrast") = kContrastMor,
          "The fog of a visibility: metres >= 0, infinity is no fog; contrast in (0, 1) is what is left of a\n"
          "dark object's contrast at that range. ValueError with field, value and rule.")
      .def_static(
          "from_runway_visual_range",
          [](FogMode mode, const Given<double>& metres, const Given<double>& candela,
             const Given<double>& illuminance_threshold) {
            return fog_from_runway_visual_range(
                mode, metres.value("metres"),
                {candela.value("candela"), illuminance_threshold.value("illuminance_threshold")});
          },
          py::arg("mode"), py::arg("metres"), py::arg("candela") = RunwayLights{}.candela,
          py::arg("illuminance_threshold") = RunwayLights{}.illuminance_threshold,
          "The fog of a runway visual range, at which lamps of these candela reach the threshold in lux, or markings\n"
          "that of their contrast: at night, 550 m is a visibility of 155 m. ValueError with field, value and rule.");
  bind_record<PhaseLobe>(m, "PhaseLobe", "A lobe of a phase function, Draine's.",
                         field("asymmetry", &PhaseLobe::asymmetry, "g, (-1, 1); > 0 forward"),
                         field("alpha", &PhaseLobe::alpha, "[0, 1e6]; 0 is Henyey and Greenstein's function"));
  bind_record<Phase>(m, "Phase", "A phase function of two lobes; by default isotropic.",
                     field("first", &Phase::first, "PhaseLobe"), field("second", &Phase::second, "PhaseLobe"),
                     field("weight", &Phase::weight, "[0, 1], of the first lobe; the second has the rest"))
      .def_static(
          "henyey_greenstein", [](double asymmetry) { return require_checked(Phase::henyey_greenstein(asymmetry)); },
          py::arg("asymmetry"), "One lobe, g in (-1, 1).")
      .def_static("droplets", &Phase::droplets, py::arg("micrometres"),
                  "Fog of water droplets of a diameter, 5 to 50. ValueError with field, value and rule.");
  bind_record<FogLayer>(m, "FogLayer",
                        "A layer of fog, metres. Transition bands lie outside it, in which the density falls\n"
                        "linearly to 0.",
                        field("base", &FogLayer::base, "metres; -infinity: it has no base"),
                        field("top", &FogLayer::top, "metres, above the base; infinity: it has no top"),
                        field("transition", &FogLayer::transition, "metres, finite, >= 0: height of each band"),
                        field("visibility", &FogLayer::visibility, "metres, >= 1e-290; infinity is no fog"));
  using Knots = std::vector<std::pair<double, double>>;
  const auto profile_of = [](const Knots& pairs) {
    std::vector<DensityKnot> knots;
    for (const auto& [height, density] : pairs) knots.push_back({height, density});
    return make_density_profile(knots);
  };
  const auto knots_of = [](const DensityProfile& profile) {
    Knots pairs;
    for (const auto& [height, density] : profile.used()) pairs.emplace_back(height, density);
    return py::tuple(py::cast(pairs));
  };
  py::class_<DensityProfile> density(m, "DensityProfile",
                                     "Density of exp fog over height: linear between up to 8 knots, constant beyond.");
  density.def(py::init(profile_of), py::arg("knots") = Knots{})
      .def_property_readonly("knots", knots_of, "(height in metres, density in 1/m) of each; heights rise")
      .def_static(
          "from_layers",
          [](const std::vector<FogLayer>& layers, double contrast) { return make_density_profile(layers, contrast); },
          py::arg("layers"), py::arg("contrast") = kContrastMor,
          "The profile of layers, which add up where they overlap. ValueError with field, value and rule.");
  make_record(density, {"knots"});
  bind_record<Atmosphere>(
      m, "Atmosphere", "All that the air is. Its density at a height is the fog's plus the profile's.",
      field("fog", &Atmosphere::fog, "Fog"), field("phase", &Atmosphere::phase, "Phase"),
      field("albedo", &Atmosphere::albedo, "[0, 1]: the fraction of the light taken by the fog that it scatters"),
      field("top", &Atmosphere::top,
            "metres: height at which rays to the sky leave the fog, if no layer is there or higher"),
      field("ambient_fog_color", &Atmosphere::ambient_fog_color, "linear RGB, finite, >= 0"),
      field("profile", &Atmosphere::profile, "DensityProfile: layers, in exp fog only"))
      .def(
          "fog_between",
          [](const Atmosphere& air, double height_a, double height_b) { return air.fog_between(height_a, height_b); },
          py::arg("height_a"), py::arg("height_b"),
          "Uniform fog of the mean density between two heights: the fog factor of a straight line from one to the\n"
          "other is that in it. At equal heights it is the fog there.");
  m.def(
      "visibility", [](const Fog& seen, double contrast) { return visibility(seen, contrast); }, py::arg("fog"),
      py::arg("contrast") = kContrastMor, "The visibility of a fog, metres: the inverse of Fog.from_visibility().");
  m.def("phase_at",
        over_numbers<Phase>("cosine",
                            [](const Phase& phase, double cosine) {
                              return phase_at(phase, require_within(-1, 1, "cosine", cosine, "must be in [-1, 1]"));
                            }),
        py::arg("phase"), py::arg("cosine"),
        "A phase function at cosines of the angle of scattering: 1 is straight ahead. Its mean over all directions is\n"
        "1. Numbers or arrays.");
  m.def(
      "density_from_visibility",
      [](FogMode mode, const py::object& metres, double contrast) {
        const auto density = [mode, contrast](double each) {
          return Fog::from_visibility(mode, each, contrast).density;
        };
        return py::vectorize(density)(take_numbers(metres, "metres"));
      },
      py::arg("mode"), py::arg("metres"), py::arg("contrast") = kContrastMor,
      "The density of Fog.from_visibility in 1/m; metres are a number or an array.");

  m.def(
      "runway_visual_range",
      [](const Fog& air_fog, const py::object& candela, const py::object& illuminance_threshold) {
        const auto range = [&](double lamp, double seen) { return runway_visual_range(air_fog, {lamp, seen}); };
        return py::vectorize(range)(take_numbers(candela, "candela"),
                                    take_numbers(illuminance_threshold, "illuminance_threshold"));
      },
      py::arg("fog"), py::arg("candela") = RunwayLights{}.candela,
      py::arg("illuminance_threshold") = RunwayLights{}.illuminance_threshold,
      "The runway visual range of a fog in metres, the inverse of Fog.from_runway_visual_range; numbers or\n"
      "arrays.");
  m.def(
      "illuminance_threshold",
      [](const py::object& background) {
        const auto threshold = [](double each) {
          require_background(each);
          return illuminance_threshold(each);
        };
        return py::vectorize(threshold)(take_numbers(background, "background"));
      },
      py::arg("background"),
      "The lux at the eye from which a lamp is seen before a background of these cd/m2, after ICAO; numbers or\n"
      "arrays.");

  bind_record<Attenuation>(
      m, "Attenuation",
      "Range attenuation a(r) = min(1, 1 / (constant + linear r + quadratic r^2)), r in metres. Each is finite and\n"
      ">= 0, not all are 0.",
      field("constant", &Attenuation::constant, "dimensionless"), field("linear", &Attenuation::linear, "1/m"),
      field("quadratic", &Attenuation::quadratic, "1/m^2"));

  py::enum_<ConeProfile> profile(m, "ConeProfile", "How a light's intensity falls with the angle from its axis.");
  for (const ConeProfileFacts& facts : kConeProfiles) profile.value(facts.name, facts.profile, facts.meaning);
  py::class_<Cone> cone(m, "Cone", "Angular shape of a light. Angles are radians from the axis (half angles).");
  cone.def(py::init([](ConeProfile profile, double half_angle, double exponent, double inner, double outer) {
             return require_checked(Cone{profile, half_angle, exponent, inner, outer});
           }),
           py::arg("profile") = ConeProfile(), py::arg("half_angle") = 0., py::arg("exponent") = 0.,
           py::arg("inner") = 0., py::arg("outer") = 0.)
      .def_readonly("profile", &Cone::profile, "ConeProfile")
      .def_static(
          "cosine",
          [](double half_angle, double exponent) { return require_checked(Cone::cosine(half_angle, exponent)); },
          py::arg("half_angle"), py::arg("exponent"), "A cosine cone (Hales 2004).")
      .def_static(
          "smoothstep", [](double inner, double outer) { return require_checked(Cone::smoothstep(inner, outer)); },
          py::arg("inner"), py::arg("outer"), "The dual cone of the Cg Tutorial.");
  for (const ConeProfileFacts& facts : kConeProfiles) {
    for (const ConeParameter& each : facts.parameters) {
      cone.def_readonly(each.name(), each.member, (std::string(facts.name) + ": " + each.meaning).c_str());
    }
  }
  make_record(cone, {"profile", "half_angle", "exponent", "inner", "outer"});

  using FlashTuple = std::tuple<double, double, double>;
  py::class_<Flash> flash(
      m, "Flash",
      "How a lamp flashes: it is dark except in its flashes, which recur in each period. A lamp without is steady.");
  flash
      .def(py::init([](double period, const std::vector<FlashTuple>& tuples) {
             if (tuples.size() > kMaxFlashes) fail_count("flashes", tuples.size(), "must be at most 8");
             Flash made{.period = period};
             for (const auto& [start, duration, intensity] : tuples) {
               made.flashes[made.count++] = {start, duration, intensity};
             }
             return require_checked(made);
           }),
           py::arg("period") = 0., py::arg("flashes") = std::vector<FlashTuple>())
      .def_readonly("period", &Flash::period, "seconds, (0, 3600]")
      .def_property_readonly(
          "flashes",
          [](const Flash& each) {
            std::vector<FlashTuple> tuples;
            for (const auto& [start, duration, intensity] : std::span(each.flashes).first(each.count)) {
              tuples.emplace_back(start, duration, intensity);
            }
            return py::tuple(py::cast(tuples));
          },
          "At most 8, one after the other: start and duration in seconds, and the factor of the light's colour.");
  make_record(flash, {"period", "flashes"});
  m.def("flash_at",
        over_numbers<Flash>("seconds",
                            [](const Flash& each, double seconds) {
                              require_time(seconds);
                              return flash_at(each, seconds);
                            }),
        py::arg("flash"), py::arg("seconds"),
        "The factor of the light's colour at times in [0, 1e9]; numbers or arrays.");

  bind_record<Light>(
      m, "Light", "A kind of light: what a light file holds.", field("name", &Light::name, "UTF-8"),
      field("color", &Light::color, "linear RGB, finite, >= 0; 1 is the display's white"),
      field("attenuation", &Light::attenuation, "Attenuation"),
      field("threshold", &Light::threshold, "(0, 1): attenuation at which the light ends"),
      field("cone", &Light::cone, "Cone"),
      field("density_scale", &Light::density_scale, "finite, >= 0: its class sees this fraction of the fog's density"),
      field("source_radius", &Light::source_radius,
            "metres: radius of the lamp's luminous disc for photometric(); 0: none is known"),
      field("flash", &Light::flash, "Flash: when the lamp is lit; only what takes a time reads it"));
  m.def("photometric", &photometric, py::arg("light"),
        "The light as it is near the lamp, a disc of its source radius, without the clamp of its range attenuation.");
  m.def("candela", &candela, py::arg("light"),
        "The light's far intensity on its axis in candela, a component a colour; infinite without a quadratic term.");

  bind_record<PlacedLight>(m, "PlacedLight", "A light in a scene. World space, metres.",
                           field<true>("light", &PlacedLight::light, "Light"),
                           field("position", &PlacedLight::position, "each coordinate at most 2^24 in magnitude"),
                           field("direction", &PlacedLight::direction, "axis of the cone; its length is 1 within 1e-6"),
                           field("carried", &PlacedLight::carried,
                                 "by the eye's vehicle: such lights, and only they, light the fog by Hales's term"));

  m.def("attenuation_at",
        over_numbers<Attenuation>(
            "range", [](const Attenuation& of, double range) { return attenuation_at(of, require_range(range)); }),
        py::arg("attenuation"), py::arg("range"),
        "a(r), the fraction of its near brightness that a light has at ranges in metres; numbers or arrays.");
  m.def("fog_factor_at",
        over_numbers<Fog>("range",
                          [](const Fog& seen, double range) { return fog_factor_at(seen, require_range(range)); }),
        py::arg("fog"), py::arg("range"),
        "Fog factor f(r), the fraction of light that the fog lets through; numbers or arrays.");
  m.def(
      "opacity_at",
      over_numbers<Fog>("range", [](const Fog& seen, double range) { return opacity_at(seen, require_range(range)); }),
      py::arg("fog"), py::arg("range"),
      "Opacity 1 - f(r), without the cancellation of the plain form; numbers or arrays.");
  m.def(
      "cone_at",
      over_numbers<Cone>("cos_angle",
                         [](const Cone& shape, double cos_angle) {
                           return cone_at(shape, require_within(-1, 1, "cos_angle", cos_angle, "must be in [-1, 1]"));
                         }),
      py::arg("cone"), py::arg("cos_angle"),
      "Fraction of the axial intensity that a cone sends into a direction, by the cosine of its angle from the axis;\n"
      "numbers or arrays.");
  m.def("compute_extent",
        over_numbers<Attenuation>("threshold", py::overload_cast<const Attenuation&, double>(&compute_extent)),
        py::arg("attenuation"), py::arg("threshold") = kDefaultThreshold,
        "The range in metres at which the attenuation falls to a threshold; numbers or arrays.");
  m.def("flux_within",
        over_numbers<Cone>("angle",
                           [](const Cone& shape, double angle) {
                             return flux_within(
                                 shape, require_within(0, std::numbers::pi, "angle", angle, "must be in [0, pi]"));
                           }),
        py::arg("cone"), py::arg("angle"),
        "Flux in steradians of a cone whose axial intensity is 1, out to angles in radians; numbers or arrays.");
  m.def("angle_at_level",
        over_numbers<Cone>("level",
                           [](const Cone& shape, double level) {
                             const bool is_kept = level > 0 && level < 1;
                             return angle_at_level(shape, require_rule(is_kept, "level", level, "must be in (0, 1)"));
                           }),
        py::arg("cone"), py::arg("level"),
        "Angle in radians up to which a cone keeps a fraction of its axial intensity; numbers or arrays.");
  m.def(
      "color_of_temperature",
      [](const py::object& kelvin) -> py::object {
        const Numbers<double> temperatures = take_numbers(kelvin, "kelvin");
        if (temperatures.ndim() == 0) return py::cast(color_of_temperature(*temperatures.data()));
        std::vector<glm::dvec3> colors;
        for (const double each : std::span(temperatures.data(), std::size_t(temperatures.size()))) {
          colors.push_back(color_of_temperature(each));
        }
        std::vector<py::ssize_t> shape{temperatures.shape(), temperatures.shape() + temperatures.ndim()};
        shape.push_back(3);
        return own(std::move(colors), py::dtype::of<double>(), shape);
      },
      py::arg("kelvin"),
      "A colour temperature, 1000 to 25000 K, as linear sRGB whose largest component is 1: a tuple, or of an array of\n"
      "temperatures an array with one more axis.");
}

void bind_solve(py::module_& m) {
  py::enum_<SolveStatus>(m, "SolveStatus", "How a solve ended.")
      .value("ok", SolveStatus::ok, "the fields hold the supremum to the stated error")
      .value("not_converged", SolveStatus::not_converged, "intensity is a lower bound, taken at peak_range");
  // Python's own, so that its values equal the numbers in a column of status.
  m.attr("BatchStatus") = py::module_::import("enum").attr("IntEnum")(
      "BatchStatus",
      py::dict(py::arg("ok") = int(BatchStatus::ok), py::arg("not_converged") = int(BatchStatus::not_converged),
               py::arg("invalid") = int(BatchStatus::invalid)),
      py::arg("module") = "litfog");
  m.attr("BatchStatus").attr("__doc__") =
      "What became of a light of a batch: the values of a column of status. ok: solved to the stated error;\n"
      "not_converged: as SolveStatus.not_converged; invalid: an argument breaks its rule, and intensity, peak range\n"
      "and extent are 0.";
  bind_record<FogIntensity>(
      m, "FogIntensity", "Fog colour intensity of a light and where it is taken.",
      field<true>("intensity", &FogIntensity::intensity, "[0, 1]"),
      field<true>("peak_range", &FogIntensity::peak_range, "metres, [0, extent]; may be infinity"),
      field<true>("extent", &FogIntensity::extent, "metres"),
      field<true>("status", &FogIntensity::status, "SolveStatus"));

  const char* solve_doc =
      "Fog colour intensity of a light: the supremum over [0, extent] of opacity(r) * attenuation(r), to 2 ulp.\n"
      "A Light sees the fog at its density scale. ValueError with field, value and rule.";
  m.def("solve_fog_intensity", py::overload_cast<const Attenuation&, const Fog&, double>(&solve_fog_intensity),
        py::arg("attenuation"), py::arg("fog"), py::arg("threshold") = kDefaultThreshold, solve_doc);
  m.def("solve_fog_intensity", py::overload_cast<const Light&, const Fog&>(&solve_fog_intensity), py::arg("light"),
        py::arg("fog"), solve_doc);

  py::class_<Solutions>(
      m, "BatchSolutions",
      "Where a batch's results go: one-dimensional arrays, or None for what, besides the intensity, is not to\n"
      "be computed. Columns of real numbers have the type in which lights are solved, status is uint8.")
      .def(py::init([](py::object intensity, py::object peak_range, py::object extent, py::object status) {
             return Solutions{std::move(intensity), std::move(peak_range), std::move(extent), std::move(status)};
           }),
           py::arg("intensity"), py::arg("peak_range") = py::none(), py::arg("extent") = py::none(),
           py::arg("status") = py::none())
      .def_readonly("intensity", &Solutions::intensity, "[0, 1]")
      .def_readonly("peak_range", &Solutions::peak_range, "metres")
      .def_readonly("extent", &Solutions::extent, "metres")
      .def_readonly("status", &Solutions::status, "values of BatchStatus")
      .def_readonly("invalid_count", &Solutions::invalid_count, "how many lights of the last solve were invalid");
  show_fields(m.attr("BatchSolutions"), {"intensity", "peak_range", "extent", "status", "invalid_count"});
  m.def(
      "solve_fog_intensities",
      [](py::object constant, py::object linear, py::object quadratic, py::object density, py::object threshold,
         FogMode mode, const py::object& out) {
        return solve_batch({{{"constant", std::move(constant)},
                             {"linear", std::move(linear)},
                             {"quadratic", std::move(quadratic)},
                             {"density", std::move(density)},
                             {"threshold", std::move(threshold)}}},
                           mode, out);
      },
      py::arg("constant"), py::arg("linear"), py::arg("quadratic"), py::arg("density"),
      py::arg("threshold") = kDefaultThreshold, py::arg("mode") = FogMode::exp, py::kw_only(),
      py::arg("out") = py::none(),
      "solve_fog_intensity for many lights by SIMD. Columns have one dimension; a number stands for all lights. They\n"
      "are solved in float32 where all arrays among them are, else in float64; contiguous arrays of that type are\n"
      "read where they lie. Returns BatchSolutions: out, whose arrays have that type, or new columns. No result may\n"
      "overlap another column. Invalid lights are counted and marked, not raised. Releases the GIL. TypeError and\n"
      "ValueError for columns that do not fit.");
}

void bind_airlight(py::module_& m) {
  py::enum_<LampLeg>(m, "LampLeg", "A light's own leg through the fog, from the lamp to where it is scattered.")
      .value("clear", LampLeg::clear, "nothing is lost on it, as in Hales's model")
      .value("fogged", LampLeg::fogged, "the fog factor is lost on it (single scattering)");
  m.attr("EYE_RAY") = eye_ray_dtype();
  m.def(
      "airlight", &airlights_of, py::arg("light"), py::arg("atmosphere"), py::arg("rays"),
      py::arg("lamp_leg") = LampLeg::fogged, py::kw_only(), py::arg("out") = py::none(),
      "Airlight of a PlacedLight along rays from the eye: what of it the fog scatters into the eye, to be multiplied\n"
      "with its colour. rays: an array of dtype EYE_RAY and any shape, read where it lies if it is contiguous, or a\n"
      "tuple of origin, direction and length, or a list of those; the direction is unit, the length is metres to the\n"
      "surface or infinity. Returns out, or a new float64 array of the same shape, or a number. Errs by at most 1/255\n"
      "in isotropic fog; docs/accuracy.md has other fogs. Releases the GIL. "
      "ValueError with field, value and rule, before any result is written.");
  m.def("reference_airlight", &reference_airlights_of, py::arg("light"), py::arg("atmosphere"), py::arg("rays"),
        py::arg("lamp_leg") = LampLeg::fogged, py::kw_only(), py::arg("out") = py::none(),
        "airlight() by adaptive quadrature, for comparisons: it takes some 100 times as long.");
  const char* axial_doc =
      "Airlight of a light along its own axis, the eye at the light, the light's leg clear; never below the fog\n"
      "colour intensity. ValueError with field, value and rule.";
  m.def("axial_airlight", py::overload_cast<const Attenuation&, const Fog&, double>(&axial_airlight),
        py::arg("attenuation"), py::arg("fog"), py::arg("threshold") = kDefaultThreshold, axial_doc);
  m.def("axial_airlight", py::overload_cast<const Light&, const Fog&>(&axial_airlight), py::arg("light"),
        py::arg("fog"), axial_doc);
  const auto reaches = [](const Light& light, const Fog& fog, const py::object& budget, LampLeg lamp_leg) {
    return py::vectorize([&](double each) { return light_reach(light, fog, each, lamp_leg); })(
        take_numbers(budget, "budget"));
  };
  m.def("light_reach", reaches, py::arg("light"), py::arg("fog"), py::arg("budget"),
        py::arg("lamp_leg") = LampLeg::fogged,
        "The range in metres beyond which a light shows on no surface and in no fog by as much as the budget, a\n"
        "fraction of its colour in (0, 1); numbers or arrays.");
  m.def(
      "reach_budget",
      [](double step, std::size_t lights, const py::object& brightness, const Atmosphere& atmosphere) {
        return py::vectorize([&](double each) { return reach_budget(step, lights, each, atmosphere); })(
            take_numbers(brightness, "brightness"));
      },
      py::arg("step"), py::arg("lights"), py::arg("brightness"), py::arg("atmosphere"),
      "The budget of light_reach at which all that lights add beyond their reaches stays below a step of a picture,\n"
      "in linear light. brightness: the largest component of a light's colour, a number or an array.");
  m.def(
      "directional_airlight", &directional_airlights_of, py::arg("atmosphere"), py::arg("to_light"), py::arg("rays"),
      py::kw_only(), py::arg("out") = py::none(),
      "Airlight of a directional light, such as the sun or the moon, along rays, to be multiplied with its colour;\n"
      "as it enters the fog: at the atmosphere's top, or where that is infinite at 1200 m above height 0, wherever\n"
      "the ground is. The fog is exp, to_light unit; rays and out as for airlight. Releases the GIL. ValueError with\n"
      "field, value and rule, before any result is written.");
  m.def(
      "directional_fog_factor",
      [](const Atmosphere& atmosphere, const Given<glm::dvec3>& to_light, const py::object& height) {
        const glm::dvec3 direction = to_light.value("to_light");
        return py::vectorize([&](double each) { return directional_fog_factor(atmosphere, direction, each); })(
            take_numbers(height, "height"));
      },
      py::arg("atmosphere"), py::arg("to_light"), py::arg("height"),
      "The fraction of a directional light that passes through the fog down to heights in metres, numbers or arrays.\n"
      "It lights surfaces there.");
  m.def(
      "make_scattering_table", &scattering_table_of, py::arg("atmosphere"),
      "Light that an atmosphere's phase function scatters twice and more often from a point lamp: a float32 array of\n"
      "optical depths by angles, the texture of litfog/shaders/multiple_scattering.glsl. ValueError unless the fog is\n"
      "exp, its albedo 1, and it is isotropic, of one lobe with alpha 0 and g in [0, 0.95], or of droplets.");
  m.def("effective_intensity",
        over_numbers<Attenuation>(
            "density", [](const Attenuation& of, double density) { return effective_intensity(of, density); }),
        py::arg("attenuation"), py::arg("density"),
        "The intensity of a lamp with 1 / r^2 that loses as much light to fog of a density as a light with an\n"
        "attenuation does, m^2. Densities are finite and > 0; numbers or arrays.");
  m.def("multiple_scattering", &scattering_along, py::arg("light"), py::arg("atmosphere"), py::arg("table"),
        py::arg("rays"), py::kw_only(), py::arg("out") = py::none(),
        "Light that the fog scatters twice and more often into the eye along rays, to be added to airlight and\n"
        "multiplied with the light's colour. table: make_scattering_table(atmosphere); rays and out as for airlight.\n"
        "Releases the GIL. ValueError with field, value and rule, before any result is written.");
  m.attr("THIN_BEAM") = thin_beam_dtype();
  m.def("make_thin_beams", &thin_beams_of, py::arg("atmosphere"), py::arg("table"),
        "What the scattered light of all lamps is made of: an array of dtype THIN_BEAM by optical depth. table:\n"
        "make_scattering_table(atmosphere).");
  py::class_<ScatteringSource>(m, "ScatteringSource", "A light as the fog around it scatters it.")
      .def_readonly("intensity", &ScatteringSource::intensity,
                    "m^2, as effective_intensity, of the densest layer; 0 in clear or total fog")
      .def_readonly("soft_range", &ScatteringSource::soft_range,
                    "metres within which a lamp of 1 / r^2 counts as one that is weaker near it")
      .def_readonly("phase_cosine", &ScatteringSource::phase_cosine, "mean cosine of the phase function")
      .def_readonly("is_cone", &ScatteringSource::is_cone, "else a point lamp")
      .def_property_readonly(
          "beam",
          [](const py::object& self) {
            const auto& texels = self.cast<const ScatteringSource&>().beam.texels;
            return view(py::dtype::of<float>(), {kBeamDepths, kBeamAngles, 4}, texels.data(), self);
          },
          "a read-only float32 array: the rows of a beam in the texture litfog_scattered_beams of\n"
          "litfog/shaders/multiple_scattering.glsl");
  show_fields(m.attr("ScatteringSource"), {"intensity", "soft_range", "phase_cosine", "is_cone"});
  m.def("scattering_source", &source_of, py::arg("light"), py::arg("atmosphere"), py::arg("beams"),
        "A light as the fog scatters it. beams: make_thin_beams of the atmosphere.");
  m.def(
      "scattered_light", &scattered_lights_of, py::arg("light"), py::arg("source"), py::arg("atmosphere"),
      py::arg("positions"),
      "Light of a lamp that the fog around positions has scattered, to be multiplied with its colour. positions:\n"
      "an array with a last axis of 3. Returns one with a last axis of 4: the sum over all directions, and the flow.\n"
      "The arrays of several lamps add up. Releases the GIL. ValueError with field, value and rule.");
  m.def("irradiance", &irradiances_of, py::arg("light"), py::arg("normal"),
        "What surfaces receive of light as scattered_light has it, by their normals, an array with a last axis of 3\n"
        "and length 1: in the unit of attenuation * cone * fog factor * cosine, which the lamp itself gives them.");
}

void bind_updater(py::module_& m) {
  m.attr("FOG_LIGHT_KIND") = kind_dtype();
  m.attr("FOG_LIGHT_INSTANCE") = instance_dtype();
  m.attr("FOG_LIGHT_SOURCE") = source_dtype();
  py::class_<FogLightHandle>(m, "FogLightHandle", "A light that a FogUpdater holds.")
      .def(
          "__eq__", [](const FogLightHandle& a, const FogLightHandle& b) { return a == b; }, py::is_operator())
      .def("__hash__", [](const FogLightHandle& a) { return std::uint64_t{a.generation} << 32 | a.slot; })
      .def("__repr__", [](const FogLightHandle& a) {
        return "<litfog.FogLightHandle: light " + std::to_string(a.slot) + ", generation " +
               std::to_string(a.generation) + ">";
      });
  py::class_<Changes>(m, "FogLightChanges", "What must be uploaded again: sorted, disjoint slices of each table.")
      .def_readonly("kinds", &Changes::kinds, "slices of FogUpdater.kinds")
      .def_readonly("instances", &Changes::instances, "slices of FogUpdater.instances")
      .def_readonly("sources", &Changes::sources, "slices of FogUpdater.sources");
  show_fields(m.attr("FogLightChanges"), {"kinds", "instances", "sources"});
  py::class_<FogUpdateStatistics>(m, "FogUpdateStatistics", "What the last set_fog or set_atmosphere did.")
      .def_readonly("kinds_solved", &FogUpdateStatistics::kinds_solved, "kinds")
      .def_readonly("kinds_skipped", &FogUpdateStatistics::kinds_skipped, "the other kinds held")
      .def_readonly("lights_skipped", &FogUpdateStatistics::lights_skipped, "lights off, black, or of a skipped kind")
      .def_readonly("bytes_dirty", &FogUpdateStatistics::bytes_dirty, "of the entries in the slices returned")
      .def_readonly("sources_solved", &FogUpdateStatistics::sources_solved, "kinds whose source was solved");
  show_fields(m.attr("FogUpdateStatistics"),
              {"kinds_solved", "kinds_skipped", "lights_skipped", "bytes_dirty", "sources_solved"});
  py::class_<Updater, std::shared_ptr<Updater>>(
      m, "FogUpdater",
      "The lights of a scene as the shaders' tables, kept up to date through every change of the visibility. Lights\n"
      "that agree in all but name, colour, flash, position and direction share a kind; a change of the air touches\n"
      "kinds and sources alone. The tables have every change of lights after the next set_fog or set_atmosphere.")
      .def(py::init<double>(), py::arg("skip_budget_255") = kDefaultSkipBudget255)
      .def(
          "add",
          [](Updater& updater, const PlacedLight& light) {
            updater.require_no_views();
            return updater.add(light);
          },
          py::arg("light"), "Adds a light, switched on. BufferError while views of the tables exist.")
      .def(
          "change",
          [](Updater& updater, FogLightHandle handle, const PlacedLight& light) {
            updater.require_no_views();
            updater.change(handle, light);
          },
          py::arg("handle"), py::arg("light"),
          "Replaces a light. If it is switched off, it stays so. BufferError while views of the tables exist.")
      .def("switch_light", &Updater::switch_light, py::arg("handle"), py::arg("is_on"),
           "The instance of a light that is off is black.")
      .def("set_time", &Updater::set_time, py::arg("seconds"),
           "Moves the time, 0 before: lights that flash take the colour that they have then. Solves nothing.")
      .def("remove", &Updater::remove, py::arg("handle"), "Removes a light; its handle is then of no light.")
      .def(
          "set_fog", [](Updater& updater, const Fog& fog) { return changes_of(updater.set_fog(fog)); }, py::arg("fog"),
          "Brings the tables up to date with the fog and the lights. Returns what has changed or is new.")
      .def(
          "set_atmosphere",
          [](Updater& updater, const Atmosphere& air, double eye_height) {
            return changes_of(updater.set_atmosphere(air, eye_height));
          },
          py::arg("atmosphere"), py::arg("eye_height") = 0.0,
          "The same of any air. Intensities of kinds are those in the fog at the eye's height, sources those of\n"
          "scattering_source in the densest fog. ValueError with field, value and rule.")
      .def_property_readonly(
          "kinds",
          [](const std::shared_ptr<Updater>& updater) { return view_table(updater, updater->kinds(), kind_dtype()); },
          "The table of kinds where it lies: a read-only array of dtype FOG_LIGHT_KIND, which set_fog changes.")
      .def_property_readonly(
          "instances",
          [](const std::shared_ptr<Updater>& updater) {
            return view_table(updater, updater->instances(), instance_dtype());
          },
          "The table of instances where it lies: a read-only array of dtype FOG_LIGHT_INSTANCE, which set_fog changes.")
      .def("solve_sources", &Updater::solve_sources,
           "Lets set_fog and set_atmosphere solve the source of each kind, too, for all orders of scattering.")
      .def_property_readonly(
          "sources",
          [](const std::shared_ptr<Updater>& updater) {
            return view_table(updater, updater->sources(), source_dtype());
          },
          "The sources, one a kind, where they lie: a read-only array of dtype FOG_LIGHT_SOURCE, which set_fog and\n"
          "set_atmosphere change. It is empty unless they are solved; set_fog has those of isotropic fog.")
      .def("instance_of", &Updater::instance_of, py::arg("handle"), "Index of a light among the instances.")
      .def("kind_of", &Updater::kind_of, py::arg("handle"), "Index of a light's kind.")
      .def_property_readonly(
          "statistics", [](const Updater& updater) { return updater.statistics(); }, "Of the last set_fog.")
      .def("__repr__", [](const Updater& updater) {
        return "<litfog.FogUpdater: " + std::to_string(updater.instances().size()) + " instances of " +
               std::to_string(updater.kinds().size()) + " kinds>";
      });
}

}  // namespace
}  // namespace litfog::python

PYBIND11_MODULE(_litfog, m) {
  m.attr("__name__") = "litfog";  // the package of everything below
  m.doc() =
      "How brightly lights make fog glow, with stated errors. Metres, densities in 1/m, angles in radians, colours in\n"
      "linear RGB. A value out of range raises ValueError with the field, the value and the rule.";
  m.attr("__version__") = LITFOG_VERSION;
  litfog::python::bind_lights(m);
  litfog::python::bind_solve(m);
  litfog::python::bind_airlight(m);
  litfog::python::bind_updater(m);
  litfog::python::bind_components(m);
  litfog::python::close_classes(m);
  m.attr("__name__") = "litfog._litfog";
}
