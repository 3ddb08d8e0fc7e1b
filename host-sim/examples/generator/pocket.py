"""Writes pocket_fusion.nc: a 2.5-D milling job, a gearbox cover, in the style of Autodesk Fusion's Grbl post processor.

Operations: adaptive pocket, pocket wall, bore, four screw holes, outline with tabs. All of them are climb milling:
inside counter-clockwise, outside clockwise. Z0 is the machine's table, so that all coordinates are positive.
"""
import math

from .geometry import Segment, arc, rounded_polygon, slot
from .writer import Dialect, Writer

FUSION = Dialect(modal_motion=True, zero_offsets=False)

TOOL = 4.0                      # diameter, flat end mill
TOP, FLOOR, THROUGH = 17.0, 11.0, 4.8
TAB_TOP = 7.0
CLEARANCE, RETRACT, APPROACH, PARK = 32.0, 22.0, 18.0, 40.0
CUT, PLUNGE, LINK = 1400, 400, 2600
CENTRE = 100 + 80j
HALF_TRAVEL = 27.0              # the pocket is a slot between two centres, CENTRE -+ this
POCKET_RADIUS, STOCK_TO_LEAVE = 22.0, 0.3
BORE_RADIUS, SCREW_RADIUS = 11.0, 3.3
STEP_OVER, LEVELS = 1.0, (14.0, FLOOR)
LEAD = 0.6                      # radius of lead-in arcs, vertical and horizontal


def program(_data_folder):
    mill = Mill()
    mill.header()
    mill.operation("Adaptive1", adaptive_pocket)
    mill.operation("2D Contour1", pocket_wall)
    mill.operation("Bore1", main_bore)
    mill.operation("Bore2", screw_holes)
    mill.operation("2D Contour2", outline_with_tabs)
    mill.footer()
    return mill.writer.text()


class Mill:
    """Writer with planes, leads and helices. It splits arcs into half turns, as the post processor does."""

    def __init__(self):
        self.writer = Writer(FUSION)
        self.plane = 17

    def header(self):
        w = self.writer
        w.comment("1001", "in the style of the Fusion Grbl post, by host-sim/examples/make_examples.py",
                  f"T1 D={TOOL:g} CR=0 - ZMIN={THROUGH:g} - flat end mill")
        w.raw("G90 G94", "G17", "G21")
        w.comment("Manual NC: park height for G28")
        w.raw("G54")
        w.rapid(z=PARK)
        w.raw("G28.1", "G28 G91 Z0", "G90")

    def operation(self, name, cut):
        w = self.writer
        w.raw("")
        w.comment(name)
        if w.modal.get("F") is None:
            w.raw("T1", "S18000 M3", "G17 G90 G94", "G54", "M8")
        w.motion = None
        cut(self)
        w.rapid(z=CLEARANCE)
        if self.plane != 17:
            self.plane = 17
            w.raw("G17")

    def footer(self):
        self.writer.raw("", "M9", "M5", "G28 G91 Z0", "G90", "G28 G91 X0 Y0", "G90", "M30")

    def approach(self, point):
        """Moves over the point at clearance height, then down to just above the stock."""
        self.writer.rapid(point)
        self.writer.rapid(z=CLEARANCE)
        self.line(z=RETRACT, feed=CUT)
        self.line(z=APPROACH, feed=PLUNGE)

    def line(self, point=None, z=None, feed=CUT):
        self.writer.line(point, z, F=feed)

    def arc(self, segment, z=None, feed=CUT):
        """Writes an arc, or a helix to the height z."""
        self.in_plane(17)
        start_z = self.writer.position[2]
        count = math.ceil(abs(segment.sweep) / math.pi - 1e-9)
        for i in range(count):
            height = None if z is None else start_z + (z - start_z) * (i + 1) / count
            self.writer.arc(segment.part(i / count, (i + 1) / count), height, F=feed)

    def path(self, segments, feed=CUT):
        for segment in segments:
            if segment.centre is None:
                self.line(segment.end, feed=feed)
            else:
                self.arc(segment, feed=feed)

    def in_plane(self, plane):
        """Sets the plane. The plane word is written before the next motion word, on the same line."""
        if plane != self.plane:
            self.plane = plane
            self.writer.prefix = f"G{plane} "
            self.writer.motion = None

    def vertical_arc(self, point, z, direction, downward):
        """Writes a quarter turn with radius LEAD in the XZ or YZ plane. If `downward`, the motion turns from
        downwards into `direction`; otherwise from `direction` to upwards."""
        in_xz = direction.imag == 0
        forward = direction.real + direction.imag > 0
        clockwise = forward == in_xz        # both ways down and both ways up
        self.in_plane(18 if in_xz else 19)
        w = self.writer
        words = w.axis_words(point.real, point.imag, z)
        if downward:
            words.append(("I", LEAD * direction.real) if in_xz else ("J", LEAD * direction.imag))
        else:
            words.append(("K", LEAD))
        w.block("G2" if clockwise else "G3", words + w.other_words(F=CUT))

    def lead_in(self, segment, z):
        """Leads to the segment: down on a vertical arc, towards the wall on a line, and onto the segment by a left
        quarter turn.
        """
        along = segment.tangent(0)
        towards = along / 1j
        corner = segment.start - LEAD * along - LEAD * towards
        self.line(z=z + LEAD, feed=PLUNGE)
        self.vertical_arc(corner - LEAD * towards, z, towards, downward=True)
        self.line(corner)
        self.arc(Segment(corner, segment.start, corner + LEAD * along, math.pi / 2))

    def lead_out(self, segment):
        """Leads away from the segment: by a left quarter turn, a line and a vertical arc upwards."""
        along = segment.tangent(1)
        away = along * 1j
        corner = segment.end + LEAD * along + LEAD * away
        self.arc(Segment(segment.end, corner, segment.end + LEAD * away, math.pi / 2))
        z = self.writer.position[2]
        self.line(corner + LEAD * away)
        self.vertical_arc(corner + 2 * LEAD * away, z + LEAD, away, downward=False)

    def lead_clear(self, segment, z):
        """Returns the position in the plane at which lead_in() begins."""
        along = segment.tangent(0)
        towards = along / 1j
        return segment.start - LEAD * along - 3 * LEAD * towards


