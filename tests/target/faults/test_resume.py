#!/usr/bin/env python3
"""Tests that the progress of a job survives its end: in memory that start-up preserves, after a
restart by a fault, and in the store, after a hold and a power cut.

    test_resume.py PLUGIN kerfline_generic.elf [TEST...]

KERFLINE_TRIALS=40 sets the number of times at which the job ends (default 6), KERFLINE_SEED chooses
them. Ends with 77 (skipped) if the emulator, the plug-in or the image is missing.
"""

import pathlib
import random
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chip import (BOOT_NS, CHIP_OPTIONS, MS, STOPPED, first_seed, in_parallel, main,  # noqa: E402
                  trials)
from plant import in_main_loop  # noqa: E402

CHIP = None
STEPS_PER_MM = 1600
SIDE_MM = 4.0
SET_UP = "$32=1\n$858=0\n$100=1600\n$101=1600\n$120=5000\n$121=5000\n"
# A square at 25 mm/s, each side a line of the program. Two sides lead back, so that the steps
# determine the position.
JOB = SET_UP + "M4S600F1500\nN11G1X4\nN12G1Y4\nN13G1X0\nN14G1Y0\n"
PAUSE = "(" + 60 * "." + ")\n"  # 5 ms of the wire.
STEP_X, STEP_Y = "PA0", "PA1"
RESUME = re.compile(r"\[RESUME:(\d+)\|([-\d.]+),([-\d.]+),[-\d.]+\|(\w+)\]")
CUT_NS = int(4 * SIDE_MM / 25 * 1e9)  # What the job takes, about.


def place_on_square(line: int, x: float, y: float) -> float:
    """Returns the distance along the square for a position that is reported with its line."""
    return {11: x, 12: SIDE_MM + y, 13: 3 * SIDE_MM - x, 14: 4 * SIDE_MM - y}[line]


def way_driven(run, until_ns: int) -> float:
    count = sum(ns < until_ns for pin in (STEP_X, STEP_Y) for ns in run.times("pin", f"{pin} 1"))
    return count / STEPS_PER_MM


class ResumeTest(unittest.TestCase):
    def places(self) -> list:
        chosen = random.Random(first_seed(self))
        return [chosen.uniform(0.1, 0.9) for _ in range(trials(3, in_proof=6))]

    def assert_told(self, said: str, way_mm: float, behind_mm: float) -> str:
        told = RESUME.search(said)
        self.assertTrue(told, said)
        line = int(told[1])
        place = place_on_square(line, float(told[2]), float(told[3]))
        self.assertLessEqual(place, way_mm + 0.001, told[0])
        self.assertGreaterEqual(place, way_mm - behind_mm, told[0])
        return told[4]

    def test_a_restart_keeps_line_and_place(self):
        """Preserved in memory: line and position of the last cycle in which the tool worked."""
        places = self.places()

        def one(share):
            at_ns = BOOT_NS + 60 * MS + int(share * CUT_NS)
            pauses = (at_ns - BOOT_NS) // (5 * MS) + 30
            run = CHIP.run(JOB + pauses * PAUSE + "\n$RESUME\n", at_ns + 250 * MS, *CHIP_OPTIONS,
                           *in_main_loop(CHIP, "contract", at_ns))
            return at_ns, run
        for share, (at_ns, run) in zip(places, in_parallel(one, places)):
            with self.subTest(share=share):
                self.assertEqual(STOPPED, run.status, run.told)
                restart, = run.resets()
                self.assertIn("Restarted after a fault: broken contract", run.said)
                # Two cycles at 25 mm/s, and the steps of the pulses that were under way.
                how = self.assert_told(run.said, way_driven(run, restart), 0.06)
                self.assertEqual(how, "home", "the motors had no current")

    def test_power_that_goes_after_a_hold_keeps_line_and_place(self):
        """Preserved in the store: the exact line and position of the hold."""
        places = self.places()

        def one(share):
            with tempfile.TemporaryDirectory() as name:
                flash = f"flash={pathlib.Path(name, 'flash')}"
                hold = int((60 * MS + share * CUT_NS) / (5 * MS))
                stop_ns = BOOT_NS + (hold + 60) * 5 * MS
                first = CHIP.run(JOB + hold * PAUSE + "!", stop_ns, *CHIP_OPTIONS, flash)
                return stop_ns, first, CHIP.run("$RESUME\n", BOOT_NS + 100 * MS, *CHIP_OPTIONS, flash)
        for share, (stop_ns, first, second) in zip(places, in_parallel(one, places)):
            with self.subTest(share=share):
                self.assertEqual((STOPPED, STOPPED), (first.status, second.status))
                self.assert_told(second.said, way_driven(first, stop_ns), 0.3)
                self.assertEqual([], second.steps(), "nothing moves by itself")
                self.assertEqual([], second.lit())


if __name__ == "__main__":
    main(globals(), "target.resume")
