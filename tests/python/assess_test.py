# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
import json
import unittest

import bracket
import numpy

import scenes


def nodes_of(mesh, degree):
    """Nodes and cells as other programs have them."""
    if degree == 1:
        return mesh.vertices, mesh.cells
    middles = mesh.vertices[mesh.edges].mean(axis=1)
    sides = len(mesh.vertices) + mesh.cell_edges[:, [2, 0, 1]]  # behind corner 0, 1, 2
    return numpy.concatenate([mesh.vertices, middles]), numpy.concatenate([mesh.cells, sides], axis=1)


class Assess(unittest.TestCase):
    def judged(self, degree, refinements, **options):
        """Bracket's own displacements of a degree on a coarse mesh, as if they were another program's."""
        scene = scenes.with_blocks(scenes.two_blocks())
        scene.set_refine(strategy="uniform", target=0, max_levels=refinements + 1)
        scene.set_solve(degree=degree)
        coarse = bracket.run(scene)
        nodes, cells = nodes_of(coarse.mesh, degree)
        u = coarse.displacement
        values = numpy.concatenate([u.vertex, u.edge.reshape(-1, 2)])
        scene.set_refine(strategy="adaptive", max_levels=30)
        return coarse, bracket.assess(scene, nodes, values, cells=cells, **options)

    def test_bounds_the_error_of_a_given_field(self):
        for degree, refinements in ((1, 1), (2, 0)):
            coarse, judged = self.judged(degree, refinements)
            self.assertEqual((judged.status, judged.guarantee), ("done", "rounding-safe"))
            # L is known to much less than this error: |u_h - u|^2 <= 2 (L(u_h) - L(u)), which for the fields of a run
            # is an equality but for the work of the contact.
            exact = -0.00156588566
            lower, upper = judged.error
            self.assertLessEqual(lower, numpy.sqrt(2 * (coarse.levels[-1].upper - exact)))
            self.assertGreater(lower, 0.5 * upper)
            self.assertLess(judged.penetration, 1e-15)
            self.assertEqual(judged.displacement.degree, degree)
            self.assertEqual(judged.cell.shape, (len(judged.mesh.cells),))
            self.assertFalse(judged.interpolated)
            self.assertAlmostEqual(numpy.sqrt(judged.cell.sum()), 0.5 * (lower + upper), delta=0.1 * upper)
            self.assertIn("guaranteed error", str(judged))
            self.assertEqual(json.loads(judged.json())["status"], "done")

    def test_is_that_of_the_file(self):
        file = scenes.FIELDS / "calculix.frd"
        scene = bracket.read_scene(scenes.SCENES / "two_blocks.toml")
        judged = bracket.assess_file(scene, file)
        lower, upper = judged.relative
        self.assertTrue(0.1298 < lower < upper < 0.1306)  # docs/other-programs.md
        # The same values by their places alone, which bodies that touch need names for.
        u, mesh = judged.displacement, judged.mesh
        body = numpy.empty(len(mesh.vertices), int)
        body[mesh.cells] = mesh.cell_body[:, None]
        scene.set_solve(degree=1)  # the points are also the nodes of quadratic triangles
        by_place = bracket.assess(scene, mesh.vertices, u.vertex, bodies=[mesh.bodies[i] for i in body])
        self.assertEqual(by_place.relative, judged.relative)
        self.assertRegex(str(by_place), "note: .* taken as linear")
        self.assertNotIn("note", str(judged))
        with self.assertRaisesRegex(bracket.Error, "column 'body'|bodies touch"):
            bracket.assess(scene, mesh.vertices, u.vertex)

    def test_calls_back_and_ends(self):
        levels = []

        def stop(so_far):
            levels.append(so_far.levels[-1].cells)
            return False

        _, judged = self.judged(2, 0, progress=stop)
        self.assertEqual((len(levels), judged.status), (1, "budget_spent"))
        self.assertLess(judged.error[0], judged.error[1])

    def test_refuses_arrays_that_do_not_fit(self):
        scene = scenes.square()
        mesh = scene.mesh()
        nodes, cells = nodes_of(mesh, 1)
        values = numpy.zeros_like(nodes)
        hole = values.copy()
        hole[3, 1] = numpy.inf
        for wrong, kind, named in (
            (lambda: bracket.assess(scene, nodes, values[:-1]), bracket.Error, "has 24 values for 25 nodes"),
            (lambda: bracket.assess(scene, nodes, values[:, 0]), ValueError, "values must have the shape"),
            (lambda: bracket.assess(scene, nodes, hole), bracket.Error, "the node 3 .* expected numbers"),
            (lambda: bracket.assess(scene, nodes + 5, values), bracket.Error, "no vertex"),
            (lambda: bracket.assess(scene, nodes, values, bodies=["block"]), bracket.Error, "names of bodies"),
            (lambda: bracket.assess(scene, nodes, values, cells=cells + 1), bracket.Error, "node 25; expected 0 to 24"),
            (lambda: bracket.assess(scene, nodes, values, cells=cells[:, :2]), ValueError, "3 or 4 or 6"),
            (lambda: bracket.assess(scene, nodes[:0], values[:0]), bracket.Error, "no displacements"),
            (lambda: bracket.assess_file(scene, "missing.csv"), bracket.Error, "no such file"),
        ):
            with self.subTest(named), self.assertRaisesRegex(kind, named) as raised:
                wrong()
            if kind is bracket.Error and "file" not in named:
                self.assertIsNone(raised.exception.file)


if __name__ == "__main__":
    unittest.main()
