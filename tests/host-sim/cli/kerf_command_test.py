#!/usr/bin/env python3
"""`kerfline kerf` as its users call it: from test cuts to a table for the controller.

    kerf_command_test.py KERFLINE EXAMPLES
"""

import csv
import json
import pathlib
import re
import sqlite3
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

KERFLINE = ""
EXAMPLES = pathlib.Path()
# Leaks of the libraries behind --png; only a sanitized build reads this file.
SUPPRESSIONS = pathlib.Path(__file__).with_name("leaks.supp")

# Table 2 (mm: W: mm/min) and Table 3 (mm: l1, l2) of Park and Ahn 2007, typed from the paper.
TABLE_2 = {
    0.5: {1200: (4000, 10000), 1400: (4000, 10000), 1600: (5000, 9000), 1800: (5000, 9000)},
    1.0: {1200: (4000, 6000), 1400: (4000, 7000), 1600: (4000, 7000), 1800: (4000, 7000)},
    1.6: {1200: (2000, 5000), 1400: (2000, 5000), 1600: (3000, 5000), 1800: (3000, 5000)},
    2.0: {1200: (3000, 4000), 1400: (3000, 5000), 1600: (3000, 5000), 1800: (3000, 5000)},
}
TABLE_3 = {0.5: (.0097, .398), 1.0: (.0085, .441), 1.6: (.0053, .546), 2.0: (.0061, .560)}
HEADER = ["material", "laser", "gas_pressure_mpa", "thickness_mm", "power_w", "speed_mm_min",
          "kerf_top_mm", "kerf_bottom_mm", "dross_area_mm2", "straightness_mm"]


