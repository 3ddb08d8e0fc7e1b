#!/usr/bin/env python3
"""Output of `kerfline cut` about a job: animation, job sheet, times and prices.

    cut_output_test.py KERFLINE
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

KERFLINE = ""
SHEET = """<svg xmlns="http://www.w3.org/2000/svg" width="160mm" height="90mm" viewBox="0 0 160 90">
<rect id="a" x="10" y="10" width="40" height="30"/><circle cx="30" cy="25" r="6"/>
<rect id="b" x="60" y="10" width="40" height="30"/><circle cx="80" cy="25" r="6"/>
<circle id="disc" cx="30" cy="65" r="14"/><path id="line" d="M70 60H110" stroke="red"/>
</svg>
"""
STEEL = ("--material", "CSP 1N", "--thickness", "2", "--layer", "red: side=on", "--pierce", "0.2")
SVG = "{http://www.w3.org/2000/svg}"


class CutOutput(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.sheet = self.folder / "bl\u00e4tter & co.svg"
        self.sheet.write_text(SHEET)

    def cut(self, *more, status=0):
        done = subprocess.run([KERFLINE, "cut", self.sheet, *STEEL, "-o", self.folder / "out.nc",
                               "--report", self.folder / "out.json", *map(str, more)],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def report(self, *more):
        self.cut(*more)
        return json.loads((self.folder / "out.json").read_text())

    def test_times_add_up_and_are_near_the_simulated_job(self):
        report = self.report()
        time = report["time"]
        kinds = {key: value for key, value in time.items() if key not in ("total_s", "predicted_s")}
        self.assertAlmostEqual(sum(kinds.values()), report["job_time_s"], 3)
        self.assertAlmostEqual(time["total_s"], report["job_time_s"], 3)
        self.assertLess(abs(time["predicted_s"] / time["total_s"] - 1), 0.02)
        self.assertAlmostEqual(kinds["pierce_s"], 5 * 0.2, delta=0.1)
        self.assertEqual({row["colour"]: row["cuts"] for row in report["cuts_by_layer"]}, {"black": 5, "red": 1})
        self.assertNotIn("cost", report)

    def test_parts_have_their_share_of_time_and_money(self):
        report = self.report("--rate", 60, "--sheet-cost", 10, "--currency", "\u20ac")
        parts = {part["name"]: part for part in report["parts"]}
        self.assertEqual(sorted(part["copies"] for part in parts.values()), [1, 1, 2])
        pair = next(part for part in parts.values() if part["copies"] == 2)
        self.assertEqual((pair["pierces"], round(pair["area_mm2"])), (4, 2174))
        self.assertAlmostEqual(pair["cost"], 2 * pair["cost_each"], 4)
        self.assertAlmostEqual(sum(part["time_s"] for part in parts.values()), report["job_time_s"], 3)
        self.assertAlmostEqual(report["cost"]["total"], report["job_time_s"] / 60 + 10, 3)
        self.assertAlmostEqual(sum(part["cost"] for part in parts.values()), report["cost"]["total"], 3)
        told = self.cut("--rate", 60, "--currency", "\u20ac").stdout
        self.assertIn("\u20ac each", told)
        self.assertIn("2 parts like rect", told)

    def test_prices_that_mean_nothing_are_refused(self):
        for option, value in (("--rate", "-1"), ("--rate", "nan"), ("--sheet-cost", "1e99"), ("--sheet-cost", "x"),
                              ("--currency", ""), ("--currency", "a\nb"), ("--currency", 40 * "E"),
                              ("--animation-time", "0"), ("--animation-time", "inf")):
            with self.subTest(option, value=value):
                self.assertIn(option, self.cut(option, value, status=2).stderr)
                self.assertFalse((self.folder / "out.nc").exists())

    def test_the_animation_is_well_formed_and_goes_forward(self):
        name = self.folder / "job.svg"
        job_time = self.report("--animation", name, "--animation-time", 5)["job_time_s"]
        root = xml.etree.ElementTree.parse(name).getroot()
        self.assertEqual([node for node in root.iter() if node.tag.endswith("script")], [])
        moves = [*root.iter(SVG + "animate"), *root.iter(SVG + "animateTransform")]
        self.assertGreater(len(moves), 6)
        for move in moves:
            times = [float(time) for time in move.get("keyTimes").split(";")]
            self.assertEqual(len(times), len(move.get("values").split(";")))
            self.assertEqual((times[0], times[-1], times), (0.0, 1.0, sorted(times)))
            self.assertEqual(move.get("dur"), f"{min(job_time, 5):.3f}s")

    def test_a_job_of_many_hours_is_not_simulated_but_checked(self):
        slow = ("--cool", 3600, "--cool-distance", 1000)
        report = self.report(*slow)
        self.assertEqual("predicted", report["job_time_is"])
        self.assertAlmostEqual(report["job_time_s"], report["order"]["predicted_job_time_s"], 6)
        self.assertGreater(report["job_time_s"], 3 * 3600)
        program = (self.folder / "out.nc").read_text()
        self.assertIn("predicted", program.split("rapid;")[1][:60])
        self.assertLess(max(map(len, program.splitlines())), 80)
        done = self.cut(*slow, "--set", "$20=1", "--set", "$130=90", status=1)
        self.assertRegex(done.stderr, r"out\.nc:\d+:\d+: X needs")
        self.assertEqual("simulated", self.report()["job_time_is"])

    def test_the_report_says_what_starts_between_the_listed_ones_save(self):
        for cost, figure in (("length", "rapid_length_mm"), ("time", "rapid_time_s")):
            order = self.report("--cost", cost)["order"]
            self.assertLess(order[figure], order["with_listed_starts"][figure])
            self.assertLess(order["with_listed_starts"][figure], order["nearest_with_usual_starts"][figure])

    def test_the_job_sheet_is_the_same_each_time(self):
        names = [self.folder / f"{i}.pdf" for i in range(2)]
        for name in names:
            self.cut("--job-sheet", name, "--rate", 60)
        first, second = (name.read_bytes() for name in names)
        self.assertTrue(first.startswith(b"%PDF"))
        self.assertEqual(first, second)
        self.assertNotIn(b"CreationDate", first)

    def test_the_png_is_one(self):
        name = self.folder / "job.png"
        self.cut("--png", name)
        self.assertTrue(name.read_bytes().startswith(b"\x89PNG"))

    def test_the_program_plays(self):
        self.cut()
        done = subprocess.run([KERFLINE, "sim", self.folder / "out.nc", "--set", "$32=1"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    KERFLINE = sys.argv[1]
    unittest.main(argv=sys.argv[:1])
