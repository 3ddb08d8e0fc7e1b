"""Writes sheet_8877.nc and its drawing: the nested parts of a real flame-cutting sheet, scaled to 9.5 %."""
import json

from .cutting import with_leads
from .drawing import svg
from .geometry import box, bulge_segment, join_arcs, moved
from .writer import Dialect, Writer

SHEET_CUTTER = Dialect(line_numbers=10)
SCALE = 0.095                   # 2653 x 1993 mm of the sheet become 252 x 190 mm
PLACE = 4 + 4j
LEAD_MM = 0.8
POWER, FEED = 900, 1200
PIERCE_S = 0.2


def contours_of(data_folder):
    """Returns a pair (path, whether it is a hole) for every contour."""
    with open(data_folder / "sheet_8877.json", encoding="utf-8") as file:
        parts = json.load(file)["parts"]
    return [(contour_path(contour), i > 0) for part in parts for i, contour in enumerate(part)]


def drawing(data_folder):
    """Returns the drawing of the same sheet for `kerfline cut`."""
    return svg(260 + 200j, [("cut", "black", [path for path, _ in contours_of(data_folder)])])


def program(data_folder):
    contours = contours_of(data_folder)
    writer = Writer(SHEET_CUTTER)
    writer.comment("SHEET 8877_01, 16 PARTS, SCALED TO 9.5 PERCENT", "MADE BY HOST-SIM/EXAMPLES/MAKE_EXAMPLES.PY")
    writer.raw("G17 G21 G54 G90", "M8")
    for number, path in enumerate(inside_first(contours), 1):
        cut(writer, number, path)
    writer.raw("M9", "G0 X0 Y0", "M30")
    return writer.text()


def contour_path(contour):
    points = [(complex(x, y), bulge) for x, y, bulge in contour]
    segments = [bulge_segment(p, q, bulge) for (p, bulge), (q, _) in zip(points, points[1:])]
    return join_arcs(moved(segments, SCALE, PLACE))


def inside_first(contours):
    """Yields paths with leads. The next path is the nearest one whose box contains no uncut contour."""
    remaining = [(box([path]), with_leads(path, is_hole, LEAD_MM)) for path, is_hole in contours]
    position = 0
    while remaining:
        free = [one for one in remaining if not any(lies_inside(other[0], one[0]) for other in remaining)]
        nearest = min(free, key=lambda one: abs(one[1][0].start - position))
        remaining.remove(nearest)
        position = nearest[1][-1].end
        yield nearest[1]


def lies_inside(inner, outer):
    return (inner != outer and outer[0].real <= inner[0].real and outer[0].imag <= inner[0].imag
            and inner[1].real <= outer[1].real and inner[1].imag <= outer[1].imag)


def cut(writer, number, path):
    """Writes rapid, pierce, contour and beam off. G1 is written before M3, because a Grbl laser stays off in G0."""
    writer.comment(f"CONTOUR {number}")
    writer.rapid(path[0].start)
    writer.raw(f"G1 F{FEED} M3 S{POWER}", f"G4 P{PIERCE_S}")
    writer.follow(path)
    writer.raw("M5")
