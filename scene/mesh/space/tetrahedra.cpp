// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// In space: cells of files are tetrahedra.
#include <limits>

#include "scene/mesh/raw_nodes.h"
#include "scene/text.h"

namespace bracket::scene {

template <> Simplices<3> simplices_of<3>(const RawMesh& raw, double merge, const std::string& where) {
  if (raw.cells.empty() || raw.dimension != 3)
    fail(Status::mesh, where,
         "the mesh has no tetrahedra; Gmsh makes them of a .geo by 'gmsh -3' and, where there are physical groups, "
         "saves "
         "only those in physical volumes; of plane meshes the scene has dim = 2");
  if (raw.cells.size() + raw.nodes.size() > std::numeric_limits<int>::max() / 16)
    fail(Status::mesh, where, "the mesh is too large");
  const UsedNodes used = used_nodes(raw);
  Simplices<3> result;
  number_vertices(result, raw, used, representatives<3>(raw, used, merge, where, result.notes));
  result.cells.reserve(raw.cells.size());
  for (std::size_t i = 0; i < raw.cells.size(); ++i) {
    const auto& [a, b, c, d] = raw.cells[i].corners;
    result.cells.push_back({result.vertex[a], result.vertex[b], result.vertex[c], result.vertex[d]});
    result.origin.push_back(static_cast<int>(i));
  }
  if (auto note = straightened<3>(raw)) result.notes.push_back(std::move(*note));
  return result;
}

}  // namespace bracket::scene
