// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/problems_in_space.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "scene/scene.h"

namespace bracket::tests {

using scene::Mesh;
using scene::Problem;
using scene::Simplex;
using scene::Vector;

namespace {

template <std::size_t n> std::array<int, n> sorted(std::array<int, n> v) {
  std::sort(v.begin(), v.end());
  return v;
}

/// Edges, facet numbers and boundary facets.
Mesh<3> with_facets(Mesh<3> mesh) {
  std::map<std::array<int, 2>, int> edges;
  std::map<std::array<int, 3>, std::vector<std::array<int, 2>>> facets;  // the cells at each
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    for (int e = 0; e < 6; ++e) {
      const auto& [i, k] = Simplex<3>::edges[e];
      edges.emplace(sorted(std::array<int, 2>{mesh.cells[c][i], mesh.cells[c][k]}), 0);
    }
    for (int f = 0; f < 4; ++f)
      facets[sorted(scene::facet_vertices(mesh, static_cast<int>(c), f))].push_back({static_cast<int>(c), f});
  }
  for (auto& [vertices, number] : edges) {
    number = static_cast<int>(mesh.edges.size());
    mesh.edges.push_back(vertices);
  }
  mesh.cell_edges.resize(mesh.cells.size());
  mesh.facet_numbers.resize(mesh.cells.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (int e = 0; e < 6; ++e) {
      const auto& [i, k] = Simplex<3>::edges[e];
      mesh.cell_edges[c][e] = edges.at(sorted(std::array<int, 2>{mesh.cells[c][i], mesh.cells[c][k]}));
    }
  for (const auto& [vertices, at] : facets) {
    for (const auto& [cell, local] : at) mesh.facet_numbers[cell][local] = mesh.facet_count;
    ++mesh.facet_count;
    if (at.size() == 1)
      mesh.boundary.push_back({scene::facet_vertices(mesh, at[0][0], at[0][1]), at[0][0], at[0][1], -1, -1});
  }
  return mesh;
}

void for_each_facet(Problem<3>& problem, const std::string& part,
                    const std::function<void(scene::FacetData<3>&, const std::array<Vector<3>, 3>&)>& set) {
  int count = 0;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& facet = problem.mesh.boundary[f];
    if (facet.part < 0 || problem.mesh.parts[facet.part] != part) continue;
    set(problem.facets[f], scene::positions(problem.mesh, facet.vertices));
    ++count;
  }
  if (count == 0) throw std::invalid_argument("no part " + part);
}

void set_normals(Problem<3>& problem) {
  std::vector<Vector<3>> known;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    Vector<3> n = scene::normal(problem.mesh, static_cast<int>(f));
    for (int k = 0; k < 3; ++k)
      if (std::abs(n[k]) < 1e-12) n[k] = 0;
    n.normalize();
    bool found = false;
    for (const Vector<3>& m : known)
      for (const double sign : {1.0, -1.0})
        if (!found && (sign * m - n).norm() < 1e-9) {
          n = sign * m;
          found = true;
        }
    if (!found) known.push_back(n);
    problem.facets[f].normal = n;
  }
}

}  // namespace

Mesh<3> mesh_of(const std::vector<Box>& boxes, const std::function<bool(const Vector<3>&)>& leave_out) {
  constexpr std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  const std::array<const char*, 6> sides = {"left", "right", "bottom", "top", "back", "front"};
  Mesh<3> mesh;
  for (const Box& box : boxes) {
    std::map<std::array<int, 3>, int> vertices;
    const auto size = [&](int k) { return (box.range[k][1] - box.range[k][0]) / box.cells[k]; };
    const auto vertex = [&](const std::array<int, 3>& i) {
      const auto [at, is_new] = vertices.emplace(i, static_cast<int>(mesh.vertices.size()));
      if (is_new) {
        Vector<3> x;
        for (int k = 0; k < 3; ++k) x[k] = i[k] == box.cells[k] ? box.range[k][1] : box.range[k][0] + i[k] * size(k);
        mesh.vertices.push_back(x);
      }
      return at->second;
    };
    const int body = static_cast<int>(mesh.bodies.size());
    mesh.bodies.push_back(box.body);
    mesh.components.push_back(box.body);
    for (int i = 0; i < box.cells[0]; ++i)
      for (int j = 0; j < box.cells[1]; ++j)
        for (int k = 0; k < box.cells[2]; ++k) {
          const Vector<3> centre(box.range[0][0] + (i + .5) * size(0), box.range[1][0] + (j + .5) * size(1),
                                 box.range[2][0] + (k + .5) * size(2));
          if (leave_out && leave_out(centre)) continue;
          for (int o = 0; o < 6; ++o) {
            std::array<int, 3> at = {i, j, k};
            std::array<int, 4> cell = {vertex(at), 0, 0, 0};
            for (int step = 0; step < 3; ++step) {
              ++at[orders[o][step]];
              cell[step + 1] = vertex(at);
            }
            if (o >= 3) std::swap(cell[2], cell[3]);  // these orders are odd
            mesh.cells.push_back(cell);
            mesh.cell_body.push_back(body);
            mesh.cell_component.push_back(body);
          }
        }
    for (const char* side : sides) mesh.parts.push_back(box.body + "." + side);
  }
  mesh = with_facets(std::move(mesh));
  for (auto& facet : mesh.boundary) {
    const int body = mesh.cell_body[facet.cell];
    for (int k = 0; k < 3; ++k)
      for (int end = 0; end < 2; ++end) {
        bool on = true;
        for (const int v : facet.vertices) on = on && mesh.vertices[v][k] == boxes[body].range[k][end];
        if (on) facet.part = 6 * body + 2 * k + end;
      }
  }
  return mesh;
}

