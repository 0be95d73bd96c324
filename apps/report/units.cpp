// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace bracket::apps {
namespace {

enum class Of { length, force, stress };

struct Unit {
  std::string_view name;
  Of of;
  double si;
};
constexpr double inch = 0.0254, pound_force = 4.4482216152605;
constexpr std::array known = {Unit{"m", Of::length, 1},
                              Unit{"cm", Of::length, 1e-2},
                              Unit{"mm", Of::length, 1e-3},
                              Unit{"µm", Of::length, 1e-6},
                              Unit{"um", Of::length, 1e-6},
                              Unit{"in", Of::length, inch},
                              Unit{"ft", Of::length, 12 * inch},
                              Unit{"N", Of::force, 1},
                              Unit{"kN", Of::force, 1e3},
                              Unit{"MN", Of::force, 1e6},
                              Unit{"lbf", Of::force, pound_force},
                              Unit{"kip", Of::force, 1e3 * pound_force},
                              Unit{"Pa", Of::stress, 1},
                              Unit{"kPa", Of::stress, 1e3},
                              Unit{"MPa", Of::stress, 1e6},
                              Unit{"GPa", Of::stress, 1e9},
                              Unit{"psi", Of::stress, pound_force / inch / inch},
                              Unit{"ksi", Of::stress, 1e3 * pound_force / inch / inch}};

}  // namespace

Units units_of(const std::string& label, int dim) {
  std::array<const Unit*, 3> named = {};
  for (std::size_t begin = 0; begin <= label.size();) {
    const std::size_t end = std::min(label.find_first_of(",;", begin), label.size());
    std::string_view word = std::string_view(label).substr(begin, end - begin);
    word.remove_prefix(std::min(word.find_first_not_of(' '), word.size()));
    word = word.substr(0, word.find_last_not_of(' ') + 1);
    const auto* const unit = std::ranges::find(known, word, &Unit::name);
    if (unit == known.end() || named[static_cast<std::size_t>(unit->of)] != nullptr) return {};
    named[static_cast<std::size_t>(unit->of)] = unit;
    begin = end + 1;
  }
  const auto& [length, force, stress] = named;
  if (length == nullptr || (force == nullptr && stress == nullptr)) return {};
  if (force != nullptr && stress != nullptr) {
    const double ratio = stress->si * length->si * length->si / force->si;
    if (std::abs(ratio - 1) > 1e-9) return {};  // rounding of the table's own numbers is less
  }
  const std::string_view l = length->name;
  Units units;
  units.length = fmt::format(" {}", l);
  units.angle = " rad";
  units.area = fmt::format(" {}²", l);
  units.volume = fmt::format(" {}³", l);
  const bool space = dim == 3;
  if (force == nullptr) {
    units.stress = fmt::format(" {}", stress->name);
    units.force = fmt::format(" {} {}{}", stress->name, l, space ? "²" : "");
    units.energy = fmt::format(" {} {}{}", stress->name, l, space ? "³" : "²");
    units.body_force = fmt::format(" {}/{}", stress->name, l);
  } else {
    units.stress = stress != nullptr ? fmt::format(" {}", stress->name) : fmt::format(" {}/{}²", force->name, l);
    units.force = space ? fmt::format(" {}", force->name) : fmt::format(" {}/{}", force->name, l);
    units.energy = space ? fmt::format(" {} {}", force->name, l) : fmt::format(" {} {}/{}", force->name, l, l);
    units.body_force = fmt::format(" {}/{}³", force->name, l);
  }
  units.energy_norm = fmt::format(" √({})", units.energy.substr(1));
  return units;
}

template <int dim> std::string unit_of(const scene::Quantity<dim>& quantity, const Units& units) {
  if (quantity.weight) return "";
  switch (quantity.kind) {
    case scene::QuantityKind::displacement:
    case scene::QuantityKind::body:
    case scene::QuantityKind::opening:
    case scene::QuantityKind::slip: return units.length;
    case scene::QuantityKind::rotation: return units.angle;
    case scene::QuantityKind::force:
    case scene::QuantityKind::reaction: return units.force;
    case scene::QuantityKind::stress: return units.stress;
    case scene::QuantityKind::energy: return units.energy;
  }
  return {};
}

template std::string unit_of(const scene::Quantity<2>&, const Units&);
template std::string unit_of(const scene::Quantity<3>&, const Units&);

}  // namespace bracket::apps
