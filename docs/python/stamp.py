# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""A scene in space from arrays: a quarter of a stamp whose sides taper, pressed on a wall by a load that a callable has.

    python3 stamp.py
"""
import itertools

import bracket
import bracket.space
import numpy


def tetrahedra(n):
    """The unit cube: vertices (k, 3) and cells (m, 4), six for each of n x n x n cubes."""
    places = numpy.array(list(itertools.product(range(n + 1), repeat=3)))
    step = (n + 1) ** numpy.arange(2, -1, -1)  # from a vertex to the next along x, y, z
    corners = places[(places < n).all(axis=1)] @ step
    cells = [corners[:, None] + numpy.cumsum([0, *step[list(order)]]) for order in itertools.permutations(range(3))]
    return places / n, numpy.concatenate(cells)


def faces(cells, on_part):
    """The faces of cells whose vertices are all on a flat part of the boundary."""
    all_faces = numpy.concatenate([numpy.delete(cells, i, axis=1) for i in range(4)])
    return all_faces[on_part[all_faces].all(axis=1)]


def scene():
    x, cells = tetrahedra(3)
    vertices = x.copy()
    vertices[:, :2] *= 20 + 10 * (1 - x[:, 2:])  # half of 40 mm wide at the top, of 60 mm at the wall
    vertices[:, 2] *= 30
    made = bracket.space.Scene(title="A stamp", units="N, mm, MPa")
    sides = {"plane x": x[:, 0] == 0, "plane y": x[:, 1] == 0, "foot": x[:, 2] == 0, "head": x[:, 2] == 1}
    made.set_mesh(vertices, cells, parts={name: faces(cells, on) for name, on in sides.items()})
    made.add_body("body", E=2000, nu=0.35)
    made.set_sliding("plane x", 0)  # of symmetry
    made.set_sliding("plane y", 0)
    made.set_traction("head", 0, 0, lambda x, y, z: -10 * (1 - (x + y) / 80))
    made.add_contact("foot", "rigid", gap="2e-4 * (x * x + y * y)", name="foot")
    made.add_quantity("sinking", "displacement", "head", direction=(0, 0, -1))
    made.add_quantity("force", "force", "foot")
    made.set_refine(strategy="adaptive", target=0.1)
    return made


if __name__ == "__main__":
    outcome = bracket.run(scene())
    print(outcome, end="")
    contact = outcome.contacts[0]
    print(f"pressed: {contact.pressed_area:.0f} of {contact.area:.0f} mm²")
