#!/usr/bin/env python3
"""kerfline surface probe-grid as its users call it: from a surface to the probed grid of this
surface.

    probe_grid_test.py KERFLINE
"""

import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
MACHINE = ("--set", "$102=250")
STEP_MM = 1 / 250
WORDS = ("--x", "0:20", "--y", "0:15", "--pitch", 5, "--safe", 4, "--depth", -8, "--feed", 120)


def run(*arguments, text=None):
    return subprocess.run([KERFLINE, *map(str, arguments)], input=text, capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"})


def plane(x, y):
    return -4 + 0.3 * x - 0.2 * y


def facet(corners):
    return struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *corner) for corner in corners) + b"\0\0"


def plane_stl():
    a, b, c, d = ((x, y, plane(x, y)) for x, y in ((-5, -5), (30, -5), (30, 25), (-5, 25)))
    return b"of a test".ljust(80) + struct.pack("<I", 2) + facet((a, b, c)) + facet((a, c, d))


def plane_grid():
    return "\n".join("".join(f"{x} {y} {plane(x, y):.6f}\n" for x in (-5, 30)) for y in (-5, 25))


def points_of(text):
    rows = [line.split() for line in text.splitlines() if line and not line.startswith("#")]
    return [tuple(map(float, row)) for row in rows]


