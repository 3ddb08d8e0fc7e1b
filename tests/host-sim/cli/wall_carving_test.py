#!/usr/bin/env python3
"""kerfline wall carve and taper as their users call them: blocks burned by beams, measured walls, gains, refusals.

    wall_carving_test.py KERFLINE
"""

import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

KERFLINE = sys.argv.pop(1)
HALF, OUTER, DEPTH = 0.3, 0.6, 0.5


def run(*arguments):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"})


def pit_stl():
    """Returns a block with a square pit as a binary STL, its top at Z 0."""
    def ring(half, z):
        return [(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)]
    floor, rim = ring(HALF, -DEPTH), ring(HALF, 0)
    top, bottom = ring(OUTER, 0), ring(OUTER, -DEPTH - 0.1)
    quads = [floor, bottom[::-1]]
    for i in range(4):
        j = (i + 1) % 4
        quads += [[floor[j], floor[i], rim[i], rim[j]], [rim[i], top[i], top[j], rim[j]],
                  [bottom[i], bottom[j], top[j], top[i]]]
    facets = [facet for a, b, c, d in quads for facet in ((a, b, c), (a, c, d))]
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(value for corner in facet for value in corner), 0)
                    for facet in facets)
    return b"pit".ljust(80) + struct.pack("<I", len(facets)) + body


def tips(layers=50, samples=8):
    """Returns a list of tips along each wall, for each layer."""
    corners = [(-HALF, -HALF), (HALF, -HALF), (HALF, HALF), (-HALF, HALF)]
    for layer in range(1, layers + 1):
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
            yield [(ax + (bx - ax) * k / samples, ay + (by - ay) * k / samples, -DEPTH * layer / layers)
                   for k in range(samples + 1)]


class WallCarving(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.part = self.folder / "pit.stl"
        self.part.write_bytes(pit_stl())

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def upright(self):
        return self.file("upright.txt", "\n\n".join(
            "\n".join(f"{x:.9g} {y:.9g} {z:.9g} 0 0 1" for x, y, z in stroke) for stroke in tips()))

    def leaning(self, *more):
        """Returns the beams of least tilt at the same tips."""
        strokes = list(tips())
        places = self.file("tips.txt", "".join(f"{x:.9g} {y:.9g} {z:.9g}\n" for s in strokes for x, y, z in s))
        done = run("wall", self.part, "--half-angle", 7, "--at", places, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = iter(done.stdout.splitlines())
        return self.file("leaning.txt", "\n\n".join("\n".join(next(lines) for _ in s) for s in strokes))

    def carve(self, beams, *more):
        done = run("wall", "carve", self.part, "--beams", beams, "--half-angle", 7, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line.split() for line in done.stdout.splitlines() if line[0] != "#"], done.stderr

    def test_measures_walls_with_and_without_avoidance(self):
        picture, carved = self.folder / "section.svg", self.folder / "carved.stl"
        rows, err = self.carve(self.leaning(), "--beside", self.upright(), "--section=-0.6,0,0.6,0",
                               "--picture-section", picture, "--carved", carved)
        walls = [row for row in rows if row[6] != "-"]
        self.assertEqual((len(rows), len(walls)), (8, 4), rows)
        for row in walls:
            self.assertAlmostEqual(float(row[5]), 0, delta=1e-3)
            self.assertAlmostEqual(float(row[6]), 0, delta=0.5)
            self.assertAlmostEqual(float(row[8]), 7, delta=0.2)
        self.assertIn("leaning.txt: 4 walls carved, off the drawn angle by", err)
        self.assertIn("; 4 not carved", err)
        self.assertEqual(picture.read_text().count('fill="#aab2bd"'), 2)
        # The carved stock is a closed body, which can be used as a part.
        done = run("wall", carved, "--half-angle", 7, "--at", self.file("at", "0 0 1\n"))
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_cancels_heat_by_the_gain_of_measured_cuts(self):
        hot, _ = self.carve(self.leaning(), "--heat", 13)
        carved = [float(row[6]) for row in hot if row[6] != "-"]
        self.assertEqual(len(carved), 4)
        for angle in carved:
            self.assertAlmostEqual(angle, 13, delta=0.3)
        done = run("wall", "taper", self.file("cuts.txt", "".join(f"0 {angle}\n" for angle in carved)),
                   "--half-angle", 7)
        self.assertEqual(done.returncode, 0, done.stderr)
        gain = float(done.stdout.split("--taper-gain ")[1])
        self.assertAlmostEqual(gain, 13 / 7, delta=0.05)
        rows, _ = self.carve(self.leaning("--taper-gain", gain), "--heat", 13)
        for row in rows:
            if row[6] != "-":
                self.assertAlmostEqual(float(row[6]), 0, delta=0.5)

    def test_fits_the_response_of_several_gains(self):
        # The wall is 10 degrees wider by heat, and a lean reduces this by 80 % of the lean. The
        # last wall gives no information.
        cuts = self.file("cuts.txt", "# drawn carved gain\n0 10\n2 12 0\n0 4.4 1\n2 6.4 1\n30 30 1\n")
        done = run("wall", "taper", cuts, "--half-angle", 7)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("by 10.000 degrees; an additional lean of the beam reduces this by 0.800", done.stdout)
        self.assertIn(f"--taper-gain {10 / 5.6:.4f}", done.stdout)
        self.assertIn("4 cuts, off by 0.000 degrees (root mean square); 1 that", done.stderr)

    def test_refuses_with_place_and_remedy_and_writes_nothing(self):
        output = self.folder / "walls.txt"
        good = self.file("good.txt", "0 0 -0.1 0 0 1\n")
        carve = ("wall", "carve", self.part, "--half-angle", 7, "-o", output, "--beams")
        calls = (
            ((*carve, self.file("a", "0 0 0 0 0 1\n1 2 3\n")), "a:2: `1 2 3` is not a beam; give"),
            ((*carve, self.file("b", "0 0 0 1 0 0\n")), "b:1: "),
            ((*carve, self.file("c", "0 0 0 0 0 1 -1\n")), "c:1: "),
            ((*carve, self.file("d", "nan 0 0 0 0 1\n")), "d:1: "),
            ((*carve, self.file("e", "# 0 0 0 is out of reach\n")), "e: has no beam"),
            ((*carve, good, "--cell", 0.001, "--around", 20), "--cell: cells of 0.001 mm on 41.2 by 41.2"),
            ((*carve, good, "--depth", 0.1), "add --waist"),
            (("wall", "carve", self.part, "--beams", good, "--half-angle", 30, "--heat", 60), "exceed 85 degrees"),
            ((*carve, good, "--section", "0,0,1,1"), "--section and --picture-section require each other"),
            ((*carve, good, "--section", "1,1,1,1", "--picture-section", "a.gif"), "is no format of a picture"),
            ((*carve, good, "--section", "1,1,1,1", "--picture-section", "a.svg"), "both ends are one point"),
            (("wall", "taper", self.file("f", "0 13\n0 x\n"), "--half-angle", 7), "f:2: `0 x` is not a cut"),
            (("wall", "taper", self.file("g", "30 30\n"), "--half-angle", 7), "only walls that an upright beam"),
            (("wall", "taper", self.file("h", "0 5 0\n0 9 1\n"), "--half-angle", 7), "no gain from 0 to 12"),
            (("wall", self.part, "--half-angle", 30, "--taper-gain", 3, "--at", good), "leave no beam"),
        )
        for call, message in calls:
            done = run(*call)
            self.assertEqual(done.returncode, 2, call)
            self.assertIn(message, done.stderr)
            self.assertFalse(output.exists())


if __name__ == "__main__":
    unittest.main()
