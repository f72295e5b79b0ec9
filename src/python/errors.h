// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace litfog::python {

/// Raises InputError and OutputError of C++ as these classes of litfog's, from whatever function of this extension.
void translate_errors(const pybind11::object& input_error, const pybind11::object& output_error);

}  // namespace litfog::python