class ProbeGrid(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program, self.log, self.grid = (self.folder / name for name in ("probe.nc", "a.log", "grid.xyz"))

    def write(self, *more):
        done = run("surface", "probe-grid", *WORDS, *more, "-o", self.program)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("20 points in 4 rows of 5, 5 mm apart in X and 5 mm in Y", done.stderr)

    def probe(self, surface, *more):
        done = run("sim", self.program, *MACHINE, "--probe-surface", surface, *more, "--answers", self.log)
        self.assertEqual(done.returncode, 0, done.stderr)

    def read(self, *more, program=True):
        words = ("--program", self.program) if program else ()
        return run("surface", "probe-grid", "--read", self.log, *words, *more, "-o", self.grid)

    def assert_on_plane(self, text, bound=0.0):
        points = points_of(text)
        self.assertEqual(len(points), 20)
        for x, y, z in points:
            self.assertGreater(z - plane(x, y), -STEP_MM - 0.0011)
            self.assertLess(z - plane(x, y), bound + 0.0011)

    def test_the_circle_closes_for_a_mesh_and_a_grid_and_any_tip(self):
        stl, xyz = self.folder / "part.stl", self.folder / "part.xyz"
        stl.write_bytes(plane_stl())
        xyz.write_text(plane_grid())
        for surface in (stl, xyz):
            for tip in (0, 1, 2):
                for more in ((), ("--fast-feed", 400), ("--hop", 2.5)):
                    with self.subTest(surface=surface.name, tip=tip, more=more):
                        self.write("--tip", tip, *more)
                        self.probe(surface, "--probe-tip", tip)
                        done = self.read()
                        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
                        self.assert_on_plane(self.grid.read_text())
        # On a slope, the heights of the tip are above the surface.
        self.assertEqual(self.read("--tip", 0).returncode, 0)
        above = math.sqrt(1 + 0.3 ** 2 + 0.2 ** 2) - 1
        self.assert_on_plane(self.grid.read_text(), bound=above)
        self.assertLess(max(z - plane(x, y) for x, y, z in points_of(self.grid.read_text())), above + 0.001)
        # The probed grid can be used as a surface to probe.
        done = run("sim", self.program, "--probe-surface", self.grid, "--answers", self.log)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_converts_to_work_coordinates_by_the_log(self):
        stl = self.folder / "part.stl"
        stl.write_bytes(plane_stl())
        self.write()
        # The origin of the part is at X 3, Y 2, Z -0.5 of the machine.
        text = "G10 L2 P1 X3 Y2 Z-0.5\n" + self.program.read_text()
        moved = self.folder / "moved.nc"
        moved.write_text(text)
        done = run("sim", moved, *MACHINE, "--probe-surface", stl, "--answers", self.log)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("WCO:3.000,2.000,-0.500", self.log.read_text())
        log = "\n".join(line for line in self.log.read_text().splitlines() if "WCO" not in line)
        for change, more in (("", ("--offset", "3,2,-0.5")), ("[G54:3.000,2.000,-0.500]\n", ()),
                             ("<Idle|MPos:0.000,0.000,0.000|WCO:3.000,2.000,-0.500>\n", ())):
            with self.subTest(change=change, more=more):
                self.log.write_text(change + log + "\n")
                done = self.read(*more)
                self.assertEqual(done.returncode, 0, done.stderr)
                for x, y, z in points_of(self.grid.read_text()):
                    self.assertAlmostEqual(z - 0.5, plane(x + 3, y + 2), delta=STEP_MM + 0.001)
        self.log.write_text(log + "\n")
        done = self.read()
        self.assertEqual(done.returncode, 2)
        self.assertIn("no answer is at a point of the grid", done.stderr)
        self.assertIn("--offset", done.stderr)
        lines = log.splitlines()
        half = len(lines) // 2
        self.log.write_text("\n".join(["<Idle|WCO:3,2,-0.5>", *lines[:half], "<Idle|WCO:3,2,0>", *lines[half:]]))
        self.assertIn("the work offset changes among the answers", self.read().stderr)

    def test_warns_of_rises_that_are_shorter_than_the_way_to_stop(self):
        done = run("surface", "probe-grid", *WORDS, "--fast-feed", 900, "--retract", 0.5, "--hop", 0.2)
        self.assertEqual(done.returncode, 0)
        self.assertIn("--retract 0.5: the tip may need 0.75 mm at 900 mm/min to stop", done.stderr)
        self.assertIn("--hop 0.2: the tip may need 0.5 mm at 600 mm/min to stop", done.stderr)
        self.assertNotIn("go on", run("surface", "probe-grid", *WORDS, "--fast-feed", 900).stderr)

    def test_names_what_lacks_and_writes_nothing(self):
        self.write()
        places = [(x, y) for row, y in enumerate(range(0, 20, 5))
                  for x in (range(0, 25, 5) if row % 2 == 0 else range(20, -5, -5))]
        lines = [f"[PRB:{x}.000,{y}.000,{plane(x, y):.3f}:1]" for x, y in places]
        lines[2] = "[PRB:10.000,0.000,-8.000:0]"
        lines[7] = "[PRB:10.00"
        del lines[12]
        self.log.write_text("<Idle|WCO:0,0,0>\n" + "\nok\n".join(lines) + "\n")
        self.grid.write_text("before\n")
        done = self.read()
        self.assertEqual(done.returncode, 1)
        for told in ("row 1, column 3 (X 10, Y 0) touched nothing down to Z -8.000",
                     ":16: an answer is damaged", "row 2, column 3 (X 10, Y 5) has no answer",
                     "row 3, column 3 (X 10, Y 10) has no answer", "3 of 20 points are missing, and nothing is written",
                     "is still the earlier file"):
            self.assertIn(told, done.stderr)
        self.assertEqual(self.grid.read_text(), "before\n")
        done = self.read("--gaps")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.grid.read_text().count(" nan\n"), 3)
        done = self.read("--gaps", "--x", "0:20")
        self.assertEqual(done.returncode, 2)
        again = run("surface", "probe-grid", "--read", self.log, "--x", "0:20", "--y", "0:15", "--columns", 5,
                    "--rows", 4, "--depth", -8, "--gaps")
        self.assertEqual(again.stdout, self.grid.read_text())

    def test_any_log_is_a_grid_or_a_refusal(self):
        self.write()
        chance = random.Random(5)
        good = "".join(f"[PRB:{x}.000,{y}.000,0.000:1]\nok\n" for x in range(0, 25, 5) for y in range(0, 20, 5))
        for _ in range(40):
            letters = list(good)
            for _ in range(chance.randrange(40)):
                letters[chance.randrange(len(letters))] = chance.choice("[]PRB:,.0e-nan\n\rWCO<|>\xe9")
            self.log.write_text("".join(letters))
            done = self.read()
            self.assertIn(done.returncode, (0, 1, 2), done.stderr)
            self.assertNotEqual(done.stderr, "")

    def test_wrong_values_are_named(self):
        for words, told in (
                (("--safe", -8), "--safe -8: must be above --depth -8"), (("--pitch", 0), "--pitch: 0 mm"),
                (("--pitch", "x"), "--pitch"), (("--feed", 0), "--feed 0: must be above 0 mm/min"),
                (("--pitch", 0.01), "choose a greater pitch"), (("--x", "0"), "--x 0: is not FROM:TO"),
                (("--x", "5:0"), "does not rise"), (("--y", "nan:4"), "check the unit"),
                (("--fast-feed", 100), "must be above --feed"), (("--hop", -1), "--hop -1"),
                (("--tip", -2), "--tip -2"), (("--offset", "1,2,3"), "require --read"), (("--gaps",), "require --read"),
                (("--columns", 3), "--columns")):
            options = list(map(str, WORDS))
            if words[0] in options:
                options[options.index(words[0]) + 1] = str(words[1])
            else:
                options += map(str, words)
            with self.subTest(words=words):
                done = run("surface", "probe-grid", *options, "-o", self.program)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(told, done.stderr)
                self.assertFalse(self.program.exists())
        for option in ("--x", "--y", "--pitch", "--safe", "--depth", "--feed"):
            at = WORDS.index(option)
            done = run("surface", "probe-grid", *WORDS[:at], *WORDS[at + 2:])
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(option, done.stderr)

    def test_a_surface_for_the_simulated_probe_is_checked(self):
        self.write()
        part = self.folder / "part.xyz"
        part.write_text("0 0 1\n1 nothing\n")
        for words, told in ((("--probe-surface", part), str(part)),
                            (("--probe-surface", self.folder / "none"), "none"),
                            (("--probe-tip", 2), "give --probe-surface"),
                            (("--probe-surface", part, "--probe-tip", -1), "--probe-tip")):
            for command in ("sim", "check"):
                done = run(command, self.program, *words)
                self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                self.assertIn(told, done.stderr)

    def test_a_recorded_conversation_replays_with_its_surface(self):
        part, talk = self.folder / "part.stl", self.folder / "talk.txt"
        part.write_bytes(plane_stl())
        server = subprocess.Popen([KERFLINE, "serve", "--tcp", "0", "--speed", "20", "--probe-surface", str(part),
                                   "--probe-tip", "2", "--record", str(talk)],
                                  stdout=subprocess.PIPE, text=True, env={"PATH": "/usr/bin"})
        try:
            address = server.stdout.readline().split()[1]
            self.assertEqual(server.stdout.readline(), "ready\n")
            job = self.folder / "job.nc"
            job.write_text("$X\nG21\nG0 Z4\nG38.2 Z-8 F300\n")
            sent = run("send", job, "--tcp", address, "--accept-faults")
        finally:
            server.terminate()
            server.wait(20)
            server.stdout.close()
        self.assertEqual(sent.returncode, 0, sent.stdout + sent.stderr)
        part.unlink()
        text = talk.read_text()
        self.assertIn("\nprobe_surface 2 \"", text)
        self.assertIn("[PRB:0.000,0.000,-3.940:1]", text)
        done = run("replay", talk)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
