#!/usr/bin/env python3
"""`kerfline cut` as its users call it: programs, pictures, reports, and what is refused.

    cut_command_test.py KERFLINE
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80">
<path id="plate" d="M10 10H80A15 15 0 0 1 95 25V60H60V50A8 8 0 0 0 44 50V60H10Z"/>
<circle id="bore" cx="28" cy="30" r="9"/><circle id="screw" cx="80" cy="25" r="2.5"/>
<path id="mark" d="M20 55H30" stroke="red"/>
</svg>
"""
CURVES = """<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="60mm" viewBox="0 0 90 60">
<path id="leaf" d="M10 30C10 5 45 0 80 30C60 60 10 55 10 30Z"/>
<ellipse id="eye" cx="35" cy="30" rx="12" ry="7" transform="rotate(15 35 30)"/>
</svg>
"""
FINE_STEPS = ("--set", "$0=1", "--set", "$100=400", "--set", "$101=400")
STEEL = ("--material", "CSP 1N", "--thickness", "2")


def run(*arguments, text=None):
    return subprocess.run([KERFLINE, *map(str, arguments)], input=text, capture_output=True,
                          text=True, check=False, env={"PATH": "/usr/bin"})


class Cut(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.plate = self.folder / "plate.svg"
        self.plate.write_text(PLATE)
        self.marks = ("--layer", "red: side=on, feed=5000")

    def cut(self, *more):
        return run("cut", self.plate, *STEEL, *self.marks, *more)

    def test_program_picture_and_report(self):
        names = {key: self.folder / f"out.{key}" for key in ("nc", "svg", "json")}
        done = self.cut("-o", names["nc"], "--svg", names["svg"], "--report", names["json"])
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(names["json"].read_text())
        self.assertEqual(report["cuts"], 4)
        self.assertEqual(report["faults"], [])
        self.assertEqual([layer["feed_mm_min"] for layer in report["layers"]], [5000.0, 5000.0])
        program = names["nc"].read_text()
        self.assertIn(f"kerf {report['layers'][0]['kerf_mm']:.4f} mm)", program)
        checked = run("check", names["nc"], "--set", "$32=1", "--json")
        self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertAlmostEqual(json.loads(checked.stdout)["job_time_s"], report["job_time_s"], 2)
        self.assertIn("<svg", names["svg"].read_text())
        for line in program.splitlines():
            self.assertLess(len(line), 80)

    def test_same_call_writes_the_same_program(self):
        self.assertEqual(self.cut().stdout, self.cut().stdout)

    def test_parts_come_after_what_lies_in_them(self):
        order = re.findall(r'^\(\d+: (.*)\)$', self.cut().stdout, re.MULTILINE)
        self.assertEqual(order[-1], 'outer, path "plate"')
        self.assertEqual(sorted(order[:-1]),
                         ['hole, circle "bore"', 'hole, circle "screw"', 'on the line, path "mark"'])

    def test_layers_of_a_file_change_power_and_feed(self):
        layers = self.folder / "layers"
        layers.write_text("# marks are shallow\nred: side=on, power=1200, feed=3000\n")
        done = run("cut", self.plate, *STEEL, "--layers", layers)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("F3000S666.667", done.stdout)

    def refused(self, *call, status=2):
        done = run("cut", *call)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr

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
        self.assertIn("--layer: led-in: no such setting; there are power, feed",
                      self.refused(self.plate, *STEEL, "--layer", "red: led-in=arc:1"))
        for number in ("nan", "inf", "1e99", "x"):
            self.assertIn("feed=", self.refused(self.plate, *STEEL, "--feed", number))

    def drawn(self, name, content):
        file = self.folder / name
        file.write_text(content)
        return file

    def test_faulty_drawings_are_told_with_place_and_remedy(self):
        broken = self.drawn("broken.svg", "<svg><rect x='1'></svg>")
        self.assertIn("broken.svg:1:", self.refused(broken, *STEEL, status=1))
        no_area = self.drawn("flat.svg", PLATE.replace("H30", "H30H20z"))
        self.assertIn("flat.svg", self.refused(no_area, *STEEL, *self.marks, status=1))
        nan = self.drawn("nan.svg", PLATE.replace('cx="28"', 'cx="nan"'))
        self.assertIn("nan.svg:3:", self.refused(nan, *STEEL, *self.marks, status=1))
        small = self.drawn("small.svg", PLATE.replace('r="2.5"', 'r="0.2"'))
        self.assertIn('circle "screw" at 80.200 55.000: is narrower than the kerf of 0.562 mm',
                      self.refused(small, *STEEL, *self.marks, status=1))
        open_line = self.refused(self.plate, *STEEL, status=1)
        self.assertIn('plate.svg:4:', open_line)
        self.assertIn('path "mark"', open_line)

    def test_curves_are_cut_as_arcs_within_the_tolerance(self):
        leaf, name = self.drawn("leaf.svg", CURVES), self.folder / "out.json"
        arcs = {}
        for tolerance, fit in (("0.1", "fewest"), ("0.1", "paper"), ("0.01", "fewest")):
            done = run("cut", leaf, *STEEL, "--tolerance", tolerance, "--fit", fit, "--report", name)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"(3 curves as arcs within {tolerance} mm, fit {fit})\n", done.stdout)
            report = json.loads(name.read_text())
            self.assertEqual((report["curves"], report["tolerance_mm"], report["fit"]),
                             (3, float(tolerance), fit))
            arcs[tolerance, fit] = report["arcs"]
        self.assertLess(arcs["0.1", "fewest"], arcs["0.1", "paper"])
        self.assertLess(arcs["0.1", "fewest"], arcs["0.01", "fewest"])
        self.assertNotIn("curves as arcs", self.cut().stdout)
        self.refused(leaf, *STEEL, "--tolerance", "0")
        self.refused(leaf, *STEEL, "--tolerance", "10.1")
        self.refused(leaf, *STEEL, "--fit", "best")

    def test_check_measures_against_the_drawn_curves(self):
        leaf, name = self.drawn("leaf.svg", CURVES), self.folder / "out.json"
        done = run("cut", leaf, *STEEL, "--check", "-o", self.folder / "out.nc", "--report", name,
                   "--tolerance", "0.05", "--unit", "J/mm", "--full-power", "2800", *FINE_STEPS)
        self.assertEqual(done.returncode, 0, done.stderr)
        edges = json.loads(name.read_text())["edges"]["m4"]
        for peak in ("most_off", "most_left"):
            self.assertLess(abs(edges[peak]["mm"]), 0.055)
        self.assertGreater(edges["most_off"]["mm"] - edges["most_left"]["mm"], 0.05)

    def test_curves_that_no_arcs_follow_are_told_with_their_place(self):
        odd = self.drawn("odd.svg", CURVES.replace("M10 30C10 5 45 0 80 30C60 60 10 55 10 30Z",
                                                   "M2 2C2 2 2 2 9 8L2 12Z"))
        self.assertIn('odd.svg:2:1: path "leaf" at 9.000 52.000: a curve that begins here is',
                      self.refused(odd, *STEEL, status=1))

    def test_anyway_cuts_what_is_sound(self):
        done = run("cut", self.plate, *STEEL, "--anyway", "-o", self.folder / "out.nc")
        self.assertEqual(done.returncode, 1)
        self.assertIn("3 cuts", done.stdout)

    def test_a_machine_that_is_too_small_is_told(self):
        done = self.cut("--set", "$130=50")
        self.assertEqual(done.returncode, 1)
        self.assertIn("$130 allows 50", done.stderr)
        self.assertIn("M2\n", done.stdout)

    def test_check_says_how_well_parts_fit(self):
        name = self.folder / "out.json"
        done = self.cut("--check", "-o", self.folder / "out.nc", "--report", name,
                        "--unit", "J/mm", "--full-power", "2800", *FINE_STEPS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("left on it at most", done.stdout)
        edges = json.loads(name.read_text())["edges"]
        self.assertLess(edges["m4"]["mean_mm"], 0.003)
        self.assertLess(edges["m4"]["heat_ratio"]["greatest"], 1.05)
        self.assertGreater(edges["m4"]["heat_ratio"]["least"], 0.95)
        self.assertGreater(edges["m3"]["heat_ratio"]["greatest"], 2.0)


if __name__ == "__main__":
    KERFLINE = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
