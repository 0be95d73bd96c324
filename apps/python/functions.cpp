// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/python/functions.h"

#include <fmt/format.h>

#include <memory>

#include "scene/toml/expression.h"

namespace bracket::python {

namespace py = pybind11;

namespace {

double number(const py::handle& object) {
  const double value = PyFloat_AsDouble(object.ptr());
  if (value == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  return value;
}

template <int dim> scene::Function<dim> sampled(const py::handle& callable) {
  // Who drops the last copy of the function may not hold the GIL.
  const std::shared_ptr<const py::object> held(new py::object(py::reinterpret_borrow<py::object>(callable)),
                                               [](const py::object* object) {
                                                 const py::gil_scoped_acquire gil;
                                                 delete object;
                                               });
  return [held](const scene::Vector<dim>& x) {
    const py::gil_scoped_acquire gil;
    if constexpr (dim == 2) return number((*held)(x[0], x[1]));
    if constexpr (dim == 3) return number((*held)(x[0], x[1], x[2]));
  };
}

}  // namespace

template <int dim> scene::Function<dim> function_of(const py::handle& given, const std::string& name) {
  if (py::isinstance<py::str>(given)) return scene::parse_expression<dim>(given.cast<std::string>(), "");
  if (PyCallable_Check(given.ptr()) != 0) return sampled<dim>(given);
  if (PyNumber_Check(given.ptr()) != 0 && !PyBool_Check(given.ptr())) return number(given);
  throw py::type_error(fmt::format("{} must be a number, an expression in {}, or a callable f({}), not {}", name,
                                   dim == 2 ? "x and y" : "x, y and z", dim == 2 ? "x, y" : "x, y, z",
                                   py::str(py::type::of(given).attr("__name__")).cast<std::string>()));
}

template scene::Function<2> function_of<2>(const py::handle&, const std::string&);
template scene::Function<3> function_of<3>(const py::handle&, const std::string&);

}  // namespace bracket::python
