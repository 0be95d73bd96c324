# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Energies and quantities of elastic bodies in contact, each between two guaranteed bounds.

    scene = bracket.read_scene("two_blocks.toml")      # or bracket.Scene(), filled in code
    outcome = bracket.run(scene)
    print(outcome)                                     # what is guaranteed
    outcome.displacement, outcome.stress               # the fields, computed

Units are those of the scene; forces and energies of the plane are by thickness. Arrays are NumPy's and copies. What is in
three dimensions is in bracket.space.
"""

from . import space
from ._bracket import (
    Assessment,
    Circle,
    Contact,
    Displacement,
    Error,
    Level,
    Line,
    Mesh,
    Outcome,
    Quantity,
    Scene,
    Stress,
    __version__,
    assess,
    assess_file,
    read_scene,
    run,
)

__all__ = [
    "Assessment",
    "Circle",
    "Contact",
    "Displacement",
    "Error",
    "Level",
    "Line",
    "Mesh",
    "Outcome",
    "Quantity",
    "Scene",
    "Stress",
    "__version__",
    "assess",
    "assess_file",
    "read_scene",
    "run",
    "space",
]
