#!/usr/bin/env python3
"""`kerfline cut` with sheet files as its users call it.

    cut_sheet_test.py KERFLINE
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
KEY = """<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm" viewBox="0 0 60 40">
<path id="rim" d="M5 5H40A10 10 0 0 1 50 15V35H5Z"/><circle id="eye" cx="20" cy="20" r="6"/>
</svg>
"""
FRAME = """<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100">
<rect id="outside" x="0" y="0" width="100" height="100"/><rect id="inside" x="10" y="10" width="80" height="80"/>
</svg>
"""
STEEL = ("--material", "CSP 1N", "--thickness", "2")


def run(*arguments, text=None):
    return subprocess.run([KERFLINE, *map(str, arguments)], input=text, capture_output=True,
                          text=True, check=False, env={"PATH": "/usr/bin"})


class Sheets(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "parts").mkdir()
        (self.folder / "parts" / "key.svg").write_text(KEY)
        (self.folder / "parts" / "frame.svg").write_text(FRAME)

    def sheet(self, *parts, locked=False, **stock):
        name = self.folder / "sheet.json"
        name.write_text(json.dumps({"kerfline_sheet": 1, "stock": {"width_mm": 300, "height_mm": 200} | stock,
                                    "locked": locked, "parts": list(parts)}))
        return name

    def cut(self, sheet, *more):
        return run("cut", sheet, *STEEL, *more)

    def refused(self, *parts, **stock):
        output = self.folder / "out.nc"
        done = self.cut(self.sheet(*parts, **stock), "-o", output)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertFalse(output.exists())
        self.assertIn("no program is written", done.stderr)
        return done.stderr

    def test_parts_edge_to_edge_are_cut_along_their_edge_where_lines_are_shared(self):
        parts = [{"drawing": "parts/frame.svg", "places": [{"x_mm": x, "y_mm": 20} for x in (20, 120)]}]
        self.assertIn("nearer than the kerf", self.refused(*parts))
        report = self.folder / "report.json"
        done = self.cut(self.sheet(*parts), "--common-line", "0.02", "-o", self.folder / "out.nc", "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("touches other parts along 100.000 mm"), 2)
        shared = json.loads(report.read_text())["common_lines"]
        self.assertEqual(shared["count"], 1)
        self.assertAlmostEqual(shared["length_mm"], 100, delta=1)

    def test_parts_are_cut_where_they_lie_those_in_holes_first(self):
        done = self.cut(self.sheet({"drawing": "parts/frame.svg", "x_mm": 20, "y_mm": 20},
                                   {"drawing": "parts/key.svg", "name": "key",
                                    "places": [{"x_mm": 40, "y_mm": 40},
                                               {"x_mm": 280, "y_mm": 40, "mirror": True},
                                               {"x_mm": 250, "y_mm": 100, "angle_deg": 90}]}))
        self.assertEqual(done.returncode, 0, done.stderr)
        order = re.findall(r"^\(\d+: \w+, (.*)\)$", done.stdout, re.MULTILINE)
        self.assertEqual(len(order), 8)
        place = {name: order.index(name) for name in order}
        self.assertLess(place['key #1: path "rim"'], place['frame: rect "inside"'])
        self.assertLess(place['frame: rect "inside"'], place['frame: rect "outside"'])
        for copy in (1, 2, 3):
            self.assertLess(place[f'key #{copy}: circle "eye"'], place[f'key #{copy}: path "rim"'])
        checked = run("check", "-", "--set", "$32=1", "--json", text=done.stdout)
        bounds = json.loads(checked.stdout)[0]["bounds_mm"]
        self.assertLess(bounds["X"][1], 300.0)

    # The parts alternate between the two sides, so that no short order equals this one.
    TURNS = ({"drawing": "parts/key.svg", "name": "far", "x_mm": 240, "y_mm": 150},
             {"drawing": "parts/key.svg", "name": "near", "x_mm": 5, "y_mm": 5},
             {"drawing": "parts/key.svg", "name": "middle", "copies": 2, "step_x_mm": 60, "x_mm": 100, "y_mm": 80})

    def parts_in_turn(self, *parts, more=(), **sheet):
        done = self.cut(self.sheet(*parts, **sheet), *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return re.findall(r"^\(\d+: \w+, (.*): path \"rim\"\)$", done.stdout, re.MULTILINE)

    def test_parts_are_cut_after_those_that_the_sheet_names(self):
        far, near, middle = self.TURNS
        as_listed = ["far", "near", "middle #1", "middle #2"]
        self.assertNotEqual(as_listed, self.parts_in_turn(*self.TURNS))
        self.assertEqual(as_listed, self.parts_in_turn(*self.TURNS, locked=True))
        cool = ("--cool", 60, "--cool-distance", 90)
        self.assertEqual(as_listed, self.parts_in_turn(*self.TURNS, more=cool, locked=True))
        waiting = self.parts_in_turn(near | {"after": ["far"]}, middle, far | {"after": ["middle"]})
        self.assertEqual({"middle #1", "middle #2"}, set(waiting[:2]))
        self.assertEqual(["far", "near"], waiting[2:])

    def test_parts_that_wait_for_what_cannot_be_are_told(self):
        a, b, c = ({"drawing": "parts/key.svg", "name": name, "x_mm": 60 * i} for i, name in enumerate("abc"))
        told = self.refused(a | {"after": ["c"]}, b, c | {"after": ["b", "a"]})
        self.assertIn('/parts/0/after: parts wait for each other in a circle: "a" after "c" after "a"; remove', told)
        self.assertIn('"a" after "a"', self.refused(a | {"after": ["a"]}, b))
        self.assertIn('/parts/1/after: no part is called "d"', self.refused(a, b | {"after": ["d"]}))
        self.assertIn('contains a value that is no name', self.refused(a | {"after": [3]}, b))
        self.assertIn('part "b" comes later in the file, and the order is locked',
                      self.refused(a | {"after": ["b"]}, b, locked=True))
        frame = {"drawing": "parts/frame.svg", "name": "frame", "x_mm": 100, "y_mm": 50}
        inside = {"drawing": "parts/key.svg", "name": "inside", "x_mm": 120, "y_mm": 70}
        self.assertIn("inside is inside it and is to be cut later, but inner parts come first",
                      self.refused(inside | {"after": ["frame"]}, frame))
        done = self.cut(self.sheet(frame, inside, locked=True))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("inside is inside it and is to be cut later", done.stderr)

    def test_a_saved_sheet_cuts_the_same(self):
        saved = self.folder / "saved.json"
        alone = self.cut(self.folder / "parts" / "frame.svg", "--save-sheet", saved, "--sheet-margin", "0")
        self.assertEqual(alone.returncode, 0, alone.stderr)
        self.assertEqual(json.loads(saved.read_text())["parts"][0]["drawing"], "parts/frame.svg")
        again = self.folder / "parts" / "again.json"
        placed = self.cut(saved, "--save-sheet", again)
        self.assertEqual(json.loads(again.read_text())["parts"][0]["drawing"], "frame.svg")

        def motions(text):
            return [line for line in text.splitlines() if not line.startswith("(")]
        self.assertEqual(motions(placed.stdout), motions(alone.stdout))
        self.assertEqual(motions(self.cut(again).stdout), motions(alone.stdout))
        self.assertEqual(run("cut", "-", *STEEL, "--save-sheet", saved, text=FRAME).returncode, 2)

    def test_what_is_wrong_with_a_sheet_names_part_place_and_remedy(self):
        key = {"drawing": "parts/key.svg"}
        self.assertIn("key #2 at ", self.refused(key | {"copies": 2, "step_x_mm": 30}))
        self.assertIn("overlaps key #1; move one of them", self.refused(key | {"copies": 2, "step_x_mm": 30}))
        self.assertIn("is 0.300 mm from key #1, nearer than the kerf of 0.562 mm",
                      self.refused(key | {"copies": 2, "step_x_mm": 45.3}))
        self.assertIn("is 5.000 mm beyond the right edge of the stock, 300 by 200 mm less its margin of 5 mm",
                      self.refused(key | {"x_mm": 250}, margin_mm=5))
        self.assertIn('/parts/0: part "none": ', self.refused({"drawing": "parts/none.svg"}))
        self.assertIn("No such file", self.refused({"drawing": "parts/none.svg"}))
        self.assertIn("/parts/0/copies: -1 is out of range; write 1 to 100000", self.refused(key | {"copies": -1}))
        self.assertIn("did you mean drawing?", self.refused({"drawin": "parts/key.svg"}))
        self.assertIn("is a sheet, too", self.refused({"drawing": "sheet.json"}))
        broken = self.folder / "broken.json"
        broken.write_text('{"kerfline_sheet": 1,\n"parts": [}')
        done = self.cut(broken)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("broken.json:2:11: broken JSON", done.stderr)

    def test_only_cut_takes_sheets(self):
        done = run("drawing", self.sheet({"drawing": "parts/key.svg"}))
        self.assertIn("`kerfline cut` takes sheets", done.stdout + done.stderr)


if __name__ == "__main__":
    KERFLINE = sys.argv[1]
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
