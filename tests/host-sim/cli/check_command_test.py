#!/usr/bin/env python3
"""`kerfline check` as its users call it: its reports about programs.

    check_command_test.py KERFLINE EXAMPLES
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from sanitized import is_sanitized  # noqa: E402

KERFLINE = ""
# Leaks of the libraries behind --png; only a sanitized build reads this file.
SUPPRESSIONS = pathlib.Path(__file__).with_name("leaks.supp")
EXAMPLES = pathlib.Path()


def run(*arguments, text=None, **environment):
    return subprocess.run(
        [KERFLINE, *map(str, arguments)], input=text, capture_output=True, text=True, check=False,
        env={"PATH": "/usr/bin", "LSAN_OPTIONS": f"suppressions={SUPPRESSIONS}", **environment})


class Check(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.laser = ("--settings", EXAMPLES / "laser.settings")

    def test_check_names_the_place_of_every_fault(self):
        job = self.folder / "bad.nc"
        job.write_text("G21\nG1 X1 F100\nG6 X2\nG2 X1 Y1 I0.1 J0\n")
        done = run("check", job)
        self.assertEqual(done.returncode, 1)
        lines = [line for line in done.stdout.splitlines() if line.startswith(str(job))]
        self.assertRegex(lines[0], r":3:1: ")
        self.assertRegex(lines[1], r":4:\d+: ")

    def test_check_takes_the_simulated_time(self):
        job = EXAMPLES / "circle_r20.nc"
        simulated = json.loads(run("sim", job, *self.laser, "--json").stdout)
        checked, = json.loads(run("check", job, *self.laser, "--json").stdout)
        self.assertAlmostEqual(checked["job_time_s"] / simulated["job_time_s"], 1.0, delta=0.01)

    def test_check_finds_what_needs_more_travel_than_there_is(self):
        done = run("check", "-", "--set", "$130=50", text="G21 G90\nG0 X40\nG0 Y5 X60\n")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"-:3:7: X needs 60\.000 mm of travel, \$130 allows 50")

    def test_check_needs_no_memory_for_lines_that_it_has_read(self):
        """A line of the file has 24 bytes. Besides the text, 20 bytes per line are allowed: 10^7
        lines in 1 GB. The release build is measured, because a sanitizer keeps freed memory.
        """
        if is_sanitized(KERFLINE):
            return
        peaks = []
        for lines in (20_000, 220_000):
            job = self.folder / "long.nc"
            with job.open("w") as file:
                file.write("G21 G91\nM4 S500\n")
                for i in range(lines // 2):
                    file.write(f"G1 X0.100 Y0.0{i % 10} F1000\nG1 X-0.100 Y-0.0{i % 10}\n")
            words = [KERFLINE, "check", str(job), "--set", "$110=30000"]
            process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0)
            peaks.append((usage.ru_maxrss * 1024, job.stat().st_size))
        (small, small_file), (great, great_file) = peaks
        beside_text = (great - small - 2 * (great_file - small_file)) / 200_000
        print(f"check: {(great - small) / 200_000:.1f} bytes a line, {beside_text:.1f} beside text", file=sys.stderr)
        self.assertLess((great - small) / 200_000, 100.0)
        self.assertLess(beside_text, 20.0)

    def test_a_file_that_is_missing_costs_the_others_nothing(self):
        good, missing = EXAMPLES / "circle_r20.nc", self.folder / "missing.nc"
        blank, seven = self.folder / "blank.nc", self.folder / "seven.nc"
        blank.write_text("\n\r\n  \n")
        seven.write_bytes(b"\0" * 7)
        mark = self.folder / "mark.nc"
        mark.write_bytes(b"\xef\xbb\xbf\n")
        for command in ("check", "sim"):
            with self.subTest(command=command):
                done = run(command, good, missing, blank, good, seven, mark)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(done.stdout.count("circle_r20.nc"), 2, done.stdout)
                self.assertEqual(len(done.stderr.splitlines()), 4, done.stderr)
                for name in (missing, blank, seven, mark):
                    self.assertIn(str(name), done.stderr)
                done = run(command, good, missing, "--json")
                self.assertEqual(done.returncode, 2)
                reports = json.loads(done.stdout)
                self.assertEqual((reports[0] if command == "check" else reports)["job"], "circle_r20.nc")
        for name in (blank, seven, mark):
            done = run("check", name)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(f"{name}: has nothing but blanks; it has no program", done.stderr)

    def test_programs_that_go_on_behind_their_end_are_named(self):
        for text, told in (("%\nG21\nG1 X5 F100\n%\n", None), ("G21\nG1 X1 F100\nM30\n%\n", None),
                           ("%\nO1000\nG21\nG1 X5 F100\n%\n\n(more)\nG1 X9\n",
                            "-:8: the program continues after the % of line 5"),
                           ("O1000\nG21\nG1 X5 F100\nO2000\nG1 X9\n", "-:4: a second program begins here, after"),
                           ("%one\nG21\nG1 X5 F100\n%two\nG1 X9\n", "-:5: the program continues after the % of line 4"),
                           ("G21\nG1 X1 F100\nM30\nG1 X9\n", "-:4: the program ended in line 3")):
            with self.subTest(text=text):
                done = run("check", "-", text=text)
                self.assertEqual(done.returncode, 0, done.stdout)
                if told:
                    self.assertIn(told, done.stdout)
                else:
                    self.assertNotIn("warning", done.stdout)
        self.assertIn("M99 is not supported", run("check", "-", text="G21\nM99\n").stdout)

    def test_block_delete_of_the_program_itself(self):
        """The setting is changed while the machine rests: a controller accepts no setting in motion."""
        for first, told, bounds in (("", "skipped ($890, $B)", "no motion"),
                                    ("$890=0\n", "driven ($890=0)", "to 5.000"),
                                    ("$B\n", "driven ($890=0)", "to 5.000"), ("$890=1\n", "skipped", "no motion"),
                                    ("$890=0\n$b\n", "skipped ($890, $B)", "no motion")):
            with self.subTest(first=first):
                done = run("check", "-", text=f"{first}G21 G90\n/G1 X5 F100\nN3 /G1 X1\n")
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertIn(f"lines that begin with / are {told}", done.stdout)
                self.assertIn("; 2 times in all", done.stdout)
                self.assertIn(bounds, done.stdout)

    def test_feeds_are_named_as_the_program_has_them(self):
        for text, told in (("G21\nG1 X1 F9999999\n", "-:2: F9999999 is above $110="),
                           ("G20\nG1 X1 F9000\n", "-:2: F9000 requires 228600 mm/min here, above $110="),
                           ("G21 G93\nG1 X50 F6000\n", "-:2: F6000 requires 300000 mm/min here, above $110="),
                           ("G21\nF12345678.5\nG1 X1\n", "-:3: F12345678.5 is above"),
                           ("G21\nG1 A9 F99999\n", "the rate of A: driven"),
                           ("G21\nM4 S1000000\nG1 X1 F100\n", "-:2: S1000000 is above $30=1000 ")):
            with self.subTest(text=text):
                self.assertIn(told, run("check", "-", text=text).stdout)

    def test_degrees_are_not_called_millimetres(self):
        turn = "G21 G91\nG1 A90 F1000\n"
        done = run("check", "-", text=turn)
        self.assertIn("bounds in degrees:  A 0.000 to 90.000", done.stdout)
        self.assertRegex(done.stdout.splitlines()[0], r", 0\.0 mm, 0\.0 mm of it cut, 90\.0 degrees turned$")
        both = run("check", "-", text="G21 G91\nG1 X3 Y4 A90 F1000\nG1 A-10\n").stdout.splitlines()[0]
        self.assertRegex(both, r", 5\.0 mm, 0\.0 mm of it cut, 10\.0 degrees turned$")
        self.assertNotIn("bounds in mm", done.stdout)
        report, = json.loads(run("check", "-", "--json", text=turn).stdout)
        self.assertEqual(report["bounds_deg"]["A"], [0.0, 90.0])
        done = run("check", "-", "--set", "$133=50", text=turn)
        self.assertIn("A needs 90.000 degrees of travel, $133 allows 50", done.stdout)

    def test_numbers_are_rounded(self):
        done = run("sim", EXAMPLES / "circle_r20.nc", *self.laser, "--json")
        self.assertEqual(re.findall(r"\d\.\d{7,}", done.stdout), [])


if __name__ == "__main__":
    KERFLINE, EXAMPLES = sys.argv[1], pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
