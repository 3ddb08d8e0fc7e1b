"""Compares the path of the beam with the parts of a drawing, for judge_cuts.py."""
import cmath
import math
import re

from shapely.geometry import LineString, Point, Polygon
from shapely.prepared import prep
from shapely.strtree import STRtree

from judge_drawing import CHORD_MM, closed_rings, is_closed, line, parts_of

SLACK_MM = 0.005
TOUCHES_MM = 0.012
EVERY_MM, FINELY_MM = 0.4, 0.05
MIN_RUN = 4  # Consecutive points that two cuts share where they only cross.


def points_of_arc(start: complex, end: complex, centre: complex, left: bool) -> list:
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
            rows[-1] += points_of_arc(place, end, centre, motion == 3)
        place = end
    return [row for row in rows if len(row) > 1]


def strokes_of(rows: list) -> list:
    """Returns short line strings, which suit a tree, each with the number of its row."""
    strokes = []
    for i, row in enumerate(rows):
        for k in range(0, len(row) - 1, 16):
            strokes.append((i, line(row[k:k + 17])))
    return [(i, stroke) for i, stroke in strokes if stroke.length > 0]


def strokes_of_lines(lines: list) -> list:
    return [stroke for _, stroke in strokes_of([[complex(*c) for c in one.coords] for one in lines])]


def points_along(one: LineString, every_mm: float = EVERY_MM) -> list:
    count = max(1, int(one.length / every_mm))
    return [one.interpolate((k + 0.5) / count, normalized=True) for k in range(count)]


class Nearest:
    """Distances to many lines."""

    def __init__(self, lines: list) -> None:
        self.tree = STRtree(lines) if lines else None

    def of(self, place: Point) -> float:
        return place.distance(self.tree.nearest(place)) if self.tree else math.inf


class Inside:
    """Whether points lie in any of the parts."""

    def __init__(self, parts: list) -> None:
        self.tree = STRtree(parts) if parts else None
        self.prepared = {id(part): prep(part) for part in parts}

    def has(self, place: Point) -> bool:
        return self.tree is not None and any(self.prepared[id(part)].contains(place)
                                             for part in self.tree.query(place))


class Shapes:
    """Counts the edges of parts and holes, and those that are cut as they are drawn."""

    def __init__(self, count: int = 0, right: int = 0) -> None:
        self.count, self.right = count, right

    def add(self, other: "Shapes") -> None:
        self.count += other.count
        self.right += other.right

    def take(self, rings: list, near_cuts: Nearest, kerf: float, gouged: list) -> None:
        too_near = STRtree(gouged) if gouged else None
        for ring in rings:
            places = points_along(LineString(ring.coords))
            reached = sum(near_cuts.of(place) <= kerf + SLACK_MM for place in places)
            is_gouged = too_near is not None and any(
                place.distance(ring) < kerf / 2 for place in too_near.query(ring.buffer(kerf)))
            self.count += 1
            self.right += reached >= 0.95 * len(places) and not is_gouged


class SharedLines:
    """Lines along which two contours with parts on both sides lie against each other, and where they touch."""

    def __init__(self, rows: list, parts: list, inside: Inside) -> None:
        common = self.common_of([line(row) for row in closed_rings(rows)])
        edges = [LineString(ring.coords) for ring in rings_of(parts)]
        pieces = [one for one in common if one.length > 0.05 and self.is_between(one, inside)]
        self.pieces = strokes_of_lines(pieces)
        self.lines, self.touching = Nearest(self.pieces), Nearest(common + self.common_of(edges))

    @staticmethod
    def common_of(rings: list) -> list:
        """Returns the lines of rings that are within TOUCHES_MM of a later ring."""
        tree, number, found = STRtree(rings), {id(ring): i for i, ring in enumerate(rings)}, []
        for i, ring in enumerate(rings):
            for other in tree.query(ring.buffer(TOUCHES_MM)):
                if number[id(other)] <= i:
                    continue
                common = ring.intersection(other.buffer(TOUCHES_MM))
                found += [one for one in getattr(common, "geoms", [common]) if not one.is_empty and one.length > 0]
        return found

    @staticmethod
    def is_between(piece: LineString, inside: Inside) -> bool:
        middle, next_place = (piece.interpolate(0.5 * piece.length + d) for d in (0, 0.001))
        way = complex(next_place.x - middle.x, next_place.y - middle.y)
        off = 1j * way / abs(way) * 0.03
        return inside.has(Point(middle.x + off.real, middle.y + off.imag)) and inside.has(
            Point(middle.x - off.real, middle.y - off.imag))

    def allow(self, place: Point, apart: float, kerf: float) -> bool:
        if self.lines.of(place) <= SLACK_MM + TOUCHES_MM:
            return True
        return apart >= -TOUCHES_MM and self.touching.of(place) <= 2 * kerf

    def uncut(self, near_cuts: Nearest) -> list:
        places = [place for piece in self.pieces for place in points_along(piece, FINELY_MM)]
        return [place for place in places if near_cuts.of(place) > SLACK_MM + TOUCHES_MM]


