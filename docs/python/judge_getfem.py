# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Cook's membrane by GetFEM (Debian: python3-getfem), and how wrong that is: python3 judge_getfem.py."""
import pathlib

import bracket

SCENES = pathlib.Path(__file__).resolve().parents[2] / "apps" / "scenes"
E, NU = 1.0, 1 / 3  # as cook.toml has them


def solve(mesh):
    """The displacements of GetFEM by linear triangles on a mesh of Bracket: nodes, values and cells."""
    import getfem

    getfem.util_trace_level(0)

    triangles = getfem.Mesh("empty", 2)
    for cell in mesh.cells:
        triangles.add_convex(getfem.GeoTrans("GT_PK(2,1)"), mesh.vertices[cell].T[:, :, None])
    field = getfem.MeshFem(triangles, 2)
    field.set_fem(getfem.Fem("FEM_PK(2,1)"))
    integration = getfem.MeshIm(triangles, getfem.Integ("IM_TRIANGLE(4)"))
    left, right = 1, 2
    triangles.set_region(left, triangles.outer_faces_with_direction([-1, 0], 0.01))
    triangles.set_region(right, triangles.outer_faces_with_direction([1, 0], 0.01))

    model = getfem.Model("real")
    model.add_fem_variable("u", field)
    model.add_initialized_data("mu", E / (2 * (1 + NU)))
    model.add_initialized_data("lame", E * NU / (1 - NU**2))  # of plane stress
    model.add_isotropic_linearized_elasticity_brick(integration, "u", "lame", "mu")
    model.add_initialized_data("traction", [0, 1 / 16])
    model.add_source_term_brick(integration, "u", "traction", right)
    model.add_Dirichlet_condition_with_multipliers(integration, "u", field, left)
    model.solve()
    cells = field.basic_dof_from_cvid()[0].reshape(-1, 6)[:, ::2] // 2  # each node has two numbers
    return field.basic_dof_nodes()[:, ::2].T, model.variable("u").reshape(-1, 2), cells


if __name__ == "__main__":
    scene = bracket.read_scene(SCENES / "cook.toml", ["refine.strategy=adaptive"])
    for refinements in range(3):
        mesh = scene.mesh(refinements)
        nodes, values, cells = solve(mesh)
        judged = bracket.assess(scene, nodes, values, cells=cells)
        print(f"{len(mesh.cells):5} cells: {judged}", end="")
