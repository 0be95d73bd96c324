// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/numbers.h"
#include "apps/report/shares.h"

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

std::string half_width(const bounds::QuantityInterval& interval) {
  const double width = interval.upper - interval.lower;
  if (std::isfinite(interval.relative_width)) return rounded_up(50 * interval.relative_width) + " %";
  return rounded_up_exponent(width / 2);
}

}  // namespace

Decimals enclosed_in_decimals(double lower, double upper) {
  const double size = std::max(std::abs(lower), std::abs(upper)), width = upper - lower;
  if (size == 0) return {"0", "0"};
  const int most = exponent_of(size) - 16, fewest = exponent_of(size) - 2;  // digits that tell doubles apart; three
  const int last = width > 0 ? std::clamp(exponent_of(width) - 1, most, fewest) : most;
  return {decimal(lower, last, false), decimal(upper, last, true)};
}

std::string told(const bounds::QuantityInterval& interval, const std::string& units) {
  const std::string label = units.empty() ? "" : "   (" + units + ")";
  const std::string note = interval.weighted ? "   weighted: falls to zero where it meets a support or a contact" : "";
  const bool below = std::isfinite(interval.lower), above = std::isfinite(interval.upper);
  if (!below && !above) return "has no bounds: " + interval.reason;
  if (!above)
    return fmt::format("at least {}{}{}   no upper bound: {}",
                       enclosed_in_decimals(interval.lower, interval.lower).lower, label, note, interval.reason);
  if (!below)
    return fmt::format("at most {}{}{}   no lower bound: {}",
                       enclosed_in_decimals(interval.upper, interval.upper).upper, label, note, interval.reason);
  const auto [lower, upper] = enclosed_in_decimals(interval.lower, interval.upper);
  return fmt::format("in [{}, {}]   ± {}{}{}", lower, upper, half_width(interval), label, note);
}

std::string quantity_lines(const Report& report) {
  if (report.outcome.guarantee == "none") return "";
  std::size_t longest = 0;
  for (const auto& interval : report.outcome.quantities)
    if (interval.zone < 0) longest = std::max(longest, interval.name.size());
  std::string text;
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i)
    if (const auto& one = report.outcome.quantities[i]; one.zone < 0)
      text += fmt::format("{:<{}}  {}{}\n", one.name, longest, told(one, report.scene.units), share_text(report, i));
  return text;
}

std::string quantities_csv(const Report& report) {
  std::string text = "name,kind,cells,lower,upper,s,seconds\n";
  for (const auto& interval : report.outcome.quantities) {
    std::string quoted = interval.name;
    for (std::size_t at = 0; (at = quoted.find('"', at)) != std::string::npos; at += 2) quoted.insert(at, "\"");
    for (const auto& level : interval.levels)
      text += fmt::format("\"{}\",{},{},{},{},{},{}\n", quoted, name(interval.kind), level.cells, level.lower,
                          level.upper, level.s, level.seconds);
  }
  return text;
}

}  // namespace bracket::apps
