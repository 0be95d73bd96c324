// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bounds/space/problems.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "bounds/certificate/space/kept_gap.h"
#include "scene/problem/psi.h"

namespace bracket::tests {

using scene::Mesh;
using scene::Piece;
using scene::Problem;
using scene::Support;

namespace {

using Key = std::array<double, 3>;
Key key_of(const Vector<3>& x) { return {x[0], x[1], x[2]}; }

template <std::size_t n> std::array<int, n> sorted(std::array<int, n> values) {
  std::ranges::sort(values);
  return values;
}

void add_box(Mesh<3>& mesh, const Box& box) {
  const int base = static_cast<int>(mesh.vertices.size()), body = static_cast<int>(mesh.bodies.size());
  const auto& n = box.cells;
  for (int k = 0; k <= n[2]; ++k)
    for (int j = 0; j <= n[1]; ++j)
      for (int i = 0; i <= n[0]; ++i) {
        const std::array<int, 3> at = {i, j, k};
        Vector<3> x;
        for (int c = 0; c < 3; ++c) x[c] = box.from[c] + (box.to[c] - box.from[c]) * at[c] / n[c];
        mesh.vertices.push_back(x);
      }
  const auto vertex = [&](const std::array<int, 3>& at) {
    return base + (at[2] * (n[1] + 1) + at[1]) * (n[0] + 1) + at[0];
  };
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) {
        std::array<int, 3> axes = {0, 1, 2};
        do {
          std::array<int, 3> at = {i, j, k};
          std::array<int, 4> cell = {vertex(at), 0, 0, 0};
          for (int step = 0; step < 3; ++step) {
            ++at[axes[step]];
            cell[step + 1] = vertex(at);
          }
          if (scene::volume<3>(positions(mesh, cell)) < 0) std::swap(cell[2], cell[3]);
          mesh.cells.push_back(cell);
          mesh.cell_body.push_back(body);
        } while (std::ranges::next_permutation(axes).found);
      }
  mesh.bodies.push_back("body " + std::to_string(body));
}

Vector<3> middle_of(const Mesh<3>& mesh, int facet) {
  const auto x = positions(mesh, mesh.boundary[facet].vertices);
  return (x[0] + x[1] + x[2]) / 3;
}

/// Of each facet the one with the same vertices, on another body; −1: none. And which vertex meets which.
struct Met {
  int facet = -1;
  std::array<int, 3> meets = scene::backwards<3>();
};
std::vector<Met> met_facets(const Mesh<3>& mesh) {
  std::map<std::set<Key>, std::vector<int>> at;
  const auto keys = [&](int f) {
    std::set<Key> result;
    for (const auto& x : positions(mesh, mesh.boundary[f].vertices)) result.insert(key_of(x));
    return result;
  };
  const int n = static_cast<int>(mesh.boundary.size());
  for (int f = 0; f < n; ++f) at[keys(f)].push_back(f);
  std::vector<Met> met(n);
  for (const auto& [_, facets] : at) {
    if (facets.size() != 2) continue;
    for (int side = 0; side < 2; ++side) {
      const int own = facets[side], other = facets[1 - side];
      met[own].facet = other;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          if (mesh.vertices[mesh.boundary[own].vertices[i]] == mesh.vertices[mesh.boundary[other].vertices[k]])
            met[own].meets[i] = k;
    }
  }
  return met;
}

}  // namespace

scene::Mesh<3> with_topology(Mesh<3> mesh) {
  std::map<std::array<int, 2>, int> edges;
  std::map<std::array<int, 3>, std::vector<std::array<int, 2>>> facets;  // cell and local number
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (const auto& [a, b] : scene::Simplex<3>::edges)
      edges.insert({sorted<2>({mesh.cells[c][a], mesh.cells[c][b]}), 0});
    for (int k = 0; k < 4; ++k)
      facets[sorted(scene::facet_vertices(mesh, static_cast<int>(c), k))].push_back({static_cast<int>(c), k});
  }
  mesh.edges.clear();
  for (auto& [vertices, number] : edges) {
    number = static_cast<int>(mesh.edges.size());
    mesh.edges.push_back(vertices);
  }
  mesh.cell_edges.assign(mesh.cells.size(), {});
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int e = 0; e < 6; ++e) {
      const auto& [a, b] = scene::Simplex<3>::edges[e];
      mesh.cell_edges[c][e] = edges.at(sorted<2>({mesh.cells[c][a], mesh.cells[c][b]}));
    }
  mesh.facet_numbers.assign(mesh.cells.size(), {});
  mesh.boundary.clear();
  mesh.facet_count = 0;
  for (const auto& [_, sides] : facets) {
    for (const auto& [cell, local] : sides) mesh.facet_numbers[cell][local] = mesh.facet_count;
    ++mesh.facet_count;
    if (sides.size() == 2) continue;
    const auto& [cell, local] = sides[0];
    mesh.boundary.push_back({scene::facet_vertices(mesh, cell, local), cell, local, -1, -1});
  }
  mesh.cell_component = mesh.cell_body;
  mesh.components = mesh.bodies;
  mesh.refinement_edge.assign(mesh.cells.size(), 0);
  return mesh;
}

