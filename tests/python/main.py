# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tests of this folder, and ends with the lines that tests/run.sh counts: python3 main.py [NAME…]"""
import pathlib
import sys
import unittest

folder = pathlib.Path(__file__).parent
sys.path.insert(0, str(folder))
if sys.argv[1:]:
    suite = unittest.defaultTestLoader.loadTestsFromNames(sys.argv[1:])
else:
    suite = unittest.defaultTestLoader.discover(str(folder), "*_test.py")
result = unittest.TextTestRunner(verbosity=2).run(suite)
failed = len(result.failures) + len(result.errors)
print(f"[  PASSED  ] {result.testsRun - failed} tests.")
if failed:
    print(f"[  FAILED  ] {failed} tests, listed below:")
sys.exit(failed > 0)
