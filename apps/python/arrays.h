// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "scene/types.h"

/// NumPy's arrays and the library's vectors. Arrays that come in may be strided, of any byte order, lists or whatever
/// else NumPy makes an array of; what goes out is a copy, which belongs to Python.
namespace bracket::python {

namespace py = pybind11;

/// \param name of the argument, for messages
/// \throw TypeError unless its entries are real numbers; ValueError unless its shape is (n, dim)
template <int dim> std::vector<scene::Vector<dim>> points(const py::handle& array, const std::string& name);

/// Whole numbers, row by row.
struct Integers {
  std::vector<int> values;
  std::size_t rows = 0, columns = 0;
};
/// Of a shape (n, columns), columns being one of `columns`, or (n) where they have but a 1; without any entry in any
/// shape.
/// \throw TypeError unless its entries are integers; ValueError for other shapes, and for what is no int
Integers integers(const py::handle& array, const std::string& name, const std::vector<std::size_t>& columns);

/// A copy of `values`, which are the entries of an array of that shape. \pre as many
py::array_t<double> array_of(const double* values, std::vector<py::ssize_t> shape);
py::array_t<int> array_of(const int* values, std::vector<py::ssize_t> shape);

/// Shape (n, dim).
template <int dim> py::array_t<double> array_of_vectors(const std::vector<scene::Vector<dim>>& vectors) {
  return array_of(vectors.empty() ? nullptr : vectors.front().data(), {static_cast<py::ssize_t>(vectors.size()), dim});
}
/// Shape (n, columns) or, without columns, (n).
py::array_t<double> array_of(const std::vector<double>& values);
template <class Row> py::array_t<int> array_of_rows(const std::vector<Row>& rows) {
  const auto columns = static_cast<py::ssize_t>(std::tuple_size_v<Row>);
  return array_of(rows.empty() ? nullptr : rows.front().data(), {static_cast<py::ssize_t>(rows.size()), columns});
}

}  // namespace bracket::python