scene::Problem<3> problem_of(const std::vector<Box>& boxes, const Label& label, const Warp& warp) {
  Problem<3> problem;
  for (const Box& box : boxes) {
    add_box(problem.mesh, box);
    problem.bodies.emplace_back(box.material);
    problem.bodies.back().force = box.force;
  }
  problem.mesh = with_topology(std::move(problem.mesh));
  auto& mesh = problem.mesh;
  const auto n = static_cast<int>(mesh.boundary.size());
  for (int f = 0; f < n; ++f)
    problem.facets.push_back(label(mesh.cell_body[mesh.boundary[f].cell], middle_of(mesh, f),
                                   scene::area_vector<3>(positions(mesh, mesh.boundary[f].vertices)).normalized()));
  const auto met = met_facets(mesh);
  for (auto& x : mesh.vertices) x = warp(x);
  std::map<std::pair<int, Key>, int> pairs;
  for (int f = 0; f < n; ++f) {
    Vector<3>& normal = problem.facets[f].normal;
    normal = scene::area_vector<3>(positions(mesh, mesh.boundary[f].vertices)).normalized();
    for (int earlier = 0; earlier < f; ++earlier) {  // one and the same where they agree but for rounding
      const Vector<3>& other = problem.facets[earlier].normal;
      if ((other - normal).norm() < 1e-6) normal = other;
      if ((other + normal).norm() < 1e-6) normal = -other;
    }
    if (problem.facets[f].support != Support::contact) continue;
    const int other = met[f].facet;
    if (other >= 0 && other < f) continue;
    const int number =
        pairs.insert({{mesh.cell_body[mesh.boundary[f].cell], key_of(normal)}, static_cast<int>(pairs.size())})
            .first->second;
    problem.contact.push_back({number, f, other, {}, {}, {}, met[f].meets});
  }
  return problem;
}

namespace {

template <std::size_t d> std::array<double, d> halfway(const std::array<double, d>& a, const std::array<double, d>& b) {
  std::array<double, d> middle;
  for (std::size_t i = 0; i < d; ++i) middle[i] = 0.5 * (a[i] + b[i]);
  return middle;
}

/// The edges that meet an edge in contacts, and itself.
std::set<int> meeting(const Problem<3>& problem, int edge) {
  std::set<int> found = {edge};
  for (std::size_t size = 0; size != found.size();) {
    size = found.size();
    for (const auto& pair : problem.contact)
      for (int k = 3; k < 6 && pair.second >= 0; ++k) {
        const auto vertices = static_cast<int>(problem.mesh.vertices.size());
        const int one = bounds::space::nodes_of_facet(problem.mesh, pair.first)[k] - vertices;
        const int other = bounds::space::node_across(problem.mesh, pair, k) - vertices;
        if (found.contains(one) || found.contains(other)) found.insert({one, other});
      }
  }
  return found;
}

/// A refined facet's data: those of the first mesh, rounded.
scene::FacetData<3> on_piece(scene::FacetData<3> data, const Piece<2>& piece) {
  const auto given = data;
  for (int i = 0; i < 3; ++i) {
    const auto& [s, t] = piece.corner[i];
    const auto at = [&](const auto& v) { return ((1 - s) - t) * v[0] + s * v[1] + t * v[2]; };
    data.traction[i] = at(given.traction);
    data.pressure[i] = at(given.pressure);
    data.displacement[i] = at(given.displacement);
    data.normal_displacement[i] = at(given.normal_displacement);
  }
  return data;
}

}  // namespace

