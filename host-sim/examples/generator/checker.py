"""Reads programs with a separate interpreter and lists their faults."""
import math
import re
from dataclasses import dataclass

RADIUS_TOLERANCE_MM = 0.002
TRAVEL_TOLERANCE_MM = 1e-6
LONGEST_LINE = 200
KNOWN_G = {0, 1, 2, 3, 4, 17, 18, 19, 20, 21, 28, 28.1, 40, 54, 90, 91, 94}
KNOWN_M = {2, 3, 4, 5, 8, 9, 30}
WORD = re.compile(r"([A-Z])([-+]?(?:\d+\.?\d*|\.\d+))")
PLANES = {17: "XYZ", 18: "ZXY", 19: "YZX"}          # first and second axis of arcs, axis of helices
OFFSETS = {"X": "I", "Y": "J", "Z": "K"}
# Definition of a chopped arc: this number of successive lines of equal length, each shorter than CHORD_MM, that turn by
# equal angles.
CHOPPED_RUN, CHORD_MM = 6, 3.0


@dataclass(frozen=True)
class Expected:
    settings: str
    arcs: int = 0                   # least number of arcs
    chords_allowed: bool = False


class Reader:
    """Modal state of one program, with its measured values and faults. Positions are in mm, by axis letter."""

    def __init__(self, travel):
        self.travel = travel
        self.position = dict.fromkeys("XYZ", 0.0)
        self.park = dict(self.position)
        self.low, self.high = dict(self.position), dict(self.position)
        self.motion, self.plane, self.absolute, self.scale = 0, 17, True, 1.0
        self.lines = self.arcs = 0
        self.feed = self.ended = False
        self.worst_radius = 0.0
        self.steps = []             # (dx, dy) of successive lines; None where a row ends
        self.faults = []

    def read(self, number, line):
        try:
            self.execute(line)
        except ValueError as fault:
            self.faults.append(f"{number}: {fault}: {line.strip()}")

    def execute(self, line):
        if len(line) > LONGEST_LINE:
            raise ValueError("line too long")
        text = re.sub(r"\([^()]*\)|;.*", "", line).strip().upper().replace(" ", "")
        if text in ("", "%"):
            return
        words = [(letter, float(value)) for letter, value in WORD.findall(text)]
        if "".join(m.group(0) for m in WORD.finditer(text)) != text:
            raise ValueError("not G-code")
        if self.ended:
            raise ValueError("words after the end of the program")
        values = self.modal(words)
        if self.special:
            self.go_home(values)
        elif any(axis in values for axis in "XYZIJK"):
            self.move(values)

    def modal(self, words):
        """Applies the modal words of a line. Returns the values of all other words."""
        values, self.special = {}, None
        for letter, value in words:
            if letter == "G":
                self.g_word(value)
            elif letter == "M":
                if value not in KNOWN_M:
                    raise ValueError(f"M{value:g}")
                self.ended = value in (2, 30)
            elif letter in "XYZIJKPFSNT":
                if letter in values:
                    raise ValueError(f"two {letter} words")
                values[letter] = value * (self.scale if letter in "XYZIJK" else 1)
            else:
                raise ValueError(f"{letter} word")
        self.feed = self.feed or values.get("F", 0) > 0
        return values

    def g_word(self, value):
        if value not in KNOWN_G:
            raise ValueError(f"G{value:g}")
        if value <= 3:
            self.motion = int(value)
        elif value in PLANES:
            self.plane = int(value)
        elif value in (20, 21):
            self.scale = 25.4 if value == 20 else 1.0
        elif value in (90, 91):
            self.absolute = value == 90
        elif value in (28, 28.1):
            self.special = value

    def go_home(self, values):
        if self.special == 28.1:
            self.park = dict(self.position)
            return
        self.reach(self.target(values))
        axes = [axis for axis in "XYZ" if axis in values] or "XYZ"
        self.reach({**self.position, **{axis: self.park[axis] for axis in axes}})
        self.steps.append(None)

    def target(self, values):
        base = dict.fromkeys("XYZ", 0.0) if self.absolute else self.position
        return {axis: base[axis] + values[axis] if axis in values else self.position[axis] for axis in "XYZ"}

    def move(self, values):
        target = self.target(values)
        if self.motion and not self.feed:
            raise ValueError("no feed")
        if self.motion >= 2:
            self.arc(values, target)
        elif self.motion == 1:
            self.lines += 1
            self.steps.append((target["X"] - self.position["X"], target["Y"] - self.position["Y"]))
        if self.motion != 1:
            self.steps.append(None)
        self.reach(target)

    def arc(self, values, target):
        """Checks one arc and visits the points of its circle that are on the arc."""
        self.arcs += 1
        a, b, _ = PLANES[self.plane]
        if OFFSETS[a] not in values and OFFSETS[b] not in values:
            raise ValueError("arc without centre")
        if a not in values and b not in values:
            raise ValueError("arc without an axis of its plane")
        centre = (self.position[a] + values.get(OFFSETS[a], 0), self.position[b] + values.get(OFFSETS[b], 0))
        start = (self.position[a] - centre[0], self.position[b] - centre[1])
        end = (target[a] - centre[0], target[b] - centre[1])
        radius = math.hypot(*start)
        deviation = abs(radius - math.hypot(*end))
        self.worst_radius = max(self.worst_radius, deviation)
        if deviation > RADIUS_TOLERANCE_MM:
            raise ValueError(f"radii differ by {deviation:.4f} mm")
        if radius < 0.01:
            raise ValueError(f"radius {radius:.4f} mm")
        from_angle = math.atan2(start[1], start[0])
        sweep = (math.atan2(end[1], end[0]) - from_angle) % (2 * math.pi)
        sweep = (sweep or 2 * math.pi) if self.motion == 3 else sweep - 2 * math.pi
        for i in range(65):
            angle = from_angle + sweep * i / 64
            self.reach({**self.position, a: centre[0] + radius * math.cos(angle),
                        b: centre[1] + radius * math.sin(angle)})

    def reach(self, target):
        self.position = dict(target)
        for axis in "XYZ":
            self.low[axis] = min(self.low[axis], target[axis])
            self.high[axis] = max(self.high[axis], target[axis])
            if not -TRAVEL_TOLERANCE_MM <= target[axis] <= self.travel[axis] + TRAVEL_TOLERANCE_MM:
                raise ValueError(f"{axis}{target[axis]:.3f} is outside the machine")

    def chopped_arcs(self):
        """Returns the number of runs of lines that look like a chopped arc."""
        found, run, turn_before = 0, 0, None
        for one, other in zip(self.steps, self.steps[1:]):
            turn = turn_between(one, other)
            alike = turn is not None and turn_before is not None and abs(turn - turn_before) < 0.02 * abs(turn_before)
            run = run + 1 if alike else 0
            found += run == CHOPPED_RUN
            turn_before = turn
        return found


