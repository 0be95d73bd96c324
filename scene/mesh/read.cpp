// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <set>

#include "scene/mesh/abaqus_cards.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

std::optional<double> decimal(std::string_view text) {
  std::string fortran;
  if (text.find_first_of("dD") != std::string_view::npos) {
    fortran = text;
    std::ranges::replace_if(
        fortran, [](char c) { return c == 'd' || c == 'D'; }, 'e');
    text = fortran;
  }
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return {};
  if (error == std::errc()) return value;
  // Too large or too small: the exponent tells or, where there is none, the digits.
  if (text.starts_with('-')) text.remove_prefix(1);
  const std::size_t exponent = text.find_first_of("eE");
  const bool small = exponent == std::string_view::npos ? text.starts_with('0') || text.starts_with('.')
                                                        : text.substr(exponent + 1).starts_with('-');
  return small ? 0 : std::numeric_limits<double>::infinity();
}

namespace {

/// The first bytes of a file; empty where it cannot be read.
std::string beginning_of(const std::filesystem::path& file) {
  std::string text(64, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace

RawMesh read_raw_mesh(const std::filesystem::path& file) {
  // libgmsh runs what it does not know as a script: it gets only what it is sure to read as a mesh.
  static const std::set<std::string> by_libgmsh = {".BDF", ".NAS", ".MED", ".MESH", ".VTK"};
  const std::string ending = capitals(file.extension().string());
  if (ending == ".INP") return read_abaqus(file);
  if (ending == ".UNV") return read_unv(file);
  if (by_libgmsh.contains(ending)) return read_by_libgmsh(file);
  const std::string beginning = beginning_of(file);
  const bool foreign = beginning.starts_with("$MeshFormat") || beginning.starts_with("$NOD");
  if (ending == ".MSH" && foreign && !is_gmsh_text(beginning)) return read_by_libgmsh(file);
  if (ending == ".GEO")
    fail(Status::mesh, file.string(), "is a geometry, not a mesh; 'gmsh -2' makes a .msh of it, in space 'gmsh -3'");
  if (ending != ".MSH" && !is_gmsh_text(beginning)) {
    read_text(file);  // says what is wrong where it cannot be read
    fail(Status::mesh, file.string(),
         "is of no kind that is read: Gmsh (.msh), Abaqus (.inp), universal (.unv), Nastran (.bdf, .nas), Medit "
         "(.mesh), "
         "VTK (.vtk), MED (.med)");
  }
  return read_gmsh(file);
}

int dimension_of_mesh(const std::filesystem::path& file) { return read_raw_mesh(file).dimension; }

template <int dim> Mesh<dim> read_mesh(const std::filesystem::path& file) {
  return mesh_of(read_raw_mesh(file), Scene<dim>{}, file.string());
}

template Mesh<2> read_mesh(const std::filesystem::path&);
template Mesh<3> read_mesh(const std::filesystem::path&);

}  // namespace bracket::scene
