"""Judges the programs that `kerfline cut` makes of a folder of drawings, by independent geometry.

usage: judge_cuts.py KERFLINE FOLDER [--only PATTERN] OPTION_OF_CUT …

Not part of the test suite: it accepts any folder of drawings. svgelements or ezdxf reads each drawing independently
of kerfline. shapely fills its closed contours by the even-odd rule, or by the fill rule of a filled shape. For each
program that is written, the judge checks

* that no path of the beam runs across a part, or is nearer to it than half the kerf less 5 um, or less the distance
  that the option --narrow allows;
* that each edge of a part has a path along it, or is listed by the program's warnings;
* that no two cuts run along the same line;
* with the option --common-line, that each line along which two parts touch is cut once, along this line. At its ends,
  and where parts touch at a corner, a path may be nearer than half the kerf over a length of two kerfs, but nowhere
  within a part.

The judge ignores parts and holes of less than 0.02 mm2 or 0.01 mm mean width, spikes and slits less than 5 um wide,
and open lines that are cut as lines. It prints a line for each drawing, and the sums of drawings and of closed shapes,
which are edges of parts and holes. A shape is cut as drawn if no path is too near to it and 95 % of it have a path
along it. With the option --anyway of `cut`, shapes of refused drawings count, too. The exit status is 1 if a drawing is
wrong.
"""
import cmath
import fnmatch
import io
import itertools
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy
import shapely
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import polygonize, unary_union
from shapely.prepared import prep
from shapely.strtree import STRtree

CHORD_MM = 0.0005
MM_PER_PX = 25.4 / 96
SLACK_MM = 0.005
LEAST_MM2, LEAST_WIDTH_MM = 0.02, 0.01
NEEDLE_MM = 0.005
TOUCHES_MM = 0.012
EVERY_MM, FINELY_MM = 0.4, 0.05
LEAST_RUN = 4  # Places that two cuts share where they cross.
MEETING_MM, CERTAIN_GAP_MM = 0.01, 0.2
NEARLY_CLOSED_MM, NEARLY_CLOSED_SHARE = 0.5, 0.02
SECONDS = 300


class Row(list):
    """Points of a path in order; if its shape is filled by the rule nonzero, also that shape."""

    shape = None


def curve(segment) -> list:
    """Returns points along a segment of svgelements, without its start, within the chord error."""
    if type(segment).__name__ in ("Line", "Close"):
        return [complex(segment.end.x, segment.end.y)]
    length = segment.length(error=1e-3)
    count = max(4, min(800, math.ceil(math.sqrt(length) / math.sqrt(8 * CHORD_MM) * 2)))
    return [complex(segment.point(i / count).x, segment.point(i / count).y) for i in range(1, count + 1)]


def rows_of_svg(file: pathlib.Path) -> list:
    """Returns the subpaths of all visible shapes, in mm, y upwards."""
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
                rows[-1] += curve(segment)
    height = float(document.height)
    for row in rows:
        row[:] = [MM_PER_PX * complex(p.real, height - p.imag) for p in row]
    rows = [row for row in rows if len(row) > 1]
    closed = [row for row in rows if is_closed(row)]
    return closed + joined(joined([row for row in rows if not is_closed(row)], MEETING_MM), CERTAIN_GAP_MM)


def is_seen(paint) -> bool:
    return paint is not None and paint.value is not None and paint.alpha != 0


def rows_of_dxf(file: pathlib.Path) -> list:
    """Returns the entities of the model space that are curves, in mm, joined."""
    from ezdxf import disassemble, recover, units  # pylint: disable=import-outside-toplevel
    document, _ = recover.readfile(str(file))  # Coordinates in any order, too.
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
    """Returns rows of pieces whose ends meet within a gap."""
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
    """Returns whether the ends of a row meet exactly, or nearly in comparison with its length."""
    apart = abs(row[0] - row[-1])
    length = sum(abs(b - a) for a, b in zip(row, row[1:]))
    return apart <= 0.01 or (apart <= NEARLY_CLOSED_MM and apart <= NEARLY_CLOSED_SHARE * length)


def line(row: list) -> LineString:
    return LineString([(p.real, p.imag) for p in row])


def without_copies(rows: list) -> list:
    """Returns the rows without those that repeat an earlier row within 10 um."""
    kept, known = [], {}
    for row in rows:
        one = line(row)
        key = tuple(round(bound) for bound in one.bounds)
        near = itertools.product(*((bound - 1, bound, bound + 1) for bound in key))
        if not any(one.hausdorff_distance(other) < 0.01 for place in near for other in known.get(place, ())):
            kept.append(row)
            known.setdefault(key, []).append(one)
    return kept