# -- operations --------------------------------------------------------------------------------------------------------


def adaptive_pocket(mill):
    """Writes for each level a helix down, a spiral of half turns, and crescents along the slot. Links are lifted by 0.2
    mm.
    """
    radius = POCKET_RADIUS - TOOL / 2 - STOCK_TO_LEAVE
    left = CENTRE - HALF_TRAVEL
    for i, level in enumerate(LEVELS):
        entry = 1.8
        mill.approach(left + entry) if i == 0 else mill.line(left + entry, z=CLEARANCE, feed=LINK)
        top = TOP + 0.5 if i == 0 else LEVELS[i - 1] + 0.5
        mill.line(z=top, feed=PLUNGE)
        turns = round((top - level) / 0.35)
        mill.arc(arc(left, entry, 0, 2 * math.pi * turns), level)
        mill.arc(arc(left, entry, 0, math.pi))
        spiral(mill, left, entry, radius)
        crescents(mill, left, radius, level)
        mill.line(z=CLEARANCE, feed=LINK)


def spiral(mill, centre, inner, outer):
    """Writes half turns about two alternating centres, then one full turn. The radius grows by half the step in each
    half turn."""
    growth = STEP_OVER / 2
    place, side = centre - inner, -1
    while True:
        middle = centre + side * growth / 2 * -1
        reach = abs(place - middle)
        if reach >= outer - growth:
            break
        mill.arc(Segment(place, 2 * middle - place, middle, math.pi))
        place, side = 2 * middle - place, -side
    start = centre + side * outer
    mill.line(start)
    mill.arc(Segment(start, start, centre, 2 * math.pi))
    if side < 0:
        mill.arc(Segment(start, 2 * centre - start, centre, math.pi))


