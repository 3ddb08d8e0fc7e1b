"""Tests of the judge of cuts: small drawings with programs that are right, or wrong in one way.

`judge_cuts.py --self-test` runs them. They are not part of the test suite, because it has no shapely.
"""
import math
import pathlib
import tempfile
import unittest

from shapely.geometry import Point, Polygon, box
from shapely.ops import unary_union

from judge_drawing import parts_of, rows_of
from judge_path import Shapes, judged

KERF = 0.15
SQUARE = box(0, 0, 20, 10)


def rings_of(shape) -> list:
    parts = getattr(shape, "geoms", [shape])
    return [list(ring.coords) for part in parts for ring in [part.exterior, *part.interiors]]


def program_of(paths: list) -> str:
    """Returns a program that cuts along closed or open lines."""
    text = [f"(kerf {KERF} mm, given)", "G21 G90"]
    for path in paths:
        (x, y), *rest = path
        text += [f"G0 X{x:.4f} Y{y:.4f}", *(f"G1 X{x:.4f} Y{y:.4f}" for x, y in rest)]
    return "\n".join(text)


def paths_beside(shape) -> list:
    """Returns the paths of a beam half a kerf beside a shape, in the waste."""
    return rings_of(shape.buffer(KERF / 2, join_style=2))


def complaint_on(rings: list, paths: list, told: str = "", options: tuple = ()) -> str:
    """Returns the judge's complaint about `paths` for a drawing of closed `rings`."""
    def subpath(ring: list) -> str:
        return "M" + " L".join(f"{x:.6f},{30 - y:.6f}" for x, y in ring[:-1]) + "Z"

    drawing = ('<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30">' +
               "".join(f'<path d="{subpath(ring)}" fill="none" stroke="#000"/>' for ring in rings) + "</svg>")
    with tempfile.TemporaryDirectory() as scratch:
        file = pathlib.Path(scratch) / "drawing.svg"
        file.write_text(drawing, encoding="utf-8")
        return judged(rows_of(file), program_of(paths), told, Shapes(), list(options))


def bay(neck_mm: float, depth_mm: float, width_mm: float) -> Polygon:
    """Returns a bay of the edge y = 0 of SQUARE: a neck of 10 um, then a box of width and depth."""
    inner = box(10 - width_mm / 2, 0.01, 10 + width_mm / 2, 0.01 + depth_mm)
    return unary_union([inner, box(10 - neck_mm / 2, -0.5, 10 + neck_mm / 2, 0.011)])


def corner_loop(size_mm: float) -> list:
    """Returns a square whose outline crosses itself at the corner 20, 10 and makes a loop within the square."""
    loop = [(20 - size_mm, 9.99), (20 - size_mm, 10 - size_mm), (19.99, 10 - size_mm)]
    return [(0, 0), (20, 0), (20, 10), *loop, (20, 10), (0, 10), (0, 0)]


