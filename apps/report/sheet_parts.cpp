// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/sheet_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/report/numbers.h"
#include "apps/report/order.h"
#include "apps/report/pairs.h"
#include "apps/report/units.h"
#include "apps/report/words.h"

namespace bracket::apps {
namespace {

std::string counted(std::size_t n, const char* one, const char* many) {
  return n == 1 ? fmt::format("one {}", one) : fmt::format("{} {}", n, many);
}

template <int dim> std::string of_data(const ReportOf<dim>& report) {
  const scene::Oscillation& data = report.outcome.problem.oscillation;
  constexpr double rounding = 1e-13;
  if (std::max({data.traction, data.displacement, data.gap}) < rounding)
    return "changed by nothing: the meshes carry the given functions exactly";
  const double energy = report.outcome.levels.back().oscillation_energy;
  return fmt::format(
      "changed by {:.1e} (tractions), {:.1e} (displacements), {:.1e} (gaps) of their largest values at most; the "
      "energy by {}",
      data.traction, data.displacement, data.gap,
      std::isfinite(energy) ? "about " + rounded_up_exponent(energy) + units_of(report.scene.units, dim).energy +
                                  " (an estimate; what is guaranteed is of the data as fixed)"
                            : "an amount that has no bound");
}

template <int dim> std::string of_geometry(const ReportOf<dim>& report) {
  if (report.scene.curves.empty())
    return fmt::format("the bodies are the {} of the first mesh, which refinement keeps", Words<dim>::cells);
  const std::string last = "the intervals are those of the last mesh's polygon";
  return std::isfinite(report.outcome.moved)
             ? fmt::format("{}; the last halving of its edges moved the middle of the energy's by {}{}", last,
                           rounded_up_exponent(report.outcome.moved), units_of(report.scene.units, dim).energy)
             : last + "; with one mesh nothing is known of what its edges cost";
}

}  // namespace

template <int dim> std::optional<Order> order_of(const ReportOf<dim>& report) {
  const double slope = observed_order(samples_of(report.outcome.levels));
  if (!std::isfinite(slope) || report.outcome.guarantee == "none" || error_is_rounding(report.outcome))
    return std::nullopt;
  return Order{slope, -dim * slope};
}

std::optional<Uncertain> uncertain(double lower, double upper) {
  if (!std::isfinite(lower) || !std::isfinite(upper)) return std::nullopt;
  const double middle = lower + (upper - lower) / 2, half = std::max(upper - middle, middle - lower);
  return Uncertain{middle, half > 0 ? std::nextafter(half, INFINITY) : 0};
}

template <int dim> std::string model(const ReportOf<dim>& report) {
  const scene::Scene<dim>& scene = report.scene;
  std::string text = fmt::format("linear elasticity, small displacements, {}; {}", setting_of(scene),
                                 counted(report.outcome.problem.bodies.size(), "body", "bodies"));
  if (scene.contact.empty()) text += "; no contact";
  std::map<std::string, std::size_t> laws;
  for (const auto& pair : scene.contact) ++laws[law_text(pair)];
  for (const auto& [law, pairs] : laws) text += fmt::format("; contact {}: {}", law, counted(pairs, "pair", "pairs"));
  if (!scene.bonds.empty()) text += fmt::format("; bonded sides: {}", counted(scene.bonds.size(), "pair", "pairs"));
  return text + (scene.units.empty() ? "; units: not told" : "; units " + scene.units);
}

template <int dim> std::string method(const ReportOf<dim>& report) {
  const scene::Scene<dim>& scene = report.scene;
  std::string text = fmt::format(
      "finite elements twice: displacements of degree {}, stresses in equilibrium of degree {}; refinement: {}",
      scene.solve.degree, std::max(1, scene.solve.degree - 1), name(scene.refine.strategy));
  if (report.outcome.status == scene::Status::budget) return text + "; budget spent: " + report.outcome.reason;
  if (report.outcome.status != scene::Status::done) return text;
  return text + (scene.refine.target > 0 ? fmt::format("; the target of {:g} is reached", scene.refine.target) : "");
}

template <int dim> std::string certainty(const ReportOf<dim>& report) {
  if (report.outcome.guarantee == "none") return "none: " + report.outcome.reason;
  const std::string sure =
      "the exact value of the mathematical model lies in each interval marked ●, for sure: discretisation, iteration "
      "and rounding are all inside";
  const std::string step = report.outcome.guarantee == "tresca-step"
                               ? "; but of friction up to the bound of the last step, for Coulomb's law has no energy"
                               : "";
  const std::string sampled = report.outcome.problem.sampled
                                  ? "; but some functions are known at points only, and what they do between is not"
                                  : "";
  return sure + step + sampled;
}

template <int dim> std::vector<Line> costs(const ReportOf<dim>& report) {
  std::vector<Line> lines = {{"data", of_data(report)}, {"geometry", of_geometry(report)}};
  if (const double changed = report.outcome.problem.imbalance; changed > 0)
    lines.push_back(
        {"loads", fmt::format("changed by {} of the largest, so that a body that nothing holds is in balance",
                              rounded_up_exponent(changed))});
  for (const std::string& note : report.outcome.problem.mesh.notes) lines.push_back({"mesh", note});
  return lines;
}

template <int dim> std::vector<Line> outside() {
  return {
      {"validation", "not done: no experiment is compared with, so that nothing is said of the error of the model"},
      {"uncertainty of the input", "not assessed: geometry, moduli, loads, supports and gaps are taken as given"},
      {"model",
       std::string("friction that depends on the path, large displacements and strains, plastic or viscous materials, "
                   "inertia, heat") +
           (dim == 2 ? " and what varies across the plane are not in it" : " are not in it")},
      {"computed numbers (○)", "have no bound of their own; stresses at a point may be further off than their norm"}};
}

#define INSTANTIATE(dim)                                        \
  template std::optional<Order> order_of(const ReportOf<dim>&); \
  template std::string model(const ReportOf<dim>&);             \
  template std::string method(const ReportOf<dim>&);            \
  template std::string certainty(const ReportOf<dim>&);         \
  template std::vector<Line> costs(const ReportOf<dim>&);       \
  template std::vector<Line> outside<dim>();
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE

}  // namespace bracket::apps