def rings_of(parts: list) -> list:
    return [ring for part in parts for ring in [part.exterior, *part.interiors]]


def place_text(place: Point) -> str:
    return f"{place.x:.3f} {place.y:.3f}"


def judged(rows: list, program: str, told: str, shapes: Shapes, options: list) -> str:
    """Returns the faults of a program, or an empty text, and counts the shapes.

    `rows` are the curves of the drawing, `told` is the text that the program printed.
    """
    narrow = float(options[options.index("--narrow") + 1]) if "--narrow" in options else 0.0
    kerf = float(re.search(r"kerf ([\d.]+) mm", program)[1])
    parts = parts_of(rows, kerf)
    rings, inside = rings_of(parts), Inside(parts)
    edges, cuts = strokes_of_lines(rings), strokes_of(beam_rows(program))
    near_cuts = Nearest([stroke for _, stroke in cuts])
    shared = SharedLines(rows, parts, inside) if "--common-line" in options and parts else None

    open_lines = Nearest([stroke for _, stroke in strokes_of([row for row in rows if not is_closed(row)])])
    gouged = too_near(cuts, kerf, kerf / 2 - narrow - SLACK_MM, Nearest(edges), inside, open_lines, shared)
    shapes.take(rings, near_cuts, kerf, [place for _, place in gouged])
    complaints = []
    if gouged:
        apart, place = min(gouged, key=lambda one: one[0])
        complaints.append(f"{len(gouged)} places too near, {apart:.4f} mm at {place_text(place)}")
    between = shared.uncut(near_cuts) if shared else []
    if between:
        complaints.append(f"{len(between)} places between parts uncut, as at {place_text(between[0])}")
    missing, uncut = uncut_length(edges, near_cuts, kerf)
    listed = listed_length(told, rings, kerf)
    if missing > 1.2 * listed + 1:
        complaints.append(f"{missing:.1f} mm uncut, {listed:.1f} listed, as at {place_text(uncut[0])}")
    twice = cut_twice(cuts)
    if twice > 1:
        complaints.append(f"{twice:.1f} mm cut twice")
    return "; ".join(complaints)


def too_near(cuts: list, kerf: float, min_mm: float, edges: Nearest, inside: Inside, open_lines: Nearest,
             shared: SharedLines) -> list:
    """Returns (distance, point) of the points of cuts that are nearer to a part than `min_mm`; < 0 is in a part."""
    found = []
    for _, stroke in cuts:
        for place in points_along(stroke):
            apart = -edges.of(place) if inside.has(place) else edges.of(place)
            if shared and shared.allow(place, apart, kerf):
                continue
            if apart < min_mm and open_lines.of(place) > SLACK_MM + 0.01:
                found.append((apart, place))
    return found


def uncut_length(edges: list, near_cuts: Nearest, kerf: float) -> tuple:
    """Returns the length of edges without a path beside them, and points on them."""
    uncut, missing = [], 0.0
    for edge in edges:
        if all(near_cuts.of(place) <= kerf + SLACK_MM for place in points_along(edge)):
            continue
        finely = points_along(edge, FINELY_MM)
        without = [place for place in finely if near_cuts.of(place) > kerf + SLACK_MM]
        uncut += without
        missing += edge.length * len(without) / len(finely)
    return missing, uncut


def listed_length(told: str, rings: list, kerf: float) -> float:
    """Returns the length of edges that the program's own warnings list as uncut."""
    listed = sum(float(mm) for mm in re.findall(r"([\d.]+) mm of it stay uncut", told))
    if "would vanish" in told:
        listed += sum(ring.length for ring in rings if Polygon(ring).buffer(-kerf / 2).is_empty)
    return listed


def cut_twice(cuts: list) -> float:
    """Returns the length along which two cuts are within 10 um of each other, without mere crossings."""
    tree = STRtree([stroke for _, stroke in cuts]) if cuts else None
    owner = {id(stroke): i for i, stroke in cuts}
    length = 0.0
    for i, stroke in cuts:
        places, run = points_along(stroke, FINELY_MM), 0
        for place in places:
            around = LineString([(place.x - 0.01, place.y - 0.01), (place.x + 0.01, place.y + 0.01)])
            is_shared = any(owner[id(other)] > i and other.distance(place) < 0.01 for other in tree.query(around))
            run = run + 1 if is_shared else 0
            if run > MIN_RUN:
                length += stroke.length / len(places)
    return length
