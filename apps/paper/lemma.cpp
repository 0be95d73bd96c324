// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "apps/paper/paper.h"
#include "dual/block_element.h"
#include "scene/voigt.h"

/// Lemma 1.6 of [HH81]: a stress satisfies (1.18) … (1.22) if and only if it lies in K⁺_{F,P}, that is, if its work on
/// every displacement of K is at least that of the loads.
namespace bracket::apps {
namespace {

using scene::Support;
using scene::Vector;
using scene::Voigt;

/// A functional on the quadratics: a force at each vertex and each edge, by the Bernstein polynomials λ_i², 2 λ_i λ_j.
/// A displacement whose coefficients keep the contact keeps it everywhere.
struct Forces {
  explicit Forces(const scene::Mesh<2>& mesh)
      : vertex(mesh.vertices.size(), Vector<2>::Zero()), edge(mesh.edges.size(), Vector<2>::Zero()) {}
  std::vector<Vector<2>> vertex, edge;

  double norm() const {
    double sum = 0;
    for (const auto* list : {&vertex, &edge})
      for (const Vector<2>& force : *list) sum += force.squaredNorm();
    return std::sqrt(sum);
  }
};

/// ∫ λ : ε(v) on one part of a cell, by its polynomials: v's coefficients at the cell's vertices and edges.
void add_part(const scene::Mesh<2>& mesh, int cell, int part, const std::vector<scene::Voigt<2>>& stress,
              Forces& forces) {
  const auto& v = mesh.cells[cell];
  using Table = scene::Simplex<2>;
  const double part_area = scene::volume(mesh, cell) / 3;
  const auto gradient = scene::hat_gradients<2>(scene::positions(mesh, v));
  std::array<Vector<3>, 3> at;  // barycentric coordinates of the part's corners
  for (int i = 0; i < 2; ++i) at[i] = Vector<3>::Unit(Table::facets[part][i]);
  at[2] = Vector<3>::Constant(1. / 3);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const Voigt<2>& s = stress[3 * part + a];
      const double weight = part_area / Table::hat_masses_of * Table::hat_mass(a, b);
      const auto force = [&](const Vector<2>& slope) { return Vector<2>(weight * scene::traction<2>(s, slope)); };
      for (int k = 0; k < 3; ++k) {
        const auto [i, j] = Table::edges[k];
        forces.vertex[v[k]] += force(2 * at[b][k] * gradient[k]);
        forces.edge[mesh.cell_edges[cell][k]] += force(2 * (at[b][i] * gradient[j] + at[b][j] * gradient[i]));
      }
    }
}

Forces work_of_stress(const scene::Mesh<2>& mesh, const scene::Stress<2>& stress) {
  Forces forces(mesh);
  for (int c = 0; c < static_cast<int>(mesh.cells.size()); ++c)
    for (int part = 0; part < 3; ++part) add_part(mesh, c, part, stress.cell[c], forces);
  return forces;
}

/// \pre no body force
void subtract_loads(const scene::Problem<2>& problem, Forces& forces) {
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    if (problem.facets[f].support != Support::traction) continue;
    const auto& facet = problem.mesh.boundary[f];
    const auto [load0, load1] = scene::load(problem, static_cast<int>(f));
    forces.vertex[facet.vertices[0]] -= (3 * load0 + load1) / 12;
    forces.vertex[facet.vertices[1]] -= (load0 + 3 * load1) / 12;
    forces.edge[facet.edge] -= (load0 + load1) / 6;
  }
}

/// The displacement of K that is nearest to v, of which the contact's coefficients come in pairs.
/// \pre no gaps; supports along the axes, at right angles to the contact where they meet
void project_on_cone(const scene::Problem<2>& problem, Forces& v) {
  const auto& mesh = problem.mesh;
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const auto& facet = mesh.boundary[f];
    const auto& data = problem.facets[f];
    for (Vector<2>* at : {&v.vertex[facet.vertices[0]], &v.vertex[facet.vertices[1]], &v.edge[facet.edge]}) {
      if (data.support == Support::fixed) at->setZero();
      if (data.support == Support::sliding) *at -= at->dot(data.normal) * data.normal;
    }
  }
  for (const auto& contact : problem.contact) {
    const auto &first = mesh.boundary[contact.first], &second = mesh.boundary[contact.second];
    const Vector<2>& d = problem.facets[contact.first].normal;
    const auto separate = [&d](Vector<2>& one, Vector<2>& other) {
      const double overlap = (one - other).dot(d);
      if (overlap > 0) one -= overlap / 2 * d, other += overlap / 2 * d;
    };
    separate(v.vertex[first.vertices[0]], v.vertex[second.vertices[1]]);
    separate(v.vertex[first.vertices[1]], v.vertex[second.vertices[0]]);
    separate(v.edge[first.edge], v.edge[second.edge]);
  }
}

/// −min (∫ λ : ε(v) − ℓ(v)) over the quadratics v of K with coefficients of norm one, by the norm of ∫ λ : ε.
double work_below_loads(const scene::Problem<2>& problem, const scene::Stress<2>& stress) {
  Forces forces = work_of_stress(problem.mesh, stress);
  const double size = forces.norm();
  subtract_loads(problem, forces);
  Forces descent = forces;
  for (auto* list : {&descent.vertex, &descent.edge})
    for (Vector<2>& value : *list) value = -value;
  project_on_cone(problem, descent);
  return descent.norm() / size;
}

