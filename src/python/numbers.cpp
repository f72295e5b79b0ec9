// SPDX-License-Identifier: Apache-2.0
#include "python/numbers.h"

#include <string_view>

namespace litfog::python {
namespace {

namespace py = pybind11;

/// Whether an array masks any of its values, or of their members, like arrays of numpy.ma.
bool has_masked_values(const py::handle& array) {
  const py::object mask = py::getattr(array, "mask", py::none());
  if (mask.is_none() || PyCallable_Check(mask.ptr())) return false;  // a method of pandas
  const auto bytes = py::array::ensure(mask).attr("tobytes")().cast<py::bytes>();
  return std::string_view(bytes).find('\1') != std::string_view::npos;
}

}  // namespace

std::string str_of(const py::object& object) { return py::cast<std::string>(py::str(object)); }

void expect_plain_values(const py::handle& object, const std::string& name) {
  if (py::isinstance<py::list>(object) || py::isinstance<py::tuple>(object)) {
    for (const py::handle& part : object) {
      if (!PyFloat_CheckExact(part.ptr())) expect_plain_values(part, name);
    }
    return;
  }
  if (PyFloat_Check(object.ptr()) || PyLong_Check(object.ptr())) return;
  if (has_masked_values(object)) {
    throw py::value_error(name + ": must hold no masked values; x.compressed() or x.filled() makes such an array");
  }
  for (const char* unit : {"unit", "units"}) {  // the attributes of astropy and of pint
    if (!py::hasattr(object, unit)) continue;
    throw py::type_error(name + ": must be plain numbers, has the unit " + str_of(object.attr(unit)));
  }
}

py::object expect_numbers(const py::object& object, const std::string& name) {
  expect_plain_values(object, name);
  if (PyFloat_Check(object.ptr()) || PyLong_Check(object.ptr())) return py::float_(object);
  const py::array array = py::array::ensure(object);
  if (!array) throw py::type_error(name + ": must be a number or an array of numbers");
  constexpr std::string_view kRealKinds = "fiub";
  if (kRealKinds.find(array.dtype().kind()) == kRealKinds.npos) {
    throw py::type_error(name + ": must be real numbers, is an array of " + str_of(array.dtype()));
  }
  return array;
}

}  // namespace litfog::python
