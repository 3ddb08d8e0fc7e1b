#!/usr/bin/env python3
"""kerfline wall as its users call it: beams that lean away from walls, cones that other programs
can check, and refusals.

    wall_command_test.py KERFLINE
"""

import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

KERFLINE = sys.argv.pop(1)


def run(*arguments, text=None):
    return subprocess.run([KERFLINE, *map(str, arguments)], input=text, capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"})


def pocket_stl(inner=20, outer=60, depth=2, open_floor=False):
    """Returns a block with a square pocket as a binary STL: its floor at Z 0, its top at Z `depth`."""
    def ring(half, z):
        return [(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)]
    floor, rim = ring(inner / 2, 0), ring(inner / 2, depth)
    top, bottom = ring(outer / 2, depth), ring(outer / 2, -5)
    quads = [] if open_floor else [floor]
    quads += [bottom[::-1]]
    for i in range(4):
        j = (i + 1) % 4
        quads += [[floor[j], floor[i], rim[i], rim[j]], [rim[i], top[i], top[j], rim[j]],
                  [bottom[i], bottom[j], top[j], top[i]]]
    facets = [facet for a, b, c, d in quads for facet in ((a, b, c), (a, c, d))]
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(value for corner in facet for value in corner), 0)
                    for facet in facets)
    return b"pocket".ljust(80) + struct.pack("<I", len(facets)) + body


class WallCommand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "pocket.stl"
        self.part.write_bytes(pocket_stl())

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def beams(self, tips, *more, half_angle=7):
        return run("wall", self.part, "--half-angle", half_angle, "--at", self.file("tips.txt", tips), *more)

    def test_leans_beams_away_from_walls(self):
        done = self.beams("# middle, wall, corner, rim\n0 0 0\n10 0 0\n10 10 0\n10 0 2\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [[float(word) for word in line.split()] for line in done.stdout.splitlines()]
        tilts = [math.degrees(math.acos(min(1, row[5]))) for row in rows]
        for tilt, wanted in zip(tilts, (0, 7, math.degrees(math.asin(math.sqrt(2) * math.sin(math.radians(7)))), 0)):
            self.assertAlmostEqual(tilt, wanted, delta=1e-3)
        self.assertLess(rows[1][3], 0)
        self.assertIn("greatest tilt 9.924 degrees, 0 tips out of reach", done.stderr)

    def test_keeps_the_margin_and_the_greatest_tilt(self):
        done = self.beams("10 0 0\n", "--margin-angle", 0.5)
        self.assertIn("greatest tilt 7.500 degrees", done.stderr)
        done = self.beams("10 10 0\n0 0 0\n", "--max-tilt", 9)
        self.assertEqual(done.returncode, 1)
        self.assertIn("# 10 10 0 is out of reach\n0 0 0 ", done.stdout)
        # A beam cannot reach a tip within the part. A tip less than 1 um within the wall counts as
        # on the wall.
        done = self.beams("12 0 0\n10.0005 0 0\n")
        self.assertEqual(done.stdout.count("out of reach"), 1, done.stdout)

    def test_answers_lines_of_cones(self):
        level = "-9 -9 5 9 -9 5 0 9 5"
        cones = self.file("cones.txt", f"# axis through a face, beside it, touching, above the lens\n"
                          f"0 0 0 0 0 2 0.64 10 {level}\n30 0 0 0 0 1 0.64 10 {level}\n"
                          "0 0 0 0 0 1 0.64 10 3 0 4 3 1 4 9 0 4\n0 0 0 0 0 1 0.64 4 " + level + "\n")
        done = run("wall", "--cones", cones)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split() for line in done.stdout.splitlines()]
        self.assertEqual([row[0] for row in rows], ["1", "0", "1", "0"])
        self.assertAlmostEqual(float(rows[0][1]), -3)
        self.assertGreater(float(rows[1][1]), 5)
        self.assertAlmostEqual(float(rows[2][1]), 0, delta=1e-12)
        self.assertEqual(rows[3][1], "inf")

    def test_refuses_with_place_and_remedy_and_writes_nothing(self):
        output = self.folder / "beams.txt"
        tips = self.file("tips.txt", "0 0 0\n")
        hole = self.folder / "hole.stl"
        hole.write_bytes(pocket_stl(open_floor=True))
        calls = (
            ((hole, "--half-angle", 7, "--at", tips), "hole.stl: does not enclose a solid: the edge from 10 -10 0"),
            ((self.part, "--half-angle", 7), "--at is missing"),
            ((self.part, "--at", tips), "--half-angle is missing"),
            ((self.part, "--half-angle", 90, "--at", tips), "--half-angle"),
            ((self.part, "--half-angle", 80, "--margin-angle", 10, "--at", tips), "leave no beam"),
            ((self.part, "--half-angle", 7, "--at", self.file("a", "0 0 0\n1 2\n")), "a:2: `1 2` is not a valid line"),
            ((self.part, "--half-angle", 7, "--at", self.file("b", "nan 0 0\n")), "b:1: `nan 0 0` is not a valid line"),
            ((self.part, "--half-angle", 7, "--at", self.file("c", "#\n")), "is empty"),
            (("--cones", self.file("d", "0 0 0 0 0 0 0.5 1 0 0 1 1 0 1 0 1 1\n")), "d:1:"),
            (("--cones", self.file("e", "0 0 0 0 0 1 1.0 1 0 0 1 1 0 1 0 1 1\n")), "e:1:"),
            ((self.part, "--cones", tips), "excludes FILE"),
        )
        for call, message in calls:
            done = run("wall", *call, "-o", output)
            self.assertEqual(done.returncode, 2, call)
            self.assertIn(message, done.stderr)
            self.assertFalse(output.exists())


if __name__ == "__main__":
    unittest.main()
