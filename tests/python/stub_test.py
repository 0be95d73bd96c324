# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""The stub, the docstrings and the module tell the same names."""
import ast
import inspect
import pathlib
import re
import unittest

import bracket
import bracket.space

PACKAGE = pathlib.Path(bracket.__file__).parent


def is_public(name):
    return not name.startswith("_") or name in ("__version__", "_repr_html_", "__init__", "__copy__")


def arguments(function):
    """Names of the arguments of a function of the stub, "*" where those by name alone begin."""
    given = function.args
    names = [one.arg for one in given.posonlyargs + given.args]
    return names + (["*"] + [one.arg for one in given.kwonlyargs] if given.kwonlyargs else [])


def documented(function):
    """The same of a function of the module, from the first line of its docstring."""
    signature = function.__doc__.splitlines()[0]
    inside = signature[signature.index("(") + 1 : signature.rindex(") ->")]
    nested = r"\[[^\[\]]*\]|\([^()]*\)|\{[^{}]*\}|'[^']*'"  # types and defaults, which may have commas
    while re.search(nested, inside):
        inside = re.sub(nested, "", inside)
    return [part.split(":")[0].split("=")[0].strip() for part in inside.split(",") if part.strip()]


class Stub(unittest.TestCase):
    module = bracket
    stub = "__init__.pyi"
    parts = {"space"}  # modules in it

    def setUp(self):
        tree = ast.parse((PACKAGE / self.stub).read_text())
        self.classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        self.functions = {node.name: node for node in tree.body if isinstance(node, ast.FunctionDef)}
        self.values = {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}

    def test_has_every_public_name(self):
        told = set(self.classes) | set(self.functions) | self.values | self.parts
        self.assertEqual(told, {name for name in vars(self.module) if is_public(name)} | {"__all__"})
        self.assertEqual(set(self.module.__all__), told - {"__all__"})

    def test_has_every_member(self):
        for name, node in self.classes.items():
            if name == "Error":
                continue  # its attributes are made with each
            told = {one.name for one in node.body}
            there = {member for member in vars(getattr(self.module, name)) if is_public(member)}
            if "__init__" not in told:  # made by the module alone
                there.discard("__init__")
            self.assertEqual(told, there, name)

    def test_has_the_arguments(self):
        for name, node in self.functions.items():
            self.assertEqual(documented(getattr(self.module, name)), arguments(node), name)
        for name, node in self.classes.items():
            for one in node.body:
                member = vars(getattr(self.module, name)).get(getattr(one, "name", ""))
                if isinstance(one, ast.FunctionDef) and not isinstance(member, property) and one.name != "__copy__":
                    self.assertEqual(documented(member), arguments(one), f"{name}.{one.name}")

    def test_is_beside_docstrings(self):
        for name in self.functions:
            self.assertGreater(len(getattr(self.module, name).__doc__.splitlines()), 2, name)
        for name in self.classes:
            self.assertTrue(inspect.getdoc(getattr(self.module, name)), name)

    def test_names_what_is_in_the_package(self):
        for name in self.module.__all__:
            where = getattr(getattr(self.module, name), "__module__", self.module.__name__)
            self.assertEqual(where, self.module.__name__, name)


class StubOfSpace(Stub):
    module = bracket.space
    stub = "space.pyi"
    parts = set()


if __name__ == "__main__":
    unittest.main()
