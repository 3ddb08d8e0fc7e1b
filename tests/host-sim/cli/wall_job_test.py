#!/usr/bin/env python3
"""kerfline wall --layer: the program is interpreted here, and its cone is compared with the walls
of the part.

    wall_job_test.py KERFLINE
"""

import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

KERFLINE = sys.argv.pop(1)
HALF_ANGLE = 7
BURN = ("--half-angle", HALF_ANGLE, "--power", 10, "--full-power", 20, "--feed", 600)
OFF_MM = 1.2e-3  # Depth between tips, and rounding of the words.


def run(*arguments):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"})


def stl(facets):
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(value for corner in facet for value in corner), 0)
                    for facet in facets)
    return b"part".ljust(80) + struct.pack("<I", len(facets)) + body


def facets_of(quads):
    return [facet for a, b, c, d in quads for facet in ((a, b, c), (a, c, d))]


def ring(half, z, half_y=None):
    y = half if half_y is None else half_y
    return [(-half, -y, z), (half, -y, z), (half, y, z), (-half, y, z)]


def pocket(half, half_y=None, depth=0.5):
    """Returns a block with a pocket: its floor is at Z 0, its top at Z `depth`."""
    floor, rim = ring(half, 0, half_y), ring(half, depth, half_y)
    top, bottom = ring(4, depth), ring(4, -1)
    quads = [floor, bottom[::-1]]
    for i in range(4):
        j = (i + 1) % 4
        quads += [[floor[j], floor[i], rim[i], rim[j]], [rim[i], top[i], top[j], rim[j]],
                  [bottom[i], bottom[j], top[j], top[i]]]
    return stl(facets_of(quads))


def block(rings):
    """Returns a stack of rings as a solid."""
    quads = [rings[0][::-1], rings[-1]]
    for low, high in zip(rings, rings[1:]):
        quads += [[low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]] for i in range(4)]
    return stl(facets_of(quads))


def axis_of(tilt, turn, is_ac):
    t, c = math.radians(tilt), math.radians(turn)
    if is_ac:
        return (math.sin(c) * math.sin(t), -math.cos(c) * math.sin(t), math.cos(t))
    return (math.cos(c) * math.sin(t), math.sin(c) * math.sin(t), math.cos(t))


def cone(axis, count=180):
    """Returns directions along the side of a beam."""
    x, y, z = axis
    across = math.hypot(x, z)
    one = (z / across, 0.0, -x / across)
    other = (y * one[2] - z * one[1], z * one[0] - x * one[2], x * one[1] - y * one[0])
    cosine, sine = math.cos(math.radians(HALF_ANGLE)), math.sin(math.radians(HALF_ANGLE))
    for i in range(count):
        turn = 2 * math.pi * i / count
        yield tuple(cosine * axis[k] + sine * (math.cos(turn) * one[k] + math.sin(turn) * other[k]) for k in range(3))


class Drive:
    """A program as a machine executes it: `cuts` are pairs of (tip, tilt, turn)."""

    def __init__(self, program):
        self.cuts, self.rapids, self.s, self.feed = [], [], set(), set()
        now = dict.fromkeys("XYZABC", 0.0)
        self.is_ac = not re.search(r"^G[01].*B", program, re.M)
        for line in program.splitlines():
            words = re.findall(r"([A-Z])(-?[\d.]+)", re.sub(r"\(.*\)", "", line))
            values = {letter: float(value) for letter, value in words if letter != "G"}
            before = dict(now)
            now.update({letter: value for letter, value in values.items() if letter in now})
            self.s |= {values["S"]} if values.get("S") else set()
            self.feed |= {values["F"]} if "F" in values else set()
            motion = line.split()[0] if line else ""
            if motion == "G1":
                self.cuts.append((self.state(before), self.state(now)))
            elif motion == "G0":
                self.rapids.append((self.state(before), self.state(now)))

    def state(self, now):
        return (now["X"], now["Y"], now["Z"], now["A" if self.is_ac else "B"], now["C"])

    def states(self, parts=4):
        """Yields tips and axes along all cuts."""
        for begin, end in self.cuts:
            for i in range(parts + 1):
                here = [a + (b - a) * i / parts for a, b in zip(begin, end)]
                yield here[:3], axis_of(here[3], here[4], self.is_ac)


def deepest_in_pocket(drive, half, half_y, depth):
    """Returns the greatest depth of the beam's side in the walls of a pocket, mm."""
    worst = -1e9
    for tip, axis in drive.states():
        for way in cone(axis):
            up = max(0.0, depth - tip[2]) / way[2]
            worst = max(worst, abs(tip[0] + up * way[0]) - half, abs(tip[1] + up * way[1]) - half_y)
    return worst


