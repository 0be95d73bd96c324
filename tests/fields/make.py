# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Writes one field in each encoding that VTK has, and as meshio writes it (Debian: python3-vtk9, python3-meshio).

make.py MESH.vtu QUADRATIC_MESH.vtu: of two_blocks.toml with 2 x 2 cells a block, as "bracket mesh" writes them.
"""
import sys

import meshio
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy


def displacement(points, upper):
    """Linear in each body: tests/scene/field_test.cpp has the same."""
    x, y = points[:, 0], points[:, 1]
    lower = numpy.array([0.1 + 0.2 * x - 0.3 * y, 0.4 * x + 0.5 * y, 0 * x])
    other = numpy.array([1 - 0.7 * x + 0.11 * y, -2 + 0.13 * x + 0.17 * y, 0 * x])
    return numpy.where(upper, other, lower).T.copy()


def field_on(name, single=False):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    grid = reader.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    upper = numpy.zeros(len(points), dtype=bool)
    for cell in range(grid.GetNumberOfCells()):
        if grid.GetCellData().GetArray("body").GetValue(cell) == 1:
            ids = grid.GetCell(cell).GetPointIds()
            upper[[ids.GetId(i) for i in range(ids.GetNumberOfIds())]] = True
    values = displacement(points, upper)
    if single:
        moved = vtk.vtkPoints()
        moved.SetDataTypeToFloat()
        moved.SetData(numpy_to_vtk(points.astype(numpy.float32), deep=True))
        grid.SetPoints(moved)
        values = values.astype(numpy.float32)
    array = numpy_to_vtk(values, deep=True)
    array.SetName("displacement")
    grid.GetPointData().AddArray(array)
    return grid


def write(name, grid, mode, encode=False, compress=False, header=32):
    writer = vtk.vtkXMLUnstructuredGridWriter()
    writer.SetFileName(name)
    writer.SetInputData(grid)
    {"ascii": writer.SetDataModeToAscii, "base64": writer.SetDataModeToBinary,
     "appended": writer.SetDataModeToAppended}[mode]()
    writer.SetEncodeAppendedData(encode)
    writer.SetCompressorTypeToZLib() if compress else writer.SetCompressorTypeToNone()
    writer.SetHeaderTypeToUInt32() if header == 32 else writer.SetHeaderTypeToUInt64()
    writer.Write()


linear, quadratic = field_on(sys.argv[1]), field_on(sys.argv[2])
write("ascii.vtu", linear, "ascii")
write("base64.vtu", linear, "base64", header=64)
write("base64_zlib.vtu", linear, "base64", compress=True)
write("appended_base64.vtu", linear, "appended", encode=True)
write("appended_base64_zlib.vtu", linear, "appended", encode=True, compress=True, header=64)
write("appended_raw.vtu", linear, "appended", header=64)
write("appended_raw_zlib.vtu", linear, "appended", compress=True)
write("single.vtu", field_on(sys.argv[1], single=True), "base64", compress=True)
write("quadratic.vtu", quadratic, "appended", compress=True, header=64)
meshio.write("meshio.vtu", meshio.read("ascii.vtu"))
