// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/quantity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace bracket::scene {

namespace {

/// The key that says what is asked, of which there must be one.
template <int dim> const toml::node& kind_of(const toml::table& entry, Quantity<dim>& quantity) {
  const auto& kinds = option_names<QuantityKind>;
  const toml::node* found = nullptr;
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const toml::node* node = entry.get(kinds[kind]);
    if (node == nullptr) continue;
    if (found != nullptr) refuse(*node, fmt::format("a quantity is either {} or {}", name(quantity.kind), kinds[kind]));
    quantity.kind = static_cast<QuantityKind>(kind);
    found = node;
  }
  if (found == nullptr)
    refuse(entry, fmt::format("[[quantity]] must say of what; write one of {}", fmt::join(kinds, ", ")));
  return *found;
}

/// What it is called where the scene gives no name.
template <int dim> std::string description(const Quantity<dim>& quantity) {
  switch (quantity.kind) {
    case QuantityKind::energy: return "strain energy";
    case QuantityKind::body: return "displacement of " + quantity.of;
    case QuantityKind::stress: return fmt::format("stress {} of {}", name(quantity.component), quantity.of);
    case QuantityKind::force:
      return (quantity.of_force == ForceComponent::shear ? "shear force of " : "force of ") + quantity.of;
    default: return fmt::format("{} of {}", name(quantity.kind), quantity.of);
  }
}

}  // namespace

template <int dim> Quantity<dim> read_quantity(const toml::table& entry) {
  const std::string called = "quantity";
  check_keys(entry, "[[quantity]]",
             {"displacement", "body", "rotation", "force", "opening", "reaction", "stress", "energy", "slip", "name",
              "direction", "component", "from", "to", "weight", "target", "absolute"});
  Quantity<dim> quantity;
  quantity.where = where(entry);
  const toml::node& of = kind_of(entry, quantity);
  const std::string kind = name(quantity.kind);
  if (quantity.kind != QuantityKind::energy)
    quantity.of = label(of, called + "." + kind);
  else if (!truth(of, "quantity.energy"))
    refuse(of, "quantity.energy must be true");

  const auto belongs = [&](const char* key, std::initializer_list<QuantityKind> kinds) -> const toml::node* {
    const toml::node* node = entry.get(key);
    if (node != nullptr && std::find(kinds.begin(), kinds.end(), quantity.kind) == kinds.end()) {
      std::vector<std::string> names;
      for (const QuantityKind one : kinds) names.push_back(name(one));
      refuse(*node, fmt::format("quantity.{} belongs to {}, not to {}", key, fmt::join(names, ", "), kind));
    }
    return node;
  };
  using enum QuantityKind;
  const bool turns = dim == 3 && quantity.kind == rotation;
  if (const toml::node* direction =
          turns ? entry.get("direction") : belongs("direction", {displacement, body, reaction});
      direction != nullptr && direction->value<std::string>() != "normal") {
    quantity.direction = vector<dim>(*direction, called + ".direction");
  } else if (direction == nullptr &&
             (quantity.kind == displacement || quantity.kind == body || quantity.kind == reaction)) {
    refuse(entry, fmt::format("quantity.{} needs a direction = [{}]{}", kind, dim == 2 ? "x, y" : "x, y, z",
                              quantity.kind == body ? "" : ", or \"normal\""));
  }
  const toml::node* component = belongs("component", {stress, force});
  if (component != nullptr && quantity.kind == force)
    quantity.of_force = choice<ForceComponent>(*component, called + ".component");
  else if (component != nullptr)
    quantity.component = choice<StressComponent>(*component, called + ".component");
  else if (quantity.kind == stress)
    refuse(entry, fmt::format("quantity.stress needs a component: {} or mean",
                              dim == 2 ? "xx, yy, xy" : "xx, yy, zz, xy, yz, xz"));
  const toml::node* from = belongs("from", {force, opening});
  const toml::node* to = belongs("to", {force, opening});
  if (from != nullptr || to != nullptr) {
    if (from == nullptr || to == nullptr) refuse(*(from == nullptr ? to : from), "a stretch needs both from and to");
    quantity.stretch = {number(*from, called + ".from"), number(*to, called + ".to")};
  }
  if (const toml::node* weight = belongs("weight", {force, opening})) {
    if (quantity.stretch) refuse(*weight, "a quantity has either a stretch or a weight");
    quantity.weight = function<dim>(*weight, called + ".weight");
  }
  if (const toml::node* target = entry.get("target")) quantity.target = number(*target, called + ".target");
  if (const toml::node* absolute = entry.get("absolute")) quantity.absolute = number(*absolute, called + ".absolute");
  const toml::node* own = entry.get("name");
  quantity.name = own != nullptr ? label(*own, called + ".name") : description(quantity);
  return quantity;
}

template Quantity<2> read_quantity<2>(const toml::table&);
template Quantity<3> read_quantity<3>(const toml::table&);

}  // namespace bracket::scene
