// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "scene/fault.h"
#include "scene/fields.h"
#include "scene/mesh/topology.h"
#include "scene/problem/fix_gaps.h"
#include "scene/problem/laws.h"
#include "scene/problem/matching.h"
#include "scene/problem/normals.h"
#include "scene/problem/notes.h"
#include "scene/problem/projection.h"
#include "scene/problem/sides.h"
#include "scene/problem/space/face_values.h"
#include "scene/range.h"
#include "scene/text.h"

namespace bracket::scene {

namespace {

template <int dim> std::vector<Body<dim>> bodies_of(const Scene<dim>& scene, const Mesh<dim>& mesh) {
  std::vector<std::string> given;
  for (const auto& [name, body] : scene.bodies) {
    given.push_back(name);
    if (std::find(mesh.bodies.begin(), mesh.bodies.end(), name) == mesh.bodies.end()) {
      fail(Status::input, body.where,
           fmt::format("the mesh has no body '{}': {}", name, suggestion(name, mesh.bodies)));
    }
  }
  std::vector<Body<dim>> bodies;
  for (const std::string& name : mesh.bodies) {
    const auto body = scene.bodies.find(name);
    if (body == scene.bodies.end()) {
      fail(Status::input, scene.file,
           fmt::format("the mesh has a body '{0}', but [bodies.{0}] is missing; the scene has: {1}", name,
                       fmt::join(given, ", ")));
    }
    bodies.push_back(body->second);
  }
  return bodies;
}

/// The condition of each part, null: none.
template <int dim> std::vector<const Condition<dim>*> conditions_of(const Scene<dim>& scene, const Mesh<dim>& mesh) {
  std::vector<const Condition<dim>*> conditions(mesh.parts.size(), nullptr);
  for (const auto& [name, condition] : scene.boundary) {
    conditions[part_named(mesh, name, condition.where)] = &condition;
  }
  return conditions;
}

template <int dim> struct FixedFacets {
  std::vector<FacetData<dim>> facets;
  Extent traction, displacement;
};

/// Of each facet, whether it slides or touches.
template <int dim>
std::vector<char> directed(const Mesh<dim>& mesh, const std::vector<const Condition<dim>*>& conditions,
                           const std::vector<ContactFacetOf<dim>>& contact) {
  std::vector<char> result(mesh.boundary.size(), 0);
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet) {
    const int part = mesh.boundary[facet].part;
    result[facet] = part != -1 && conditions[part] != nullptr && conditions[part]->kind == ConditionKind::sliding;
  }
  for (const ContactFacetOf<dim>& pair : contact) {
    result[pair.first] = 1;
    if (pair.second != -1) result[pair.second] = 1;
  }
  return result;
}

/// Writes a load's component, or the pressure, to a facet.
void set_load(const EdgeLoad& load, ConditionKind kind, std::size_t component, FacetData<2>& data) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& [linear, higher] = load.value;
    (kind == ConditionKind::pressure ? data.pressure[i] : data.traction[i][component]) = linear[i];
    (kind == ConditionKind::pressure ? data.higher_pressure[i] : data.higher_traction[i][component]) = higher[i];
  }
}

void fix_load(const Scene<2>& scene, const std::array<Vector<2>, 2>& x, const Condition<2>& condition, std::size_t i,
              FacetData<2>& data, Extent& extent) {
  const EdgeLoad values = project(condition.value[i], x[0], x[1], stress_degree(scene.solve.degree), condition.where);
  extent.include(values);
  set_load(values, condition.kind, i, data);
}
void fix_load(const Scene<3>&, const Face& x, const Condition<3>& condition, std::size_t i, FacetData<3>& data,
              Extent& extent) {
  const FacetValues<3> values = project(condition.value[i], x, condition.where);
  extent.include(values);
  for (std::size_t k = 0; k < 3; ++k)
    (condition.kind == ConditionKind::pressure ? data.pressure[k] : data.traction[k][i]) = values.value[k];
}

FacetValues<2> interpolated(const std::array<Vector<2>, 2>& x, const Function<2>& given, const std::string& where) {
  return interpolate_linear(given, x[0], x[1], where);
}
FacetValues<3> interpolated(const Face& x, const Function<3>& given, const std::string& where) {
  return interpolate_linear(given, x, where);
}

