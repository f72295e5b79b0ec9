// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

#include "litfog/light.h"
#include "model/require.h"
#include "python/numbers.h"

/// A number that is not masked.
template <>
struct pybind11::detail::type_caster<double> {
  PYBIND11_TYPE_CASTER(double, const_name("float"));

  bool load(handle source, bool convert) {
    litfog::python::expect_plain_values(source, "number");
    make_caster<long double> number;
    if (!number.load(source, convert)) return false;
    value = double(cast_op<long double>(number));
    return true;
  }
  static handle cast(double number, return_value_policy, handle) { return PyFloat_FromDouble(number); }
};

/// A vector is a tuple of three floats; any sequence of three numbers is taken for one.
template <>
struct pybind11::detail::type_caster<glm::dvec3> {
  PYBIND11_TYPE_CASTER(glm::dvec3, const_name("Sequence[float]"));

  bool load(handle source, bool convert) {
    object numbers = reinterpret_borrow<object>(source);
    if (isinstance<array>(source)) {
      numbers = litfog::python::take_numbers(numbers, "vector");
    } else {
      litfog::python::expect_plain_values(source, "vector");
    }
    make_caster<std::array<double, 3>> three;
    if (!three.load(numbers, convert)) return false;
    const auto& [x, y, z] = cast_op<std::array<double, 3>&>(three);
    value = {x, y, z};
    return true;
  }
  static handle cast(const glm::dvec3& vector, return_value_policy, handle) {
    return make_tuple(vector.x, vector.y, vector.z).release();
  }
};

/// An enumerator is taken by its name, too: "exp" for FogMode.exp.
template <typename Enumeration>
struct pybind11::detail::type_caster<Enumeration, pybind11::detail::enable_if_t<std::is_enum_v<Enumeration>>>
    : type_caster_base<Enumeration> {
  bool load(handle source, bool convert) {
    if (!isinstance<str>(source)) return type_caster_base<Enumeration>::load(source, convert);
    return type_caster_base<Enumeration>::load(type::handle_of<Enumeration>()(source), convert);  // the class keeps it
  }
};

/// A light is taken by the name of a bundled one, too, or the path of its file, as read_light takes them.
template <>
struct pybind11::detail::type_caster<litfog::Light> : type_caster_base<litfog::Light> {
  bool load(handle source, bool convert) {
    if (!isinstance<str>(source)) return type_caster_base::load(source, convert);
    const object read = module_::import("litfog").attr("read_light")(source);
    loader_life_support::add_patient(read);
    return type_caster_base::load(read, convert);
  }
};

namespace litfog::python {

namespace py = pybind11;

/// An argument or a field as it is given, so that errors can name it.
template <typename T>
struct Given {
  py::object object;

  T value(const std::string& name) const {
    using Caster = py::detail::make_caster<T>;
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, glm::dvec3>) expect_plain_values(object, name);
    Caster caster;
    if (!object.is_none() && caster.load(object, true)) return py::detail::cast_op<T>(caster);
    std::string type = Caster::name.text;
    if constexpr (std::is_base_of_v<py::detail::type_caster_generic, Caster>) {
      type = str_of(py::type::of<T>().attr("__name__"));
    }
    throw py::type_error(name + ": must be " + type + ", is " + str_of(py::type::of(object).attr("__name__")));
  }
};

}  // namespace litfog::python

template <typename T>
struct pybind11::detail::type_caster<litfog::python::Given<T>> {
  PYBIND11_TYPE_CASTER(litfog::python::Given<T>, make_caster<T>::name);
  bool load(handle source, bool) {
    value.object = reinterpret_borrow<object>(source);
    return true;
  }
};

namespace litfog::python {

/// Gives a class of read-only fields equality, a hash, a repr() that reads back, replace() and pickling. Its
/// constructor takes the fields in this order, and refuses what is wrong.
void make_record(const py::object& type, std::initializer_list<const char*> fields);

/// A member of a struct as a field of its class; its constructor takes the struct's own default where none is required.
template <bool kIsRequired, typename Struct, typename T>
struct Field {
  using Value = T;
  const char* name;
  T Struct::*member;
  const char* meaning;
  auto getter() const {
    return [member = member](const Struct& of) -> const T& { return of.*member; };
  }
  auto argument() const {
    if constexpr (kIsRequired) {
      return py::arg(name);
    } else {
      return py::arg(name) = Struct{}.*member;
    }
  }
};
template <bool kIsRequired = false, typename Struct, typename T>
Field<kIsRequired, Struct, T> field(const char* name, T Struct::*member, const char* meaning) {
  return {name, member, meaning};
}

/// A class of a struct that is a record of these fields. Its constructor refuses what find_error() of the struct does.
template <typename Struct, typename... Fields>
py::class_<Struct> bind_record(py::module_& m, const char* name, const char* meaning, const Fields&... fields) {
  py::class_<Struct> type(m, name, meaning);
  const auto make = [fields...](const Given<typename Fields::Value>&... values) {
    Struct made{};
    ((made.*fields.member = values.value(fields.name)), ...);
    if constexpr (requires { find_error(made); }) require(find_error(made));
    return made;
  };
  type.def(py::init(make), fields.argument()...);
  (type.def_property_readonly(fields.name, fields.getter(), fields.meaning), ...);
  make_record(type, {fields.name...});
  return type;
}

/// Lets a class be pickled. Its constructor takes the fields in this order.
void make_picklable(const py::object& type, std::initializer_list<const char*> fields);

/// Gives a class that is no record a repr() of some of its fields.
void show_fields(const py::object& type, std::initializer_list<const char*> fields);

/// A structured dtype of float64 or float32 members; a width of 1 is a scalar.
struct Member {
  const char* name;
  const char* format;
  int width;
};
py::dtype make_dtype(std::initializer_list<Member> members);

/// The vector's memory as an array, which owns it from now on.
template <typename T>
py::array own(std::vector<T> values, const py::dtype& dtype, std::vector<py::ssize_t> shape) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
  return py::array(dtype, std::move(shape), {}, kept->data(), owner);
}

/// Memory of another object, which stays alive with the array, as an array that cannot be written.
py::array view(const py::dtype& dtype, std::vector<py::ssize_t> shape, const void* data, const py::object& owner);

/// Light files, photometric files and fits.
void bind_components(py::module_& module);

}  // namespace litfog::python
