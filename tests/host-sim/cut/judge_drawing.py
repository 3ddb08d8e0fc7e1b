"""Reads a drawing for judge_cuts.py and returns its curves and the parts that they enclose.

Shares no code with the program. svgelements reads SVG and ezdxf reads DXF. Coordinates are complex numbers in mm,
with y upwards.
"""
import io
import itertools
import math
import pathlib
import re
from collections.abc import Iterator

import numpy
import shapely
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import polygonize, unary_union
from shapely.strtree import STRtree

CHORD_MM = 0.0005
MM_PER_PX = 25.4 / 96
MIN_MM2, MIN_WIDTH_MM = 0.02, 0.01
NEEDLE_MM = 0.005
MEETING_MM, CERTAIN_GAP_MM = 0.01, 0.2
NEARLY_CLOSED_MM, NEARLY_CLOSED_SHARE = 0.5, 0.02


class Row(list):
    """Points along a curve, and the number of its shape if that shape is filled by the rule nonzero."""

    shape = None


def rows_of(file: pathlib.Path) -> list:
    """Returns the curves of a drawing that are seen, as rows of points; rows that meet are joined."""
    return rows_of_svg(file) if file.suffix.lower() == ".svg" else rows_of_dxf(file)


def points_of_segment(segment) -> list:
    """Returns points along a segment of svgelements, without its start, within the chord error."""
    if type(segment).__name__ in ("Line", "Close"):
        return [complex(segment.end.x, segment.end.y)]
    rough = numpy.array(segment.npoint(numpy.linspace(0, 1, 17)))
    length = numpy.sum(numpy.hypot(*numpy.diff(rough, axis=0).T))
    count = max(4, min(800, math.ceil(math.sqrt(length) / math.sqrt(8 * CHORD_MM) * 2)))
    return [complex(x, y) for x, y in segment.npoint(numpy.arange(1, count + 1) / count)]


def rows_of_svg(file: pathlib.Path) -> list:
    """Returns the subpaths of all shapes that have a visible stroke or fill."""
    import svgelements  # pylint: disable=import-outside-toplevel
    # The region of flowing text is not drawn.
    text = re.sub(rb"<flowRoot\b.*?</flowRoot>", b"", file.read_bytes(), flags=re.S)
    document = svgelements.SVG.parse(io.BytesIO(text), reify=True, ppi=96)
    rows = []
    for number, shape in enumerate(document.elements()):
        if not isinstance(shape, svgelements.Shape) or shape.values.get("display") == "none":
            continue
        if not any(is_seen(paint) for paint in (shape.stroke, shape.fill)):
            continue
        for segment in abs(svgelements.Path(shape)).segments():
            if type(segment).__name__ == "Move":
                rows.append(Row([complex(segment.end.x, segment.end.y)]))
                if is_seen(shape.fill) and shape.values.get("fill-rule", "nonzero") == "nonzero":
                    rows[-1].shape = number
            elif segment.start is not None and segment.end is not None:
                rows[-1] += points_of_segment(segment)
    height = float(document.height)
    for row in rows:
        row[:] = [MM_PER_PX * complex(p.real, height - p.imag) for p in row]
    rows = [row for row in rows if len(row) > 1]
    closed = [row for row in rows if is_closed(row)]
    return closed + joined(joined([row for row in rows if not is_closed(row)], MEETING_MM), CERTAIN_GAP_MM)


def is_seen(paint) -> bool:
    return paint is not None and paint.value is not None and paint.alpha != 0


def rows_of_dxf(file: pathlib.Path) -> list:
    """Returns the curves of the model space."""
    from ezdxf import disassemble, recover, units  # pylint: disable=import-outside-toplevel
    document, _ = recover.readfile(str(file))  # Reads coordinates in any order, too.
    unit = document.header.get("$INSUNITS", 0)
    factor = units.conversion_factor(unit, units.MM) if unit else 1.0
    pieces = []
    for entity in disassemble.to_primitives(disassemble.recursive_decompose(document.modelspace())):
        if entity.path is None:
            continue
        points = [complex(v.x, v.y) * factor for v in entity.path.flattening(CHORD_MM / factor)]
        if len(points) > 1:
            pieces.append(points)
    return joined(joined(pieces, MEETING_MM), CERTAIN_GAP_MM)


def joined(pieces: list, gap_mm: float) -> list:
    """Returns rows made of pieces whose ends meet within `gap_mm`."""
    rows, left = [], pieces[:]
    while left:
        row = left.pop()
        grown = True
        while grown and abs(row[0] - row[-1]) > gap_mm:
            grown = False
            for i, piece in enumerate(left):
                if abs(piece[0] - row[-1]) <= gap_mm or abs(piece[-1] - row[-1]) <= gap_mm:
                    row = row + (piece if abs(piece[0] - row[-1]) <= gap_mm else piece[::-1])
                    del left[i]
                    grown = True
                    break
        rows.append(row)
    return rows


def is_closed(row: list) -> bool:
    """Returns whether the ends of a row meet, or nearly meet compared with its length."""
    apart = abs(row[0] - row[-1])
    length = sum(abs(b - a) for a, b in zip(row, row[1:]))
    return apart <= 0.01 or (apart <= NEARLY_CLOSED_MM and apart <= NEARLY_CLOSED_SHARE * length)


def line(row: list) -> LineString:
    return LineString([(p.real, p.imag) for p in row])


