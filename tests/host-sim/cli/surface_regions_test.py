#!/usr/bin/env python3
"""kerfline surface with limited rows: drawings, slopes, rests of a larger tool, direction; and
valleys.

    surface_regions_test.py KERFLINE
"""

import json
import math
import pathlib
import re
import tempfile
import unittest

from pocket_bench import MACHINE, run

MILL = ("--feed", "1500", "--plunge-feed", "500")
ROWS = ("--tool", "ball:2", "--step", "0.5", *MILL)
CIRCLE = ('<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm" viewBox="0 0 20 20">'
          '<circle cx="10" cy="10" r="6"/>{}</svg>')
ISLAND = '<circle cx="10" cy="10" r="3"/>'


def grid(height, count=41, pitch=0.5):
    rows = ("\n".join(f"{pitch * x:.3f} {pitch * y:.3f} {height(pitch * x, pitch * y):.4f}" for x in range(count))
            for y in range(count))
    return "\n\n".join(rows) + "\n"


class SurfaceRegions(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "part.nc"
        self.surface = self.folder / "part.xyz"
        # The surface is a plane with a groove along Y, whose sides have 45 degrees.
        self.surface.write_text(grid(lambda x, y: max(-4.0, min(0.0, abs(x - 10) - 4))))
        self.drawing = self.folder / "part.svg"
        self.drawing.write_text(CIRCLE.format(""))

    def mill(self, *options):
        report = self.folder / "part.json"
        done = run("surface", self.surface, *ROWS, "-o", self.program, "--report", report, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(report.read_text())

    def bounds(self):
        report = self.folder / "sim.json"
        done = run("sim", self.program, *MACHINE, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(report.read_text())["bounds_mm"]

    def test_stays_in_a_drawing_with_the_tip_or_the_rim(self):
        for side, radius in (("inside", 5.0), ("on", 6.0), ("outside", 7.0)):
            figures = self.mill("--boundary", self.drawing, "--boundary-side", side)
            self.assertEqual(figures["digests"][1]["kind"], "boundary")
            highest = self.bounds()["X"][1]
            self.assertLessEqual(highest, 10 + radius + 0.01)
            self.assertGreater(highest, 10 + radius - 0.05)

    def test_leaves_islands_and_rises_over_none(self):
        whole = self.mill("--boundary", self.drawing)
        self.drawing.write_text(CIRCLE.format(ISLAND))
        ring = self.mill("--boundary", self.drawing)
        self.assertEqual(whole["lifts"], 1)
        self.assertLessEqual(ring["lifts"], 3)
        # The groove's sides lengthen the rows by the same factor with and without the island.
        share = (6 ** 2 - 3 ** 2) / 6 ** 2
        self.assertAlmostEqual(ring["row_length_mm"] / whole["row_length_mm"], share, 1)
        self.assertLess(ring["row_length_mm"], whole["row_length_mm"])

    def test_mills_slopes_in_a_range(self):
        whole = self.mill()["row_length_mm"]
        steep = self.mill("--slope", "30:90")
        shallow = self.mill("--slope", "0:30")
        self.assertLess(steep["row_length_mm"], 0.75 * whole)
        self.assertLess(shallow["row_length_mm"], 0.75 * whole)
        # Both borders of each side overlap by a quarter of the radius.
        self.assertGreater(steep["row_length_mm"] + shallow["row_length_mm"], whole)
        self.assertLessEqual(steep["lifts"], 4)

    def test_mills_what_a_larger_tool_has_left(self):
        whole = self.mill()["row_length_mm"]
        rest = self.mill("--rest-of", "ball:6")
        # The rows extend from the bottom of the groove to (3 - 1) sin 45 on both sides, and an
        # eighth of the radius farther.
        rows = 41
        width = 2 * (2 * math.sin(math.pi / 4) + 0.125)
        self.assertLess(rest["row_length_mm"], rows * width * math.sqrt(2.0))
        self.assertGreater(rest["row_length_mm"], 0.7 * rows * width)
        self.assertLess(rest["row_length_mm"], 0.25 * whole)
        self.assertLessEqual(rest["lifts"], 2)

    def test_keeps_the_stock_on_one_side(self):
        for direction, first_row in (("climb", "Y20"), ("conventional", "Y0")):
            figures = self.mill("--direction", direction)
            self.assertEqual(figures["link_length_mm"], 0)
            self.assertGreater(figures["lifts"], 40)
            self.assertEqual(re.findall("Y[0-9.]+", self.program.read_text())[0], first_row)

    def test_follows_valleys_with_a_pencil(self):
        report = self.folder / "part.json"
        pencil = ("--tool", "ball:2", *MILL, "--pencil", "-o", self.program, "--report", report)
        done = run("surface", self.surface, *pencil)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual(figures["lifts"], 1)
        self.assertAlmostEqual(figures["row_length_mm"], 20, 0)
        self.assertIn("(along valleys sharper than 20 degrees", self.program.read_text())
        bounds = self.bounds()
        self.assertAlmostEqual(bounds["X"][1], 10, 1)
        # A ball of 1 mm touches two sides of 45 degrees.
        self.assertAlmostEqual(bounds["Z"][0], -4 + math.sqrt(2) - 1, 1)
        done = run("surface", self.surface, *pencil, "--boundary", self.drawing)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertAlmostEqual(json.loads(report.read_text())["row_length_mm"], 12, 1)
        self.program.unlink()
        self.surface.write_text(grid(lambda x, y: 0.1 * x))
        for options, told in (((), "the surface has no valley"), (("--step", 1), "--step: --pencil has no rows"),
                              (("--layers", 1), "--layers: --pencil has no rows"),
                              (("--pencil-angle", 0), "--pencil-angle")):
            done = run("surface", self.surface, *pencil, *options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(told, done.stderr)
            self.assertFalse(self.program.exists())

    def test_refuses_what_is_no_region(self):
        open_line = self.folder / "open.svg"
        open_line.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="9mm" height="9mm" viewBox="0 0 9 9">'
                             '<path d="M1 1 L5 1 L5 5"/></svg>')
        far = self.folder / "far.svg"
        far.write_text(CIRCLE.format("").replace('cx="10"', 'cx="400"'))
        for options, told in (
                (("--boundary", open_line), "open.svg:1"),
                (("--boundary", self.folder / "none.svg"), "none.svg"),
                (("--boundary", far), "no row is in the region"),
                (("--boundary-side", "inside"), "--boundary-side: requires --boundary"),
                (("--boundary", self.drawing, "--boundary-side", "inside", "--tool", "ball:16"), "fits nowhere"),
                (("--slope", "30"), "--slope 30: is not LOW:HIGH"),
                (("--slope", "40:30"), "--slope 40:30: is not LOW:HIGH"),
                (("--slope", "0:91"), "--slope 0:91: is not LOW:HIGH"),
                (("--rest-of", "ball:2"), "is no larger than --tool"),
                (("--rest-of", "egg:9"), "--rest-of egg:9"),
                (("--rest-of", "ball:6", "--rest-allowance", 0.2), "are a rest everywhere"),
                (("--rest-depth", 0.1), "--rest-depth: requires --rest-of"),
                (("--rest-allowance", 0.1), "--rest-allowance: requires --rest-of"),
                (("--direction", "climb", "--order", "zigzag"), "rows to and fro cut in both directions"),
                (("--direction", "up"), "--direction")):
            done = run("surface", self.surface, *(() if "--tool" in options else ROWS[:2]), *ROWS[2:], "-o",
                       self.program, *options)
            self.assertEqual(done.returncode, 2, (options, done.stderr))
            self.assertIn(told, done.stderr)
            self.assertFalse(self.program.exists())


if __name__ == "__main__":
    unittest.main()