def without_needles(part: Polygon) -> list:
    """Returns a part without spikes and slits that are narrower than NEEDLE_MM."""
    mitre = {"join_style": 2, "mitre_limit": 10}
    half = NEEDLE_MM / 2
    slim = part.buffer(-half, **mitre).buffer(2 * half, **mitre).buffer(-half, **mitre)
    return [one for one in getattr(slim, "geoms", [slim]) if not one.is_empty and is_worth(one.exterior)]


def is_worth(ring) -> bool:
    area = abs(Polygon(ring).area)
    return area >= LEAST_MM2 and 2 * area / ring.length >= LEAST_WIDTH_MM


def parts_of(rows: list) -> list:
    """Returns polygons of the area that closed rows fill by the even-odd rule."""
    closed = without_copies([ring_of(row) for row in rows if is_closed(row)])
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
    merged = unary_union(inside)
    polygons = list(merged.geoms) if hasattr(merged, "geoms") else [merged]
    slim = [one for p in polygons if not p.is_empty for one in without_needles(p)]
    return [Polygon(p.exterior, [ring for ring in p.interiors if is_worth(ring)]) for p in slim]


def ring_of(row: list) -> Row:
    ring = Row(list(row) + [row[0]])
    ring.shape = getattr(row, "shape", None)
    return ring


def turns_round(row: numpy.ndarray, place: Point) -> int:
    """Returns how many times a closed row of complex points winds around a point, counter-clockwise."""
    crossing = numpy.flatnonzero((row.imag[:-1] > place.y) != (row.imag[1:] > place.y))
    a, b = row[crossing], row[crossing + 1]
    beside = place.x < a.real + (place.y - a.imag) * (b.real - a.real) / (b.imag - a.imag)
    return int(numpy.sum(numpy.where(b.imag > a.imag, 1, -1)[beside]))


def arc(start: complex, end: complex, centre: complex, left: bool) -> list:
    """Returns points along an arc, without its start."""
    turn = cmath.phase((end - centre) / (start - centre))
    if left and turn <= 1e-12:
        turn += 2 * math.pi
    if not left and turn >= -1e-12:
        turn -= 2 * math.pi
    radius = abs(start - centre)
    step = math.sqrt(8 * CHORD_MM / max(radius, CHORD_MM))
    count = max(2, math.ceil(abs(turn) / step))
    return [centre + (start - centre) * cmath.exp(1j * turn * i / count) for i in range(1, count)] + [end]


def beam_rows(program: str) -> list:
    """Returns the paths with the beam on, each from a rapid to the next."""
    rows, place, motion = [], 0j, 0
    for text in program.splitlines():
        text = re.sub(r"\(.*?\)|;.*", "", text)
        words = dict((letter, float(value)) for letter, value in re.findall(r"([A-Z])([-+]?[\d.]+)", text))
        for motions in re.findall(r"G(\d+)", text):
            motion = int(motions) if int(motions) in (0, 1, 2, 3) else motion
        if "X" not in words and "Y" not in words and "I" not in words:
            continue
        end = complex(words.get("X", place.real), words.get("Y", place.imag))
        if motion == 0:
            rows.append([end])
        elif motion == 1:
            rows[-1].append(end)
        else:
            centre = place + complex(words.get("I", 0.0), words.get("J", 0.0))
            rows[-1] += arc(place, end, centre, motion == 3)
        place = end
    return [row for row in rows if len(row) > 1]


def strokes_of(rows: list) -> list:
    """Returns short line strings, which a tree can separate, with the number of their row."""
    strokes = []
    for i, row in enumerate(rows):
        for k in range(0, len(row) - 1, 16):
            strokes.append((i, line(row[k:k + 17])))
    return [(i, stroke) for i, stroke in strokes if stroke.length > 0]


def places_along(one: LineString, every_mm: float = EVERY_MM) -> list:
    count = max(1, int(one.length / every_mm))
    return [one.interpolate((k + 0.5) / count, normalized=True) for k in range(count)]


class Nearest:
    """Computes distances to many lines."""

    def __init__(self, lines: list) -> None:
        self.tree = STRtree(lines) if lines else None

    def of(self, place: Point) -> float:
        return place.distance(self.tree.nearest(place)) if self.tree else math.inf


