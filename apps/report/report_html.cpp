// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <bracket/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "apps/report/columns.h"
#include "apps/report/findings.h"
#include "apps/report/html.h"
#include "apps/report/numbers.h"
#include "apps/report/quantities.h"
#include "apps/report/report.h"
#include "apps/report/shares.h"
#include "apps/report/units.h"
#include "apps/report/words.h"

namespace bracket::apps {
namespace {

using Rows = std::vector<std::vector<std::string>>;

// The digits that both bounds share are known; the others are not.
std::string bound(const std::string& own, const std::string& other) {
  const auto differ = std::mismatch(own.begin(), own.end(), other.begin(), other.end()).first;
  return fmt::format("<b>{}</b><span class=\"open\">{}</span>", std::string(own.begin(), differ),
                     std::string(differ, own.end()));
}

template <int dim> std::string ending(const ReportOf<dim>& report) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  if (outcome.status == scene::Status::budget) return "budget spent: " + escaped(outcome.reason);
  return report.scene.refine.target > 0 ? fmt::format("the target of {:g} is reached", report.scene.refine.target)
                                        : "done; no target was asked";
}

template <int dim> std::string answer(const ReportOf<dim>& report) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  if (outcome.guarantee == "none")
    return "<section class=\"answer none\"><p><b>No guaranteed bounds:</b> " + escaped(outcome.reason) +
           ". The plain values of this run are in report.json.</p></section>\n";
  const Decimals energy = enclosed_in_decimals(outcome.lower, outcome.upper);
  const std::string unit = escaped(units_of(report.scene.units, dim).energy);
  return fmt::format(
      "<section class=\"answer\">\n<dl class=\"bounds\"><dt>guaranteed relative error</dt><dd><b>{}</b></dd>"
      "<dt>energy at least</dt><dd>{}{}</dd><dt>energy at most</dt><dd>{}{}</dd></dl>\n"
      "<div class=\"facts\"><div>of both fields, in the energy norm</div><div>relative width of the energy <b>{}</b>"
      "</div><div>{} cells after {} level{}</div><div>{}</div></div>\n</section>\n",
      percent(outcome.relative_error_bound), bound(energy.lower, energy.upper), unit, bound(energy.upper, energy.lower),
      unit, rounded_up_exponent(relative_width(outcome)), outcome.levels.back().cells, outcome.levels.size(),
      outcome.levels.size() == 1 ? "" : "s", ending(report));
}

template <int dim> std::string quantities(const ReportOf<dim>& report) {
  Rows rows;
  for (std::size_t i = 0; i < report.outcome.quantities.size(); ++i) {
    const bounds::QuantityInterval& one = report.outcome.quantities[i];
    const std::string part = share_text(report, i);
    rows.push_back({escaped(one.name), escaped(told(report, i) + (part.empty() ? "" : ", " + part)),
                    std::to_string(one.levels.empty() ? 0 : one.levels.back().cells)});
  }
  return rows.empty()
             ? ""
             : "<h2>Quantities, between guaranteed bounds</h2>\n" +
                   html_table({"quantity", "interval", "cells"}, rows, 2,
                              "The exact value lies in the interval; cells: of the last mesh it was computed on");
}

