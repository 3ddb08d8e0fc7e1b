#!/usr/bin/env python3
"""kerfline surface --smooth: noise of a scan is not milled, the surface is not gouged, and invalid
values are refused.

    surface_smooth_test.py KERFLINE
"""

import json
import math
import pathlib
import random
import re
import tempfile
import unittest

from pocket_bench import MACHINE, run
from surface_command_test import MILL, box_of_stl, scan

FIT = 0.1
TOLERANCE = 0.01
TOOL = ("--tool", "ball:3", "--step", 0.5, "--tolerance", TOLERANCE)


def noisy():
    noise = random.Random(5)
    return scan(height=lambda x, y: -4 + 1.5 * math.sin(0.4 * x) * math.cos(0.3 * y) + noise.uniform(-0.03, 0.03))


class SurfaceSmooth(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program, self.report = self.folder / "scan.nc", self.folder / "report.json"
        self.scan = self.folder / "scan.xyz"
        self.scan.write_text(noisy())

    def surface(self, *options, file=None):
        return run("surface", file or self.scan, *TOOL, *MILL, "-o", self.program, "--report", self.report, *options)

    def figures(self, *options):
        done = self.surface(*options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(self.report.read_text())

    def heights_above_touch(self):
        """Returns the heights of the ends of moves above the position in which the tool touches."""
        position, ends = {}, []
        for line in self.program.read_text().splitlines():
            words = {word[0]: float(word[1:]) for word in re.findall(r"[GXYZF]-?[\d.]+", line)}
            if line.startswith("(") or not words.keys() & {"X", "Y", "Z"}:
                continue
            position.update((axis, words[axis]) for axis in "XYZ" if axis in words)
            if words.keys() & {"X", "Y"} and position["Z"] < 0:
                ends.append(dict(position))
        wanted = self.folder / "ends.txt"
        wanted.write_text("".join(f"{end['X']} {end['Y']}\n" for end in ends))
        done = run("surface", self.scan, "--tool", "ball:3", "--at", wanted)
        self.assertEqual(done.returncode, 0, done.stderr)
        touched = [float(row.split()[2]) for row in done.stdout.splitlines()]
        return [end["Z"] - height for end, height in zip(ends, touched)]

    def test_mills_no_noise_and_stays_in_its_band(self):
        exact = self.figures()
        patches = self.folder / "patches.txt"
        smooth = self.figures("--smooth", "--fit-tolerance", FIT, "--patches", patches)
        self.assertLess(smooth["arcs"] + smooth["lines"], 0.6 * (exact["arcs"] + exact["lines"]))
        self.assertEqual((exact.get("fit_tolerance_mm"), smooth["fit_tolerance_mm"]), (None, FIT))
        self.assertIn("(along smooth patches within 0.1 mm)\n", self.program.read_text())
        self.assertGreater(len(patches.read_text().splitlines()), 16)
        above = self.heights_above_touch()
        self.assertGreater(len(above), 40)
        self.assertGreaterEqual(min(above), 0.0)
        self.assertLessEqual(max(above), 1.3 * (FIT + 2 * TOLERANCE))  # In space, where it is steep.

    def test_the_machine_leaves_the_scan_without_a_gouge(self):
        self.figures("--smooth", "--fit-tolerance", FIT)
        stock = ("--stock", "0,0,15,10,-2,-8", "--stock-cell", 0.05, "--stock-surface", self.scan)
        done = run("sim", self.program, *MACHINE, *stock, "--tool", "ball:3", "--report", self.report)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(self.report.read_text())["stock"]["surface"]
        self.assertEqual(found["gouge_mm3"]["least"], 0.0)
        self.assertEqual(found["worst_gouges"], [])

    def test_goes_with_layers_scallops_and_lines_of_one_height_or_distance(self):
        for options in (("--layers", 1, "--stock-top", 0), ("--angle", 30, "--order", "oneway"),
                        ("--scallop", 0.05), ("--paths", "waterline"), ("--paths", "contour"), ("--allowance", 0.2)):
            self.figures("--smooth", "--fit-tolerance", FIT, *options)
            done = run("sim", self.program, *MACHINE, "--report", self.report)
            self.assertEqual(json.loads(self.report.read_text())["faults"], [], (options, done.stderr))

    def test_refuses_what_has_no_smooth_path(self):
        block = self.folder / "block.stl"
        block.write_bytes(box_of_stl(20, 6))
        places = self.folder / "places.txt"
        places.write_text("1 1\n")
        self.program.unlink(missing_ok=True)
        for options, file, told in (
                ((), block, "this is a mesh; give a grid"),
                (("--pencil",), None, "--pencil: a smooth surface has no valleys; leave it out, or --smooth"),
                (("--at", places), None, "--at: it writes the tip's exact heights; leave it out"),
                (("--like-paper",), None, "--like-paper: it makes no path; leave it out"),
                (("--approach", "1,0,0"), None, "--approach: patches fit a grid only as seen from above")):
            done = self.surface("--smooth", *options, file=file)
            self.assertEqual(done.returncode, 2, (options, done.stderr))
            self.assertIn(told, done.stderr)
            self.assertFalse(self.program.exists())


if __name__ == "__main__":
    unittest.main()