def run(*arguments):
    return subprocess.run(
        [KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
        env={"PATH": "/usr/bin", "LSAN_OPTIONS": f"suppressions={SUPPRESSIONS}"})


def kerf(*arguments):
    return run("kerf", *arguments)


def advise(material, thickness, power, speed, *more):
    return kerf("advise", "--material", material, "--thickness", thickness, "--power", power,
                "--speed", speed, *more)


def cuts_of_the_paper(seconds):
    """Returns a cut at every m/min of Table 2, with the widths of Table 3; Q in W/(mm/min) times
    `seconds`. Just outside of each window there is a cut with too much dross.
    """
    for thickness, powers in TABLE_2.items():
        slope, intercept = TABLE_3[thickness]
        for power, (least, most) in powers.items():
            for speed in range(least - 1000, most + 1001, 1000):
                width = slope * seconds * power / speed + intercept
                good = least <= speed <= most
                yield ["steel", "a laser", 0.1, thickness, power, speed, width + .03, width - .03,
                       0.4 if good else 0.6, 0.005]


class KerfCommand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.base = self.folder / "kerf.db"

    def write_cuts(self, rows, name="cuts.csv"):
        file = self.folder / name
        with file.open("w", newline="") as stream:
            csv.writer(stream).writerows([HEADER, *rows])
        return file

    def count(self, table):
        connection = sqlite3.connect(self.base)
        self.addCleanup(connection.close)
        return connection.execute(f"SELECT count(*) FROM {table}").fetchone()[0]

    def test_advises_the_worked_example(self):
        done = advise("CSP 1N", 2.0, 1800, 4000)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("kerf 0.562745 mm, 95 % of cuts within +/- 0.010 mm; offset 0.281373 mm",
                      done.stdout)
        self.assertIn("kerf 0.724700 mm", advise("CSP 1N", 2, 1800, 4000, "--unit", "J/mm").stdout)

    def test_refuses_whatever_is_outside_of_table_2_and_says_what_is_permissible(self):
        for thickness, powers in TABLE_2.items():
            for power, (least, most) in powers.items():
                for speed in (least, most):
                    self.assertEqual(advise("CSP 1N", thickness, power, speed).returncode, 0)
                for speed in (least - .01, most + .01):
                    done = advise("CSP 1N", thickness, power, speed)
                    self.assertEqual(done.returncode, 1)
                    self.assertNotIn("kerf 0", done.stdout)
                    self.assertIn(f"permissible are {least} to {most} mm/min", done.stderr)
        self.assertIn("permissible are 0.5 to 2 mm", advise("CSP 1N", 2.1, 1800, 4000).stderr)
        self.assertIn("permissible are 1200 to 1800 W", advise("CSP 1N", 2, 1100, 4000).stderr)

    def test_names_the_option_that_is_no_number(self):
        for option, values in (("thickness", ("nan", 1800, 4000)), ("power", (2, "nan", 4000)),
                               ("speed", (2, 1800, "fast"))):
            done = advise("CSP 1N", *values)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"--{option}: `{values[('thickness', 'power', 'speed').index(option)]}` is no number; "
                          "write 0 to ", done.stderr)
            self.assertRegex(done.stderr, " (mm|W|mm/min)\n")

    def test_an_unknown_material_is_told_what_there_is(self):
        done = advise("CSP 2N", 2, 1800, 4000)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no record of `CSP 2N`; there are CSP 1N", done.stderr)

    def test_fits_tables_2_and_3_to_cuts_of_them(self):
        for unit, seconds in (("printed", 1), ("J/mm", 60)):
            cuts = self.write_cuts(cuts_of_the_paper(seconds), f"cuts{seconds}.csv")
            self.base = self.folder / f"kerf{seconds}.db"
            added = kerf("add", cuts, "--db", self.base)
            self.assertEqual(added.returncode, 0, added.stderr)
            self.assertEqual(added.stdout.count("rejected: dross area 0.6 mm2 is above 0.5"), 32)
            done = kerf("fit", "--db", self.base, "--material", "steel", "--unit", unit)
            self.assertEqual(done.returncode, 0, done.stderr)
            for thickness, (slope, intercept) in TABLE_3.items():
                self.assertRegex(done.stdout, rf"{thickness:g} +{slope:g} Q \+ {intercept:.4f} +1\.00")
                for power, (least, most) in TABLE_2[thickness].items():
                    self.assertRegex(done.stdout, rf"{thickness:g} +{power} +{least} +{most} ")
        done = advise("steel", 2, 1800, 4000, "--db", self.folder / "kerf1.db")
        self.assertIn("kerf 0.562745 mm", done.stdout)
        self.assertEqual(advise("steel", 2, 1800, 6000, "--db", self.base).returncode, 1)

    def test_limits_of_acceptance_can_be_set(self):
        cuts = self.write_cuts(cuts_of_the_paper(60))
        done = kerf("add", cuts, "--db", self.base, "--max-dross", "0.6", "--max-straightness",
                    "0.004")
        self.assertIn(" 0 accepted", done.stdout)
        self.assertIn("straightness 0.005 mm is above 0.004 mm", done.stdout)
        self.assertEqual(self.count("cut WHERE rejection <> ''"), self.count("cut"))
        self.assertIn("no cut is accepted",
                      kerf("fit", "--db", self.base, "--material", "steel").stderr)

    def test_adds_nothing_from_a_broken_file(self):
        rows = list(cuts_of_the_paper(60))
        self.assertEqual(kerf("add", self.write_cuts(rows[:5]), "--db", self.base).returncode, 0)
        rows[20][4] = "lots"
        broken = self.write_cuts(rows, "broken.csv")
        done = kerf("add", broken, "--db", self.base)
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"{broken}:22: column power_w: `lots` is not a number", done.stderr)
        self.assertEqual(self.count("cut"), 5)

    def test_adds_no_file_twice(self):
        cuts = self.write_cuts(cuts_of_the_paper(60))
        kerf("add", cuts, "--db", self.base)
        before = self.count("cut")
        done = kerf("add", cuts, "--db", self.base)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has its cuts already", done.stderr)
        self.assertEqual(self.count("cut"), before)

    def test_draws_both_figures(self):
        for figure, labels in ((7, ("1200 W", "1800 W", "5000 mm/min")), (8, ("0.5 mm", "2 mm"))):
            svg, png = self.folder / "f.svg", self.folder / "f.png"
            done = kerf("plot", "--material", "CSP 1N", "--figure", figure, "--svg", svg,
                        "--png", png)
            self.assertEqual(done.returncode, 0, done.stderr)
            texts = [e.text for e in xml.etree.ElementTree.parse(svg).iter() if e.text]
            for label in labels:
                self.assertIn(label, texts)
            self.assertEqual(png.read_bytes()[:4], b"\x89PNG")
        done = kerf("plot", "--material", "CSP 1N", "--thickness", 3, "--svg", svg)
        self.assertEqual(done.returncode, 2)
        self.assertIn("permissible are 0.5 to 2 mm", done.stderr)

    def test_a_coupon_is_cut_measured_and_fitted(self):
        program, form = self.folder / "coupon.nc", self.folder / "form.csv"
        done = kerf("calibrate", "--material", "acrylic", "--thickness", 3, "--full-power", 80,
                    "--out", program, "--form", form)
        self.assertEqual(done.returncode, 0, done.stderr)
        cut = run("sim", program, "--settings", EXAMPLES / "laser.settings", "--json")
        self.assertEqual(cut.returncode, 0, cut.stdout + cut.stderr)
        feeds = re.findall(r"^G1 X105 F(\S+)$", program.read_text(), re.M)
        with form.open(newline="") as stream:
            rows = list(csv.reader(stream))
        self.assertEqual([row[5] for row in rows[1:]], feeds)
        self.assertEqual(len(feeds), 9)
        empty = kerf("calibrate", "--measured", form, "--db", self.base)
        self.assertEqual(empty.returncode, 2)
        self.assertIn(f"{form}:10: no line has a measurement", empty.stderr)
        for row in rows[1:]:
            heat = 60 * float(row[4]) / float(row[5])
            row[6:] = [f"{.25 + .02 * heat:.7f}", f"{.21 + .02 * heat:.7f}", "0.1", "0.004"]
        filled = self.write_cuts(rows[1:])
        done = kerf("calibrate", "--measured", filled, "--db", self.base, "--unit", "J/mm", "--laser", "mine")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"3 +0\.02\d* Q \+ 0\.2300")
        advice = advise("acrylic", 3, 60, 600, "--db", self.base)
        self.assertIn("kerf 0.3500", advice.stdout)
        self.assertNotIn("not calibrated", advice.stdout)

    def filled_form(self, **more):
        """Returns a form of `calibrate` with widths that were measured with a calliper on all
        slots but the last.
        """
        form, laser = self.folder / "form.csv", more.get("laser", ())
        done = kerf("calibrate", "--material", "acrylic", "--thickness", 3, "--full-power", 60, "--powers", "30,45,60",
                    "--speeds", "400,600,800", *laser, "--out", self.folder / "coupon.nc", "--form", form)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = form.read_text().splitlines()
        for i, line in enumerate(lines[1:-1], 1):
            *_, power, speed = line.split(",")[:6]
            width = .2 + 1.2 * float(power) / float(speed)
            lines[i] = line[:-4] + f",{width + .02:.3f},{width - .02:.3f},,"
        form.write_text("\n".join(lines) + "\n")
        return form, done.stderr

    def test_reads_back_the_form_that_it_writes(self):
        form, told = self.filled_form()
        self.assertIn("names no laser; write the name of the laser into the form", told)
        refused = kerf("calibrate", "--measured", form, "--db", self.base, "--unit", "J/mm")
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"{form}:2: column laser is empty; name the laser of these cuts", refused.stderr)
        self.assertFalse(self.base.exists(), "nothing is written")
        done = kerf("calibrate", "--measured", form, "--db", self.base, "--unit", "J/mm", "--laser", "mine")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("8 cuts, 8 accepted, 1 lines without a measurement left out", done.stdout)
        self.assertEqual(self.count("cut"), 8)
        self.assertEqual(advise("acrylic", 3, 30, 600, "--db", self.base).returncode, 0)
        cuts = kerf("show", "--material", "acrylic", "--cuts", "--db", self.base).stdout
        self.assertEqual(len(cuts.splitlines()), 8)

    def test_asks_for_the_laser_where_the_form_names_none(self):
        """The laser is required whether the database contains other lasers or not."""
        named, told = self.filled_form(laser=("--laser", "mine"))
        self.assertEqual(told, "")
        done = kerf("calibrate", "--measured", named, "--db", self.base)
        self.assertEqual(done.returncode, 0, done.stderr)
        form, _ = self.filled_form()
        done = kerf("calibrate", "--measured", form, "--db", self.base)
        self.assertEqual(done.returncode, 2)
        self.assertIn("name the laser of these cuts with --laser NAME", done.stderr)
        self.assertEqual(self.count("cut"), 8, "nothing was added")
        done = kerf("calibrate", "--measured", form, "--db", self.base, "--laser", "other")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.count("cut"), 16)

    def test_cut_compares_the_laser_of_the_record_with_this_machine_s(self):
        named, _ = self.filled_form(laser=("--laser", "mine"))
        self.assertEqual(kerf("calibrate", "--measured", named, "--db", self.base, "--unit", "J/mm").returncode, 0)
        plate = self.folder / "plate.svg"
        plate.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40">'
                         '<rect x="5" y="5" width="30" height="20"/></svg>')
        program, report = self.folder / "out.nc", self.folder / "out.json"
        connection = sqlite3.connect(self.base)
        self.addCleanup(connection.close)
        for laser, options, words in (("mine", ("--laser", "mine"), None),
                                      ("mine", ("--laser", "other"), "is of the laser `mine`, not of `other`"),
                                      ("mine", (), "was measured with the laser `mine`; if this machine has it,"),
                                      ("", ("--laser", "mine"), "measured with a laser that has no name"),
                                      ("", (), "measured with a laser that has no name")):
            with self.subTest(laser=laser, options=options):
                connection.execute("UPDATE record SET laser = ? WHERE provenance LIKE 'fitted%'", (laser,))
                connection.commit()
                done = run("cut", plate, "--material", "acrylic", "--thickness", 3, "--db", self.base, *options,
                           "-o", program, "--report", report)
                self.assertEqual(done.returncode, 0, done.stderr)
                kerf_of = json.loads(report.read_text())["kerf"]
                heading = " ".join(line.strip("()") for line in program.read_text().splitlines() if line[:1] == "(")
                self.assertEqual(kerf_of["measured_on_this_machine"], words is None)
                for text in (done.stderr, heading, " ".join(kerf_of["warnings"])):
                    if words is None:
                        self.assertNotIn("laser", text)
                    else:
                        self.assertIn(words, text)

    def test_a_material_that_is_not_there_names_its_nearest(self):
        for name, nearest in (("CSP 1n", "CSP 1N"), ("acryllic", "acrylic"), ("Acrylic", "acrylic")):
            self.assertIn(f"did you mean {nearest}?", kerf("show", "--material", name).stderr)

    def test_reads_what_spreadsheets_save(self):
        """The files contain semicolons with decimal commas, tabs, empty columns at the end, and
        lines of separators alone.
        """
        good = [["tin", "a laser", "0.1", "1", str(power), str(speed), f"{.4 + power / speed:.3f}", "0.4", "", ""]
                for power in (40, 60) for speed in (400, 500, 600)]
        for number, (separator, mark, tail, head) in enumerate(((";", ",", "", ""), (";", ".", ";;;", "sep=;\n"),
                                                                (",", ".", ",,", ""), ("\t", ",", "\t\t", ""))):
            with self.subTest(separator=separator, tail=tail):
                rows = [separator.join(row).replace(".", mark) + tail for row in good]
                empty = separator * (9 + len(tail))
                file = self.folder / f"sheet{number}.csv"
                file.write_text(head + separator.join(HEADER) + tail + "\r\n" + "\r\n".join([*rows, empty, ""]))
                base = self.folder / f"sheet{number}.db"
                done = kerf("add", file, "--db", base)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("6 cuts, 6 accepted", done.stdout)
                self.assertIn("kerf 0.4500 mm", kerf("show", "--material", "tin", "--cuts", "--db", base).stdout)
        file.write_text(";".join(HEADER) + "\ntin;a;0,1;1;40;400;0,x;0,4;;\n")
        self.assertIn("column kerf_top_mm: `0.x` is not a number", kerf("add", file, "--db", base).stderr)

    def test_dross_and_straightness_are_judged_where_they_are_measured(self):
        good = ["tin", "a", 0.1, 1, 50, 500, .41, .39]
        done = kerf("add", self.write_cuts([[*good, "", ""], [*good, 0.6, ""], [*good, "", 0.02], [*good, 0.1, 0.001]]),
                    "--db", self.base)
        self.assertIn("4 cuts, 2 accepted", done.stdout)
        self.assertIn("dross area 0.6 mm2 is above 0.5", done.stdout)
        self.assertIn("straightness 0.02 mm is above 0.01", done.stdout)

    def test_plots_show_the_interval_of_single_cuts(self):
        for figure, bands in ((7, 9), (8, 4)):
            svg = self.folder / "out.svg"
            done = kerf("plot", "--material", "CSP 1N", "--unit", "J/mm", "--figure", figure, "--svg", svg)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(svg.read_text().count('class="band"'), bands)
            self.assertIn("bands hold 95 % of cuts", svg.read_text())

    def test_a_coupon_asks_for_no_more_than_the_laser_has(self):
        done = kerf("calibrate", "--material", "CSP 1N", "--thickness", 2, "--full-power", 1500,
                    "--out", self.folder / "coupon.nc")
        self.assertEqual(done.returncode, 2)
        self.assertIn("1600 W are more than the laser's 1500 W", done.stderr)

    def test_the_image_is_the_same_as_bytes_and_as_lines(self):
        lines, raw = self.folder / "lines", self.folder / "bytes"
        for extra in ((lines,), (raw, "--bytes")):
            done = kerf("image", "--material", "CSP 1N", "--as", "steel", "--out", *extra)
            self.assertEqual(done.returncode, 0, done.stderr)
        *parts, last = lines.read_text().splitlines()
        self.assertEqual(last, "$KS")
        self.assertTrue(all(len(line) <= 256 for line in parts))
        self.assertEqual([line.split(":")[0] for line in parts],
                         [f"$KW={i}" for i in range(len(parts))])
        data = raw.read_bytes()
        self.assertEqual(bytes.fromhex("".join(line.split(":")[1] for line in parts)), data)
        self.assertEqual(data[:4], b"KFT\x01")
        self.assertEqual(int.from_bytes(data[-4:], "little"), zlib.crc32(data[:-4]))

    def test_the_controller_takes_the_image_and_gives_the_same_kerf(self):
        image, job = self.folder / "image", self.folder / "job.nc"
        kerf("image", "--material", "acrylic", "--out", image)
        for question, status in (("acrylic,3,60,600", 0), ("acrylic,3,60,1081", 1),
                                 ("acryl,3,60,600", 1)):
            job.write_text(image.read_text() + f"$KQ={question}\n")
            done = run("sim", job)
            self.assertEqual(done.returncode, status, done.stdout)
        damaged = image.read_text().replace("61637279", "61637278")
        job.write_text(damaged)
        done = run("sim", job)
        self.assertEqual(done.returncode, 1)
        self.assertIn("CRC-32 is wrong", done.stdout)

    def test_an_image_that_does_not_fit_says_so(self):
        rows = [["steel", "a laser", 0.1, 1 + n / 10, 1000, speed, .5, .4, .1, .005]
                for n in range(9) for speed in (2000, 3000, 4000)]
        kerf("add", self.write_cuts(rows), "--db", self.base)
        self.assertEqual(kerf("fit", "--db", self.base, "--material", "steel").returncode, 0)
        done = kerf("image", "--db", self.base, "--material", "steel", "--out", self.folder / "i")
        self.assertEqual(done.returncode, 2)
        self.assertIn("kerf table has 9 thicknesses, capacity 8", done.stderr)


if __name__ == "__main__":
    KERFLINE, EXAMPLES = sys.argv[1], pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
