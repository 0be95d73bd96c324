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
                       int n_names) {
  const auto row = [n_names](const std::vector<std::string>& cells, const char* tag) {
    std::string html = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i)
      html += fmt::format("<{0}{1}>{2}</{0}>", tag, static_cast<int>(i) < n_names ? " class=\"name\"" : "", cells[i]);
    return html + "</tr>\n";
  };
  std::string html = "<div class=\"scroll\"><table>\n<thead>" + row(head, "th") + "</thead>\n<tbody>\n";
  for (const auto& cells : rows) html += row(cells, "td");
  return html + "</tbody></table></div>\n";
}

const char* const html_style = R"(
:root { --ink: #1d2530; --soft: #5d6875; --line: #dde2e8; --blue: #1f5a94; --paper: #ffffff; --wash: #f4f6f9; }
* { box-sizing: border-box; }
body { margin: 0; background: var(--wash); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "DejaVu Sans", sans-serif; }
main { max-width: 76rem; margin: 0 auto; padding: 2rem 1.25rem 4rem; }
header p { color: var(--soft); margin: .2rem 0 0; overflow-wrap: anywhere; }
h1 { font-size: 1.75rem; line-height: 1.2; margin: 0; overflow-wrap: anywhere; }
h2 { font-size: 1.15rem; margin: 2.6rem 0 .8rem; }
h3 { font-size: 1rem; margin: 1.4rem 0 .4rem; }
p { max-width: 46rem; }
.answer { background: var(--paper); border: 1px solid var(--line); border-left: 6px solid var(--blue);
  border-radius: 6px; padding: 1.1rem 1.4rem; margin: 1.5rem 0; }
.answer.none { border-left-color: #b3261e; }
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
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 32rem), 1fr)); gap: 1.2rem; }
figure { margin: 0; background: var(--paper); border: 1px solid var(--line); border-radius: 6px; padding: .8rem; }
figure.wide { grid-column: 1 / -1; }
figure svg { display: block; width: 100%; height: auto; max-height: 40rem; margin: 0 auto; }
figure.wide svg { max-width: 60rem; max-height: none; }
figcaption { color: var(--soft); font-size: .88rem; line-height: 1.45; margin-top: .6rem; }
.scroll { overflow-x: auto; background: var(--paper); border: 1px solid var(--line); border-radius: 6px; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .38rem .8rem; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--line); }
tbody tr:last-child td { border-bottom: 0; }
th { color: var(--soft); font-weight: 600; white-space: normal; vertical-align: bottom; }
.name { text-align: left; }
.failed { color: #b3261e; font-weight: 700; }
footer { color: var(--soft); font-size: .88rem; margin-top: 3rem; }
@media (max-width: 40rem) {
  main { padding: 1.2rem .8rem 3rem; }
  .answer { padding: .9rem 1rem; }
  .bounds { grid-template-columns: 1fr; }
  .bounds dd { margin-bottom: .4rem; font-size: min(1.4rem, 5.4vw); }
}
@media print { body { background: none; } figure, .scroll, .answer { break-inside: avoid; } }
)";

}  // namespace bracket::apps
