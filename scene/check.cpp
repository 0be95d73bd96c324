// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "scene/fault.h"
#include "scene/fields.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

using Key = std::vector<std::string>;
using Found = std::optional<Fault>;

Key with(Key key, const std::string& last) {
  key.push_back(last);
  return key;
}

Found size_fault(Key key, const std::string& name, double value, const std::string& where) {
  std::string message = size_message(value, name);
  if (message.empty()) return {};
  return Fault{std::move(key), std::move(message), where};
}

// ---- bodies, boundary, contact --------------------------------------------------------------------------------------

template <int dim> Found body_fault(const Scene<dim>& scene) {
  for (const auto& [body_name, body] : scene.bodies) {
    const Key key = {"bodies", body_name};
    const std::string called = "bodies." + body_name;
    const auto& constants = body.material.constants();
    if (dim == 2 && constants && constants->plane != scene.plane) {
      return Fault{key,
                   fmt::format("the material of '{}' is one of plane {}, the scene of plane {}", body_name,
                               name(constants->plane), name(scene.plane)),
                   body.where};
    }
    if (constants) {
      if (Found fault = size_fault(with(key, "E"), called + ".E", constants->young, body.where)) return fault;
    } else {
      for (const double entry : body.material.stiffness().reshaped())
        if (Found fault = size_fault(with(key, "stiffness"), called + ".stiffness", entry, body.where)) return fault;
    }
    for (const double component : body.force)
      if (Found fault = size_fault(with(key, "body_force"), called + ".body_force", component, body.where))
        return fault;
  }
  return {};
}

template <int dim> Found condition_fault(const Scene<dim>& scene) {
  for (const auto& [part, condition] : scene.boundary) {
    const std::string kind = name(condition.kind);
    const Key key = {"boundary", part, kind};
    const bool vector = condition.kind == ConditionKind::fixed || condition.kind == ConditionKind::traction;
    const std::size_t needed = vector ? dim : 1, given = condition.value.size();
    if (given != needed) {
      return Fault{key,
                   fmt::format("boundary.\"{}\".{} must have {} function{}, has {}", part, kind, needed,
                               needed == 1 ? "" : "s", given),
                   condition.where};
    }
    for (const Function<dim>& function : condition.value)
      if (!function)
        return Fault{key, fmt::format("boundary.\"{}\".{} has an empty function", part, kind), condition.where};
  }
  return {};
}

template <int dim> Found obstacle_fault(const Side& side, const Key& key, const std::string& where) {
  const auto fault = [&](const std::string& message) { return Fault{key, "contact.second: " + message, where}; };
  std::vector<double> numbers;
  if (dim == 3 && (side.obstacle.index() == 1 || side.obstacle.index() == 2))
    return fault(
        fmt::format("{} is an obstacle of the plane; in space there are \"rigid\" and {{ plane = {{ point, "
                    "normal }} }}",
                    name(side)));
  if (dim == 2 && side.obstacle.index() == 3)
    return fault("a plane is an obstacle of space; here there are { line } and { circle }");
  if (const auto* line = std::get_if<LineObstacle>(&side.obstacle)) {
    numbers = {line->point[0], line->point[1], line->normal[0], line->normal[1]};
    if (line->normal.isZero(0)) return fault("the normal of the line must not be zero");
  } else if (const auto* round = std::get_if<CircleObstacle>(&side.obstacle)) {
    const auto& [center, radius] = round->circle;
    numbers = {center[0], center[1], radius};
    if (!(radius > 0)) return fault(fmt::format("the radius of the circle must be positive, is {}", radius));
  }
  if (const auto* plane = std::get_if<PlaneObstacle>(&side.obstacle)) {
    numbers.assign(plane->point.begin(), plane->point.end());
    numbers.insert(numbers.end(), plane->normal.begin(), plane->normal.end());
    if (plane->normal.isZero(0)) return fault("the normal of the plane must not be zero");
  }
  for (const double number : numbers)
    if (const std::string message = size_message(number, "a number"); !message.empty()) return fault(message);
  if (!numbers.empty() && !side.parts.empty()) return fault("either boundary parts or an obstacle, not both");
  return {};
}

template <int dim> Found curve_fault(const Scene<dim>& scene) {
  for (const auto& [part, curve] : scene.curves) {
    const Key key = {"curves", part};
    if (dim == 3) return Fault{key, "[curves] are arcs of the plane; in space faces stay flat", curve.where};
    if (!curve.circle) continue;
    const auto& [center, radius] = *curve.circle;
    const std::string name = fmt::format("curves.\"{}\".circle", part);
    for (const double number : {center[0], center[1], radius})
      if (Found fault = size_fault(key, name, number, curve.where)) return fault;
    if (radius <= 0) return Fault{key, fmt::format("{}.radius must be positive, is {}", name, radius), curve.where};
  }
  return {};
}

