// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contact/contact.h"
#include "scene/scene.h"

namespace bracket::tests {

/// The stress of least S of the block elements of degree 1, by the global hybrid method over any dimension: what
/// dual::local() is measured by, on few cells. Frictionless or two-sided contact.
template <int dim> struct Hybrid {
  contact::Termination termination;
  scene::Stress<dim> stress;
};
template <int dim> Hybrid<dim> hybrid(const scene::Problem<dim>& problem);

}  // namespace bracket::tests
