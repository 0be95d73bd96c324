# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""python3 lift-off.py MESH: apps/scenes/space/lift_off.toml by GetFEM (Debian's python3-getfem++): quadratic
displacements, contact at nodes by multipliers and Newton's method. MESH is that of

    bracket mesh apps/scenes/space/lift_off.toml -o MESH.msh --degree 1 --refine N

Prints the case 0, the number of cells, the energy and the mean displacement of the top."""
import sys

import getfem as gf
import numpy as np

YOUNG, POISSON = {"lower": 1.0, "upper": 2.0}, 0.3
PRESSED, PULLED = -0.1, 0.09


def read(path):
    """The nodes of a mesh of Gmsh 2.2, and the tetrahedra of each body."""
    with open(path) as file:
        lines = file.read().split("\n")

    def section(name):
        first = lines.index(name) + 2
        return lines[first:first + int(lines[first - 1])]

    names = {}
    for line in section("$PhysicalNames"):
        dim, tag, name = line.split()
        names[int(dim), int(tag)] = name.strip('"')
    points = np.array([[float(x) for x in line.split()[1:]] for line in section("$Nodes")])
    cells = {}
    for line in section("$Elements"):
        entry = [int(x) for x in line.split()]
        if entry[1] == 4:
            cells.setdefault(names[3, entry[3]], []).append([k - 1 for k in entry[3 + entry[2]:]])
    return points, {body: np.array(of) for body, of in cells.items()}


class Body:
    """A box of a mesh of its own, with faces that are 'left', 'bottom', … of it."""

    SIDES = {"left": (0, 0), "right": (0, 1), "bottom": (1, 0), "top": (1, 1), "back": (2, 0), "front": (2, 1)}

    def __init__(self, model, name, points, cells):
        self.mesh = gf.Mesh("empty", 3)
        for cell in cells:
            self.mesh.add_convex(gf.GeoTrans("GT_PK(3,1)"), points[cell].T)
        self.integral = gf.MeshIm(self.mesh, gf.Integ("IM_TETRAHEDRON(5)"))
        self.fem = gf.MeshFem(self.mesh, 3)
        self.fem.set_fem(gf.Fem("FEM_PK(3,2)"))
        self.outer = self.mesh.outer_faces()
        self.centres = np.array(
            [self.mesh.pts()[:, self.mesh.pid_in_faces(face.reshape(2, 1))].mean(axis=1) for face in self.outer.T])
        ends = points[cells].reshape(-1, 3).min(axis=0), points[cells].reshape(-1, 3).max(axis=0)
        self.region = {}
        for side, (axis, end) in self.SIDES.items():
            self.add_region(side, np.abs(self.centres[:, axis] - ends[end][axis]) < 1e-9)
        self.variable = "u_" + name
        model.add_fem_variable(self.variable, self.fem)
        young = YOUNG[name]
        model.add_initialized_data("lambda_" + name, young * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)))
        model.add_initialized_data("mu_" + name, young / (2 * (1 + POISSON)))
        model.add_isotropic_linearized_elasticity_brick(self.integral, self.variable, "lambda_" + name, "mu_" + name)

    def add_region(self, name, faces):
        self.region[name] = 1 + len(self.region)
        self.mesh.set_region(self.region[name], self.outer[:, faces])

    def components(self, side, axis):
        """The unknowns of one component on a side."""
        unknowns = self.fem.basic_dof_on_region(self.region[side])
        return unknowns[unknowns % 3 == axis]

    def hold(self, model, unknowns):
        rows = gf.Spmat("empty", len(unknowns), self.fem.nbdof())
        for row, unknown in enumerate(unknowns):
            rows.add(row, unknown, 1.0)
        model.add_variable("reactions_of_" + self.variable, len(unknowns))
        model.add_constraint_with_multipliers(self.variable, "reactions_of_" + self.variable, rows,
                                              np.zeros(len(unknowns)))


def sliding(body, sides, but=()):
    found = set()
    for side, axis in sides:
        found |= {int(unknown) for unknown in body.components(side, axis)}
    return sorted(found - set(but))


def rows_of_contact(lower, upper):
    """u_lower − u_upper along y, at the nodes that face each other."""
    def nodes(body, side):
        unknowns = body.components(side, 1)
        return {tuple(np.round(x, 9)): int(k) for x, k in zip(body.fem.basic_dof_nodes(unknowns).T, unknowns)}

    above, below = nodes(upper, "bottom"), nodes(lower, "top")
    assert above.keys() == below.keys()
    rows = [gf.Spmat("empty", len(above), body.fem.nbdof()) for body in (lower, upper)]
    for row, at in enumerate(sorted(above)):
        rows[0].add(row, below[at], 1.0)
        rows[1].add(row, above[at], -1.0)
    return len(above), rows


def main():
    gf.util_trace_level(0)
    points, cells = read(sys.argv[1])
    model = gf.Model("real")
    lower, upper = (Body(model, name, points, cells[name]) for name in ("lower", "upper"))
    model.add_Dirichlet_condition_with_simplification(lower.variable, lower.region["bottom"])
    held = [int(unknown) for unknown in lower.fem.basic_dof_on_region(lower.region["bottom"])]
    lower.hold(model, sliding(lower, [("back", 2), ("front", 2)], but=held))
    upper.hold(model, sliding(upper, [("left", 0), ("back", 2), ("front", 2)]))
    on_top = np.abs(upper.centres[:, 1] - upper.centres[:, 1].max()) < 1e-9
    for name, load, faces in (("pressed", PRESSED, upper.centres[:, 0] < 0.5), ("pulled", PULLED, upper.centres[:, 0] > 0.5)):
        upper.add_region(name, on_top & faces)
        model.add_initialized_data(name, [0, load, 0])
        model.add_source_term_brick(upper.integral, upper.variable, name, upper.region[name])
    count, (below, above) = rows_of_contact(lower, upper)
    model.add_variable("pressure", count)
    model.add_initialized_data("augmentation", 1.0)
    model.add_initialized_data("gap", np.zeros(count))
    model.add_basic_contact_brick_two_deformable_bodies(lower.variable, upper.variable, "pressure", "augmentation",
                                                        below, above, "gap")
    steps, converged = model.solve("max_res", 1e-11, "max_iter", 50, "lsolver", "mumps")
    if not converged:
        sys.exit("not converged")

    def integral(body, expression, region=-1):
        return gf.asm_generic(body.integral, 0, expression, region, model)

    energy = 0
    for name, body in (("lower", lower), ("upper", upper)):
        energy += integral(body, "0.5*lambda_{0}*sqr(Trace(Grad_u_{0}))+mu_{0}*(Sym(Grad_u_{0}):Sym(Grad_u_{0}))"
                           .format(name))
    for name in ("pressed", "pulled"):
        energy -= integral(upper, name + ".u_upper", upper.region[name])
    top = integral(upper, "[0,1,0].u_upper", upper.region["top"]) / 0.5
    print(0, sum(len(of) for of in cells.values()), repr(float(energy)), repr(float(top)))


main()
