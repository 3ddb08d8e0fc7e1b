#!/usr/bin/env python3
"""`kerfline kerf import`: libraries of materials, and programs with the source of the
measurements.

    kerf_import_test.py KERFLINE
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
SQUARE = ('<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="0 0 60 60">'
          '<rect x="10" y="10" width="30" height="30" fill="none" stroke="#000"/></svg>')
HEADER = ("material,laser,gas_pressure_mpa,thickness_mm,power_w,speed_mm_min,kerf_top_mm,kerf_bottom_mm,"
          "dross_area_mm2,straightness_mm\n")


def entry(thickness, name, mode="Cut", **values):
    tag = "CutSetting_Img" if mode == "Image" else "CutSetting"
    rows = "".join(f'<{key} Value="{value}"/>' for key, value in values.items())
    return f'<Entry Thickness="{thickness}" Desc="{name}"><{tag} type="{mode}">{rows}</{tag}></Entry>'


def library(**materials):
    body = "".join(f'\n<Material name="{name}">{"".join(entries)}</Material>' for name, entries in materials.items())
    return f'<?xml version="1.0"?>\n<LightBurnLibrary DisplayName="Shop">{body}</LightBurnLibrary>'


SHOP = library(Birch=[entry(3, "Cut", maxPower=65, speed=10, numPasses=2), entry(3, "Score", maxPower=12, speed=50),
                      entry(-1, "Fill", "Scan", maxPower=20, speed=300, interval=0.1)],
               Felt=[entry(4, "Cut", speed=8), entry(4, "Photo", "Image", speed=8)])


class Import(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "square.svg").write_text(SQUARE)
        (self.folder / "shop.clb").write_text(SHOP)
        os.utime(self.folder / "shop.clb", (1790000000, 1790000000))

    def run_it(self, *words, status=0):
        done = subprocess.run([KERFLINE, *map(str, words)], capture_output=True, text=True, check=False,
                              env={"PATH": "/usr/bin"}, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        return done

    def kerf(self, *words, status=0):
        return self.run_it("kerf", *words, "--db", "my.db", status=status)

    def cut(self, *words, status=0):
        return self.run_it("cut", "square.svg", "--db", "my.db", *words, "-o", "square.nc", "--report", "square.json",
                           status=status)

    def program(self):
        heading = (self.folder / "square.nc").read_text().split("G21")[0]
        return " ".join(heading.replace("(", "").replace(")", "").split())

    def test_settings_of_a_library_are_marked_as_not_measured_here(self):
        done = self.kerf("import", "shop.clb")
        self.assertIn("4 settings of 2 materials; not measured here: from LightBurn library shop.clb of 2026-09-21",
                      done.stdout)
        self.assertIn('shop.clb:4:', done.stderr)
        self.assertIn('Felt "Cut": cut, 4 mm: power not known, 480 mm/min', done.stderr)
        self.assertIn('Felt "Photo": the mode Image is neither Cut nor Scan; the entry is left out', done.stderr)
        self.assertIn("Birch, Q in W/(mm/min): not measured here", self.kerf("show").stdout)
        shown = self.kerf("show", "--material", "Birch").stdout
        self.assertRegex(shown, r"3 +cut +65 +600 +2 +\? +Cut; not measured here")
        self.assertRegex(shown, r"\? +fill +20 +18000 +\? +\? +Fill; not measured here")
        self.assertIn("of 2020-02-02", self.kerf("import", "shop.clb", "--on", "2020-02-02").stdout)
        self.assertEqual(self.kerf("show", "--material", "Birch").stdout.count("2020-02-02"), 3)

    def test_a_cut_takes_them_with_a_kerf_and_says_so(self):
        self.kerf("import", "shop.clb", "--laser", "tube")
        call = ("--material", "Birch", "--thickness", "3")
        self.assertIn("there are 2 settings to cut it, none measured here; choose one with --entry: \"Cut\"",
                      self.cut(*call, "--kerf", "0.15", status=2).stderr)
        self.assertIn("the kerf of Birch is not known (not measured here: from LightBurn library shop.clb",
                      self.cut(*call, "--entry", "Cut", status=2).stderr)
        done = self.cut(*call, "--entry", "Cut", "--kerf", "0.15")
        self.assertIn("warning: settings of Birch: not measured here: from LightBurn library shop.clb of 2026-09-21",
                      done.stderr)
        report = json.loads((self.folder / "square.json").read_text())
        row = report["layers"][0]
        self.assertEqual((row["power_percent"], row["feed_mm_min"], row["passes"], row["kerf_mm"]), (65, 600, 2, 0.15))
        self.assertFalse(report["kerf"]["measured_on_this_machine"])
        self.assertIn("settings of Birch: not measured here: from LightBurn library shop.clb of 2026-09-21, laser tube",
                      self.program())
        self.cut(*call, "--entry", "Cut", "--kerf", "0.15", "--feed", "500")
        row = json.loads((self.folder / "square.json").read_text())["layers"][0]
        self.assertEqual((row["power_percent"], row["feed_mm_min"], row["passes"]), (65, 500, 2))

    def test_what_is_not_known_is_said(self):
        self.kerf("import", "shop.clb")
        call = ("--kerf", "0.1", "--material")
        self.assertIn("power is not given", self.cut(*call, "Felt", "--thickness", "4", status=2).stderr)
        self.assertIn("no settings are known for 5 mm; there is 4 mm",
                      self.cut(*call, "Felt", "--thickness", "5", status=2).stderr)
        self.assertIn("did you mean Cut?",
                      self.cut(*call, "Birch", "--thickness", "3", "--entry", "Cat", status=2).stderr)
        self.assertIn("--entry: requires a --material",
                      self.run_it("cut", "square.svg", "--entry", "x", status=2).stderr)
        self.assertIn("CSP 1N has no entries",
                      self.cut("--material", "CSP 1N", "--thickness", "2", "--entry", "x", status=2).stderr)
        felt = ("--material", "Felt", "--thickness", "4")
        self.assertIn("--kerf-table", self.cut(*felt, "--kerf-table", "1", status=2).stderr)
        self.assertIn("no kerf is known", self.kerf("advise", *felt, status=1).stderr)
        self.assertIn("no kerf is known", self.kerf("plot", "--material", "Felt", "--svg", "f.svg", status=2).stderr)

    def test_what_is_no_library_changes_nothing(self):
        (self.folder / "bad.clb").write_text("<LightBurnLibrary>\n<Material")
        self.assertIn("bad.clb:2:", self.kerf("import", "bad.clb", status=2).stderr)
        (self.folder / "photos.clb").write_text(library(Slate=[entry(3, "Photo", "Image")]))
        self.assertIn("no entry is for cutting or filling", self.kerf("import", "photos.clb", status=2).stderr)
        self.assertIn("`2026-02-30` is no day", self.kerf("import", "shop.clb", "--on", "2026-02-30", status=2).stderr)
        self.assertFalse((self.folder / "my.db").exists())

    def test_programs_say_who_measured_a_law(self):
        rows = "".join(f"tin,tube,0,2,{power},{speed},{0.1 + power / speed:.4f},{0.1 + power / speed:.4f},,\n"
                       for power in (40, 60) for speed in (400, 500, 600))
        (self.folder / "cuts.csv").write_text(HEADER + rows)
        self.kerf("add", "cuts.csv", "--by", "Ada", "--on", "2026-11-30")
        self.kerf("fit", "--material", "tin")
        self.cut("--material", "tin", "--thickness", "2", "--laser", "tube")
        self.assertIn("kerf of tin: fitted to 6 of 6 test cuts, measured by Ada on 2026-11-30",
                      self.program())


if __name__ == "__main__":
    KERFLINE = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
