#!/usr/bin/env python3
"""`kerfline cut` without test cuts: known kerfs, layers as operations, machines, placement,
recipes.

    cut_operations_test.py KERFLINE
"""

import json
import math
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
SVG = ('<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
       'width="80mm" height="60mm" viewBox="0 0 80 60" fill="none" stroke="#000">')
LAYERED = SVG + """
<g inkscape:groupmode="layer" inkscape:label="outline" stroke="#f00">
<rect id="plate" x="5" y="5" width="50" height="30"/><circle id="bore" cx="12" cy="12" r="2"/></g>
<g inkscape:groupmode="layer" inkscape:label="lines" stroke="#00f">
<path id="a" d="M 20 20 h 20 M 20 25 q 10 5 20 0"/></g>
<g inkscape:groupmode="layer" inkscape:label="shade" stroke="#00e000">
<rect id="f" x="42" y="10" width="8" height="4"/></g>
</svg>"""
NOTES = SVG + """
<g inkscape:groupmode="layer" inkscape:label="cut"><rect x="5" y="5" width="50" height="30"/></g>
<g inkscape:groupmode="layer" inkscape:label="notes"><text x="20" y="3" font-size="3">3 mm birch</text></g></svg>"""
PLAIN = SVG + '<rect id="r" x="5" y="5" width="50" height="30"/></svg>'
GIVEN = ("--kerf", "0.15", "--power", "60%", "--feed", "600")
OPERATIONS = ("--layer", "lines: kind=engrave, power=20%, feed=3000",
              "--layer", "green: kind=fill, power=15%, feed=6000, interval=0.5")


def run(*arguments, **more):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"}, **more)


def moves_of(program):
    """Returns (g, x, y, s, f) of each motion."""
    words, state, moves = {}, {"G": 0.0}, []
    for line in program.splitlines():
        line = re.sub(r"\(.*?\)", "", line)
        words = re.findall(r"([A-Z])(-?[\d.]+)", line)
        is_motion = False
        for letter, value in words:
            if letter == "G" and float(value) > 3:
                continue
            state[letter] = float(value)
            is_motion = is_motion or letter in "XY"
        if is_motion:
            moves.append((state["G"], state.get("X"), state.get("Y"), state.get("S", 0.0), state.get("F")))
    return moves


