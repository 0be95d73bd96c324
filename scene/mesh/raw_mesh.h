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
  /// A triangle or quadrilateral (a cell) or a line. Side k runs from corner k to the next one.
  struct Element {
    Tag tag;
    std::array<int, 4> corners = {-1, -1, -1, -1};  ///< places in `nodes`; −1 beyond the last
    std::array<int, 4> middles = {-1, -1, -1, -1};  ///< of the nodes in the middle of side k; −1: it is straight
  };
  struct Set {
    std::string name;
    std::vector<int> members;
  };

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
RawMesh raw_mesh_of(const GivenMesh<2>& given);

/// What the digits of coordinates leave open, by their size: they have as many as the longest of them has.
double rounding_of(const std::vector<RawMesh::Node>& nodes);

/// The mesh that a scene asks for. Nodes as close as its `merge` become one; quadrilaterals are cut in two, sides of
/// second order straightened. Where a cell or line is in several sets, the scene's materials, conditions and contact
/// pairs say which name counts, and the first does where they say nothing. Bodies that share nodes are joined, but for
/// a line that both sides of a contact pair name: its nodes are doubled, and each body has its own. Other lines inside
/// of bodies are ignored. Whatever is mended or ignored is told in the notes.
/// \param where the file, for messages
/// \throw Error (mesh): no cells, not plane, a line off the mesh, names that contradict each other; as with_topology()
Mesh<2> mesh_of(const RawMesh& raw, const Scene<2>& scene, const std::string& where);

// ---- its steps ------------------------------------------------------------------------------------------------------

/// Triangles of a raw mesh. The vertices are those nodes that triangles have.
struct Triangles {
  std::vector<Vector<2>> vertices;
  std::vector<int> vertex;                ///< of each node, −1: none
  std::vector<std::array<int, 3>> cells;  ///< vertices
  std::vector<int> origin;                ///< of each triangle, the cell of the raw mesh
  std::vector<std::string> notes;
};
/// \param merge nodes as close become one, 0: none
/// \throw Error (mesh): no cells, not plane, merged nodes of one cell
Triangles triangles_of(const RawMesh& raw, double merge, const std::string& where);

/// Fills the bodies of a mesh whose cells are given.
/// \throw Error (mesh): a cell in no set, or in two that are both materials of the scene
Mesh<2> with_bodies(Mesh<2> mesh, const RawMesh& raw, const std::vector<int>& origin, const Scene<2>& scene,
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
  std::vector<int> cut;  ///< edges along which bodies are to be separated
  std::vector<std::string> notes;
};
/// The boundary parts of a mesh whose edges and bodies are given.
/// \throw Error (mesh): a line that is no edge, a side with two names that both have data, data of a part that has no
///        line on the boundary
PartSides part_sides(const Mesh<2>& mesh, const RawMesh& raw, const std::vector<int>& vertex, const Scene<2>& scene,
                     const std::string& where);

/// Gives the cells on either side of the edges `cut` vertices of their own, and bodies that have but a vertex in
/// common as well. \return whether there was anything to do
bool separate(Mesh<2>& mesh, const std::vector<int>& cut);

/// A note for each two components that touch by nodes at the same places and are in no contact with each other: they
/// may have been meant to be one.
std::vector<std::string> untied(const Mesh<2>& mesh, const Scene<2>& scene);

}  // namespace bracket::scene
