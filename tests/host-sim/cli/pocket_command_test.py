#!/usr/bin/env python3
"""kerfline pocket as its users call it: programs that the simulated machine takes, and refusals.

    pocket_command_test.py KERFLINE
"""

import json
import math
import re
import unittest

from pocket_bench import MACHINE, MILL, TRAY, PocketTest, run, svg


class PocketCommand(PocketTest):
    def test_mills_a_tray_round_its_island_to_the_walls(self):
        report = self.folder / "tray.json"
        picture = self.folder / "passes.svg"
        done = self.pocket(TRAY, "--tool", 6, "--depth", 4, "--depth-step", 1.5, *MILL, "--report", report,
                           "--svg", picture, "--spindle", 16000, "--coolant", "mist")
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual(figures["levels"], 3)
        self.assertGreaterEqual(figures["passes"], 2)
        self.assertGreaterEqual(figures["rows"], 3)
        self.assertGreater(figures["pass_length_mm"], 3 * 250)
        self.assertTrue(picture.read_text().startswith("<"))
        text = self.program.read_text()
        for line in ("G21 G90 G17 G94 G54", "S16000 M3", "M7", "M9", "M5", "M2"):
            self.assertIn(line + "\n", text)
        driven = self.simulated()
        # The machine's Y points up, so the limits are 80 - 50 and 80 - 10, less half the tool at
        # each wall.
        for axis, least, greatest in (("X", 13.0, 67.0), ("Y", 33.0, 67.0)):
            low, high = driven["bounds_mm"][axis]
            self.assertAlmostEqual(min(low, least), least if low > 0 else low, 2)
            self.assertAlmostEqual(high, greatest, 2)
        self.assertAlmostEqual(driven["bounds_mm"]["Z"][0], -4.0, 2)
        self.assertAlmostEqual(driven["bounds_mm"]["Z"][1], 5.0, 2)
        self.assertEqual(driven["faults"], [])

    def test_writes_the_same_program_again_to_standard_output(self):
        self.assertEqual(self.pocket(TRAY, "--tool", 6, "--depth", 2, *MILL).returncode, 0)
        again = run("pocket", self.folder / "tray.svg", "--tool", 6, "--depth", 2, *MILL)
        digest = re.compile(r"\(kerfline digest drawing=([0-9a-f]{16}) (.*)\)\n")
        written = self.program.read_text()
        self.assertEqual(digest.sub("", again.stdout), digest.sub("", written))
        self.assertIn("passes in", again.stderr)
        piped = run("pocket", "-", "--tool", 6, "--depth", 2, *MILL, text=TRAY)
        self.assertEqual(piped.stdout.splitlines()[3:], again.stdout.splitlines()[3:])
        # The digest of the drawing is the same; its name is relative to the folder of the program.
        self.assertEqual(digest.search(written)[2], "tray.svg")
        self.assertEqual(digest.search(piped.stdout)[1], digest.search(written)[1])

    def test_tells_that_its_drawing_or_tools_have_changed(self):
        tools = self.folder / "tools.txt"
        tools.write_text("flat6: diameter=6, feed=900, plunge-feed=300\n")
        report = self.folder / "tray.json"
        done = self.pocket(TRAY, "--tools", tools, "--tool", "flat6", "--depth", 2, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([digest["kind"] for digest in json.loads(report.read_text())["digests"]],
                         ["tools", "drawing"])
        self.assertNotIn("changed", run("check", self.program, *MACHINE).stderr)
        tools.write_text("flat6: diameter=5.9, feed=900, plunge-feed=300\n")
        self.drawing(TRAY.replace('r="8"', 'r="9"'))
        told = run("check", self.program, *MACHINE)
        for name in "tray.svg", "tools.txt":
            self.assertRegex(told.stdout + told.stderr, f"{name}.*changed")

    def test_drills_the_holes_that_it_plunges_into(self):
        holes = self.folder / "holes.nc"
        for strategy in "contour", "spiral", "adaptive", "zigzag":
            with self.subTest(strategy=strategy):
                done = self.pocket(TRAY, "--tool", 6, "--depth", 4, "--depth-step", 2, *MILL, "--entry", "plunge",
                                   "--strategy", strategy, "--holes", holes)
                self.assertEqual(done.returncode, 0, done.stderr)
                stock = ("--stock", "5,25,75,75,0,-8", "--tool", 6, "--stock-cell", 0.05)
                alone = self.simulated(*stock)["stock"]["plunges_in_stock"]["count"]
                self.assertGreater(alone, 0)
                milling = self.program.read_text()
                self.program.write_text(holes.read_text())
                drilled = self.simulated(*stock)["stock"]
                self.program.write_text(holes.read_text().replace("M2\n", "") + milling)
                both = self.simulated(*stock)["stock"]
                self.assertEqual(both["plunges_in_stock"]["count"], drilled["plunges_in_stock"]["count"])
                self.assertEqual(both["rapids_in_stock"]["count"], 0, both["rapids_in_stock"])
        done = self.pocket(TRAY, "--tool", 6, "--depth", 2, *MILL, "--holes", holes)
        self.assertEqual(done.returncode, 2)
        self.assertIn("add --entry plunge", done.stderr)

    def test_finishes_floors_and_walls_and_compensates_wear(self):
        for more, code in (((), "G41 D2"), (("--conventional",), "G42 D2")):
            with self.subTest(more=more):
                done = self.pocket(TRAY, "--tool", 6, "--depth", 4, "--depth-step", 2, *MILL, "--finish", 0.3,
                                   "--finish-floor", 0.5, "--wear", 2, *more)
                self.assertEqual(done.returncode, 0, done.stderr)
                text = self.program.read_text()
                self.assertEqual(text.count(code), 6)  # Two walls, two levels and the floor.
                self.assertEqual(text.count("G40"), 6)
                # The tool is 0.1 mm wider and its path is compensated by that. The walls remain
                # where they were drawn.
                self.program.write_text("G10 L1 P2 R0.05\n" + text)
                stock = self.simulated("--stock", "5,25,75,75,0,-8", "--tool", 6.1, "--stock-cell", 0.05)["stock"]
                volume = 4 * (60 * 40 - (4 - math.pi) * 3.05 ** 2 - math.pi * 8 ** 2)
                self.assertLessEqual(stock["removed_mm3"]["least"], volume)
                self.assertGreaterEqual(stock["removed_mm3"]["most"], volume)
                self.assertEqual(stock["rapids_in_stock"]["count"], 0, stock["rapids_in_stock"])
                bounds = self.simulated()["bounds_mm"]
                self.assertAlmostEqual(bounds["X"][1], 66.95, 2)
        for more, words in ((("--wear", 2), "add --finish"), (("--finish", 0.3, "--wear", 13), "1 to 12"),
                            (("--finish-floor", 4), "at most one level, 3 mm")):
            done = self.pocket(TRAY, "--tool", 6, "--depth", 4, *MILL, *more)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(words, done.stderr)

    def test_takes_every_entry_and_both_directions(self):
        for entry in ("helix", "ramp", "plunge"):
            for more in ((), ("--conventional",)):
                with self.subTest(entry=entry, more=more):
                    done = self.pocket(TRAY, "--tool", 6, "--depth", 2, "--entry", entry, *more, *MILL)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertAlmostEqual(self.simulated()["bounds_mm"]["Z"][0], -2.0, 2)

    def test_carves_all_that_the_tool_reaches_and_nothing_else(self):
        # The cleared area is all but the island and the corners of the walls, which have the tool's
        # radius.
        volume = 4 * (60 * 40 - (4 - math.pi) * 3 ** 2 - math.pi * 8 ** 2)
        for more in ((), ("--conventional", "--stepover", 2), ("--entry", "ramp", "--corner", 0),
                     ("--finish", 0.3), ("--finish", 0.3, "--conventional"), ("--strategy", "spiral"),
                     ("--strategy", "spiral", "--conventional", "--finish", 0.2)):
            with self.subTest(more=more):
                done = self.pocket(TRAY, "--tool", 6, "--depth", 4, "--depth-step", 2, *MILL, *more)
                self.assertEqual(done.returncode, 0, done.stderr)
                stock = self.simulated("--stock", "5,25,75,75,0,-8", "--tool", 6, "--stock-cell", 0.05)["stock"]
                self.assertLessEqual(stock["removed_mm3"]["least"], volume)
                self.assertGreaterEqual(stock["removed_mm3"]["most"], volume)
                self.assertLess(stock["removed_mm3"]["most"] - stock["removed_mm3"]["least"], 0.02 * volume)
                self.assertEqual(stock["rapids_in_stock"]["count"], 0, stock["rapids_in_stock"])
                self.assertEqual(stock["plunges_in_stock"]["count"], 0, stock["plunges_in_stock"])

    def test_clears_adaptively_what_contours_clear(self):
        volume = 4 * (60 * 40 - (4 - math.pi) * 3 ** 2 - math.pi * 8 ** 2)
        report = self.folder / "tray.json"
        done = self.pocket(TRAY, "--tool", 6, "--depth", 4, "--depth-step", 2, *MILL, "--strategy", "adaptive",
                           "--engagement", 70, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual((figures["strategy"], figures["levels"], figures["narrow"]), ("adaptive", 2, []))
        stock = self.simulated("--stock", "5,25,75,75,0,-8", "--tool", 6, "--stock-cell", 0.05)["stock"]
        self.assertLessEqual(stock["removed_mm3"]["least"], volume)
        self.assertGreaterEqual(stock["removed_mm3"]["most"], volume)
        self.assertEqual(stock["rapids_in_stock"]["count"], 0, stock["rapids_in_stock"])
        self.assertEqual(stock["plunges_in_stock"]["count"], 0, stock["plunges_in_stock"])
        light = 1200 / math.sin(math.radians(70))
        self.assertIn(f"F{light:.3f}", self.program.read_text())
        self.pocket(TRAY, "--tool", 6, "--depth", 4, *MILL, "--strategy", "adaptive", "--keep-feed")
        self.assertNotRegex(self.program.read_text(), r"F1[3-9]\d\d")

    def test_carves_with_a_v_tool(self):
        report = self.folder / "sign.json"
        picture = self.folder / "sign-path.svg"
        done = self.pocket(svg('<rect x="10" y="10" width="4" height="30"/>',
                               '<rect x="40" y="10" width="20" height="20"/>'),
                           "--v-angle", 90, "--tool", 12, "--depth", 3, *MILL, "--report", report, "--svg", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual(figures["pockets"], 2)
        self.assertAlmostEqual(figures["carved_depth_mm"], 3.0, 6)
        self.assertAlmostEqual(figures["wide_area_mm2"], 14 * 14, 3)
        self.assertIn("196.0 mm2 are too wide for 3 mm", done.stderr)
        self.assertTrue(picture.read_text().startswith("<"))
        stock = self.simulated("--stock", "5,35,65,75,0,-5", "--tool", "12,v,90", "--stock-cell", 0.05)["stock"]
        # A groove like a roof, and the rim of the square, down to a depth of 3 mm and up again.
        groove = 4 * 2 / 2 * 26 + 4 ** 2 * 2 / 3
        rim = 4 * (20 * 3 ** 2 / 2 - 2 * 3 ** 3 / 3) + 4 * (14 * 3 ** 2 / 2 - 2 * 3 ** 3 / 6)
        self.assertLess(stock["removed_mm3"]["least"], groove + rim)
        self.assertGreater(stock["removed_mm3"]["most"], 0.998 * (groove + rim))
        self.assertLess(stock["removed_mm3"]["most"] - stock["removed_mm3"]["least"], 0.06 * (groove + rim))
        # The depth is limited by the width of the tool.
        done = self.pocket(TRAY, "--v-angle", 90, "--tool", 4, "--depth", 30, *MILL)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertAlmostEqual(self.simulated()["bounds_mm"]["Z"][0], -2.0, 3)

    def test_clears_by_lines_what_contours_clear(self):
        volume = 4 * (60 * 40 - (4 - math.pi) * 3 ** 2 - math.pi * 8 ** 2)
        report = self.folder / "tray.json"
        done = self.pocket(TRAY, "--tool", 6, "--depth", 4, "--depth-step", 2, *MILL, "--strategy", "zigzag",
                           "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"\d+ lines in 2 levels")
        figures = json.loads(report.read_text())
        self.assertEqual(figures["strategy"], "zigzag")
        stock = self.simulated("--stock", "5,25,75,75,0,-8", "--tool", 6, "--stock-cell", 0.05)["stock"]
        self.assertLessEqual(stock["removed_mm3"]["least"], volume)
        self.assertGreaterEqual(stock["removed_mm3"]["most"], volume)
        self.assertEqual(stock["rapids_in_stock"]["count"], 0, stock["rapids_in_stock"])
        self.assertEqual(stock["plunges_in_stock"]["count"], 0, stock["plunges_in_stock"])

    def test_keeps_to_the_paper_where_asked(self):
        bulge = -math.tan(0.5 * math.asin(0.5 * math.hypot(40, 90) / 100))
        wall = f"10 10\n130 10\n130 110 {bulge:.17g}\n90 200\n10 110\nclosed\n"
        report = self.folder / "paper.json"
        done = run("pocket", "-", "--tool", 10, "--depth", 4, "--depth-step", 2, *MILL, "--strategy", "paper",
                   "-o", self.program, "--report", report, text=wall)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual((figures["passes"], figures["levels"], figures["rows"]), (8, 2, 2))
        self.assertAlmostEqual(figures["pass_length_mm"] / 2, 2146.1, 1)
        done = self.pocket(TRAY, "--tool", 6, "--depth", 2, *MILL, "--strategy", "paper")
        self.assertEqual(done.returncode, 1)
        self.assertIn("supports no islands", done.stderr)

    def test_refuses_options_of_another_strategy(self):
        for more, words in ((("--v-angle", 60, "--stepover", 2), "--stepover: cannot be used with --v-angle"),
                            (("--v-angle", 60, "--strategy", "adaptive"), "--strategy: cannot be used with --v-angle"),
                            (("--strategy", "adaptive", "--corner", 1), "--corner: cannot be used with"),
                            (("--strategy", "adaptive", "--engagement", 170), "10 to 150 degrees"),
                            (("--v-angle", 180), "1 to 175 degrees"),
                            (("--strategy", "zigzag", "--conventional"), "lines run in both directions"),
                            (("--strategy", "zigzag", "--stepover", 7), "leave stock between"),
                            (("--strategy", "paper", "--corner", 0), "that strategy follows the paper exactly"),
                            (("--strategy", "helical"), "helical"),
                            (("--strategy", "spiral", "--stepover", 2.8), "at most 2.7 mm apart"),
                            (("--rest-of", 6), "larger than --tool 6 mm"),
                            (("--rest-of", 8, "--finish", 0.2), "--finish: cannot be used with --rest-of"),
                            (("--rest-of", 8, "--strategy", "zigzag"), "by --strategy contour"),
                            (("--rest-of", 8, "--v-angle", 60), "--rest-of: cannot be used with --v-angle"),
                            (("--finish", 3.1), "at most half the tool, 3 mm"),
                            (("--engagement", 60), "add --strategy adaptive")):
            with self.subTest(more=more):
                done = self.pocket(TRAY, "--tool", 6, "--depth", 2, *MILL, *more)
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(words, done.stderr)
                self.assertFalse(self.program.exists())

    def test_mills_in_spirals(self):
        report = self.folder / "spiral.json"
        done = self.pocket(svg('<rect x="10" y="10" width="60" height="40"/>'), "--tool", 6, "--depth", 3,
                           "--depth-step", 1.5, *MILL, "--strategy", "spiral", "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual((figures["strategy"], figures["levels"], figures["rows"]), ("spiral", 2, 2))

    def test_takes_feeds_from_a_file_of_tools(self):
        tools = self.folder / "tools.txt"
        tools.write_text("flat6: diameter=6, flutes=2, feed-per-tooth=0.04, spindle=15000, plunge-feed=350\n"
                         "bare: diameter=6, flutes=2, feed-per-tooth=0.04, plunge-feed=350\n"
                         "v60: diameter=10, angle=60, feed=800, plunge-feed=200\n")
        of_file = ("--tools", tools, "--depth", 2)
        done = self.pocket(TRAY, "--tool", "flat6", *of_file)
        self.assertEqual(done.returncode, 0, done.stderr)
        program = self.program.read_text()
        self.assertIn("F1200\n", program)
        self.assertIn("S15000 M3\n", program)
        done = self.pocket(TRAY, "--tool", "flat6", *of_file, "--spindle", 10000, "--plunge-feed", 100)
        self.assertEqual(done.returncode, 0, done.stderr)
        program = self.program.read_text()
        self.assertIn("F800\n", program)
        self.assertNotIn("F1200", program)
        done = self.pocket(TRAY, "--tool", "v60", *of_file)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("V tool 10 mm of 60 degrees", self.program.read_text())
        self.program.unlink()
        for more, words in ((("--tool", "flat7", *of_file), "has no tool flat7; there are flat6, bare, v60"),
                            (("--tool", "bare", *of_file), "has a feed per tooth and no spindle"),
                            (("--tool", "v60", *of_file, "--v-angle", 90), "has 60 degrees"),
                            (("--tool", "flat6", "--depth", 2), "a name requires --tools"),
                            (("--tool", 6, *of_file), "--feed is required")):
            with self.subTest(more=more):
                done = self.pocket(TRAY, *more)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn(words, done.stderr)
                self.assertFalse(self.program.exists())

    def test_mills_only_the_rest_of_a_larger_tool(self):
        report = self.folder / "rest.json"
        done = self.pocket(TRAY, "--tool", 3, "--rest-of", 8, "--depth", 4, "--depth-step", 2, *MILL,
                           "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual((figures["rest_of_mm"], figures["levels"]), (8, 2))
        self.assertEqual(figures["rows"], 2 * figures["passes"])
        self.assertLess(figures["pass_length_mm"], 300)
        bounds = self.simulated()["bounds_mm"]
        self.assertAlmostEqual(bounds["X"][1], 68.5, 2)
        self.assertAlmostEqual(bounds["Y"][1], 68.5, 2)
        self.assertAlmostEqual(bounds["Z"][0], -4, 2)
        done = self.pocket(svg('<circle cx="40" cy="30" r="15"/>'), "--tool", 3, "--rest-of", 8, "--depth", 4, *MILL)
        self.assertEqual(done.returncode, 1)
        self.assertIn("a tool of 8 mm has left no stock", done.stderr)

    def test_takes_pockets_in_a_short_order(self):
        holes = [f'<circle cx="{10 + 9 * (7 * k % 10)}" cy="20" r="4"/>' for k in range(10)]
        report = self.folder / "holes.json"
        done = self.pocket(svg(*holes), "--tool", 6, "--depth", 4, "--depth-step", 2, *MILL, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual((figures["pockets"], figures["rows"]), (10, 20))
        self.assertLess(figures["rapid_length_mm"], 120)

    def test_refuses_a_drawing_with_faults_and_writes_nothing(self):
        open_wall = svg('<path d="M 10 10 H 60 V 50 H 20"/>')
        crossing = svg('<rect x="10" y="10" width="40" height="30"/>', '<circle cx="50" cy="30" r="8"/>')
        for text, words in ((open_wall, "open"), (crossing, "cross"), (svg(), "no contour")):
            with self.subTest(words=words):
                done = self.pocket(text, "--tool", 6, "--depth", 2, *MILL)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(words, done.stderr)
                self.assertFalse(self.program.exists())

    def test_refuses_numbers_out_of_range_with_their_range(self):
        good = {"--tool": 6, "--depth": 2, "--feed": 1200, "--plunge-feed": 300}
        for option, value, words in (("--tool", 0, "0.01 to 500 mm"), ("--depth", 0, "0.001 to 1000 mm"),
                                     ("--depth", -2, "0.001 to 1000 mm"), ("--feed", 0, "mm/min"),
                                     ("--stepover", 0, "mm"), ("--slope", 50, "0.1 to 45 degrees"),
                                     ("--safe", 0, "mm"), ("--tool", None, "--tool"),
                                     ("--depth", None, "--depth"), ("--feed", None, "--feed"),
                                     ("--plunge-feed", None, "--plunge-feed")):
            call = good | {option: value}
            words_of_call = [word for pair in call.items() if pair[1] is not None for word in pair]
            with self.subTest(option=option, value=value):
                done = self.pocket(TRAY, *words_of_call)
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(words, done.stderr)
                self.assertFalse(self.program.exists())


if __name__ == "__main__":
    unittest.main()
