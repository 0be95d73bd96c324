// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "scene/mesh/mesh.h"
#include "scene/options.h"

/// A mesh as the text of a file for other programs. Nodes have the numbers of the vertices and, of degree 2, behind
/// them those of the edges, whose nodes are at the midpoints; each body has its own, also where two touch. Nodes and
/// cells are in the order of the mesh. Coordinates read back to the last bit.
namespace bracket::scene {

/// Gmsh 2.2, ASCII: bodies are physical surfaces, boundary parts physical curves; in space volumes and surfaces.
/// \pre degree 1 or 2; so below
/// \throw Error (input): a name that the format cannot hold; so below
template <int dim> std::string gmsh_text(const Mesh<dim>& mesh, int degree);

/// Input of Abaqus and CalculiX: elements CPE3, CPS6 and so on, in space C3D4 and C3D10; an element set for each body,
/// a node set and a surface of element sides for each boundary part. CalculiX reads the first 20 characters of a
/// number: they give it to 1e-17 where they do not give it to the last place. \param plane of two dimensions
template <int dim> std::string abaqus_text(const Mesh<dim>& mesh, int degree, Plane plane);

/// VTK's unstructured grid, ASCII, with the number of its body for each cell; boundary parts are not in it.
template <int dim> std::string vtu_text(const Mesh<dim>& mesh, int degree);

}  // namespace bracket::scene
