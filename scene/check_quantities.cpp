// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "scene/fault.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

template <int dim> std::string fault_in(const Quantity<dim>& quantity) {
  using enum QuantityKind;
  const bool directed = quantity.kind == displacement || quantity.kind == body || quantity.kind == reaction ||
                        (dim == 3 && quantity.kind == rotation);
  if (quantity.kind != energy && quantity.of.empty()) return "it does not say of what";
  if (quantity.direction && !directed) return "only displacements and reactions have a direction";
  if (quantity.kind == body && !quantity.direction) return "a body has no normal; give a direction";
  if (quantity.direction && quantity.direction->isZero(0)) return "its direction must not be zero";
  if (quantity.of_force != ForceComponent::normal && quantity.kind != force)
    return "only the force of a contact has a component \"shear\"";
  if (dim == 3 && (quantity.kind == slip || quantity.of_force != ForceComponent::normal))
    return "slip and shear are of contacts with friction, which the plane alone has";
  if (dim == 2 && quantity.kind == stress && quantity.component > StressComponent::mean)
    return fmt::format("a stress in the plane has no component \"{}\"; expected xx, yy, xy or mean",
                       name(quantity.component));
  if ((quantity.stretch || quantity.weight) && !is_pressing_force(quantity) && quantity.kind != opening)
    return is_of_contact(quantity)
               ? "shear and slip have either sign, and no stretch or weight; ask for the whole contact, and for a part "
                 "of it make two contacts"
               : "only forces and openings of contacts have a stretch or a weight";
  if (quantity.stretch && quantity.weight) return "either a stretch or a weight";
  if (dim == 3 && quantity.kind == rotation && (!quantity.direction || (quantity.direction->array() != 0).count() != 1))
    return "a rotation in space is about an axis of the coordinates; give its direction, such as [0, 0, 1]";
  if (dim == 3 && quantity.stretch) return "a stretch by arc length is one of the plane; in space write a weight";
  if (!(quantity.target >= 0)) return fmt::format("its target must not be negative, is {}", quantity.target);
  if (!(quantity.absolute >= 0))
    return fmt::format("its absolute target must not be negative, is {}", quantity.absolute);
  std::vector<double> numbers = {quantity.target, quantity.absolute};
  if (quantity.direction) numbers.insert(numbers.end(), quantity.direction->begin(), quantity.direction->end());
  if (quantity.stretch) numbers.insert(numbers.end(), {quantity.stretch->from, quantity.stretch->to});
  for (const double number : numbers)
    if (const std::string message = size_message(number, "a number"); !message.empty()) return message;
  return "";
}

}  // namespace

template <int dim> std::optional<Fault> quantity_fault(const Scene<dim>& scene) {
  const bool without = dim == 2 && scene.solve.dual == Dual::local;
  constexpr const char* why = "takes the factors of solve.dual = \"hybrid\": write that, in place of \"local\"";
  if (without && !scene.quantities.empty())
    return Fault{{"quantity", "0"}, fmt::format("[[quantity]] {}", why), scene.quantities[0].where};
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.quantities.size(); ++i) {
    const Quantity<dim>& quantity = scene.quantities[i];
    const std::vector<std::string> key = {"quantity", std::to_string(i)};
    if (quantity.name.empty()) return Fault{key, "a quantity has no name", quantity.where};
    if (std::find(names.begin(), names.end(), quantity.name) != names.end())
      return Fault{key, fmt::format("two quantities are called '{}'; give them names of their own", quantity.name),
                   quantity.where};
    names.push_back(quantity.name);
    if (const std::string message = fault_in(quantity); !message.empty())
      return Fault{key, fmt::format("quantity '{}': {}", quantity.name, message), quantity.where};
  }
  std::set<std::string> contacts;
  for (std::size_t i = 0; i < scene.contact.size(); ++i) {
    const ContactPair<dim>& pair = scene.contact[i];
    const std::vector<std::string> key = {"contact", std::to_string(i)};
    if (!pair.name.empty() && !contacts.insert(pair.name).second)
      return Fault{key, fmt::format("two contacts are called '{}'", pair.name), pair.where};
    if (pair.zones < 0)
      return Fault{key, fmt::format("contact.zones must not be negative, is {}", pair.zones), pair.where};
    if (without && pair.zones > 0) return Fault{key, fmt::format("contact.zones {}", why), pair.where};
    if (dim == 3 && pair.zones > 0)
      return Fault{key, "contact.zones are stretches of lines; in space there are none: leave it out", pair.where};
  }
  if (!scene.refine.goal.empty() && std::find(names.begin(), names.end(), scene.refine.goal) == names.end())
    return Fault{{"refine", "goal"},
                 fmt::format("refine.goal: there is no quantity '{}'; {}", scene.refine.goal,
                             suggestion(scene.refine.goal, names)),
                 scene.file};
  return {};
}

template std::optional<Fault> quantity_fault(const Scene<2>&);
template std::optional<Fault> quantity_fault(const Scene<3>&);

}  // namespace bracket::scene
