// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
// What ParaView is told to show.
#include <fmt/format.h>

#include <algorithm>

#include "apps/report/stresses.h"
#include "apps/report/vtk.h"

namespace bracket::apps {
namespace {

/// A text as a string of Python.
std::string python(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return result + "\"";
}

constexpr const char* script =
    R"py(# Opens this run in ParaView: paraview --script=view.py (in this folder), or File, Load State.
# Bodies and contact {4} are where the pictures of the report have them: displacements and gaps are magnified alike
# (by "drawn_factor"), so that bodies touch where contact is closed and overlap nowhere.
import os

from paraview.simple import (ColorBy, GetActiveViewOrCreate, GetAnimationScene, GetColorTransferFunction, GetScalarBar,
                             PVDReader, Render, ResetCamera, Show, Threshold, WarpByVector)

TITLE = {0}
BODIES = [{1}]  # by the numbers in "body"
PAIRS = [{2}]  # by the numbers in "pair"
VON_MISES = {3}  # False: a stiffness does not tell the stress across the plane

folder = os.path.dirname(os.path.abspath(globals().get("__file__", "view.py")))
run = PVDReader(registrationName=TITLE, FileName=os.path.join(folder, "solution.pvd"))
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
GetAnimationScene().GoToLast()
view = GetActiveViewOrCreate("RenderView")
{5}

def part(name, cells, last):
    """The cells of a kind, where they are drawn."""
    chosen = Threshold(registrationName=name, Input=run, Scalars=["CELLS", cells])
    chosen.LowerThreshold, chosen.UpperThreshold = 0, last
    return WarpByVector(registrationName=name + ", deformed", Input=chosen, Vectors=["POINTS", "drawn"], ScaleFactor=1)


def colour(shown, name, title, place, component=None):
    """Colours by a point field, with its bar."""
    ColorBy(shown, ("POINTS", name) if component is None else ("POINTS", name, component))
    shown.RescaleTransferFunctionToDataRange(False, True)
    shown.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(GetColorTransferFunction(name), view)
    bar.Title, bar.ComponentTitle, bar.WindowLocation = title, "", place
    bar.TitleFontSize = bar.LabelFontSize = 12


bodies = Show(part("bodies", "body", len(BODIES) - 1), view)
bodies.NonlinearSubdivisionLevel = 2
if VON_MISES:
    colour(bodies, "von_mises", "von Mises", "Lower Right Corner")
else:
    colour(bodies, "principal", "larger principal stress", "Lower Right Corner", "larger")
names = GetColorTransferFunction("body")  # for whoever colours by "body"
names.InterpretValuesAsCategories = 1
names.Annotations = [text for i, name in enumerate(BODIES) for text in (str(i), name)]
if PAIRS:
    {4} = Show(part("contact", "pair", len(PAIRS) - 1), view)
    {6}
    colour({4}, "pressure", "pressure", "Upper Right Corner")
ResetCamera(view)
Render(view)
)py";

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& each : names) text += (text.empty() ? "" : ", ") + python(each);
  return text;
}

}  // namespace

template <int dim> std::string paraview_view(const ReportOf<dim>& report) {
  const scene::Problem<dim>& problem = report.outcome.problem;
  std::vector<std::string> pairs;
  for (const auto& pair : report.scene.contact) pairs.push_back(pair_name(pair));
  bool is_known = true;  // the whole stress, in the plane that across it too
  if constexpr (dim == 2) is_known = knows_stress_across(problem, report.scene.plane);
  const char* const contact = dim == 2 ? "lines" : "faces";
  return fmt::format(fmt::runtime(script), python(report.scene.title.empty() ? "Bracket" : report.scene.title),
                     listed(problem.mesh.bodies), listed(pairs), is_known ? "True" : "False", contact,
                     dim == 2 ? "view.InteractionMode = \"2D\"\n" : "view.InteractionMode = \"3D\"\n",
                     dim == 2 ? "lines.LineWidth = 4" : "bodies.Opacity = 0.5  # faces of contact lie between them");
}

template std::string paraview_view(const ReportOf<2>&);
template std::string paraview_view(const ReportOf<3>&);

}  // namespace bracket::apps
