// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/python/module.h"

#include <bracket/version.h>

PYBIND11_MODULE(_bracket, module) {
  using namespace bracket::python;
  namespace py = pybind11;
  py::module_ space = module.def_submodule("space");
  // What is in here is told to be in the package, which is where users find it.
  const py::object own_name = module.attr("__name__"), own_name_in_space = space.attr("__name__");
  module.attr("__name__") = "bracket";
  space.attr("__name__") = "bracket.space";
  module.attr("__version__") = BRACKET_VERSION_STRING;
  add_error(module);
  add_numbers(module);
  add_obstacles(module, space);
  add_fields<2>(module);
  add_fields<3>(space);
  add_scene<2>(module);
  add_scene<3>(space);
  add_outcome<2>(module);
  add_outcome<3>(space);
  add_assessment<2>(module);
  add_assessment<3>(space);
  add_functions(module);
  add_assess(module);
  module.attr("__name__") = own_name;
  space.attr("__name__") = own_name_in_space;
}
