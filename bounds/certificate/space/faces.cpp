// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/space/faces.h"

#include <algorithm>

namespace bracket::bounds::space {

std::vector<Face> faces_of(const scene::Mesh<3>& mesh) {
  std::vector<Face> faces(scene::n_facets(mesh));
  for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell)
    for (int k = 0; k < 4; ++k) {
      Face& face = faces[scene::cell_facets(mesh, cell)[k]];
      const bool second = face.cell[0] >= 0;
      face.cell[second] = cell;
      face.local[second] = k;
      if (!second) continue;
      const auto one = scene::facet_vertices(mesh, face.cell[0], face.local[0]);
      const auto other = scene::facet_vertices(mesh, cell, k);
      for (int i = 0; i < 3; ++i)
        face.across[i] = static_cast<int>(std::find(other.begin(), other.end(), one[i]) - other.begin());
    }
  return faces;
}

}  // namespace bracket::bounds::space
