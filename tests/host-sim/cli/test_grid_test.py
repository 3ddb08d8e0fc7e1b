#!/usr/bin/env python3
"""`kerfline kerf test-grid`: from a grid of squares to the settings of a cut.

    test_grid_test.py KERFLINE
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
SQUARE = ('<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60">'
          '<rect x="10" y="10" width="30" height="30" fill="none" stroke="#000"/></svg>')
CALL = ("--material", "birch ply", "--thickness", "3", "--power", "20:80", "--feed", "300:1500")


def paths_of(program):
    """Returns (comment, S, F, [points]) of each path with the beam on."""
    found, state, comment, path = [], {}, "", None
    for line in program.splitlines():
        if line.startswith("("):
            comment = line.strip("()")
            continue
        state.update({letter: float(value) for letter, value in re.findall(r"([XYSF])(-?[\d.]+)", line)})
        here = (state.get("X"), state.get("Y"))
        if line.startswith("G0 X"):
            path = [here]
        elif line.startswith("G1 "):
            if len(path) == 1:
                found.append((comment, state["S"], state["F"], path))
            path.append(here)
    return found


def box_of(places):
    xs, ys = zip(*places)
    return min(xs), min(ys), max(xs), max(ys)


class TestGrid(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.form = self.folder / "grid.json"

    def run_it(self, *words, status=0):
        done = subprocess.run([KERFLINE, *map(str, words)], capture_output=True, text=True, check=False,
                              env={"PATH": "/usr/bin"}, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        return done

    def grid(self, *options, call=CALL, status=0):
        return self.run_it("kerf", "test-grid", *call, *options, "--out", "grid.nc", "--form", "grid.json",
                           status=status)

    def paths(self):
        return paths_of((self.folder / "grid.nc").read_text())

    def measured(self, *options, status=0, **changes):
        form = json.loads(self.form.read_text())
        form.update(changes)
        self.form.write_text(json.dumps(form))
        return self.run_it("kerf", "test-grid", "--measured", "grid.json", "--db", "my.db", *options, status=status)

    def test_squares_have_their_power_and_feed(self):
        done = self.grid("--machine", "k40")
        self.assertIn("25 squares of 8 mm, 20 to 80 percent, 300 to 1500 mm/min, 1 pass", done.stdout)
        squares = [path for path in self.paths() if path[0].startswith("square")]
        self.assertEqual([(s, f) for _, s, f, _ in squares],
                         [(10 * power, feed) for feed in (300, 600, 900, 1200, 1500) for power in (20, 35, 50, 65, 80)])
        for number, (_, _, _, places) in enumerate(squares):
            low_x, low_y, high_x, high_y = box_of(places)
            self.assertEqual((round(high_x - low_x, 3), round(high_y - low_y, 3), len(places)), (8, 8, 5))
            self.assertAlmostEqual(low_x - squares[0][3][0][0], number % 5 * 12)
            self.assertAlmostEqual(low_y - squares[0][3][0][1], number // 5 * 12)
        slots = [path for path in self.paths() if path[0].startswith("slot")]
        self.assertEqual([round(box_of(path[3])[2] - box_of(path[3])[0], 3) for path in slots], [5, 10, 15])
        self.assertEqual({(s, f) for _, s, f, _ in slots}, {(800, 300)})
        labels = [path for path in self.paths() if path[0] == "labels"]
        self.assertEqual({(s, f) for _, s, f, _ in labels}, {(100, 3000)})
        for label in labels:
            low_x, low_y, high_x, high_y = box_of(label[3])
            for _, _, _, places in squares + slots:
                left, bottom, right, top = box_of(places)
                apart = high_x < left - 0.3 or low_x > right + 0.3 or high_y < bottom - 0.3 or low_y > top + 0.3
                self.assertTrue(apart, (label, places))

    def test_the_controller_drives_them_so(self):
        self.grid("--machine", "k40", "--constant-power")
        settings = ("--set", "$32=1", "--set", "$110=24000", "--set", "$111=24000", "--set", "$120=2500",
                    "--set", "$121=2000")
        self.assertEqual(self.run_it("check", "grid.nc", *settings).returncode, 0)
        self.run_it("sim", "grid.nc", *settings, "--trace", "grid.csv")
        rows, scale = [], 1.0
        for line in (self.folder / "grid.csv").read_text().splitlines():
            if line.startswith("#"):
                if match := re.search(r"steps_per_mm X=([\d.]+) Y=([\d.]+)", line):
                    scale = float(match[1]), float(match[2])
            elif line[0].isdigit():
                words = line.split(",")
                rows.append((int(words[0]) * 1e-9, int(words[1]) / scale[0], int(words[2]) / scale[1],
                             float(words[-1])))
        squares = [path for path in self.paths() if path[0].startswith("square")]
        for name, s, feed, places in squares:
            (left, y), right = places[0], places[1][0]
            middle = [row for row in rows if abs(row[2] - y) < 0.01 and left + 2 < row[1] < right - 2 and row[3] > 0]
            self.assertGreater(len(middle), 100, name)
            self.assertEqual({round(row[3] * 1000) for row in middle}, {s}, name)
            speed = 60 * (middle[-1][1] - middle[0][1]) / (middle[-1][0] - middle[0][0])
            self.assertAlmostEqual(speed / feed, 1.0, 2, name)

    def test_any_grid_is_as_asked_and_in_the_bed(self):
        for seed in seeds_of(self, 20):
            dice = random.Random(seed)
            low, high = sorted(round(dice.uniform(1, 100), 1) for _ in range(2))
            slow, fast = sorted(dice.randint(10, 6000) for _ in range(2))
            columns, rows = dice.randint(2, 6), dice.randint(2, 6)
            passes, cell, gap = dice.randint(1, 3), dice.randint(8, 14), dice.randint(2, 6)
            kind = dice.choice(("cut", "fill"))
            self.grid("--power-steps", columns, "--feed-steps", rows, "--passes", passes, "--cell", cell, "--gap", gap,
                      "--kind", kind, "--interval", "2", "--machine", "diode-5w", "--place", "centre",
                      call=("--material", "m", "--thickness", "3", "--power", f"{low}:{high}", "--feed",
                            f"{slow}:{fast}"))
            squares = [path for path in self.paths() if path[0].startswith("square")]
            self.assertEqual(len(squares), columns * rows * passes * (1 if kind == "cut" else cell // 2), seed)
            wanted = {(low + (high - low) * i / (columns - 1), slow + (fast - slow) * j / (rows - 1))
                      for i in range(columns) for j in range(rows)}
            for _, s, feed, _ in squares:
                self.assertTrue(any(abs(s / 10 - power) < 0.002 and abs(feed - f) < 0.002 for power, f in wanted), seed)
            for _, _, _, places in self.paths():
                left, bottom, right, top = box_of(places)
                self.assertTrue(0 <= left and 0 <= bottom and right <= 400 and top <= 400, (seed, places))

    def test_what_cannot_be_is_refused_with_its_range(self):
        base = ("--material", "m", "--thickness", "3")
        for options, reason in (
                (("--power", "20:180", "--feed", "300"), "--power 20:180: must be LOW:HIGH or one number, 0.1 to 100"),
                (("--power", "80:20", "--feed", "300"), "--power 80:20: must have the lower number first"),
                (("--power", "x", "--feed", "300"), "--power x: must be"),
                (("--power", "20", "--feed", "0:9"), "--feed 0:9: must be LOW:HIGH or one number, 1 to"),
                (("--power", "20:80", "--feed", "9", "--power-steps", "1"), "a range requires at least 2 steps"),
                (("--power", "20"), "--power and --feed are missing"),
                (("--power", "20", "--feed", "300:30000", "--machine", "k40"), "30000 mm/min exceeds the greatest"),
                (("--power", "20:80", "--feed", "300:900", "--cell", "40", "--machine", "k40"),
                 "leaves the bed of K40"),
                (("--power", "20", "--feed", "300", "--move", "-9,0"), "leaves the quadrant of X0 Y0 by 4.000 mm"),
                (("--power", "20:80", "--feed", "300", "--cell", "1", "--gap", "0.5"), "--cell: labels of 1.2 mm")):
            self.assertIn(reason, self.grid(*options, call=base, status=2).stderr)
        self.assertIn("--thickness is missing",
                      self.grid("--power", "20", "--feed", "300", call=("--material", "m"), status=2).stderr)
        self.assertIn("--passes", self.grid("--passes", "0", status=2).stderr)
        self.assertFalse((self.folder / "grid.nc").exists())

    def test_a_measured_form_becomes_the_settings_of_a_cut(self):
        self.grid("--laser", "tube")
        form = json.loads(self.form.read_text())
        for row in form["squares"]:
            row["result"] = "good" if row["power_percent"] / row["feed_mm_min"] > 0.055 else "bad"
        form["squares"][-1]["result"] = ""
        for row, width in zip(form["slots"]["rows"], (5.16, 10.14, None)):
            row["measured_mm"] = width
        done = self.measured(squares=form["squares"], slots=form["slots"], measured_by="Ada", measured_on="2026-11-30")
        self.assertIn("measured by Ada on 2026-11-30, grid.json", done.stdout)
        self.assertIn("kerf 0.150 mm, the mean of 2 slots at 80 percent and 300 mm/min, is used for all squares",
                      done.stderr)
        self.assertIn("1 squares have no result", done.stderr)
        (self.folder / "square.svg").write_text(SQUARE)
        self.run_it("cut", "square.svg", "--db", "my.db", "--material", "birch ply", "--thickness", "3",
                    "--laser", "tube", "-o", "square.nc", "--report", "square.json")
        report = json.loads((self.folder / "square.json").read_text())
        row = report["layers"][0]
        self.assertEqual((row["power_percent"], row["feed_mm_min"]), (80, 1200), "the fastest with the least power")
        self.assertAlmostEqual(row["kerf_mm"], 0.15, 6)
        self.assertTrue(report["kerf"]["measured_on_this_machine"])
        heading = (self.folder / "square.nc").read_text().split("G21")[0]
        self.assertIn("settings of birch ply: measured by Ada on 2026-11-30, grid.json, laser tube",
                      " ".join(re.sub("[()]", "", heading).split()))
        self.measured(measured_on="2026-12-01")
        shown = self.run_it("kerf", "show", "--db", "my.db", "--material", "birch ply").stdout
        self.assertNotIn("2026-11-30", shown, "the later form counts")

    def test_a_wrong_form_is_refused_by_its_place(self):
        self.grid()
        fresh = json.loads(self.form.read_text())
        person = {"measured_by": "Ada", "measured_on": "2026-11-30"}
        good = [{**row, "result": "good"} for row in fresh["squares"]]

        def slots(*widths):
            rows = [{"path_mm": 5.0, "measured_mm": width} for width in widths]
            return {**fresh["slots"], "rows": rows}

        for changes, reason in (
                ({}, "measured_by"), ({"measured_by": "Ada"}, "measured_on"),
                ({**person, "measured_on": "30.11.2026"}, "measured_on"),
                ({**person}, "no square is good"), ({**person, "squares": 3}, "/squares: must be the list"),
                ({**person, "squares": [{"result": "good"}]}, "/squares/0/power_percent: must be a number"),
                ({**person, "squares": [{**good[0], "result": "yes"}]}, "/squares/0/result: must be"),
                ({**person, "squares": [{**good[0], "power_percent": 101}]}, "/squares/0/power_percent"),
                ({**person, "squares": good, "slots": slots(4.9)}, "a slot is wider than its path"),
                ({**person, "squares": good, "slots": slots(5.1, 5.6)}, "differ, from 0.100 to 0.600 mm"),
                ({**person, "squares": good, "material": ""}, "material"), ({"kind": "burn"}, "kind"),
                ({"kerfline_test_grid": 2}, "kerfline_test_grid")):
            self.form.write_text(json.dumps(fresh))
            self.assertIn(reason, self.measured(status=2, **changes).stderr)
        self.assertFalse((self.folder / "my.db").exists())
        self.form.write_text(json.dumps(fresh))
        done = self.measured("--by", "Ada", "--on", "2026-11-30", squares=good)
        self.assertIn("no slot was measured: the kerf is not known", done.stderr)


if __name__ == "__main__":
    KERFLINE = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