class JudgeTest(unittest.TestCase):
    def test_a_path_half_a_kerf_beside_the_part_is_right(self):
        self.assertEqual(complaint_on(rings_of(SQUARE), paths_beside(SQUARE)), "")

    def test_a_path_nearer_than_half_the_kerf_is_wrong(self):
        path = rings_of(SQUARE.buffer(KERF / 2 - 0.01, join_style=2))
        self.assertIn("too near", complaint_on(rings_of(SQUARE), path))
        self.assertEqual(complaint_on(rings_of(SQUARE), path, options=("--narrow", "0.03")), "")

    def test_a_path_across_a_part_is_wrong(self):
        paths = [*paths_beside(SQUARE), [(-1, 5), (21, 5)]]
        self.assertIn("too near, -", complaint_on(rings_of(SQUARE), paths))

    def test_an_uncut_hole_is_wrong_unless_it_is_listed(self):
        with_hole = SQUARE.difference(box(5, 5, 5.1, 8))
        self.assertIn("mm uncut", complaint_on(rings_of(with_hole), paths_beside(SQUARE)))
        listing = "warning: a.svg:1:1: path at {}: is too narrow here: 6.20 mm of it stay uncut; widen the slot"
        for place, right in (("5.000 5.000", True), ("5.000 12.000", False)):
            complaint = complaint_on(rings_of(with_hole), paths_beside(SQUARE), listing.format(place))
            self.assertEqual(complaint == "", right, place)

    def test_two_cuts_along_one_line_are_wrong(self):
        paths = [*paths_beside(SQUARE), [(-KERF / 2, 0), (-KERF / 2, 8)]]
        self.assertIn("cut twice", complaint_on(rings_of(SQUARE), paths))

    def test_small_loops_at_points_of_a_contour_are_left_out(self):
        self.assertEqual([len(ring) for part in self.parts_of(corner_loop(0.1))
                          for ring in [part.exterior.coords, *part.interiors]], [5])

    def test_larger_loops_at_points_of_a_contour_count(self):
        (part,) = self.parts_of(corner_loop(0.2))
        self.assertAlmostEqual(part.area, 200 - 0.04, 2)

    def test_small_loops_behind_a_narrow_neck_are_left_out(self):
        for neck in (0.002, 0.006, 0.03, 0.05):
            (part,) = self.parts_of(SQUARE.difference(bay(neck, 0.13, 0.13)))
            self.assertAlmostEqual(part.area, 200, 2, msg=f"neck {neck}")
            self.assertLess(200 - part.area, neck * 0.011 + 0.002, f"neck {neck}")

    def test_loops_count_that_are_larger_or_have_a_wide_neck(self):
        for neck, depth, width in ((0.03, 0.2, 0.2), (0.03, 0.8, 0.08), (0.1, 0.13, 0.13)):
            drawn = SQUARE.difference(bay(neck, depth, width))
            (part,) = self.parts_of(drawn)
            self.assertAlmostEqual(part.area, drawn.area, 4, msg=f"neck {neck}, {depth} mm x {width} mm")

    def test_a_neck_that_is_as_wide_as_the_kerf_is_none(self):
        drawn = SQUARE.difference(bay(0.03, 0.13, 0.13))
        (part,) = self.parts_of(drawn, kerf=0.02)
        self.assertAlmostEqual(part.area, drawn.area, 4)

    def test_notches_and_slits_of_uneven_width_count(self):
        notch = box(10, -1, 10.1, 0.15)
        slit = Polygon([(2, 2), *((2 + k / 10, 2.08 + 0.02 * math.sin(k)) for k in range(60)), (8, 2)])
        for waste in (notch, slit):
            drawn = SQUARE.difference(waste)
            (part,) = self.parts_of(drawn)
            self.assertAlmostEqual(part.area, drawn.area, 4)

    def test_a_spur_of_a_part_counts_though_it_is_small(self):
        spur = unary_union([SQUARE, box(9.97, 9, 10.03, 10.05), box(9.94, 10.05, 10.06, 10.17)])
        (part,) = self.parts_of(spur)
        self.assertAlmostEqual(part.area, spur.area, 4)

    def test_a_hole_keeps_its_place_beside_a_small_loop_of_its_own(self):
        hole = Point(10, 5).buffer(2).union(box(11.9, 4.99, 12.02, 5.01)).union(box(12.02, 4.95, 12.12, 5.05))
        (part,) = self.parts_of(SQUARE.difference(hole))
        self.assertEqual(len(part.interiors), 1)
        self.assertAlmostEqual(part.area, 200 - Point(10, 5).buffer(2).area, 2)

    def test_a_cut_along_a_slit_is_right_as_far_as_narrow_allows(self):
        drawn = SQUARE.difference(Polygon([(10, 9), (10.001, 9), (10.05, 10), (9.95, 10)]))
        slit = [(10, 9.05), (10, 10.2)]
        narrow = ("--narrow", "0.075")
        self.assertEqual(complaint_on(rings_of(drawn), [*paths_beside(SQUARE), slit], options=narrow), "")
        self.assertIn("too near", complaint_on(rings_of(drawn), [*paths_beside(SQUARE), slit]))
        self.assertIn("too near", complaint_on(rings_of(drawn), [*paths_beside(SQUARE), slit, [(5, 5), (5, 6)]],
                                               options=narrow))

    def test_a_shared_edge_is_cut_once_along_itself(self):
        rings = rings_of(box(0, 0, 10, 10)) + rings_of(box(10, 0, 20, 10))
        around = rings_of(SQUARE.buffer(KERF / 2, join_style=2))
        between = [(10, -KERF / 2), (10, 10 + KERF / 2)]
        common = ("--common-line", "0.1")
        self.assertEqual(complaint_on(rings, [*around, between], options=common), "")
        self.assertIn("between parts uncut", complaint_on(rings, around, options=common))

    def test_an_edge_that_two_contours_have_on_the_same_side_need_not_be_cut(self):
        sheet, tall, low = box(0, 0, 20, 10), box(2, 2, 8, 8), box(2, 2, 8, 5)
        hole = box(2, 5, 8, 8)
        self.assertEqual(complaint_on(rings_of(sheet) + rings_of(tall) + rings_of(low),
                                      paths_beside(sheet.difference(hole)), options=("--common-line", "0.1")), "")

    @staticmethod
    def parts_of(drawn, kerf: float = KERF) -> list:
        rings = [drawn] if isinstance(drawn, list) else rings_of(drawn)
        return parts_of([[complex(x, y) for x, y in ring] for ring in rings], kerf)


def main() -> int:
    result = unittest.TextTestRunner().run(unittest.defaultTestLoader.loadTestsFromTestCase(JudgeTest))
    return 0 if result.wasSuccessful() else 1
