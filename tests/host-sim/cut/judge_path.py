"""Compares the path of the beam with the parts of a drawing, for judge_cuts.py."""
import cmath
import math
import re

import numpy
from shapely.geometry import LineString, Point, Polygon
from shapely.strtree import STRtree

from judge_distance import Inside, Nearest, samples_of, strokes_of
from judge_drawing import CHORD_MM, cleaned, closed_rings, filled_parts, is_closed, line, turns_round

SLACK_MM = 0.005
TOUCHES_MM = 0.012
EVERY_MM, FINELY_MM = 0.4, 0.05
SAME_MM = 0.01
MAX_UNLISTED_MM = 1.0
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


class Shapes:
    """Counts the edges of parts and holes, and those that are cut as they are drawn."""

    def __init__(self, count: int = 0, right: int = 0) -> None:
        self.count, self.right = count, right

    def add(self, other: "Shapes") -> None:
        self.count += other.count
        self.right += other.right

    def take(self, rings: list, near_cuts: Nearest, kerf: float, gouged: numpy.ndarray) -> None:
        for ring in rings:
            places, _, _ = samples_of([ring], EVERY_MM)
            reached = numpy.mean(near_cuts.of(places) <= kerf + SLACK_MM)
            is_gouged = len(gouged) > 0 and any(Nearest([ring], kerf / 2).of(gouged) < kerf / 2)
            self.count += 1
            self.right += bool(reached >= 0.95 and not is_gouged)


class SharedLines:
    """Lines along which two contours with parts on both sides lie against each other, and where they touch.

    Contours that run along each other with their insides on the same side cancel each other by even-odd: the program
    notes that such lines are not cut.
    """

    def __init__(self, rows: list, parts: list, inside: Inside, kerf: float) -> None:
        rings = closed_rings(rows)
        common = self.common_of([line(ring) for ring in rings])
        edges = [LineString(ring.coords) for part in parts for ring in [part.exterior, *part.interiors]]
        self.pieces = [points_of_line(one) for one, i, k in common
                       if one.length > 0.05 and self.is_between(one, rings[i], rings[k], inside)]
        self.lines = Nearest(self.pieces, SLACK_MM + TOUCHES_MM)
        self.touching = Nearest([points_of_line(one) for one, _, _ in common + self.common_of(edges)], 2 * kerf)
        self.kerf = kerf

    @staticmethod
    def common_of(rings: list) -> list:
        """Returns the lines of rings that are within TOUCHES_MM of a later ring, with the numbers of both rings."""
        tree, number, found = STRtree(rings), {id(ring): i for i, ring in enumerate(rings)}, []
        for i, ring in enumerate(rings):
            for other in tree.query(ring.buffer(TOUCHES_MM)):
                k = number[id(other)]
                if k <= i:
                    continue
                common = ring.intersection(other.buffer(TOUCHES_MM))
                found += [(one, i, k) for one in getattr(common, "geoms", [common])
                          if not one.is_empty and one.length > 0]
        return found

    @staticmethod
    def is_between(piece: LineString, one: list, other: list, inside: Inside) -> bool:
        middle, next_place = (complex(*piece.interpolate(0.5 * piece.length + d).coords[0]) for d in (0, 0.001))
        off = 1j * (next_place - middle) / abs(next_place - middle) * 0.03
        sides = [middle + off, middle - off]
        in_one, in_other = ([turns_round(numpy.array(row), Point(side.real, side.imag)) % 2 for side in sides]
                            for row in (one, other))
        return in_one != in_other and all(inside.has(numpy.array(sides)))

    def allow(self, places: numpy.ndarray, apart: numpy.ndarray) -> numpy.ndarray:
        is_along = self.lines.of(places) <= SLACK_MM + TOUCHES_MM
        return is_along | ((apart >= -TOUCHES_MM) & (self.touching.of(places) <= 2 * self.kerf))

    def uncut(self, near_cuts: Nearest) -> numpy.ndarray:
        places, _, _ = samples_of(strokes_of(self.pieces)[0], FINELY_MM)
        return places[near_cuts.of(places) > SLACK_MM + TOUCHES_MM]


def rings_of(parts: list) -> list:
    return [points_of_line(ring) for part in parts for ring in [part.exterior, *part.interiors]]


def points_of_line(one) -> numpy.ndarray:
    return numpy.array([complex(x, y) for x, y, *_ in one.coords])


def place_text(place: complex) -> str:
    return f"{place.real:.3f} {place.imag:.3f}"