template <int dim> Found contact_fault(const Scene<dim>& scene) {
  for (std::size_t i = 0; i < scene.contact.size(); ++i) {
    const ContactPair<dim>& pair = scene.contact[i];
    const Key key = {"contact", std::to_string(i)};
    const auto fault = [&](const char* of, const std::string& message) {
      return Fault{of[0] == '\0' ? key : with(key, of), message, pair.where};
    };
    if (pair.gap && !*pair.gap)
      return fault("gap", fmt::format("the gap of '{}' is an empty function", name(pair.first)));
    if (pair.jump && (!(*pair.jump)[0] || !(*pair.jump)[1]))
      return fault("jump", fmt::format("the jump of '{}' has an empty function", name(pair.first)));
    if (const std::string message = law_message(scene, pair); !message.empty()) return fault("law", message);
    const bool crack = !is_wall(pair.second) && pair.first.parts == pair.second.parts;
    if (Found of_obstacle = obstacle_fault<dim>(pair.second, with(key, "second"), pair.where)) return of_obstacle;
    std::set<std::string> own;  // parts of this pair
    for (const auto& [side, of] : {std::pair(&pair.first, "first"), std::pair(&pair.second, "second")}) {
      if (side->parts.empty() && !(side == &pair.second && is_wall(*side)))
        return fault(of, fmt::format("contact.{} must name a boundary part", of));
      if (side == &pair.second && is_wall(*side)) continue;
      for (const std::string& part : side->parts) {
        if (part.empty()) return fault(of, fmt::format("contact.{} must not be empty", of));
        if (part == "rigid")
          return fault(of, side == &pair.first
                               ? "contact.first must be a boundary part; a rigid wall is the second side"
                               : "contact.second is 'rigid' alone or boundary parts, not both");
        if (const auto condition = scene.boundary.find(part); condition != scene.boundary.end()) {
          const auto& [kind, value, where] = condition->second;
          return fault("", fmt::format("the part '{}' is in contact and has a condition of its own ({})", part,
                                       where.empty() ? name(kind) : where));
        }
        if (!own.insert(part).second && !crack)
          return fault(of, fmt::format("the part '{}' is named twice in one contact pair", part));
      }
    }
  }
  return {};
}

template <int dim> Found bond_fault(const Scene<dim>& scene) {
  std::set<std::string> used;  // parts of contact pairs and bonds
  for (const ContactPair<dim>& pair : scene.contact)
    for (const Side* side : {&pair.first, &pair.second}) used.insert(side->parts.begin(), side->parts.end());
  for (std::size_t i = 0; i < scene.bonds.size(); ++i) {
    const Bond& bond = scene.bonds[i];
    for (const auto& [side, of] : {std::pair(&bond.first, "first"), std::pair(&bond.second, "second")}) {
      const auto fault = [&, key = of](const std::string& message) {
        return Fault{{"bond", std::to_string(i), key}, message, bond.where};
      };
      if (is_wall(*side) || contains(*side, "rigid"))
        return fault("a bond has two sides of bodies; what sticks to a wall is a boundary part that is fixed = [0, 0]");
      for (const std::string& part : side->parts) {
        if (scene.boundary.contains(part))
          return fault(fmt::format("the part '{}' is bonded and has a condition of its own", part));
        if (scene.curves.contains(part))
          return fault(fmt::format("the part '{}' is bonded, along the mesh's edges, and cannot follow a curve", part));
        if (!used.insert(part).second)
          return fault(fmt::format("the part '{}' is bonded twice, or in contact too", part));
      }
    }
  }
  return {};
}

// ---- settings -------------------------------------------------------------------------------------------------------

Found degree_fault(int degree) {
  if (1 <= degree && degree <= largest_degree) return {};
  return Fault{{"solve", "degree"}, fmt::format("solve.degree must be from 1 to {}, is {}", largest_degree, degree)};
}

template <int dim> Found settings_fault(const Refine& refine, const Solve& solve) {
  const auto fault = [](const char* key, const char* limits, auto value) {
    return Fault{{"refine", key}, fmt::format("refine.{} must {}, is {}", key, limits, value)};
  };
  for (const auto& [key, value] : {std::pair("target", refine.target), std::pair("bulk", refine.bulk),
                                   std::pair("max_seconds", refine.max_seconds)})
    if (Found out = size_fault({"refine", key}, fmt::format("refine.{}", key), value, "")) return out;
  if (refine.target < 0) return fault("target", "not be negative", refine.target);
  if (refine.bulk <= 0 || refine.bulk > 1) return fault("bulk", "lie in (0, 1]", refine.bulk);
  if (refine.max_levels < 1) return fault("max_levels", "be at least 1", refine.max_levels);
  if (refine.max_cells < 1) return fault("max_cells", "be at least 1", refine.max_cells);
  if (refine.max_seconds < 1) return fault("max_seconds", "be at least 1", refine.max_seconds);
  if (Found wrong = degree_fault(solve.degree)) return wrong;
  if (dim == 3 && solve.degree > 2)
    return Fault{{"solve", "degree"},
                 fmt::format("solve.degree must be 1 or 2 in three dimensions, is {}", solve.degree)};
  if (dim == 3 && solve.dual != Dual::local)
    return Fault{{"solve", "dual"},
                 fmt::format("solve.dual = \"{}\" is for two dimensions; here write \"local\"", name(solve.dual))};
  if (dim == 2 && solve.dual == Dual::local && solve.degree != 2)
    return Fault{
        {"solve", "dual"},
        fmt::format("solve.dual = \"local\" is for displacements of degree 2 in the plane; solve.degree is {}: "
                    "write solve.dual = \"hybrid\"",
                    solve.degree)};
  if (solve.sweeps && solve.dual != Dual::local)
    return Fault{{"solve", "sweeps"},
                 fmt::format("solve.sweeps are those of solve.dual = \"local\", which is \"{}\": leave them out",
                             name(solve.dual))};
  if (solve.sweeps && (*solve.sweeps < 1 || *solve.sweeps > 100))
    return Fault{{"solve", "sweeps"}, fmt::format("solve.sweeps must be from 1 to 100, is {}", *solve.sweeps)};
  if (solve.dual == Dual::uzawa && solve.degree > 2)
    return Fault{{"solve", "dual"},
                 fmt::format("solve.dual = \"uzawa\" has linear stresses, beside displacements of degree 1 or 2; "
                             "solve.degree is {}: write solve.dual = \"hybrid\"",
                             solve.degree)};
  return {};
}

}  // namespace

