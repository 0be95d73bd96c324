# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
import gc
import unittest

import bracket
import numpy

import scenes


class Fields(unittest.TestCase):
    def test_have_shapes_by_their_degree(self):
        for degree in (1, 2, 3, 4):
            outcome = bracket.run(scenes.square(degree=degree))
            mesh, u, stress = outcome.mesh, outcome.displacement, outcome.stress
            n, m, k = len(mesh.vertices), len(mesh.cells), len(mesh.edges)
            self.assertEqual((u.degree, stress.degree), (degree, max(1, degree - 1)))
            self.assertEqual(u.vertex.shape, (n, 2))
            self.assertEqual(u.edge.shape, (k if degree > 1 else 0, degree - 1, 2))
            inside = (degree - 1) * (degree - 2) // 2
            self.assertEqual(u.cell.shape, (m if inside else 0, inside, 2))
            coefficients = (stress.degree + 1) * (stress.degree + 2) // 2
            self.assertEqual(stress.coefficients.shape, (m, 3, coefficients, 3))
            self.assertEqual(outcome.indicator.shape, (m,))
            for array in (u.vertex, stress.coefficients, outcome.indicator):
                self.assertEqual(array.dtype, numpy.float64)

    def test_have_their_values_where_they_are_said_to_be(self):
        for degree in (1, 2, 3, 4):
            outcome = bracket.run(scenes.square(degree=degree))
            mesh, u = outcome.mesh, outcome.displacement
            size = abs(u.vertex).max()
            at_vertices, _ = outcome.values_at(mesh.vertices)
            self.assertLess(abs(at_vertices - u.vertex).max(), 1e-13 * size)
            a, b = mesh.vertices[mesh.edges.T]
            for i in range(degree - 1):
                t = (i + 1) / degree
                values, _ = outcome.values_at((1 - t) * a + t * b)
                self.assertLess(abs(values - u.edge[:, i]).max(), 1e-13 * size)
            corners = mesh.vertices[mesh.cells]
            inside = {3: [(1, 1, 1)], 4: [(2, 1, 1), (1, 2, 1), (1, 1, 2)]}.get(degree, [])
            for i, place in enumerate(inside):
                values, _ = outcome.values_at(numpy.tensordot(corners, numpy.array(place) / degree, ([1], [0])))
                self.assertLess(abs(values - u.cell[:, i]).max(), 1e-13 * size)

    def test_of_stress_are_bernstein_coefficients_on_parts_of_cells(self):
        outcome = bracket.run(scenes.with_blocks(scenes.two_blocks()))
        stress, corners = outcome.stress, outcome.mesh.vertices[outcome.mesh.cells]
        size = abs(stress.coefficients).max()
        centre = corners.mean(axis=1)
        weights = numpy.array([0.3, 0.25, 0.45])  # of a point inside of a part
        for part in range(3):
            ends = corners[:, (part + 1) % 3], corners[:, (part + 2) % 3]
            _, values = outcome.values_at(weights[0] * ends[0] + weights[1] * ends[1] + weights[2] * centre)
            expected = numpy.tensordot(stress.coefficients[:, part], weights, ([1], [0]))  # of degree 1
            self.assertLess(abs(values - expected).max(), 1e-12 * size)

    def test_of_contact_belong_to_the_force(self):
        outcome = bracket.run(scenes.square(degree=3))
        contact = outcome.contacts[0]
        lengths = numpy.linalg.norm(contact.points[:, 1] - contact.points[:, 0], axis=1)
        self.assertAlmostEqual((lengths * contact.pressure.mean(axis=1)).sum(), contact.force[1], delta=1e-13)
        self.assertAlmostEqual(contact.force[1], 1, delta=1e-12)  # the pressure 1 on the length 1
        self.assertGreaterEqual(contact.pressure.min(), 0)
        self.assertLess(abs(contact.gap).max(), 1e-15)
        force, moment = outcome.resultant("block.top")
        self.assertAlmostEqual(force[1], -1, delta=1e-12)
        self.assertAlmostEqual(moment, -0.5, delta=1e-12)

    def test_outlive_and_leave_alone_whom_they_come_from(self):
        outcome = bracket.run(scenes.square())
        vertices, values = outcome.mesh.vertices, outcome.displacement.vertex
        before = values.copy()
        vertices[:] = numpy.nan
        values[0] = 7
        numpy.testing.assert_array_equal(outcome.displacement.vertex, before)
        self.assertTrue(numpy.isfinite(outcome.mesh.vertices).all())
        mesh, displacement = outcome.mesh, outcome.displacement
        del outcome
        gc.collect()
        numpy.testing.assert_array_equal(displacement.vertex, before)
        self.assertEqual(mesh.cells.max() + 1, len(mesh.vertices))

    def test_are_nowhere_outside_of_the_bodies(self):
        outcome = bracket.run(scenes.square())
        displacement, stress = outcome.values_at([[0.5, 0.5], [3, 3]])
        numpy.testing.assert_array_equal(numpy.isnan(displacement), [[False] * 2, [True] * 2])
        numpy.testing.assert_array_equal(numpy.isnan(stress), [[False] * 3, [True] * 3])
        self.assertEqual(outcome.values_at(numpy.zeros((0, 2)))[1].shape, (0, 3))

    def test_of_a_mesh_hang_together(self):
        mesh = scenes.with_blocks(scenes.two_blocks()).mesh()
        corners = mesh.vertices[mesh.cells]
        sides = corners[:, 1:] - corners[:, :1]
        self.assertTrue((numpy.linalg.det(sides) > 0).all())
        for k in range(3):
            ends = numpy.sort(mesh.cells[:, [(k + 1) % 3, (k + 2) % 3]], axis=1)
            numpy.testing.assert_array_equal(mesh.edges[mesh.cell_edges[:, k]], ends)
        self.assertEqual(mesh.bodies, ["lower", "upper"])
        self.assertEqual(mesh.parts["upper.top"].shape, (4, 2))
        self.assertTrue((mesh.vertices[mesh.parts["upper.top"]][..., 1] == 2).all())
        along = numpy.diff(mesh.vertices[mesh.parts["upper.top"]][..., 0], axis=1)
        self.assertTrue((along < 0).all())  # the body is to the left
        self.assertEqual(len(scenes.with_blocks(scenes.two_blocks()).mesh(2).cells), 16 * len(mesh.cells))


if __name__ == "__main__":
    unittest.main()
