// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/stress_loads.h"

#include <algorithm>

#include "scene/voigt.h"

namespace bracket::bounds::space {

namespace {

using scene::Support;
using scene::Vector;

/// A pressure below this part of the largest traction on either body is rounding of their stresses. It has to go: on a
/// body that nothing holds it would be a load, which the data do not have.
constexpr double noise = 1e-11;

double area(const scene::Mesh<3>& mesh, const Face& face) {
  return scene::area_vector<3>(positions(mesh, scene::facet_vertices(mesh, face.cell[0], face.local[0]))).norm();
}

void drop_noise(const scene::Problem<3>& problem, const std::vector<Face>& faces, PlainLoads& loads) {
  const auto& mesh = problem.mesh;
  std::vector<double> largest(mesh.components.size(), 0);  // traction in each body
  for (std::size_t f = 0; f < faces.size(); ++f) {
    double& of_body = largest[mesh.cell_component[faces[f].cell[0]]];
    for (const Vector<3>& load : loads.face[f]) of_body = std::max(of_body, load.norm() / area(mesh, faces[f]));
  }
  for (const auto& pair : problem.contact) {
    double traction = largest[mesh.cell_component[mesh.boundary[pair.first].cell]];
    if (pair.second >= 0) traction = std::max(traction, largest[mesh.cell_component[mesh.boundary[pair.second].cell]]);
    const double least = noise * traction * area(mesh, faces[face_of(mesh, pair.first)]);
    for (double& p : loads.along_normal[pair.first])
      if (p <= least && (!pair.law.two_sided || p >= -least)) p = 0;
  }
}

}  // namespace

PlainLoads plain_loads(const scene::Problem<3>& problem, const std::vector<Face>& faces,
                       const scene::Stress<3>& stress) {
  const auto& mesh = problem.mesh;
  PlainLoads loads = no_loads(problem);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face& face = faces[f];
    const int sides = face.cell[1] < 0 ? 1 : 2;
    for (int side = 0; side < sides; ++side) {  // λn of each, as it acts on the first cell: their mean
      const int cell = face.cell[side], k = face.local[side];
      const Vector<3> normal = scene::area_vector<3>(positions(mesh, scene::facet_vertices(mesh, cell, k))) / sides;
      for (int i = 0; i < 3; ++i) {
        const int own = side == 0 ? i : face.across[i];
        const Vector<3> load = scene::traction<3>(stress.cell[cell][4 * k + own], normal);
        loads.face[f][i] += side == 0 ? load : Vector<3>(-load);
      }
    }
  }
  for (std::size_t f = 0; f < problem.facets.size(); ++f) {
    const int facet = static_cast<int>(f);
    if (problem.facets[f].support == Support::traction || !has_perturbing_load(problem, facet)) continue;
    const auto added = beside<double>(problem, facet);
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 3; ++c) loads.face[face_of(mesh, facet)][i][c] -= added[i][c];
  }
  const auto along = [&](int facet, int i) {
    return loads.face[face_of(mesh, facet)][i].dot(problem.facets[facet].normal);
  };
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    for (int i = 0; i < 3 && problem.facets[f].support == Support::sliding; ++i)
      loads.along_normal[f][i] = along(static_cast<int>(f), i);
  for (const auto& pair : problem.contact) {
    const auto opening = opening_load<double>(problem, pair);
    for (int i = 0; i < 3; ++i) {
      double pressure = -along(pair.first, i);
      if (pair.second >= 0) pressure = (pressure - along(pair.second, pair.meets[i])) / 2;
      pressure += problem.perturbed.loads * opening[i];
      loads.along_normal[pair.first][i] = pair.law.two_sided ? pressure : std::max(0.0, pressure);
    }
  }
  drop_noise(problem, faces, loads);
  for (std::size_t f = 0; f < problem.facets.size(); ++f)
    if (problem.facets[f].support != Support::fixed)
      loads.face[face_of(mesh, static_cast<int>(f))].fill(Vector<3>::Zero());
  return loads;
}

PlainLoads no_loads(const scene::Problem<3>& problem, double pressure) {
  PlainLoads none;
  none.face.assign(scene::n_facets(problem.mesh), scene::at_vertices<3>(Vector<3>(Vector<3>::Zero())));
  none.along_normal.assign(problem.facets.size(), {0, 0, 0});
  for (const auto& pair : problem.contact) none.along_normal[pair.first] = {pressure, pressure, pressure};
  return none;
}

std::vector<char> carrying_pairs(const scene::Problem<3>& problem, const PlainLoads& loads) {
  std::vector<char> carrying;
  for (const auto& pair : problem.contact) {
    carrying.resize(std::max<std::size_t>(carrying.size(), pair.pair + 1), 0);
    carrying[pair.pair] |= pair.law.two_sided;
    for (const double p : loads.along_normal[pair.first]) carrying[pair.pair] |= p > 0;
  }
  return carrying;
}

}  // namespace bracket::bounds::space