scene::Problem<3> halved(const Problem<3>& problem, int edge) {
  const auto& old = problem.mesh;
  Problem<3> finer = problem;
  finer.origin.first = problem.origin.first ? problem.origin.first : std::make_shared<const Problem<3>>(problem);
  const Problem<3>& first = *finer.origin.first;
  finer.origin.cells.clear();
  finer.origin.facets.clear();
  std::map<std::array<int, 2>, int> middle;
  for (const int one : meeting(problem, edge)) {
    const auto& [a, b] = old.edges[one];
    middle[old.edges[one]] = static_cast<int>(finer.mesh.vertices.size());
    finer.mesh.vertices.push_back(0.5 * (old.vertices[a] + old.vertices[b]));
  }
  finer.mesh.cells.clear();
  finer.mesh.cell_body.clear();
  std::map<std::array<int, 3>, std::pair<int, Piece<2>>> facets;  // by vertices: facet of the old mesh, piece
  const auto split = [&](const auto& vertices, const auto& piece, const auto& keep) {
    for (std::size_t a = 0; a < vertices.size(); ++a)
      for (std::size_t b = a + 1; b < vertices.size(); ++b) {
        const auto found = middle.find(sorted<2>({vertices[a], vertices[b]}));
        if (found == middle.end()) continue;
        for (const std::size_t gone : {a, b}) {
          auto own = vertices;
          auto part = piece;
          own[gone] = found->second;
          part.corner[gone] = halfway(piece.corner[a], piece.corner[b]);
          keep(own, part);
        }
        return;
      }
    keep(vertices, piece);
  };
  for (std::size_t c = 0; c < old.cells.size(); ++c)
    split(old.cells[c], scene::piece_of_cell(problem, static_cast<int>(c)), [&](const auto& cell, const auto& piece) {
      finer.mesh.cells.push_back(cell);
      finer.mesh.cell_body.push_back(old.cell_body[c]);
      finer.origin.cells.push_back(piece);
    });
  for (std::size_t f = 0; f < old.boundary.size(); ++f)
    split(old.boundary[f].vertices, scene::piece_of_facet(problem, static_cast<int>(f)),
          [&](const auto& facet, const auto& piece) {
            facets[sorted(facet)] = {static_cast<int>(f), {piece}};
            // in the order of `facet`
            auto& kept = facets[sorted(facet)].second;
            std::map<int, std::array<double, 2>> corner;
            for (int i = 0; i < 3; ++i) corner[facet[i]] = piece.corner[i];
            for (int i = 0; i < 3; ++i) kept.corner[i] = corner[sorted(facet)[i]];
          });
  finer.mesh = with_topology(std::move(finer.mesh));
  finer.facets.clear();
  for (const auto& facet : finer.mesh.boundary) {
    const auto order = sorted(facet.vertices);
    auto piece = facets.at(order).second;
    const auto given = piece;
    for (int i = 0; i < 3; ++i)
      piece.corner[i] = given.corner[std::ranges::find(order, facet.vertices[i]) - order.begin()];
    finer.origin.facets.push_back(piece);
    finer.facets.push_back(on_piece(first.facets[piece.of], piece));
  }
  const auto met = met_facets(finer.mesh);
  const auto contacts = scene::contacts_by_first(first);
  finer.contact.clear();
  for (int f = 0; f < static_cast<int>(finer.facets.size()); ++f) {
    const Piece<2>& piece = finer.origin.facets[f];
    if (contacts[piece.of] < 0) continue;
    const auto& whole = first.contact[contacts[piece.of]];
    scene::ContactFacetOf<3> pair = whole;
    pair.first = f;
    pair.second = whole.second < 0 ? -1 : met[f].facet;
    pair.meets = met[f].meets;
    const auto below = scene::on_part(whole.lower, piece.corner);
    const auto above = scene::on_part(whole.upper, piece.corner);
    for (int k = 0; k < 6; ++k) {
      const auto [least, most] = std::ranges::minmax(whole.lower);
      const double rounding = least == most ? 0 : 1e-15 * std::max(std::abs(least), std::abs(most));
      pair.lower[k] = below[k] - rounding;
      pair.upper[k] = above[k] + rounding;
    }
    finer.contact.push_back(pair);
  }
  return finer;
}

scene::Problem<3> refined(Problem<3> problem, int halvings, std::mt19937& generator) {
  for (int k = 0; k < halvings; ++k) {
    const auto& mesh = problem.mesh;
    const std::size_t cell = std::uniform_int_distribution<std::size_t>(0, mesh.cells.size() - 1)(generator);
    const auto longer = [&](int a, int b) {
      const auto length = [&](int e) {
        return (mesh.vertices[mesh.edges[e][0]] - mesh.vertices[mesh.edges[e][1]]).norm();
      };
      return length(a) < length(b);
    };
    const int longest = *std::ranges::max_element(mesh.cell_edges[cell], longer);
    problem = halved(problem, k % 4 == 3 ? mesh.cell_edges[cell][0] : longest);
  }
  return problem;
}

scene::Material<3> steel(double young, double poisson) {
  return scene::isotropic<3>(young, poisson, scene::Plane::strain);
}
scene::Material<3> crystal() {
  scene::Elasticity<3> c = scene::Elasticity<3>::Zero();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) c(i, j) = i == j ? 2 + 0.25 * i : 0.125 / (1 + std::abs(i - j));
  return scene::anisotropic<3>(c);
}

scene::Displacement<3> random_displacement(const Problem<3>& problem, int degree, double size,
                                           std::mt19937& generator) {
  std::uniform_real_distribution<double> number(-size, size);
  const auto vector = [&] { return Vector<3>(number(generator), number(generator), number(generator)); };
  scene::Displacement<3> u{degree, {}, {}, {}};
  for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v) u.vertex.push_back(vector());
  for (std::size_t e = 0; e < problem.mesh.edges.size() && degree > 1; ++e) u.edge.push_back(vector());
  return u;
}

scene::Stress<3> random_stress(const Problem<3>& problem, const scene::Voigt<3>& mean, double size,
                               std::mt19937& generator) {
  std::uniform_real_distribution<double> number(-size, size);
  scene::Stress<3> stress;
  for (std::size_t c = 0; c < problem.mesh.cells.size(); ++c) {
    std::vector<scene::Voigt<3>> values(16, mean);
    for (auto& value : values)
      for (double& x : value) x += number(generator);
    stress.cell.push_back(values);
  }
  return stress;
}

}  // namespace bracket::tests
