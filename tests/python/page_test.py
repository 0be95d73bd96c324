# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/python.md and the examples beside it say."""
import base64
import contextlib
import importlib.util
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

import bracket
import numpy

import scenes


def example(name):
    spec = importlib.util.spec_from_file_location(name, scenes.DOCS / "python" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def is_there(*modules):
    return all(importlib.util.find_spec(module) for module in modules)


class Page(unittest.TestCase):
    def test_runs_as_it_is_printed(self):
        """Its blocks of Python, one after the other, in the folder docs; what they print is the text below them."""
        text = (scenes.DOCS / "python.md").read_text()
        blocks = re.findall(r"^```(\w+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
        self.assertGreater(len(blocks), 5)
        names, before = {}, os.getcwd()
        os.chdir(scenes.DOCS)
        try:
            for (kind, block), (after, expected) in zip(blocks, blocks[1:] + [("", "")]):
                if kind != "python":
                    continue
                with contextlib.redirect_stdout(io.StringIO()) as printed:
                    exec(compile(block, "python.md", "exec"), names)
                self.assertEqual(printed.getvalue(), expected if after == "text" else "", block)
        finally:
            os.chdir(before)


class Examples(unittest.TestCase):
    @unittest.skipUnless(is_there("matplotlib"), "needs matplotlib")
    def test_plot(self):
        plot = example("plot")
        outcome = bracket.run(plot.scene())
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "wall.png"
            plot.draw(outcome, file)
            self.assertEqual(file.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    @unittest.skipUnless(is_there("matplotlib"), "needs matplotlib")
    def test_mean_stress_is_that_of_the_points_in_the_middle(self):
        plot = example("plot")
        scene = plot.scene()
        scene.set_refine(max_levels=1)
        outcome = bracket.run(scene)
        self.assertEqual(outcome.status, "budget_spent")
        corners = outcome.mesh.vertices[outcome.mesh.cells]
        # Of a linear function the mean of its values at the corners is its mean, and over the cell that of the parts.
        means = plot.mean_stress(outcome.stress)
        sides = corners[:, 1:] - corners[:, :1]
        resultant = (means * numpy.linalg.det(sides)[:, None] / 2).sum(axis=0)
        # On the whole block the vertical stress is that of the load 100 (1 + 0.2 x), the mean of which is 110.
        self.assertAlmostEqual(resultant[1], -110, delta=1e-9)

    def test_stamp_bears_its_load(self):
        stamp = example("stamp")
        scene = stamp.scene()
        scene.set_refine(max_levels=2)
        outcome = bracket.run(scene)
        self.assertEqual(outcome.guarantee, "discretisation")
        # On the quarter of the head, [0, 20]^2, the load 10 (1 - (x + y)/80) has the mean 7.5.
        force = outcome.quantity("force")
        self.assertLessEqual(force.lower, 3000)
        self.assertGreaterEqual(force.upper, 3000)
        self.assertLess(force.upper - force.lower, 1)
        mesh = outcome.mesh
        normals = numpy.cross(*(mesh.vertices[mesh.parts["foot"]][:, [1, 2]] - mesh.vertices[mesh.parts["foot"]][:, :1]).transpose(1, 0, 2))
        numpy.testing.assert_allclose(normals.sum(axis=0) / 2, [0, 0, -900], atol=1e-9)

    @unittest.skipUnless(is_there("getfem"), "needs GetFEM")
    def test_judge_getfem(self):
        """Prints what the page says."""
        command = [sys.executable, "python/judge_getfem.py"]
        printed = subprocess.run(command, cwd=scenes.DOCS, capture_output=True, text=True, check=True).stdout
        text = (scenes.DOCS / "python.md").read_text()
        self.assertIn(f"```sh\npython3 {command[1]}\n```\n\n```text\n{printed}```\n", text)


class Notebook(unittest.TestCase):
    def expect_picture(self, html):
        self.assertRegex(html, r"^<pre>[^<]+</pre>")
        svg = re.search(r'src="data:image/svg\+xml;base64,([^"]+)"', html)
        self.assertEqual(ElementTree.fromstring(base64.b64decode(svg[1])).tag, "{http://www.w3.org/2000/svg}svg")

    @unittest.skipUnless(shutil.which("gnuplot"), "needs gnuplot")
    def test_shows_the_first_lines_and_a_picture(self):
        scene = scenes.with_blocks(scenes.two_blocks())
        scene.add_quantity("a < b", "energy")
        scene.set_refine(max_levels=2)
        outcome = bracket.run(scene)
        self.expect_picture(outcome._repr_html_())
        self.assertIn("a &lt; b", outcome._repr_html_())
        page = outcome.html()
        self.assertTrue(page.lower().startswith("<!doctype html>"))
        self.assertGreater(page.count("<svg"), 2)
        mesh = scene.mesh(1)
        names = [mesh.bodies[i] for i in numpy.repeat(mesh.cell_body, 3)]
        nodes = mesh.vertices[mesh.cells.reshape(-1)]
        self.expect_picture(bracket.assess(scene, nodes, 0 * nodes, bodies=names)._repr_html_())


if __name__ == "__main__":
    unittest.main()
