# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
import ctypes
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import bracket
import numpy

import scenes


def kernels():
    """The setting by which another process has the BLAS kernels of this one: the program chooses its own."""
    with open("/proc/self/maps") as maps:
        files = {line.split()[-1] for line in maps if "libopenblas" in line}
    if not files:
        return {}
    name = ctypes.CDLL(files.pop()).openblas_get_corename
    name.restype = ctypes.c_char_p
    return {"OPENBLAS_CORETYPE": name().decode()}


def report_of_program(scene, overrides):
    options = [word for line in overrides for word in ("--set", line)]
    with tempfile.TemporaryDirectory() as folder:
        command = [os.environ["BRACKET_PROGRAM"], "run", str(scene), "-o", str(pathlib.Path(folder) / "out")]
        command += ["--json", "--no-report", *options]
        run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **kernels()})
    return json.loads(run.stdout)


def without_seconds(report):
    if isinstance(report, dict):
        return {key: without_seconds(value) for key, value in report.items() if not key.startswith("seconds")}
    if isinstance(report, list):
        return [without_seconds(value) for value in report]
    return report


class Numbers(unittest.TestCase):
    def expect_equal(self, outcome, report):
        """To the last bit."""
        self.assertEqual(outcome.status, report["status"])
        self.assertEqual(outcome.guarantee, report["guarantee"])
        self.assertEqual([outcome.lower, outcome.upper], [report["energy"]["lower"], report["energy"]["upper"]])
        self.assertEqual(outcome.relative_error_bound, report["relative_error_bound"])
        of_level = ("cells", "primal_dofs", "dual_dofs", "lower", "upper", "relative_error_bound")
        self.assertEqual(
            [[getattr(level, name) for name in of_level] for level in outcome.levels],
            [[level[name] for name in of_level] for level in report["levels"]],
        )
        self.assertGreater(len(outcome.levels), 0)
        of_quantity = ("name", "kind", "lower", "upper", "weighted", "target_reached", "reason")
        self.assertEqual(
            [[getattr(one, name) for name in of_quantity] for one in outcome.quantities if one.zone < 0],
            [[one[name] for name in of_quantity] for one in report["quantities"]],
        )
        of_contact = ("name", "first", "second", "length", "pressed_length", "largest_pressure")
        self.assertEqual(
            [[getattr(contact, name) for name in of_contact] + [list(contact.at)] for contact in outcome.contacts],
            [[contact[name] for name in of_contact] + [contact["at"]] for contact in report["contact"]],
        )
        self.assertEqual(without_seconds(json.loads(outcome.json())), without_seconds(report))

    def test_are_those_of_the_program_to_the_last_bit(self):
        for name, overrides in (
            ("two_blocks", ["refine.max_levels=5"]),
            ("westergaard", ["refine.strategy=adaptive", "refine.max_levels=3", "solve.degree=3"]),
            ("linear_pressure", []),
            ("shrink_fit", ["refine.strategy=uniform", "refine.max_levels=2"]),
        ):
            with self.subTest(name):
                file = scenes.SCENES / f"{name}.toml"
                outcome = bracket.run(bracket.read_scene(file, overrides))
                self.expect_equal(outcome, report_of_program(file, overrides))

    def test_of_a_scene_in_code_are_those_of_its_file(self):
        ours = scenes.with_blocks(scenes.two_blocks())
        ours.set_refine(max_levels=5)
        theirs = bracket.read_scene(scenes.SCENES / "two_blocks.toml", ["refine.max_levels=5"])
        ours, theirs = json.loads(bracket.run(ours).json()), json.loads(bracket.run(theirs).json())
        self.assertNotEqual(ours.pop("scene"), theirs.pop("scene"))
        self.assertEqual(without_seconds(ours), without_seconds(theirs))

    def test_of_arrays_for_a_mesh_bound_the_same_energy(self):
        scene = scenes.two_blocks()
        vertices, cells, bodies, parts = scenes.two_grids(4)
        scene.set_mesh(vertices, cells, bodies=bodies, parts=parts)
        scene.set_refine(max_levels=5)
        outcome = bracket.run(scene)
        self.assertEqual(outcome.guarantee, "rounding-safe")
        # A fine computation (tests/compare): [-0.00156588569415, -0.00156588566432].
        self.assertLessEqual(outcome.lower, -0.00156588569415)
        self.assertGreaterEqual(outcome.upper, -0.00156588566432)
        # The same triangles as the blocks have, so the same first mesh.
        blocks = scenes.with_blocks(scenes.two_blocks())
        blocks.set_refine(max_levels=1)
        first = bracket.run(blocks).levels[0]
        self.assertAlmostEqual(outcome.levels[0].upper, first.upper, delta=1e-12 * abs(first.upper))
        self.assertAlmostEqual(outcome.levels[0].lower, first.lower, delta=1e-12 * abs(first.lower))

    def test_of_bodies_that_share_vertices_are_separated_by_their_contact(self):
        vertices, cells, bodies, parts = scenes.two_grids(4)
        kept, number = numpy.unique(vertices, axis=0, return_inverse=True)
        self.assertLess(len(kept), len(vertices))
        number = number.reshape(-1)
        scene = bracket.Scene()
        scene.set_mesh(
            kept,
            number[cells],
            bodies=bodies,
            parts={"bottom": number[parts["lower.bottom"]], "joint": number[parts["lower.top"]],
                   "top": number[parts["upper.top"]], "left": number[parts["upper.left"]]},
        )
        scene.add_body("lower", E=1.0, nu=0.3)
        scene.add_body("upper", E=2.0, nu=0.3)
        scene.set_fixed("bottom", 0, 0)
        scene.set_sliding("left", 0)
        scene.set_traction("top", 0, "x < 0.5 ? -0.1 : 0.09")
        scene.add_contact("joint", "joint")
        outcome = bracket.run(scene)
        self.assertEqual(len(outcome.mesh.vertices), len(vertices))
        self.assertLessEqual(outcome.lower, -0.00156588569415)
        self.assertGreaterEqual(outcome.upper, -0.00156588566432)

    def test_of_bonded_bars(self):
        scene = scenes.with_blocks(bracket.Scene(), cells=2)
        scene.add_body("lower", E=1.0, nu=0.0)
        scene.add_body("upper", E=2.0, nu=0.0)
        scene.set_sliding("lower.bottom", 0)
        scene.set_sliding("lower.left", 0)
        scene.set_traction("upper.top", 0, 0.5)
        scene.add_bond("upper.bottom", "lower.top")
        outcome = bracket.run(scene)
        self.assertLessEqual(outcome.lower, -0.1875)
        self.assertGreaterEqual(outcome.upper, -0.1875)
        self.assertLess(outcome.upper - outcome.lower, 1e-10)
        self.assertEqual(len(outcome.mesh.vertices), 15)
        apart = scenes.with_blocks(bracket.Scene(), cells=2)
        apart.add_bond("upper.bottom", "lower.bottom")
        with self.assertRaises(bracket.Error):
            bracket.run(apart)

    def test_of_bars_with_contact_laws(self):
        def bar(pull, **law):
            scene = scenes.with_blocks(bracket.Scene(), cells=2)
            scene.add_body("lower", E=1.0, nu=0.0)
            scene.add_body("upper", E=2.0, nu=0.0)
            scene.set_sliding("lower.bottom", 0)
            scene.set_sliding("lower.left", 0)
            scene.set_sliding("upper.left", 0)
            scene.set_traction("upper.top", 0, pull)
            scene.add_contact("upper.bottom", "lower.top", **law)
            return bracket.run(scene)

        # Compliances: 1 and ½ of the bars, 1/k = 4 of the springs.
        for outcome, energy in (
            (bar(0.5, law="bilateral"), -0.1875),
            (bar(-0.5, law="winkler", value=0.25), -0.6875),
            (bar(0.5, law="winkler", value=0.25, lifts_off=False), -0.6875),
            (bar(-0.5, law="tresca", value=1), -0.1875),
            (bar(-0.5, law="coulomb", value=0.3), -0.1875),
        ):
            self.assertLessEqual(outcome.lower, energy)
            self.assertGreaterEqual(outcome.upper, energy)
            self.assertLess(outcome.upper - outcome.lower, 1e-10)
        self.assertEqual(bar(-0.5, law="coulomb", value=0.3).guarantee, "tresca-step")
        with self.assertRaises(bracket.Error):
            bar(0.5, law="winkler", value=0.25)
        with self.assertRaises(bracket.Error):
            bar(0.5, law="bilateral", value=1)
        with self.assertRaises(ValueError):
            bar(0.5, law="velcro")

    def test_of_callables_are_told_to_be_sampled(self):
        sampled = scenes.with_blocks(scenes.two_blocks(traction=lambda x, y: -0.1 if x < 0.5 else 0.09))
        sampled.set_refine(max_levels=2)
        outcome = bracket.run(sampled)
        self.assertEqual(outcome.guarantee, "discretisation")
        self.assertIn("sampled", str(outcome))
        exact = scenes.with_blocks(scenes.two_blocks())
        exact.set_refine(max_levels=2)
        expected = bracket.run(exact)
        self.assertNotIn("sampled", str(expected))
        self.assertEqual([outcome.lower, outcome.upper], [expected.lower, expected.upper])

    def test_of_a_sampled_gap(self):
        def pressed(gap):
            scene = scenes.square()
            scene.add_quantity("sinking", "displacement", "block.top", direction=(0, -1))
            scene.add_contact("block.right", "rigid", gap=gap)
            return bracket.run(scene)

        sampled, exact = pressed(lambda x, y: 1e-4 * (1 + y)), pressed("1e-4 * (1 + y)")
        self.assertEqual((sampled.guarantee, exact.guarantee), ("discretisation", "rounding-safe"))
        for one, other in zip(sampled.quantities, exact.quantities):
            self.assertAlmostEqual(one.lower, other.lower, delta=1e-9 * abs(other.lower))
            self.assertAlmostEqual(one.upper, other.upper, delta=1e-9 * abs(other.upper))


if __name__ == "__main__":
    unittest.main()
