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

/// Real numbers: one, a sequence of them, or an array of any layout and any dtype of real numbers, as float64. Text,
/// dates, complex numbers and objects are refused, though NumPy would make numbers of them.
///
/// throws  TypeError; what expect_plain_values() throws
pybind11::array_t<double> take_numbers(const pybind11::object& object, const std::string& name);

}  // namespace litfog::python
