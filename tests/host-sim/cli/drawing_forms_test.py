#!/usr/bin/env python3
"""`kerfline drawing` and `cut` with drawings of other programs: units, gaps, LightBurn projects.

    drawing_forms_test.py KERFLINE
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
STEEL = ("--material", "CSP 1N", "--thickness", "2", "--lead-in", "none")
PROJECT = """<?xml version="1.0" encoding="UTF-8"?>
<LightBurnProject AppVersion="1.7.08" FormatVersion="1" MirrorX="False" MirrorY="False">
<CutSetting type="Cut"><index Value="0"/><name Value="Edge"/><maxPower Value="60"/><speed Value="9"/></CutSetting>
<Shape Type="Rect" CutIndex="0" W="50" H="30" Cr="3"><XForm>1 0 0 1 50 50</XForm></Shape>
<Shape Type="Text" CutIndex="1" Str="left out" H="9"><XForm>1 0 0 1 50 50</XForm></Shape>
</LightBurnProject>
"""


def dxf_of(entities, unit=4):
    return (f"0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{unit}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}"
            "0\nENDSEC\n0\nEOF\n")


def loose_square(side, gap):
    corners = ((gap, 0, side, 0), (side, gap, side, side), (side - gap, side, 0, side), (0, side - gap, 0, 0))
    return "".join(f"0\nLINE\n8\nCut\n10\n{a}\n20\n{b}\n11\n{c}\n21\n{d}\n" for a, b, c, d in corners)


def two_beziers():
    """Returns a spline with inner knots of multiplicity degree + 1, and a line that closes it."""
    knots = [0] * 4 + [0.5] * 4 + [1] * 4
    points = ((0, 0), (0, 10), (10, 10), (10, 0), (10, 0), (10, -10), (0, -10), (0, 0))
    return ("0\nSPLINE\n8\n0\n70\n8\n71\n3\n" + "".join(f"40\n{knot}\n" for knot in knots)
            + "".join(f"10\n{x}\n20\n{y}\n" for x, y in points))


def pdf_of(content):
    """Returns a page of 100 mm by 100 mm with these operators, and with bytes that are not text."""
    size = 100 * 72 / 25.4
    parts = ["<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
             f"<</Type/Page/Parent 2 0 R/MediaBox[0 0 {size:.4f} {size:.4f}]/Contents 4 0 R>>",
             f"<</Length {len(content)}>>\nstream\n{content}\nendstream"]
    text, places = "%PDF-1.4\n%" + "\x00\x01\x02\xe2" * 40 + "\n", []
    for number, part in enumerate(parts, 1):
        places.append(len(text))
        text += f"{number} 0 obj\n{part}\nendobj\n"
    rows = "".join(f"{place:010} 00000 n \n" for place in places)
    return text + (f"xref\n0 5\n0000000000 65535 f \n{rows}trailer\n<</Size 5/Root 1 0 R>>\nstartxref\n{len(text)}\n"
                   "%%EOF\n")


class DrawingForms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_on(self, command, name, text, *more):
        file = self.folder / name
        file.write_bytes(text if isinstance(text, bytes) else text.encode("latin-1"))
        return subprocess.run([KERFLINE, command, file, *more], capture_output=True, text=True, check=False)

    def read(self, name, text, *more, status=0):
        done = self.run_on("drawing", name, text, "--json", *more)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return json.loads(done.stdout)

    def test_a_spline_of_two_beziers_is_one_contour(self):
        drawn = self.read("spline.dxf", dxf_of(two_beziers()))
        self.assertEqual([contour["side"] for contour in drawn["contours"]], ["outer"])
        self.assertEqual(drawn["faults"], [])

    def test_most_gaps_are_closed_when_asked_and_said(self):
        loose = dxf_of(loose_square(30, 0.07))
        refused = self.run_on("cut", "loose.dxf", loose, *STEEL, "--gap", "0.01")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("--gap 0.1 closes 8 of 8 open ends", refused.stderr)
        done = self.run_on("cut", "loose.dxf", loose, *STEEL, "--gap", "auto")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("note: ", done.stderr)
        self.assertIn("gaps up to 0.1 mm are joined", done.stderr)
        self.assertIn("G1", done.stdout)

    def test_gaps_that_are_certain_are_closed_and_said(self):
        done = self.run_on("cut", "loose.dxf", dxf_of(loose_square(30, 0.07)), *STEEL)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("note: ", done.stderr)
        self.assertIn("gaps between two ends without a third end near are joined by lines", done.stderr)

    def test_units_are_said_and_set(self):
        circle = "0\nCIRCLE\n8\n0\n40\n1\n"
        asked = self.read("plan.dxf", dxf_of(circle, 0))
        self.assertEqual({fault["kind"] for fault in asked["faults"]}, {"note"})
        remedies = " ".join(fault["remedy"] for fault in asked["faults"])
        self.assertIn("--drawing-unit inch", remedies)
        inches = self.read("plan.dxf", dxf_of(circle, 0), "--drawing-unit", "inch")
        self.assertEqual(inches["faults"], [])
        self.assertAlmostEqual(inches["contours"][0]["length_mm"], 159.593, 3)
        self.assertEqual(self.read("plan.dxf", dxf_of(circle, 0), "--drawing-unit", "25.4"), inches)
        for wrong in ("ell", "0", "-1", "nan"):
            done = self.run_on("drawing", "plan.dxf", dxf_of(circle), "--drawing-unit", wrong)
            self.assertEqual(done.returncode, 2)
            self.assertIn("choose mm, inch, cm", done.stderr)

    def test_a_project_of_lightburn_is_cut_but_its_letters(self):
        done = self.run_on("cut", "job.lbrn2", PROJECT, *STEEL)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Text: letters are no paths", done.stderr)
        drawn = self.read("job.lbrn2", PROJECT)
        self.assertEqual([(row["layer"], row["colour"]) for row in drawn["contours"]], [("Edge", "#000000")])

    def test_a_page_of_pdf_is_cut(self):
        page = pdf_of("1 0 0 RG 0.3 w 28.3465 28.3465 141.7323 85.0394 re S")
        drawn = self.read("page.pdf", page)
        self.assertEqual([row["colour"] for row in drawn["contours"]], ["#ff0000"])
        self.assertAlmostEqual(drawn["contours"][0]["area_mm2"], 1500, 1)
        done = self.run_on("cut", "page.pdf", page, *STEEL)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_is_not_read_has_a_way_round(self):
        for name, text, way in (("a.eps", "%!PS-Adobe-3.0 EPSF-3.0\n", "open it in Inkscape"),
                                ("a.pdf", "%PDF-1.7\n", "export it again")):
            done = self.run_on("drawing", name, text)
            self.assertEqual(done.returncode, 1)
            self.assertIn(way, done.stdout)


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
