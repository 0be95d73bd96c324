// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "scene/fault.h"

namespace bracket::scene {

template <int dim> std::string law_message(const Scene<dim>& scene, const ContactPair<dim>& pair) {
  if (pair.law == Law::bonded) return "a contact pair cannot be bonded; what sticks is a bond of its own";
  if (dim == 3 && pair.law != Law::frictionless && pair.law != Law::bilateral)
    return fmt::format("contact.law: three dimensions know \"frictionless\", \"bilateral\" and \"bonded\", not \"{}\"",
                       name(pair.law));
  const bool valued = pair.law == Law::winkler || pair.law == Law::tresca || pair.law == Law::coulomb;
  if (valued != (pair.value && *pair.value))
    return fmt::format("contact.law: '{}' has {}", name(pair.law), valued ? "no value" : "a value, and needs none");
  if ((!valued || pair.law == Law::coulomb) && !pair.lifts_off)
    return fmt::format("contact.law: sides that may not lift off are \"bilateral\", not \"{}\"", name(pair.law));
  if (dim == 3 && pair.jump)
    return "contact.jump: in space no law resists slip; write contact.gap, which is the jump along the normal";
  if (pair.jump && (pair.law == Law::winkler || !is_two_sided(pair)))
    return fmt::format(
        "contact.jump is of sides that keep together, \"bilateral\" or {{ tresca = g, liftoff = false }}; for '{}' "
        "write contact.gap, which is that along the normal",
        name(pair.law));
  if (pair.jump && pair.gap) return "contact.jump says what contact.gap does, and more; leave one of them out";
  if (pair.law == Law::frictionless) return "";
  if (scene.solve.dual == Dual::uzawa)
    return fmt::format(
        "contact.law: Uzawa's iteration knows frictionless contact only; for '{}' write solve.dual = "
        "\"hybrid\"",
        name(pair.law));
  if (dim == 2 && scene.solve.dual == Dual::local && pair.law != Law::bilateral)
    return fmt::format(
        "contact.law: stresses built locally know \"frictionless\" and \"bilateral\" only; for '{}' write solve.dual = "
        "\"hybrid\"",
        name(pair.law));
  if (pair.law == Law::coulomb && scene.solve.degree > 2)
    return fmt::format(
        "contact.law: Coulomb's friction takes its bound from pressures that are linear on each edge, of "
        "solve.degree 1 or 2; it is {}",
        scene.solve.degree);
  if (pair.zones > 0 && is_two_sided(pair))
    return "contact.zones: where the sides cannot lift off there are no zones of contact to find";
  return "";
}

template std::string law_message(const Scene<2>&, const ContactPair<2>&);
template std::string law_message(const Scene<3>&, const ContactPair<3>&);

}  // namespace bracket::scene
