# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""What is in three dimensions."""
import copy
import itertools
import json
import math
import pathlib
import re
import tempfile
import unittest

import bracket
import bracket.space
import numpy

import scenes

FACES = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]  # of a tetrahedron, counter-clockwise from outside
MIDDLES = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]  # of edges, in the order of other programs
EDGES = [(1, 2), (2, 0), (0, 1), (0, 3), (1, 3), (2, 3)]  # of Mesh.cell_edges


def on_a_wall(with_block=True):
    """A block pressed on a wall by 1 + x / 2, and bent sideways."""
    scene = bracket.space.Scene(title="On a wall", units="N, mm, MPa")
    if with_block:
        scene.add_block("block", x=(0, 1), y=(0, 2), z=(0, 1), cells=(2, 4, 2))
    scene.add_body("block", E=1000, nu=0.3)
    scene.set_sliding("block.left", 0)
    scene.set_sliding("block.back", 0)
    scene.set_traction("block.top", 0.05, "-(1 + x / 2)", 0)
    scene.add_contact("block.bottom", "rigid", gap=0, name="wall")
    scene.add_quantity("sinking", "displacement", "block.top", direction=(0, -1, 0))
    scene.add_quantity("push", "force", "wall")
    return scene


def cubes(n):
    """[0, 1] x [0, 2] x [0, 1] as n x 2n x n cubes, each cut in six along its diagonal, with the faces of its sides."""
    size = numpy.array([n, 2 * n, n])
    places = numpy.array(list(itertools.product(*[range(k + 1) for k in size])))
    number = {tuple(place): i for i, place in enumerate(places)}
    cells = []
    for corner in itertools.product(*[range(k) for k in size]):
        for order in itertools.permutations(range(3)):
            at = list(corner)
            cell = [number[tuple(at)]]
            for axis in order:
                at[axis] += 1
                cell.append(number[tuple(at)])
            cells.append(cell)
    faces = {tuple(sorted(cell[:i] + cell[i + 1 :])) for cell in cells for i in range(4)}
    sides = {"left": (0, 0), "right": (0, n), "bottom": (1, 0), "top": (1, 2 * n), "back": (2, 0), "front": (2, n)}
    parts = {
        f"block.{name}": [face for face in faces if (places[list(face), axis] == at).all()]
        for name, (axis, at) in sides.items()
    }
    return places / n, numpy.array(cells), parts


class Numbers(unittest.TestCase):
    def test_of_a_file_are_those_of_the_same_in_code(self):
        file = scenes.SCENES / "space" / "patch.toml"
        scene = bracket.read_scene(file)
        self.assertIsInstance(scene, bracket.space.Scene)
        self.assertEqual((scene.dim, scene.file), (3, str(file)))
        self.assertIsInstance(bracket.read_scene(scenes.SCENES / "patch.toml"), bracket.Scene)
        outcome = bracket.run(scene)
        self.assertIsInstance(outcome, bracket.space.Outcome)
        self.assertEqual((outcome.status, outcome.guarantee), ("done", "rounding-safe"))
        self.assertLessEqual(outcome.lower, 50)  # docs/verification.md
        self.assertGreaterEqual(outcome.upper, 50)
        self.assertEqual(json.loads(outcome.json())["dim"], 3)

    def test_of_a_block_hold_what_statics_says(self):
        outcome = bracket.run(on_a_wall())
        push = outcome.quantity("push")  # the wall alone bears the load across it
        self.assertLessEqual(push.lower, 1.25)
        self.assertGreaterEqual(push.upper, 1.25)
        self.assertLess(push.upper - push.lower, 1e-6)
        force, moment = outcome.resultant("block.top")
        numpy.testing.assert_allclose(force, [0.05, -1.25, 0], atol=1e-12)
        # The middle of the load is at x = ∫ x (1 + x/2) / 1.25, z = ½, y = 2.
        x = (1 / 2 + 1 / 6) / 1.25
        numpy.testing.assert_allclose(moment, numpy.cross([x, 2, 0.5], [0, -1.25, 0]) +
                                      numpy.cross([0.5, 2, 0.5], [0.05, 0, 0]), atol=1e-12)
        about = outcome.resultant("block.top", about=(x, 2, 0.5))[1]
        numpy.testing.assert_allclose(about, numpy.cross([0.5 - x, 0, 0], [0.05, 0, 0]), atol=1e-12)

    def test_do_not_know_whether_the_mesh_is_given(self):
        blocks = bracket.run(on_a_wall())
        vertices, cells, parts = cubes(2)
        for given in (cells, cells[:, ::-1], cells.astype(numpy.uint16).tolist()):
            scene = on_a_wall(with_block=False)
            scene.set_mesh(vertices, given, bodies={"block": range(len(cells))}, parts=parts)
            outcome = bracket.run(scene)
            self.assertAlmostEqual(outcome.upper, blocks.upper, delta=1e-12 * abs(blocks.upper))
            # The stresses are built in the order of vertices, which is another one.
            self.assertLessEqual(max(outcome.lower, blocks.lower), min(outcome.upper, blocks.upper))
            self.assertTrue(any("inside out" in note for note in outcome.mesh.notes))  # every second one

    def test_of_callables_are_told_to_be_sampled(self):
        exact = on_a_wall()
        sampled = copy.copy(exact)
        sampled.set_traction("block.top", 0.05, lambda x, y, z: -(1 + x / 2), 0)
        expected, outcome = bracket.run(exact), bracket.run(sampled)
        self.assertEqual((expected.guarantee, outcome.guarantee), ("rounding-safe", "discretisation"))
        self.assertIn("sampled", str(outcome))
        self.assertEqual([outcome.lower, outcome.upper], [expected.lower, expected.upper])

    def test_of_a_plane_are_those_of_a_wall(self):
        wall = bracket.run(on_a_wall())
        scene = on_a_wall()
        plane = bracket.space.Scene()
        plane.add_block("block", x=(0, 1), y=(0, 2), z=(0, 1), cells=(2, 4, 2))
        plane.add_body("block", E=1000, nu=0.3)
        for part in ("block.left", "block.back"):
            plane.set_sliding(part, 0)
        plane.set_traction("block.top", 0.05, "-(1 + x / 2)", 0)
        plane.add_contact("block.bottom", bracket.space.Plane(point=(5, 0, 5), normal=(0, 2, 0)))
        outcome = bracket.run(plane)
        self.assertEqual([outcome.lower, outcome.upper], [wall.lower, wall.upper])
        self.assertEqual(outcome.contacts[0].second, "a plane")
        stiff = on_a_wall()
        a, b, c = 1000 * 0.7 / (1.3 * 0.4), 1000 * 0.3 / (1.3 * 0.4), 1000 / 2.6
        matrix = numpy.diag([a, a, a, c, c, c])
        matrix[:3, :3] += b * (1 - numpy.eye(3))
        stiff.add_body("block", stiffness=matrix)
        self.assertAlmostEqual(bracket.run(stiff).upper, wall.upper, delta=1e-12 * abs(wall.upper))


