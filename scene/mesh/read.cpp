// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <charconv>

#include "scene/mesh/abaqus_cards.h"
#include "scene/mesh/readers.h"
#include "scene/text.h"

namespace bracket::scene {

std::optional<double> decimal(std::string_view text) {
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

RawMesh read_raw_mesh(const std::filesystem::path& file) {
  if (capitals(file.extension().string()) == ".INP") return read_abaqus(file);
  return read_gmsh(file);
}

template <int dim> Mesh<dim> read_mesh(const std::filesystem::path& file) {
  static_assert(dim == 2);
  return mesh_of(read_raw_mesh(file), Scene<dim>{}, file.string());
}

template Mesh<2> read_mesh(const std::filesystem::path&);

}  // namespace bracket::scene
