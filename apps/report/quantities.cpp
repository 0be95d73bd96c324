// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/findings.h"
#include "apps/report/lines.h"
#include "apps/report/numbers.h"
#include "apps/report/shares.h"
#include "apps/report/units.h"

namespace bracket::apps {
namespace {

/// A number in all of its digits, "d.ddd…e±xx", cut towards zero or away from it behind so many decimals.
std::string scientific(double value, int decimals, bool away) {
  std::string text = fmt::format("{:.1100e}", std::abs(value));  // a double has no more
  const std::size_t e = text.find('e');
  int exponent = std::stoi(text.substr(e + 1));
  std::string all = text.substr(0, 1) + text.substr(2, e - 2);
  const auto keep = static_cast<std::size_t>(decimals) + 1;
  const bool rest = all.find_first_not_of('0', keep) != std::string::npos;
  all.resize(keep);
  if (rest && away) {
    std::size_t i = keep;
    while (i > 0 && all[i - 1] == '9') all[--i] = '0';
    if (i > 0) {
      ++all[i - 1];
    } else {
      all.insert(0, "1").pop_back();
      ++exponent;
    }
  }
  if (exponent < -4 || exponent > 6) {
    if (keep > 1) all.insert(1, ".");
    return fmt::format("{}{}e{:+03d}", value < 0 ? "-" : "", all, exponent);
  }
  if (exponent < 0) all.insert(0, static_cast<std::size_t>(-exponent), '0');
  const auto whole = static_cast<std::size_t>(std::max(exponent, 0)) + 1;
  if (all.size() < whole) all.append(whole - all.size(), '0');
  if (all.size() > whole) all.insert(whole, ".");
  return (value < 0 ? "-" : "") + all;
}

int exponent_of(double value) {
  const std::string text = fmt::format("{:.17e}", value);
  return std::stoi(text.substr(text.find('e') + 1));
}

/// \param last the place of the last digit, as a power of ten
std::string decimal(double value, int last, bool upward) {
  if (value == 0) return "0";
  const int decimals = exponent_of(value) - last;
  const bool away = upward == (value > 0);
  if (decimals < 0) return away ? fmt::format("{}1e{:+03d}", value < 0 ? "-" : "", last) : "0";
  return scientific(value, decimals, away);
}

std::string half_width(double lower, double upper, const std::string& unit) {
  const double size = std::max(std::abs(lower), std::abs(upper)), width = upper - lower;
  if (lower <= 0 && upper >= 0) return rounded_up_exponent(width / 2) + unit;
  return rounded_up(50 * (width / size)) + " %";
}

}  // namespace

Decimals enclosed_in_decimals(double lower, double upper) {
  const double size = std::max(std::abs(lower), std::abs(upper)), width = upper - lower;
  if (size == 0) return {"0", "0"};
  const int most = exponent_of(size) - 14, fewest = exponent_of(size) - 2;  // fifteen digits; three
  const int last = width > 0 ? std::clamp(exponent_of(width) - 1, most, fewest) : most;
  return {decimal(lower, last, false), decimal(upper, last, true)};
}

std::string interval_text(double lower, double upper, const std::string& unit) {
  if (!std::isfinite(upper)) return fmt::format("at least {}{}", enclosed_in_decimals(lower, lower).lower, unit);
  if (!std::isfinite(lower)) return fmt::format("at most {}{}", enclosed_in_decimals(upper, upper).upper, unit);
  const auto [low, high] = enclosed_in_decimals(lower, upper);
  return low == high ? low + unit : fmt::format("{} … {}{}", low, high, unit);
}

template <int dim> std::string told(const ReportOf<dim>& report, std::size_t quantity) {
  const bounds::QuantityInterval& interval = report.outcome.quantities[quantity];
  const Units units = units_of(report.scene.units, dim);
  const std::string unit = interval.zone >= 0 ? units.force : unit_of(report.scene.quantities[quantity], units);
  const std::string note = interval.weighted ? "   weighted: falls to zero where it meets a support or a contact" : "";
  const bool below = std::isfinite(interval.lower), above = std::isfinite(interval.upper);
  if (!below && !above) return "has no bounds: " + interval.reason;
  const std::string text = interval_text(interval.lower, interval.upper, unit) + note;
  if (!above) return fmt::format("{}   no upper bound: {}", text, interval.reason);
  if (!below) return fmt::format("{}   no lower bound: {}", text, interval.reason);
  return fmt::format("{}   ± {}", text, half_width(interval.lower, interval.upper, unit));
}

template <int dim> std::string told_energy(const ReportOf<dim>& report, double lower, double upper) {
  const std::string unit = units_of(report.scene.units, dim).energy;
  return fmt::format("{}   ± {}", interval_text(lower, upper, unit), half_width(lower, upper, unit));
}

template <int dim> std::string quantity_lines(const ReportOf<dim>& report, std::size_t columns) {
  std::string text;
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i)
    if (const auto& one = report.outcome.quantities[i]; one.zone < 0) {
      text += fmt::format("{} {}  {}\n", mark(Standing::guaranteed), padded(one.name, columns), told(report, i));
      if (const std::string part = share_text(report, i); !part.empty())
        text += fmt::format("  {}  {}\n", padded("", columns), part);
    }
  return text;
}

std::string csv_text(const std::string& text) {
  std::string quoted = text;
  for (std::size_t at = 0; (at = quoted.find('"', at)) != std::string::npos; at += 2) quoted.insert(at, "\"");
  return "\"" + quoted + "\"";
}

template <int dim> std::string quantities_csv(const ReportOf<dim>& report) {
  std::string text = "name,kind,cells,lower,upper,s,seconds\n";
  for (const auto& interval : report.outcome.quantities)
    for (const auto& level : interval.levels)
      text += fmt::format("{},{},{},{},{},{},{}\n", csv_text(interval.name), name(interval.kind), level.cells,
                          level.lower, level.upper, level.s, level.seconds);
  return text;
}

template std::string told(const ReportOf<2>&, std::size_t);
template std::string told_energy(const ReportOf<2>&, double, double);
template std::string quantity_lines(const ReportOf<2>&, std::size_t);
template std::string quantities_csv(const ReportOf<2>&);
template std::string told(const ReportOf<3>&, std::size_t);
template std::string told_energy(const ReportOf<3>&, double, double);
template std::string quantity_lines(const ReportOf<3>&, std::size_t);
template std::string quantities_csv(const ReportOf<3>&);

}  // namespace bracket::apps
