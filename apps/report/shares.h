// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "apps/report/report.h"

/// Which part of a contact's force its stretches carry.
namespace bracket::apps {

struct Share {
  double lower = 0, upper = 1;  ///< guaranteed
};

/// part / total, of forces of one contact: as pressures are ≥ 0 it is in [0, 1] anyway.
Share share(const bounds::QuantityInterval& part, const bounds::QuantityInterval& total);

/// The share of a force on a stretch, or a zone, where the contact's whole force is asked for as well and both are
/// known on one mesh; else, or where it may be anything, none. \param quantity index into Outcome::quantities
template <int dim> std::optional<Share> share(const ReportOf<dim>& report, std::size_t quantity);

/// The same in percent, rounded outward.
Share in_percent(const Share& share);

/// "of the total 12.31 to 12.35 %", rounded outward; nothing without a share.
template <int dim> std::string share_text(const ReportOf<dim>& report, std::size_t quantity);

}  // namespace bracket::apps
