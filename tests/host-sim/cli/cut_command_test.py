#!/usr/bin/env python3
"""`kerfline cut` as its users call it: programs, pictures and reports.

    cut_command_test.py KERFLINE
"""

import json
import math
import re
import sys
import unittest

import cut_bench
from cut_bench import CURVES, FINE_STEPS, PLATE, SHEET, STEEL, CutBench, run


class Cut(CutBench):
    def test_program_picture_and_report(self):
        names = {key: self.folder / f"out.{key}" for key in ("nc", "svg", "json")}
        done = self.cut("-o", names["nc"], "--svg", names["svg"], "--report", names["json"])
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(names["json"].read_text())
        self.assertEqual(report["cuts"], 4)
        self.assertEqual(report["version"], run("--version").stdout.strip())
        self.assertEqual(report["faults"], [])
        self.assertEqual([layer["feed_mm_min"] for layer in report["layers"]], [5000.0, 5000.0])
        program = names["nc"].read_text()
        self.assertIn(f"kerf {report['layers'][0]['kerf_mm']:.4f} mm)", program)
        checked = run("check", names["nc"], "--set", "$32=1", "--json")
        self.assertEqual(checked.returncode, 0, checked.stdout)
        self.assertAlmostEqual(json.loads(checked.stdout)[0]["job_time_s"], report["job_time_s"], 2)
        self.assertIn("<svg", names["svg"].read_text())
        for line in program.splitlines():
            self.assertLess(len(line), 80)

    def test_a_kerf_that_nobody_measured_here_is_told_everywhere(self):
        names = {key: self.folder / f"out.{key}" for key in ("nc", "json")}
        done = self.cut("-o", names["nc"], "--report", names["json"])
        report = json.loads(names["json"].read_text())
        program = " ".join(line.strip("()") for line in names["nc"].read_text().splitlines() if line.startswith("("))
        for text in (done.stderr, program, " ".join(report["kerf"]["warnings"])):
            self.assertIn("the kerf of CSP 1N was not measured on this machine", text)
            self.assertIn("Park and Ahn 2007", text)
            self.assertIn("kerf 0.5617 mm by --unit printed, 0.6625 mm by --unit J/mm", text)
        self.assertFalse(report["kerf"]["measured_on_this_machine"])
        self.assertEqual(report["kerf"]["unit"], "W/(mm/min)")
        done = run("cut", self.plate, "--material", "acrylic", "--thickness", "3", *("--layer", "red: side=on"))
        self.assertIn("measured by nobody", done.stderr)

    def test_full_power_bounds_what_is_chosen(self):
        done = self.cut("--full-power", "1500", "--report", self.folder / "out.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        layer = json.loads((self.folder / "out.json").read_text())["layers"][0]
        self.assertEqual((layer["power_w"], layer["feed_mm_min"]), (1400.0, 5000.0))
        for watts, speed in (("1000", ()), ("1300", ("--feed", "5000"))):
            told = self.refused(self.plate, *STEEL, "--full-power", watts, *speed)
            self.assertIn(f"no power up to the laser's {watts} W (--full-power) is permissible", told)

    def test_wishes_without_room_are_told(self):
        small = self.drawn("small.svg", SHEET + '<rect id="a" x="20" y="20" width="6" height="6"/>'
                           '<rect id="b" x="28" y="17" width="6" height="6"/></svg>')
        window = self.drawn("window.svg", SHEET + '<rect x="20" y="20" width="40" height="40"/>'
                            '<rect id="hole" x="34" y="34" width="12" height="12"/></svg>')

        def told(drawing, *wishes):
            return run("cut", drawing, *STEEL, *wishes).stderr
        self.assertIn("has space for 1 of 40 tabs", told(small, "--tabs", "40", "--tab-width", "8"))
        usual = ("--lead-in", "line:10", "--start", "usual")
        self.assertIn('rect "hole" at ', told(window, *usual))
        self.assertIn("has free space for leads of 50 % of their length", told(window, *usual))
        self.assertNotIn("has free space for leads", told(window, *usual[:2]), "it begins where they have room")
        self.assertIn("have free space for a smaller loop only", told(small, "--corner-loop", "1.5"))
        marks = self.drawn("marks.svg", SHEET + '<path id="m" d="M20 20H90"/><path id="n" d="M20 30H90"/></svg>')
        done = run("cut", marks, *STEEL, "--layer", ": side=on", "--tabs", "2", "--pierce", "0.1")
        self.assertEqual(done.stderr.count("is cut on its line, without tabs, pierce"), 1, done.stderr)
        for leads, told_of in (("lead-in=line:3", "without lead-in"), ("lead-out=arc:3", "without lead-out"),
                               ("lead-in=arc:3, lead-out=line:1, overcut=2", "without lead-in, lead-out, overcut")):
            done = run("cut", marks, *STEEL, "--layer", f": side=on, {leads}")
            self.assertEqual(done.stderr.count(f"is cut on its line, {told_of};"), 1, done.stderr)
        for leads in ("", ", lead-in=none"):  # The lead that a cut has unless it is told is no wish.
            self.assertNotIn("is cut on its line", run("cut", marks, *STEEL, "--layer", f": side=on{leads}").stderr)

    def test_lines_are_engraved_with_any_power(self):
        engraved = ("--layer", "red: side=mark, power=8, feed=20000, rank=0", "--lead-in", "arc:1", "--tabs", "2")
        done = run("cut", self.plate, *STEEL, *engraved, "--full-power", "1800", "--check",
                   "--report", self.folder / "out.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("is cut on its line", done.stderr)
        row = next(row for row in json.loads((self.folder / "out.json").read_text())["layers"]
                   if row["colour"] == "red")
        self.assertEqual((row["power_w"], row["feed_mm_min"], row["kerf_mm"]), (8, 20000, 0))
        self.assertIn("8 W at 20000 mm/min; engraved)", done.stdout)
        self.assertIn('engraved, path "mark"', done.stdout)
        self.assertIn("F20000S4.444\n", done.stdout)
        # Without power and feed in the option of the layer, marking has a tenth of the power of the cut, at its feed.
        done = run("cut", self.plate, *STEEL, "--layer", "red: side=mark", "--mark-power", "5", "--power", "1400")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("S38.889\n", done.stdout)
        for more in ("lead-in=arc:1", "tabs=2", "pierce=0.3"):
            told = self.refused(self.plate, *STEEL, "--layer", f"red: {more}", "--layer", "red: side=mark")
            self.assertIn(f"--layer: {more}: an engraved layer takes power, feed, side, kind, start, rank,", told)

    def test_the_picture_tells_order_size_power_and_kerf(self):
        svg = self.folder / "out.svg"
        done = self.cut("--svg", svg, "--tabs", "3")
        self.assertEqual(done.returncode, 0, done.stderr)
        text = svg.read_text()
        self.assertEqual(re.findall(r'paint-order="stroke">(\d+)<', text), ["1", "2", "3", "4"])
        self.assertIn("85.0 \u00d7 50.0 mm", text)
        self.assertIn("1400 W at 5000 mm/min, kerf 0.5617 mm", text)
        self.assertIn("max-width:100%;max-height:100vh", text)
        length = re.search(r"([\d.]+) mm cut", done.stderr)[1]
        self.assertIn(f"{length} mm cut", text)

    def test_colours_differ_for_the_colour_blind(self):
        """Lines that may be next to each other differ in lightness, whichever cones of the eye are
        missing.
        """
        svg = self.folder / "out.svg"
        self.cut("--svg", svg, "--tabs", "3")
        paths = re.findall(r'<path d="[^"]*" fill="none" stroke="(#\w{6})"', svg.read_text())
        colours = {colour.lower() for colour in paths}
        self.assertEqual(len(colours), 4, "kerf, path, leads and tabs, whose rim is black as the path is")

        def lightness(colour):
            parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
            linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
            y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
            return 116 * y ** (1 / 3) - 16
        order = sorted(map(lightness, colours))
        for dark, light in zip(order, order[1:]):
            self.assertGreater(light - dark, 15)

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

    def test_a_scanned_outline_of_many_points_is_cut(self):
        """The outline has 200,000 points, 160 of them within half a kerf, each with a small deviation."""
        count, places = 200_000, []
        for i in range(count):
            angle, radius = 2 * math.pi * i / count, 95 + 0.01 * math.sin(2.4 * i * i)
            places.append(f"{100 + radius * math.cos(angle):.5f},{100 + radius * math.sin(angle):.5f}")
        content = SHEET + '<polygon points="{}"/></svg>'
        scan = self.drawn("scan.svg", content.format(" ".join(places)))
        name = self.folder / "out.json"
        done = run("cut", scan, *STEEL, "-o", self.folder / "out.nc", "--report", name)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(name.read_text())
        self.assertAlmostEqual(report["cut_length_mm"], 2 * math.pi * 95.29, delta=4.0)
        self.assertLess(report["arcs"], count // 4)

    def test_corners_have_loops_and_dwells(self):
        name, picture = self.folder / "out.json", self.folder / "out.svg"
        done = self.cut("--corner-loop", "3", "--corner-dwell", "0.2", "--report", name, "--svg", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        report = json.loads(name.read_text())["corners"]
        self.assertEqual((report["count"], report["loops"], report["dwells"]), (5, 5, 0))
        self.assertIn(f'5 corners: 5 loops, {report["loops_longer_mm"]:.1f} mm longer; 0 dwells', done.stdout)
        done = self.cut("--corner-dwell", "0.2", "--report", name)
        self.assertEqual(done.stdout.count("G4 P0.200\n"), 5)
        self.assertEqual(json.loads(name.read_text())["corners"]["dwells_s"], 1.0)
        done = self.cut("--corner-dwell", "0.2", "--corner-angle", "91", "--report", name)
        self.assertNotIn("G4", done.stdout)
        self.assertNotIn("corners:", done.stdout)

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
        self.assertIn('odd.svg:2:1: path "leaf" at 9.000 52.000: a part of the curve that begins here is',
                      self.refused(odd, *STEEL, status=1))

    def test_the_controller_finds_the_way_beside_parts(self):
        name, picture, program = (self.folder / f"out.{key}" for key in ("json", "svg", "nc"))
        done = self.cut("--kerf-table", "1", "--unit", "J/mm", "--power", "1800", "--feed", "4000", "--check",
                        "--overcut", "1", "--pierce", "0.1", "-o", program, "--svg", picture,
                        "--report", name, "--set", "$11=0.003", *FINE_STEPS)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("controller", done.stderr)
        text = program.read_text()
        self.assertEqual((text.count("M190 P1 Q2\n"), text.count("\nG42\n"), text.count("\nG40\n")), (1, 3, 3))
        self.assertIn("X95\n", text.replace("Y25", "").replace("Y60", ""))
        edges = json.loads(name.read_text())["edges"]
        self.assertEqual(list(edges), ["power_keeps_kerf", "path_follows_kerf"])
        self.assertLess(abs(edges["power_keeps_kerf"]["most_off_model"]["mm"]), 0.005)
        self.assertGreater(edges["power_keeps_kerf"]["heat_ratio"]["least"], 0.95)
        self.assertLess(edges["power_keeps_kerf"]["heat_ratio"]["greatest"], 1.05)
        self.assertLess(abs(edges["path_follows_kerf"]["most_off_known"]["mm"]), 0.005)
        self.assertIn("within 5 um", picture.read_text())

    def test_what_the_controller_cannot_do_it_is_not_given(self):
        done = self.cut("--kerf-table", "0", "--tabs", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('path "plate" at', done.stderr)
        self.assertIn("is not offset by the controller: it has tabs", done.stderr)
        self.assertEqual(done.stdout.count("\nG42\n"), 2)
        self.assertEqual(self.cut("--kerf-table", "-1").returncode, 2)
        self.assertEqual(self.cut("--kerf-table", "x").returncode, 2)

    def test_anyway_cuts_what_is_sound(self):
        small = self.drawn("small.svg", PLATE.replace('r="2.5"', 'r="0.2"'))
        done = run("cut", small, *STEEL, "--anyway", "-o", self.folder / "out.nc")
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
    cut_bench.KERFLINE = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
