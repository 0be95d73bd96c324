// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/python/arrays.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

namespace bracket::python {

namespace {

std::string shape_of(const py::array& array) {
  std::vector<py::ssize_t> shape(array.shape(), array.shape() + array.ndim());
  return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

/// \param kinds of NumPy's types that are taken
py::array as_array(const py::handle& object, const std::string& name, std::string_view kinds, const char* expected) {
  // By NumPy itself: it raises what it cannot do.
  py::array array = py::module_::import("numpy").attr("asarray")(object);
  if (array.size() > 0 && kinds.find(array.dtype().kind()) == std::string_view::npos)
    throw py::type_error(fmt::format("{} must be an array of {}, is one of {}", name, expected,
                                     py::str(array.dtype()).cast<std::string>()));
  return array;
}

template <class Number> py::array_t<Number> copy_of(const Number* values, const std::vector<py::ssize_t>& shape) {
  py::array_t<Number> array(shape);
  std::copy_n(values, array.size(), array.mutable_data());
  return array;
}

}  // namespace

template <int dim> std::vector<scene::Vector<dim>> points(const py::handle& object, const std::string& name) {
  const py::array array = as_array(object, name, "fiu", "real numbers");
  if (array.ndim() != 2 || array.shape(1) != dim)
    throw py::value_error(fmt::format("{} must have the shape (n, {}), has {}", name, dim, shape_of(array)));
  const auto values = py::array_t<double, py::array::c_style | py::array::forcecast>(array);
  const auto entry = values.template unchecked<2>();
  std::vector<scene::Vector<dim>> result(static_cast<std::size_t>(entry.shape(0)));
  for (py::ssize_t i = 0; i < entry.shape(0); ++i)
    for (int k = 0; k < dim; ++k) result[i][k] = entry(i, k);
  return result;
}
template std::vector<scene::Vector<2>> points<2>(const py::handle&, const std::string&);
template std::vector<scene::Vector<3>> points<3>(const py::handle&, const std::string&);

Integers integers(const py::handle& object, const std::string& name, const std::vector<std::size_t>& columns) {
  const py::array array = as_array(object, name, "iu", "integers");
  if (array.size() == 0) return {};
  const bool flat = columns == std::vector<std::size_t>{1};
  const bool fits =
      flat ? array.ndim() == 1 : array.ndim() == 2 && std::ranges::find(columns, array.shape(1)) != columns.end();
  if (!fits)
    throw py::value_error(fmt::format("{} must have the shape {}, has {}", name,
                                      flat ? "(n,)" : fmt::format("(n, {})", fmt::join(columns, " or ")),
                                      shape_of(array)));
  const auto values = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>(array);
  Integers result{{}, static_cast<std::size_t>(array.shape(0)), flat ? 1 : static_cast<std::size_t>(array.shape(1))};
  for (const std::int64_t value : std::span(values.data(), values.size())) {
    if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
      throw py::value_error(fmt::format("{} has {}, which is out of range", name, value));
    result.values.push_back(static_cast<int>(value));
  }
  return result;
}

py::array_t<double> array_of(const double* values, std::vector<py::ssize_t> shape) { return copy_of(values, shape); }
py::array_t<int> array_of(const int* values, std::vector<py::ssize_t> shape) { return copy_of(values, shape); }

py::array_t<double> array_of(const std::vector<double>& values) {
  return array_of(values.data(), {static_cast<py::ssize_t>(values.size())});
}

}  // namespace bracket::python
