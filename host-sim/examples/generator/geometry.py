"""Lines and arcs in the plane. Points are complex numbers, in mm; angles are in radians.

A path is a list of segments. Each segment begins at the end of the previous one. A path is closed if its last segment
ends at the start of its first. Counter-clockwise is positive.
"""
import cmath
import math
from dataclasses import dataclass
from typing import Optional

# Greatest deviation of a segment from its chord at which the segment is written as a line: half of the last digit of
# the output.
STRAIGHT_MM = 0.0005


@dataclass(frozen=True)
class Segment:
    """A line (`centre` is None) or an arc of at most one full turn."""
    start: complex
    end: complex
    centre: Optional[complex] = None
    sweep: float = 0.0

    @property
    def radius(self):
        return abs(self.start - self.centre)

    @property
    def length(self):
        return abs(self.end - self.start) if self.centre is None else self.radius * abs(self.sweep)

    def point(self, t):
        if self.centre is None:
            return self.start + t * (self.end - self.start)
        return self.centre + (self.start - self.centre) * cmath.rect(1, t * self.sweep)

    def tangent(self, t):
        """Returns the unit vector of travel at the parameter `t`."""
        if self.centre is None:
            return unit(self.end - self.start)
        return unit(self.point(t) - self.centre) * (1j if self.sweep > 0 else -1j)

    def part(self, t0, t1):
        return Segment(self.point(t0), self.point(t1), self.centre, self.sweep * (t1 - t0))

    def moved(self, factor, shift):
        """Returns the segment with each point z moved to factor * z + shift: scaling and rotation, then translation."""
        centre = None if self.centre is None else factor * self.centre + shift
        return Segment(factor * self.start + shift, factor * self.end + shift, centre, self.sweep)


def unit(z):
    return z / abs(z)


def cross(a, b):
    return (a.conjugate() * b).imag


def moved(path, factor=1, shift=0):
    return [segment.moved(factor, shift) for segment in path]


def reverse(path):
    return [Segment(s.end, s.start, s.centre, -s.sweep) for s in reversed(path)]


def arc(centre, radius, angle, sweep):
    start = centre + cmath.rect(radius, angle)
    return Segment(start, centre + cmath.rect(radius, angle + sweep), centre, sweep)


def bulge_segment(start, end, bulge):
    """Returns the segment between two points with bulge = tan(sweep / 4), the form of drawings and sheet files."""
    if bulge == 0:
        return Segment(start, end)
    centre = (start + end) / 2 + 1j * (end - start) * (1 - bulge * bulge) / (4 * bulge)
    return Segment(start, end, centre, 4 * math.atan(bulge))


def tangent_arc(start, tangent, end):
    """Returns the arc (or line) that leaves `start` along `tangent` and reaches `end`."""
    chord = end - start
    half_sweep = cmath.phase(chord / tangent)
    if abs(chord) / 4 * abs(half_sweep) < STRAIGHT_MM:
        return Segment(start, end)
    centre = start + 1j * tangent * abs(chord) / (2 * math.sin(half_sweep))
    return Segment(start, end, centre, 2 * half_sweep)


def polygon(points):
    return [Segment(a, b) for a, b in zip(points, points[1:] + points[:1])]


def circle(centre, radius, angle=0.0):
    return [arc(centre, radius, angle, 2 * math.pi)]


def slot(a, b, width):
    """Returns two lines and two half circles around the line from a to b, counter-clockwise."""
    side = unit(b - a) * 1j * width / 2
    return [Segment(a - side, b - side), bulge_segment(b - side, b + side, 1),
            Segment(b + side, a + side), bulge_segment(a + side, a - side, 1)]


def curved_slot(centre, radius, width, angle, sweep):
    """Returns a slot that is bent around `centre`: two concentric arcs and two half circles, counter-clockwise."""
    outer = arc(centre, radius + width / 2, angle, sweep)
    inner = arc(centre, radius - width / 2, angle + sweep, -sweep)
    return [outer, bulge_segment(outer.end, inner.start, 1), inner, bulge_segment(inner.end, outer.start, 1)]


def rounded_polygon(corners):
    """Returns the polygon of (point, radius) corners. A tangent arc rounds each corner; a corner with radius 0 stays.
    """
    bends = [bend(corners[i - 1][0], corners[i][0], corners[(i + 1) % len(corners)][0], corners[i][1])
             for i in range(len(corners))]
    path = []
    for i, (entry, exit_, centre, sweep) in enumerate(bends):
        if centre is not None:
            path.append(Segment(entry, exit_, centre, sweep))
        following = bends[(i + 1) % len(bends)][0]
        if abs(following - exit_) > 1e-9:
            path.append(Segment(exit_, following))
    return path


def bend(before, corner, after, radius):
    """Returns entry, exit, centre and sweep of the arc that rounds one corner."""
    incoming, outgoing = unit(corner - before), unit(after - corner)
    turn = cmath.phase(outgoing / incoming)
    if radius == 0 or abs(turn) < 1e-9:
        return corner, corner, None, 0
    set_back = radius * math.tan(abs(turn) / 2)
    entry = corner - incoming * set_back
    centre = entry + incoming * 1j * math.copysign(radius, turn)
    return entry, corner + outgoing * set_back, centre, turn


def signed_area(path):
    """Returns the exact area of a closed path, positive if the path runs counter-clockwise."""
    area = 0.0
    for s in path:
        area += cross(s.start, s.end) / 2
        if s.centre is not None:
            area += s.radius ** 2 * (s.sweep - math.sin(s.sweep)) / 2
    return area


def oriented(path, counter_clockwise):
    return path if (signed_area(path) > 0) == counter_clockwise else reverse(path)


def begin_on_longest(path):
    """Returns the same closed path, beginning in the middle of its longest segment, where a lead-in damages no corner.
    """
    if len(path) == 1:
        return path
    i = max(range(len(path)), key=lambda k: path[k].length)
    return [path[i].part(0.5, 1)] + path[i + 1:] + path[:i] + [path[i].part(0, 0.5)]


def join_arcs(path):
    """Joins neighbouring arcs of one circle to one arc. Thus a circle that was drawn as two halves becomes one block.
    """
    joined = [path[0]]
    for s in path[1:]:
        last = joined[-1]
        same = (s.centre is not None and last.centre is not None and abs(s.centre - last.centre) < 1e-4
                and s.sweep * last.sweep > 0 and abs(s.sweep + last.sweep) < 2 * math.pi + 1e-9)
        if same:
            joined[-1] = Segment(last.start, s.end, last.centre, last.sweep + s.sweep)
        else:
            joined.append(s)
    return joined


def box(paths, samples=64):
    """Returns the lower left and the upper right corner of the box around paths. Arcs are sampled."""
    points = [s.point(i / samples) for path in paths for s in path for i in range(samples + 1)]
    xs, ys = [p.real for p in points], [p.imag for p in points]
    return complex(min(xs), min(ys)), complex(max(xs), max(ys))
