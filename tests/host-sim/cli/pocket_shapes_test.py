#!/usr/bin/env python3
"""kerfline pocket with various shapes: slots, islands, separate depths and open sides.

    pocket_shapes_test.py KERFLINE
"""

import json
import math
import pathlib
import struct
import unittest

from pocket_bench import MILL, TRAY, PocketTest, svg

OPEN_BOX = "0,0,100,80"  # A stock that pockets reach across the edge of, in plan.


def heights(ply):
    """Returns {(x, y): greatest z} of the points of a carved stock, rounded to mm in the plane."""
    head, body = pathlib.Path(ply).read_bytes().split(b"end_header\n", 1)
    count = int(next(line for line in head.split(b"\n") if line.startswith(b"element vertex")).split()[2])
    found = {}
    for x, y, z in struct.iter_unpack("<fff", body[:12 * count]):
        place = (round(x), round(y))
        found[place] = max(z, found.get(place, -1e9))
    return found


class PocketShapes(PocketTest):
    def test_lists_what_is_too_narrow_for_the_engagement(self):
        rooms = svg('<path d="M10 10 H40 V26 H50 V10 H80 V50 H50 V33 H40 V50 H10 Z"/>')
        report = self.folder / "rooms.json"
        done = self.pocket(rooms, "--tool", 6, "--depth", 2, *MILL, "--strategy", "adaptive", "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        narrow = json.loads(report.read_text())["narrow"]
        self.assertEqual(len(narrow), 1, narrow)
        self.assertAlmostEqual(narrow[0]["width_mm"], 7.0, 3)
        self.assertIn("1 narrow stretches", done.stdout)

    def test_mills_a_slot_drawn_as_wide_as_the_tool(self):
        for strategy in "contour", "spiral", "adaptive", "zigzag":
            for slot in ('<rect x="10" y="10" width="60" height="6"/>',
                         '<path d="M13 10h54a3 3 0 0 1 0 6h-54a3 3 0 0 1 0-6z"/>'):
                with self.subTest(strategy=strategy, slot=slot):
                    done = self.pocket(svg(slot), "--tool", 6, "--depth", 2, *MILL, "--strategy", strategy)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    bounds = self.simulated()["bounds_mm"]
                    self.assertAlmostEqual(bounds["X"][1], 67.0, 2)
                    self.assertAlmostEqual(bounds["Y"][1], 67.0, 2)

    def test_mills_a_hole_as_wide_as_the_tool_only_where_it_may_plunge(self):
        hole = svg('<circle cx="20" cy="20" r="3"/>')
        for strategy in "contour", "spiral", "adaptive", "zigzag":
            with self.subTest(strategy=strategy):
                done = self.pocket(hole, "--tool", 6, "--depth", 2, *MILL, "--strategy", strategy)
                self.assertEqual(done.returncode, 1)
                self.assertIn("--entry plunge", done.stderr)
                self.assertFalse(self.program.exists())
                done = self.pocket(hole, "--tool", 6, "--depth", 2, *MILL, "--strategy", strategy, "--entry", "plunge")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.program.unlink()

    def test_mills_a_pocket_in_a_pocket_and_a_boss_each_to_its_depth(self):
        steps = svg('<rect x="10" y="10" width="60" height="50" stroke="black"/>',
                    '<rect x="20" y="20" width="20" height="30" stroke="red"/>',
                    '<circle cx="55" cy="35" r="8" stroke="#00f"/>',
                    '<rect x="78" y="10" width="13" height="15" stroke="red"/>')
        report = self.folder / "steps.json"
        done = self.pocket(steps, "--tool", 6, "--depth", 4, "--depth-of", "red=6.5", "--depth-of", "#00f=1.5",
                           "--depth-step", 3, *MILL, "--report", report)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(report.read_text())
        self.assertEqual(figures["floors_mm"], [1.5, 4, 6.5])
        self.assertEqual((figures["levels"], figures["pockets"]), (3, 4))
        ply = self.folder / "stock.ply"
        stock = self.simulated("--stock", "0,0,100,80,0,-10", "--tool", 6, "--stock-cell", 0.25,
                               "--stock-ply", ply)["stock"]
        self.assertEqual(stock["rapids_in_stock"]["count"], 0)
        self.assertEqual(stock["plunges_in_stock"]["count"], 0)
        height = heights(ply)
        # Y of the drawing points down.
        for place, z in (((5, 40), 0), ((15, 40), -4), ((30, 45), -6.5), ((55, 45), -1.5), ((87, 60), -6.5)):
            self.assertAlmostEqual(height[place], z, delta=0.01, msg=place)

    def test_mills_a_pocket_in_an_island_around_the_same_middle(self):
        target = svg('<rect x="10" y="10" width="60" height="50"/>', '<circle cx="40" cy="35" r="15"/>',
                     '<circle cx="40" cy="35" r="8"/>')
        volume = 2 * (60 * 50 - (4 - math.pi) * 9 - math.pi * 15 ** 2 + math.pi * 8 ** 2)
        for strategy in "contour", "spiral", "adaptive", "zigzag":
            with self.subTest(strategy=strategy):
                done = self.pocket(target, "--tool", 6, "--depth", 2, *MILL, "--strategy", strategy)
                self.assertEqual(done.returncode, 0, done.stderr)
                stock = self.simulated("--stock", "5,15,75,75,0,-8", "--tool", 6, "--stock-cell", 0.1)["stock"]
                self.assertLessEqual(stock["removed_mm3"]["least"], volume)
                self.assertGreaterEqual(stock["removed_mm3"]["most"], volume)

    def test_refuses_islands_that_touch_their_wall(self):
        room = '<rect x="10" y="10" width="60" height="40"/>'
        for island, place in (('<rect x="10" y="20" width="5" height="5"/>', "10.000"),
                              ('<circle cx="15" cy="30" r="5"/>', "10.000 50.000"),
                              ('<path d="M40 50 L45 40 L35 40 Z"/>', "40.000 30.000")):
            for strategy in "contour", "spiral", "adaptive", "zigzag":
                with self.subTest(island=island, strategy=strategy):
                    done = self.pocket(svg(room, island), "--tool", 3, "--depth", 2, *MILL, "--strategy", strategy)
                    self.assertEqual(done.returncode, 1, done.stdout)
                    self.assertIn(f"at {place}", done.stderr)
                    self.assertIn("separate them", done.stderr)
                    self.assertFalse(self.program.exists())
        # A deeper pocket may share walls with the pocket around it.
        done = self.pocket(svg(room, '<rect x="10" y="10" width="20" height="40" stroke="red"/>'), "--tool", 6,
                           "--depth", 2, "--depth-of", "red=4", *MILL)
        self.assertEqual(done.returncode, 0, done.stderr)
        stock = self.simulated("--stock", "5,25,75,75,0,-8", "--tool", 6, "--stock-cell", 0.1)["stock"]
        corner = (4 - math.pi) * 3 ** 2
        volume = 2 * (60 * 40 - corner) + 2 * (20 * 40 - corner)
        self.assertLessEqual(stock["removed_mm3"]["least"], volume)
        self.assertGreaterEqual(stock["removed_mm3"]["most"], volume)

    def test_refuses_depths_of_no_layer_and_no_depths(self):
        for more, words in ((("--depth-of", "red"), "must be a layer or colour and its depth"),
                            (("--depth-of", "black=-1"), "0 to 1000 mm"),
                            (("--depth-of", "black=1 mm"), "must be a layer or colour"),
                            (("--depth-of", "blak=1"), 'no closed contour of layer or colour "blak"'),
                            (("--depth-of", "black=1", "--v-angle", 60), "--depth-of: cannot be used with --v-angle")):
            with self.subTest(more=more):
                done = self.pocket(TRAY, "--tool", 6, "--depth", 2, *MILL, *more)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn(words, done.stderr)
                self.assertFalse(self.program.exists())
        done = self.pocket(svg('<rect x="10" y="10" width="60" height="40" stroke="red"/>'), "--tool", 6, "--depth", 2,
                           *MILL, "--depth-of", "red=0")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no contour in it is deeper than Z 0", done.stderr)

    def test_mills_open_pockets_from_beside_the_stock(self):
        shapes = svg('<rect x="40" y="-5" width="20" height="45"/>', '<rect x="75" y="50" width="15" height="20"/>')
        # The open pocket is cleared completely, except for its rounded corners within the stock;
        # the closed one except for four corners.
        corner = (1 - math.pi / 4) * 3 ** 2
        volume = 3 * (20 * 40 - 2 * corner + 15 * 20 - 4 * corner)
        for strategy in "contour", "spiral", "adaptive", "zigzag":
            with self.subTest(strategy=strategy):
                done = self.pocket(shapes, "--tool", 6, "--depth", 3, "--depth-step", 1.5, *MILL, "--stock", OPEN_BOX,
                                   "--strategy", strategy)
                self.assertEqual(done.returncode, 0, done.stderr)
                stock = self.simulated("--stock", f"{OPEN_BOX},0,-10", "--tool", 6, "--stock-cell", 0.25)["stock"]
                self.assertEqual(stock["rapids_in_stock"]["count"], 0)
                self.assertEqual(stock["plunges_in_stock"]["count"], 0)
                self.assertLessEqual(stock["removed_mm3"]["least"], volume)
                self.assertGreaterEqual(stock["removed_mm3"]["most"], volume)
                self.assertLess(stock["removed_mm3"]["most"] - stock["removed_mm3"]["least"], 0.15 * volume)

    def test_refuses_what_open_pockets_have_not(self):
        shapes = svg('<rect x="40" y="-5" width="20" height="45"/>')
        for more, words in ((("--stock", "0,0,100,-80"), "the greater values last"),
                            (("--stock", OPEN_BOX, "--strategy", "paper"), "--stock"),
                            (("--stock", OPEN_BOX, "--finish", 0.2), "--finish: cannot be used with --stock"),
                            (("--stock", OPEN_BOX, "--rest-of", 9), "--stock: cannot be used with --rest-of")):
            with self.subTest(more=more):
                done = self.pocket(shapes, "--tool", 6, "--depth", 3, *MILL, *more)
                self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
                self.assertIn(words, done.stderr)
        done = self.pocket(shapes, "--tool", 6, "--depth", 3, *MILL, "--stock", "200,200,300,300")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no pocket is within the stock", done.stderr)

    def test_names_what_the_tool_does_not_fit_into(self):
        two = svg('<rect x="10" y="10" width="40" height="30"/>', '<rect x="60" y="10" width="4" height="30"/>')
        done = self.pocket(two, "--tool", 6, "--depth", 2, *MILL)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"60\.000 \d+\.000.* for a tool of 6 mm; choose a smaller one")
        self.assertFalse(self.program.exists())
        done = self.pocket(two, "--tool", 6, "--depth", 2, *MILL, "--anyway")
        self.assertEqual(done.returncode, 1)
        self.assertTrue(self.program.exists())
        self.assertLess(self.simulated()["bounds_mm"]["X"][1], 47.01)
        self.program.unlink()
        done = self.pocket(TRAY, "--tool", 60, "--depth", 2, *MILL, "--anyway")
        self.assertEqual(done.returncode, 1)
        self.assertIn("fits nowhere", done.stderr)
        self.assertFalse(self.program.exists())


if __name__ == "__main__":
    unittest.main()
