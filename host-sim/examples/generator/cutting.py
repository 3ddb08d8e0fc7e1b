"""Prepares closed contours for cutting with a beam: side, lead-in, lead-out and order."""
import cmath
import math

from .geometry import Segment, begin_on_longest, oriented

LEAD_OUT_SWEEP = math.pi / 4


def with_leads(contour, is_hole, radius):
    """Returns lead-in, contour and lead-out.

    The contour is oriented so that the waste is to the left of the motion: holes run counter-clockwise, outlines
    clockwise. Both leads are arcs in the waste, tangent to the contour.
    """
    path = begin_on_longest(oriented(contour, is_hole))
    return [lead_in(path[0], radius)] + path + [lead_out(path[-1], radius)]


def lead_in(segment, radius):
    """Returns a quarter turn that ends at the start of the segment."""
    centre = segment.start + radius * 1j * segment.tangent(0)
    start = centre + (segment.start - centre) * cmath.rect(1, -math.pi / 2)
    return Segment(start, segment.start, centre, math.pi / 2)


def lead_out(segment, radius):
    """Returns an eighth of a turn that begins at the end of the segment."""
    centre = segment.end + radius * 1j * segment.tangent(1)
    end = centre + (segment.end - centre) * cmath.rect(1, LEAD_OUT_SWEEP)
    return Segment(segment.end, end, centre, LEAD_OUT_SWEEP)


def nearest_order(paths, position):
    """Returns the paths in greedy order: the next path is always the one whose start is nearest."""
    remaining, ordered = list(paths), []
    while remaining:
        nearest = min(remaining, key=lambda path: abs(path[0].start - position))
        remaining.remove(nearest)
        ordered.append(nearest)
        position = nearest[-1].end
    return ordered
