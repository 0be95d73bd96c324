// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/fields.h"
#include "scene/problem/problem.h"
#include "scene/problem/refine.h"
#include "scene/problem/rigid_motion.h"

/// The mechanical problem: geometry, mesh, materials, supports, loads and contact pairs; reading and checking them.
/// Start with read_scene(), then build_mesh(), then fix_data(); the `Problem` that results is all that the two
/// formulations see.
namespace bracket::scene {

/// A built-in rectangle of cells[0] × cells[1] squares, each cut in two by the diagonal from its lower left.
/// Its boundary parts are "body.left", ".right", ".bottom" and ".top".
template <int dim> struct Block {
  std::string body;
  std::array<std::array<double, 2>, dim> range;  ///< {x from, to}, {y from, to}
  std::array<int, dim> cells;
  std::string where;  ///< "file:line:column", for messages; so below
};

enum class ConditionKind { fixed, sliding, traction, pressure };

/// What is prescribed on one boundary part. `value`: `dim` functions for fixed (displacement) and traction (force per
/// area), one for sliding (displacement along the outward normal) and pressure (traction −p n).
template <int dim> struct Condition {
  ConditionKind kind;
  std::vector<Function<dim>> value;
  std::string where;
};

/// A frictionless contact pair. The gap is measured along the outward normal of `first`, ≥ 0 open, < 0 interference.
template <int dim> struct ContactPair {
  std::string first;
  std::string second;  ///< a boundary part, or "rigid": a wall along `first`
  Function<dim> gap;
  std::string where;
};

struct Refine {
  std::string strategy = "none";
  double target = 0;  ///< relative error bound to reach; 0: none asked
  double bulk = 0.5;
  int max_levels = 30;
  int max_cells = 200000;
  double max_seconds = 600;
};

struct Solve {
  int degree = 2;               ///< of the displacements, 1 or 2
  std::string dual = "hybrid";  ///< or "uzawa"
};

template <int dim> struct Scene {
  std::string file;  ///< where it was read from; empty if built in code
  std::string title;
  std::string units;
  std::string plane = "strain";  ///< or "stress"
  std::vector<Block<dim>> blocks;
  std::filesystem::path mesh_file;  ///< empty: blocks
  std::string mesh_where;
  std::map<std::string, Body<dim>> bodies;
  std::map<std::string, Condition<dim>> boundary;
  std::vector<ContactPair<dim>> contact;
  Refine refine;
  Solve solve;
};

/// Reads and checks a scene file (TOML). `overrides` are "key=value" lines that replace or add keys before checking.
/// \throw Error (input), with file, line and column and, for a misspelt key, the nearest known one
template <int dim>
Scene<dim> read_scene(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// The scene's blocks as a mesh, or its mesh file read.
/// \throw Error (input: no such file; mesh: not usable)
template <int dim> Mesh<dim> build_mesh(const Scene<dim>& scene);

/// Fixes the data of `scene` on `mesh`: tractions projected (L2) on linear functions per edge, displacements
/// interpolated linearly, gaps quadratically; matches the contact sides edge by edge; gives the facets of one straight
/// line one normal; where displacements are prescribed on both sides of a contact's vertex and close more than its gap
/// by rounding only (8 ε of their size, the gap's and the length scale), raises the gap to their approach.
/// \throw Error (input: unknown names, two conditions on one part, values that are not finite or out of
///        range, prescribed displacements that contradict each other at a vertex; mesh: sides that do not match)
template <int dim> Problem<dim> fix_data(const Scene<dim>& scene, Mesh<dim> mesh);

}  // namespace bracket::scene
