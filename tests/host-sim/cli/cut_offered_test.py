#!/usr/bin/env python3
"""`kerfline cut` of a LightBurn project, whose layers contain their settings.

    cut_offered_test.py KERFLINE
"""

import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import seeds_of  # noqa: E402

KERFLINE = ""
PALETTE = ("#000000", "#0000ff", "#ff0000", "#00e000", "#d0d000", "#ff8000")


def setting(index, mode="Cut", **values):
    tag = "CutSetting_Img" if mode == "Image" else "CutSetting"
    rows = "".join(f'<{name} Value="{value}"/>' for name, value in values.items())
    return f'<{tag} type="{mode}"><index Value="{index}"/>{rows}</{tag}>'


def square(index, x, y, side):
    return (f'<Shape Type="Rect" CutIndex="{index}" W="{side}" H="{side}">'
            f'<XForm>1 0 0 1 {x} {y}</XForm></Shape>')


def project(*parts):
    return ('<?xml version="1.0"?>\n<LightBurnProject AppVersion="1.7" FormatVersion="1">' +
            "".join(parts) + "</LightBurnProject>")


CUT = setting(0, name="Edge", minPower=20, maxPower=65.5, speed=12.5, numPasses=2, priority=1)
FILL = setting(1, "Scan", maxPower=20, speed=300, priority=0, interval=0.5, angle=90)
BOX = project(CUT, FILL, square(0, 30, 30, 40), square(1, 30, 30, 10))


def powers_of(program):
    """Returns (S, F) of all motions with the beam on."""
    state, found = {"S": 0.0, "F": 0.0}, set()
    for line in program.splitlines():
        line = re.sub(r"\(.*?\)", "", line)
        for letter, value in re.findall(r"([SF])([\d.]+)", line):
            state[letter] = float(value)
        if re.search(r"[XY]", line) and "G0" not in line and state["S"] > 0:
            found.add((state["S"], state["F"]))
    return found