def judged(rows: list, program: str, told: str, shapes: Shapes, options: list) -> str:
    """Returns the faults of a program, or an empty text, and counts the shapes.

    `rows` are the curves of the drawing, `told` is the text that the program printed.
    """
    narrow = float(options[options.index("--narrow") + 1]) if "--narrow" in options else 0.0
    kerf = float(re.search(r"kerf ([\d.]+) mm", program)[1])
    drawn, cuts = filled_parts(rows), beam_rows(program)
    parts = cleaned(drawn, kerf)
    rings = rings_of(parts)
    inside, near_cuts, near_edges = Inside(parts), Nearest(cuts, kerf + SLACK_MM), Nearest(rings, max(kerf, 1))
    shared = SharedLines(rows, parts, inside, kerf) if "--common-line" in options and parts else None
    open_lines = Nearest([row for row in rows if not is_closed(row)], SLACK_MM + 0.01)
    min_mm = kerf / 2 - narrow - SLACK_MM
    apart, gouged = too_near(cuts, min_mm, near_edges, inside, open_lines, shared)
    # A cut along a slit that is narrower than NEEDLE_MM is not within the part as drawn.
    is_wrong = signed_distance(gouged, Nearest(rings_of(drawn), max(kerf, 1)), Inside(drawn)) < min_mm
    apart, gouged = apart[is_wrong], gouged[is_wrong]
    shapes.take(rings, near_cuts, kerf, gouged)
    complaints = []
    if len(gouged):
        worst = numpy.argmin(apart)
        complaints.append(f"{len(gouged)} places too near, {apart[worst]:.4f} mm at {place_text(gouged[worst])}")
    between = shared.uncut(near_cuts) if shared else []
    if len(between):
        complaints.append(f"{len(between)} places between parts uncut, as at {place_text(between[0])}")
    uncut, each_mm = uncut_places(rings, near_cuts, kerf)
    is_listed, listed = listed_places(uncut, told, rings, kerf)
    unlisted = numpy.sum(each_mm[~is_listed])
    if unlisted > MAX_UNLISTED_MM or numpy.sum(each_mm) > 1.2 * listed + MAX_UNLISTED_MM:
        first = uncut[numpy.argmin(is_listed)]
        complaints.append(f"{numpy.sum(each_mm):.1f} mm uncut, {listed:.1f} listed, {unlisted:.1f} of it elsewhere, "
                          f"as at {place_text(first)}")
    twice = cut_twice(cuts)
    if twice > 1:
        complaints.append(f"{twice:.1f} mm cut twice")
    return "; ".join(complaints)


def too_near(cuts: list, min_mm: float, edges: Nearest, inside: Inside, open_lines: Nearest,
             shared: SharedLines) -> tuple:
    """Returns the distances and the points of cuts nearer to a part than `min_mm`; a distance < 0 is in a part.

    A depth of more than the reach of `edges` is reported as that reach.
    """
    places, _, _ = samples_of(strokes_of(cuts)[0], EVERY_MM)
    apart = signed_distance(places, edges, inside)
    wrong = (apart < min_mm) & (open_lines.of(places) > SLACK_MM + 0.01)
    if shared:
        wrong &= ~shared.allow(places, apart)
    return apart[wrong], places[wrong]


def signed_distance(places: numpy.ndarray, edges: Nearest, inside: Inside) -> numpy.ndarray:
    return edges.of(places) * numpy.where(inside.has(places), -1, 1)


def uncut_places(rings: list, near_cuts: Nearest, kerf: float) -> tuple:
    """Returns points of edges without a path beside them, and the length that each stands for, mm."""
    strokes, _ = strokes_of(rings)
    places, number, _ = samples_of(strokes, EVERY_MM)
    doubtful = numpy.unique(number[near_cuts.of(places) > kerf + SLACK_MM])
    finely, _, each_mm = samples_of([strokes[i] for i in doubtful], FINELY_MM)
    without = near_cuts.of(finely) > kerf + SLACK_MM
    return finely[without], each_mm[without]


def listed_places(uncut: numpy.ndarray, told: str, rings: list, kerf: float) -> tuple:
    """Returns whether the program's own warnings list each uncut point, and the length that they list, mm.

    A warning has the position and the length of a stretch. It lists the points within that length of the position.
    """
    is_listed, listed = numpy.zeros(len(uncut), dtype=bool), 0.0
    for x, y, mm in re.findall(r"at (-?[\d.]+) (-?[\d.]+): .*?([\d.]+) mm of it stay uncut", told):
        is_listed |= numpy.abs(uncut - complex(float(x), float(y))) <= float(mm) + kerf
        listed += float(mm)
    if "would vanish" in told:
        areas = [Polygon([(p.real, p.imag) for p in ring]) for ring in rings]
        vanished = [ring for ring, area in zip(rings, areas) if area.buffer(-kerf / 2).is_empty]
        is_listed |= Nearest(vanished, SLACK_MM).of(uncut) <= SLACK_MM
        listed += sum(numpy.sum(numpy.abs(numpy.diff(ring))) for ring in vanished)
    return is_listed, listed


def cut_twice(cuts: list) -> float:
    """Returns the length along which two cuts are within SAME_MM of each other, without mere crossings."""
    strokes, owner = strokes_of(cuts)
    places, number, each_mm = samples_of(strokes, FINELY_MM)
    is_shared = Nearest(cuts, SAME_MM).of(places, after=owner[number]) < SAME_MM
    length, run, last = 0.0, 0, -1
    for k in range(len(places)):
        run = (run if number[k] == last else 0) + 1 if is_shared[k] else 0
        last = number[k]
        if run > MIN_RUN:
            length += each_mm[k]
    return length