class Runs(unittest.TestCase):
    def test_tell_of_each_level_and_end_where_they_are_told(self):
        scene = on_a_wall()
        scene.set_refine(strategy="adaptive", max_levels=9)
        told = []

        def follow(so_far):
            told.append(so_far)
            return len(so_far.levels) < 3

        outcome = bracket.run(scene, follow)
        self.assertEqual([len(one.levels) for one in told], [1, 2, 3])
        self.assertEqual((outcome.status, len(outcome.levels)), ("budget_spent", 3))
        self.assertEqual([len(one.mesh.cells) for one in told], [level.cells for level in outcome.levels])

        def failing(so_far):
            raise LookupError

        with self.assertRaises(LookupError):
            bracket.run(scene, failing)


class Fields(unittest.TestCase):
    def test_have_shapes_by_their_degree(self):
        for degree in (1, 2):
            scene = on_a_wall()
            scene.set_solve(degree=degree, sweeps=2)
            outcome = bracket.run(scene)
            mesh, u, stress = outcome.mesh, outcome.displacement, outcome.stress
            n, m, k = len(mesh.vertices), len(mesh.cells), len(mesh.edges)
            self.assertEqual((u.degree, stress.degree), (degree, 1))
            self.assertEqual((mesh.vertices.shape, mesh.cells.shape, mesh.cell_edges.shape), ((n, 3), (m, 4), (m, 6)))
            self.assertEqual(u.vertex.shape, (n, 3))
            self.assertEqual(u.edge.shape, (k if degree > 1 else 0, degree - 1, 3))
            self.assertEqual(stress.coefficients.shape, (m, 4, 4, 6))
            self.assertEqual(outcome.indicator.shape, (m,))
            (contact,) = outcome.contacts
            faces = len(mesh.parts["block.bottom"])
            self.assertEqual([one.shape for one in (contact.points, contact.pressure, contact.gap)],
                             [(faces, 3, 3), (faces, 3), (faces, 6)])

    def test_have_their_values_where_they_are_said_to_be(self):
        outcome = bracket.run(on_a_wall())
        mesh, u, stress = outcome.mesh, outcome.displacement, outcome.stress
        size = abs(u.vertex).max()
        self.assertLess(abs(outcome.values_at(mesh.vertices)[0] - u.vertex).max(), 1e-13 * size)
        a, b = mesh.vertices[mesh.edges.T]
        self.assertLess(abs(outcome.values_at((a + b) / 2)[0] - u.edge[:, 0]).max(), 1e-13 * size)
        corners = mesh.vertices[mesh.cells]
        weights = numpy.array([0.3, 0.2, 0.1, 0.4])  # of a point inside of a part
        for part, face in enumerate(FACES):
            points = [corners[:, i] for i in face] + [corners.mean(axis=1)]
            _, values = outcome.values_at(sum(w * x for w, x in zip(weights, points)))
            expected = numpy.tensordot(stress.coefficients[:, part], weights, ([1], [0]))
            self.assertLess(abs(values - expected).max(), 1e-12 * abs(stress.coefficients).max())
        displacement, values = outcome.values_at([[0.5, 0.5, 0.5], [3, 3, 3]])
        numpy.testing.assert_array_equal(numpy.isnan(displacement), [[False] * 3, [True] * 3])
        numpy.testing.assert_array_equal(numpy.isnan(values), [[False] * 6, [True] * 6])

    def test_of_contact_belong_to_the_force(self):
        contact = bracket.run(on_a_wall()).contacts[0]
        self.assertEqual((contact.name, contact.first, contact.second), ("wall", "block.bottom", "a rigid wall"))
        sides = contact.points[:, 1:] - contact.points[:, :1]
        areas = numpy.linalg.norm(numpy.cross(sides[:, 0], sides[:, 1]), axis=1) / 2
        self.assertAlmostEqual(areas.sum(), contact.area, delta=1e-14)
        self.assertAlmostEqual((areas * contact.pressure.mean(axis=1)).sum(), contact.force[1], delta=1e-13)
        self.assertLessEqual(contact.pressed_area, contact.area)
        self.assertGreaterEqual(contact.pressure.min(), 0)
        self.assertEqual((contact.force.shape, contact.at.shape), ((3,), (3,)))

    def test_of_a_mesh_hang_together(self):
        scene = on_a_wall()
        mesh = scene.mesh()
        sides = mesh.vertices[mesh.cells][:, 1:] - mesh.vertices[mesh.cells][:, :1]
        self.assertAlmostEqual(numpy.linalg.det(sides).sum() / 6, 2, delta=1e-13)
        self.assertTrue((numpy.linalg.det(sides) > 0).all())
        for k, ends in enumerate(EDGES):
            numpy.testing.assert_array_equal(mesh.edges[mesh.cell_edges[:, k]], numpy.sort(mesh.cells[:, ends], axis=1))
        top = mesh.vertices[mesh.parts["block.top"]]
        normals = numpy.cross(top[:, 1] - top[:, 0], top[:, 2] - top[:, 0]) / 2
        numpy.testing.assert_allclose(normals.sum(axis=0), [0, 1, 0], atol=1e-14)  # outward
        self.assertGreater(len(scene.mesh(1).cells), len(mesh.cells))
        with self.assertRaisesRegex(bracket.Error, "more cells than refine.max_cells"):
            scene.set_refine(max_cells=100)
            scene.mesh(1)


