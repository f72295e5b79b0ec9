// SPDX-License-Identifier: Apache-2.0
#include "python/errors.h"

#include <exception>
#include <string_view>
#include <system_error>

#include "litfog/files/output_error.h"
#include "litfog/input_error.h"

namespace litfog::python {
namespace {

namespace py = pybind11;

// Both classes are kept for as long as Python runs.
py::handle input_error_class;
py::handle output_error_class;

/// Our text as Python's own errors show it: names of files in it may not be UTF-8.
py::object text_of(std::string_view text) {
  return py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefaultAndSize(text.data(), py::ssize_t(text.size())));
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    const py::object raised = input_error_class(text_of(error.what()));
    raised.attr("file") = text_of(error.location().file);
    raised.attr("line") = error.location().line;
    raised.attr("column") = error.location().column;
    PyErr_SetObject(input_error_class.ptr(), raised.ptr());
  } catch (const OutputError& error) {
    PyErr_SetObject(output_error_class.ptr(), text_of(error.what()).ptr());
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::not_enough_memory) throw;
    PyErr_NoMemory();
  }
}

}  // namespace

void translate_errors(const py::object& input_error, const py::object& output_error) {
  input_error_class = input_error.inc_ref();
  output_error_class = output_error.inc_ref();
  py::register_local_exception_translator(&translate);
}

}  // namespace litfog::python
