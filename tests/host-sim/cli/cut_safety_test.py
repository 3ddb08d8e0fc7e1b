#!/usr/bin/env python3
"""`kerfline cut` with the options for an order that is safe to run.

    cut_safety_test.py KERFLINE
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
STEEL = ("--material", "CSP 1N", "--thickness", "2")
ROW = "".join(f'<rect x="{5 + 25 * i}" y="40" width="20" height="20"/>' for i in range(3))
COLUMN = "".join(f'<rect x="20" y="{5 + 24 * i}" width="20" height="20"/>' for i in range(3))


def run(*arguments):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True,
                          check=False, env={"PATH": "/usr/bin"})


def crossings(program, boxes):
    """Returns the rapids of a program that enter a box that was cut before."""
    place, cut, found = (0.0, 0.0), 0, 0
    word = re.compile(r"([GXY])([-0-9.]+)")
    motion = 0
    for line in program.splitlines():
        named = re.match(r"\((\d+): ", line)
        if named:
            cut = int(named.group(1)) - 1
        if line.startswith("M2"):
            break
        if line.startswith("M9"):
            cut = len(boxes)
        if line.startswith(("(", "M")):
            continue
        values = dict(word.findall(line))
        motion = int(values.get("G", motion)) if "G" in values else motion
        end = (float(values.get("X", place[0])), float(values.get("Y", place[1])))
        if motion == 0:
            for share in range(1001):
                x, y = (a + 0.001 * share * (b - a) for a, b in zip(place, end))
                if any(x0 < x < x1 and y0 < y < y1 for x0, y0, x1, y1 in boxes[:cut]):
                    found += 1
                    break
        place = end
    return found


class Safety(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def cut(self, drawn, *more):
        drawing = self.folder / "drawn.svg"
        drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" '
                           f'viewBox="0 0 100 100">{drawn}</svg>')
        self.program, self.report = self.folder / "out.nc", self.folder / "out.json"
        return run("cut", drawing, *STEEL, "-o", self.program, "--report", self.report,
                   "--svg", self.folder / "out.svg", *more)

    def safety(self):
        return json.loads(self.report.read_text())["safety"]

    def test_nothing_is_told_of_what_is_not_asked_for(self):
        self.assertEqual(self.cut(ROW).returncode, 0)
        self.assertNotIn("safety", json.loads(self.report.read_text()))
        self.assertNotIn("freed", self.program.read_text())

    def test_rapids_go_round_parts(self):
        boxes = [(5 + 25 * i, 40, 25 + 25 * i, 60) for i in range(3)]
        self.assertEqual(self.cut(ROW).returncode, 0)
        self.assertGreater(crossings(self.program.read_text(), boxes), 0)
        done = self.cut(ROW, "--avoid-freed")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(crossings(self.program.read_text(), boxes), 0)
        self.assertGreater(self.safety()["led_round"], 0)
        self.assertIn("rapids routed around freed areas", done.stdout)
        self.assertNotIn("Z", self.program.read_text().split("M4")[1])

    def test_without_a_way_there_is_no_program_or_the_head_is_lifted(self):
        # The origin is in the part, and so is the end of the way home.
        part = '<rect x="-20" y="80" width="40" height="40"/>'
        reach = ("--set", "$20=0")
        done = self.cut(part, "--avoid-freed", "--anyway", *reach)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no rapid leads here from cut 1, rect to zero", done.stderr)
        self.assertIn("its rapids would not be safe", done.stderr)
        self.assertFalse(self.program.exists())
        self.assertEqual(self.cut(part, "--avoid-freed", "--lift", "6", *reach).returncode, 0)
        self.assertIn("G0 Z6\n", self.program.read_text())
        self.assertEqual(self.safety()["lifted"], 1)

    def test_pierces_wait_for_heat(self):
        holes = "".join(f'<circle cx="{20 + 5 * i}" cy="50" r="2"/>' for i in range(5))
        done = self.cut(holes, "--cool", "5", "--cool-distance", "8")
        self.assertEqual(done.returncode, 0, done.stderr)
        waits = [float(text) for text in re.findall(r"M5\nG4 P([0-9.]+)\nM4", self.program.read_text())]
        self.assertEqual(len(waits), self.safety()["waits"])
        self.assertGreater(len(waits), 0)
        self.assertAlmostEqual(sum(waits), self.safety()["waits_s"], 6)
        self.assertIn("cooling: ", done.stdout)
        self.assertGreater(json.loads(self.report.read_text())["job_time_s"], sum(waits))

    def test_neighbours_are_chained(self):
        self.assertEqual(self.cut(COLUMN, "--pierce", "3", "--chain", "40").returncode, 0)
        saved = self.safety()["pierces_saved"]
        self.assertGreater(saved, 0)
        self.assertEqual(self.program.read_text().count("\nG0"), 1 + 3 - saved)

    def test_the_line_between_parts_is_cut_once(self):
        grid = "".join(f'<rect x="{5 + 20.57 * i}" y="{50 + 20.57 * k}" width="20" height="20"/>'
                       for i in range(3) for k in range(2))
        self.assertEqual(self.cut(grid).returncode, 0)
        alone = json.loads(self.report.read_text())
        self.assertNotIn("common_lines", alone)
        done = self.cut(grid, "--common-line", "0.02", "--avoid-freed", "--check")
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(self.report.read_text())
        self.assertEqual(report["common_lines"]["count"], 7)
        self.assertAlmostEqual(report["common_lines"]["length_mm"], 140.0, 6)
        self.assertLess(report["cut_length_mm"], alone["cut_length_mm"] - 140.0)
        self.assertIn("7 lines between parts cut once, 140.0 mm", done.stdout)
        self.assertIn("7 lines between parts cut once", self.program.read_text())
        self.assertEqual(self.cut(grid, "--common-line", "0.005").returncode, 0)
        self.assertEqual(json.loads(self.report.read_text())["common_lines"]["count"], 0)

    def test_the_waste_is_sliced(self):
        done = self.cut(ROW, "--slice", "15")
        self.assertEqual(done.returncode, 0, done.stderr)
        slices = self.safety()["slices"]
        self.assertGreater(slices, 3)
        self.assertEqual(self.program.read_text().count(": waste, slice)"), slices)
        self.assertIn(f"{slices} cuts through the waste", done.stdout)

    def test_all_of_it_at_once(self):
        done = self.cut(ROW, "--avoid-freed", "--cool", "2", "--chain", "20", "--slice", "60",
                        "--pierce", "0.5", "--lift", "5", "--check")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_makes_no_sense_is_refused(self):
        for more in (("--lift", "5"), ("--avoid-freed", "--lift", "0"), ("--cool", "0"),
                     ("--cool", "x"), ("--cool-distance", "5"), ("--chain", "-1"),
                     ("--slice", "nan"), ("--slice-margin", "5"),
                     ("--avoid-freed", "--avoid-margin", "-1")):
            done = self.cut(ROW, *more)
            self.assertEqual(done.returncode, 2, more)
            self.assertIn(more[-2], done.stderr)
            self.assertFalse(self.program.exists())


if __name__ == "__main__":
    KERFLINE = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