class Errors(unittest.TestCase):
    def test_tell_file_and_line(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "scene.toml"
            text = (scenes.SCENES / "space" / "patch.toml").read_text()
            file.write_text(re.sub(r"(?m)^nu *= *[0-9.]+", "nu = 0.7", text))
            line = 1 + file.read_text()[: file.read_text().index("nu = 0.7")].count("\n")
            with self.assertRaises(bracket.Error) as raised:
                bracket.read_scene(file)
            self.assertEqual((raised.exception.file, raised.exception.line, raised.exception.status),
                             (str(file), line, "input_error"))

    def test_of_arguments_and_scenes(self):
        scene = on_a_wall()
        vertices, cells, parts = cubes(1)

        def on_mesh(vertices=vertices, cells=cells, parts=parts):
            made = on_a_wall(with_block=False)
            made.set_mesh(vertices, cells, bodies={"block": range(len(cells))}, parts=parts)
            return bracket.run(made)

        for wrong, kind, named in (
            (lambda: bracket.space.Scene(plane="strain"), TypeError, ""),
            (lambda: scene.set_fixed("a", 0, 0), TypeError, ""),
            (lambda: scene.set_fixed("a", 0, 0, None), TypeError, r"x, y and z, or a callable f\(x, y, z\)"),
            (lambda: scene.set_pressure("a", "w"), bracket.Error, "Known: x, y, z"),
            (lambda: scene.add_body("a", stiffness=numpy.eye(3)), TypeError, ""),
            (lambda: scene.add_body("a", E=1, nu=0.7), bracket.Error, "nu"),
            (lambda: scene.add_contact("a", bracket.Line((0, 0), (0, 1))), TypeError, "second must be"),
            (lambda: scene.add_quantity("q", "rotation", "block.top"), ValueError, "direction"),
            (lambda: scene.add_quantity("q", "rotation", "block.top", direction="normal"), ValueError, "direction"),
            (lambda: scene.add_quantity("q", "displacement", "a", direction=(1, 2)), TypeError, ""),
            (lambda: scene.add_quantity("q", "stress", "block"), ValueError, "zz"),
            (lambda: scene.set_solve(degree="low"), ValueError, "1 to 2"),
            (lambda: bracket.run(scene).values_at([[1, 2]]), ValueError, r"\(n, 3\)"),
            (lambda: bracket.run(scene).resultant("none"), bracket.Error, "none"),
            (lambda: on_mesh(vertices=vertices[:, :2]), ValueError, r"vertices must have the shape \(n, 3\)"),
            (lambda: on_mesh(cells=cells[:, :3]), ValueError, r"cells must have the shape \(n, 4\)"),
            (lambda: on_mesh(parts={"block.top": [[0, 1]]}), ValueError, r"parts\['block.top'\]"),
            (lambda: on_mesh(cells=cells + 1), bracket.Error, "has the vertex 12; expected 0 to 11"),
            (lambda: on_mesh(cells=cells[:0]), bracket.Error, "no tetrahedra"),
            (lambda: on_mesh(parts={**parts, "block.top": [[0, 5, 11]]}), bracket.Error, "block.top"),
        ):
            with self.subTest(named), self.assertRaisesRegex(kind, named):
                wrong()

    def test_of_what_space_does_not_have(self):
        for change, named in (
            (lambda one: one.set_solve(degree=3), "degree"),
            (lambda one: one.add_contact("block.right", "rigid", law="winkler"), "law"),
            (lambda one: one.add_quantity("q", "slip", "wall"), "slip"),
            (lambda one: one.add_quantity("q", "rotation", "block.top", direction=(1, 1, 0)), "axis"),
        ):
            scene = on_a_wall()
            change(scene)
            with self.subTest(named), self.assertRaisesRegex(bracket.Error, named) as raised:
                bracket.run(scene)
            self.assertNotIn("\n", str(raised.exception))


class Assess(unittest.TestCase):
    def test_judges_arrays(self):
        scene = on_a_wall()
        own = bracket.run(scene)
        mesh, u = own.mesh, own.displacement
        place = {ends: k for k, ends in enumerate(EDGES)}
        order = [place.get(ends, place.get(ends[::-1])) for ends in MIDDLES]
        nodes = numpy.concatenate([mesh.vertices, mesh.vertices[mesh.edges].mean(axis=1)])
        cells = numpy.concatenate([mesh.cells, len(mesh.vertices) + mesh.cell_edges[:, order]], axis=1)
        scene.set_refine(strategy="adaptive", max_cells=1500)
        judged = bracket.assess(scene, nodes, numpy.concatenate([u.vertex, u.edge[:, 0]]), cells=cells)
        self.assertIsInstance(judged, bracket.space.Assessment)
        self.assertEqual(judged.guarantee, "rounding-safe")
        lower, upper = judged.error
        self.assertTrue(0 <= lower < upper <= math.sqrt(2 * (own.upper - own.lower)) * (1 + 1e-9))
        self.assertEqual(judged.cell.shape, (len(mesh.cells),))
        self.assertFalse(judged.interpolated)
        self.assertIn("guaranteed error", str(judged))
        linear = bracket.assess(scene, mesh.vertices, u.vertex, cells=mesh.cells)
        self.assertEqual(linear.displacement.degree, 1)
        self.assertGreater(linear.error[1], upper)
        self.assertGreater(linear.error[0], lower)
        self.assertRegex(linear._repr_html_(), "data:image/svg")
        with self.assertRaisesRegex(ValueError, r"\(n, 4 or 10\)"):
            bracket.assess(scene, nodes, nodes, cells=cells[:, :3])
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "u.csv"
            table = numpy.concatenate([mesh.vertices, u.vertex], axis=1)
            numpy.savetxt(file, table, fmt="%.17g", delimiter=",", header="x,y,z,ux,uy,uz", comments="")
            scene.set_solve(degree=1)  # the vertices may be those of coarser quadratic cells, too
            self.assertEqual(bracket.assess_file(scene, file).error, linear.error)


class Notebook(unittest.TestCase):
    def test_shows_the_first_lines_and_the_surface(self):
        outcome = bracket.run(on_a_wall())
        html = outcome._repr_html_()
        self.assertRegex(html, r"^<pre>[^<]+</pre><img")
        self.assertIn("push", html)
        self.assertGreater(outcome.html().count("<svg"), 2)
        self.assertIn("space.Outcome done", repr(outcome))


if __name__ == "__main__":
    unittest.main()
