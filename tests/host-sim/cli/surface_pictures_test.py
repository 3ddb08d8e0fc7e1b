#!/usr/bin/env python3
"""Tests pictures of kerfline surface, and compares its programs with the surface on the simulated
machine.

    surface_pictures_test.py KERFLINE
"""

import collections
import json
import math
import pathlib
import struct
import tempfile
import unittest

from pocket_bench import MACHINE, MILL, run

PICTURES = {"data": "Measured surface", "offset": "Positions of the tool", "patches": "patches", "paths": "rapids",
            "carved": "Carved stock", "map": "Off the surface, mm"}


def scan(rows=17, columns=25, pitch=0.5):
    lines = ("\n".join(f"{pitch * i} {pitch * row} {math.sin(0.4 * pitch * i) * math.cos(0.5 * pitch * row) - 3:.4f}"
                       for i in range(columns)) for row in range(rows))
    return "\n\n".join(lines) + "\n"


def stl_triangles(path):
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    for i in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * i)
        yield [numbers[3 + 3 * k:6 + 3 * k] for k in range(3)]


class SurfacePictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "scan.nc"
        self.scan = self.folder / "scan.xyz"
        self.scan.write_text(scan())

    def surface(self, *options, file=None):
        return run("surface", file or self.scan, "--tool", "ball:3", "--step", 0.5, *MILL, "-o", self.program, *options)

    def test_draws_each_picture_as_svg_and_png(self):
        files = {name: self.folder / f"{name}.svg" for name in PICTURES}
        words = [word for name, file in files.items() for word in (f"--picture-{name}", file)]
        done = self.surface(*words, "--fit-tolerance", 0.05, "--picture-cell", 0.05)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, file in files.items():
            text = file.read_text()
            self.assertIn(PICTURES[name], text)
            self.assertIn("data:image/png;base64,", text)
            self.assertNotIn("nan", text.split("base64,")[0] + text.split('"/>')[-1])
        self.assertRegex(done.stderr, r"gouge: 0\.00 to [\d.]+ mm³\n")
        self.assertRegex(done.stderr, r"rest R1: \+0\.\d+ mm at X")
        picture = self.folder / "view.png"
        done = self.surface("--picture-data", picture, "--picture-view", "200,50")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">I", picture.read_bytes()[16:20])[0], 1600)

    def test_draws_the_same_bytes_each_time(self):
        texts = []
        for name in ("a.svg", "b.svg"):
            self.assertEqual(self.surface("--picture-paths", self.folder / name).returncode, 0)
            texts.append((self.folder / name).read_bytes())
        self.assertEqual(texts[0], texts[1])

    def test_refuses_pictures_of_unknown_kinds_and_of_no_path(self):
        for options, message in (
                (("--picture-data", self.folder / "a.jpg"), "a.jpg: is no format of a picture"),
                (("--picture-view", "0,90"), "an elevation of 5 to 85"),
                (("--like-paper", "--picture-map", self.folder / "a.png"),
                 "--picture-map: there is no path to draw with --like-paper")):
            done = run("surface", self.scan, "--tool", "ball:3", *MILL, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertIn(message, done.stderr)
            self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["scan.xyz"])
        done = self.surface("--picture-map", self.folder / "none" / "a.png")
        self.assertEqual(done.returncode, 2)
        self.assertIn("none", done.stderr)

    def test_the_machine_leaves_a_surface_without_a_gouge(self):
        self.assertEqual(self.surface().returncode, 0)
        report, chart, body = (self.folder / name for name in ("sim.json", "map.png", "out.stl"))
        stock = ("--stock", "0,0,12,8,-1.5,-8", "--stock-cell", 0.05, "--stock-surface", self.scan)
        done = run("sim", self.program, *MACHINE, *stock, "--tool", "ball:3", "--stock-map", chart, "--stock-stl", body,
                   "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(report.read_text())["stock"]["surface"]
        self.assertEqual(found["gouge_mm3"]["least"], 0.0)
        self.assertEqual(found["worst_gouges"], [])
        self.assertLess(found["tallest_rest"]["least_mm"], 0.15)
        self.assertGreater(found["cells"], 35_000)
        self.assertEqual(chart.read_bytes()[:4], b"\x89PNG")
        self.assertNotIn("gouged", done.stdout + done.stderr)
        # Each edge of the body belongs to two triangles, once in each direction.
        edges = collections.Counter()
        for a, b, c in stl_triangles(body):
            edges.update([(a, b), (b, c), (c, a)])
        self.assertTrue(edges)
        for (a, b), count in edges.items():
            self.assertEqual(count, edges[(b, a)])

    def test_the_machine_tells_the_gouge_of_a_larger_tool(self):
        self.assertEqual(self.surface().returncode, 0)
        chart = self.folder / "map.svg"
        stock = ("--stock", "0,0,12,8,-1.5,-8", "--stock-cell", 0.1, "--stock-surface", self.scan)
        done = run("sim", self.program, *MACHINE, *stock, "--tool", "ball:6", "--stock-map", chart)
        self.assertIn("the surface is gouged", done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"gouge G1\s+-0\.\d+ mm at X")
        self.assertRegex(chart.read_text(), r">G1 -0\.\d+")

    def test_options_that_need_each_other(self):
        self.assertEqual(self.surface().returncode, 0)
        stock = ("--stock", "0,0,12,8,-1.5,-8", "--tool", "ball:3")
        for options, message in (
                ((*stock, "--stock-map", "a.png"), "--stock-map: requires the surface of --stock-surface"),
                (("--stock-surface", self.scan), "--stock-surface: requires the block of --stock"),
                ((*stock, "--stock-surface", self.scan, "--stock-map", "a.gif"), "--stock-map a.gif: is no format"),
                ((*stock, "--stock-surface", self.folder / "no.xyz"), "no.xyz"),
                (("--stock", "0,0,1200,800,-1,-8", "--tool", "ball:3", "--stock-surface", self.scan, "--stock-cell",
                  0.01), "so choose larger")):
            done = run("sim", self.program, *MACHINE, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertIn(message, done.stderr)


if __name__ == "__main__":
    unittest.main()
