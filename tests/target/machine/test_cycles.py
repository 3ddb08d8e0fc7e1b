"""Tests the model of the core's cycles against manual sums from the manuals' tables."""

import unittest

from emulator import Emulator

END = 1  # The store that ends the counting.
REFILL = 2


class CyclesTest(unittest.TestCase):
    def test_short_rows_are_as_the_tables_have_them(self):
        said = {name: values[0][0] - END for name, values in
                Emulator.run("cycles", "memories_only=on", "cycles=on").said.items()}
        lines = -(-(2000 * 4 + 2) // 16)  # Of a row of 1,999 instructions between its stores.
        wanted = {
            "nothing": 0,
            "arithmetic": 1 + 1 + 2,
            "loads": 1 + 2 + 1 + 1,
            "load_apart": 1 + 2 + 1 + 2,
            "many": 4 + 4,
            "divisions": 1 + 12 + 14 + 14,
            "late_result": 1 + 1 + 1,
            "early_result": 3,
            "loop": 1 + 10 * (1 + 1) + 9 * REFILL,
            "short_row": 40,
            "jumps": 4 + 3 * REFILL,
        }
        self.assertEqual(wanted, {name: said[name] for name in wanted})
        # A line holds four instructions, and the line that is read ahead arrives after six cycles.
        self.assertAlmostEqual(6 * lines, said["long_row"], delta=12)

    def test_cycles_want_the_plain_machine(self):
        outcome = Emulator.run("cycles", "cycles=on")
        self.assertNotEqual(0, outcome.status)
        self.assertIn("machine: cycles=on needs memories_only=on", outcome.text)