template <int dim> std::string scope(const ReportOf<dim>& report) {
  const scene::Oscillation& data = report.outcome.problem.oscillation;
  const double moved = std::max({data.traction, data.displacement, data.gap});
  const bool exact = moved < 1e-13;
  const std::string sampled = report.outcome.guarantee != "none" && report.outcome.problem.sampled
                                  ? "<li>Some functions are known at points only; what they do between those is not "
                                    "seen.</li>\n"
                                  : "";
  const std::string step =
      report.outcome.guarantee != "tresca-step"
          ? ""
          : fmt::format(
                "<li>Coulomb's friction has no energy: all bounds hold for friction up to a given shear, &mu; "
                "times the pressure of the step before. The residual of Coulomb's law is {}, after {} steps.</li>\n",
                rounded_up(report.outcome.levels.back().friction.residual),
                report.outcome.levels.back().friction.steps);
  const std::string fixed_data =
      exact ? "<li>The given functions are carried exactly by the mesh.</li>\n"
            : fmt::format(
                  "<li>The bounds hold for the given functions as they are fixed on the {} of the first mesh, "
                  "which moved tractions by {:.1e}, displacements by {:.1e} and gaps by {:.1e} of their largest "
                  "values at most, and the energy by about {:.1e}.</li>\n",
                  Words<dim>::facets, data.traction, data.displacement, data.gap,
                  report.outcome.levels.back().oscillation_energy);
  return fmt::format(
      "<h2>What this says, and what it does not</h2>\n<div class=\"scope\"><div><h3>Guaranteed</h3><ul>\n"
      "<li>The potential energy of the exact elastic solution, for gaps as they are written and for loads and "
      "displacements as the first mesh carries them, lies between the two bounds. The upper one is the energy of "
      "displacements that keep supports and contact everywhere; the lower "
      "one is minus the complementary energy of stresses in exact equilibrium that never pull across the "
      "contact.</li>\n"
      "<li>Displacements and stresses are each within {} of the exact ones in the energy norm, {} of its size: the "
      "square root of twice the width, with no unknown constant.</li>\n"
      "<li>This holds in floating point, whatever the solvers did (guarantee: {}): code that shares nothing with them "
      "moved the displacements out of contact and the stresses into balance exactly, and enclosed every rounding error "
      "of both energies.</li>\n{}</ul></div><div><h3>Not guaranteed</h3><ul>\n"
      "{}"
      "<li>The bodies are the {} of the mesh, coordinates as they are rounded; sides whose directions differ by "
      "less than 1e-6 are taken as parallel.</li>\n"
      "<li>Large displacements, curved {} and material laws other than linear elasticity "
      "are outside of "
      "the model. Stresses at a point may be further off than their norm.</li>\n</ul></div></div>\n",
      rounded_up(std::sqrt(2 * std::max(0.0, report.outcome.upper - report.outcome.lower))),
      percent(report.outcome.relative_error_bound), report.outcome.guarantee, exact ? fixed_data : "",
      step + sampled + (exact ? "" : fixed_data), Words<dim>::cells, Words<dim>::facets);
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

// A drawing as an element of the page, where the names in it must not meet those of another.
std::string inlined(const Drawing& drawing) {
  std::string svg = drawing.svg.substr(drawing.svg.find("<svg"));
  for (const char* reference : {"id='", "id=\"", "href='#", "url(#"})
    replace_all(svg, reference, reference + drawing.name + "-");
  const std::string kind = drawing.wide ? "<figure class=\"wide\">" : "<figure>";
  return kind + svg + "<figcaption>" + escaped(drawing.caption) + "</figcaption></figure>\n";
}

std::string figures(std::span<const Drawing> drawings, const char* kind = "pictures") {
  std::string html;
  for (const Drawing& drawing : drawings) html += inlined(drawing);
  return html.empty() ? "" : fmt::format("<div class=\"{}\">\n{}</div>\n", kind, html);
}

constexpr std::size_t first_pictures = 2;

/// The answer in pictures.
std::string answer_pictures(std::span<const Drawing> drawings) {
  return figures(drawings.first(std::min(first_pictures, drawings.size())), "pictures first");
}

template <int dim> std::string other_pictures(const ReportOf<dim>& report, std::span<const Drawing> drawings) {
  std::string html;
  if (drawings.size() > first_pictures)
    html = "<h2>How the bounds close, and where the error is</h2>\n" + figures(drawings.subspan(first_pictures));
  if (error_is_rounding(report.outcome)) html += "<p>The error is rounding: there is no picture of where it is.</p>\n";
  for (const std::string& line : report.missing) html += "<p>Missing: " + escaped(line) + ".</p>\n";
  return html;
}

template <int dim> std::string levels(const ReportOf<dim>& report) {
  Rows rows;
  for (std::size_t i = 0; i < report.outcome.levels.size(); ++i) {
    const bounds::Level& level = report.outcome.levels[i];
    const bool enclosed = std::isfinite(level.bracket.lower) && std::isfinite(level.bracket.upper) &&
                          level.bracket.lower <= level.bracket.upper;
    const Decimals energy =
        enclosed ? enclosed_in_decimals(level.bracket.lower, level.bracket.upper) : Decimals{"none", "none"};
    const auto closed = [](const contact::Statistics& of) { return fmt::format("{} / {}", of.active_rows, of.rows); };
    rows.push_back({fmt::to_string(i), fmt::to_string(level.cells), fmt::to_string(level.primal.unknowns),
                    fmt::to_string(level.dual.unknowns), energy.lower, energy.upper,
                    percent(level.bracket.relative_error_bound), closed(level.primal), closed(level.dual),
                    fmt::format("{:.2f}", report.around[i].elapsed)});
  }
  return "<h2>Levels</h2>\n" +
         html_table({"level", "cells", "unknowns, displace&shy;ments", "unknowns, stresses", "energy at least",
                     "energy at most", "relative error", "closed, displace&shy;ments", "closed, stresses", "seconds"},
                    rows, 0,
                    "Bounds of each mesh, guaranteed; closed: rows of contact by all rows; seconds since the start");
}

template <int dim> std::string seconds(const ReportOf<dim>& report) {
  const auto in_all = [&](const std::string& column) { return fmt::format("{:.2f}", sum(column, report)); };
  std::vector<std::string> head = {"formulation"};
  head.insert(head.end(), phase_names.begin(), phase_names.end());
  head.push_back("all");
  const auto row = [&](const char* name, const std::string& formulation) {
    std::vector<std::string> cells = {name};
    for (const std::string phase : phase_names) cells.push_back(in_all(formulation + "_" + phase));
    cells.push_back(in_all("seconds_" + formulation));
    return cells;
  };
  return "<h2>Where the time went</h2>\n" +
         html_table(head, {row("displacements", "primal"), row("stresses", "dual")}, 1,
                    "Seconds of each formulation, by stage, all levels together") +
         fmt::format(
             "<p>The two run {}. Besides: read {:.2f}, mesh {}, estimate {}, certify {}, quantities {}, "
             "write {}, pictures "
             "{:.2f} seconds.</p>\n",
             dim == 2 ? "side by side" : "one after the other", report.read, in_all("seconds_mesh"),
             in_all("seconds_estimate"), in_all("seconds_certify"), in_all("seconds_quantities"),
             in_all("seconds_write"), report.pictures);
}

std::string checks(const bounds::Checks& checks) {
  Rows rows;
  for (const bounds::Check& check : checks.all()) {
    const bool passed = check.value <= bounds::Checks::tolerance;
    rows.push_back({check.name, check.meaning, fmt::format("{:.1e}", check.value),
                    passed ? "ok" : "<span class=\"failed\">large</span>"});
  }
  return "<h2>Checks of the fields as computed, before the certificate</h2>\n" +
         html_table({"check", "meaning", "worst value", "verdict"}, rows, 2, "Of the last level") +
         fmt::format("<p>By the size of the scene's stresses, displacements or energy; limit {:g}.</p>\n",
                     bounds::Checks::tolerance);
}

std::string list(const char* title, const std::vector<std::string>& lines) {
  if (lines.empty()) return "";
  std::string html = fmt::format("<h2>{}</h2>\n<ul>\n", title);
  for (const std::string& line : lines) html += "<li>" + escaped(line) + "</li>\n";
  return html + "</ul>\n";
}

}  // namespace

