// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "apps/python/arrays.h"
#include "apps/python/module.h"
#include "bounds/results.h"

/// What a run hands out beside its numbers and fields.
namespace bracket::python {

/// A contact pair and what the fields have on it.
template <int dim> struct ContactOfRun {
  std::string name, first, second;
  bounds::ContactResult<dim> result;
  py::array_t<double> points, pressure, gap;
};
template <int dim> void add_contact_results(py::module_& module);
template <int dim> std::vector<ContactOfRun<dim>> contacts_of(const Result<dim>& self);

}  // namespace bracket::python