def closed_rings(rows: list) -> list:
    """Returns the closed rows, with the start repeated at the end, each curve once."""
    return without_copies([ring_of(row) for row in rows if is_closed(row)])


def ring_of(row: list) -> Row:
    ring = Row(list(row) + [row[0]])
    ring.shape = getattr(row, "shape", None)
    return ring


def without_copies(rows: list) -> list:
    """Returns the rows that do not lie within 10 um of an earlier one."""
    kept, known = [], {}
    for row in rows:
        one = line(row)
        key = tuple(round(bound) for bound in one.bounds)
        near = itertools.product(*((bound - 1, bound, bound + 1) for bound in key))
        if not any(one.hausdorff_distance(other) < 0.01 for place in near for other in known.get(place, ())):
            kept.append(row)
            known.setdefault(key, []).append(one)
    return kept


def parts_of(rows: list, kerf: float) -> list:
    """Returns polygons of the area that the closed rows fill, without specks, needles and small loops."""
    return cleaned(filled_parts(rows), kerf)


def filled_parts(rows: list) -> list:
    """Returns polygons of the area that the closed rows fill, exactly as drawn."""
    return polygons_of(unary_union(filled_faces(closed_rings(rows))))


def cleaned(parts: list, kerf: float) -> list:
    """Returns parts without specks, needles and small loops."""
    parts = [slim for part in without_specks(parts) for slim in without_needles(part)]
    parts = [whole for part in without_specks(parts) for whole in polygons_of(without_small_loops(part, kerf))]
    return without_specks(parts)  # A filled loop may leave hairlines along its edge.


def filled_faces(closed: list) -> list:
    """Returns the faces between closed rows that are inside by even-odd, or by the fill rule of a filled shape."""
    faces = list(polygonize(unary_union([line(row) for row in closed])))
    around = [Polygon(line(row)) for row in closed]
    tree = STRtree(around)
    number = {id(polygon): i for i, polygon in enumerate(around)}
    arrays = [numpy.array(row) for row in closed]
    inside = []
    for face in faces:
        place = face.representative_point()
        numbers = [number[id(p)] for p in tree.query(place)]
        shapes = {}
        for i in numbers:
            shapes.setdefault(closed[i].shape, []).append(turns_round(arrays[i], place))
        filled = sum(sum(turns) != 0 for shape, turns in shapes.items() if shape is not None)
        if (filled + sum(shapes.get(None, []))) % 2:
            inside.append(face)
    return inside


def turns_round(row: numpy.ndarray, place: Point) -> int:
    """Returns how many times a closed row goes around a point, positive to the left."""
    crossing = numpy.flatnonzero((row.imag[:-1] > place.y) != (row.imag[1:] > place.y))
    a, b = row[crossing], row[crossing + 1]
    right = place.x < a.real + (place.y - a.imag) * (b.real - a.real) / (b.imag - a.imag)
    return int(numpy.sum(numpy.where(b.imag > a.imag, 1, -1)[right]))


def polygons_of(shape) -> list:
    return [one for one in getattr(shape, "geoms", [shape]) if not one.is_empty and isinstance(one, Polygon)]


def is_worth(ring) -> bool:
    area = abs(Polygon(ring).area)
    return area >= MIN_MM2 and 2 * area / ring.length >= MIN_WIDTH_MM


def without_specks(parts: list) -> list:
    """Returns the parts that are large enough to count, with the holes that are.

    A loop that touches a contour at one point is a part or a hole of its own here. It must be left out before
    `without_needles` offsets the part: the offset opens the point into a channel, and the loop becomes a bay.
    """
    return [Polygon(part.exterior, [ring for ring in part.interiors if is_worth(ring)])
            for part in parts if is_worth(part.exterior)]


def without_needles(part: Polygon) -> list:
    """Returns a part without points, and without slits, that are narrower than NEEDLE_MM."""
    mitre = {"join_style": 2, "mitre_limit": 10}
    half = NEEDLE_MM / 2
    return polygons_of(part.buffer(-half, **mitre).buffer(2 * half, **mitre).buffer(-half, **mitre))


def without_small_loops(part: Polygon, kerf: float):
    """Returns a part in which the small loops of the waste around it and in its holes are filled."""
    loops = [loop for ring in part.interiors for loop in small_loops(Polygon(ring), kerf)]
    frame = shapely.geometry.box(*part.bounds).buffer(1, join_style=2)
    loops += small_loops(frame.difference(Polygon(part.exterior)), kerf)
    return unary_union([part, *loops]) if loops else part


def small_loops(waste: Polygon, kerf: float) -> Iterator:
    """Yields the regions of less than MIN_MM2 that hang on the waste by a neck narrower than the kerf.

    A neck of the width w divides the waste when w is taken off it. The largest piece is the waste itself. A loop is at
    least twice as wide as its neck. A notch that is as wide at its mouth as inside is therefore no loop, and no more is
    a slit of uneven width.
    """
    width = NEEDLE_MM
    while width < min(kerf, math.sqrt(MIN_MM2)):
        pieces = polygons_of(waste.buffer(-width / 2))
        for piece in sorted(pieces, key=lambda one: one.area)[:-1]:
            loop = piece.buffer(width / 2).intersection(waste)
            if loop.area < MIN_MM2 and not piece.buffer(-width / 2).is_empty:
                yield loop
        width *= math.sqrt(2)
