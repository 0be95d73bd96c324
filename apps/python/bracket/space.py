# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""What is in three dimensions: bracket.space.Scene is in space what bracket.Scene is in the plane, and so on.

bracket.read_scene(), run(), assess() and assess_file() know both.
"""

from ._bracket import space as _space

Assessment = _space.Assessment
Contact = _space.Contact
Displacement = _space.Displacement
Mesh = _space.Mesh
Outcome = _space.Outcome
Plane = _space.Plane
Scene = _space.Scene
Stress = _space.Stress

__all__ = ["Assessment", "Contact", "Displacement", "Mesh", "Outcome", "Plane", "Scene", "Stress"]
