# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Writes dolfinx_1.vtu and dolfinx_2.vtu: linear and quadratic fields of DOLFINx on the unit square (python3-dolfinx)."""
import pathlib
import shutil
import tempfile

import numpy
from dolfinx import fem, io, mesh
from mpi4py import MPI

square = mesh.create_rectangle(MPI.COMM_WORLD, [[0, 0], [1, 1]], [3, 3])
for degree in (1, 2):
    u = fem.Function(fem.VectorFunctionSpace(square, ("CG", degree)))
    # As make.py, lower body.
    u.interpolate(lambda x: numpy.vstack((0.1 + 0.2 * x[0] - 0.3 * x[1], 0.4 * x[0] + 0.5 * x[1])))
    with tempfile.TemporaryDirectory() as folder:
        with io.VTKFile(square.comm, str(pathlib.Path(folder) / "u.pvd"), "w") as file:
            file.write_function(u)
        shutil.copy(pathlib.Path(folder) / "u_p0_000000.vtu", f"dolfinx_{degree}.vtu")
