// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// Small files of each kind, with everything that its reader knows, and words that may do harm in them.
namespace bracket::tests::seeds {

std::vector<std::string> gmsh();
std::vector<std::string> gmsh_words();
std::vector<std::string> abaqus();
std::vector<std::string> abaqus_words();
std::vector<std::string> unv();
std::vector<std::string> unv_words();
/// Displacements of two blocks of two triangles each.
std::vector<std::string> csv();
std::vector<std::string> csv_words();
std::vector<std::string> frd();
std::vector<std::string> frd_words();

}  // namespace bracket::tests::seeds
