"""Writes enclosure_lightburn.nc: a finger-jointed box for a controller board, in the style of LightBurn for Grbl.

LightBurn (1.x, "GRBL" device) chops every curve into short G1 lines, and so does this generator. """
import math

from .cutting import nearest_order
from .geometry import box, circle, curved_slot, moved, polygon, rounded_polygon, slot
from .lettering import Font
from .writer import Dialect, Writer

LIGHTBURN = Dialect(separator="", comment="; {}")
CHORD_TOLERANCE_MM = 0.01

WIDTH, DEPTH, HEIGHT = 110.0, 75.0, 40.0        # outer size of the box
THICKNESS = 3.0
FINGERS = {WIDTH: 9, DEPTH: 7, HEIGHT: 3}       # number of fingers and gaps per edge, odd
ORIGIN, GAP = 10 + 10j, 5.0


def program(data_folder):
    font = Font(data_folder / "dejavu_sans_bold.json")
    panels = place_panels(font)
    engraved = [path for _, _, marks in panels for path in marks]
    cut = [path for _, contours, _ in panels for path in contours]
    writer = Writer(LIGHTBURN)
    low, high = box(engraved + cut)
    writer.comment("LightBurn 1.7.04 style, made by host-sim/examples/make_examples.py",
                   "GRBL device profile, absolute coords",
                   f"Bounds: X{low.real:g} Y{low.imag:g} to X{high.real:g} Y{high.imag:g}")
    writer.raw("G00 G17 G40 G21 G54", "G90", "M4")
    position = layer(writer, ["C01"], nearest_order(engraved, 0), power=18, speed=3000)
    for _, contours, _ in panels:
        holes, outline = contours[:-1], contours[-1]
        position = layer(writer, ["C00 Pass 1 of 2", "C00 Pass 2 of 2"],
                         nearest_order(holes, position) + [outline], power=85, speed=900)
    writer.raw("M9", "G1 S0", "M5", "G90")
    writer.comment("return to user-defined finish pos")
    writer.raw("G0 X0 Y0", "M2")
    return writer.text()


def layer(writer, names, paths, power, speed):
    """Writes one cut layer of LightBurn's plan. Each shape is cut once for each name in `names`, which are the names
    of the passes."""
    writer.comment(f"Cut @ {speed} mm/min, {power}% power")
    writer.raw("M8")
    for path in paths:
        writer.rapid(path[0].start)
        for name in names:
            writer.comment(f"Layer {name}")
            for point in chopped(path):
                writer.line(point, S=10 * power, F=speed)
    return paths[-1][-1].end


def chopped(path):
    """Yields the ends of the lines that approximate a path."""
    for segment in path:
        count = 1
        if segment.centre is not None:
            step = 2 * math.acos(1 - CHORD_TOLERANCE_MM / segment.radius)
            count = math.ceil(abs(segment.sweep) / step)
        for i in range(1, count + 1):
            yield segment.point(i / count)


# -- panels of the box -------------------------------------------------------------------------------------------------


def place_panels(font):
    """Returns (name, contours with the outline last, engraving) of the six panels, placed on the sheet."""
    rows = [[bottom(font), top(font)], [front(font), back(font)], [side(font, "LEFT"), side(font, "RIGHT")]]
    placed, y = [], ORIGIN.imag
    for row in rows:
        x = ORIGIN.real
        for name, size, contours, marks in row:
            shift = complex(x, y)
            placed.append((name, [moved(path, 1, shift) for path in contours],
                           [moved(path, 1, shift) for path in marks]))
            x += size.real + GAP
        y += row[0][1].imag + GAP
    return placed


def bottom(font):
    size = complex(WIDTH, DEPTH)
    feet = [circle(complex(x, y), 1.6) for x in (12, WIDTH - 12) for y in (12, DEPTH - 12)]
    louvres = [slot(complex(x, 25), complex(x, 50), 2.4) for x in range(30, 81, 5)]
    return "bottom", size, feet + louvres + [panel(size, "AAAA")], font.along_line("BOTTOM", 4, 55 + 12j)


def top(font):
    size = complex(WIDTH, DEPTH)
    centre = complex(WIDTH / 2 + 18, DEPTH / 2)
    screws = [circle(centre + complex(x, y), 1.75) for x in (-16, 16) for y in (-16, 16)]
    guard = [curved_slot(centre, radius, 2.6, turn * math.pi / 2 + 3.6 / radius, math.pi / 2 - 7.2 / radius)
             for radius in (8, 12.5, 17) for turn in range(4)]
    name = font.along_line("KERFLINE", 5, complex(28, DEPTH / 2))
    return "top", size, screws + guard + [circle(centre, 3)] + [panel(size, "AAAA")], name


def front(font):
    size = complex(WIDTH, HEIGHT)
    display = rounded_polygon([(12 + 11j, 1.5), (44 + 11j, 1.5), (44 + 29j, 1.5), (12 + 29j, 1.5)])
    buttons = [circle(complex(x, 20), 3.5) for x in (56, 67, 78)]
    knob = [circle(94 + 20j, 4.9)]
    labels = [path for axis, x in (("X", 56), ("Y", 67), ("Z", 78))
              for path in font.along_line(axis, 3, complex(x, 28))]
    return "front", size, [display] + buttons + knob + [panel(size, "BABA")], labels


def back(font):
    size = complex(WIDTH, HEIGHT)
    connector = rounded_polygon([(20 + 16j, 2), (40 + 16j, 2), (42 + 25j, 2), (18 + 25j, 2)])
    ears = [circle(complex(x, 20.5), 1.6) for x in (14.5, 45.5)]
    usb = rounded_polygon([(58 + 17j, 0.6), (70 + 17j, 0.6), (70 + 23j, 0.6), (58 + 23j, 0.6)])
    gland = [circle(90 + 20j, 8.2)]
    return "back", size, [connector, usb] + ears + gland + [panel(size, "BABA")], font.along_line("USB", 3, 64 + 28j)


def side(font, name):
    size = complex(DEPTH, HEIGHT)
    vents = [slot(complex(x, 14), complex(x + 6, 26), 2.2) for x in range(18, 52, 6)]
    return name, size, vents + [panel(size, "BBBB")], font.along_line(name, 3, 37.5 + 8.5j)


def panel(size, kinds):
    """Returns the outline of a panel. `kinds` has one letter per edge (bottom, right, top, left): A has fingers at its
    corners, B has gaps.
    """
    width, height = size.real, size.imag
    corners = [0j, complex(width, 0), size, complex(0, height)]
    points = []
    for i in range(4):
        start, end = corners[i], corners[(i + 1) % 4]
        along = (end - start) / abs(end - start)
        points.append(start + along * complex(inset(kinds[i - 1], 0), inset(kinds[i], 0)))
        points += edge(start, along, abs(end - start), kinds[i])
    return polygon(points)


def edge(start, along, length, kind):
    """Returns the points of the steps between fingers and gaps, without the two corners."""
    count = FINGERS[length]
    points = []
    for k in range(1, count):
        for piece in (k - 1, k):
            points.append(start + along * (length * k / count) + along * 1j * inset(kind, piece))
    return points


def inset(kind, piece):
    return THICKNESS if (kind == "A") == (piece % 2 == 1) else 0.0
