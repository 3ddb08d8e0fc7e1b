#!/usr/bin/env python3
"""`kerfline engrave`: sizes, powers of pixels as the simulated machine burns them, dots, refusals.

    engrave_command_test.py KERFLINE
"""

import collections
import json
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

KERFLINE = ""
LASER = ("--set", "$32=1")


def run(*arguments):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"})


def png_of(rows):
    """Returns a grey PNG of 8 bits; rows from the top, 0 black to 255 white."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    pixels = b"".join(b"\0" + bytes(row) for row in rows)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(pixels)) +
            chunk(b"IEND", b""))


def bmp_of(rows):
    """Returns a BMP of 24 bits."""
    width, height = len(rows[0]), len(rows)
    padding = b"\0" * (-3 * width % 4)
    pixels = b"".join(b"".join(bytes([grey] * 3) for grey in row) + padding for row in reversed(rows))
    return (b"BM" + struct.pack("<IHHI", 54 + len(pixels), 0, 0, 54) +
            struct.pack("<IiiHHIIiiII", 40, width, height, 1, 24, 0, len(pixels), 0, 0, 0, 0) + pixels)


def burnt(trace, pixel, interval):
    """Returns the seconds of full power by (column, row), from the step trace; cells outside of
    the picture count, too.
    """
    energy = collections.defaultdict(float)
    scale, before = None, None
    for line in trace.read_text().splitlines():
        if line.startswith("# steps_per_mm"):
            scale = [float(value) for value in re.findall(r"[XY]=([\d.]+)", line)]
        if line.startswith(("#", "time")):
            continue
        fields = line.split(",")
        time, x, y = int(fields[0]) * 1e-9, int(fields[1]) / scale[0], int(fields[2]) / scale[1]
        duty = float(fields[-1])
        if before and before[3] > 0.0:
            place = (int((0.5 * (before[1] + x)) // pixel), int(y // interval))
            energy[place] += (time - before[0]) * before[3]
        before = (time, x, y, duty)
    return energy


class Engrave(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "job.nc"
        self.report = self.folder / "job.json"
        self.trace = self.folder / "trace.csv"

    def picture(self, rows, kind=png_of, name="picture.png"):
        path = self.folder / name
        path.write_bytes(kind(rows))
        return path

    def engrave(self, picture, *options, status=0):
        done = run("engrave", picture, *options, "-o", self.program, "--report", self.report)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        return done

    def burnt(self, pixel, interval):
        done = run("sim", self.program, *LASER, "--trace", self.trace)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return burnt(self.trace, pixel, interval)

    def test_pixels_get_the_power_of_their_grey(self):
        greys = [list(range(0, 256, 5)), list(range(255, -1, -5)), [255] * 52, [30, 200] * 26]
        picture = self.picture(greys)
        pixel, feed = 0.3, 6000.0
        for more in ((), ("--plain",), ("--one-way",), ("--constant-power",), ("--gamma", "1.5", "--min-power", "10%")):
            done = self.engrave(picture, "--width", 52 * pixel, "--interval", pixel, "--power", "90%", "--feed", feed,
                                *more)
            self.assertIn("52 x 4 pixels, 15.60 x 1.20 mm; 3 rows", done.stdout)
            report = json.loads(self.report.read_text())
            self.assertEqual((report["burnt_rows"], report["job_time_is"]), (3, "simulated"))
            energy = self.burnt(pixel, pixel)
            gamma, least = (1.5, 0.1) if "--gamma" in more else (1.0, 0.0)
            whole = pixel * 60.0 / feed
            for row, line in enumerate(reversed(greys)):
                for column, grey in enumerate(line):
                    darkness = 1.0 - grey / 255.0
                    power = least + (0.9 - least) * darkness ** gamma if darkness > 0.0 else 0.0
                    told = f"{more} {column} {row}"
                    # A step is 0.004 mm, and the power of the neighbour pixel may last one step
                    # longer.
                    self.assertAlmostEqual(energy.pop((column, row), 0.0) / whole, power, delta=0.03 * power + 0.014,
                                           msg=told)
            self.assertLess(sum(energy.values()), 0.01 * whole, more)  # The last step of a row.

    def test_lines_are_no_longer_than_a_controller_takes(self):
        picture = self.picture([[(37 * x + 11 * y) % 256 for x in range(300)] for y in range(3)])
        self.engrave(picture, "--width", "60", "--power", "S999.9", "--feed", "6000", "--interval", "0.2")
        lines = self.program.read_text().splitlines()
        self.assertLess(max(map(len, lines)), 256)
        self.assertLessEqual(max(line.count(":") for line in lines), 63)
        self.assertLess(len(lines), 60)
        self.engrave(picture, "--width", "60", "--power", "S999.9", "--feed", "6000", "--interval", "0.2", "--plain")
        self.assertFalse([line for line in self.program.read_text().splitlines()
                          if ":" in line and not line.startswith("(")])

    def test_dots_have_the_mean_of_the_grey(self):
        picture = self.picture([[128] * 60] * 60)
        for shading in ("ordered", "floyd-steinberg", "jarvis", "stucki"):
            self.engrave(picture, "--width", "12", "--interval", "0.2", "--power", "50%", "--feed", "6000",
                         "--shading", shading)
            self.assertAlmostEqual(json.loads(self.report.read_text())["burnt_mm"], 60 * 12 * 127 / 255, delta=20)
            self.assertEqual(set(re.findall(r"S([\d.:]+)", self.program.read_text())) & {"250"}, set())
        self.engrave(picture, "--width", "12", "--interval", "0.2", "--power", "50%", "--feed", "6000",
                     "--shading", "threshold", status=1)
        self.engrave(picture, "--width", "12", "--interval", "0.2", "--power", "50%", "--feed", "6000",
                     "--shading", "threshold", "--invert")

    def test_bmp_is_read_as_png_is(self):
        rows = [[0, 60, 120], [200, 255, 9]]
        options = ("--width", "3", "--interval", "1", "--power", "50%", "--feed", "600")
        self.engrave(self.picture(rows), *options)
        first = [line for line in self.program.read_text().splitlines() if not line.startswith("(")]
        self.engrave(self.picture(rows, bmp_of, "picture.bmp"), *options)
        self.assertEqual([line for line in self.program.read_text().splitlines() if not line.startswith("(")], first)

    def test_machine_and_place(self):
        picture = self.picture([[0] * 10] * 10)
        options = ("--width", "20", "--power", "20W", "--feed", "3000", "--machine", "k40")
        self.engrave(picture, *options, "--place", "centre")
        self.assertIn("S500", self.program.read_text())
        told = self.engrave(picture, *options, "--place", "0,-20", status=1).stderr
        self.assertRegex(told, r"leaves the bed of K40.*by 0\.\d+ mm at its left")

    def test_what_is_wrong_is_named(self):
        picture = self.picture([[0] * 10] * 10)
        fine = ("--width", "20", "--power", "50%", "--feed", "3000")
        for wrong, told in ((("--power", "50%", "--feed", "3000"), "the size of the picture is missing"),
                            (("--width", "20", "--power", "20W", "--feed", "3000"), "laser with --full-power"),
                            ((*fine, "--min-power", "60%"), "--min-power: exceeds --power"),
                            ((*fine, "--image-dpi", "100"), "--image-dpi"),
                            ((*fine, "--shading", "dots"), "--shading"),
                            ((*fine, "--interval", "0.005", "--pixel", "0.005", "--height", "9999"),
                             "pixels would be")):
            self.assertIn(told, self.engrave(picture, *wrong, status=2).stderr)
        text = self.folder / "text.txt"
        text.write_text("no picture")
        self.assertIn("text.txt: is no PNG, JPEG or BMP picture", self.engrave(text, *fine, status=2).stderr)
        broken = self.folder / "broken.png"
        broken.write_bytes(picture.read_bytes()[:40])
        self.assertIn("broken.png: the PNG is damaged", self.engrave(broken, *fine, status=2).stderr)
        white = self.picture([[255] * 9] * 9)
        self.assertIn("the picture is white", self.engrave(white, *fine, status=1).stderr)


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
