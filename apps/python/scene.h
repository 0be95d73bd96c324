// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "apps/python/module.h"

/// What a scene is made of in code.
namespace bracket::python {

namespace py = pybind11;

template <int dim> using Components = std::array<double, std::size_t{dim}>;
template <int dim> scene::Vector<dim> vector_of(const Components<dim>& given) {
  return Eigen::Map<const scene::Vector<dim>>(given.data());
}

/// One name or several. \param what they are of, for messages   \throw TypeError
std::vector<std::string> names_of(const py::object& given, const std::string& what);

void add_contacts(py::class_<scene::Scene<2>>& scene);
void add_contacts(py::class_<scene::Scene<3>>& scene);
void add_quantities(py::class_<scene::Scene<2>>& scene);
void add_quantities(py::class_<scene::Scene<3>>& scene);

}  // namespace bracket::python
