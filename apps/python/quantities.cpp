// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <variant>

#include "apps/python/functions.h"
#include "apps/python/options.h"
#include "apps/python/scene.h"

namespace bracket::python {

namespace {

template <int dim> using Direction = std::optional<std::variant<Components<dim>, std::string>>;

/// What quantities have in the plane and in space.
template <int dim>
scene::Quantity<dim> quantity_of(const std::string& name, const std::string& kind, const std::string& of,
                                 const Direction<dim>& direction, const std::optional<std::string>& component,
                                 const py::object& weight, double target, double absolute) {
  scene::Quantity<dim> quantity;
  quantity.name = name;
  quantity.kind = option_of<scene::QuantityKind>(kind, "kind");
  quantity.of = of;
  using enum scene::QuantityKind;
  const bool turns = dim == 3 && quantity.kind == rotation;
  const bool directed = quantity.kind == displacement || quantity.kind == body || quantity.kind == reaction || turns;
  const std::string* word = direction ? std::get_if<std::string>(&*direction) : nullptr;
  if (directed != direction.has_value() || (word != nullptr && (*word != "normal" || turns)))
    throw py::value_error(either<dim>(
        "a direction, (x, y) or \"normal\", belongs to a displacement, a body or a reaction, which need one",
        "a direction, (x, y, z) or, but for rotations, \"normal\", belongs to a displacement, a body, a reaction or a "
        "rotation, which need one"));
  if (direction && word == nullptr) quantity.direction = vector_of<dim>(std::get<Components<dim>>(*direction));
  if (component.has_value() != (quantity.kind == stress) && !(component && quantity.kind == force))
    throw py::value_error(either<dim>(
        "a component belongs to a stress, which needs one (xx, yy, xy or mean), or a force (normal or shear)",
        "a component belongs to a stress, which needs one (xx, yy, zz, yz, xz, xy or mean)"));
  if (component && quantity.kind == force)
    quantity.of_force = option_of<scene::ForceComponent>(*component, "component");
  else if (component)
    quantity.component = option_of<scene::StressComponent>(*component, "component");
  if (!weight.is_none()) quantity.weight = function_of<dim>(weight, "weight");
  quantity.target = target;
  quantity.absolute = absolute;
  return quantity;
}

}  // namespace

void add_quantities(py::class_<scene::Scene<2>>& scene) {
  const auto none = py::none();
  scene.def(
      "add_quantity",
      [](scene::Scene<2>& self, const std::string& name, const std::string& kind, const std::string& of,
         const Direction<2>& direction, const std::optional<std::string>& component,
         const std::optional<Components<2>>& stretch, const py::object& weight, double target, double absolute) {
        auto quantity = quantity_of<2>(name, kind, of, direction, component, weight, target, absolute);
        if (stretch) quantity.stretch = scene::LineStretch{(*stretch)[0], (*stretch)[1]};
        self.quantities.push_back(std::move(quantity));
      },
      py::arg("name"), py::arg("kind"), py::arg("of") = "", py::kw_only(), py::arg("direction") = none,
      py::arg("component") = none, py::arg("stretch") = none, py::arg("weight") = none, py::arg("target") = 0.0,
      py::arg("absolute") = 0.0,
      "An interval for what you ask.\n\n"
      "kind, of: \"displacement\", \"rotation\" or \"reaction\" of a boundary part; \"body\", its mean\n"
      "displacement, or \"stress\", its mean, of a body; \"force\", \"opening\" or \"slip\" of a contact, by its\n"
      "name or its first part; \"energy\". direction: (x, y) or \"normal\", of displacement, body and reaction.\n"
      "component: \"xx\", \"yy\", \"xy\" or \"mean\", of stress; \"shear\", of force. stretch: (from, to) by arc "
      "length, or weight:\n"
      "a function, of force and opening. target, absolute: width to reach, relative or in the quantity's units.");
}

void add_quantities(py::class_<scene::Scene<3>>& scene) {
  const auto none = py::none();
  scene.def(
      "add_quantity",
      [](scene::Scene<3>& self, const std::string& name, const std::string& kind, const std::string& of,
         const Direction<3>& direction, const std::optional<std::string>& component, const py::object& weight,
         double target, double absolute) {
        self.quantities.push_back(quantity_of<3>(name, kind, of, direction, component, weight, target, absolute));
      },
      py::arg("name"), py::arg("kind"), py::arg("of") = "", py::kw_only(), py::arg("direction") = none,
      py::arg("component") = none, py::arg("weight") = none, py::arg("target") = 0.0, py::arg("absolute") = 0.0,
      "An interval for what you ask.\n\n"
      "kind, of: \"displacement\", \"rotation\" or \"reaction\" of a boundary part; \"body\", its mean\n"
      "displacement, or \"stress\", its mean, of a body; \"force\" or \"opening\" of a contact, by its name or its\n"
      "first part; \"energy\". direction: (x, y, z) or \"normal\", of displacement, body and reaction; the axis of a\n"
      "rotation. component: \"xx\", \"yy\", \"zz\", \"yz\", \"xz\", \"xy\" or \"mean\", of stress. weight: a function, "
      "of\n"
      "force and opening. target, absolute: width to reach, relative or in the quantity's units.");
}

}  // namespace bracket::python
