// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/toml/contact.h"

#include <fmt/format.h>

namespace bracket::scene {

namespace {

Circle read_circle(const toml::table& entry, const std::string& name) {
  check_keys(entry, name, {"center", "radius"});
  return {vector<2>(required(entry, name, "center"), name + ".center"),
          number(required(entry, name, "radius"), name + ".radius")};
}

/// { line = { point, normal } } or { circle = { center, radius }, inside }; in space { plane = { point, normal } }.
template <int dim> Side read_obstacle(const toml::table& entry, const std::string& name);

template <> Side read_obstacle<3>(const toml::table& entry, const std::string& name) {
  check_keys(entry, name, {"plane"});
  const std::string of = name + ".plane";
  const toml::table& plane = table(required(entry, name, "plane"), of);
  check_keys(plane, of, {"point", "normal"});
  return PlaneObstacle{vector<3>(required(plane, of, "point"), of + ".point"),
                       vector<3>(required(plane, of, "normal"), of + ".normal")};
}

template <> Side read_obstacle<2>(const toml::table& entry, const std::string& name) {
  check_keys(entry, name, {"line", "circle", "inside"});
  if (const toml::node* node = entry.get("circle")) {
    if (const toml::node* line = entry.get("line")) refuse(*line, name + " is either a line or a circle");
    CircleObstacle round{read_circle(table(*node, name + ".circle"), name + ".circle")};
    if (const toml::node* inside = entry.get("inside")) round.inside = truth(*inside, name + ".inside");
    return round;
  }
  if (const toml::node* inside = entry.get("inside")) refuse(*inside, name + ".inside belongs to a circle");
  const std::string of = name + ".line";
  const toml::table& line = table(required(entry, name, "line"), of);
  check_keys(line, of, {"point", "normal"});
  return LineObstacle{vector<2>(required(line, of, "point"), of + ".point"),
                      vector<2>(required(line, of, "normal"), of + ".normal")};
}

/// A part, a list of parts or, of a second side, an obstacle.
template <int dim> Side read_side(const toml::node& node, const std::string& name, bool second) {
  if (const toml::table* obstacle = node.as_table(); obstacle != nullptr && second)
    return read_obstacle<dim>(*obstacle, name);
  const toml::array* parts = node.as_array();
  if (parts == nullptr) return text(node, name);
  Side side;
  for (const toml::node& part : *parts) side.parts.push_back(text(part, name));
  return side;
}

/// "bilateral", { winkler = k, tension }, { tresca = g, liftoff } or { coulomb = μ }.
template <int dim> void read_law(const toml::node& node, ContactPair<dim>& pair) {
  const toml::table* entry = node.as_table();
  if (entry == nullptr) {
    pair.law = choice<Law>(node, "contact.law");
    if (pair.law == Law::winkler || pair.law == Law::tresca || pair.law == Law::coulomb)
      refuse(node, fmt::format("contact.law = \"{0}\" needs its value: write law = {{ {0} = … }}", name(pair.law)));
    return;
  }
  check_keys(*entry, "contact.law", {"winkler", "tension", "tresca", "liftoff", "coulomb"});
  pair.law = entry->get("coulomb") ? Law::coulomb : entry->get("tresca") ? Law::tresca : Law::winkler;
  for (const auto& [key, law] : {std::pair("winkler", Law::winkler),
                                 {"tension", Law::winkler},
                                 {"tresca", Law::tresca},
                                 {"liftoff", Law::tresca},
                                 {"coulomb", Law::coulomb}})
    if (const toml::node* wrong = entry->get(key); wrong != nullptr && law != pair.law)
      refuse(*wrong, fmt::format("contact.law: '{}' does not belong to '{}'", key, name(pair.law)));
  pair.value = function<dim>(required(*entry, "contact.law", name(pair.law)), "contact.law." + name(pair.law));
  if (const toml::node* tension = entry->get("tension")) pair.lifts_off = !truth(*tension, "contact.law.tension");
  if (const toml::node* liftoff = entry->get("liftoff")) pair.lifts_off = truth(*liftoff, "contact.law.liftoff");
}

}  // namespace

template <int dim> ContactPair<dim> read_contact(const toml::table& entry) {
  check_keys(entry, "[[contact]]", {"first", "second", "law", "gap", "jump", "name", "zones"});
  ContactPair<dim> pair;
  pair.where = where(entry);
  pair.first = read_side<dim>(required(entry, "[[contact]]", "first"), "contact.first", false);
  pair.second = read_side<dim>(required(entry, "[[contact]]", "second"), "contact.second", true);
  if (const toml::node* gap = entry.get("gap"); gap != nullptr && gap->value<std::string>() != "drawn")
    pair.gap = function<dim>(*gap, "contact.gap");
  if (const toml::node* jump = entry.get("jump")) {
    const toml::array& all = list(*jump, "contact.jump", dim);
    pair.jump.emplace();
    for (int i = 0; i < dim; ++i) (*pair.jump)[i] = function<dim>(all[i], "contact.jump");
  }
  if (const toml::node* law = entry.get("law")) read_law(*law, pair);
  if (const toml::node* own = entry.get("name")) pair.name = label(*own, "contact.name");
  if (const toml::node* zones = entry.get("zones")) pair.zones = integer(*zones, "contact.zones");
  return pair;
}
template ContactPair<2> read_contact<2>(const toml::table&);
template ContactPair<3> read_contact<3>(const toml::table&);

bool is_bond(const toml::table& entry) {
  const toml::node* law = entry.get("law");
  return law && law->value<std::string>() == name(Law::bonded);
}

Bond read_bond(const toml::table& entry) {
  if (const toml::node* node = entry.get("jump"))
    refuse(*node,
           "bonded sides are one piece, their displacements one: for a jump between them write law = { tresca = g, "
           "liftoff = false } with a g that they do not slip at");
  for (const char* key : {"gap", "zones", "name"})
    if (const toml::node* node = entry.get(key))
      refuse(*node, fmt::format("bonded sides are one piece: they have no {}; leave contact.{} out", key, key));
  check_keys(entry, "[[contact]]", {"first", "second", "law"});
  return {read_side<2>(required(entry, "[[contact]]", "first"), "contact.first", false),
          read_side<2>(required(entry, "[[contact]]", "second"), "contact.second", false), where(entry)};
}

Curve read_curve(const toml::table& entry, const std::string& part) {
  const std::string name = "curves.\"" + part + "\"";
  check_keys(entry, "[" + name + "]", {"circle"});
  Curve curve;
  curve.where = where(entry);
  const toml::node& circle = required(entry, "[" + name + "]", "circle");
  if (const toml::table* given = circle.as_table())
    curve.circle = read_circle(*given, name + ".circle");
  else if (text(circle, name + ".circle") != "detect")
    refuse(circle, name + ".circle must be { center = [x, y], radius = r } or \"detect\"");
  return curve;
}

}  // namespace bracket::scene
