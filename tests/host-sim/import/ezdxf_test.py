#!/usr/bin/env python3
"""Compares kerfline with a second reader of DXF: ezdxf writes random drawings and flattens them,
and kerfline must draw the same.

    ezdxf_test.py KERFLINE

KERFLINE_TRIALS=N: number of drawings; KERFLINE_SEED=N: a single drawing
"""

import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

import ezdxf
from ezdxf import path

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import seeds_of  # noqa: E402

KERFLINE = ""
TOLERANCE_MM = 0.03  # Chords of both within 0.01, and ends joined over 0.01.


def distance_to(place, row):
    best = math.inf
    for (ax, ay), (bx, by) in zip(row, row[1:]):
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        share = 0 if square == 0 else max(0, min(1, ((place[0] - ax) * dx + (place[1] - ay) * dy) / square))
        best = min(best, math.hypot(place[0] - ax - share * dx, place[1] - ay - share * dy))
    return best


class Drawer:
    """Draws random entities, each far from the others so that none are joined."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.document = ezdxf.new("R2010", units=4)
        self.space = self.document.modelspace()
        self.exploded = False

    def number(self, least, most):
        return self.random.uniform(least, most)

    def place(self, at):
        return at[0] + self.number(-20, 20), at[1] + self.number(-20, 20)

    def draw(self):
        block = self.document.blocks.new("PART", base_point=(self.number(-3, 3), self.number(-3, 3)))
        self.entity(block, (0, 0), self.random.randrange(6))
        for i in range(6):
            self.entity(self.space, (200 * i, 0), self.random.randrange(7))
        for i in range(2):
            size = self.number(0.5, 2)
            self.space.add_blockref("PART", (200 * i, 400), dxfattribs={
                "rotation": self.number(-180, 180), "xscale": size,
                "yscale": self.random.choice([size, -size, 0.7 * size])})

    def entity(self, space, at, kind):
        behind = {"extrusion": (0, 0, -1)} if self.random.random() < 0.3 else {}
        if kind == 0:
            space.add_line(self.place(at), self.place(at))
        elif kind == 1:
            space.add_circle(at, self.number(1, 20), dxfattribs=behind)
        elif kind == 2:
            space.add_arc(at, self.number(1, 20), self.number(-360, 360), self.number(-360, 360), dxfattribs=behind)
        elif kind == 3:
            corners = [(*self.place(at), self.random.choice([0, self.number(-2, 2)])) for _ in range(5)]
            add = self.random.choice([space.add_lwpolyline, space.add_polyline2d])
            add(corners, format="xyb", close=self.random.random() < 0.5, dxfattribs=behind)
        elif kind == 4:
            start, end = self.random.choice([(0, math.tau), (self.number(0, 3), self.number(3.2, 6.2))])
            space.add_ellipse(at, (self.number(2, 20), self.number(2, 20)), self.number(0.1, 1), start, end,
                              dxfattribs=behind)
        elif kind == 5:
            points = [self.place(at) for _ in range(7)]
            weights = [self.number(0.3, 3) for _ in points]
            if self.random.random() < 0.5:
                space.add_open_spline(points, degree=self.random.randint(2, 5))
            else:
                space.add_rational_spline(points, weights, degree=3)
        else:
            spline = space.add_spline([self.place(at) for _ in range(6)])
            spline.dxf.start_tangent = self.number(-1, 1), self.number(0.1, 1)
            spline.dxf.end_tangent = self.number(-1, 1), self.number(0.1, 1)

    def flattened(self):
        rows = []
        for entity in self.space:
            # A stretched polyline is drawn edge by edge.
            parts = entity.virtual_entities() if entity.dxftype() == "INSERT" else [entity]
            for part in parts:
                rows.append([(p.x, p.y) for p in self.flatten(part)])
        self.exploded = len(rows) != len(self.space)
        return rows

    @staticmethod
    def flatten(entity):
        if entity.dxftype() == "SPLINE":  # Of these a path has an approximation only.
            return entity.construction_tool().flattening(0.005, 32)
        if entity.dxftype() in ("ARC", "CIRCLE", "ELLIPSE"):
            return entity.flattening(0.005)
        return path.make_path(entity).flattening(0.005, 32)


class FormDrawer(Drawer):
    """Draws entities of any release, in ASCII or binary: nested blocks, arrays, tilted planes, any
    kind of knots.
    """

    VERSIONS = ("R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018")

    def __init__(self, seed):
        super().__init__(seed)
        self.version = self.random.choice(self.VERSIONS)
        self.form = self.random.choice(("asc", "bin"))
        self.document = ezdxf.new(self.version, units=4)
        # In Release 12, ezdxf writes no $INSUNITS.
        self.space = self.document.modelspace()
        self.contours = 0

    def draw(self):
        inner = self.document.blocks.new("INNER", base_point=(self.number(-3, 3), self.number(-3, 3)))
        outer = self.document.blocks.new("OUTER")
        self.form_of(inner, (0, 0))
        outer.add_blockref("inner", (5, 5), dxfattribs={"rotation": self.number(-180, 180), "xscale": -1.0})
        for i in range(6):
            self.form_of(self.space, (200 * i, 0))
        # A rotated block in a stretched one is sheared, which an INSERT of ezdxf cannot represent.
        size = self.number(0.5, 2)
        self.space.add_blockref("OUTER", (0, 400), dxfattribs={
            "rotation": self.number(-180, 180), "xscale": size, "yscale": self.random.choice([size, -size]),
            "column_count": 2, "row_count": 3, "column_spacing": 150, "row_spacing": 160,
            "extrusion": self.random.choice([(0, 0, 1), (0, 0, -1)])})
        self.contours = 6 + 2 * 3

    def form_of(self, space, at):
        kind = self.random.randrange(4 if self.version == "R12" else 7)
        normal = self.random.choice([(0, 0, 1), (0, 0, -1), (self.number(-1, 1), self.number(-1, 1), 1),
                                     (self.number(-1, 1), self.number(-1, 1), -0.7)])
        tilted = {"extrusion": normal}
        middle = (*at, self.number(-30, 30))
        if kind == 0:
            space.add_circle(middle, self.number(1, 20), dxfattribs=tilted)
        elif kind == 1:
            space.add_arc(middle, self.number(1, 20), self.number(-360, 360), self.number(-360, 360), dxfattribs=tilted)
        elif kind == 2:
            corners = [(*self.place(at), self.random.choice([0, self.number(-2, 2)])) for _ in range(5)]
            space.add_polyline2d(corners, format="xyb", close=self.random.random() < 0.5,
                                 dxfattribs={**tilted, "elevation": (0, 0, middle[2])})
        elif kind == 3:
            space.add_polyline3d([(*self.place(at), self.number(-9, 9)) for _ in range(4)])
        elif kind == 4:
            start = self.number(0, 3)
            frame = ezdxf.math.OCS(normal)
            axis = frame.to_wcs((self.number(2, 20), self.number(2, 20), 0))
            space.add_ellipse(at, axis, self.number(0.1, 1), start, start + self.number(0.5, 3), dxfattribs=tilted)
        else:
            self.spline(space, at, self.random.randint(1, 10) if kind == 5 else 3)

    def spline(self, space, at, degree):
        """Adds a spline with random knots, clamped or not, inner ones up to `degree` times, or
        with the fit points of a closed curve.
        """
        count = degree + 1 + self.random.randrange(8)
        knots = [0.0] * (degree + 1)
        while len(knots) < count:
            times = min(self.random.randint(1, degree), count - len(knots))
            knots += [knots[-1] + self.number(0.2, 2)] * times
        knots += [knots[-1] + 1] * (degree + 1)
        if self.random.random() < 0.3:
            knots = [float(i) for i in range(count + degree + 1)]
        spline = space.add_spline(degree=degree)
        spline.control_points = [(*self.place(at), 0) for _ in range(count)]
        spline.knots = knots
        if self.random.random() < 0.3:
            spline.weights = [self.number(0.3, 3) for _ in range(count)]

    def rows(self):
        for entity in self.space:
            parts = [entity]
            if entity.dxftype() == "INSERT":
                parts = [part for copy in entity.multi_insert() for part in self.parts_of(copy)]
            for part in parts:
                yield [(p[0], p[1]) for p in self.flatten(part)]

    def parts_of(self, insert):
        for part in insert.virtual_entities():
            if part.dxftype() == "INSERT":
                yield from self.parts_of(part)
            else:
                yield part


def is_filled(read):
    """Returns whether contours cross, and are read as the outlines of the area that they fill."""
    return any(fault["kind"] == "mended" for fault in read["faults"])


class ByEzdxf(unittest.TestCase):
    def test_random_forms_of_all_releases_are_the_same_curves(self):
        with tempfile.TemporaryDirectory() as folder:
            for seed in seeds_of(self, 60):
                with self.subTest(seed=seed):
                    drawer = FormDrawer(seed)
                    drawer.draw()
                    file = pathlib.Path(folder) / f"{seed}.dxf"
                    drawer.document.saveas(file, fmt=drawer.form)
                    self.compare_rows(drawer, file)

    def compare_rows(self, drawer, file):
        done = subprocess.run([KERFLINE, "drawing", file, "--json", "--gap", "0"], capture_output=True, text=True,
                              check=False)
        read = json.loads(done.stdout)
        told = ("open", "crossing", "ignored", "note", "mended")
        self.assertEqual([fault for fault in read["faults"] if fault["kind"] not in told], [])
        ours = [contour["outline_mm"] for contour in read["contours"]]
        rows = list(drawer.rows())
        if is_filled(read):
            self.compare_lines(rows, ours, read)
            return
        self.assertEqual(len(ours), drawer.contours, drawer.version)
        near = [min(ours, key=lambda o: distance_to(row[0], o) + distance_to(row[len(row) // 2], o)) for row in rows]
        for row, other in zip(rows, near):
            for place in row[::max(1, len(row) // 40)]:
                self.assertLess(distance_to(place, other), TOLERANCE_MM, f"{place} of {drawer.version}")
        for outline in ours:
            self.assertTrue(any(other is outline for other in near), "a contour that ezdxf does not have")

    def compare_lines(self, theirs, ours, read):
        """Checks that outlines of crossing contours are the drawn lines, except for loops that are
        left out.
        """
        for row in ours:
            for place in row[::max(1, len(row) // 40)]:
                self.assertLess(min(distance_to(place, other) for other in theirs), TOLERANCE_MM, place)
        far, far_mm, step_mm = [], 0.0, 0.0
        for row in theirs:
            places = row[::max(1, len(row) // 40)]
            for place, after in zip(places, [*places[1:], places[-1]]):
                nearest = min(distance_to(place, other) for other in ours)
                if nearest >= TOLERANCE_MM:
                    far.append((place, nearest))
                    far_mm += math.dist(place, after)
                    step_mm = max(step_mm, math.dist(place, after))
        loops = sum(int(found[1]) for fault in read["faults"]
                    for found in [re.search(r"(\d+) (?:loops? )?smaller than", fault["reason"])] if found)
        # A loop that is left out is shorter than 2 mm, by the limits of its area and width.
        self.assertLessEqual(far_mm, (2 + step_mm) * loops, far)
        self.assertTrue(all(nearest < 2 for _, nearest in far), far)

    def test_random_drawings_are_the_same_curves(self):
        # Known fault: at seed 1314348124 the two readers differ.
        seeds = seeds_of(self, 60, known_fault=True)
        with tempfile.TemporaryDirectory() as folder:
            for seed in seeds:
                with self.subTest(seed=seed):
                    self.compare(seed, pathlib.Path(folder) / f"{seed}.dxf")

    def compare(self, seed, file):
        drawer = Drawer(seed)
        drawer.draw()
        drawer.document.saveas(file)
        done = subprocess.run([KERFLINE, "drawing", file, "--json"], capture_output=True, text=True, check=False)
        read = json.loads(done.stdout)
        told = ("open", "crossing", "ignored", "mended")
        self.assertEqual([fault for fault in read["faults"] if fault["kind"] not in told], [])
        ours = [contour["outline_mm"] for contour in read["contours"]]
        theirs = drawer.flattened()
        if is_filled(read):
            self.compare_lines(theirs, ours, read)
            return
        self.assertEqual(len(ours), len(drawer.space))
        for row in theirs:
            near = min(ours, key=lambda o: distance_to(row[0], o) + distance_to(row[len(row) // 2], o))
            for one, other in ((row, near),) if drawer.exploded else ((row, near), (near, row)):
                for place in one[::max(1, len(one) // 60)]:
                    self.assertLess(distance_to(place, other), TOLERANCE_MM, f"{place} of seed {seed}")


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