class WallJob(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.output = self.folder / "part.nc"

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def job(self, part, *more, code=0):
        done = run("wall", self.file("part.stl", part), *BURN, "-o", self.output, *more)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_drives_a_beam_that_clears_the_walls_of_a_pocket(self):
        for axes in ("AC", "BC"):
            for turn in (0, 67):
                beams, report = self.folder / "beams.txt", self.folder / "report.json"
                self.job(pocket(1, 0.75), "--layer", 0.1, "--hatch", 0.1, "--hatch-turn", turn, "--axes", axes,
                         "--beams", beams, "--report", report)
                program = self.output.read_text()
                drive = Drive(program)
                self.assertEqual(drive.is_ac, axes == "AC")
                self.assertLess(deepest_in_pocket(drive, 1, 0.75, 0.5), OFF_MM)
                self.assertEqual({round(end[2], 6) for _, end in drive.cuts}, {0.4, 0.3, 0.2, 0.1, 0.0})
                self.assertLess(program.index("G43.4"), program.index("M4 S0"))
                self.assertTrue(program.endswith("G49\nM2\n"))
                self.assertEqual((drive.s, max(drive.feed)), ({500.0}, 600.0))
                figures = json.loads(report.read_text())
                self.assertEqual(figures["layers_cut"], 5)
                self.assertEqual(figures["tips_out_of_reach"], 0)
                self.assertAlmostEqual(figures["greatest_tilt_deg"], 9.924, delta=1e-3)
                self.assertLess(figures["slowed_length_mm"], 0.01 * figures["burnt_length_mm"])
                rows = [[float(word) for word in line.split()] for line in beams.read_text().splitlines()]
                self.assertEqual(len(rows), figures["beams"])
                for row in rows:
                    self.assertAlmostEqual(math.hypot(*row[3:]), 1, delta=1e-12)
                # All positions of the program are beams of the list.
                places = {tuple(round(value, 4) + 0.0 for value in row[:3]) for row in rows}
                for _, end in drive.cuts:
                    self.assertIn(tuple(round(value, 4) + 0.0 for value in end[:3]), places)

    def test_upright_beams_burn_the_walls_by_the_half_angle(self):
        self.job(pocket(1, 0.75), "--layer", 0.1, "--hatch", 0.1, "--avoid", "none")
        drive = Drive(self.output.read_text())
        self.assertTrue(all(axis == (0.0, 0.0, 1.0) for _, axis in drive.states(1)))
        self.assertAlmostEqual(deepest_in_pocket(drive, 1, 0.75, 0.5), 0.5 * math.tan(math.radians(7)), delta=1e-3)

    def test_hatches_all_of_the_layers(self):
        done = self.job(block([ring(1, 0), ring(1, 0.5)]), "--layer", 0.25, "--hatch", 0.2, "--stock-margin", 1)
        self.assertIn("2 layers of 0.25 mm", done.stdout)
        drive = Drive(self.output.read_text())
        length = sum(math.dist(begin[:3], end[:3]) for begin, end in drive.cuts)
        # In each of two layers, lines 0.2 mm apart cover 16 mm2 less the 4 mm2 of the part, and
        # 8 mm run around the part.
        self.assertAlmostEqual(length, 2 * (12 / 0.2 + 8), delta=0.1)
        # The border of the stock is not a wall.
        self.assertFalse(any(begin[0] == end[0] and abs(end[0]) == 2 for begin, end in drive.cuts))
        self.job(block([ring(1, 0), ring(1, 0.5)]), "--layer", 0.25, "--hatch", 0.2, "--stock-margin", 1,
                 "--no-contour", "--hatch-angle", 90)
        drive = Drive(self.output.read_text())
        self.assertTrue(all(begin[0] == end[0] for begin, end in drive.cuts))

    def test_keeps_the_waist_off_the_walls(self):
        self.job(pocket(1, 0.75), "--layer", 0.25, "--waist", 0.05)
        drive = Drive(self.output.read_text())
        self.assertEqual({max(abs(end[0]) - 0.95, abs(end[1]) - 0.7) <= 1e-4 for _, end in drive.cuts}, {True})
        sine = math.sin(math.radians(HALF_ANGLE))
        worst = max(tip[0] + (0.5 - tip[2]) * (axis[0] / axis[2]) + 0.05 +
                    (0.5 - tip[2]) * math.tan(math.radians(HALF_ANGLE)) for tip, axis in drive.states())
        self.assertLess(worst, 1 + 0.05 * sine + 2e-3)

    def test_names_what_is_out_of_reach_and_burns_it_where_asked(self):
        slot = pocket(1, 0.04)
        beams = self.folder / "beams.txt"
        done = self.job(slot, "--layer", 0.25, "--beams", beams, code=1)
        lost = beams.read_text().count("is out of reach")
        self.assertGreater(lost, 0)
        self.assertIn(f"{lost} tips are out of reach", done.stderr)
        done = self.job(slot, "--layer", 0.25, "--beams", beams, "--allow-lean")
        self.assertEqual(beams.read_text().count("is out of reach"), 0)
        # At the depth of 0.5 mm at one wall, a beam fits up to the rim of the other wall, 0.08 mm
        # away.
        left = 7 - math.degrees(math.atan(0.08 / 0.5)) / 2
        self.assertIn("beams enter the part, by up to", done.stderr)
        self.assertAlmostEqual(float(re.search(r"by up to ([\d.]+)", done.stderr)[1]), left, delta=0.02)

    def test_warns_of_undercuts_with_the_place(self):
        done = self.job(block([ring(1, 0), ring(1, 1), ring(2, 1), ring(2, 2)]), "--layer", 0.5, "--hatch", 0.5,
                        "--stock-margin", 1)
        self.assertIn("overhangs 12.000 mm2", done.stderr)
        self.assertRegex(done.stderr, r"most at \S+ \S+ 1\.000; the stock below stays")
        self.assertTrue(all(max(abs(end[0]), abs(end[1])) >= 2 - 1e-6 for _, end in Drive(
            self.output.read_text()).cuts))

    def test_takes_the_depth_of_a_pass_from_a_record(self):
        record = self.file("record.json", json.dumps({"passes": [
            {"power_w": 10, "feed_mm_min": 1200, "depth_mm": 0.1},
            {"power_w": 10, "feed_mm_min": 400, "depth_mm": 0.4}]}))
        done = self.job(pocket(1), "--record", record)
        # 1 J/mm is in the middle between 0.5 and 1.5.
        self.assertIn("2 layers of 0.25 mm", done.stdout)

    def test_refuses_with_reason_and_remedy_and_writes_nothing(self):
        part = self.file("part.stl", pocket(1))
        flat = self.file("flat.stl", stl([((0, 0, 0), (1, 0, 0), (0, 1, 0)), ((0, 0, 0), (0, 1, 0), (1, 0, 0))]))
        block_only = self.file("block.stl", block([ring(1, 0), ring(1, 1)]))
        one = self.file("one.json", '{"passes": [{"power_w": 10, "feed_mm_min": 1200, "depth_mm": 0.1}]}')
        nan = self.file("nan.json", '{"passes": [{"power_w": 10, "feed_mm_min": 0, "depth_mm": 0.1}]}')
        two = self.file("two.json", '{"passes": [{"power_w": 1, "feed_mm_min": 1200, "depth_mm": 0.1},'
                                    ' {"power_w": 2, "feed_mm_min": 1200, "depth_mm": 0.2}]}')
        text = self.file("text.json", "passes")
        half = ("--half-angle", 7)
        burn = (*half, "--power", 10, "--feed", 600)
        calls = (
            ((part, *half, "--layer", 0.1), "--power is missing"),
            ((part, *half, "--layer", 0.1, "--power", 10), "--feed is missing"),
            ((part, *burn, "--layer", 0.1, "--max-tilt", 6), "--max-tilt: 6 degrees do not clear"),
            ((part, *burn, "--layer", 0.1, "--no-contour"), "--no-contour: without --hatch nothing is cut"),
            ((part, *burn, "--layer", 0.1, "--record", two), "--record: the depth of a layer is given"),
            ((part, *burn, "--layer", 0.1, "--stock-top", 0.2), "--stock-top: 0.2 mm is below the part's top"),
            ((part, *burn, "--layer", 0.1, "--full-power", 5), "exceeds the 5 W"),
            ((part, *burn, "--layer", 0), "--layer"),
            ((part, *burn, "--record", one), "one.json: has passes of fewer than two energies"),
            ((part, *burn, "--record", nan), "nan.json: a pass has no `feed_mm_min` above 0"),
            ((part, *burn, "--record", text), "text.json: is not a record"),
            ((part, *burn, "--record", two), "10 W at 600 mm/min are 1 J/mm, but only 0.05 to 0.1 were measured"),
            ((flat, *burn, "--layer", 0.1), "flat.stl: encloses no volume"),
            ((block_only, *burn, "--layer", 0.1), "leaves nothing to remove in 10 layers of 0.1 mm"),
            ((part, *half, "--at", one, "--layer", 0.1), "--at: gives the tips and excludes"),
            ((part, *half, "--at", one, "--beams", self.folder / "b"), "describe the program of layers"),
        )
        for call, message in calls:
            done = run("wall", *call, "-o", self.output)
            self.assertEqual(done.returncode, 2, call)
            self.assertIn(message, done.stderr)
            self.assertFalse(self.output.exists(), call)


if __name__ == "__main__":
    unittest.main()
