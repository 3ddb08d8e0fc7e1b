"""Writes circle_r20.nc: a circle of radius 20 mm, as one arc and as two."""
from math import pi

from .geometry import arc
from .writer import Writer

CENTRE, RADIUS = 60 + 60j, 20.0


def program(_data_folder):
    writer = Writer()
    writer.comment("a circle of radius 20 mm: as one whole turn, then as two half turns")
    writer.raw("G21 G90 G17 G54", "M4 S0")
    writer.rapid(CENTRE - RADIUS)
    writer.follow([arc(CENTRE, RADIUS, pi, -2 * pi)], S=500, F=6000)
    writer.follow([arc(CENTRE, RADIUS, pi, -pi), arc(CENTRE, RADIUS, 0, -pi)])
    writer.raw("M5", "G0 X0 Y0", "M30")
    return writer.text()