template <int dim> std::optional<Fault> fault_beside_mesh(const Scene<dim>& scene) {
  for (const auto& find : {body_fault<dim>, condition_fault<dim>, curve_fault<dim>, contact_fault<dim>, bond_fault<dim>,
                           quantity_fault<dim>})
    if (Found fault = find(scene)) return fault;
  Found fault = settings_fault<dim>(scene.refine, scene.solve);
  if (fault) fault->where = scene.file;
  return fault;
}

template <int dim> std::optional<Fault> fault_of(const Scene<dim>& scene) {
  if (Found fault = mesh_fault(scene)) return fault;
  return fault_beside_mesh(scene);
}

void throw_if(const std::optional<Fault>& fault) {
  if (fault) fail(Status::input, fault->where, fault->message);
}

bool is_rigid(const Side& side) { return side.parts == std::vector<std::string>{"rigid"}; }
bool contains(const Side& side, const std::string& part) {
  return std::find(side.parts.begin(), side.parts.end(), part) != side.parts.end();
}
bool is_wall(const Side& side) { return is_rigid(side) || side.obstacle.index() != 0; }
std::string name(const Side& side) {
  if (is_rigid(side)) return "a rigid wall";
  if (std::holds_alternative<LineObstacle>(side.obstacle)) return "a line";
  if (std::holds_alternative<CircleObstacle>(side.obstacle)) return "a circle";
  if (std::holds_alternative<PlaneObstacle>(side.obstacle)) return "a plane";
  return fmt::format("{}", fmt::join(side.parts, ", "));
}

template <int dim> void check(const Scene<dim>& scene) { throw_if(fault_of(scene)); }
template <int dim> void check_settings(const Refine& refine, const Solve& solve) {
  throw_if(settings_fault<dim>(refine, solve));
}
int degree_for(double target, double cells) {
  const bool fine = cells >= 1000;
  if (target == 0 || target > (fine ? 3e-3 : 3e-2)) return 2;
  return target > (fine ? 3e-5 : 3e-4) ? 3 : 4;
}

template <int dim> double cells_of(const Scene<dim>& scene) {
  if (scene.given) return static_cast<double>(scene.given->cells.size());
  double cells = 0;
  for (const Block<dim>& block : scene.blocks) cells += cells_of(block);
  if (!scene.blocks.empty()) return cells;
  try {
    return static_cast<double>(read_mesh<dim>(scene.mesh_file).cells.size());
  } catch (const Error&) {
    return std::numeric_limits<double>::infinity();
  }
}

template <int dim> bool has_coulomb(const Scene<dim>& scene) {
  return std::any_of(scene.contact.begin(), scene.contact.end(),
                     [](const ContactPair<dim>& pair) { return pair.law == Law::coulomb; });
}

int sweeps_for(double flatness) {
  constexpr int most = 8;  // for more, cells of better shape are the better way
  return flatness <= flat ? 1 : std::min(most, static_cast<int>(std::ceil(flatness / 3)));
}

double bulk_for(int degree) { return degree >= 3 ? 0.8 : 0.5; }

void check_degree(int degree) { throw_if(degree_fault(degree)); }

template void check(const Scene<2>&);
template void check(const Scene<3>&);
template void check_settings<2>(const Refine&, const Solve&);
template void check_settings<3>(const Refine&, const Solve&);
template std::optional<Fault> fault_beside_mesh(const Scene<2>&);
template std::optional<Fault> fault_beside_mesh(const Scene<3>&);
template std::optional<Fault> fault_of(const Scene<2>&);
template std::optional<Fault> fault_of(const Scene<3>&);
template double cells_of(const Scene<2>&);
template double cells_of(const Scene<3>&);
template bool has_coulomb(const Scene<2>&);
template bool has_coulomb(const Scene<3>&);

}  // namespace bracket::scene
