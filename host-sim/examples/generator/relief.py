"""Writes relief_inkscape.nc: contour lines of a volcano as thousands of short lines, in the style of Inkscape's
gcodetools.

The height map is interpolated (Catmull-Rom), traced by marching squares, and resampled to nearly equal steps.
"""
import json

from .cutting import nearest_order
from .geometry import Segment
from .writer import Dialect, Writer

INKSCAPE = Dialect(lower_case=True, leading_zero=False, two_digits=True, modal_motion=True, line_end="\r\n")
WIDTH_MM = 150.0
PLACE = 20 + 20j
REFINE = 6                      # number of cells of the traced grid per cell of the map
STEP_MM = 0.2                   # distance between points, as surface CAM writes them at a tolerance of some micrometres
SHORTEST_MM = 3.0               # length below which contours are dropped
LEVELS_M = range(98, 194, 8)
FEED = 2400


def program(data_folder):
    heights, cell_mm = refined_map(data_folder / "volcano.json")
    writer = Writer(INKSCAPE)
    writer.raw("%", "(Header)", "(in the style of gcodetools for Inkscape, by host-sim/examples/make_examples.py)",
               "(Header end.)", "g21 (All units in mm)", "g90 g17 g54", "m4 s0", "")
    position = 0
    for level in LEVELS_M:
        lines = [resampled(line) for line in trace(heights, cell_mm, level) if span(line) > SHORTEST_MM]
        for number, line in enumerate(nearest_order([as_path(line) for line in lines], position), 1):
            engrave(writer, line, level, number)
            position = line[-1].end
    writer.raw("", "(Footer)", "m5", "g00 x0.0000 y0.0000", "m2", "%")
    return writer.text()


def engrave(writer, path, level, number):
    writer.comment(f"Start cutting path id: H\u00f6henlinie {level} m, {number}")
    writer.rapid(path[0].start)
    writer.follow(path, S=100 + 4 * (level - LEVELS_M.start), F=FEED)


def as_path(points):
    return [Segment(p, q) for p, q in zip(points, points[1:])]


def span(points):
    return sum(abs(q - p) for p, q in zip(points, points[1:]))


def resampled(points):
    """Returns the polyline divided into equal steps of its length, about STEP_MM."""
    count = round(span(points) / STEP_MM)
    step = span(points) / count
    result, travelled, target = [points[0]], 0.0, step
    for p, q in zip(points, points[1:]):
        piece = abs(q - p)
        while len(result) < count and travelled + piece >= target:
            result.append(p + (q - p) * (target - travelled) / piece)
            target += step
        travelled += piece
    return result + [points[-1]]


# -- height map --------------------------------------------------------------------------------------------------------


def refined_map(path):
    """Returns the rows of heights from the bottom up, and the size of a cell in mm."""
    with open(path, encoding="utf-8") as file:
        data = json.load(file)
    width = data["width"]
    rows = [data["values"][i * width:(i + 1) * width] for i in reversed(range(data["height"]))]
    for _ in range(2):          # the map is rounded to full metres: smooth its terraces along both axes
        rows = transposed([smoothed(row) for row in rows])
    for _ in range(2):
        rows = transposed([interpolated(row) for row in rows])
    return rows, WIDTH_MM / (width - 1) / REFINE


def transposed(rows):
    return [list(column) for column in zip(*rows)]


def smoothed(row):
    """Returns a row after the binomial filter 1 4 6 4 1. Beyond the ends, the end values are repeated."""
    padded = [row[0]] * 2 + row + [row[-1]] * 2
    weights = (1, 4, 6, 4, 1)
    return [sum(w * padded[i + k] for k, w in enumerate(weights)) / 16 for i in range(len(row))]


def interpolated(row):
    """Returns REFINE values for each step of the row, interpolated by Catmull-Rom splines. Beyond the ends, the end
    values are repeated."""
    padded = [row[0]] + row + [row[-1]]
    fine = []
    for a, b, c, d in zip(padded, padded[1:], padded[2:], padded[3:]):
        for t in (i / REFINE for i in range(REFINE)):
            fine.append(b + t / 2 * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a))))
    return fine + [row[-1]]


# -- marching squares --------------------------------------------------------------------------------------------------


def trace(heights, cell_mm, level):
    """Returns the polylines at the height `level`, as lists of points on the table, in a fixed order."""
    links, points = {}, {}
    for y in range(len(heights) - 1):
        low, high = heights[y], heights[y + 1]
        for x in range(len(low) - 1):
            corners = (low[x], low[x + 1], high[x + 1], high[x])
            if min(corners) < level <= max(corners):
                for ends in crossings(x, y, corners, level):
                    link(links, *ends)
                    points.update((end, place(heights, cell_mm, level, end)) for end in ends)
    return [[points[key] for key in chain] for chain in chains(links)]


def crossings(x, y, corners, level):
    """Returns pairs of crossed edges of a cell. An edge leads from a grid point to the right (x, y, 0) or upward (x, y,
    1).
    """
    edges = ((x, y, 0), (x + 1, y, 1), (x, y + 1, 0), (x, y, 1))
    above = [corner >= level for corner in corners]
    crossed = [edge for i, edge in enumerate(edges) if above[i] != above[(i + 1) % 4]]
    if len(crossed) == 4 and (sum(corners) / 4 >= level) != above[0]:      # saddle: the mean height decides
        return [(crossed[3], crossed[0]), (crossed[1], crossed[2])]
    return [tuple(crossed[i:i + 2]) for i in range(0, len(crossed), 2)]


def place(heights, cell_mm, level, edge):
    x, y, upward = edge
    a = heights[y][x]
    b = heights[y + 1][x] if upward else heights[y][x + 1]
    t = (level - a) / (b - a)
    return PLACE + cell_mm * (complex(x, y + t) if upward else complex(x + t, y))


def link(links, a, b):
    links.setdefault(a, []).append(b)
    links.setdefault(b, []).append(a)


def chains(links):
    """Yields chains of linked edges of the grid: first open chains from the border, then rings. Each edge is used once.
    """
    used = set()
    for start in sorted(links, key=lambda key: (len(links[key]), key)):
        if start in used:
            continue
        chain, key = [start], start
        used.add(start)
        while True:
            following = [k for k in links[key] if k not in used]
            if not following:
                break
            key = following[0]
            used.add(key)
            chain.append(key)
        if len(links[start]) == 2:
            chain.append(start)
        yield chain
