// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "scene/mesh/raw_mesh.h"

/// The readers of mesh files.
namespace bracket::scene {

/// Of any kind that is known, by what the file begins with and by the ending of its name.
/// \throw Error (input: no such file; mesh: not a mesh, truncated, …); so below
RawMesh read_raw_mesh(const std::filesystem::path& file);

/// Gmsh, ASCII, version 2.2 or 4.1, first and second order. Physical groups name bodies and parts, or, where there are
/// none, the numbers of surfaces and curves: "surface_1", "curve_3".
RawMesh read_gmsh(const std::filesystem::path& file);
/// Whether a text begins as what read_gmsh() reads.
bool is_gmsh_text(std::string_view text);

/// Abaqus input, as Abaqus, CalculiX, PrePoMax and Gmsh write it.
RawMesh read_abaqus(const std::filesystem::path& file);

/// Universal files (I-DEAS), as Salome and Gmsh write them, with their groups.
RawMesh read_unv(const std::filesystem::path& file);

/// What else libgmsh reads: Gmsh of any version, binary too, and files of other programs. A process of its own reads
/// it, so that its crash is an Error (mesh), as is more time than \p limit.
RawMesh read_by_libgmsh(const std::filesystem::path& file, std::chrono::seconds limit = std::chrono::seconds(300));

/// A decimal number, with a plus or Fortran's D if it likes; what is too small for a double is 0. None: it is not a
/// number.
std::optional<double> decimal(std::string_view text);

}  // namespace bracket::scene
