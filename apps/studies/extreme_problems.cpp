// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/studies/extreme_problems.h"

#include "scene/problem/stretch.h"

namespace bracket::apps {

using scene::Mesh;
using scene::Problem;
using scene::Vector;

namespace {

/// Body forces, tractions, and prescribed displacements and gaps, each times its factor.
Problem<2> with_data_times(Problem<2> problem, double force, double traction, double displacement) {
  for (scene::Body<2>& body : problem.bodies) body.force *= force;
  for (scene::FacetData<2>& facet : problem.facets)
    for (int end = 0; end < 2; ++end) {
      facet.traction[end] *= traction;
      facet.pressure[end] *= traction;
      facet.higher_traction[end] *= traction;
      facet.higher_pressure[end] *= traction;
      facet.displacement[end] *= displacement;
      facet.normal_displacement[end] *= displacement;
    }
  for (scene::ContactFacet& facet : problem.contact)
    for (auto* gaps : {&facet.lower, &facet.upper})
      for (double& gap : *gaps) gap *= displacement;
  problem.gaps.clear();  // what is between the two quadratics is the gap from now on
  return problem;
}

}  // namespace

Problem<2> in_units(Problem<2> problem, double length, double stress) {
  for (Vector<2>& x : problem.mesh.vertices) x *= length;
  problem.length_scale *= length;
  for (std::size_t body = 0; body < problem.bodies.size(); ++body)
    problem = with_moduli_times(std::move(problem), static_cast<int>(body), stress);
  return with_data_times(std::move(problem), stress / length, stress, length);
}

Problem<2> with_loads_times(Problem<2> problem, double factor) {
  return with_data_times(std::move(problem), factor, factor, factor);
}

Problem<2> with_moduli_times(Problem<2> problem, int body, double factor) {
  scene::Material<2>& own = problem.bodies[body].material;
  const auto& constants = own.constants();
  own = constants ? scene::isotropic<2>(factor * constants->young, constants->poisson, constants->plane)
                  : scene::anisotropic<2>(factor * own.stiffness());
  return problem;
}

Problem<2> with_poisson(Problem<2> problem, double poisson) {
  for (scene::Body<2>& body : problem.bodies)
    if (const auto& constants = body.material.constants())
      body.material = scene::isotropic<2>(constants->young, poisson, constants->plane);
  return problem;
}

Problem<2> with_cells_cut(Problem<2> problem, const std::array<double, 3>& point) {
  const Mesh<2> old = problem.mesh;
  Mesh<2>& mesh = problem.mesh;
  mesh.cells.clear();
  mesh.cell_edges.clear();
  mesh.cell_body.clear();
  mesh.cell_component.clear();
  mesh.refinement_edge.clear();
  for (std::size_t c = 0; c < old.cells.size(); ++c) {
    const auto& cell = old.cells[c];
    const int opposite = old.refinement_edge[c];  // of a mesh just made it is the longest
    const int inner = static_cast<int>(mesh.vertices.size());
    const int spoke = static_cast<int>(mesh.edges.size());  // from vertex k: spoke + k
    Vector<2> x = Vector<2>::Zero();
    for (int k = 0; k < 3; ++k) {
      x += point[(k - opposite + 3) % 3] * old.vertices[cell[k]];
      mesh.edges.push_back({cell[k], inner});
    }
    mesh.vertices.push_back(x);
    for (int k = 0; k < 3; ++k) {  // the part at edge k has the inner point in the place of vertex k
      auto corners = cell;
      auto edges = old.cell_edges[c];
      corners[k] = inner;
      edges[(k + 1) % 3] = spoke + (k + 2) % 3;
      edges[(k + 2) % 3] = spoke + (k + 1) % 3;
      mesh.cells.push_back(corners);
      mesh.cell_edges.push_back(edges);
      mesh.cell_body.push_back(old.cell_body[c]);
      mesh.cell_component.push_back(old.cell_component[c]);
      mesh.refinement_edge.push_back(static_cast<char>(k));
    }
  }
  for (auto& facet : mesh.boundary) facet.cell = 3 * facet.cell + facet.local;
  return problem;
}

Problem<2> flattened(scene::Scene<2> scene, double factor) {
  const auto before = [factor](const scene::Function<2>& f) -> scene::Function<2> {
    const auto at_points = [f, factor](const Vector<2>& x) { return f(Vector<2>(x[0], x[1] / factor)); };
    using Range = scene::Function<2>::Range;
    if (!f.is_enclosed()) return at_points;
    return {at_points, [f, factor](const Range& x) { return f.over(Range{x[0], x[1] / factor}); }};
  };
  for (auto& [name, condition] : scene.boundary)
    for (scene::Function<2>& f : condition.value) f = before(f);
  for (scene::ContactPair<2>& pair : scene.contact) {
    if (pair.gap) pair.gap = before(*pair.gap);
    if (pair.jump) pair.jump = {before((*pair.jump)[0]), before((*pair.jump)[1])};
  }
  Mesh<2> mesh = scene::build_mesh(scene);
  for (Vector<2>& x : mesh.vertices) x[1] *= factor;
  return scene::fix_data(scene, std::move(mesh));
}

namespace {

std::vector<ContactEnd> contact_ends(const Problem<2>& problem) {
  std::vector<int> facets_at(problem.mesh.vertices.size(), 0);
  for (const scene::ContactFacet& facet : problem.contact)
    for (const int vertex : problem.mesh.boundary[facet.first].vertices) ++facets_at[vertex];
  std::vector<ContactEnd> ends;
  for (std::size_t j = 0; j < problem.contact.size(); ++j)
    for (int end = 0; end < 2; ++end)
      if (facets_at[problem.mesh.boundary[problem.contact[j].first].vertices[end]] == 1)
        ends.push_back({static_cast<int>(j), end});
  return ends;
}

}  // namespace

std::optional<ContactEnd> contact_end(const Problem<2>& problem) {
  const auto ends = contact_ends(problem);
  return ends.empty() ? std::nullopt : std::optional(ends[0]);
}

Problem<2> with_ends_refined(Problem<2> problem, int times) {
  for (int i = 0; i < times; ++i) {
    std::vector<char> marked(problem.mesh.cells.size(), 0);
    for (const auto& [contact, end] : contact_ends(problem))
      marked[problem.mesh.boundary[problem.contact[contact].first].cell] = 1;
    problem = scene::refine(problem, marked).problem;
  }
  return problem;
}

namespace {

/// Cuts a boundary facet, and its cell up to the vertex opposite, at x. The piece at its vertex `end` becomes a new,
/// free facet, the other keeps its place and data.
Problem<2> with_piece_freed(Problem<2> problem, int facet, int end, const Vector<2>& x) {
  Mesh<2>& mesh = problem.mesh;
  const int cell = mesh.boundary[facet].cell, local = mesh.boundary[facet].local;
  const int at_end = (local + 1 + end) % 3, at_other = (local + 2 - end) % 3;
  const int middle = static_cast<int>(mesh.vertices.size()), piece = static_cast<int>(mesh.cells.size());
  const int short_edge = static_cast<int>(mesh.edges.size()), inner_edge = short_edge + 1;
  const int last = mesh.cells[cell][at_end], other = mesh.cells[cell][at_other], apex = mesh.cells[cell][local];
  const int side = mesh.cell_edges[cell][at_other];  // from the last vertex to the apex

  mesh.vertices.push_back(x);
  mesh.edges[mesh.boundary[facet].edge] = {other, middle};
  mesh.edges.push_back({last, middle});
  mesh.edges.push_back({apex, middle});
  auto corners = mesh.cells[cell];
  auto edges = mesh.cell_edges[cell];
  corners[at_other] = middle;
  edges[local] = short_edge;
  edges[at_end] = inner_edge;
  mesh.cells.push_back(corners);
  mesh.cell_edges.push_back(edges);
  mesh.cell_body.push_back(mesh.cell_body[cell]);
  mesh.cell_component.push_back(mesh.cell_component[cell]);
  mesh.refinement_edge.push_back(mesh.refinement_edge[cell]);
  mesh.cells[cell][at_end] = middle;
  mesh.cell_edges[cell][at_other] = inner_edge;
  for (auto& neighbour : mesh.boundary)
    if (neighbour.edge == side) neighbour.cell = piece;

  auto freed = mesh.boundary[facet];
  freed.vertices[1 - end] = middle;
  freed.cell = piece;
  freed.edge = short_edge;
  freed.part = -1;
  mesh.boundary[facet].vertices[end] = middle;
  mesh.boundary.push_back(freed);
  scene::FacetData<2> data;
  data.normal = problem.facets[facet].normal;
  problem.facets.push_back(data);
  return problem;
}

}  // namespace

Problem<2> with_end_freed(Problem<2> problem, const ContactEnd& where, double distance) {
  scene::ContactFacet& contact = problem.contact[where.contact];
  contact.lower = where.end == 0 ? scene::on_stretch(contact.lower, distance, 1)
                                 : scene::on_stretch(contact.lower, 0, 1 - distance);
  contact.upper = contact.lower;
  const auto [first, second] = std::pair(contact.first, contact.second);
  const auto& ends = problem.mesh.boundary[first].vertices;
  const Vector<2> last = problem.mesh.vertices[ends[where.end]], other = problem.mesh.vertices[ends[1 - where.end]];
  const Vector<2> x = last + distance * (other - last);
  problem = with_piece_freed(std::move(problem), first, where.end, x);
  return second < 0 ? problem : with_piece_freed(std::move(problem), second, 1 - where.end, x);
}

Loading loading(const Problem<2>& problem) {
  const Mesh<2>& mesh = problem.mesh;
  Loading result;
  Vector<2> force = Vector<2>::Zero(), weighted = Vector<2>::Zero();
  Eigen::AlignedBox2d box;
  double length = 0;
  const auto ends = [&](int facet) {
    const auto& [a, b] = mesh.boundary[facet].vertices;
    return std::array<Vector<2>, 2>{mesh.vertices[a], mesh.vertices[b]};
  };
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& data = problem.facets[f];
    if (!scene::is_loaded(data)) continue;
    const int facet = static_cast<int>(f);
    const auto [a, b] = ends(facet);
    const double own = scene::length(mesh, facet);
    box.extend(a).extend(b);
    const auto load = scene::load(problem, facet);
    force += (load[0] + load[1]) / 2;
    weighted += own / 2 * (a + b);
    length += own;
    result.facets.push_back(facet);
  }
  if (result.facets.empty()) return result;
  result.mean = force / length;
  result.centre = weighted / length;
  const Vector<2> size = box.diagonal();
  result.reach = size[0] >= size[1] ? Vector<2>(size[0] / 2, 0) : Vector<2>(0, size[1] / 2);
  for (const int facet : result.facets) {
    const auto load = scene::load(problem, facet);
    const auto x = ends(facet);
    for (int i = 0; i < 2; ++i)
      result.moment += scene::hat_moment(load, i).dot(result.mean) * (x[i] - result.centre).dot(result.reach);
  }
  return result;
}

Problem<2> with_traction(Problem<2> problem, const Loading& loading,
                         const std::function<Vector<2>(const Vector<2>&)>& added) {
  for (const int facet : loading.facets)
    for (int end = 0; end < 2; ++end)
      problem.facets[facet].traction[end] += added(problem.mesh.vertices[problem.mesh.boundary[facet].vertices[end]]);
  return problem;
}

}  // namespace bracket::apps
