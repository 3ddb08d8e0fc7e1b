#!/usr/bin/env python3
"""kerfline surface along waterlines and contours: programs that the simulated machine carves, and refusals.

    surface_paths_test.py KERFLINE
"""

import json
import pathlib
import re
import tempfile
import unittest

from pocket_bench import run
from probe_to_carve_test import CELL, CELL_ERROR, CORNER, DEPTH, ROUNDING, SETTINGS, STEPS_PER_MM, WIDTH, part_grid, \
    upper_points
from surface_command_test import MILL, box_of_stl

TOLERANCE = 0.005


class SurfacePaths(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "part.xyz"
        self.part.write_text(part_grid(beyond=0))
        self.program = self.folder / "part.nc"
        self.report = self.folder / "part.json"

    def surface(self, *options, file=None):
        return run("surface", file or self.part, "-o", self.program, "--report", self.report, *MILL, *options)

    def moves(self):
        return [line for line in self.program.read_text().splitlines() if not line.startswith("(")]

    def carved(self, *options):
        """Returns the heights of the stock that a program leaves, by point."""
        done = self.surface("--tool", "ball:3", "--tolerance", TOLERANCE, "--stock-top", 0, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        rest = self.folder / "rest.ply"
        done = run("sim", self.program, *SETTINGS, "--stock", f"0,0,{WIDTH},{DEPTH},0,-10", "--tool", "3,ball",
                   "--stock-cell", CELL, "--stock-ply", rest)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("a rapid cuts stock", done.stdout + done.stderr)
        return upper_points(rest.read_bytes())

    def off_the_part(self, carved):
        """Returns the heights of the carved stock above the part."""
        places = [(x, y) for x, y in carved if 2 < x < WIDTH - 2 and 2 < y < DEPTH - 2][::7]
        wanted = self.folder / "places.txt"
        wanted.write_text("".join(f"{x} {y}\n" for x, y in places))
        done = run("surface", self.part, "--tool", "ball:0.01", "--at", wanted)
        self.assertEqual(done.returncode, 0, done.stderr)
        heights = [float(row.split()[2]) for row in done.stdout.splitlines()]
        return [carved[place] - height for place, height in zip(places, heights)]

    def test_contours_and_waterlines_carve_the_part_and_cut_nothing_of_it(self):
        least = 1 / STEPS_PER_MM + CORNER + ROUNDING + CELL_ERROR
        off = self.off_the_part(self.carved("--paths", "contour", "--step", 0.4))
        self.assertGreater(min(off), -least)
        # The bound is for 0.55 of a step from a line, plus the material that a ball leaves in a
        # valley of facets.
        self.assertLess(max(off), 0.22 ** 2 / (2 * 1.5) + 2 * TOLERANCE + least + 0.5 ** 2 / (8 * 1.5))
        off = self.off_the_part(self.carved("--paths", "waterline", "--step", 0.05))
        self.assertGreater(min(off), -least)
        self.assertLess(sorted(off)[len(off) // 2], 0.03)  # Flats are left.

    def test_waterlines_are_arcs_at_one_height_each(self):
        block = self.folder / "block.stl"
        block.write_bytes(box_of_stl(20, 6))
        place = ("--move", "0,0,-6", "--tool", 6, "--margin", 8, "--floor", -6, "--step", 2, "--paths", "waterline")
        areas = {}
        for direction in ("climb", "conventional"):
            done = self.surface(*place, "--direction", direction, file=block)
            self.assertEqual(done.returncode, 0, done.stderr)
            figures = json.loads(self.report.read_text())
            self.assertEqual(figures["lifts"], 1)
            # The rows run around a block of 20 mm at a distance of 3 mm, three times.
            self.assertAlmostEqual(figures["row_length_mm"], 3 * (80 + 6 * 3.14159), delta=0.5)
            self.assertLess(figures["arcs"] + figures["lines"], 60)
            self.assertNotRegex(self.program.read_text(), r"\nG1[89]\n")
            areas[direction] = len([line for line in self.moves() if re.match("G2(?!1)", line)])
            done = run("sim", self.program, *SETTINGS, "--stock", "-2,-2,22,22,0,-6", "--tool", 6)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("a rapid cuts stock", done.stdout + done.stderr)
        self.assertNotEqual(areas["climb"], areas["conventional"])
        self.assertIn("finishing in waterlines", self.program.read_text())
        self.assertEqual(self.surface(*place, "--lines", file=block).returncode, 0)
        self.assertFalse([line for line in self.moves() if re.match("G[23](?!1)", line)])

    def test_levels_are_as_near_as_the_scallop_asks(self):
        lengths = []
        for scallop in (0.08, 0.02):
            done = self.surface("--tool", "ball:3", "--tolerance", TOLERANCE, "--paths", "waterline", "--scallop",
                                scallop)
            self.assertEqual(done.returncode, 0, done.stderr)
            lengths.append(json.loads(self.report.read_text())["row_length_mm"])
        self.assertGreater(lengths[1], 1.5 * lengths[0])

    def roughed(self, *options):
        """Returns the figures of a program that roughs a block with a dome, and the output of the
        simulated machine.
        """
        dome = self.folder / "dome.xyz"
        dome.write_text("".join(f"{x} {y} {max(-9.0, -(x - 14) ** 2 / 16 - (y - 12) ** 2 / 12):.4f}\n"
                                for y in range(25) for x in range(33)))
        done = self.surface("--tool", 4, "--tolerance", TOLERANCE, "--stock-top", 0, "--paths", "rough", "--layers", 3,
                            "--allowance", 0.4, "--ramp", 5, "--slot-feed", 700, *options, file=dome)
        self.assertEqual(done.returncode, 0, done.stderr)
        carved = run("sim", self.program, *SETTINGS, "--stock", "0,0,32,24,0,-12", "--tool", 4, "--stock-cell", 0.1,
                     "--stock-surface", dome)
        self.assertEqual(carved.returncode, 0, carved.stderr)
        self.assertNotIn("a rapid cuts stock", carved.stdout + carved.stderr)
        gouge = re.search(r"gouge +([0-9.]+) to", carved.stdout)
        self.assertEqual(float(gouge.group(1)), 0.0, carved.stdout)
        return json.loads(self.report.read_text()), carved.stdout

    def test_roughs_in_levels_from_above_and_from_beside_the_stock(self):
        drawing = self.folder / "half.svg"
        drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="16mm" height="24mm" viewBox="0 0 16 24">'
                           '<rect width="15" height="24"/></svg>')
        lengths = []
        for options in ((), ("--stock-margin", 0), ("--stock-margin", 1.5), ("--boundary", drawing), ("--step", 3.5),
                        ("--direction", "conventional"), ("--lines",)):
            figures, printed = self.roughed(*options)
            self.assertGreater(figures["lowest_mm"], -9.0)
            self.assertGreater(figures["arcs"] + figures["lines"], 50)
            self.assertEqual(figures["arcs"] == 0, options == ("--lines",))
            program = self.program.read_text()
            self.assertFalse(re.search(r"\nG1[89]\n", program))
            # If the tool enters from outside of the stock, no pass has stock on both sides.
            self.assertEqual("F700" in program, "--stock-margin" not in options, options)
            self.assertTrue("roughing in levels of 3 mm" in program)
            self.assertIn("rest", printed)
            lengths.append(figures["row_length_mm"])
        self.assertLess(lengths[3], 0.8 * lengths[0])
        self.assertLess(lengths[4], 0.8 * lengths[0])

    def test_levels_leave_no_more_than_a_layer_where_the_tool_may_be(self):
        _, printed = self.roughed()
        rest = float(re.search(r"rest .* at least ([0-9.]+) mm", printed).group(1))
        self.assertLess(rest, 3.0 + 0.4 + 2 * TOLERANCE + 0.3)
        self.assertGreater(rest, 0.3)

    def test_refuses_options_that_mean_nothing_and_surfaces_without_lines(self):
        tool = ("--tool", "ball:3")
        block = self.folder / "block.stl"
        block.write_bytes(box_of_stl(20, 6))
        for options, file, told in (
                (("--paths", "waterline", "--angle", 30), self.part, "--angle: only rows have an angle"),
                (("--paths", "contour", "--order", "oneway"), self.part, "--order: only rows have an order"),
                (("--paths", "waterline", "--layers", 1), self.part, "--layers: only rows have layers"),
                (("--paths", "spiral"), self.part, "--paths"),
                (("--paths", "waterline"), block, "no level has a line"),
                (("--paths", "rough"), self.part, "give --layers"),
                (("--paths", "rough", "--layers", 1, "--slope", "0:30"), self.part, "--slope: is not possible with"),
                (("--paths", "rough", "--layers", 1, "--scallop", 0.1), self.part, "--scallop: is not possible with"),
                (("--paths", "rough", "--layers", 1, "--step", 2.9), self.part, "--step: 2.9 mm is more than"),
                (("--paths", "rough", "--layers", 1, "--stock-top", -90), self.part, "below the top of the stock"),
                (("--paths", "rough", "--layers", 1, "--margin", 1, "--stock-margin", 1), self.part, "--margin: with"),
                (("--stock-margin", 1), self.part, "--stock-margin: only --paths rough"),
                (("--paths", "contour", "--step", 50), self.part, "choose a smaller --step"),
                (("--paths", "contour", "--step", 0.001), self.part, "mill the surface in parts or in rows")):
            done = self.surface(*tool, *options, file=file)
            self.assertEqual(done.returncode, 2, (options, done.stderr))
            self.assertIn(told, done.stderr)
            self.assertFalse(self.program.exists())


if __name__ == "__main__":
    unittest.main()
