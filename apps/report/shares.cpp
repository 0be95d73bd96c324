// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/quantities.h"
#include "scene/enclosure.h"

namespace bracket::apps {
namespace {

using bounds::QuantityInterval;
using scene::Enclosure;

template <int dim> bool is_stretch(const ReportOf<dim>& report, std::size_t quantity) {
  if (report.outcome.quantities[quantity].zone >= 0) return true;
  const auto& asked = report.scene.quantities[quantity];
  return is_pressing_force(asked) && asked.stretch;
}

template <int dim> bool is_total(const ReportOf<dim>& report, std::size_t quantity, int contact) {
  const QuantityInterval& one = report.outcome.quantities[quantity];
  if (one.zone >= 0 || one.contact != contact || one.weighted) return false;
  const auto& asked = report.scene.quantities[quantity];
  return is_pressing_force(asked) && !asked.stretch && !asked.weight;
}

/// On an arc each mesh is a problem of its own.
bool on_one_mesh(const QuantityInterval& a, const QuantityInterval& b) {
  return !a.levels.empty() && !b.levels.empty() && a.levels.back().cells == b.levels.back().cells;
}

}  // namespace

Share share(const QuantityInterval& part, const QuantityInterval& total) {
  Share result;
  if (part.lower > 0 && std::isfinite(total.upper))
    result.lower = lower(Enclosure(part.lower) / Enclosure(total.upper));
  if (total.lower > 0 && std::isfinite(part.upper))
    result.upper = std::min(1.0, upper(Enclosure(std::max(0.0, part.upper)) / Enclosure(total.lower)));
  return result;
}

template <int dim> std::optional<Share> share(const ReportOf<dim>& report, std::size_t quantity) {
  const auto& quantities = report.outcome.quantities;
  const QuantityInterval& part = quantities[quantity];
  if (report.outcome.guarantee == "none" || !is_stretch(report, quantity)) return {};
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (!is_total(report, i, part.contact) || !on_one_mesh(part, quantities[i])) continue;
    const Share result = share(part, quantities[i]);
    if (result.lower > 0 || result.upper < 1) return result;
  }
  return {};
}

Share in_percent(const Share& share) {
  const Enclosure hundred(100);
  return {lower(hundred * Enclosure(share.lower)), std::min(upper(hundred * Enclosure(share.upper)), 100.0)};
}

template <int dim> std::string share_text(const ReportOf<dim>& report, std::size_t quantity) {
  const auto known = share(report, quantity);
  if (!known) return "";
  const auto [low, high] = in_percent(*known);
  const auto [from, to] = enclosed_in_decimals(low, high);
  if (known->lower == 0) return fmt::format("of the total at most {} %", to);
  if (known->upper == 1) return fmt::format("of the total at least {} %", from);
  return fmt::format("of the total {} to {} %", from, to);
}

template std::optional<Share> share(const ReportOf<2>&, std::size_t);
template std::string share_text(const ReportOf<2>&, std::size_t);
template std::optional<Share> share(const ReportOf<3>&, std::size_t);
template std::string share_text(const ReportOf<3>&, std::size_t);

}  // namespace bracket::apps
