#!/usr/bin/env python3
"""The complete cycle of a measured part: probed by a machine, milled from the probed grid, carved,
and compared.

    probe_to_carve_test.py KERFLINE
"""

import math
import pathlib
import struct
import tempfile
import unittest

from pocket_bench import MACHINE, run

STEPS_PER_MM = 320
WIDTH, DEPTH = 16, 12
TOLERANCE, SCALLOP = 0.005, 0.02
# Limit for rounding corners and welding lines in the machine, mm.
CORNER = 0.001
SETTINGS = (*MACHINE, "--set", f"$11={CORNER}", "--set", f"$12={CORNER}")
# Rounding of the coordinates in an answer and in the program, mm.
ROUNDING = 0.002
# The carved stock has one height per cell. On the steepest slope this height is wrong by half a
# cell.
CELL = 0.025
CELL_ERROR = 0.5 * CELL * 0.9 * (0.35 + 0.3)


def part(x, y):
    return -4 + 0.9 * math.sin(0.35 * x) * math.cos(0.3 * y)


def part_grid(pitch=0.25, beyond=4):
    columns, rows = (1 + int((size + 2 * beyond) / pitch) for size in (WIDTH, DEPTH))
    places = [[(-beyond + pitch * c, -beyond + pitch * r) for c in range(columns)] for r in range(rows)]
    return "\n".join("".join(f"{x} {y} {part(x, y):.6f}\n" for x, y in row) for row in places)


def upper_points(ply):
    """Returns the highest point of a binary PLY at each point of the plan."""
    head, _, body = ply.partition(b"end_header\n")
    count = int(head.split(b"element vertex ")[1].split()[0])
    heights = {}
    for x, y, z in struct.iter_unpack("<3f", body[:12 * count]):
        heights[x, y] = max(z, heights.get((x, y), z))
    return heights


class ProbeToCarve(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def done(self, *call):
        result = run(*call)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def carve(self, tip_mm):
        """Returns the probed grid as a file, and the heights of the carved stock by point."""
        part_file, probe, log, grid, program, rest = (
            self.folder / name for name in ("part.xyz", "probe.nc", "probe.log", "grid.xyz", "part.nc", "rest.ply"))
        part_file.write_text(part_grid())
        self.done("surface", "probe-grid", "--x", f"0:{WIDTH}", "--y", f"0:{DEPTH}", "--pitch", 1, "--safe", 2,
                  "--depth", -9, "--feed", 200, "--tip", tip_mm, "-o", probe)
        self.done("sim", probe, *SETTINGS, "--probe-surface", part_file, "--probe-tip", tip_mm, "--answers", log)
        self.done("surface", "probe-grid", "--read", log, "--program", probe, "-o", grid)
        self.done("surface", grid, "--tool", "ball:3", "--tolerance", TOLERANCE, "--scallop", SCALLOP, "--feed", 1500,
                  "--plunge-feed", 800, "-o", program)
        self.done("sim", program, *SETTINGS, "--stock", f"0,0,{WIDTH},{DEPTH},0,-10", "--tool", "3,ball",
                  "--stock-cell", CELL, "--stock-ply", rest)
        return grid, upper_points(rest.read_bytes())

    def heights_of(self, grid, places):
        """Returns the heights of the surface at points, found with the tip of a very small ball."""
        wanted = self.folder / "places.txt"
        wanted.write_text("".join(f"{x} {y}\n" for x, y in places))
        rows = self.done("surface", grid, "--tool", "ball:0.01", "--at", wanted).stdout.splitlines()
        return [float(row.split()[2]) for row in rows]

    def test_what_is_carved_is_what_was_probed(self):
        for tip_mm in (0, 2):
            with self.subTest(tip_mm=tip_mm):
                grid, carved = self.carve(tip_mm)
                places = [(x, y) for x, y in carved if 2 < x < WIDTH - 2 and 2 < y < DEPTH - 2][::7]
                probed = self.heights_of(grid, places)
                off = [carved[place] - height for place, height in zip(places, probed)]
                step = 1 / STEPS_PER_MM
                print(f"tip {tip_mm} mm: {len(off)} places, {min(off):.4f} to {max(off):.4f} mm above the probed grid")
                self.assertGreater(min(off), -step - CORNER - ROUNDING - CELL_ERROR)
                # In a valley between facets, a ball leaves material that no ball of its size can
                # reach.
                most = 2 * TOLERANCE + SCALLOP + step + CORNER + ROUNDING + CELL_ERROR
                self.assertLess(max(off), most + 0.5 ** 2 / (8 * 1.5))
                meant = [height - part(*place) for place, height in zip(places, probed)]
                # The grid has chords of 1 mm. The curvature of the tip adds to that of the part.
                self.assertLess(max(map(abs, meant)), 0.11 * 2 / 8 + step + ROUNDING)


if __name__ == "__main__":
    unittest.main()