class Operations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.layered = self.file("layered.svg", LAYERED)
        self.plain = self.file("plain.svg", PLAIN)
        self.program = self.folder / "job.nc"
        self.report = self.folder / "job.json"

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def cut(self, drawing, *options, status=0):
        done = run("cut", drawing, *options, "-o", self.program, "--report", self.report, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        return done

    def refused(self, drawing, *options, status=2):
        return self.cut(drawing, *options, status=status).stderr

    def test_a_known_kerf_needs_no_material(self):
        done = self.cut(self.plain, *GIVEN, "--check")
        report = json.loads(self.report.read_text())
        self.assertIsNone(report["material"])
        self.assertIsNone(report["full_power_w"])
        layer = report["layers"][0]
        self.assertEqual((layer["kerf_mm"], layer["power_percent"], layer["power_w"]), (0.15, 60.0, None))
        self.assertIn("60 percent at 600 mm/min; kerf 0.1500 mm, given", done.stdout)
        self.assertIn("S600", self.program.read_text())
        for way in report["edges"].values():
            self.assertLess(abs(way["most_off"]["mm"]), 0.005)
        sides = [x for g, x, _, s, _ in moves_of(self.program.read_text()) if g == 1 and s > 0]
        self.assertAlmostEqual(max(sides), 55.075, 3)

    def test_power_is_watts_percent_or_s(self):
        for power, full, s in (("40W", ("--full-power", "80"), 500), ("40", ("--full-power", "50"), 800),
                               ("25%", (), 250), ("S333", (), 333), ("40", (), 1000)):
            done = self.cut(self.plain, "--kerf", "0.1", "--feed", "900", "--power", power, *full)
            self.assertEqual({s for _, _, _, s, _ in moves_of(self.program.read_text()) if s}, {s}, power)
            guessed = power == "40" and not full
            self.assertEqual("full power is not given: S1000 is taken as 40 W" in done.stderr, guessed)
        self.assertIn("power=S1001", self.refused(self.plain, "--kerf", "0.1", "--feed", "900", "--power", "S1001"))
        self.assertIn("in watts and as a share", self.refused(
            self.layered, "--kerf", "0.1", "--feed", "900", "--power", "40", "--layer", "lines: kind=score, power=5%"))

    def test_what_lacks_is_named(self):
        self.assertIn("kerf is not known; give --kerf", self.refused(self.plain, "--power", "60%", "--feed", "600"))
        self.assertIn("power is not given; give --power", self.refused(self.plain, "--kerf", "0.1", "--feed", "600"))
        self.assertIn("feed is not given; give --feed", self.refused(self.plain, "--kerf", "0.1", "--power", "S9"))
        self.assertIn("--thickness is missing", self.refused(self.plain, "--material", "CSP 1N"))
        self.assertIn("--kerf-table", self.refused(self.plain, *GIVEN, "--kerf-table", "1"))
        self.assertIn("requires the thickness",
                      self.refused(self.plain, *GIVEN, "--rule", "hole diameter < thickness: skip"))
        self.assertIn("name one, or leave them out", self.refused(self.plain, *GIVEN, "--unit", "J/mm"))

    def test_a_material_gives_what_is_not_said(self):
        self.cut(self.plain, "--material", "CSP 1N", "--thickness", "2", "--kerf", "0.4")
        layer = json.loads(self.report.read_text())["layers"][0]
        self.assertEqual(layer["kerf_mm"], 0.4)
        self.assertGreater(layer["power_w"], 100.0)

    def test_a_kerf_of_nothing_is_a_path_on_the_line(self):
        self.cut(self.plain, "--kerf", "0", "--power", "60%", "--feed", "600", "--lead-in", "none")
        places = {(x, y) for g, x, y, s, _ in moves_of(self.program.read_text()) if g == 1 and s > 0}
        self.assertEqual(places, {(5.0, 25.0), (55.0, 25.0), (5.0, 55.0), (55.0, 55.0)} & places)
        self.assertEqual(max(x for x, _ in places), 55.0)

    def test_layers_are_operations(self):
        done = self.cut(self.layered, *GIVEN, *OPERATIONS)
        program = self.program.read_text()
        order = re.findall(r"^\(\d+: ([a-z ]+), ([^)]*)\)", program, re.MULTILINE)
        kinds = [kind for kind, _ in order]
        self.assertEqual(sorted(kinds), ["engraved", "engraved", "filled", "hole", "outer"])
        self.assertEqual(kinds[-1], "outer")
        self.assertIn("kerf 0.1500 mm, given", done.stdout)
        powers = {s: f for _, _, _, s, f in moves_of(program) if s}
        self.assertEqual(powers, {600.0: 600.0, 200.0: 3000.0, 150.0: 6000.0})
        lit = 0.0
        here = (0.0, 0.0)
        for _, x, y, s, _ in moves_of(program):
            if s == 150.0:
                lit += abs(x - here[0]) + abs(y - here[1])
            here = (x, y)
        self.assertAlmostEqual(lit * 0.5, 8 * 4, 3)
        checked = run("check", self.program, "--set", "$32=1")
        self.assertEqual(checked.returncode, 0, checked.stdout)

    def test_areas_are_filled_along_their_outline(self):
        along = (*OPERATIONS[:2], "--layer", "green: kind=fill, pattern=contour, power=15%, feed=6000, interval=0.5")
        saved = self.folder / "recipe.json"
        self.cut(self.layered, *GIVEN, *along, "--save-recipe", saved)
        program = self.program.read_text()
        self.assertEqual(json.loads(saved.read_text())["layers"]["green"]["pattern"], "contour")
        lit, here, places = 0.0, (0.0, 0.0), []
        for g, x, y, s, _ in moves_of(program):
            if s == 150.0 and g == 1:
                lit += math.dist((x, y), here)
                places += [here, (x, y)]
            here = (x, y)
        # The rows have 7.5 by 3.5, 6.5 by 2.5, 5.5 by 1.5 and 4.5 by 0.5 mm, with links of 0.5 mm
        # between them.
        self.assertAlmostEqual(lit, 2 * (11 + 9 + 7 + 5) + 3 * 0.5, 2)
        self.assertAlmostEqual(max(x for x, _ in places) - min(x for x, _ in places), 7.5, 3)
        self.cut(self.layered, "--recipe", saved)
        self.assertEqual(self.program.read_text(), program)
        self.assertIn("filled", program)
        checked = run("check", self.program, "--set", "$32=1")
        self.assertEqual(checked.returncode, 0, checked.stdout)

    def test_wrong_patterns_are_refused(self):
        green = "green: kind=fill, power=15%, feed=6000, "
        for text, told in (("pattern=spiral", "pattern=spiral: must be `lines` or `contour`"),
                           ("pattern=lines feed=3000", "put a comma between settings"),
                           ("pattern=contour, angle=45", "angle=45: is for pattern=lines"),
                           ("pattern=contour, overscan=2", "overscan=2: is for pattern=lines")):
            self.assertIn(told, self.refused(self.layered, *GIVEN, *OPERATIONS[:2], "--layer", green + text))
        self.assertIn("pattern=contour: is for a layer with kind=fill", self.refused(
            self.layered, *GIVEN, *OPERATIONS, "--layer", "lines: pattern=contour"))
        told = self.refused(self.layered, *GIVEN, *OPERATIONS[:2], "--layer", green + "pattern=contour, interval=5",
                            status=1)
        self.assertIn("is narrower than the interval of its fill, 5 mm", told)

    def test_every_layer_without_a_rule_has_the_default(self):
        self.cut(self.layered, "--kerf", "0.15", "--layer", "*: power=30%, feed=700",
                 "--layer", "blue: kind=score, power=5%, feed=900", "--layer", "shade: kind=skip")
        layers = json.loads(self.report.read_text())["layers"]
        self.assertEqual([(layer["layer"], layer["power_percent"]) for layer in layers],
                         [("outline", 30.0), ("lines", 5.0)])
        self.assertIn("scored, path", self.program.read_text())

    def test_text_may_lie_in_a_skipped_layer(self):
        notes = self.file("notes.svg", NOTES)
        self.cut(notes, *GIVEN, "--layer", "notes: kind=skip")
        self.assertEqual(json.loads(self.report.read_text())["cuts"], 1)

    def test_passes_z_and_air(self):
        self.cut(self.plain, *GIVEN, "--passes", "3", "--z-step", "0.5")
        program = self.program.read_text()
        self.assertEqual(re.findall(r"pass \d of 3", program), ["pass 1 of 3", "pass 2 of 3", "pass 3 of 3"])
        self.assertEqual(re.findall(r"Z-?[\d.]+", program), ["Z-0.5", "Z-1", "Z0"])
        self.assertEqual(json.loads(self.report.read_text())["cuts"], 3)
        self.cut(self.layered, *GIVEN, "--layer", "blue: kind=engrave, power=9%, feed=999, air=off",
                 "--layer", "green: kind=skip", "--group", "layer")
        air, kind, kinds = "", "", {}
        for line in self.program.read_text().splitlines():
            if re.fullmatch("M[789]", line):
                air = line
            elif kind and line.startswith(("G1", "G2")):
                kinds[kind] = air
            elif match := re.match(r"\(\d+: (\w+),", line):
                kind = match[1]
        self.assertEqual(kinds, {"hole": "M8", "outer": "M8", "engraved": "M9"})
        self.assertIn("--cool", self.refused(self.plain, *GIVEN, "--passes", "2", "--cool", "1"))

    def test_engraving_needs_no_region_of_the_material(self):
        self.cut(self.layered, "--material", "CSP 1N", "--thickness", "2",
                 "--layer", "lines: kind=engrave, power=1, feed=9000", "--layer", "shade: kind=skip")
        self.assertIn('layer "lines"', self.refused(
            self.layered, "--material", "CSP 1N", "--thickness", "2", "--layer", "lines: side=on, power=1, feed=9000",
            "--layer", "shade: kind=skip"))

    def test_a_filled_layer_wants_closed_contours(self):
        told = self.refused(self.layered, *GIVEN, "--layer", "lines: kind=fill, power=9%, feed=999", status=1)
        self.assertIn('path "a"', told)

    def test_machine_and_place(self):
        done = self.cut(self.plain, *GIVEN, "--machine", "k40", "--place", "corner")
        self.assertIn("not measured on yours", done.stderr)
        report = json.loads(self.report.read_text())
        self.assertEqual((report["full_power_w"], report["layers"][0]["power_w"]), (40.0, 24.0))
        self.assertIn("placed: X5.000 to 55.000, Y-35.000 to -5.000 mm, origin at the back left", done.stdout)
        told = self.refused(self.plain, *GIVEN, "--machine", "k40", status=1)
        self.assertRegex(told, r"leaves the bed of K40, CO2 laser of 40 W, 300 x 200 mm, origin at the back left of "
                               r"the bed, by 5\d\.\d{3} mm at its back")
        self.assertIn("no program is written", told)
        self.assertIn("choose diode-20w, diode-5w, k40, router, sheet-cutter",
                      self.refused(self.plain, *GIVEN, "--machine", "k50"))
        for name in ("diode-5w", "diode-20w", "router", "sheet-cutter"):
            self.cut(self.plain, *GIVEN, "--machine", name, "--place", "centre")

    def test_a_drawing_is_moved_turned_mirrored_scaled_and_copied(self):
        self.cut(self.plain, "--kerf", "0", "--power", "S9", "--feed", "900", "--lead-in", "none", "--place", "10,20",
                 "--turn", "90", "--scale", "0.5", "--copies", "2x3", "--copy-gap", "4", "--move=-1,0")
        moves = [(x, y) for g, x, y, s, _ in moves_of(self.program.read_text()) if g == 1 and s > 0]
        self.assertEqual((min(x for x, _ in moves), max(x for x, _ in moves)), (9.0, 9.0 + 2 * 15 + 4))
        self.assertEqual((min(y for _, y in moves), max(y for _, y in moves)), (20.0, 20.0 + 3 * 25 + 2 * 4))
        self.assertEqual(json.loads(self.report.read_text())["cuts"], 6)
        for option in (("--copies", "0x2"), ("--copies", "2"), ("--place", "there"), ("--move", "3"), ("--scale", "0"),
                       ("--mirror", "z"), ("--place", "centre"), ("--turn", "400")):
            self.refused(self.plain, *GIVEN, *option)

    def test_a_recipe_makes_the_same_program(self):
        saved = self.folder / "recipes" / "job.json"
        saved.parent.mkdir()
        self.file("machine.settings", "$120=900\n$121=900\n")
        self.file("layers.txt", "outline: passes=2\n")
        self.cut(self.layered, *GIVEN, *OPERATIONS, "--machine", "k40", "--place", "20,-100", "--turn", "10",
                 "--lead-in", "arc:1", "--order", "nearest", "--cost", "length", "--rule", "hole: feed=80%",
                 "--settings", "machine.settings", "--set", "$11=0.02", "--layers", "layers.txt", "--constant-power",
                 "--copies", "2x1", "--save-recipe", saved)
        first = self.program.read_bytes()
        recipe = json.loads(saved.read_text())
        self.assertEqual(recipe["kerfline_recipe"], 1)
        self.assertEqual(recipe["layers"]["lines"], {"kind": "engrave", "power": "20%", "feed": 3000})
        self.assertEqual((recipe["order"], recipe["cost"], recipe["kerf"]), ("nearest", "length", 0.15))
        self.assertEqual(recipe["settings"], "../machine.settings")
        again = self.folder / "again.json"
        self.cut(self.layered, "--recipe", saved, "--save-recipe", again)
        self.assertEqual(self.program.read_bytes(), first)
        self.cut(self.layered, "--recipe", again)
        self.assertEqual(self.program.read_bytes(), first)

    def test_the_call_goes_before_its_recipe(self):
        recipe = self.file("r.json", '{"kerfline_recipe": 1, "kerf": 0.2, "power": "50%", "feed": 700, '
                                     '"layers": {"*": {"passes": 2}}}')
        self.cut(self.plain, "--recipe", recipe, "--feed", "800", "--layer", "*: passes=1")
        layer = json.loads(self.report.read_text())["layers"][0]
        self.assertEqual((layer["kerf_mm"], layer["power_percent"], layer["feed_mm_min"], layer["passes"]),
                         (0.2, 50.0, 800.0, 1))

    def test_wrong_recipes_are_refused_with_their_place(self):
        for text, told in (('{"kerf": 0.2}', "is no recipe"),
                           ('{"kerfline_recipe": 1, "kerf": "x"}', "r.json: /kerf: "),
                           ('{"kerfline_recipe": 1,\n "kerf" 3}', "r.json:2:"),
                           ('{"kerfline_recipe": 1, "karf": 0.2}', "/karf: there is no such key"),
                           ('{"kerfline_recipe": 1, "output": "x"}', "/output: there is no such key"),
                           ('{"kerfline_recipe": 1, "check": 3}', "/check: must be true or false"),
                           ('{"kerfline_recipe": 1, "layers": {"a": {"pwer": 3}}}', "/layers/a/pwer: "),
                           ('{"kerfline_recipe": 1, "layers": {"nowhere": {"power": 3}}}', "/layers/nowhere: "),
                           ('{"kerfline_recipe": 1, "avoid-margin": 3}', "/avoid-margin: requires --avoid-freed"),
                           ('{"kerfline_recipe": 1, "feed": "1 2"}', "feed=1 2")):
            recipe = self.file("r.json", text)
            self.assertIn(told, self.refused(self.plain, "--recipe", recipe), text)

    def test_a_recipe_beside_the_call_names_files_from_its_folder(self):
        self.file("machine.settings", "$32=1\n")
        call = ("cut", self.plain, *GIVEN, "--settings", "machine.settings", "--save-recipe", "r.json", "-o", "r.nc")
        done = run(*call, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn('"machine.settings"', (self.folder / "r.json").read_text(encoding="utf-8"))
        again = run("cut", self.plain, "--recipe", "r.json", "-o", "s.nc", cwd=self.folder)
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_a_damaged_recipe_is_refused_with_its_name(self):
        whole = ('{"kerfline_recipe": 1, "kerf": 0.2, "power": "50%", "feed": 700, "set": ["$11=0.02"], '
                 '"avoid-freed": true, "layers": {"*": {"passes": 2}}}')
        choose = random.Random(int(os.environ.get("KERFLINE_SEED_BASE", "0") or "0", 36))
        for _ in range(40):
            at = choose.randrange(len(whole))
            text = choose.choice((whole[:at], whole[:at] + choose.choice('[]{}":,1e-') + whole[at:],
                                  whole[:at] + chr(choose.randrange(32, 300)) + whole[at + 1:]))
            recipe = self.file("r.json", text)
            done = run("cut", self.plain, "--recipe", recipe, cwd=self.folder)
            self.assertIn(done.returncode, (0, 1, 2), text)
            self.assertTrue(done.returncode == 0 or done.stderr.startswith("kerfline: "), (text, done.stderr))

    def test_from_a_box_to_a_running_job(self):
        """Follows the walk-through of the README."""
        box = self.file("box.svg", LAYERED.replace("M 20 20 h 20 M 20 25 q 10 5 20 0", "M 20 20 h 20 v 5 h -20 z"))
        self.assertEqual(run("drawing", box).returncode, 0)
        self.cut(box, "--machine", "k40", "--place", "corner", *GIVEN, *OPERATIONS, "--save-recipe",
                 self.folder / "box.json")
        self.assertEqual(run("check", self.program, "--set", "$32=1").returncode, 0)
        picture = self.folder / "box_path.svg"
        self.assertEqual(run("sim", self.program, "--set", "$32=1", "--svg", picture).returncode, 0)
        with subprocess.Popen([KERFLINE, "serve", "--tcp", "0", "--speed", "50"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as machine:
            port = int(machine.stdout.readline().rsplit(":", 1)[1])
            sent = run("send", self.program, "--tcp", f"127.0.0.1:{port}", timeout=120)
            machine.terminate()
        self.assertEqual(sent.returncode, 0, sent.stderr + sent.stdout)


if __name__ == "__main__":
    KERFLINE = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
