#!/usr/bin/env python3
"""`kerfline sim --stock`: volumes, faults of the motion, files, and a pocket compared with its drawing.

    sim_stock_test.py KERFLINE
"""

import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
MILL = [word for setting in ("$32=0", "$30=24000", "$100=320", "$101=320", "$102=320", "$110=5000", "$111=5000",
                             "$112=2000", "$120=400", "$121=400", "$122=250")
        for word in ("--set", setting)]
# A pocket of 30 by 20 mm with corners of the tool's radius, 2 mm deep: entered by a ramp, then
# cleared in loops.
POCKET = """G21 G90 G17
M3 S10000
G0 Z5
G0 X15 Y14
G0 Z0.5
G1 X25 Z-2 F300
G1 X15
{loops}G0 Z5
M5
M30
"""


def loops():
    lines = []
    for inset in (5.0, 4.0, 0.0):
        low, right, top = 8 + inset, 32 - inset, 22 - inset
        lines.append(f"G1 X{low} Y{low - 2} F800\nG1 X{right}\nG1 Y{top}\nG1 X{low}\nG1 Y{low - 2}\n")
    return "".join(lines)


class SimStock(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.job = self.folder / "job.nc"

    def sim(self, program, *more, status=0):
        self.job.write_text(program)
        done = subprocess.run([KERFLINE, "sim", self.job, *MILL, *map(str, more)], capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def carved(self, program, *more):
        name = self.folder / "report.json"
        done = self.sim(program, "--report", name, *more)
        return json.loads(name.read_text())["stock"], done.stdout

    def test_the_volume_of_a_pocket_is_between_its_bounds(self):
        # The outermost loop of the path is 24 by 16 mm, the tool's radius is 4 mm.
        volume = 2 * (24 * 16 + 2 * 4 * (24 + 16) + math.pi * 16)
        gaps = []
        for cell in (0.1, 0.05):
            stock, text = self.carved(POCKET.format(loops=loops()), "--stock", "0,0,40,30,0,-8", "--tool", 8,
                                      "--stock-cell", cell)
            removed = stock["removed_mm3"]
            self.assertLessEqual(removed["least"], volume)
            self.assertGreaterEqual(removed["most"], volume)
            gaps.append(removed["most"] - removed["least"])
            self.assertEqual(stock["cell_mm"], [cell, cell])
            self.assertEqual(stock["rapids_in_stock"], {"count": 0, "lines": []})
            self.assertEqual(stock["plunges_in_stock"]["count"], 0)
            self.assertIn("mm³ removed by flat 8 mm", text)
        self.assertLess(gaps[1], 0.65 * gaps[0])
        self.assertLess(gaps[1], 0.03 * volume)

    def test_the_volume_grows_and_slots_engage_half_of_the_tool(self):
        stock, _ = self.carved(POCKET.format(loops=loops()), "--stock", "0,0,40,30,0,-8", "--tool", 8)
        times = stock["removed_over_time"]
        self.assertGreater(len(times), 20)
        for before, after in zip(times, times[1:]):
            self.assertLess(before[0], after[0])
            self.assertLessEqual(before[1], after[1])
            self.assertLessEqual(before[2], after[2])
        self.assertEqual(times[-1][1:], [stock["removed_mm3"]["least"], stock["removed_mm3"]["most"]])
        engagement = stock["greatest_engagement_deg"]
        self.assertGreater(engagement["least"], 178)
        self.assertEqual(engagement["line"], 6)

    def test_a_rapid_through_stock_is_reported_by_line(self):
        program = "G21 G90\nM3 S10000\nG0 Z2\nG0 X10 Y10\nG1 Z-1 F200\nG1 X20\nG0 X30\nG0 X20\nG0 Z2\nM5\nM30\n"
        stock, text = self.carved(program, "--stock", "0,0,40,20,0", "--tool", "6")
        rapids = stock["rapids_in_stock"]
        self.assertEqual([cut["line"] for cut in rapids["lines"]], [7])
        self.assertAlmostEqual(rapids["lines"][0]["least_mm3"], 60, delta=6)
        self.assertIn("job.nc:7: a rapid cuts stock", text)
        plunges = stock["plunges_in_stock"]
        self.assertEqual([cut["line"] for cut in plunges["lines"]], [5])
        self.assertAlmostEqual(plunges["lines"][0]["least_mm3"], 9 * math.pi, delta=3)
        self.assertIsNone(stock["bottom_mm"])

    def test_a_rapid_into_stock_from_above_is_no_plunge_of_the_feed_behind_it(self):
        program = "G21 G90\nM3 S10000\nG0 Z2\nG0 X10 Y10\nG0 Z-1\nG1 X20 F500\nG0 Z2\nM5\nM30\n"
        stock, _ = self.carved(program, "--stock", "-5,-5,40,20,0,-3", "--tool", "6,ball")
        self.assertEqual([cut["line"] for cut in stock["rapids_in_stock"]["lines"]], [5])
        self.assertEqual(stock["plunges_in_stock"]["count"], 0)
        self.assertIsNone(stock["greatest_engagement_deg"])

    def test_a_clean_program_has_no_rapid_in_stock(self):
        program = ("G21 G90 G17\nM3 S10000\nG0 Z2\nG0 X10 Y10\nG0 Z0\nG1 Z-1 F200\nG1 X20 F800\nG3 X20 Y14 J2\n"
                   "G1 X10\nG0 Z0\nG0 X20 Y10\nG0 Z-1\nG0 X10\nG0 Z2\nM5\nM30\n")
        for tool in ("5", "5,ball", "5,bull,1", "5,v,90,0.5"):
            stock, _ = self.carved(program, "--stock", "0,0,40,20,0,-3", "--tool", tool)
            self.assertEqual(stock["rapids_in_stock"]["count"], 0, stock["rapids_in_stock"])

    def test_files_of_the_carved_stock(self):
        names = {kind: self.folder / f"left.{kind}" for kind in ("png", "stl", "ply")}
        program = "G21 G90\nM3 S10000\nG1 Z-2 F300\nG1 X20\nG0 Z2\nM5\nM30\n"
        stock, _ = self.carved(program, "--stock", "0,0,20,10,0,-4", "--tool", 6, "--stock-cell", 0.1,
                               *[word for kind, name in names.items() for word in (f"--stock-{kind}", name)])
        self.assertEqual(names["png"].read_bytes()[:4], b"\x89PNG")
        self.assertTrue(names["ply"].read_bytes().startswith(b"ply\nformat binary_little_endian 1.0\n"))
        stl = names["stl"].read_bytes()
        count = struct.unpack_from("<I", stl, 80)[0]
        self.assertEqual(len(stl), 84 + 50 * count)
        volume = 0.0
        for face in struct.iter_unpack("<12fH", stl[84:]):
            a, b, c = face[3:6], face[6:9], face[9:12]
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                       + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        removed = stock["removed_mm3"]
        self.assertAlmostEqual(volume, 800 - (removed["least"] + removed["most"]) / 2, delta=0.5)

    def pocket(self, program, *more):
        drawing = self.folder / "pocket.svg"
        drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30">'
                           '<rect x="4" y="4" width="32" height="24"/></svg>')
        stock, text = self.carved(program, "--stock", "0,0,40,30,0,-8", "--tool", 8, "--stock-target", drawing,
                                  "--stock-depth", 2, *more)
        return stock["pocket"], text

    def test_a_pocket_is_compared_with_contours_as_text(self):
        program = POCKET.format(loops=loops())
        walls = self.folder / "walls.txt"
        walls.write_text("4 2\n36 2\n36 26\n4 26\nclosed\n")
        stock, _ = self.carved(program, "--stock", "0,0,40,30,0,-8", "--tool", 8, "--stock-target", walls,
                               "--stock-depth", 2)
        # Walls coincide with the borders of cells, up to the last digit, so their cells may count
        # for either side.
        drawn, _ = self.pocket(program)
        for name in ("gouge_mm3", "rest_mm3"):
            for bound in ("least", "most"):
                self.assertAlmostEqual(stock["pocket"][name][bound], drawn[name][bound], delta=112 * 0.05 * 2)
        # The walls are round here. The pocket's corners beyond them are gouges, and uncleared areas
        # within them are rest.
        walls.write_text("36 14 1\n4 14 1\nclosed\n")
        stock, _ = self.carved(program, "--stock", "0,0,40,30,0,-8", "--tool", 8, "--stock-target", walls,
                               "--stock-depth", 2)
        self.assertGreater(stock["pocket"]["gouge_mm3"]["least"], 50)
        walls.write_text("4 2\nx 2\n")
        done = self.sim(program, "--stock", "0,0,40,30,0,-8", "--tool", 8, "--stock-target", walls,
                        "--stock-depth", 2, status=2)
        self.assertIn("walls.txt:2", done.stderr)

    def test_a_pocket_is_compared_with_its_drawing(self):
        program = POCKET.format(loops=loops())
        good, text = self.pocket(program)
        self.assertLess(good["gouge_mm3"]["least"], 0.01)
        self.assertLess(good["rest_mm3"]["least"], 0.01)
        # The two bounds differ by a cell on either side of 112 mm of walls, and in corners.
        self.assertLess(good["gouge_mm3"]["most"], 2 * 112 * 0.2)
        self.assertLess(good["rest_mm3"]["most"], 2 * 112 * 0.2)
        self.assertNotIn("gouged", text)
        # Without the last loop there is a rim of 4 mm. With one side 0.5 mm farther out there is a
        # gouge, which is round at its ends.
        rest, _ = self.pocket(POCKET.format(loops=loops()[:loops().index("G1 X8.0 Y6.0")]))
        rim = 2 * (32 * 24 - 24 * 16)
        self.assertLess(rest["rest_mm3"]["least"], rim)
        self.assertGreater(rest["rest_mm3"]["least"], 0.9 * rim)
        self.assertGreater(rest["rest_mm3"]["most"], rim)
        self.assertAlmostEqual(rest["tallest_rest"]["least_mm"], 2, 3)
        wide, text = self.pocket(program.replace("X32.0", "X32.5"))
        gouge = 2 * (0.5 * 16 + 16 * math.acos(3.5 / 4) - 3.5 * math.sqrt(16 - 3.5 ** 2))
        self.assertLess(wide["gouge_mm3"]["least"], gouge)
        self.assertGreater(wide["gouge_mm3"]["least"], 0.7 * gouge)
        self.assertAlmostEqual(wide["deepest_gouge"]["least_mm"], 2, 3)
        self.assertAlmostEqual(wide["deepest_gouge"]["at_mm"][0], 36.25, delta=0.3)
        self.assertIn("job.nc: the pocket is gouged", text)

    def test_several_programs_fill_the_placeholder(self):
        other = self.folder / "other.nc"
        other.write_text("G21 G90\nM3 S10000\nG1 X20 Z-1 F500\nG0 Z2\nM30\n")
        self.sim("G21 G90\nM3 S10000\nG1 X9 Z-1 F500\nG0 Z2\nM30\n", other, "--stock", "0,0,20,10,0", "--tool", 3,
                 "--stock-ply", self.folder / "{}.ply")
        self.assertTrue((self.folder / "other.ply").exists())
        self.assertTrue((self.folder / "job.ply").exists())
        self.sim("G0 X1\n", other, "--stock", "0,0,20,10,0", "--tool", 3, "--stock-ply", self.folder / "x.ply",
                 status=2)

    def test_wrong_stocks_and_tools_are_refused(self):
        good = ("--stock", "0,0,20,10,0,-5", "--tool", "6")
        for more, words in (
                ((*good[:2],), "--stock: requires the tool"),
                ((*good[2:],), "--tool: requires the block of --stock"),
                (("--stock-stl", self.folder / "x.stl"), "--stock-stl: requires the block"),
                (("--stock", "0,0,20,10", *good[2:]), "has 4 numbers; it requires XMIN,YMIN,XMAX,YMAX,ZTOP[,ZBOTTOM]"),
                (("--stock", "0,0,20,ten,0", *good[2:]), "`ten` is no number"),
                (("--stock", "0,0,nan,10,0", *good[2:]), "`nan` is no number"),
                (("--stock", "0,0,1e300,10,0", *good[2:]), "it must be within -100000 to 100000 mm"),
                (("--stock", "20,0,0,10,0", *good[2:]), "20 to 0 mm; the second number must be greater"),
                (("--stock", "0,0,20,10,0,0", *good[2:]), "Z of the stock is 0 to 0 mm"),
                (("--stock", "0,0,20,10,0,-2000", *good[2:]), "2000 mm high; at most 1000 mm are possible"),
                (("--stock", "0,0,9000,9000,0", *good[2:], "--stock-cell", "0.01"), "cells of 0.01 mm; at most"),
                ((*good, "--stock-target", self.folder / "none.svg"), "--stock-target: requires the depth"),
                ((*good, "--stock-depth", "2"), "--stock-depth: requires the drawing"),
                ((*good, "--stock-depth", "2", "--stock-target", self.folder / "none.svg"), "none.svg"),
                ((*good, "--stock-depth", "2", "--stock-target", self.job), "it is neither SVG nor DXF"),
                ((*good, "--stock-cell", "0"), "0 is out of range, 0.001 to 10 mm"),
                ((*good, "--stock-cell", "nan"), "--stock-cell"),
                ((*good[:2], "--tool", "0"), "the tool's diameter is 0 mm; it must be 0.01 to 500 mm"),
                ((*good[:2], "--tool", "6,drill"), "must be a diameter in mm and flat, ball"),
                ((*good[:2], "--tool", "6,bull"), "must be a diameter in mm and flat, ball"),
                ((*good[:2], "--tool", "6,bull,3.5"), "the corner radius is 3.5 mm; it must be above 0 and at most 3"),
                ((*good[:2], "--tool", "6,v,180"), "the included angle is 180 degrees; it must be 1 to 179 degrees"),
                ((*good[:2], "--tool", "6,v,60,6"), "is 6 mm; it must be at least 0 and less than 6 mm"),
                ((*good[:2], "--tool", ""), "--stock: requires the tool"),
                ((*good, "--stock-png", self.job), "FILE")):
            with self.subTest(more):
                before = sorted(self.folder.iterdir())
                done = self.sim("G0 X1\n", *more, status=2)
                self.assertIn(words, done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertEqual(sorted(self.folder.iterdir()), before or [self.job])


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