class Shapes:
    """Edges of parts and holes, and which of them are cut as drawn."""

    def __init__(self) -> None:
        self.count = self.right = 0

    def take(self, rings: list, near_cuts: Nearest, kerf: float, gouged: list) -> None:
        too_near = STRtree(gouged) if gouged else None
        for ring in rings:
            places = places_along(LineString(ring.coords))
            beside = sum(near_cuts.of(place) <= kerf + SLACK_MM for place in places)
            is_gouged = too_near is not None and any(
                place.distance(ring) < kerf / 2 for place in too_near.query(ring.buffer(kerf)))
            self.count += 1
            self.right += beside >= 0.95 * len(places) and not is_gouged


class SharedLines:
    """Lines along which two contours with parts on both sides touch, and points where they touch."""

    def __init__(self, rows: list, parts: list) -> None:
        rings = [line(row) for row in without_copies([ring_of(row) for row in rows if is_closed(row)])]
        inside, prepared = STRtree(parts), {id(part): prep(part) for part in parts}

        def has_part(place: Point) -> bool:
            return any(prepared[id(part)].contains(place) for part in inside.query(place))

        common = self.common_of(rings)
        edges = [LineString(ring.coords) for part in parts for ring in [part.exterior, *part.interiors]]
        pieces = [one for one in common if one.length > 0.05 and self.is_between(one, has_part)]
        touching = common + self.common_of(edges)
        self.pieces = [stroke for _, stroke in strokes_of([[complex(*c) for c in one.coords] for one in pieces])]
        self.lines, self.touching = Nearest(self.pieces), Nearest(touching)

    @staticmethod
    def common_of(rings: list) -> list:
        """Returns lines of rings that are within TOUCHES_MM of a later ring."""
        tree, number, found = STRtree(rings), {id(ring): i for i, ring in enumerate(rings)}, []
        for i, ring in enumerate(rings):
            for other in tree.query(ring.buffer(TOUCHES_MM)):
                if number[id(other)] <= i:
                    continue
                common = ring.intersection(other.buffer(TOUCHES_MM))
                found += [one for one in getattr(common, "geoms", [common]) if not one.is_empty and one.length > 0]
        return found

    @staticmethod
    def is_between(piece: LineString, has_part) -> bool:
        middle, next_place = (piece.interpolate(0.5 * piece.length + d) for d in (0, 0.001))
        way = complex(next_place.x - middle.x, next_place.y - middle.y)
        off = 1j * way / abs(way) * 0.03
        return has_part(Point(middle.x + off.real, middle.y + off.imag)) and has_part(
            Point(middle.x - off.real, middle.y - off.imag))

    def allow(self, place: Point, apart: float, kerf: float) -> bool:
        if self.lines.of(place) <= SLACK_MM + TOUCHES_MM:
            return True
        return apart >= -TOUCHES_MM and self.touching.of(place) <= 2 * kerf

    def uncut(self, near_cuts: Nearest) -> list:
        places = [place for piece in self.pieces for place in places_along(piece, FINELY_MM)]
        return [place for place in places if near_cuts.of(place) > SLACK_MM + TOUCHES_MM]


