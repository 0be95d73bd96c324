# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
import copy
import json
import pathlib
import tempfile
import unittest

import bracket
import numpy

import scenes

SCENE = """schema = 1
[[mesh.block]]
body = "block"
x = [0, 1]
y = [0, 1]
cells = [2, 2]
[bodies.block]
E = 1
nu = 0.7
"""


class Errors(unittest.TestCase):
    def test_tell_file_and_line(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "scene: 7.toml"
            file.write_text(SCENE)
            with self.assertRaises(bracket.Error) as raised:
                bracket.read_scene(file)
            error = raised.exception
            self.assertEqual((error.file, error.line, error.status), (str(file), 9, "input_error"))
            self.assertIn("nu", error.message)
            self.assertNotIn(folder, error.message)
            self.assertEqual(str(error), f"{file}:9:6: {error.message}")

            with self.assertRaises(bracket.Error) as raised:
                bracket.read_scene(file, ["bodies.block.nu=0.8"])
            self.assertEqual((raised.exception.file, raised.exception.line), (None, None))
            self.assertTrue(str(raised.exception).startswith("--set bodies.block.nu=0.8: "))

            missing = pathlib.Path(folder) / "missing.toml"
            with self.assertRaises(bracket.Error) as raised:
                bracket.read_scene(str(missing))
            self.assertEqual((raised.exception.file, raised.exception.line), (str(missing), None))

            mesh = pathlib.Path(folder) / "mesh.msh"
            mesh.write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
            file.write_text('schema = 1\nmesh.file = "mesh.msh"\nbodies.block = {E = 1, nu = 0}\n')
            with self.assertRaises(bracket.Error) as raised:
                bracket.run(bracket.read_scene(file))
            self.assertEqual((raised.exception.file, raised.exception.status), (str(mesh), "mesh_error"))

    def test_of_scenes_in_code_have_no_file(self):
        def refused(change, *named, status="input_error"):
            scene = scenes.square()
            change(scene)
            with self.assertRaises(bracket.Error) as raised:
                bracket.run(scene)
            error = raised.exception
            self.assertEqual((error.file, error.line, error.status, error.message), (None, None, status, str(error)))
            for name in named:
                self.assertIn(name, str(error))
            self.assertNotIn("\n", str(error))

        refused(lambda scene: scene.set_pressure("block.tpo", 1), "block.tpo", "did you mean 'block.top'")
        refused(lambda scene: scene.add_block("block", (2, 1), (0, 1), (1, 1)), "block", "empty")
        refused(lambda scene: scene.set_refine(target=-1), "refine.target")
        refused(lambda scene: scene.set_solve(degree=9), "solve.degree")
        refused(lambda scene: scene.add_quantity("q", "force", "nowhere"), "no contact 'nowhere'", "block.bottom")
        refused(lambda scene: scene.set_pressure("block.top", lambda x, y: float("nan")), "not finite")
        refused(lambda scene: scene.set_pressure("block.top", -1), "block", status="ill_posed")
        refused(lambda scene: scene.set_mesh(*scenes.grid(2, 0)[:2]), "mesh")

    def test_of_expressions_come_at_once(self):
        scene = bracket.Scene()
        with self.assertRaisesRegex(bracket.Error, "sinn.*did you mean 'sin'"):
            scene.set_pressure("part", "sinn(x)")
        with self.assertRaisesRegex(bracket.Error, "E must be > 0"):
            scene.add_body("body", E=-1, nu=0)
        with self.assertRaises(bracket.Error):
            scene.add_body("body", stiffness=[[1, 2, 0], [2, 1, 0], [0, 0, 1]])


class Meshes(unittest.TestCase):
    def run_on(self, vertices, cells, **sets):
        scene = bracket.Scene()
        scene.add_body("body", E=1, nu=0.3)
        scene.set_mesh(vertices, cells, **sets)
        scene.set_fixed("bottom", 0, 0)
        scene.set_pressure("top", 1)
        return bracket.run(scene)

    def setUp(self):
        self.vertices, self.cells, self.parts = scenes.grid(3, 0)

    def test_may_be_any_arrays(self):
        expected = self.run_on(self.vertices, self.cells, parts=self.parts)
        wide = numpy.zeros((2 * len(self.vertices), 5))
        wide[::2, 1:4:2] = self.vertices
        strided = wide[::2, 1:4:2]
        self.assertFalse(strided.flags.c_contiguous)
        read_only = self.vertices.copy()
        read_only.flags.writeable = False
        same = [
            (strided, self.cells),
            (numpy.asfortranarray(self.vertices), numpy.asfortranarray(self.cells)),
            (self.vertices.astype(">f8"), self.cells.astype(">i4")),
            (self.vertices.tolist(), self.cells.tolist()),
            (read_only, self.cells.astype(numpy.uint16)),
            (numpy.flipud(numpy.flipud(self.vertices)), self.cells[:, [1, 2, 0]]),
        ]
        for vertices, cells in same:
            outcome = self.run_on(vertices, cells, parts=self.parts)
            self.assertAlmostEqual(outcome.upper, expected.upper, delta=1e-13 * abs(expected.upper))
        clockwise = self.run_on(self.vertices, self.cells[:, ::-1], parts=self.parts)
        self.assertAlmostEqual(clockwise.upper, expected.upper, delta=1e-13 * abs(expected.upper))
        self.assertTrue(any("clockwise" in note for note in clockwise.mesh.notes))

    def test_of_wrong_shapes_or_types_are_refused(self):
        vertices, cells, parts = self.vertices, self.cells, self.parts
        for wrong, kind, named in (
            (lambda: self.run_on(vertices[:, :1], cells), ValueError, r"vertices must have the shape \(n, 2\), has \(16, 1\)"),
            (lambda: self.run_on(vertices.ravel(), cells), ValueError, r"vertices .* has \(32,\)"),
            (lambda: self.run_on(vertices, cells[:, :2]), ValueError, r"cells must have the shape \(n, 3\)"),
            (lambda: self.run_on(vertices, cells.astype(float)), TypeError, "cells must be an array of integers"),
            (lambda: self.run_on(vertices + 0j, cells), TypeError, "vertices must be an array of real numbers"),
            (lambda: self.run_on(vertices.astype(str), cells), TypeError, "real numbers"),
            (lambda: self.run_on(vertices.astype(object), cells), TypeError, "real numbers"),
            (lambda: self.run_on([[0, 1], [2]], cells), ValueError, ""),
            (lambda: self.run_on(None, cells), TypeError, ""),
            (lambda: self.run_on(vertices, cells, parts={"top": [1, 2, 3]}), ValueError, r"parts\['top'\]"),
            (lambda: self.run_on(vertices, cells, bodies={"body": [[1]]}), ValueError, r"bodies\['body'\]"),
            (lambda: self.run_on(vertices, cells, parts=[1]), TypeError, ""),
            (lambda: self.run_on(vertices, cells + 2**40), ValueError, "out of range"),
        ):
            with self.subTest(named), self.assertRaisesRegex(kind, named):
                wrong()

    def test_that_do_not_hang_together_are_refused(self):
        vertices, cells, parts = self.vertices, self.cells, self.parts
        hole = vertices.copy()
        hole[0, 0] = numpy.nan
        for wrong, named in (
            (lambda: self.run_on(vertices, cells + 1, parts=parts), "the cell .* has the vertex 16; expected 0 to 15"),
            (lambda: self.run_on(vertices, cells - 1, parts=parts), "has the vertex -1"),
            (lambda: self.run_on(hole, cells, parts=parts), "a coordinate of the vertex 0 must be finite"),
            (lambda: self.run_on(vertices * 0, cells, parts=parts), "degenerate"),
            (lambda: self.run_on(vertices, cells[[0, 0]], parts=parts), "."),
            (lambda: self.run_on(numpy.zeros((0, 2)), numpy.zeros((0, 3), int)), "no triangles"),
            (lambda: self.run_on(vertices, cells, parts={**parts, "top": [[0, 15]]}), "no edge of the mesh"),
            (lambda: self.run_on(vertices, cells, parts={"top": [[0, 99]]}), "the part 'top' has the vertex 99"),
            (lambda: self.run_on(vertices, cells, bodies={"body": [99]}), "the body 'body' has the cell 99"),
            (lambda: self.run_on(vertices, cells, bodies={"body": [0]}, parts=parts), "the cell 1 is in no cell set"),
            (lambda: self.run_on(vertices, cells, bodies={"other": range(18)}, parts=parts), "no body 'body'"),
            (lambda: self.run_on(vertices, cells), "no boundary part 'bottom'"),
        ):
            with self.subTest(named), self.assertRaisesRegex(bracket.Error, named):
                wrong()


class Arguments(unittest.TestCase):
    def test_that_make_no_sense_are_refused(self):
        scene = scenes.square()
        for wrong, kind in (
            (lambda: bracket.Scene(plane="strian"), ValueError),
            (lambda: bracket.Scene(titel="a"), TypeError),
            (lambda: scene.add_body("a"), ValueError),
            (lambda: scene.add_body("a", E=1), ValueError),
            (lambda: scene.add_body("a", E=1, nu=0, stiffness=numpy.eye(3)), ValueError),
            (lambda: scene.add_body("a", stiffness=numpy.eye(2)), TypeError),
            (lambda: scene.set_fixed("a", None, 0), TypeError),
            (lambda: scene.set_fixed("a", True, 0), TypeError),
            (lambda: scene.set_pressure("a", [1, 2]), TypeError),
            (lambda: scene.set_pressure("a", 1j), TypeError),
            (lambda: scene.set_pressure(3, 1), TypeError),
            (lambda: scene.add_contact("a", 5), TypeError),
            (lambda: scene.add_contact("a", [5]), TypeError),
            (lambda: scene.add_quantity("q", "displacment", "a"), ValueError),
            (lambda: scene.add_quantity("q", "displacement", "a"), ValueError),
            (lambda: scene.add_quantity("q", "displacement", "a", direction="up"), ValueError),
            (lambda: scene.add_quantity("q", "displacement", "a", direction=(1, 2, 3)), TypeError),
            (lambda: scene.add_quantity("q", "force", "a", direction=(1, 0)), ValueError),
            (lambda: scene.add_quantity("q", "stress", "a"), ValueError),
            (lambda: scene.add_curve("a", center=(0, 0)), ValueError),
            (lambda: scene.set_refine(strategy="adaptiv"), ValueError),
            (lambda: scene.set_solve(degree="automatic"), ValueError),
            (lambda: scene.set_solve(degree=2.5), TypeError),
            (lambda: scene.mesh(-1), ValueError),
            (lambda: bracket.run(None), TypeError),
            (lambda: bracket.run(scene, 5), TypeError),
            (lambda: bracket.run(scene).quantity("none"), KeyError),
            (lambda: bracket.run(scene).values_at([1, 2]), ValueError),
            (lambda: bracket.run(scene).resultant("none"), bracket.Error),
            (lambda: scene.mesh(20), bracket.Error),
        ):
            with self.assertRaises(kind):
                wrong()

    def test_of_a_callable_raise_what_it_raises(self):
        def failing(x, y):
            raise LookupError("here")

        for wrong, kind in ((failing, LookupError), (lambda x: 1, TypeError), (lambda x, y: "a", TypeError)):
            scene = scenes.square()
            scene.set_pressure("block.top", wrong)
            with self.assertRaises(kind):
                bracket.run(scene)

    def test_of_the_degree_may_be_left_to_the_scene(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        file = pathlib.Path(folder.name) / "scene.toml"
        for target, cells in ((0, 4), (0.01, 4), (1e-6, 4), (0.01, 32), (1e-4, 32)):
            scene = scenes.square()
            scene.set_refine(target=target, strategy="adaptive", max_levels=2)
            scene.add_block("far", (5, 6), (0, 1), (cells, cells))
            scene.add_body("far", E=1000, nu=0.3)
            scene.set_fixed("far.left", 0, 0)
            scene.set_pressure("far.top", 1)
            scene.set_solve(degree="auto")
            file.write_text(f"""schema = 1
mesh.block = [{{ body = "block", x = [0, 1], y = [0, 1], cells = [4, 4] }},
              {{ body = "far", x = [5, 6], y = [0, 1], cells = [{cells}, {cells}] }}]
bodies.block = {{ E = 1000, nu = 0.3 }}
bodies.far = {{ E = 1000, nu = 0.3 }}
[boundary]
"block.left" = {{ sliding = 0 }}
"block.top" = {{ pressure = 1 }}
"far.left" = {{ fixed = [0, 0] }}
"far.top" = {{ pressure = 1 }}
[[contact]]
first = "block.bottom"
second = "rigid"
[refine]
strategy = "adaptive"
max_levels = 2
target = {target}
[solve]
degree = "auto"
""")
            ours, read = (json.loads(bracket.run(one).json()) for one in (scene, bracket.read_scene(file)))
            self.assertEqual(ours["degree"], read["degree"], (target, cells))
            # The same bulk marks the same cells.
            self.assertEqual([one["cells"] for one in ours["levels"]], [one["cells"] for one in read["levels"]])
        scene = scenes.square(dual="uzawa")
        scene.set_refine(target=1e-6)
        scene.set_solve(degree="auto")  # blocks of linear stresses
        scene.check()

    def test_of_obstacles_and_arcs_are_taken(self):
        scene = scenes.square()
        wall = bracket.Line(point=(0, 0), normal=(0, 1))
        other = bracket.Scene()
        other.add_block("block", x=(0, 1), y=(0, 1), cells=(4, 4))
        other.add_body("block", E=1000, nu=0.3)
        other.set_sliding("block.left", 0)
        other.set_pressure("block.top", 1)
        other.add_contact("block.bottom", wall)
        self.assertAlmostEqual(bracket.run(other).upper, bracket.run(scene).upper, delta=1e-15)
        scene.add_contact("block.right", bracket.Circle((3, 0.5), 2))
        self.assertEqual(bracket.run(scene).contacts[1].second, "a circle")

    def test_are_not_changed_by_a_copy(self):
        scene = scenes.square()
        other = copy.copy(scene)
        other.set_pressure("block.top", 2)
        self.assertAlmostEqual(bracket.run(other).upper, 4 * bracket.run(scene).upper, delta=1e-15)


if __name__ == "__main__":
    unittest.main()
