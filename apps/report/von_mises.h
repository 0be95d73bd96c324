// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "apps/report/report.h"

namespace bracket::apps {

/// The largest von Mises stress of ½ (σ(u_h) + λ_h), whose error has the least bound, on the bodies whose stress across
/// the plane is known: zero in plane stress, ν (σ_xx + σ_yy) in plane strain, not told by a 3 × 3 stiffness.
struct LargestVonMises {
  double value = -1;  ///< less than 0: it is known of no body
  scene::Vector<2> at = scene::Vector<2>::Zero();
  bool of_all = true;  ///< it is known of all
};
LargestVonMises largest_von_mises(const Report& report);

}  // namespace bracket::apps