double largest(const scene::Stress<2>& stress) {
  double size = 0;
  for (const auto& corners : stress.cell)
    for (const Voigt<2>& s : corners) size = std::max(size, s.cwiseAbs().maxCoeff());
  return size;
}

/// The block's stress that loads but one side, along itself, by moments ∓1 at its ends.
dual::Corners shear_of_side(const scene::Mesh<2>& mesh, int cell, int side, double size) {
  const auto& v = mesh.cells[cell];
  const auto block = dual::block_element<1>({mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]},
                                            scene::Elasticity<2>::Identity());
  dual::Corners corners = dual::block_stress<1>(block.piola, dual::ModeVector<1>::Unit(6 + side));
  double greatest = 0;
  for (const Voigt<2>& s : corners) greatest = std::max(greatest, s.cwiseAbs().maxCoeff());
  for (Voigt<2>& s : corners) s *= size / greatest;
  return corners;
}

struct Case {
  std::string label;
  scene::Problem<2> problem;
  scene::Stress<2> stress;
};

Case broken(std::string label, const bounds::Outcome<2>& solved, int cell, const dual::Corners& added) {
  Case result{std::move(label), solved.problem, solved.stress};
  for (int c = 0; c < 9; ++c) result.stress.cell[cell][c] += added[c];
  return result;
}

Case sheared(std::string label, const bounds::Outcome<2>& solved, const std::string& part) {
  const auto& mesh = solved.problem.mesh;
  const auto& facet =
      *std::ranges::find_if(mesh.boundary, [&](const auto& f) { return f.part >= 0 && mesh.parts[f.part] == part; });
  return broken(std::move(label), solved, facet.cell,
                shear_of_side(mesh, facet.cell, facet.local, largest(solved.stress) / 10));
}

std::vector<Case> cases() {
  std::vector<Case> list;
  bounds::Outcome<2> solved;
  for (const Example& example : examples()) {
    if (example.name == "contact end") continue;  // a gap: K is no cone
    solved = bounds::run(example.scene(4));
    list.push_back({"solved: " + example.name, solved.problem, solved.stress});
  }
  const auto& mesh = solved.problem.mesh;
  const double size = largest(solved.stress) / 10;

  // A stress that grows from zero on the cell's sides to its centroid: tractions stay continuous.
  dual::Corners tent;
  for (int c = 0; c < 9; ++c) tent[c] = c % 3 == 2 ? Voigt<2>(size, 0, 0) : Voigt<2>(Voigt<2>::Zero());
  list.push_back(broken("(1.18) inside of a cell", solved, 0, tent));
  std::vector<char> outer(mesh.edges.size(), 0);
  for (const auto& facet : mesh.boundary) outer[facet.edge] = 1;
  const auto& sides = mesh.cell_edges[0];
  const int inner = static_cast<int>(std::ranges::find_if(sides, [&](int e) { return !outer[e]; }) - sides.begin());
  list.push_back(broken("(1.18) between cells", solved, 0, shear_of_side(mesh, 0, inner, size)));
  list.push_back(sheared("(1.19) load", solved, "slider.top"));
  list.push_back(sheared("(1.20) shear on the base", solved, "slider.bottom"));
  list.push_back(sheared("(1.21) shear on the contact", solved, "slider.right"));

  Case unequal{"(1.22) two pressures", solved.problem, solved.stress};
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    if (mesh.bodies[mesh.cell_body[c]] == "stop")
      for (Voigt<2>& s : unequal.stress.cell[c]) s *= 1.1;
  list.push_back(unequal);
  Case tension{"(1.22) tension", solved.problem, solved.stress};  // loads and stresses turned round
  for (auto& facet : tension.problem.facets) {
    for (Vector<2>& t : facet.traction) t = -t;
    for (double& p : facet.pressure) p = -p;
  }
  for (auto& corners : tension.stress.cell)
    for (Voigt<2>& s : corners) s = -s;
  list.push_back(tension);
  return list;
}

}  // namespace

Table admissible_stresses() {
  Table table{"lemma_1_6",
              "Lemma 1.6. A stress is in K+ if and only if it satisfies (1.18) to (1.22). Left:\n"
              "how far each of them is missed, by the largest stress: balance (1.18), jumps\n"
              "(1.18) and (1.22), boundary (1.19) to (1.21), tension (1.22). Right: the most by\n"
              "which the work of the loads exceeds that of the stress, on all quadratics of K,\n"
              "by the norm of the latter: 0 in K+.",
              {{"balance", ".1e"}, {"jumps", ".1e"}, {"boundary", ".1e"}, {"tension", ".1e"}, {"excess", ".1e"}}};
  for (const Case& c : cases()) {
    const std::vector<Vector<2>> rest(c.problem.mesh.vertices.size(), Vector<2>::Zero());
    const bounds::Checks checks = bounds::admissibility(c.problem, {.degree = 1, .vertex = rest, .edge = {}}, c.stress);
    table.rows.push_back({c.label,
                          {checks.equilibrium, checks.interface_jump, checks.boundary_traction, checks.tension,
                           work_below_loads(c.problem, c.stress)}});
  }
  return table;
}

}  // namespace bracket::apps
