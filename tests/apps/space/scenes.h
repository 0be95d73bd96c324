// Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Scenes of space for the tests of this folder.
namespace bracket::apps::tests {

/// Two blocks pressed together on the left half of the top and pulled apart on the right, half a unit deep, with ends
/// that slide: the plane's two blocks (docs/theory.md §9.2), extruded.
inline constexpr const char* two_boxes = R"(schema = 1
dim = 3
title = "Two boxes"
units = "N, mm, MPa"
[[mesh.block]]
body = "lower"
x = [0, 1]
y = [0, 1]
z = [0, 0.5]
cells = [2, 2, 1]
[[mesh.block]]
body = "upper"
x = [0, 1]
y = [1, 2]
z = [0, 0.5]
cells = [2, 2, 1]
[bodies.lower]
E = 1
nu = 0.3
[bodies.upper]
E = 2
nu = 0.3
[boundary]
"lower.bottom" = { fixed = [0, 0, 0] }
"upper.left" = { sliding = 0 }
"lower.back" = { sliding = 0 }
"lower.front" = { sliding = 0 }
"upper.back" = { sliding = 0 }
"upper.front" = { sliding = 0 }
"upper.top" = { traction = [0, "x < 0.5 ? -0.1 : 0.09", 0] }
[[contact]]
first = "upper.bottom"
second = "lower.top"
)";

}  // namespace bracket::apps::tests