def judged(file: pathlib.Path, program: str, told: str, shapes: Shapes, options: list) -> str:
    """Returns the faults of a program, or an empty text."""
    narrow = float(options[options.index("--narrow") + 1]) if "--narrow" in options else 0.0
    nearest = -narrow - SLACK_MM
    kerf = float(re.search(r"kerf ([\d.]+) mm", program)[1])
    rows = rows_of_svg(file) if file.suffix == ".svg" else rows_of_dxf(file)
    parts = parts_of(rows)
    rings = [ring for part in parts for ring in [part.exterior, *part.interiors]]
    edges = [stroke for _, stroke in strokes_of([[complex(*c) for c in ring.coords] for ring in rings])]
    lines = [stroke for _, stroke in strokes_of([row for row in rows if not is_closed(row)])]
    cuts = strokes_of(beam_rows(program))
    near_edges, near_lines, near_cuts = Nearest(edges), Nearest(lines), Nearest([s for _, s in cuts])
    inside, prepared = STRtree(parts) if parts else None, {id(part): prep(part) for part in parts}
    shared = SharedLines(rows, parts) if "--common-line" in options and parts else None
    complaints, gouged = [], []
    worst, where = math.inf, None
    for _, stroke in cuts:
        for place in places_along(stroke):
            apart = near_edges.of(place)
            if inside and any(prepared[id(part)].contains(place) for part in inside.query(place)):
                apart = -apart
            if shared and shared.allow(place, apart, kerf):
                continue
            if apart < kerf / 2 + nearest and near_lines.of(place) > SLACK_MM + 0.01:
                gouged.append(place)
                if apart < worst:
                    worst, where = apart, place
    shapes.take(rings, near_cuts, kerf, gouged)
    if gouged:
        complaints.append(f"{len(gouged)} places too near, {worst:.4f} mm at {where.x:.3f} {where.y:.3f}")
    between = shared.uncut(near_cuts) if shared else []
    if between:
        complaints.append(f"{len(between)} places between parts uncut, as at {between[0].x:.3f} {between[0].y:.3f}")
    uncut, missing = [], 0.0
    for edge in edges:
        if all(near_cuts.of(p) <= kerf + SLACK_MM for p in places_along(edge)):
            continue
        finely = places_along(edge, FINELY_MM)
        without = [p for p in finely if near_cuts.of(p) > kerf + SLACK_MM]
        uncut += without
        missing += edge.length * len(without) / len(finely)
    listed = sum(float(mm) for mm in re.findall(r"([\d.]+) mm of it stay uncut", told))
    listed += sum(ring.length for ring in rings if "would vanish" in told and
                  Polygon(ring).buffer(-kerf / 2).is_empty)
    if missing > 1.2 * listed + 1:
        complaints.append(f"{missing:.1f} mm uncut, {listed:.1f} listed, as at {uncut[0].x:.3f} {uncut[0].y:.3f}")
    twice = cut_twice(cuts)
    if twice > 1:
        complaints.append(f"{twice:.1f} mm cut twice")
    return "; ".join(complaints)


def cut_twice(cuts: list) -> float:
    """Returns the length along which two cuts run within 10 um; crossings do not count."""
    tree = STRtree([stroke for _, stroke in cuts]) if cuts else None
    owner = {id(stroke): i for i, stroke in cuts}
    length = 0.0
    for i, stroke in cuts:
        places, run = places_along(stroke, FINELY_MM), 0
        for place in places:
            beside = LineString([(place.x - 0.01, place.y - 0.01), (place.x + 0.01, place.y + 0.01)])
            is_beside = any(owner[id(other)] > i and other.distance(place) < 0.01 for other in tree.query(beside))
            run = run + 1 if is_beside else 0
            if run > LEAST_RUN:
                length += stroke.length / len(places)
    return length


def count_uncut(file: pathlib.Path, shapes: Shapes) -> None:
    """Counts the shapes of a drawing that has no program."""
    rows = rows_of_svg(file) if file.suffix == ".svg" else rows_of_dxf(file)
    shapes.count += sum(1 + len(part.interiors) for part in parts_of(rows))


def verdict_on(kerfline: str, file: pathlib.Path, options: list, shapes: Shapes) -> tuple:
    """Returns `right`, `wrong`, `refused` or `not judged`, and the reason."""
    with tempfile.TemporaryDirectory() as scratch:
        target = pathlib.Path(scratch) / "job.nc"
        try:
            run = subprocess.run([kerfline, "cut", str(file), *options, "-o", str(target)],
                                 capture_output=True, text=True, check=False, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return "refused", f"longer than {SECONDS} s"
        try:
            complaint = judged(file, target.read_text(), run.stderr, shapes, options) if target.exists() else None
            if complaint is None:
                count_uncut(file, shapes)
        except Exception as error:  # pylint: disable=broad-except
            return "not judged", f"{type(error).__name__}: {error}"
        if run.returncode != 0:
            errors = [text for text in run.stderr.splitlines()
                      if not text.startswith(("note", "warning", "kerfline"))]
            return "refused", errors[0] if errors else run.stderr.strip()[-200:]
        return ("wrong", complaint) if complaint else ("right", "")


def main() -> int:
    kerfline, folder, options = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    pattern = "*"
    if options[:1] == ["--only"]:
        pattern, options = options[1], options[2:]
    sums, shapes = {}, Shapes()
    for file in sorted(folder.rglob("*")):
        if file.suffix.lower() not in (".svg", ".dxf") or not fnmatch.fnmatch(file.name, pattern):
            continue
        verdict, why = verdict_on(kerfline, file, options, shapes)
        sums[verdict] = sums.get(verdict, 0) + 1
        print(f"{file.relative_to(folder)}: {verdict}{': ' + why[:200] if why else ''}", flush=True)
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(sums.items())) +
          f"; {shapes.right} of {shapes.count} closed shapes as drawn; shapely {shapely.__version__}")
    return 1 if sums.get("wrong") else 0


if __name__ == "__main__":
    sys.exit(main())
