"""Outline lettering: converts the quadratic splines of a TrueType font to pairs of tangent arcs (biarcs)."""
import cmath
import json

from .geometry import Segment, cross, moved, tangent_arc, unit

# Greatest distance between a spline and the arcs that replace it.
TOLERANCE_MM = 0.005
SAMPLES = 16


class Font:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            data = json.load(file)
        self.cap_height = data["cap_height"]
        self.glyphs = data["glyphs"]

    def outlines(self, text, cap_height):
        """Returns the closed paths of a line of text that begins at the origin, and the width of the line."""
        scale = cap_height / self.cap_height
        paths, x = [], 0.0
        for character in text:
            glyph = self.glyphs[character]
            for contour in glyph["contours"]:
                points = [(complex(px * scale + x, py * scale), on) for px, py, on in contour]
                paths.append(contour_path(points))
            x += glyph["advance"] * scale
        return paths, x

    def along_line(self, text, cap_height, centre):
        """Returns the paths of a text that is centred on a point, horizontally and vertically."""
        paths, width = self.outlines(text, cap_height)
        return [moved(path, 1, centre - complex(width, cap_height) / 2) for path in paths]

    def along_circle(self, text, cap_height, centre, radius, angle):
        """Returns the paths of a text along a circle, centred at an angle. It is read from outside; its baseline is at
        `radius`.
        """
        paths, width = self.outlines(text, cap_height)
        outward = cmath.rect(1, angle)
        return [moved(moved(path, 1, complex(-width / 2, radius)), outward / 1j, centre) for path in paths]


def contour_path(points):
    """Returns a TrueType contour as lines and arcs. Its points are either on the curve or control points. The middle
    of two successive control points is a point on the curve, which the font does not store."""
    first = next(i for i, (_, on) in enumerate(points) if on)
    points = points[first:] + points[:first + 1]
    path, start, control = [], points[0][0], None
    for point, on in points[1:]:
        if on and control is None:
            path.append(Segment(start, point))
            start = point
        elif control is None:
            control = point
        else:
            end = point if on else (control + point) / 2
            path += quadratic_arcs(start, control, end)
            start, control = end, None if on else point
    return path


def quadratic_arcs(start, control, end):
    """Returns a quadratic Bezier curve as biarcs within TOLERANCE_MM. The curve is halved until the biarcs fit."""
    if abs(cross(control - start, end - start)) < 1e-9:
        return [Segment(start, end)]
    pair = biarc(start, control, end)
    curve = [start + 2 * t * (control - start) + t * t * (start - 2 * control + end)
             for t in (i / SAMPLES for i in range(1, SAMPLES))]
    if max(min(distance(p, s) for s in pair) for p in curve) <= TOLERANCE_MM:
        return pair
    left, right = (start + control) / 2, (control + end) / 2
    middle = (left + right) / 2
    return quadratic_arcs(start, left, middle) + quadratic_arcs(middle, right, end)


def biarc(start, control, end):
    """Returns two arcs that are tangent to the sides of the triangle at its ends, and tangent to each other at their
    joint.

    The joints of all such pairs are on one circle. The incentre of the triangle is on this circle and divides the bend
    evenly.
    """
    a, b, c = abs(end - control), abs(end - start), abs(control - start)
    joint = (a * start + b * control + c * end) / (a + b + c)
    first = tangent_arc(start, unit(control - start), joint)
    last = tangent_arc(end, unit(control - end), joint)
    return [first, Segment(joint, end, last.centre, -last.sweep)]


def distance(point, segment):
    """Returns the distance from a point to the infinite line or the full circle of a segment."""
    if segment.centre is None:
        return abs(cross(unit(segment.end - segment.start), point - segment.start))
    return abs(abs(point - segment.centre) - segment.radius)
