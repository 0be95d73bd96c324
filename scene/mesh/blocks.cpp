// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "scene/mesh/bonds.h"
#include "scene/mesh/readers.h"
#include "scene/mesh/topology.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

/// The place of a name in the list, to which it is added if it is not there.
int place_of(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

/// Without those that two blocks of a body share.
template <int dim> std::vector<PartFacet<dim>> outer(const std::vector<PartFacet<dim>>& facets) {
  std::map<std::array<int, dim>, int> times;
  const auto key = [](const PartFacet<dim>& facet) {
    std::array<int, dim> vertices = facet.vertices;
    std::ranges::sort(vertices);
    return vertices;
  };
  for (const PartFacet<dim>& facet : facets) ++times[key(facet)];
  std::vector<PartFacet<dim>> result;
  for (const PartFacet<dim>& facet : facets)
    if (times[key(facet)] == 1) result.push_back(facet);
  return result;
}

template <int dim> using Place = std::array<int, dim>;  // in a grid, along each axis

/// All places of a grid, along the first axis first.
template <int dim> std::vector<Place<dim>> places(const Place<dim>& counts) {
  std::vector<Place<dim>> result;
  for (Place<dim> at{}; at[dim - 1] < counts[dim - 1];) {
    result.push_back(at);
    ++at[0];
    for (int axis = 0; axis + 1 < dim && at[axis] == counts[axis]; ++axis) {
      at[axis] = 0;
      ++at[axis + 1];
    }
  }
  return result;
}

/// The simplices into which a cube falls along its diagonal from (0, …, 0) to (1, …, 1), one for each order of the axes
/// in which steps lead there (Kuhn), positively oriented.
template <int dim> std::vector<std::array<Place<dim>, dim + 1>> simplices_of_cube() {
  std::vector<std::array<Place<dim>, dim + 1>> result;
  Place<dim> order;
  std::iota(order.begin(), order.end(), 0);
  do {
    std::array<Place<dim>, dim + 1> corners{};
    bool odd = false;
    for (int step = 0; step < dim; ++step) {
      corners[step + 1] = corners[step];
      corners[step + 1][order[step]] = 1;
      for (int before = 0; before < step; ++before) odd ^= order[before] > order[step];
    }
    if (odd) std::swap(corners[dim - 1], corners[dim]);
    result.push_back(corners);
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

template <int dim> Mesh<dim> build_blocks(const std::vector<Block<dim>>& blocks, const std::string& where) {
  Mesh<dim> mesh;
  std::vector<PartFacet<dim>> part_facets;
  const auto simplices = simplices_of_cube<dim>();
  std::map<std::pair<int, std::array<double, dim>>, int> on_sides;  // vertices of each body, which blocks may share
  for (const Block<dim>& block : blocks) {
    const int body = place_of(block.body, mesh.bodies);
    const auto at = [&](int axis, int i) {  // exact at both ends, so that blocks meet
      const auto& [from, to] = block.range[axis];
      const int n = block.cells[axis];
      return i == n ? to : from + (to - from) * i / n;
    };
    Place<dim> counts = block.cells;
    for (int& count : counts) ++count;
    std::vector<int> vertices;
    for (const Place<dim>& place : places<dim>(counts)) {
      const int next = static_cast<int>(mesh.vertices.size());
      bool inside = true;
      std::array<double, dim> x;
      for (int axis = 0; axis < dim; ++axis) {
        inside = inside && place[axis] > 0 && place[axis] < block.cells[axis];
        x[axis] = at(axis, place[axis]);
      }
      vertices.push_back(inside ? next : on_sides.try_emplace({body, x}, next).first->second);
      if (vertices.back() == next) mesh.vertices.push_back(Vector<dim>(x.data()));
    }
    std::array<std::array<int, 2>, dim> parts;
    for (int axis = 0; axis < dim; ++axis)
      for (int end = 0; end < 2; ++end) {
        static constexpr std::array<std::array<const char*, 2>, 3> names = {
            {{".left", ".right"}, {".bottom", ".top"}, {".back", ".front"}}};
        parts[axis][end] =
            place_of(block.body + (block.name.empty() ? "" : "." + block.name) + names[axis][end], mesh.parts);
      }
    for (const Place<dim>& cube : places<dim>(block.cells))
      for (std::array<Place<dim>, dim + 1> corners : simplices) {
        std::array<int, dim + 1> cell;
        for (int k = 0; k <= dim; ++k) {
          int place = 0;
          for (int axis = dim; axis-- > 0;) place = place * counts[axis] + (corners[k][axis] += cube[axis]);
          cell[k] = vertices[place];
        }
        mesh.cells.push_back(cell);
        for (const auto& facet : Simplex<dim>::facets)
          for (int axis = 0; axis < dim; ++axis)
            for (int end = 0; end < 2; ++end) {
              const auto on_side = [&](int k) { return corners[k][axis] == end * block.cells[axis]; };
              if (!std::all_of(facet.begin(), facet.end(), on_side)) continue;
              part_facets.push_back({{}, parts[axis][end]});
              for (int i = 0; i < dim; ++i) part_facets.back().vertices[i] = cell[facet[i]];
            }
      }
    mesh.cell_body.resize(mesh.cells.size(), body);
  }
  return with_topology(std::move(mesh), outer<dim>(part_facets), where);
}

/// What flat cells do to stresses that are built star by star; empty: there are few or none.
template <int dim> std::string flat_cells_note(const Mesh<dim>& mesh, const Solve& solve) {
  const std::vector<double> of_cells = flatness(mesh);
  const double common = common_flatness(of_cells);
  if (common <= flat) return "";
  const auto count = std::ranges::count_if(of_cells, [](double of) { return of > flat; });
  const int sweeps = solve.sweeps.value_or(sweeps_for(common));
  return fmt::format(
      "{} of {} cells are flatter than {:g} : 1, the flattest {:.2g} : 1: stresses built locally are less sharp there, "
      "and swept {} times{}; cells of better shape, or more solve.sweeps, narrow the interval",
      count, of_cells.size(), flat, std::ranges::max(of_cells), sweeps, solve.sweeps ? ", as asked" : "");
}

/// As build_mesh(), before sides are joined.
template <int dim> Mesh<dim> with_bonds_open(const Scene<dim>& scene) {
  if (scene.given) return mesh_of(raw_mesh_of(*scene.given), scene, scene.mesh_where);
  if (scene.mesh_file.empty()) return build_blocks(scene.blocks, scene.mesh_where);
  RawMesh raw;
  try {
    raw = read_raw_mesh(scene.mesh_file);
  } catch (const Error& error) {
    // That there is no such file is to be mended in the scene, the rest in the mesh file.
    if (error.status() == Status::input) fail(Status::input, scene.mesh_where, error.what());
    throw;
  }
  return mesh_of(raw, scene, scene.mesh_file.string());
}

}  // namespace

template <int dim> Mesh<dim> build_mesh(const Scene<dim>& scene) {
  check(scene);
  Mesh<dim> mesh = bonded(with_bonds_open(scene), scene.bonds,
                          scene.mesh_file.empty() ? scene.mesh_where : scene.mesh_file.string());
  if (scene.solve.dual == Dual::local)
    if (std::string note = flat_cells_note(mesh, scene.solve); !note.empty()) mesh.notes.push_back(std::move(note));
  return mesh;
}

template Mesh<2> build_mesh(const Scene<2>&);
template Mesh<3> build_mesh(const Scene<3>&);

}  // namespace bracket::scene
