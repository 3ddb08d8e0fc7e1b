#!/usr/bin/env python3
"""`kerfline cut` of drawings as users make them: sound contours are cut as drawn, all others are
reported.

    cut_drawings_test.py KERFLINE
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
HEAD = ('<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        'width="60mm" height="40mm" viewBox="0 0 60 40" fill="none" stroke="#000">')
KERF = ("--kerf", "0.2", "--power", "20W", "--feed", "600", "--full-power", "40")


def box_with_loops() -> str:
    """Returns a slot whose corners have the tiny loops that box generators draw."""
    return ("M 24 10 H 21 C 20.9 10 21 10.1 21 10 V 7 C 21 6.9 20.9 7 21 7 "
            "H 27 C 27.1 7 27 6.9 27 7 V 10 C 27 10.1 27.1 10 27 10 H 24 Z")


class CutDrawings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.target = self.folder / "job.nc"

    def cut(self, content, *more):
        drawing = self.folder / "drawing.svg"
        drawing.write_text(f"{HEAD}{content}</svg>")
        return subprocess.run([KERFLINE, "cut", drawing, *KERF, *more, "-o", self.target],
                              capture_output=True, text=True, check=False)

    def sound(self, content, *more):
        done = self.cut(content, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def bounds(self):
        """Returns the least and greatest X and Y of the program, without the origin, at which it ends."""
        places = {"X": [], "Y": []}
        for axis, number in re.findall(r"([XY])(-?[\d.]+)", self.target.read_text()):
            places[axis] += [float(number)] * (float(number) != 0)
        return [(min(values), max(values)) for values in places.values()]

    def cuts(self, done):
        return int(re.search(r"^(\d+) cuts?,", done.stdout, re.M)[1])

    def test_loops_at_corners_of_box_generators(self):
        done = self.sound(f'<rect x="1" y="1" width="50" height="30"/><path d="{box_with_loops()}"/>')
        self.assertEqual(self.cuts(done), 2)
        self.assertIn("4 smaller than 0.02 mm2", done.stderr)
        self.assertNotIn("warning: ", done.stderr.replace("kerfline: warning", ""))

    def test_a_copy_on_another_layer_a_nanometre_away(self):
        layer = '<g inkscape:groupmode="layer" inkscape:label="{}">{}</g>'
        plate = '<rect x="1" y="1" width="38" height="28"/><circle cx="20" cy="15" r="5"/>'
        done = self.sound(layer.format("a", plate) +
                          layer.format("b", '<circle cx="20" cy="15" r="4.999995"/>'), "--check")
        self.assertEqual(self.cuts(done), 2)
        self.assertIn("of another layer", done.stderr)
        self.assertLess(float(re.search(r"off the part at most ([\d.]+) um", done.stdout)[1]), 10)

    def test_a_slot_across_the_edge_in_another_colour(self):
        done = self.sound('<rect x="5" y="5" width="40" height="30"/>'
                          '<rect stroke="#00f" x="20" y="1" width="4" height="10"/>')
        self.assertIn("2 contours cross each other", done.stderr)
        self.assertIn("hold together", done.stderr)
        (low_x, high_x), (low_y, high_y) = self.bounds()
        self.assertAlmostEqual(high_x, 45.1, 3)
        self.assertAlmostEqual(high_y, 39.1, 3)
        self.assertLess(low_x, 4.91)
        self.assertLess(low_y, 4.91)

    def test_layers_that_are_cut_otherwise_do_not_fill_together(self):
        content = ('<rect x="5" y="5" width="40" height="30"/>'
                   '<rect stroke="#00f" x="20" y="1" width="4" height="10"/>')
        done = self.sound(content, "--layer", "#00f: kind=score, power=5W, feed=900")
        self.assertNotIn("cross each other", done.stderr)
        self.assertEqual(self.cuts(done), 2)

    def test_a_living_hinge_is_cut_on_its_lines(self):
        slits = "".join(f"M {12 + 0.5 * i} {8 + 5 * (i % 2)} v 20 " for i in range(20))
        done = self.sound(f'<rect x="5" y="5" width="40" height="30"/><path d="{slits}"/>')
        self.assertEqual(self.cuts(done), 21)
        self.assertIn("20 open contours", done.stderr)

    def test_an_outline_that_nearly_closes(self):
        done = self.sound('<path d="M 5.1 5 H 45 V 35 H 5 V 5.1"/>')
        self.assertEqual(self.cuts(done), 1)
        self.assertIn("nearly closed", done.stderr)
        refused = self.cut('<path d="M 5.1 5 H 45 V 35 H 5 V 5.1"/>', "--gap", "0.01")
        self.assertEqual(refused.returncode, 1)
        self.assertIn("the contour is open", refused.stderr)

    def test_parts_side_by_side_are_refused_and_offered_a_common_cut(self):
        pair = '<path d="M10 10H30V30H10Z"/><path d="M30 10H50V30H30Z"/>'
        refused = self.cut(pair)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("along 20.000 mm", refused.stderr)
        self.assertIn("--common-line", refused.stderr)
        self.assertFalse(self.target.exists())
        done = self.sound(pair, "--common-line", "0.2")
        self.assertIn("warning: ", done.stderr)

    def test_parts_in_a_t_are_cut_once_along_their_edges(self):
        tee = '<path d="M5 20H45V30H5Z"/><path d="M5 20V8H20V20Z"/><path d="M20 20V8H38V20Z"/>'
        refused = self.cut(tee)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("touches path along 18.000 mm", refused.stderr)
        done = self.sound(tee, "--common-line", "0.2", "--check")
        self.assertEqual(self.cuts(done), 3)
        self.assertIn("touches other parts along 33.000 mm", done.stderr)

    def test_parts_that_touch_at_a_corner_of_a_shared_edge_are_cut_apart(self):
        # The second part touches the first one along an edge, and reaches around it to another
        # corner.
        parts = '<path d="M10 10H30V20H20V30H10Z"/><path d="M30 10H40V40H5V30H10V35H30Z"/>'
        done = self.sound(parts, "--common-line", "0.2")
        self.assertEqual(self.cuts(done), 3, "the second part has what is between, and what is around")
        corners = '<path d="M10 10H20V20H10Z"/><path d="M20 20H30V30H20Z"/>'
        done = self.sound(corners, "--common-line", "0.2")
        self.assertEqual(self.cuts(done), 2)
        self.assertIn("touches other parts at corners", done.stderr)

    def test_rings_nearer_than_the_kerf_are_refused(self):
        refused = self.cut('<circle cx="30" cy="20" r="15"/><circle cx="30" cy="20" r="10"/>'
                           '<circle cx="30" cy="20" r="9.9"/>')
        self.assertEqual(refused.returncode, 1)
        self.assertIn("place them at least the kerf apart", refused.stderr)

    def test_waste_narrower_than_the_kerf_is_cut_along_its_middle_where_that_is_allowed(self):
        rings = ('<circle cx="30" cy="20" r="15"/><circle cx="30" cy="20" r="10"/>'
                 '<circle cx="30" cy="20" r="9.9"/>')
        done = self.sound(rings, "--narrow", "0.051", "--check")
        self.assertIn("takes up to 0.050 mm off its edges", done.stderr)
        self.assertEqual(self.cuts(done), 2)
        self.assertEqual(self.cut(rings, "--narrow", "0.049").returncode, 1)
        mark = ('<rect x="5" y="5" width="40" height="30"/>'
                '<path d="M20 19.95H24.95V15H25.05V19.95H30V20.05H25.05V25H24.95V20.05H20Z"/>')
        refused = self.cut(mark)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("along its middle with --narrow 0.100", refused.stderr)
        self.assertEqual(self.cuts(self.sound(mark, "--layer", "*: narrow=0.1")), 3)

    def test_no_line_runs_through_a_part_where_hairs_of_the_boundary_meet(self):
        for step in range(3):
            slot = (f'<g transform="scale(0.26458333333)translate({0.7 * step - 1770},{1700 - 1.3 * step})">'
                    '<rect width="566.92926" height="566.92914" x="1771.6536" y="-1594.4883" ry="3.0506115e-05"/>'
                    '<rect width="35.433071" height="10.629956" x="1807.0867" y="-1038.189" ry="3.0506115e-05"/></g>')
            done = self.sound(slot, "--narrow", "0.1")
            self.assertNotIn("narrower than the kerf", done.stderr)
            self.assertEqual(self.cuts(done), 1)

    def test_a_box_generator_that_allows_for_the_kerf_itself(self):
        box = ('<!-- Created with Boxes.py --><rect x="10" y="10" width="20.2" height="10.2"/>'
               '<text x="1" y="5">100.0mm, burn:0.10mm</text>')
        done = self.sound(box)
        self.assertIn("allows for a kerf of 0.2 mm", done.stderr)
        self.assertIn("side=on", done.stderr)
        self.sound(box, "--layer", "*: side=on")
        (low_x, high_x), _ = self.bounds()
        self.assertAlmostEqual(high_x - low_x, 20.2, 3)


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
