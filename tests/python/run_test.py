# Copyright (C) 2026 The Bracket developers. SPDX-License-Identifier: GPL-3.0-or-later
import _thread
import signal
import threading
import time
import unittest
import weakref

import bracket

import scenes


def two_blocks(**refine):
    scene = scenes.with_blocks(scenes.two_blocks())
    scene.set_refine(target=0, **refine)
    return scene


class Run(unittest.TestCase):
    def test_tells_of_each_level(self):
        told = []
        outcome = bracket.run(two_blocks(max_levels=4), told.append)
        self.assertEqual([len(one.levels) for one in told], [1, 2, 3, 4])
        self.assertEqual((told[-1].lower, told[-1].upper), (outcome.lower, outcome.upper))
        self.assertEqual([len(one.mesh.cells) for one in told], [level.cells for level in outcome.levels])
        self.assertEqual(told[0].stress.coefficients.shape[0], told[0].levels[0].cells)

    def test_ends_where_the_callback_returns_false(self):
        outcome = bracket.run(two_blocks(max_levels=9), lambda so_far: len(so_far.levels) < 3)
        self.assertEqual((len(outcome.levels), outcome.status), (3, "budget_spent"))
        self.assertIn("stopped on request", outcome.reason)
        self.assertEqual(outcome.guarantee, "rounding-safe")
        # None, as functions without return give it, is no wish to stop.
        self.assertEqual(len(bracket.run(two_blocks(max_levels=3), lambda so_far: None).levels), 3)

    def test_raises_what_the_callback_raises(self):
        def failing(so_far):
            raise LookupError(len(so_far.levels))

        with self.assertRaises(LookupError) as raised:
            bracket.run(two_blocks(max_levels=3), failing)
        self.assertEqual(raised.exception.args, (1,))

    def test_lets_other_threads_run(self):
        counted = [0]
        done = threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0.0005)

        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        bracket.run(two_blocks(strategy="uniform", max_levels=4))
        during = counted[0] - before
        done.set()
        thread.join()
        self.assertGreater(during, 10)

    def test_runs_in_several_threads(self):
        expected = bracket.run(two_blocks(max_levels=4))
        found = []
        scene = two_blocks(max_levels=4)
        threads = [threading.Thread(target=lambda: found.append(bracket.run(scene))) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual([(one.lower, one.upper) for one in found], 3 * [(expected.lower, expected.upper)])

    def test_keeps_callables_as_long_as_it_needs_them(self):
        class Load:
            def __call__(self, x, y):
                return -0.1

        scene = scenes.with_blocks(scenes.two_blocks(traction=Load()))
        scene.set_refine(max_levels=2)
        bracket.run(scene)
        load = Load()
        scene.set_traction("upper.top", 0, load)
        gone = weakref.ref(load)
        del load
        outcome = bracket.run(scene)
        self.assertIsNotNone(gone())
        del scene, outcome
        self.assertIsNone(gone())


class Interrupt(unittest.TestCase):
    def test_raises_keyboard_interrupt(self):
        levels = []

        def press(so_far):
            levels.append(len(so_far.levels))
            if len(levels) == 2:
                _thread.interrupt_main()  # as Ctrl-C does

        handler = signal.getsignal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            bracket.run(two_blocks(max_levels=30), press)
        self.assertEqual(levels, [1, 2])
        self.assertIs(signal.getsignal(signal.SIGINT), handler)
        self.assertEqual(bracket.run(scenes.square()).status, "done")

    def test_by_a_signal_in_the_middle_of_the_work(self):
        timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
        timer.start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            bracket.run(two_blocks(max_levels=30, max_seconds=60, max_cells=1000000))
        timer.join()
        self.assertLess(time.monotonic() - start, 30)

    def test_leaves_a_handler_of_your_own_in_charge(self):
        caught = []
        before = signal.signal(signal.SIGINT, lambda number, frame: caught.append(number))
        try:
            outcome = bracket.run(two_blocks(max_levels=3), lambda so_far: signal.raise_signal(signal.SIGINT))
        finally:
            signal.signal(signal.SIGINT, before)
        self.assertEqual((len(caught), len(outcome.levels)), (3, 3))


class Process(unittest.TestCase):
    def test_is_left_as_it_was(self):
        def state():
            fields = ("SigBlk", "SigIgn", "SigCgt")
            with open("/proc/self/status") as status:
                return [line for line in status if line.startswith(fields)]

        before = state()
        bracket.run(two_blocks(max_levels=2))
        bracket.read_scene(scenes.SCENES / "two_blocks.toml")
        self.assertEqual(state(), before)


if __name__ == "__main__":
    unittest.main()
