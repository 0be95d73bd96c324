// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

/// What check() and the factories of materials refuse, before it becomes an Error: whoever knows more of the place, as
/// the reader of scene files does, says it.
namespace bracket::scene {

struct Fault {
  std::vector<std::string> key;  ///< of the datum in a scene file, list entries by number: mesh, block, 1, cells
  std::string message;
  std::string where = {};  ///< of what it belongs to (Block::where and so on)
};

/// Of the constants that isotropic() is given; key: E or nu.
template <int dim> std::optional<Fault> isotropic_fault(double young, double poisson, Plane plane);
/// Of the matrix that anisotropic() is given; no key.
template <int dim> std::optional<Fault> anisotropic_fault(const Elasticity<dim>& stiffness);

/// Of the blocks and the mesh file, and of bodies that no block makes.
template <int dim> std::optional<Fault> mesh_fault(const Scene<dim>& scene);
/// Of a body that none of the blocks makes, where there are blocks.
template <int dim> std::optional<Fault> unmade_body(const std::vector<Block<dim>>& blocks, const std::string& body);

/// What is wrong with the law of a contact pair; empty: nothing.
template <int dim> std::string law_message(const Scene<dim>& scene, const ContactPair<dim>& pair);

/// Of quantities, names of contacts, and the goal of refinement.
template <int dim> std::optional<Fault> quantity_fault(const Scene<dim>& scene);

/// The first fault of a scene that needs no mesh to be seen.
template <int dim> std::optional<Fault> fault_of(const Scene<dim>& scene);
/// The same of a scene whose mesh is given: it may have neither blocks nor a mesh file.
template <int dim> std::optional<Fault> fault_beside_mesh(const Scene<dim>& scene);

/// \throw Error (input) with the fault's place and message, if there is one
void throw_if(const std::optional<Fault>& fault);

}  // namespace bracket::scene
