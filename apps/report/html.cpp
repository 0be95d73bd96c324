// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/report/html.h"

#include <fmt/format.h>

namespace bracket::apps {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      case '\'': result += "&#39;"; break;
      default: result += c;
    }
  }
  return result;
}

std::string html_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                       int n_names, const std::string& caption, const std::string& kind) {
  std::string html = fmt::format("<div class=\"scroll{}\" tabindex=\"0\"><table>\n", kind.empty() ? kind : " " + kind);
  if (!caption.empty()) html += "<caption>" + caption + "</caption>\n";
  html += "<thead><tr>";
  const auto name_or_number = [n_names](std::size_t i) {
    return static_cast<int>(i) < n_names ? " class=\"name\"" : "";
  };
  for (std::size_t i = 0; i < head.size(); ++i)
    html += fmt::format("<th scope=\"col\"{}>{}</th>", name_or_number(i), head[i]);
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& cells : rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
      html += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", name_or_number(i), cells[i])
                     : fmt::format("<td{}>{}</td>", name_or_number(i), cells[i]);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

const char* const html_style = R"(
:root { color-scheme: light; --ink: #1d2530; --soft: #56606c; --line: #dde2e8; --blue: #1f5a94; --paper: #ffffff;
  --wash: #f4f6f9; --bad: #b3261e; }
@media screen and (prefers-color-scheme: dark) {
  :root { color-scheme: dark; --ink: #e4e8ed; --soft: #a3adb9; --line: #39434f; --blue: #7db4ea; --paper: #1c232c;
    --wash: #12171d; --bad: #ff8a80; }
  figure svg { background: #ffffff; border-radius: 4px; filter: brightness(.92); }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--wash); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
main { max-width: 80rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
header p { color: var(--soft); margin: .2rem 0 0; overflow-wrap: anywhere; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin: 2.6rem 0 .8rem; }
h3 { font-size: 1rem; margin: 1.4rem 0 .4rem; }
p { max-width: 46rem; }
.answer { background: var(--paper); border: 1px solid var(--line); border-left: 6px solid var(--blue);
  border-radius: 6px; padding: 1.1rem 1.4rem; margin: 1.5rem 0; }
.answer.none { border-left-color: var(--bad); }
.bounds { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1.2rem; align-items: baseline; margin: 0; }
.bounds dt { color: var(--soft); }
.bounds dd { margin: 0; font-size: clamp(1.05rem, 4.4vw, 1.8rem); font-variant-numeric: tabular-nums;
  overflow-wrap: anywhere; }
.bounds .open { color: var(--soft); font-weight: 400; }
.bounds b { color: var(--blue); }
.facts { display: flex; flex-wrap: wrap; gap: .4rem 2.2rem; margin: .9rem 0 0; }
.facts div { color: var(--soft); }
.facts b { color: var(--ink); }
.scope { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); gap: 0 2rem; }
.scope ul { margin: .3rem 0; padding-left: 1.1rem; }
.scope li { margin: .35rem 0; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); gap: 1.2rem; }
.pictures.first { margin-bottom: 1.6rem; }
figure { margin: 0; background: var(--paper); border: 1px solid var(--line); border-radius: 6px; padding: .8rem; }
figure.wide { grid-column: 1 / -1; }
figure svg { display: block; width: 100%; height: auto; max-height: 44rem; margin: 0 auto; }
figure.wide svg { max-width: 60rem; max-height: none; }
figcaption { color: var(--soft); font-size: .88rem; line-height: 1.45; margin-top: .6rem; }
.scroll { overflow-x: auto; background: var(--paper); border: 1px solid var(--line); border-radius: 6px; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--soft); padding: .5rem .8rem .2rem; }
th, td { padding: .38rem .8rem; text-align: right; border-bottom: 1px solid var(--line); }
td, tbody th { white-space: nowrap; font-weight: 400; }
td.name { white-space: normal; min-width: 12rem; }
tbody tr:last-child td, tbody tr:last-child th { border-bottom: 0; }
thead th { color: var(--soft); font-weight: 600; vertical-align: bottom; }
.name { text-align: left; }
.failed { color: var(--bad); font-weight: 700; }
footer { color: var(--soft); font-size: .88rem; margin-top: 3rem; }
@media (max-width: 40rem) {
  main { padding: 1.2rem .8rem 3rem; }
  .answer { padding: .9rem 1rem; }
  .bounds { grid-template-columns: 1fr; }
  .bounds dd { margin-bottom: .4rem; font-size: min(1.4rem, 5.4vw); }
  .scope { display: block; }
  figure { margin: 0 -.7rem; padding: .3rem 0; }
  figure svg { max-height: none; }
  figcaption { padding: 0 .7rem; }
  .findings thead { position: absolute; clip-path: inset(50%); }
  .findings table, .findings tbody, .findings caption { display: block; }
  .findings tr { display: grid; grid-template-columns: 1fr auto; padding: .3rem .8rem;
    border-bottom: 1px solid var(--line); }
  .findings tr:last-child { border-bottom: 0; }
  .findings th, .findings td.name { border: 0; padding: 0; min-width: 0; white-space: normal; }
  .findings th { grid-column: 1 / -1; font-weight: 600; }
  .findings td:nth-child(2) { color: var(--soft); }
  .findings td:nth-child(3) { grid-row: 3; grid-column: 1 / -1; }
}
@page { size: A4; margin: 15mm; }
@media print {
  body { background: none; font-size: 10.5pt; }
  main { max-width: none; padding: 0; }
  .scroll { overflow: visible; }
  table { font-size: 8pt; }
  th, td { padding: .25rem .4rem; }
  td.name, th.name { white-space: normal; overflow-wrap: break-word; min-width: 0; }
  .findings td:last-child { white-space: nowrap; }
  .findings tbody tr:nth-child(-n+4) { break-before: avoid; }
  h2, h3 { break-after: avoid; }
  .answer, .scroll, tr, li, figure { break-inside: avoid; }
  .scroll.findings { break-inside: auto; }
  .findings caption { caption-side: bottom; }
  .pictures { display: block; }
  .pictures.first { display: grid; grid-template-columns: repeat(auto-fit, minmax(80mm, 1fr)); gap: 4mm;
    margin-bottom: 0; }
  figure { margin-bottom: 5mm; }
  figure svg, figure.wide svg { max-height: 86mm; width: auto; max-width: 100%; }
  figcaption { font-size: 8.5pt; }
}
)";

}  // namespace bracket::apps
