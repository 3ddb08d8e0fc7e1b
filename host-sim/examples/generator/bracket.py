"""Writes bracket.nc and its drawing: a belt tensioner plate for a NEMA 17 motor and a 608 bearing, 120 x 80 mm."""
import cmath
import math

from .cutting import nearest_order, with_leads
from .drawing import svg
from .geometry import Segment, circle, curved_slot, moved, rounded_polygon, slot
from .lettering import Font
from .writer import Writer

PLACE = 20 + 20j            # position of the part's lower left corner on the table
MOTOR = 29 + 45j
PIVOT = 80 + 40j            # centre of the bearing, the cam slot and the round end
ROUND_END = 40.0            # radius of the round end
CAM_RADIUS, CAM_WIDTH = 30.0, 5.2
CAM_HALF_SWEEP = math.radians(60)
SCREWS = (7 + 7j, 7 + 73j, 75 + 7j, 75 + 73j)
NEMA17_PITCH, NEMA17_BOSS = 31.0, 22.6

ENGRAVE = {"S": 160, "F": 3000}
CUT = {"S": 820, "F": 900}


def program(data_folder):
    font = Font(data_folder / "dejavu_sans_bold.json")
    writer = Writer()
    writer.comment("bracket: belt tensioner plate for a NEMA 17 motor, 120 x 80 mm, 3 mm plywood",
                   "made by host-sim/examples/make_examples.py; nominal outline, no kerf compensation")
    writer.raw("G21 G90 G17 G54", "M8", "M4 S0")
    writer.comment("engrave: name, scale of the cam slot, motor outline")
    position = burn(writer, engraving(font), ENGRAVE, 0)
    writer.comment("cut: holes and slots")
    position = burn(writer, [with_leads(hole, True, lead) for hole, lead in holes()], CUT, position)
    writer.comment("cut: outline")
    burn(writer, [with_leads(outline(), False, 3.0)], CUT, position)
    writer.raw("M5", "M9", "G0 X0 Y0", "M30")
    return writer.text()


def drawing(data_folder):
    """Returns the drawing of the part for `kerfline cut`."""
    font = Font(data_folder / "dejavu_sans_bold.json")
    cuts = [outline()] + [hole for hole, _ in holes()]
    operations = (("engrave", "blue", engraving(font)), ("cut", "black", cuts))
    return svg(160 + 120j, [(name, colour, [moved(path, 1, PLACE) for path in paths])
                            for name, colour, paths in operations])


def burn(writer, paths, words, position):
    """Follows paths in part coordinates, each after a rapid. Returns the end of the last path."""
    for path in nearest_order([moved(path, 1, PLACE) for path in paths], position):
        writer.rapid(path[0].start)
        writer.follow(path, **words)
        position = path[-1].end
    return position


def around(centre, offsets):
    return [centre + offset for offset in offsets]


# -- contours that are cut ---------------------------------------------------------------------------------------------


def outline():
    """Returns the outline: a rounded plate with a waist on both sides. Its right end is half a disc about the pivot."""
    corners = [(0j, 8), (46, 4), (50 + 5j, 6), (60 + 5j, 6), (64, 4), (80, 0),
               (80 + 80j, 0), (64 + 80j, 4), (60 + 75j, 6), (50 + 75j, 6), (46 + 80j, 4), (80j, 8)]
    path = rounded_polygon(corners)
    straight = next(i for i, s in enumerate(path) if s.start == 80 and s.end == 80 + 80j)
    path[straight] = Segment(80 + 0j, 80 + 80j, PIVOT, math.pi)
    return path


def holes():
    """Returns all parts that fall out, as pairs (contour, lead-in radius)."""
    return motor_holes() + bearing_holes() + cam_slots() + mounting_holes() + ventilation()


def motor_holes():
    """Returns the boss and four screw slots. The slots are long enough to move the motor by 5 mm, which tensions the
    belt. """
    travel = 2.5
    half = NEMA17_PITCH / 2
    screws = around(MOTOR, [complex(x, y) for x in (-half, half) for y in (-half, half)])
    return ([(slot(MOTOR - travel, MOTOR + travel, NEMA17_BOSS), 3.0)]
            + [(slot(screw - travel, screw + travel, 3.4), 1.0) for screw in screws])


def bearing_holes():
    """Returns the seat of a 608 bearing in a ring of ventilation slots."""
    count = 9
    turns = [2 * math.pi * i / count for i in range(count)]
    sweep = math.radians(17)
    return ([(circle(PIVOT, 11.0), 3.0)]
            + [(curved_slot(PIVOT, 17.0, 4.4, turn - sweep / 2, sweep), 1.4) for turn in turns])


def cam_slots():
    return [(curved_slot(PIVOT, CAM_RADIUS, CAM_WIDTH, -CAM_HALF_SWEEP, 2 * CAM_HALF_SWEEP), 1.6)]


def mounting_holes():
    return [(circle(centre, 2.15), 1.0) for centre in SCREWS]


def ventilation():
    """Returns a honeycomb of round holes in the space between motor, bearing ring, cam slot, screws and edges."""
    pitch, radius, rows = 4.4, 1.5, 8
    grid = [56.5 + 40j + pitch * complex(column + 0.5 * (row % 2), row * math.sqrt(0.75))
            for row in range(-rows, rows + 1) for column in range(-3, 6)]
    return [(circle(centre, radius), 0.7) for centre in grid if has_room(centre)]


def has_room(centre):
    return (52.8 < centre.real < 76 and abs(centre.imag - 40) < 28 and abs(centre - PIVOT) > 22.8
            and min(abs(centre - screw) for screw in SCREWS) > 6.2)


# -- paths that are engraved -------------------------------------------------------------------------------------------


def engraving(font):
    return lettering(font) + cam_scale(font) + motor_marks()


def lettering(font):
    return (font.along_line("KERFLINE", 5.6, MOTOR + 1.5 - 34j)
            + font.along_line("NEMA 17", 2.6, MOTOR + 26j))


def cam_scale(font):
    """Returns a degree scale along the cam slot, with its numbers on the inside."""
    marks = []
    for degrees in range(-60, 61, 5):
        direction = cmath.rect(1, math.radians(degrees))
        length = 3.2 if degrees % 30 == 0 else 2.2 if degrees % 10 == 0 else 1.3
        marks.append([Segment(PIVOT + 33.8 * direction, PIVOT + (33.8 + length) * direction)])
    numbers = [font.along_circle(str(abs(degrees)), 2.4, PIVOT, 22.0, math.radians(degrees))
               for degrees in range(-60, 61, 30)]
    return marks + [path for number in numbers for path in number]


def motor_marks():
    """Returns the outline of the motor's body in the middle of its travel."""
    half, radius = 21.15, 4.0
    corners = [(MOTOR + complex(x, y) * half, radius) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    return [rounded_polygon(corners)]
