# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes that the tests share."""
import pathlib

import bracket
import numpy

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SCENES = PROJECT / "apps" / "scenes"
DOCS = PROJECT / "docs"
FIELDS = PROJECT / "tests" / "fields"


def two_blocks(*, traction="x < 0.5 ? -0.1 : 0.09"):
    """two_blocks.toml, in code, without its mesh."""
    scene = bracket.Scene(title="Two blocks, partial lift-off", units="N, mm, MPa", plane="strain")
    scene.add_body("lower", E=1.0, nu=0.3)
    scene.add_body("upper", E=2.0, nu=0.3)
    scene.set_fixed("lower.bottom", 0, 0)
    scene.set_sliding("upper.left", 0)
    scene.set_traction("upper.top", 0, traction)
    scene.add_contact("upper.bottom", "lower.top", gap=0)
    scene.add_quantity("lift of the top", "displacement", "upper.top", direction=(0, 1))
    scene.add_quantity("force, right half", "force", "upper.bottom", stretch=(0, 0.5))
    scene.set_refine(strategy="adaptive", target=1e-3)
    return scene


def with_blocks(scene, cells=4):
    scene.add_block("lower", x=(0, 1), y=(0, 1), cells=(cells, cells))
    scene.add_block("upper", x=(0, 1), y=(1, 2), cells=(cells, cells))
    return scene


def grid(n, y):
    """The vertices and triangles of the square [0, 1] x [y, y + 1], and the vertices of its four sides."""
    i, j = numpy.meshgrid(numpy.arange(n + 1), numpy.arange(n + 1))
    vertices = numpy.column_stack([i.ravel() / n, y + j.ravel() / n])
    number = (i + (n + 1) * j).T  # by i, j
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    cells = numpy.concatenate([numpy.stack([a, b, c], -1).reshape(-1, 3), numpy.stack([a, c, d], -1).reshape(-1, 3)])
    sides = {"left": number[0], "right": number[-1], "bottom": number[:, 0], "top": number[:, -1]}
    return vertices, cells, {name: numpy.column_stack([ends[:-1], ends[1:]]) for name, ends in sides.items()}


def two_grids(n):
    """Vertices, cells, bodies and parts of two squares, one on the other, with vertices of their own."""
    below, above = grid(n, 0), grid(n, 1)
    shift, cells = len(below[0]), len(below[1])
    parts = {f"lower.{side}": edges for side, edges in below[2].items()}
    parts.update({f"upper.{side}": edges + shift for side, edges in above[2].items()})
    return (
        numpy.concatenate([below[0], above[0]]),
        numpy.concatenate([below[1], above[1] + shift]),
        {"lower": numpy.arange(cells), "upper": cells + numpy.arange(cells)},
        parts,
    )


def square(**settings):
    """A square pressed on a wall, one mesh."""
    scene = bracket.Scene()
    scene.add_block("block", x=(0, 1), y=(0, 1), cells=(4, 4))
    scene.add_body("block", E=1000, nu=0.3)
    scene.set_sliding("block.left", 0)
    scene.set_pressure("block.top", 1)
    scene.add_contact("block.bottom", "rigid")
    scene.set_solve(**settings)
    return scene
