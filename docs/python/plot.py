# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""A block pressed on a wavy wall: made in code, solved, drawn by matplotlib. python3 plot.py [FILE]"""
import math
import sys

import matplotlib
import numpy

import bracket


def scene():
    made = bracket.Scene(title="A block pressed on a wavy wall", units="N, mm, MPa")
    made.add_block("block", x=(0, 1), y=(0, 1), cells=(8, 8))
    made.add_body("block", E=210e3, nu=0.3)
    made.set_sliding("block.left", 0)
    made.set_pressure("block.top", "100 * (1 + 0.2 * x)")
    made.add_contact("block.bottom", "rigid", gap="0.001 * (1 - cos(2 * pi * x))")
    made.add_quantity("sinking", "displacement", "block.top", direction=(0, -1))
    made.set_refine(strategy="adaptive", target=0.01)
    return made


def mean_stress(stress):
    """(m, 3) of the values at the corners of the three parts of each cell."""
    return stress.coefficients[:, :, [0, stress.degree, -1]].mean(axis=(1, 2))


def draw(outcome, file):
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, (bodies, line) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
    x = outcome.mesh.vertices
    colours = bodies.tripcolor(*x.T, outcome.mesh.cells, mean_stress(outcome.stress)[:, 1], edgecolors="k", lw=0.2)
    figure.colorbar(colours, ax=bodies, label="vertical stress [MPa], computed")
    bodies.set(aspect="equal", xlabel="x [mm]", ylabel="y [mm]", title=f"{len(outcome.mesh.cells)} cells")

    contact = outcome.contacts[0]
    for ends, pressure in zip(contact.points, contact.pressure):
        t = numpy.linspace(0, 1, 9)[:, None]  # by its Bernstein coefficients
        n = len(pressure) - 1
        basis = [math.comb(n, k) * t**k * (1 - t) ** (n - k) for k in range(n + 1)]
        line.plot(((1 - t) * ends[0] + t * ends[1])[:, 0], sum(b * p for b, p in zip(basis, pressure)), "C1")
    sinking = outcome.quantity("sinking")
    line.set(xlabel="x [mm]", ylabel="contact pressure [MPa], computed")
    outward = math.floor(1e6 * sinking.lower), math.ceil(1e6 * sinking.upper)
    line.set_title("the top sinks by {} to {} nm, guaranteed".format(*outward))
    figure.savefig(file)


if __name__ == "__main__":
    outcome = bracket.run(scene())
    print(outcome, end="")
    draw(outcome, sys.argv[1] if len(sys.argv) > 1 else "wall.png")
