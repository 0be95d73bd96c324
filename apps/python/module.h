// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <stop_token>
#include <variant>

#include "bounds/bounds.h"

/// The parts of the Python module: each adds its classes and functions. What the plane and space have alike is added by
/// templates, to the module and to its submodule `space`.
namespace bracket::python {

void add_error(pybind11::module_& module);
void add_obstacles(pybind11::module_& module, pybind11::module_& space);
template <int dim> void add_scene(pybind11::module_& module);
/// Methods: refinement, solution, checks, its mesh.
template <int dim> void add_settings(pybind11::class_<scene::Scene<dim>>& scene);
template <int dim> void add_fields(pybind11::module_& module);   ///< meshes, displacements, stresses
void add_numbers(pybind11::module_& module);                     ///< of a run, the same in the plane and in space
template <int dim> void add_outcome(pybind11::module_& module);  ///< contacts and what run() finds
void add_functions(pybind11::module_& module);                   ///< read_scene() and run()
template <int dim> void add_assessment(pybind11::module_& module);
void add_assess(pybind11::module_& module);  ///< assess() and assess_file()

/// The text of the plane, or of space.
template <int dim> const char* either(const char* plane, const char* space) { return dim == 2 ? plane : space; }

/// A scene of the plane or of space.
using AnyScene = std::variant<scene::Scene<2>, scene::Scene<3>>;

/// A scene as it was run and what came of it.
template <int dim> struct Result {
  scene::Scene<dim> scene;
  bounds::Outcome<dim> outcome;
};

/// Who follows a run on behalf of Python: signals are looked for wherever the run lets us, and raised; `progress` is
/// told of each level, and ends the run by returning False.
template <int dim> class Follower {
 public:
  /// \param progress a callable of an Outcome, or None   \pre scene and follower outlive the run, which does not hold
  /// the GIL
  Follower(const scene::Scene<dim>& scene, pybind11::object progress) : scene_(scene), progress_(std::move(progress)) {}
  bounds::Observer<dim> observer();

 private:
  void tell(const bounds::Outcome<dim>& so_far);

  const scene::Scene<dim>& scene_;
  pybind11::object progress_;
  std::stop_source stop_;
};

/// A picture and a few lines as a notebook shows them. \pre the GIL is held
std::string notebook_html(const std::string& lines, const std::function<std::string()>& svg);

}  // namespace bracket::python
