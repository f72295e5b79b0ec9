// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

namespace litfog::python {

/// Makes every function of this extension raise C++'s InputError and OutputError as these Python classes.
void translate_errors(const pybind11::object& input_error, const pybind11::object& output_error);

}  // namespace litfog::python
