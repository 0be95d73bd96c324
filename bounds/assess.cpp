// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "bounds/assess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "bounds/certificate/given_field.h"
#include "bounds/coulomb.h"
#include "bounds/level.h"
#include "bounds/quantities/evaluate.h"
#include "contact/clock.h"

namespace bracket::bounds {

namespace {

using scene::Enclosure;

/// How much better m is to be than u_x (docs/other-programs.md).
constexpr double wanted_share = 0.05;

/// The roots of an interval of squares.
ErrorInterval roots(const Enclosure& least, const Enclosure& most) {
  const double low = lower(least), high = upper(most);
  ErrorInterval result;
  if (low > 0) result.lower = lower(root(Enclosure(low)));
  if (high > 0 && std::isfinite(high)) result.upper = upper(root(Enclosure(high)));
  if (high <= 0) result.upper = 0;
  return result;
}

ErrorInterval intersection(const ErrorInterval& a, const ErrorInterval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

/// An interval of norms for what is at most `radius` away.
ErrorInterval widened(double low, double high, double radius) {
  ErrorInterval result{std::max(0.0, lower(Enclosure(low) - Enclosure(radius)))};
  if (std::isfinite(high)) result.upper = upper(Enclosure(high) + Enclosure(radius));
  return result;
}

/// The least value of a quadratic on a segment.
double least_of(double a, double b, double c) {
  const double least = std::min(a, c), t = (a - b) / (a - 2 * b + c);
  return t > 0 && t < 1 ? std::min(least, (1 - t) * ((1 - t) * a + 2 * t * b) + t * t * c) : least;
}

/// The largest −ψ of a quadratic with these Bernstein coefficients.
double largest_below_zero(const std::array<double, 3>& psi) { return std::max(0.0, -least_of(psi[0], psi[1], psi[2])); }
double largest_below_zero(const std::array<double, 6>& psi) {
  double least = std::numeric_limits<double>::infinity();
  for (int e = 0; e < 3; ++e) {
    const auto& [i, k] = scene::Simplex<2>::edges[e];
    least = std::min(least, least_of(psi[i], psi[3 + e], psi[k]));
  }
  // Inside, where the slopes from corner 0 along s = φ_1 and t = φ_2 vanish: ψ = ψ_0 + 2 b·(s, t) + (s, t)·A (s, t).
  const auto& [p0, p1, p2, p12, p20, p01] = psi;
  const double a = p1 - 2 * p01 + p0, b = p12 - p01 - p20 + p0, c = p2 - 2 * p20 + p0, x = p01 - p0, y = p20 - p0;
  const double s = (b * y - c * x) / (a * c - b * b), t = (b * x - a * y) / (a * c - b * b);
  if (s > 0 && t > 0 && s + t < 1) least = std::min(least, p0 + x * s + y * t);
  return std::max(0.0, -least);
}

}  // namespace

/// What is carried from level to level.
template <int dim> struct FieldJudge {
  const scene::Scene<dim>& scene;
  const scene::Displacement<dim>& given;
  GivenEnergyOf<dim> energy;
  Functionals<dim> contact_work;  ///< J = −∫ p ψ_x, ψ_x = g − r(u_x)
  Learned learned = {};
};

namespace {

/// What solves perturbed problems on the mesh of an outcome.
template <int dim> Solvers<dim> solvers_of(const scene::Scene<dim>& scene, const Outcome<dim>& outcome) {
  auto displacements = std::make_shared<const primal::Solver<dim>>(outcome.problem, scene.solve.degree, true);
  if constexpr (dim == 2)
    return {std::move(displacements), std::make_shared<const dual::Solver<2>>(outcome.problem, outcome.stress.degree),
            nullptr};
  if constexpr (dim == 3) {
    auto stresses = std::make_shared<const LocalStresses<3>>(*displacements, outcome.problem,
                                                             sweeps_of(scene, outcome.problem.mesh), true);
    return {std::move(displacements), nullptr, std::move(stresses)};
  }
}

/// Bounds of J on a solved level.
template <int dim> ErrorInterval contact_work(FieldJudge<dim>& judge, const Outcome<dim>& outcome) {
  const auto is_zero = [](const auto& psi) { return psi == scene::FacetQuadratic<dim>{}; };
  if (std::ranges::all_of(judge.energy.below, is_zero) && std::ranges::all_of(judge.energy.above, is_zero))
    return {0, 0};  // also without contact
  const Certificate& sure = outcome.levels.back().certificate;
  const SolvedLevel<dim> level{outcome.problem,  solvers_of(judge.scene, outcome), {}, sure.lower, sure.upper,
                               outcome.indicator};
  auto found = evaluate(judge.contact_work, level, Undetermined{}, std::move(judge.learned));
  judge.learned = std::move(found.learned);
  ErrorInterval result{found.level.lower, found.level.upper};
  const auto open = [](const auto& psi) { return std::ranges::all_of(psi, [](double c) { return c >= 0; }); };
  if (std::ranges::all_of(judge.energy.below, open)) result.upper = std::min(result.upper, 0.0);
  return result;
}

template <int dim> ErrorInterval by_energy(FieldJudge<dim>& judge, const Outcome<dim>& outcome) {
  const ErrorInterval work = contact_work(judge, outcome);
  if (!std::isfinite(work.lower) || !std::isfinite(work.upper)) return {};
  const Enclosure two(2), none(0), most(judge.energy.upper);
  const bool is_equality = std::isfinite(judge.energy.lower);
  const Enclosure least =
      is_equality ? two * ((Enclosure(judge.energy.lower) - Enclosure(outcome.upper)) + Enclosure(work.lower)) : none;
  const ErrorInterval of_supported = roots(least, two * ((most - Enclosure(outcome.lower)) + Enclosure(work.upper)));
  return widened(of_supported.lower, of_supported.upper, judge.energy.moved);
}

/// Whether quantities as dear as solving are due: as those of a run.
bool is_due(const std::vector<AssessedLevel>& levels, int cells) {
  const auto known = std::find_if(levels.rbegin(), levels.rend(), [](const AssessedLevel& level) {
    return level.by_energy.lower > 0 || std::isfinite(level.by_energy.upper);
  });
  return known == levels.rend() || cells >= 4 * known->cells;
}

bool is_settled(const std::vector<AssessedLevel>& levels) {
  const AssessedLevel& last = levels.back();
  if (last.stress_error <= wanted_share * last.by_stress.lower) return true;
  if (levels.size() < 3) return false;
  const double before = levels[levels.size() - 3].stress_error;
  return std::min(levels[levels.size() - 2].stress_error, last.stress_error) >= before;
}

template <int dim> AssessmentOf<dim> with_intervals(AssessmentOf<dim> result) {
  result.error = {};
  for (const AssessedLevel& level : result.levels)
    result.error = intersection(result.error, intersection(level.by_stress, level.by_energy));
  const AssessedLevel& last = result.levels.back();
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  result.relative = {unknown, unknown};
  if (last.norm_lower > 0)
    result.relative = {lower(Enclosure(result.error.lower) / Enclosure(last.norm_upper)),
                       upper(Enclosure(result.error.upper) / Enclosure(last.norm_lower))};
  return result;
}

/// What is known of u_x before anything is solved.
template <int dim> AssessmentOf<dim> begun(scene::FieldOnSceneOf<dim> field, const GivenEnergyOf<dim>& energy) {
  AssessmentOf<dim> result;
  result.field = std::move(field);
  for (const auto& u : result.field.given.displacement.vertex) result.largest = std::max(result.largest, u.norm());
  for (const auto& u : result.field.given.displacement.edge) result.largest = std::max(result.largest, u.norm());
  result.misfit = energy.misfit;
  for (const auto& psi : energy.below) result.penetration = std::max(result.penetration, largest_below_zero(psi));
  return result;
}

/// How the run that u_x was judged by has ended. \param why, where that is not what the run says
template <int dim>
AssessmentOf<dim> ended(AssessmentOf<dim> result, const scene::Refine& refine, const Outcome<dim>& outcome,
                        bool settled, std::string why) {
  result.guarantee = outcome.guarantee;
  if (result.error.lower > result.error.upper) {
    result.guarantee = "none";
    result.reason =
        "the bounds of the error exclude each other: a fault of this program; please report it with the "
        "scene and the displacement";
  } else if (result.guarantee == "none") {
    result.reason = outcome.reason;
  }
  if (result.guarantee == "none") {
    result.status = scene::Status::not_guaranteed;
    result.error = result.relative = {};
    return result;
  }
  if (settled || outcome.unstrained) return result;
  const AssessedLevel& last = result.levels.back();
  result.status = scene::Status::budget;
  if (why.empty()) why = outcome.reason.substr(0, outcome.reason.find(';'));
  if (why.empty())
    why = refine.strategy == scene::Strategy::none ? "the mesh is not refined (strategy \"none\")"
                                                   : "the budget of [refine] is spent";
  result.reason = fmt::format(
      "{} on {} cells; Bracket's own stresses, with an error of up to {:.2g}, are not {:g} times "
      "as good as the displacement, with one of at least {:.2g}",
      why, last.cells, last.stress_error, 1 / wanted_share, last.by_stress.lower);
  return result;
}

template <int dim> scene::Scene<dim> with_settings(scene::Scene<dim> scene) {
  scene.quantities.clear();
  for (auto& pair : scene.contact) pair.zones = 0;
  scene.refine.target = 0;
  scene.refine.goal.clear();
  scene.solve.degree = 2;
  return scene;
}

}  // namespace

template <int dim>
AssessmentOf<dim> assess(const scene::Scene<dim>& asked, scene::FieldOnSceneOf<dim> field,
                         const Observer<dim>& observer) {
  const contact::BlasThreads threads(blas_threads<dim>());
  const scene::Scene<dim> scene = with_settings(asked);
  if (has_coulomb(field.problem))
    throw scene::Error(
        scene::Status::input,
        "assess: Coulomb's friction is no minimum of an energy, and no distance to its solution is known; "
        "with a given bound of the shear it is: law = { tresca = g }");
  field.problem = balanced(std::move(field.problem), scene.solve.degree);
  const GivenEnergyOf<dim> energy = certify_given(field.problem, field.given.displacement);
  if (!energy.valid) throw scene::Error(scene::Status::not_guaranteed, energy.reason);
  AssessmentOf<dim> result = begun(std::move(field), energy);
  FieldJudge<dim> judge{scene, result.field.given.displacement, energy,
                        contact_work_functionals(result.field.problem, energy.below, energy.above)};

  std::stop_source done;
  const std::stop_callback passed_on(observer.stop, [&] { done.request_stop(); });
  bool settled = false;
  std::string uncertain;
  const auto with_energy = [&](const Outcome<dim>& outcome) {
    const Clock clock;
    if (observer.stage) observer.stage("the work of the contact");
    result.levels.back().by_energy = by_energy(judge, outcome);
    result.levels.back().seconds += clock.seconds();
  };
  const auto level = [&](const Outcome<dim>& outcome) {
    const Clock clock;
    if (observer.stage) observer.stage("the displacement's error");
    const GivenDistance distance = certify_distance(outcome.problem, outcome.displacement, outcome.stress, judge.given);
    if (!distance.valid) {
      uncertain = distance.reason;
      done.request_stop();
      return;
    }
    if (outcome.levels.size() == 1)
      result.data_energy = data_effect(scene, outcome.problem, outcome.displacement, outcome.stress).energy;
    result.cell = distance.cell;
    const int cells = outcome.levels.back().cells;
    const bool due = is_due(result.levels, cells);
    result.levels.push_back({cells,
                             widened(distance.lower, distance.upper, distance.stress_error),
                             {},
                             distance.stress_error,
                             distance.norm_lower,
                             distance.norm_upper,
                             clock.seconds()});
    if (due) with_energy(outcome);
    settled = is_settled(result.levels);
    if (settled) done.request_stop();
    if (observer.level) observer.level(outcome);
  };
  const Outcome<dim> outcome = run(scene, result.field.problem, {observer.stage, level, done.get_token()});
  if (result.levels.empty())
    throw scene::Error(outcome.status == scene::Status::done ? scene::Status::not_guaranteed : outcome.status,
                       uncertain.empty() ? outcome.reason : uncertain);
  const bool known = std::isfinite(result.levels.back().by_energy.upper);
  if (outcome.guarantee != "none" && !known && uncertain.empty()) try {
      with_energy(outcome);
    } catch (const std::bad_alloc&) {  // the interval is longer without
    }
  return ended(with_intervals(std::move(result)), scene.refine, outcome, settled,
               observer.stop.stop_requested() ? "stopped on request" : uncertain);
}

template AssessmentOf<2> assess(const scene::Scene<2>&, scene::FieldOnSceneOf<2>, const Observer<2>&);
template AssessmentOf<3> assess(const scene::Scene<3>&, scene::FieldOnSceneOf<3>, const Observer<3>&);

}  // namespace bracket::bounds