class Offered(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.drawing = self.folder / "box.lbrn2"
        self.program = self.folder / "box.nc"
        self.report = self.folder / "box.json"

    def cut(self, text, *options, status=0):
        self.drawing.write_text(text)
        done = subprocess.run([KERFLINE, "cut", str(self.drawing), *options, "-o", str(self.program),
                               "--report", str(self.report)], capture_output=True, text=True, check=False,
                              env={"PATH": "/usr/bin"})
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        return done

    def offered(self):
        return json.loads(self.report.read_text())["offered"]

    def layers(self):
        rows = json.loads(self.report.read_text())["layers"]
        return {row["layer"]: (row["power_percent"], row["feed_mm_min"], row["passes"]) for row in rows}

    def test_a_layer_has_what_the_project_says(self):
        self.cut(BOX, "--kerf", "0.15", "--check")
        self.assertEqual(self.layers(), {"Edge": (65.5, 750.0, 2), "C01": (20.0, 18000.0, 1)})
        self.assertEqual(self.offered(), [
            'taken from the project for layer "Edge" #000000: kind=cut, power=65.5 percent, feed=750, passes=2, rank=1',
            'taken from the project for layer "C01" #0000ff: kind=fill, power=20 percent, feed=18000, interval=0.5, '
            'angle=90, rank=0'])
        program = self.program.read_text()
        self.assertEqual(powers_of(program), {(655.0, 750.0), (200.0, 18000.0)})
        self.assertIn("(taken from the project for layer", program)
        self.assertLess(program.index("filled"), program.index("outer"))

    def test_power_is_a_share_of_the_machine(self):
        self.cut(BOX, "--kerf", "0.15", "--machine", "k40", "--move", "0,-150")
        rows = json.loads(self.report.read_text())["layers"]
        self.assertEqual(sorted(row["power_w"] for row in rows), [8.0, 26.2])

    def test_options_win_field_by_field(self):
        self.cut(BOX, "--kerf", "0.15", "--feed", "400")
        self.assertEqual(self.layers(), {"Edge": (65.5, 400.0, 2), "C01": (20.0, 18000.0, 1)})
        self.assertIn("kind=cut, power=65.5 percent, passes=2, rank=1", self.offered()[0])
        self.cut(BOX, "--kerf", "0.15", "--layer", "*: power=30%, passes=3")
        self.assertEqual(self.layers(), {"Edge": (30.0, 750.0, 3), "C01": (30.0, 18000.0, 3)})
        self.cut(BOX, "--kerf", "0.15", "--layer", "C01: side=skip")
        self.assertEqual(self.layers(), {"Edge": (65.5, 750.0, 2)})
        recipe = self.folder / "job.json"
        recipe.write_text('{"kerfline_recipe": 1, "kerf": 0.15, "passes": 5, "layers": {"blue": {"feed": 9000}}}')
        self.cut(BOX, "--recipe", str(recipe))
        self.assertEqual(self.layers(), {"Edge": (65.5, 750.0, 5), "C01": (20.0, 9000.0, 1)})
        self.assertNotIn("feed", self.offered()[1])

    def test_what_is_for_lines_is_not_for_areas(self):
        done = self.cut(BOX, "--kerf", "0.15", "--layer", "C01: kind=engrave", status=2)
        self.assertIn('layer "C01"', done.stderr)
        self.cut(BOX, "--kerf", "0.15", "--layer", "C01: kind=engrave, power=5%, feed=900")
        self.assertEqual(self.layers()["C01"], (5.0, 900.0, 1))
        self.assertIn("power=20 percent, feed=18000, interval=0.5, angle=90 not used, because they are for filling",
                      self.offered()[1])
        self.cut(BOX, "--kerf", "0.15", "--layer", "Edge: kind=score")
        self.assertEqual(self.layers()["Edge"], (65.5, 750.0, 2))

    def test_a_material_that_is_named_gives_power_and_feed_of_cuts(self):
        self.cut(BOX, "--material", "CSP 1N", "--thickness", "2")
        self.assertEqual(self.layers()["C01"], (20.0, 18000.0, 1))
        self.assertEqual(self.layers()["Edge"][2], 1)
        self.assertIn("power=65.5 percent, feed=750, passes=2 not used, because the material gives them",
                      self.offered()[0])

    def test_what_is_no_operation_here_is_said(self):
        both = setting(2, "Scan+Cut", maxPower=30, speed=100)
        text = project(CUT, both, square(0, 30, 30, 40), square(2, 30, 30, 10))
        self.assertIn('layer "C02" #ff0000: power is not given',
                      self.cut(text, "--kerf", "0.15", "--feed", "600", status=2).stderr)
        self.cut(text, "--kerf", "0.15", "--layer", "C02: kind=fill, power=30%, feed=6000")
        self.assertIn("the mode Scan+Cut is none of Cut, Scan, Image and Tool; set its kind with kind=",
                      self.offered()[1])
        dark = setting(0, maxPower=0, speed=10, priority=2000)
        self.assertIn("layer", self.cut(project(dark, square(0, 0, 0, 9)), "--kerf", "0.15", status=2).stderr)
        self.cut(project(dark, square(0, 0, 0, 9)), "--kerf", "0.15", "--power", "40%")
        self.assertEqual(len(self.offered()), 1)
        self.assertRegex(self.offered()[0], "feed=600; power.*0.*; rank.*2000")

    def test_a_tool_layer_is_skipped(self):
        tool = setting(30, "Tool", doOutput=1)
        self.cut(project(CUT, tool, square(0, 30, 30, 40), square(30, 30, 30, 60)), "--kerf", "0.15")
        self.assertEqual(list(self.layers()), ["Edge"])
        self.assertIn("kind=skip", self.offered()[1])

    def test_watts_and_shares_need_the_full_power(self):
        error = self.cut(BOX, "--kerf", "0.15", "--power", "40W", status=2).stderr
        self.assertIn("in watts and as a share of full power; give the power of the laser, W, with --full-power", error)
        self.cut(BOX, "--kerf", "0.15", "--power", "40W", "--layer", "C01: kind=skip")

    def test_any_settings_are_those_of_the_program(self):
        for seed in seeds_of(self, 6):
            dice = random.Random(seed)
            wanted, parts = {}, []
            for index in range(dice.randint(1, 4)):
                percent = dice.randint(1, 1000) / 10
                speed = dice.choice((dice.randint(1, 60), round(dice.uniform(0.5, 60), 2)))
                passes = dice.randint(1, 4)
                parts.append(setting(index, dice.choice(("Cut", "Scan")), maxPower=percent, speed=speed,
                                     numPasses=passes, interval=1, priority=dice.randint(0, 5)))
                parts.append(square(index, 30 + 40 * index, 60, 20))
                wanted[f"C{index:02}"] = (percent, speed * 60, passes)
            self.cut(project(*parts), "--kerf", "0.1")
            found = self.layers()
            self.assertEqual(found.keys(), wanted.keys(), seed)
            for name, values in wanted.items():
                for value, expected in zip(found[name], values):
                    self.assertAlmostEqual(value, expected, 2, (seed, name))


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