def crescents(mill, centre, radius, level):
    """Writes half circles, each one step farther along the slot. Links behind the cutter join them."""
    turn = 3.0                  # radius of the link's corners
    mill.arc(arc(centre, radius, 0, math.pi / 2))
    for _ in range(round(2 * HALF_TRAVEL / STEP_OVER)):
        top = centre + 1j * radius
        mill.arc(arc(top - 1j * turn, turn, math.pi / 2, math.pi / 2), level + 0.2, LINK)
        centre += STEP_OVER
        bottom = centre - 1j * radius
        mill.line(complex(top.real - turn, bottom.imag + turn), feed=LINK)
        mill.arc(arc(complex(top.real, bottom.imag + turn), turn, math.pi, math.pi / 2), level, LINK)
        mill.line(bottom)
        mill.arc(arc(centre, radius, -math.pi / 2, math.pi))


def pocket_wall(mill):
    radius = POCKET_RADIUS - TOOL / 2
    wall = slot(CENTRE - HALF_TRAVEL, CENTRE + HALF_TRAVEL, 2 * radius)
    first = wall[0]             # begin in the middle of the lower straight side
    path = [first.part(0.5, 1)] + wall[1:] + [first.part(0, 0.5)]
    mill.approach(mill.lead_clear(path[0], FLOOR))
    mill.lead_in(path[0], FLOOR)
    mill.path(path)
    mill.lead_out(path[-1])


def main_bore(mill):
    """Writes a helix through the floor of the pocket, with one millimetre per turn."""
    bore(mill, CENTRE - HALF_TRAVEL, BORE_RADIUS - TOOL / 2, FLOOR + 0.5, 1.0)


def screw_holes(mill):
    for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        bore(mill, CENTRE + complex(54 * x, 29 * y), SCREW_RADIUS - TOOL / 2, TOP + 0.5, 1.0)


def bore(mill, centre, radius, top, pitch):
    mill.approach(centre + radius)
    mill.line(z=top, feed=PLUNGE)
    turns = math.ceil((top - THROUGH) / pitch)
    mill.arc(arc(centre, radius, 0, 2 * math.pi * turns), THROUGH, CUT // 2)
    mill.arc(arc(centre, radius, 0, 2 * math.pi), feed=CUT // 2)
    mill.arc(arc(centre + radius / 2, radius / 2, 0, math.pi))
    mill.line(z=APPROACH, feed=LINK)
    mill.writer.rapid(z=CLEARANCE)


def outline_with_tabs(mill):
    """Writes the outline at three depths. At the last depth, it climbs over four tabs."""
    half, offset = 62 + 37j, TOOL / 2
    corner = half + complex(offset, offset)
    corners = [(CENTRE + complex(x * corner.real, y * corner.imag), 12 + offset)
               for x, y in ((-1, -1), (-1, 1), (1, 1), (1, -1))]
    path = rounded_polygon(corners)
    left = next(i for i, s in enumerate(path) if s.centre is None and s.start.real == s.end.real)
    path = [path[left].part(0.5, 1)] + path[left + 1:] + path[:left] + [path[left].part(0, 0.5)]
    mill.approach(mill.lead_clear(path[0], THROUGH))
    for depth in (13.0, 9.0, THROUGH):
        mill.lead_in(path[0], depth)
        for segment in path:
            long_side = segment.centre is None and segment.length > 60
            if long_side and depth < TAB_TOP:
                over_tabs(mill, segment, depth)
            else:
                mill.path([segment])
        mill.lead_out(path[-1])
        mill.line(z=APPROACH, feed=LINK)
        mill.line(mill.lead_clear(path[0], depth), feed=LINK)


def over_tabs(mill, segment, depth):
    """Writes a segment with two tabs, at one third and two thirds: up a ramp to the tab, along the tab, and down again.
    """
    along = segment.tangent(0)
    for share in (1 / 3, 2 / 3):
        middle = segment.point(share)
        mill.line(middle - 5 * along)
        mill.line(middle - 3 * along, z=TAB_TOP)
        mill.line(middle + 3 * along)
        mill.line(middle + 5 * along, z=depth, feed=PLUNGE)
    mill.line(segment.end)
