// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/pybind11.h>

#include <regex>

#include "apps/python/module.h"
#include "apps/report/json.h"

namespace bracket::python {

namespace py = pybind11;

namespace {

constexpr const char* documentation =
    "Something that you can mend. str() is one line: where, what is wrong, what was expected.\n\n"
    "file: str | None, the file that it is about\n"
    "line: int | None, counted from 1\n"
    "status: str, \"input_error\", \"mesh_error\", \"ill_posed\", \"budget_spent\", \"not_guaranteed\"\n"
    "message: str, the line without the place";

void raise(const scene::Error& error) {
  // Looked for at each time: nothing here outlives the module.
  const py::object type = py::module_::import("bracket").attr("Error");
  // "replace": file names hold any bytes.
  const auto text = [](const std::string& bytes) {
    return py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "replace"));
  };
  py::object raised = type(text(error.what()));
  py::object file = py::none(), line = py::none();
  if (std::smatch place; std::regex_match(error.where(), place, std::regex("(.+?):([0-9]{1,9})(:[0-9]+)?"))) {
    file = text(place[1]);
    line = py::int_(std::stoi(place[2]));
  } else if (!error.where().empty() && !error.where().starts_with("--set ")) {
    file = text(error.where());
  }
  raised.attr("file") = file;
  raised.attr("line") = line;
  raised.attr("status") = apps::name(error.status());
  raised.attr("message") = text(error.message());
  PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void add_error(py::module_& module) {
  module.attr("Error") =
      py::reinterpret_steal<py::object>(PyErr_NewExceptionWithDoc("bracket.Error", documentation, nullptr, nullptr));
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const scene::Error& error) {
      raise(error);
    }
  });
}

}  // namespace bracket::python
