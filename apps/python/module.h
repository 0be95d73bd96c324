// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <stop_token>

#include "bounds/bounds.h"

/// The parts of the Python module: each adds its classes and functions.
namespace bracket::python {

void add_error(pybind11::module_& module);
void add_scene(pybind11::module_& module);
void add_settings(pybind11::class_<scene::Scene<2>>& scene);  ///< methods: refinement, solution, checks, its mesh
void add_fields(pybind11::module_& module);                   ///< meshes, displacements, stresses, contact lines
void add_outcome(pybind11::module_& module);                  ///< what run() finds, and run() itself
void add_assessment(pybind11::module_& module);

/// A scene as it was run and what came of it.
struct Result {
  scene::Scene<2> scene;
  bounds::Outcome<2> outcome;
};

/// Who follows a run on behalf of Python: signals are looked for wherever the run lets us, and raised; `progress` is
/// told of each level, and ends the run by returning False.
class Follower {
 public:
  /// \param progress a callable of an Outcome, or None   \pre scene and follower outlive the run, which does not hold
  /// the GIL
  Follower(const scene::Scene<2>& scene, pybind11::object progress) : scene_(scene), progress_(std::move(progress)) {}
  bounds::Observer<2> observer();

 private:
  void tell(const bounds::Outcome<2>& so_far);

  const scene::Scene<2>& scene_;
  pybind11::object progress_;
  std::stop_source stop_;
};

/// A picture and a few lines as a notebook shows them. \pre the GIL is held
std::string notebook_html(const std::string& lines, const std::function<std::string()>& svg);

}  // namespace bracket::python
