// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/python/module.h"

#include <bracket/version.h>

PYBIND11_MODULE(_bracket, module) {
  using namespace bracket::python;
  namespace py = pybind11;
  // What is in here is told to be in the package, which is where users find it.
  const py::object own_name = module.attr("__name__");
  module.attr("__name__") = "bracket";
  module.attr("__version__") = BRACKET_VERSION_STRING;
  add_error(module);
  add_fields(module);
  add_scene(module);
  add_outcome(module);
  add_assessment(module);
  module.attr("__name__") = own_name;
}
