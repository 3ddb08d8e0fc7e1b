#!/usr/bin/env python3
"""kerfline surface as its users call it: programs that the simulated machine takes, heights and refusals.

    surface_command_test.py KERFLINE
"""

import json
import math
import pathlib
import re
import struct
import tempfile
import unittest

from pocket_bench import MACHINE, run

MILL = ("--feed", "1500", "--plunge-feed", "500")


def scan(rows=21, columns=31, pitch=0.5, height=lambda x, y: 2 * math.sin(0.5 * x) * math.cos(0.4 * y)):
    lines = []
    for row in range(rows):
        for column in range(columns):
            x, y = pitch * column, pitch * row
            lines.append(f"{x:.3f} {y:.3f} {height(x, y):.4f}")
        lines.append("")
    return "\n".join(lines) + "\n"


def box_of_stl(side, top):
    """Returns a block as a binary STL with its bottom at Z 0."""
    corners = [(x, y, z) for z in (0, top) for y in (0, side) for x in (0, side)]
    faces = ((0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2),
             (2, 4, 6), (1, 3, 5), (3, 7, 5))
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *(part for corner in face for part in corners[corner]), 0)
                      for face in faces)
    return b"block".ljust(80) + struct.pack("<I", len(faces)) + facets


class SurfaceCommand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "scan.nc"
        self.scan = self.folder / "scan.xyz"
        self.scan.write_text(scan())

    def surface(self, *options, file=None):
        return run("surface", file or self.scan, "-o", self.program, *options)

    def simulated(self, *more):
        report = self.folder / "sim.json"
        done = run("sim", self.program, *MACHINE, "--report", report, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(report.read_text())

    def test_mills_a_scan_in_arcs_that_the_machine_drives(self):
        report = self.folder / "scan.json"
        done = self.surface("--tool", "ball:4", "--step", 0.5, *MILL, "--spindle", 16000, "--coolant", "flood",
                            "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertGreater(figures["arcs"], 21)
        self.assertEqual(figures["lifts"], 1)
        self.assertGreater(figures["row_length_mm"], 21 * 15)
        text = self.program.read_text()
        for line in ("G21 G90 G17 G94 G54", "S16000 M3", "M8", "G18", "M9", "M5", "M2"):
            self.assertIn(line + "\n", text)
        self.assertRegex(text, r"\(kerfline digest surface=[0-9a-f]{16} scan.xyz\)")
        driven = self.simulated()
        self.assertEqual(driven["faults"], [])
        self.assertAlmostEqual(driven["bounds_mm"]["X"][1], 15.0, 2)
        self.assertAlmostEqual(driven["bounds_mm"]["Y"][1], 10.0, 2)
        self.assertAlmostEqual(driven["bounds_mm"]["Z"][0], figures["lowest_mm"], 2)

    def test_rows_along_y_are_arcs_of_g19_and_others_lines(self):
        self.assertEqual(self.surface("--tool", "4,ball", "--angle", 90, *MILL).returncode, 0)
        self.assertIn("\nG19\n", self.program.read_text())
        self.assertEqual(self.simulated()["faults"], [])
        for options in (("--angle", 30), ("--lines",)):
            self.assertEqual(self.surface("--tool", "4,ball", *options, *MILL).returncode, 0)
            moves = [line for line in self.program.read_text().splitlines() if not line.startswith("(")]
            self.assertFalse([line for line in moves if re.match("G[23](?!1)", line)])
            self.assertEqual(self.simulated()["faults"], [])

    def test_adds_rows_where_scallops_would_be_too_high(self):
        report = self.folder / "scan.json"
        lengths = []
        for scallop in (0.1, 0.02):
            done = self.surface("--tool", "ball:3", "--tolerance", 0.005, "--scallop", scallop, *MILL, "--report",
                                report)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.simulated()["faults"], [])
            lengths.append(json.loads(report.read_text())["row_length_mm"])
        self.assertGreater(lengths[1], 1.8 * lengths[0])

    def test_roughs_in_layers_and_never_goes_through_stock_in_a_rapid(self):
        tool = ("--tool", "4,bull,0.5", "--allowance", 0.3, "--layers", 1.2, "--step", 1.5)
        below = ("--move", "0,0,-3", "--stock-top", 0)  # The machine begins at Z 0.
        self.assertEqual(self.surface(*tool, *below, "--margin", 3, *MILL).returncode, 0)
        self.assertIn("(layers of 1.2 mm in rows", self.program.read_text())
        stock = ("--stock", "0,0,15,10,0,-8", "--stock-cell", 0.1)
        roughed = run("sim", self.program, *MACHINE, *stock, "--tool", "4,bull,0.5")
        self.assertEqual(roughed.returncode, 0, roughed.stderr)
        self.assertNotIn("a rapid cuts stock", roughed.stderr + roughed.stdout)
        # A run that has the full stock in front of it enters slowly.
        self.assertEqual(self.surface("--tool", "ball:4", *below, *MILL).returncode, 0)
        raw = run("sim", self.program, *MACHINE, *stock, "--tool", "4,ball")
        self.assertNotIn("a rapid cuts stock", raw.stderr + raw.stdout)

    def test_leaves_an_allowance_and_stops_at_a_floor(self):
        self.scan.write_text(scan(height=lambda x, y: -4.0))
        self.assertEqual(self.surface("--tool", 6, "--allowance", 0.3, *MILL).returncode, 0)
        low = self.simulated()["bounds_mm"]["Z"][0]
        # The flat tool on a plane is above it by the allowance, and by the tolerance of 0.01 mm at
        # most twice.
        self.assertGreaterEqual(low, -3.7)
        self.assertLessEqual(low, -3.6799)
        self.assertEqual(self.surface("--tool", 6, "--floor", -3.5, "--margin", 2, *MILL).returncode, 0)
        bounds = self.simulated()["bounds_mm"]
        self.assertGreaterEqual(bounds["Z"][0], -3.5)
        self.assertLessEqual(bounds["Z"][0], -3.4799)
        self.assertAlmostEqual(bounds["X"][0], -2.0, 2)

    def test_goes_round_a_block_where_a_floor_is_given_and_not_beyond_it_else(self):
        block = self.folder / "block.stl"
        block.write_bytes(box_of_stl(20, 6))
        options = ("--move", "0,0,-6", "--tool", "bull:6:1", "--step", 2, "--margin", 5, *MILL)
        self.assertEqual(self.surface(*options, "--floor", -6, file=block).returncode, 0)
        bounds = self.simulated()["bounds_mm"]
        self.assertAlmostEqual(bounds["Z"][0], -5.99, 1)
        self.assertAlmostEqual(bounds["X"][1], 25.0, 2)
        self.assertEqual(self.surface(*options, file=block).returncode, 0)
        bounds = self.simulated()["bounds_mm"]
        self.assertGreaterEqual(bounds["Z"][0], -1.01)  # The corner of 1 mm hangs over the block's edge.
        self.assertLess(bounds["X"][1], 23.1)

    def test_drives_slots_of_layers_slower(self):
        layers = ("--tool", "4,flat", "--step", 2, "--layers", 1.5, "--move", "0,0,-3", "--stock-top", 0, "--lines")
        self.assertEqual(self.surface(*layers, *MILL, "--slot-feed", 432).returncode, 0)
        text = self.program.read_text()
        cuts = re.split(r"\nG0 ", text)
        # Each layer begins with a slot; the rows next to it have a higher feed.
        self.assertIn("F432", text)
        self.assertIn("F1500", text)
        first = next(cut for cut in cuts if "F432" in cut)
        self.assertLess(first.index("F432"), first.find("F1500") % (len(first) + 1))
        self.assertEqual(self.surface("--tool", "4,flat", *MILL, "--slot-feed", 432).returncode, 2)

    def test_enters_stock_on_a_ramp_where_asked_to(self):
        stock = ("--stock", "0,0,15,10,0,-8", "--stock-cell", 0.1)
        for ramp in ((), ("--ramp", 5)):
            done = self.surface("--tool", "4,flat", "--step", 2, "--layers", 1.5, "--move", "0,0,-3", "--stock-top", 0,
                                "--lines", *MILL, *ramp)
            self.assertEqual(done.returncode, 0, done.stderr)
            text = self.program.read_text()
            # Sums up motion straight down at the feed: only the last hundredths of a mm behind a
            # ramp.
            drops, here = [], {}
            for line in text.splitlines():
                words = dict(re.findall(r"([GXYZ])(-?[\d.]+)", line))
                after = {**here, **{axis: float(words[axis]) for axis in "XYZ" if axis in words}}
                if words.get("G") == "1" and after.get("Z", 0) < here.get("Z", 0) and (
                        (after.get("X"), after.get("Y")) == (here.get("X"), here.get("Y"))):
                    drops.append(here["Z"] - after["Z"])
                here = after
            milled = run("sim", self.program, *MACHINE, *stock, "--tool", "4")
            self.assertEqual(milled.returncode, 0, milled.stderr)
            self.assertNotIn("a rapid cuts stock", milled.stderr + milled.stdout)
            # A run of less than 0.2 mm is too short for a ramp.
            deep = sum(drop > 0.03 for drop in drops)
            if ramp:
                self.assertLessEqual(deep, 2)
            else:
                self.assertGreater(deep, 5)

    def test_says_once_what_was_mended(self):
        part = self.folder / "block.stl"
        block = box_of_stl(10, 4)
        part.write_bytes(block[:80] + struct.pack("<I", 13) + block[84:] + block[84:96] + block[96:108] * 3 + b"\0\0")
        done = run("surface", part, "--tool", "ball:1", *MILL, "-o", self.program)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("1 facets without area"), 1)
        self.assertEqual(done.stderr.count(str(part)), 1)

    def test_turns_the_surface_towards_the_tool(self):
        part = self.folder / "block.stl"
        part.write_bytes(box_of_stl(10, 4))
        places = self.folder / "places.txt"
        # From the side, the block is 10 mm high and extends from X -4 to 0. From below, Y is
        # reversed.
        for approach, place, height in (("-1,0,0", "-2 5", 10), ("0,0,1", "5 -5", 0), ("0,0,-1", "5 5", 4)):
            places.write_text(place + "\n")
            done = run("surface", part, "--approach", approach, "--tool", "ball:1", "--at", places)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(float(done.stdout.split()[2]), height, approach)
        for approach in ("0,0,0", "nan,0,1"):
            done = run("surface", part, "--approach", approach, "--tool", "ball:1", "--at", places)
            self.assertEqual(done.returncode, 2)
            self.assertIn("--approach", done.stderr)

    def test_tells_heights_and_writes_the_mesh_that_counts(self):
        self.scan.write_text(scan(height=lambda x, y: 0.5 * x))
        places = self.folder / "places.txt"
        places.write_text("# X Y\n5 5\n7.25, 3.5\n\n100 100\n")
        mesh = self.folder / "scan.ply"
        done = run("surface", self.scan, "--tool", "ball:4", "--at", places, "--mesh", mesh)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split() for line in done.stdout.splitlines()]
        # On a slope, the centre of the ball is at right angles to it at a distance of 2 mm.
        lift = 2.0 * math.hypot(1.0, 0.5) - 2.0
        self.assertAlmostEqual(float(rows[0][2]), 2.5 + lift, 12)
        self.assertAlmostEqual(float(rows[1][2]), 3.625 + lift, 12)
        self.assertEqual(rows[2][2], "nan")
        again = run("surface", mesh, "--tool", "ball:4", "--at", places, "--heights", self.folder / "heights.txt")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.folder / "heights.txt").read_text(), done.stdout)

    def test_fits_patches_and_counts_flat_pieces_as_the_paper_does(self):
        self.scan.write_text(scan(41, 41, 0.5, lambda x, y: 4 * math.sin(0.5 * x) * math.cos(0.4 * y)))
        patches = self.folder / "patches.txt"
        done = run("surface", self.scan, "--tool", "ball:4", "--patches", patches, "--like-paper", "--fit-tolerance",
                   0.1, "--flatness", 0.1)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("patches fit 1681 points within 0.1 mm", done.stderr)
        hull, paper, both, halves = (int(count) for count in re.findall(r"(\d+) by", done.stdout))
        self.assertGreater(hull, 16)
        self.assertLessEqual(both, paper)
        self.assertLessEqual(paper, hull)
        self.assertLess(halves, both)
        lines = patches.read_text().splitlines()
        heads = [line.split() for line in lines if line.startswith("patch ")]
        self.assertEqual(len(lines), 17 * len(heads))
        covered = sum((float(u1) - float(u0)) * (float(v1) - float(v0)) for _, _, u0, u1, v0, v1 in heads)
        self.assertEqual(covered, 40 * 40)
        block = self.folder / "block.stl"
        block.write_bytes(box_of_stl(20, 6))
        done = run("surface", block, "--tool", "ball:4", "--like-paper")
        self.assertEqual(done.returncode, 2)
        self.assertIn("patches fit a grid of points", done.stderr)

    def test_reads_from_standard_input_and_writes_to_standard_output(self):
        self.assertEqual(self.surface("--tool", "ball:4", *MILL).returncode, 0)
        piped = run("surface", "-", "--tool", "ball:4", *MILL, text=self.scan.read_text())
        self.assertEqual(piped.returncode, 0, piped.stderr)
        self.assertEqual(piped.stdout.splitlines()[4:], self.program.read_text().splitlines()[4:])

    def test_refuses_what_makes_no_program_and_writes_none(self):
        good = ("--tool", "ball:4", *MILL)
        nan, uneven, empty = (self.folder / name for name in ("nan.xyz", "uneven.xyz", "empty.xyz"))
        nan.write_text(scan().replace("0.500 0.000", "0.500 nan", 1))
        uneven.write_text("0 0 0\n1 0 0\n\n0 1 0\n1 1 0\n2 1 0\n\n0 2 0\n1 2 0\n")
        empty.write_text("")
        for options, file, told in (
                (("--tool", "ball:4", "--plunge-feed", 100), self.scan, "--feed is missing"),
                (("--tool", "ball:4", "--feed", 100), self.scan, "--plunge-feed is missing"),
                (MILL, self.scan, "--tool is missing"),
                (("--tool", "ball", *MILL), self.scan, "`ball` is no number"),
                (("--tool", "egg:4", *MILL), self.scan, "must be a diameter in mm and flat, ball"),
                ((*good, "--safe", 0), self.scan, "is not above the path and the surface"),
                ((*good, "--tolerance", 0.0001), self.scan, "increase --decimals"),
                ((*good, "--tolerance", 0), self.scan, "--tolerance"),
                ((*good, "--step", 0), self.scan, "--step"),
                ((*good, "--scallop", 0.015), self.scan, "less than 2 times the --tolerance"),
                ((*good, "--heights", self.folder / "h.txt"), self.scan, "--heights: requires --at"),
                ((*good, "--like-paper"), self.scan, "--output: there is no program with --like-paper"),
                (good, nan, "nan.xyz:2"),
                (good, uneven, "uneven.xyz"),
                (good, empty, "empty.xyz"),
                (good, self.folder / "none.xyz", "none.xyz")):
            done = self.surface(*options, file=file)
            self.assertEqual(done.returncode, 2, (options, done.stderr))
            self.assertIn(told, done.stderr)
            self.assertFalse(self.program.exists())
        bad = self.folder / "bad.txt"
        bad.write_text("1 2\n3\n")
        done = run("surface", self.scan, "--tool", "ball:4", "--at", bad)
        self.assertEqual(done.returncode, 2)
        self.assertIn("bad.txt:2", done.stderr)

    def test_takes_a_tool_larger_than_the_part(self):
        self.assertEqual(self.surface("--tool", "ball:100", "--step", 1, *MILL).returncode, 0)
        self.assertEqual(self.simulated()["faults"], [])


if __name__ == "__main__":
    unittest.main()
