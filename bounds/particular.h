// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.h"

namespace bracket::bounds {

/// A stress in balance with the data, λ̄ of HH81 §2 and (3.16)–(3.19), found without a global system by what makes the
/// certificate's loads balance: reactions on as few facets as hold the bodies, handed on from cell to cell. Its contact
/// tractions may be tension (Remark 2.1).
/// \pre balanced()   \throw scene::Error (not_guaranteed) where rounding hides how a body is held
template <int dim> scene::Stress<dim> particular_stress(const scene::Problem<dim>& problem);

}  // namespace bracket::bounds
