#!/usr/bin/env python3
"""Compares arcs with chords on sculptured grids: the number of motion lines, and the time of the
machine.

    surface_elements_test.py KERFLINE
    KERFLINE_GRID=100 surface_elements_test.py KERFLINE    grids of 100 x 100, at 0.1, 0.01 and
    0.001 mm
"""

import json
import math
import os
import pathlib
import tempfile
import unittest

from pocket_bench import MACHINE, run

POINTS = int(os.environ.get("KERFLINE_GRID", "64"))
ALL = "KERFLINE_GRID" in os.environ
PITCH = 0.5
SURFACES = {
    "waves": lambda x, y: 2 * math.sin(0.35 * x) * math.cos(0.3 * y),
    "dome": lambda x, y: -((x - 12) ** 2 + (y - 10) ** 2) / 60,
    "saddle": lambda x, y: (x - 10) * (y - 8) / 40,
    "hills": lambda x, y: 4 * math.exp(-((x - 6) ** 2 + (y - 7) ** 2) / 18) + 3 * math.exp(
        -((x - 15) ** 2 + (y - 12) ** 2) / 10),
    "propeller": lambda x, y: 3 * math.tanh(0.25 * (y - 9)) * math.sin(0.15 * x + 0.5),
}
# The waves are too short for the pitch: the facets of the grid dominate, and no element spans two
# facets.
COARSE = {
    "ripples": lambda x, y: 0.8 * math.sin(0.12 * ((x - 4) ** 2 + (y - 5) ** 2) ** 0.75),
}
# Settings of a machine that rounds corners and welds lines by at most a step.
SETTINGS = (*MACHINE, "--set", "$11=0.003", "--set", "$12=0.003")


class Elements(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def job(self, tolerance, *more):
        """Returns the number of motion lines and the duration of a program, s."""
        program, report, simulated = (self.folder / name for name in ("scan.nc", "scan.json", "sim.json"))
        decimals = 5 if tolerance < 0.005 else 4
        done = run("surface", self.folder / "scan.xyz", "--tool", "ball:4", "--step", PITCH, "--tolerance", tolerance,
                   "--decimals", decimals, "--feed", 1500, "--plunge-feed", 1500, "--report", report, "-o", program,
                   *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run("sim", program, *SETTINGS, "--report", simulated)
        self.assertEqual(done.returncode, 0, done.stderr)
        counts = json.loads(report.read_text())
        return counts["arcs"] + counts["lines"], json.loads(simulated.read_text())["job_time_s"]

    def test_arcs_are_few_and_take_no_longer(self):
        logs = []
        for name, height in {**SURFACES, **COARSE}.items():
            rows = ("".join(f"{PITCH * c} {PITCH * r} {height(PITCH * c, PITCH * r):.17g}\n" for c in range(POINTS))
                    for r in range(POINTS))
            (self.folder / "scan.xyz").write_text("\n".join(rows))
            for tolerance in (0.1, 0.01, 0.001) if ALL else (0.01,):
                arcs, arcs_s = self.job(tolerance)
                lines, lines_s = self.job(tolerance, "--lines")
                print(f"{name:10} {tolerance:6} mm: {arcs:6} of {lines:6} lines = {arcs / lines:.3f}, "
                      f"time {arcs_s / lines_s:.4f} of {lines_s:.1f} s")
                self.assertLessEqual(arcs, lines)
                if tolerance != 0.01:
                    continue
                self.assertLessEqual(arcs_s, 1.005 * lines_s, name)
                if name in SURFACES:
                    logs.append(math.log(arcs / lines))
        mean = math.exp(sum(logs) / len(logs))
        print(f"geometric mean at 0.01 mm: {mean:.3f}")
        self.assertLessEqual(mean, 0.45)


if __name__ == "__main__":
    unittest.main()
