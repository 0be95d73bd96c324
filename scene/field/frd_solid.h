// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/field/raw_field.h"

namespace bracket::scene {

/// An element of CalculiX's results, by cgx's numbers of types and order of nodes.
struct FrdElement {
  int type;
  std::vector<int> nodes;  ///< places in RawField::nodes
};

/// The field on plane cells. CalculiX computes plane elements as solids one cell thick and writes these where OUTPUT=3D
/// is asked for: their two faces are then moved alike in the plane and, under plane stress, apart from it by as much
/// each way. Of such the lower face is taken. Nodes that no cell has are left out. \param out_of_plane the third
/// displacement of each node \throw Error (input): solids whose faces do not lie on each other or are moved otherwise;
/// as check_values()
RawField<2> plane_field(RawField<2> field, std::vector<double> out_of_plane, const std::vector<FrdElement>& elements);

/// The field on tetrahedra; lines and plane elements beside them are left out, as are nodes that no cell has.
/// \throw Error (input): other solids; as check_values()
RawField<3> field_of_tetrahedra(RawField<3> field, const std::vector<FrdElement>& elements);

}  // namespace bracket::scene
