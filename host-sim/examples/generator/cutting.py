"""Cutting closed contours with a beam: side, lead-in, lead-out and order."""
import cmath
import math

from .geometry import Segment, begin_on_longest, oriented

LEAD_OUT_SWEEP = math.pi / 4


def with_leads(contour, is_hole, radius):
    """Lead-in, contour, lead-out. The contour is turned so that the waste lies on the left of travel:
    holes run counter-clockwise, outlines clockwise; both leads are arcs on the waste side, tangent to the contour.
    """
    path = begin_on_longest(oriented(contour, is_hole))
    return [lead_in(path[0], radius)] + path + [lead_out(path[-1], radius)]


def lead_in(segment, radius):
    """Quarter turn that ends at the segment's start."""
    centre = segment.start + radius * 1j * segment.tangent(0)
    start = centre + (segment.start - centre) * cmath.rect(1, -math.pi / 2)
    return Segment(start, segment.start, centre, math.pi / 2)


def lead_out(segment, radius):
    """Eighth of a turn from the segment's end."""
    centre = segment.end + radius * 1j * segment.tangent(1)
    end = centre + (segment.end - centre) * cmath.rect(1, LEAD_OUT_SWEEP)
    return Segment(segment.end, end, centre, LEAD_OUT_SWEEP)


def nearest_order(paths, position):
    """Greedy order: always the path whose start is nearest."""
    remaining, ordered = list(paths), []
    while remaining:
        nearest = min(remaining, key=lambda path: abs(path[0].start - position))
        remaining.remove(nearest)
        ordered.append(nearest)
        position = nearest[-1].end
    return ordered
