// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh/space/bisection.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "scene/mesh/space/marks.h"
#include "scene/mesh/topology.h"
#include "scene/problem/halfway.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Table = Simplex<3>;

std::vector<int> glued_vertices(const Problem<3>& problem) {
  const Mesh<3>& mesh = problem.mesh;
  const int count = static_cast<int>(mesh.vertices.size());
  std::vector<int> ranks(count), parents(count);
  std::iota(parents.begin(), parents.end(), 0);
  boost::disjoint_sets<int*, int*> sets(ranks.data(), parents.data());
  for (const ContactFacetOf<3>& pair : problem.contact) {
    if (pair.second == -1) continue;
    for (int i = 0; i < 3; ++i)
      sets.union_set(mesh.boundary[pair.first].vertices[i], mesh.boundary[pair.second].vertices[pair.meets[i]]);
  }
  std::vector<int> lowest(count, -1), glued(count);
  for (int v = 0; v < count; ++v) {
    int& of = lowest[sets.find_set(v)];
    if (of == -1) of = v;
    glued[v] = of;
  }
  return glued;
}

/// A cell of the old mesh or a descendant.
struct Node {
  std::array<int, 4> vertices;
  std::array<std::array<double, 3>, 4> corner;  ///< as in Piece<3>
  Mesh<3>::Marks marks;
  std::vector<BoundaryPart> boundary;
  int depth = 0;
  std::array<int, 2> children = {-1, -1};
};

/// The forest of cells and the vertices that are made in it.
class Forest {
 public:
  Forest(const Problem<3>& problem, std::vector<int> glued)
      : old_(problem.mesh), vertices_(problem.mesh.vertices), glued_(std::move(glued)) {
    const std::vector<Mesh<3>::Marks> marks = old_.marks.empty() ? first_marks(old_, glued_) : old_.marks;
    nodes_.reserve(2 * old_.cells.size());
    for (std::size_t c = 0; c < old_.cells.size(); ++c)
      nodes_.push_back({old_.cells[c], piece_of_cell(problem, static_cast<int>(c)).corner, marks[c], {}});
    for (std::size_t f = 0; f < old_.boundary.size(); ++f) {
      const auto& facet = old_.boundary[f];
      nodes_[facet.cell].boundary.push_back(
          {facet.local, static_cast<int>(f), piece_of_facet(problem, static_cast<int>(f)).corner});
    }
  }

  void bisect(int cell) {
    const Node parent = nodes_[cell];
    const int edge = refinement_edge(parent.marks.facet);
    const auto& [i, j] = Table::edges[edge];
    const int middle = middle_of(parent.vertices[i], parent.vertices[j]);
    nodes_[cell].boundary.clear();
    for (const auto& [kept, moved] : {std::pair(i, j), std::pair(j, i)}) {
      nodes_[cell].children[kept == i ? 0 : 1] = static_cast<int>(nodes_.size());
      nodes_.push_back(child(parent, kept, moved, middle));
    }
  }

  /// Bisects until no leaf has an edge that is cut.
  void close() {
    std::vector<int> leaves(old_.cells.size());
    std::iota(leaves.begin(), leaves.end(), 0);
    for (bool again = true; again;) {
      again = false;
      std::vector<int> next;
      for (std::size_t n = 0; n < leaves.size(); ++n) {  // it grows by children
        const int leaf = leaves[n];
        if (nodes_[leaf].children[0] < 0 && is_cut(nodes_[leaf])) {
          bisect(leaf);
          again = true;
        }
        if (nodes_[leaf].children[0] < 0) {
          next.push_back(leaf);
          continue;
        }
        leaves.insert(leaves.end(), nodes_[leaf].children.begin(), nodes_[leaf].children.end());
      }
      leaves = std::move(next);
    }
  }

  /// Calls visit(old cell, leaf), in the order of old cells.
  template <class Visit> void for_leaves(const Visit& visit) const {
    for (std::size_t c = 0; c < old_.cells.size(); ++c)
      for_leaves_below(static_cast<int>(c), static_cast<int>(c), visit);
  }

  const std::vector<Vector<3>>& vertices() const { return vertices_; }
  const std::vector<int>& glued() const { return glued_; }

 private:
  using Key = std::uint64_t;
  static Key key(int a, int b) {
    const auto [lower, upper] = std::minmax(a, b);
    return (static_cast<Key>(lower) << 32) + static_cast<Key>(upper);
  }

  bool is_cut(const Node& node) const {
    return std::ranges::any_of(Table::edges, [&](const auto& edge) {
      return cut_.contains(key(glued_[node.vertices[edge[0]]], glued_[node.vertices[edge[1]]]));
    });
  }

