#!/usr/bin/env python3
"""kerfline wall joints and sim --knots as their users call them.

    wall_joints_test.py KERFLINE
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

KERFLINE = sys.argv.pop(1)
PROGRAM = ("G21 G90 G94\nG43.4 Z30\nM4 S0\nG1 X20 Y0 A30 C0 F600 S500\nG2 X-20 Y0 R20 A30 C180\n"
           "G1 X-20 Y-10 A-10 C270\nM5\nG49\nM2\n")
PIVOT = 50.0 - 30.0  # Of table A below the tip: the point is one for a tool of no length, and the tool is 30 mm long.
SETTINGS = "$900=1\n$912=-50\n"


def run(*arguments):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"})


def tip_of(place):
    """Returns the tip above the part for positions of the axes, computed by hand: A turns about X
    through the pivot, C about Z.
    """
    x, y, z, a, _, c = place
    a, c = math.radians(a), math.radians(c)
    z += PIVOT
    y, z = y * math.cos(a) - z * math.sin(a), y * math.sin(a) + z * math.cos(a)
    return x * math.cos(c) - y * math.sin(c), x * math.sin(c) + y * math.cos(c), z - PIVOT


class WallJoints(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        (self.folder / "tip.nc").write_text(PROGRAM)
        (self.folder / "five.settings").write_text(SETTINGS)

    def path(self, name):
        return self.folder / name

    def joints(self, *more):
        return run("wall", "joints", self.path("tip.nc"), "--settings", self.path("five.settings"), *more)

    def simulated(self, program, *more):
        report = self.path("report.json")
        done = run("sim", program, "--report", report, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(report.read_text())

    def test_take_as_long_on_a_machine_without_control_of_the_tip(self):
        done = self.joints("-o", self.path("joints.nc"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("3 motions", done.stderr)
        tip = self.simulated(self.path("tip.nc"), "--settings", self.path("five.settings"))
        axes = self.simulated(self.path("joints.nc"))
        self.assertLess(abs(axes["job_time_s"] / tip["job_time_s"] - 1), 0.05)
        self.assertEqual(axes["refused_lines"], 0)

    def test_knots_carry_the_tip_along_its_program(self):
        report = self.simulated(self.path("tip.nc"), "--settings", self.path("five.settings"), "--knots",
                                self.path("knots.txt"))
        self.assertEqual(report["tip"]["machine"]["kind"], "tables")
        self.assertEqual(report["tip"]["machine"]["tilt_point_mm"], [0, 0, -50])
        self.assertEqual(report["tip"]["tool_length_mm"], 30)
        rows = [[float(word) for word in line.split()] for line in self.path("knots.txt").read_text().splitlines()[1:]]
        times = [row[0] for row in rows]
        self.assertEqual(times, sorted(set(times)))
        self.assertLess(abs(times[-1] - report["job_time_s"]), 0.05)
        for row in rows:
            x, y, z = tip_of(row[1:])
            self.assertLess(abs(z), 1e-3)
            # Corners are rounded within 0.01 mm ($11).
            off = abs(y) if row[6] == 0 else abs(math.hypot(x, y) - 20) if row[6] <= 180 else abs(x + 20)
            self.assertLess(off, 0.0105, row)

    def test_knots_of_a_plain_program_are_none_and_said_so(self):
        self.path("plain.nc").write_text("G1 X1 F600\n")
        report = self.simulated(self.path("plain.nc"), "--knots", self.path("knots.txt"))
        self.assertIn("contains no positions", report["warnings"][0])
        self.assertEqual(self.path("knots.txt").read_text(),
                         "# time_s x y z a b c: positions of the axes, mm and degrees\n")

    def test_refusals_name_the_line(self):
        self.path("tip.nc").write_text("G43.4\nM62 P1\n")
        done = self.joints()
        self.assertEqual(done.returncode, 2)
        self.assertIn("tip.nc:2: M62", done.stderr)
        self.path("tip.nc").write_text(PROGRAM)
        done = run("wall", "joints", self.path("tip.nc"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("$900", done.stderr)

    def test_its_zero_moves_the_axes(self):
        self.path("tip.nc").write_text("G43.4\nG1 X0 Y0 Z0 F600\nM2\n")
        done = self.joints("--zero", "1,2,3")
        self.assertIn("X1 Y2 Z3", done.stdout)


if __name__ == "__main__":
    unittest.main()
