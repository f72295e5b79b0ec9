// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>

namespace litfog::python {

/// str(object)
std::string str_of(const pybind11::object& object);

/// Refuses an array with masked values or with a unit, which plain values would drop, and a list of such arrays.
///
/// name    name of the argument
/// throws  ValueError for masked values, TypeError for a unit
void expect_plain_values(const pybind11::handle& object, const std::string& name);

/// A contiguous array.
template <typename Real>
using Numbers = pybind11::array_t<Real, pybind11::array::c_style | pybind11::array::forcecast |
                                            pybind11::detail::npy_api::NPY_ARRAY_ALIGNED_>;

/// An object of real numbers: one, a sequence of them, or an array of any layout and any dtype of real numbers. Text,
/// dates, complex numbers and objects are refused, though NumPy would make numbers of them.
///
/// returns  an object that Numbers accepts
/// throws   TypeError; like expect_plain_values()
pybind11::object expect_numbers(const pybind11::object& object, const std::string& name);

/// Real numbers as in expect_numbers(). An array that already fits is not copied.
template <typename Real = double>
Numbers<Real> take_numbers(const pybind11::object& object, const std::string& name) {
  return Numbers<Real>::ensure(expect_numbers(object, name));
}

}  // namespace litfog::python
