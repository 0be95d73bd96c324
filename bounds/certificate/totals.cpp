// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/certificate/totals.h"

namespace bracket::bounds {

std::vector<Reference> references(const scene::Mesh<2>& mesh) {
  std::vector<Eigen::AlignedBox2d> boxes(mesh.components.size());
  for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    for (const int v : mesh.cells[c]) boxes[mesh.cell_component[c]].extend(mesh.vertices[v]);
  std::vector<Reference> result;
  for (const auto& box : boxes) result.push_back({box.center(), box.diagonal().norm() / 2});
  return result;
}

}  // namespace bracket::bounds