Problem<3> problem_on(Mesh<3> mesh, const std::vector<scene::Body<3>>& bodies) {
  Problem<3> problem;
  problem.mesh = std::move(mesh);
  problem.bodies = bodies;
  problem.facets.resize(problem.mesh.boundary.size());
  Eigen::AlignedBox<double, 3> box;
  for (const auto& x : problem.mesh.vertices) box.extend(x);
  problem.length_scale = box.diagonal().norm();
  set_normals(problem);
  return problem;
}

void move(Problem<3>& problem, const std::function<Vector<3>(const Vector<3>&, int)>& to) {
  for (std::size_t v = 0; v < problem.mesh.vertices.size(); ++v)
    problem.mesh.vertices[v] = to(problem.mesh.vertices[v], static_cast<int>(v));
  set_normals(problem);
}

void fix(Problem<3>& problem, const std::string& part, const VectorAt& displacement) {
  for_each_facet(problem, part, [&](scene::FacetData<3>& data, const auto& x) {
    data.support = scene::Support::fixed;
    for (int i = 0; i < 3; ++i) data.displacement[i] = displacement(x[i]);
  });
}

void slide(Problem<3>& problem, const std::string& part, const NumberAt& normal_displacement) {
  for_each_facet(problem, part, [&](scene::FacetData<3>& data, const auto& x) {
    data.support = scene::Support::sliding;
    for (int i = 0; i < 3; ++i) data.normal_displacement[i] = normal_displacement(x[i]);
  });
}

void load(Problem<3>& problem, const std::string& part, const VectorAt& traction) {
  for_each_facet(problem, part, [&](scene::FacetData<3>& data, const auto& x) {
    for (int i = 0; i < 3; ++i) data.traction[i] = traction(x[i]);
  });
}

void touch(Problem<3>& problem, const std::string& first, const std::string& second, const NumberAt& gap,
           bool two_sided) {
  const auto& mesh = problem.mesh;
  const auto is_of = [&](const auto& facet, const std::string& part) {
    return facet.part >= 0 && mesh.parts[facet.part] == part;
  };
  const int pair = problem.contact.empty() ? 0 : problem.contact.back().pair + 1;
  for (std::size_t f = 0; f < mesh.boundary.size(); ++f) {
    if (!is_of(mesh.boundary[f], first)) continue;
    const auto x = scene::positions(mesh, mesh.boundary[f].vertices);
    scene::ContactFacetOf<3> contact{pair, static_cast<int>(f), -1, {}, {}};
    contact.law.two_sided = two_sided;
    for (int i = 0; i < 3; ++i) contact.lower[i] = gap(x[i]);
    for (int e = 0; e < 3; ++e) {
      const auto& [a, b] = Simplex<2>::edges[e];
      contact.lower[3 + e] = 2 * gap((x[a] + x[b]) / 2) - (contact.lower[a] + contact.lower[b]) / 2;
    }
    contact.upper = contact.lower;
    problem.facets[f].support = scene::Support::contact;
    for (std::size_t g = 0; g < mesh.boundary.size() && !second.empty(); ++g) {
      if (!is_of(mesh.boundary[g], second)) continue;
      const auto y = scene::positions(mesh, mesh.boundary[g].vertices);
      std::array<int, 3> meets{};
      int met = 0;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
          if (x[i] == y[k]) {
            meets[i] = k;
            ++met;
          }
      if (met < 3) continue;
      contact.meets = meets;
      contact.second = static_cast<int>(g);
      problem.facets[g].support = scene::Support::contact;
      problem.facets[g].normal = -problem.facets[f].normal;
    }
    if (!second.empty() && contact.second < 0) throw std::invalid_argument("no partner on " + second);
    problem.contact.push_back(contact);
  }
}

}  // namespace bracket::tests