  int middle_of(int a, int b) {
    const auto [known, fresh] = middles_.try_emplace(key(a, b), static_cast<int>(vertices_.size()));
    if (!fresh) return known->second;
    const int middle = known->second;
    // Does not depend on the order of the ends: of edges that are glued it is the same to the last bit.
    vertices_.push_back(0.5 * (vertices_[a] + vertices_[b]));
    glued_.push_back(cut_.try_emplace(key(glued_[a], glued_[b]), middle).first->second);
    assert(vertices_[glued_.back()] == vertices_.back());
    return middle;
  }

  /// The child that keeps one end of the refinement edge; the middle takes the place of the other.
  static Node child(const Node& parent, int kept, int moved, int middle) {
    Node child{parent.vertices, parent.corner, marks_of_child(parent.marks, kept, moved), {}, parent.depth + 1};
    child.vertices[moved] = middle;
    child.corner[moved] = halfway(parent.corner[kept], parent.corner[moved]);
    for (BoundaryPart part : parent.boundary) {
      if (part.local == kept) continue;
      if (part.local != moved) {
        const auto& corners = Table::facets[part.local];
        const auto place = [&](int vertex) {
          return std::find(corners.begin(), corners.end(), vertex) - corners.begin();
        };
        part.corner[place(moved)] = halfway(part.corner[place(kept)], part.corner[place(moved)]);
      }
      child.boundary.push_back(part);
    }
    return child;
  }

  template <class Visit> void for_leaves_below(int node, int root, const Visit& visit) const {
    if (nodes_[node].children[0] < 0) return visit(root, nodes_[node]);
    for (const int below : nodes_[node].children) for_leaves_below(below, root, visit);
  }

  const Mesh<3>& old_;
  std::vector<Vector<3>> vertices_;
  std::vector<int> glued_;
  std::vector<Node> nodes_;
  std::unordered_map<Key, int> middles_;  ///< by the ends of edges …
  std::unordered_map<Key, int> cut_;      ///< … by what stands for them
};

/// A child has half its parent's volume, until rounding of the coordinates spoils its shape.
void check_resolved(const Mesh<3>& mesh, int cell, double expected) {
  if (volume(mesh, cell) > 0.4 * expected) return;
  fail(Status::budget, "",
       "the mesh cannot be refined any further at " + point(mesh.vertices[mesh.cells[cell][0]]) +
           ": its cells are as small as the rounding of coordinates");
}

/// What is not of cells.
Mesh<3> emptied(const Mesh<3>& old) {
  Mesh<3> mesh;
  mesh.bodies = old.bodies;
  mesh.components = old.components;
  mesh.parts = old.parts;
  mesh.notes = old.notes;
  mesh.coordinate_rounding = old.coordinate_rounding;
  return mesh;
}

}  // namespace

BisectedCells bisect(const Problem<3>& problem, const std::vector<char>& marked) {
  const Mesh<3>& old = problem.mesh;
  assert(marked.size() == old.cells.size());
  Forest forest(problem, glued_vertices(problem));
  for (std::size_t c = 0; c < old.cells.size(); ++c)
    if (marked[c]) forest.bisect(static_cast<int>(c));
  forest.close();

  BisectedCells result;
  Mesh<3>& mesh = result.mesh;
  mesh = emptied(old);
  mesh.vertices = forest.vertices();
  result.glued = forest.glued();
  std::vector<std::vector<BoundaryPart>> boundary;  // of each cell
  std::vector<double> expected;
  forest.for_leaves([&](int root, const Node& leaf) {
    mesh.cells.push_back(leaf.vertices);
    mesh.cell_body.push_back(old.cell_body[root]);
    mesh.cell_component.push_back(old.cell_component[root]);
    mesh.refinement_edge.push_back(static_cast<char>(refinement_edge(leaf.marks.facet)));
    mesh.marks.push_back(leaf.marks);
    result.cell_parent.push_back(root);
    result.cells.push_back({piece_of_cell(problem, root).of, leaf.corner});
    boundary.push_back(leaf.boundary);
    expected.push_back(std::ldexp(volume(old, root), -leaf.depth));
  });
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) check_resolved(mesh, static_cast<int>(c), expected[c]);
  mesh = with_edges(std::move(mesh), "");
  for (auto& facet : mesh.boundary) {
    const auto part = std::ranges::find(boundary[facet.cell], facet.local, &BoundaryPart::local);
    assert(part != boundary[facet.cell].end());
    facet.part = old.boundary[part->facet].part;
    result.facet_parent.push_back(part->facet);
    result.facets.push_back({piece_of_facet(problem, part->facet).of, part->corner});
  }
  return result;
}

}  // namespace bracket::scene