template <int dim> std::string report_html(const ReportOf<dim>& report, const std::vector<Drawing>& drawings) {
  const bounds::Outcome<dim>& outcome = report.outcome;
  const bool guaranteed = outcome.guarantee != "none";
  const std::string title = escaped(report.scene.title.empty() ? report.scene.file : report.scene.title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0} – Bracket</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<main>\n<header><h1>{0}</h1><p>{2} · {3}{4}</p></header>\n",
      title, html_style, escaped(report.scene.file), setting_of(report.scene),
      report.scene.units.empty() ? "" : " · units " + escaped(report.scene.units));
  if (guaranteed) html += apps::quantities(report);
  html += answer(report);
  if (guaranteed) html += answer_pictures(drawings);
  html += findings_html(report);
  if (guaranteed) html += scope(report) + other_pictures(report, drawings) + levels(report);
  html += seconds(report) + checks(outcome.levels.back().checks);
  html += "<h2>The scene as it was understood</h2>\n" + html_scene(report);
  html += list("Not needed by this scene", outcome.skipped) + list("Notes", outcome.problem.mesh.notes);
  return html + "<footer>Bracket " + BRACKET_VERSION_STRING + "</footer>\n</main>\n</body>\n</html>\n";
}

template std::string report_html(const ReportOf<2>&, const std::vector<Drawing>&);
template std::string report_html(const ReportOf<3>&, const std::vector<Drawing>&);

}  // namespace bracket::apps