template <int dim>
FixedFacets<dim> fix_facets(const Scene<dim>& scene, const Mesh<dim>& mesh,
                            const std::vector<const Condition<dim>*>& conditions,
                            const std::vector<ContactFacetOf<dim>>& contact) {
  FixedFacets<dim> fixed;
  fixed.facets.resize(mesh.boundary.size());
  std::vector<Vector<dim>> normals = shared_normals(mesh, directed(mesh, conditions, contact));
  normals = with_directions_of_contact(scene, std::move(normals), contact);
  for (std::size_t facet = 0; facet < mesh.boundary.size(); ++facet) {
    const auto& [vertices, cell, local, edge, part] = mesh.boundary[facet];
    FacetData<dim>& data = fixed.facets[facet];
    data.normal = normals[facet];
    if (part == -1 || conditions[part] == nullptr) continue;
    const Condition<dim>& condition = *conditions[part];
    const auto x = positions(mesh, vertices);
    if (condition.kind == ConditionKind::fixed) data.support = Support::fixed;
    if (condition.kind == ConditionKind::sliding) data.support = Support::sliding;
    const bool load = data.support == Support::traction;
    for (std::size_t i = 0; i < condition.value.size(); ++i) {
      if (load) {
        fix_load(scene, x, condition, i, data, fixed.traction);
        continue;
      }
      const FacetValues<dim> values = interpolated(x, condition.value[i], condition.where);
      fixed.displacement.include(values);
      for (std::size_t end = 0; end < dim; ++end)
        (condition.kind == ConditionKind::fixed ? data.displacement[end][i] : data.normal_displacement[end]) =
            values.value[end];
    }
  }
  return fixed;
}

template <int dim> bool samples(const Scene<dim>& scene) {
  const auto sampled = [](const Function<dim>& f) { return !f.is_enclosed(); };
  return std::any_of(scene.boundary.begin(), scene.boundary.end(),
                     [&](const auto& part) {
                       return std::any_of(part.second.value.begin(), part.second.value.end(), sampled);
                     }) ||
         std::any_of(scene.contact.begin(), scene.contact.end(), [&](const auto& pair) {
           return (pair.gap && sampled(*pair.gap)) || (pair.value && sampled(*pair.value)) ||
                  (pair.jump && (sampled((*pair.jump)[0]) || sampled((*pair.jump)[1])));
         });
}

template <int dim> double bounding_box_diagonal(const Mesh<dim>& mesh) {
  Eigen::AlignedBox<double, dim> box;
  for (const Vector<dim>& vertex : mesh.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

/// A mesh of one's own may have sides that the scene means to be bonded, and are not.
template <int dim> void check_joined(const Scene<dim>& scene, const Mesh<dim>& mesh) {
  for (const Bond& bond : scene.bonds)
    for (const auto& facet : mesh.boundary)
      if (facet.part >= 0 &&
          (contains(bond.first, mesh.parts[facet.part]) || contains(bond.second, mesh.parts[facet.part])))
        fail(Status::mesh, bond.where,
             fmt::format(
                 "'{}' is bonded in the scene, and lies on the boundary of this mesh; build_mesh() joins the sides",
                 mesh.parts[facet.part]));
}

}  // namespace

template <int dim> std::vector<int> contacts_by_first(const Problem<dim>& problem) {
  std::vector<int> contacts(problem.facets.size(), -1);
  for (std::size_t i = 0; i < problem.contact.size(); ++i) contacts[problem.contact[i].first] = static_cast<int>(i);
  return contacts;
}

template <int dim> Problem<dim> fix_data(const Scene<dim>& scene, Mesh<dim> mesh) {
  throw_if(fault_beside_mesh(scene));
  check_joined(scene, mesh);
  Problem<dim> problem;
  problem.bodies = bodies_of(scene, mesh);
  const std::vector<const Condition<dim>*> conditions = conditions_of(scene, mesh);
  InContact<dim> sides = in_contact(scene, std::move(mesh));
  problem.contact = std::move(sides.contact);
  problem.mesh = with_sides_joined(std::move(sides.mesh), problem.contact);
  if constexpr (dim == 3)
    problem.mesh.refinement_edge = longest_edges(problem.mesh);  // alike on both sides of a contact
  problem.length_scale = bounding_box_diagonal(problem.mesh);

  FixedFacets<dim> fixed = fix_facets(scene, problem.mesh, conditions, problem.contact);
  problem.facets = with_agreement(problem.mesh, std::move(fixed.facets), conditions, fixed.displacement.largest);
  for (const ContactFacetOf<dim>& facet : problem.contact) {
    problem.facets[facet.first].support = Support::contact;
    if (facet.second != -1) problem.facets[facet.second].support = Support::contact;
  }
  problem.contact = with_laws(scene, problem.mesh, std::move(problem.contact));
  const Extent gap = fix_gaps(scene, problem);
  problem.sampled = samples(scene);
  for (std::string& note : notes_on_lines(scene, problem)) problem.mesh.notes.push_back(std::move(note));
  check_size(problem.length_scale, scene.file, "the diameter of the mesh");
  check_size(fixed.traction.largest, scene.file, "the largest traction");
  check_size(fixed.displacement.largest, scene.file, "the largest prescribed displacement");
  check_size(gap.largest, scene.file, "the largest gap");
  problem.oscillation = {fixed.traction.relative(), fixed.displacement.relative(), gap.relative()};
  return problem;
}

template std::vector<int> contacts_by_first(const Problem<2>&);
template std::vector<int> contacts_by_first(const Problem<3>&);
template Problem<2> fix_data(const Scene<2>&, Mesh<2>);
template Problem<3> fix_data(const Scene<3>&, Mesh<3>);

}  // namespace bracket::scene