def turn_between(one, other):
    """Returns the angle between two successive lines. Returns None if one of them is missing or too long, if their
    lengths differ, or if a chopped arc cannot have this angle."""
    if one is None or other is None:
        return None
    a, b = math.hypot(*one), math.hypot(*other)
    if not 0 < a < CHORD_MM or abs(a - b) > 0.02 * a:
        return None
    turn = math.atan2(one[0] * other[1] - one[1] * other[0], one[0] * other[0] + one[1] * other[1])
    return turn if 0.005 < abs(turn) < 1 else None


def travel(path):
    """Returns the travel of each axis, mm: $130, $131 and $132 of a settings file."""
    with open(path, encoding="utf-8") as file:
        found = dict(re.findall(r"^\$(13[012])=([\d.]+)", file.read(), re.MULTILINE))
    return {axis: float(found[str(130 + i)]) for i, axis in enumerate("XYZ")}


def check(text, folder, expected):
    """Returns a one-line summary of a program and a list of its faults."""
    reader = Reader(travel(folder / expected.settings))
    lines = text.splitlines()
    for number, line in enumerate(lines, 1):
        reader.read(number, line)
    faults = reader.faults
    if not reader.ended:
        faults.append("no M2 or M30")
    if reader.arcs < expected.arcs:
        faults.append(f"{reader.arcs} arcs, expected at least {expected.arcs}")
    chopped = reader.chopped_arcs()
    if chopped and not expected.chords_allowed:
        faults.append(f"{chopped} arcs are chopped into lines")
    span = " ".join(f"{axis}{reader.low[axis]:.1f}..{reader.high[axis]:.1f}" for axis in "XYZ")
    return (f"{len(lines):6} lines {len(text.encode()):7} bytes  {reader.lines:6} G1 {reader.arcs:5} G2/G3 "
            f"{chopped:3} chopped  radius error {reader.worst_radius:.4f}  {span}"), faults
