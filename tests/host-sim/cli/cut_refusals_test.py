#!/usr/bin/env python3
"""`kerfline cut` where it refuses or warns: conditions, drawings, travel.

    cut_refusals_test.py KERFLINE
"""

import re
import sys
import unittest

import cut_bench
from cut_bench import PLATE, SHEET, STEEL, CutBench, run


class Refusals(CutBench):
    def test_what_is_not_permissible_says_what_is(self):
        self.assertIn("3000 to 5000 mm/min at 1800 W",
                      self.refused(self.plate, *STEEL, "--feed", "9000"))
        self.assertIn("permissible are 0.5 to 2 mm",
                      self.refused(self.plate, "--material", "CSP 1N", "--thickness", "3"))
        self.assertIn("there are CSP 1N",
                      self.refused(self.plate, "--material", "tin", "--thickness", "1"))
        self.assertIn("1500 W are more than the laser's 1000 W",
                      run("cut", self.plate, *STEEL, *self.marks, "--power", "1500",
                          "--full-power", "1000").stderr)
        self.assertIn('no layer or colour "blue"; it has',
                      self.refused(self.plate, *STEEL, "--layer", "blue: feed=1"))
        self.assertIn("--layer: led-in: there is no such setting; settings are power, feed",
                      self.refused(self.plate, *STEEL, "--layer", "red: led-in=arc:1"))
        for number in ("nan", "inf", "1e99", "x"):
            self.assertIn("feed=", self.refused(self.plate, *STEEL, "--feed", number))


    def test_faulty_drawings_are_told_with_place_and_remedy(self):
        broken = self.drawn("broken.svg", "<svg><rect x='1'></svg>")
        self.assertIn("broken.svg:1:", self.refused(broken, *STEEL, status=1))
        nan = self.drawn("nan.svg", PLATE.replace('cx="28"', 'cx="nan"'))
        self.assertIn("nan.svg:3:", self.refused(nan, *STEEL, *self.marks, status=1))
        small = self.drawn("small.svg", PLATE.replace('r="2.5"', 'r="0.2"'))
        self.assertIn('circle "screw" at 80.200 55.000: is narrower than the kerf of 0.562 mm',
                      self.refused(small, *STEEL, *self.marks, status=1))
        gap = self.drawn("gap.svg", PLATE.replace("H30", "H30V58H20V55.25"))
        open_line = self.refused(gap, *STEEL, "--gap", "0.01", status=1)
        self.assertIn('gap.svg:4:', open_line)
        self.assertIn('path "mark"', open_line)
        self.assertIn("the contour is open", open_line)

    def test_open_lines_are_cut_on_the_line_with_a_warning(self):
        done = run("cut", self.plate, *STEEL)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('warning: ', done.stderr)
        self.assertIn('plate.svg:4:1: path "mark" at 20.000 25.000: 1 open contour of layer "" red', done.stderr)
        self.assertIn("4 cuts", done.stderr)

    def test_travel_that_no_machine_was_named_for_is_a_warning(self):
        long = self.drawn("long.svg", PLATE.replace("H80A15 15 0 0 1 95 25V60", "H360V60"))
        told = run("cut", long, *STEEL)
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertRegex(told.stderr, r"warning: .*\$130 allows 300")
        self.assertIn("give that of your machine with --machine or --settings", told.stderr)
        refused = run("cut", long, *STEEL, "--set", "$130=320")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("$130 allows 320", refused.stderr)

    def test_layers_that_are_not_permissible_are_named(self):
        for more, what in (("power=100", "power 100 W is outside of the test cuts; permissible are 1200 to"),
                           ("feed=100", "no power is permissible for 100 mm/min; permissible are 3000 to")):
            told = self.refused(self.plate, *STEEL, "--layer", f"red: side=on, {more}")
            self.assertIn(f'layer "" red: CSP 1N: {what}', told)
        for number in ("nan", "-1", "x", "101"):
            self.assertIn("--thickness", self.refused(self.plate, "--material", "CSP 1N", "--thickness", number))
        for key in ("corner-loop", "corner-dwell", "corner-angle", "pierce", "overcut"):
            for number in ("nan", "-1", "1e9", "x"):
                self.assertIn(f"{key}={number}: ", self.refused(self.plate, *STEEL, f"--{key}", number))

    def test_what_no_drawing_is_says_where_and_what_to_do(self):
        """Each kind of broken file is reported with file, line, entity, reason and remedy."""
        svg = '<svg width="40mm" height="40mm" viewBox="0 0 40 40">\n{}</svg>'
        dxf = "0\nSECTION\n2\nENTITIES\n0\n{}0\nENDSEC\n0\nEOF\n"
        for name, content, told in (
                ("empty.svg", "", ":1: it is empty; export the drawing again"),
                ("word.svg", "hello", ":1: it is neither SVG nor DXF nor JSON; export"),
                ("tags.svg", "<svg>\n<rect></svg>", ":2:9: broken XML: Start-end tags mismatch; export"),
                ("end.svg", "<svg", ":1:4: broken XML: "),
                ("end.json", '[{"a":1', ":1:8: broken JSON; export it again"),
                ("nan.svg", svg.format('<path id="p" d="M1 1L nan 5Z"/>'),
                 ':2:1: path "p": L needs 2 numbers at character 7 of d; it is left out; correct it'),
                ("far.svg", svg.format('<path id="p" d="M1 1L1e9 5L3 4Z"/>'),
                 ':2:1: path "p": one of its points is not a number, or is farther than 10 km'),
                ("nan.dxf", dxf.format("LINE\n8\n0\n10\nnan\n20\n0\n11\n5\n21\n5\n"),
                 ":6: LINE: line 10: `nan` is no number; it is left out; correct it in the drawing"),
                ("dot.dxf", dxf.format("CIRCLE\n8\n0\n10\n5\n20\n5\n40\n0\n"),
                 ":6: CIRCLE: its radius is not above 0; it is left out; correct it in the drawing"),
                ("end.dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n",
                 "the file ends without EOF; it was cut off; copy or save it again")):
            with self.subTest(name):
                file = self.drawn(name, content)
                stderr = self.refused(file, *STEEL, status=1)
                self.assertIn(f"{file}", stderr)
                self.assertIn(told, stderr)
                self.assertIn("no program is written", stderr)
                if not content:
                    continue
                read = run("drawing", file)
                self.assertEqual(read.returncode, 1, read.stdout)
                self.assertIn(told, read.stdout)

    def test_shapes_of_no_size_are_noted_and_the_rest_is_cut(self):
        plate = PLATE.replace("</svg>", '<rect id="r" x="1" y="1" width="0" height="5"/><circle id="c" r="0"/>'
                              '<ellipse id="e" rx="3" ry="0"/></svg>')
        done = run("cut", self.drawn("dots.svg", plate), *STEEL, *self.marks)
        self.assertEqual(done.returncode, 0, done.stderr)
        for note in ('rect "r": width or height is 0: it has no area; it is left out; correct it',
                     'circle "c": r is 0: it has no area', 'ellipse "e": rx or ry is 0'):
            self.assertIn(note, done.stderr)
        self.assertIn("no program is written", self.refused(self.drawn(
            "dot.svg", '<svg width="4mm" height="4mm"><circle id="c" r="0"/></svg>'), *STEEL, status=1))

    def test_closed_contours_without_area_are_lines_where_they_are_seen(self):
        plate = PLATE.replace("</svg>", '<path id="f" d="M1 1H9Z"/></svg>')
        done = run("cut", self.drawn("flat.svg", plate), *STEEL, *self.marks)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r'note: .*path "f" at 1\.000 [\d.]+: the contour is closed and has no area; '
                         "it is left out; give it a stroke to draw a line")
        line = '<svg width="40mm" height="40mm" viewBox="0 0 40 40"><path id="f" stroke="red" d="M1 1H9Z"/></svg>'
        program = self.folder / "line.nc"
        done = run("cut", self.drawn("line.svg", line), "--kerf", "0.2", "--power", "5W", "--feed", "600",
                   "--full-power", "10", "-o", program)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('1 open contour of layer "" red, this one first, is cut on the line', done.stderr)
        self.assertEqual(re.findall(r"^G1.*", program.read_text(), re.M), ["G1X9F600S500"])
        read = run("drawing", self.drawn("line.svg", line))
        self.assertIn("the contour is closed and has no area; it is read as a line", read.stdout)

    def test_hairs_are_not_said_to_have_no_area(self):
        """The lines of these shapes run back 0.1 um apart."""
        places = [f"{100 + 0.0001 * i:.4f},{10 + i % 2 * (20 + i * i % 1000 / 50):.4f}" for i in range(30_000)]
        content = SHEET + '\n<polygon id="hair" points="{} 103,5 100,5"/></svg>'
        hair = self.drawn("hair.svg", content.format(" ".join(places)))
        self.assertIn('hair.svg:2:1: polygon "hair" at 100.000 190.000: the contour runs to and fro: '
                      "57.990 mm2 in 859813 mm of path, 0.00013 mm wide on average; it is left out; simplify it",
                      self.refused(hair, *STEEL, status=1))


if __name__ == "__main__":
    cut_bench.KERFLINE = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
