#!/usr/bin/env python3
"""Programs for other controllers: kerfline cut, pocket and surface with --post.

    post_test.py KERFLINE EXAMPLES
"""

import json
import math
import pathlib
import sys
import unittest

EXAMPLES = pathlib.Path(sys.argv.pop(2))

from pocket_bench import MACHINE, MILL, TRAY, PocketTest, run  # noqa: E402

LASER = ("--material", "CSP 1N", "--thickness", "2")
POSTS = sorted((EXAMPLES / "post").glob("*.post"))


def scan():
    rows = ("\n".join(f"{0.5 * i} {0.5 * row} {math.sin(0.4 * i) * math.cos(0.3 * row) - 3:.4f}" for i in range(25))
            for row in range(17))
    return "\n\n".join(rows) + "\n"


class Posts(PocketTest):
    def made(self, command, *more):
        """Returns the text of the program that a command writes."""
        if command == "surface":
            (self.folder / "scan.xyz").write_text(scan())
            call = ("surface", self.folder / "scan.xyz", "--tool", "ball:3", "--step", 1, *MILL)
        elif command == "pocket":
            call = ("pocket", self.drawing(TRAY), "--tool", 6, "--depth", 2, *MILL)
        else:
            call = ("cut", self.drawing(TRAY), *LASER)
        done = run(*call, "-o", self.program, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.program.read_bytes().decode()

    def trace(self, *settings):
        trace = self.folder / "trace.csv"
        done = run("sim", self.program, *settings, "--trace", trace)
        self.assertEqual(done.returncode, 0, done.stderr)
        return trace.read_text().split("time_ns", 1)[1]

    def test_the_posted_program_of_linuxcnc_has_its_form(self):
        text = self.made("surface", "--post", EXAMPLES / "post/linuxcnc.post", "--spindle", 9000)
        lines = text.splitlines()
        self.assertEqual(lines[:3], ["%", "G17 G21 G40 G49 G80 G90 G94", "G64 P0.01 Q0.01"])
        self.assertRegex(lines[3], r"^\(kerfline .* surface: scan.xyz\)$")
        self.assertEqual(lines[-3:], ["M5", "M2", "%"])
        self.assertIn("M3 S9000", lines)
        self.assertIn("G18", lines)
        arcs = [line for line in lines if line.startswith(("G2 ", "G3 "))]
        self.assertGreater(len(arcs), 17)
        for arc in arcs:
            self.assertRegex(arc, r"^G[23]( [XYZ]-?\d+(\.\d+)?)+ [IJK]-?[\d.]+ [IJK]-?[\d.]+( F[\d.]+)?$")
        self.assertRegex(text, r"\(kerfline digest post=[0-9a-f]{16} .*linuxcnc.post\)")

    def test_posted_programs_are_driven_as_the_plain_ones(self):
        """If the post changes only the text, the steps are equal."""
        post = self.folder / "text.post"
        post.write_text("[format]\nblanks = yes\nrepeat = all\nline-numbers = 1 1\npoints = yes\n"
                        "comments = semicolon\nline-end = crlf\n[header]\n%\n[footer]\n%\n")
        for command, machine in (("surface", MACHINE), ("pocket", MACHINE), ("cut", ("--set", "$32=1"))):
            with self.subTest(command=command):
                self.made(command)
                plain = self.trace(*machine)
                self.assertIn("N7 ", self.made(command, "--post", post))
                self.assertEqual(self.trace(*machine), plain)

    def test_examples_are_read_as_nearly_the_same_motion(self):
        self.assertGreaterEqual(len(POSTS), 3)
        report = self.folder / "report.json"

        def bounds():
            done = run("sim", self.program, *MACHINE, "--set", "$20=0", "--report", report)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            figures = json.loads(report.read_text())
            return [*figures["bounds_mm"]["X"], *figures["bounds_mm"]["Y"], figures["bounds_mm"]["Z"][0]]

        for command in ("surface", "pocket"):
            self.made(command)
            plain = bounds()
            for post in POSTS:
                with self.subTest(command=command, post=post.name):
                    text = self.made(command, "--post", post)
                    # The simulated machine has no reference point to return to.
                    self.program.write_text(text.replace("G91 G28 Z0", "G0 Z5"))
                    for found, wanted in zip(bounds(), plain):
                        self.assertAlmostEqual(found, wanted, delta=0.03)

    def test_a_control_of_g17_gets_lines_that_never_cut_in(self):
        text = self.made("surface", "--post", EXAMPLES / "post/g17-only.post")
        self.assertNotIn("G18", text)
        self.assertNotIn("G19", text)
        self.assertFalse([line for line in text.splitlines() if " G2 " in line or " G3 " in line])
        plain = self.made("surface", "--lines", "--decimals", 3)
        motions = [line for line in plain.splitlines() if "X" in line or "Z" in line]
        posted = [line for line in text.splitlines() if line[0] == "N" and (" X" in line or " Z" in line)]
        self.assertEqual(len(motions), len(posted))
        self.assertTrue(text.startswith("%\r\nO0001\r\n; kerfline"))
        self.assertTrue(text.endswith("G91 G28 Z0\r\nM30\r\n%\r\n"))
        for line in posted:
            for word in line.split()[2:]:
                if word[0] in "XYZ":
                    self.assertRegex(word, r"^[XYZ]-?\d+\.\d{0,3}$")

    def test_decimals_are_those_of_the_post(self):
        post = self.folder / "three.post"
        post.write_text("[format]\ndecimals = 3\n")
        self.assertRegex(self.made("pocket", "--post", post), r"X\d+\.\d{3}\b")
        self.assertNotRegex(self.program.read_text(), r"[XYZ]-?\d+\.\d{4}")
        done = run("pocket", self.drawing(TRAY), "--tool", 6, "--depth", 2, *MILL, "--post", post, "--decimals", 4)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--decimals 4: the post", done.stderr)

    def test_frames_and_holes_are_posted_too(self):
        frame = self.folder / "frame.nc"
        post = EXAMPLES / "post/linuxcnc.post"
        self.made("cut", "--post", post, "--frame", frame)
        self.assertTrue(frame.read_text().startswith("%\nG17 "))
        holes = self.folder / "holes.nc"
        self.made("pocket", "--post", post, "--entry", "plunge", "--holes", holes)
        self.assertTrue(holes.read_text().startswith("%\nG17 "))

    def test_a_changed_post_is_told(self):
        post = self.folder / "my.post"
        post.write_text("[format]\nblanks = yes\n")
        self.made("pocket", "--post", post)
        self.assertNotIn("has changed", run("check", self.program, *MACHINE).stderr)
        post.write_text("[format]\nblanks = no\n")
        checked = run("check", self.program, *MACHINE)
        self.assertIn("the post my.post has changed", checked.stderr + checked.stdout)

    def test_bad_posts_are_refused_and_nothing_is_written(self):
        post = self.folder / "bad.post"
        post.write_text("[format]\nblanks = maybe\n")
        for command in ("cut", "pocket", "surface"):
            with self.subTest(command=command):
                with self.assertRaises(AssertionError) as refused:
                    self.made(command, "--post", post)
                self.assertIn("bad.post:2: blanks = maybe: must be one of yes, no", str(refused.exception))
                self.assertFalse(self.program.exists())


if __name__ == "__main__":
    unittest.main()
