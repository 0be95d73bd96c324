// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "scene/scene.h"

/// What mesh files hold, whatever they are written in. Each reader gives a RawMesh; one function makes a mesh of it.
namespace bracket::scene {

struct RawMesh {
  using Tag = std::int64_t;
  struct Node {
    Tag tag;  ///< its number in the file, for messages; so below
    std::array<double, 3> x;
  };
  /// A triangle or quadrilateral (a cell) or a line; in space a tetrahedron (a cell) or a triangle (a "line"). Side k
  /// of a cell runs from corner k to the next one; of a tetrahedron sides are Simplex<3>::edges.
  struct Element {
    Tag tag;
    std::array<int, 4> corners = {-1, -1, -1, -1};  ///< places in `nodes`; −1 beyond the last
    std::array<int, 6> middles = {-1, -1, -1,
                                  -1, -1, -1};  ///< of the nodes in the middle of side k; −1: it is straight
  };
  struct Set {
    std::string name;
    std::vector<int> members;
  };

  int dimension = 2;  ///< 3: of space
  std::vector<Node> nodes;
  std::vector<Element> cells, lines;
  std::vector<Set> bodies;     ///< of cells; a cell may be in several. Empty: all of them are one body
  std::vector<Set> parts;      ///< of lines, likewise
  std::vector<Set> node_sets;  ///< of nodes: each stands for the sides between its nodes on the boundary of a body
  std::string body_word;       ///< what sets that name bodies are called, for messages: "physical surface"
  std::vector<std::string> notes;
  double coordinate_rounding = std::numeric_limits<double>::epsilon() / 2;  ///< see Mesh
};

/// A mesh made in code; tags are places.
/// \throw Error (mesh): places that are not there; (input): coordinates that are not finite or of a size out of range
template <int dim> RawMesh raw_mesh_of(const GivenMesh<dim>& given);

/// What the digits of coordinates leave open, by their size: they have as many as the longest of them has.
double rounding_of(const std::vector<RawMesh::Node>& nodes, int dimension = 2);

/// The mesh that a scene asks for. Nodes as close as its `merge` become one; quadrilaterals are cut in two, sides of
/// second order straightened. Where a cell or line is in several sets, the scene's materials, conditions and contact
/// pairs say which name counts, and the first does where they say nothing. Bodies that share nodes are joined, but for
/// a line that both sides of a contact pair name: its nodes are doubled, and each body has its own. Other lines inside
/// of bodies are ignored. Whatever is mended or ignored is told in the notes.
/// \param where the file, for messages
/// \throw Error (mesh): no cells, not of the dimension, a line off the mesh, names that contradict each other; as
/// with_topology()
template <int dim> Mesh<dim> mesh_of(const RawMesh& raw, const Scene<dim>& scene, const std::string& where);

// ---- its steps ------------------------------------------------------------------------------------------------------

/// Triangles or tetrahedra of a raw mesh. The vertices are those nodes that they have.
template <int dim> struct Simplices {
  std::vector<Vector<dim>> vertices;
  std::vector<int> vertex;                      ///< of each node, −1: none
  std::vector<std::array<int, dim + 1>> cells;  ///< vertices
  std::vector<int> origin;                      ///< of each one, the cell of the raw mesh
  std::vector<std::string> notes;
};
/// \param merge nodes as close become one, 0: none
/// \throw Error (mesh): no cells, not plane or not in space, merged nodes of one cell
template <int dim> Simplices<dim> simplices_of(const RawMesh& raw, double merge, const std::string& where);
template <> Simplices<2> simplices_of<2>(const RawMesh& raw, double merge, const std::string& where);
template <> Simplices<3> simplices_of<3>(const RawMesh& raw, double merge, const std::string& where);

/// Fills the bodies of a mesh whose cells are given.
/// \throw Error (mesh): a cell in no set, or in two that are both materials of the scene
template <int dim>
Mesh<dim> with_bodies(Mesh<dim> mesh, const RawMesh& raw, const std::vector<int>& origin, const Scene<dim>& scene,
                      const std::string& where);

/// A side of a cell that belongs to a boundary part.
struct PartSide {
  int cell;
  int local;
  int part;
};
struct PartSides {
  std::vector<std::string> names;
  std::vector<PartSide> sides;
  std::vector<int> cut;  ///< facets, by their numbers, along which bodies are to be separated
  std::vector<std::string> notes;
};
/// The boundary parts of a mesh whose facets and bodies are given.
/// \throw Error (mesh): a line that is no facet, a side with two names that both have data, data of a part that has no
///        line on the boundary
template <int dim>
PartSides part_sides(const Mesh<dim>& mesh, const RawMesh& raw, const std::vector<int>& vertex, const Scene<dim>& scene,
                     const std::string& where);

/// Gives the cells on either side of the facets `cut` vertices of their own, and bodies that have but a vertex (in
/// space, an edge) in common as well. \return whether there was anything to do
template <int dim> bool separate(Mesh<dim>& mesh, const std::vector<int>& cut);

/// A note for each two components that touch by nodes at the same places and are in no contact with each other: they
/// may have been meant to be one.
template <int dim> std::vector<std::string> untied(const Mesh<dim>& mesh, const Scene<dim>& scene);

}  // namespace bracket::scene
