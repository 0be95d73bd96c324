// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/field/field.h"
#include "scene/scene.h"

/// Displacements of another program on the mesh that `bracket mesh` wrote for it.
namespace bracket::scene {

template <int dim> struct FieldOnSceneOf {
  Problem<dim> problem;  ///< the scene, its data fixed on the mesh of the displacement
  GivenDisplacementOf<dim> given;
  int refinements = 0;  ///< uniform ones, after which the scene's mesh is this one
};
using FieldOnScene = FieldOnSceneOf<2>;

/// Reads the nodal displacements of a file on the first of the scene's meshes, uniformly refined 0, 1, 2, … times,
/// whose nodes are those of the file. Points without cells that are both the nodes of quadratic triangles and those of
/// linear ones on the next mesh are taken as Scene::solve.degree says; a note tells. Displacements of another mesh are
/// interpolated on the first that has as many nodes.
/// \throw Error as build_mesh(), fix_data() and read_field(); input also where the scene has arcs, each mesh of which
/// is
///        another polygon, or where the mesh would have more than refine.max_cells
template <int dim> FieldOnSceneOf<dim> read_field(const Scene<dim>& scene, const std::filesystem::path& file);

/// The same of values that are there already. \throw Error, besides, (input) where their arrays do not fit together
template <int dim> FieldOnSceneOf<dim> field_on_scene(const Scene<dim>& scene, const NodalDisplacementOf<dim>& field);

}  // namespace bracket::scene
