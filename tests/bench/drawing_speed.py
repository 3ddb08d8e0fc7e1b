#!/usr/bin/env python3
"""Measures how fast drawings of many contours are read and cut; prints figures, judges nothing.

    drawing_speed.py KERFLINE

For each kind of drawing and each command, prints the processor microseconds and the bytes of
memory per element, for a small drawing and for one of ten times as many elements. Also prints the
ratio of their times, which is 10 if the work is proportional to the number of elements. Then prints
the processor seconds of a box with finger joints, and the ratio of its times with and without
--check.
"""

import math
import os
import pathlib
import sys
import tempfile

CUT = ("--kerf", "0.15", "--power", "60%", "--feed", "600", "--order", "file",
       "--set", "$130=60000", "--set", "$131=60000")


def rounded(x, y, number):
    """Returns a pentagon with round corners, which has ten elements."""
    del number
    corners = [(x + 4 * math.cos(2 * math.pi * k / 5 + 0.3), y + 4 * math.sin(2 * math.pi * k / 5 + 0.3))
               for k in range(5)]
    path = first = ""
    for k, (from_x, from_y) in enumerate(corners):
        to_x, to_y = corners[(k + 1) % 5]
        start = f"{from_x + 0.3 * (to_x - from_x):.5f} {from_y + 0.3 * (to_y - from_y):.5f}"
        end = f"{to_x + 0.3 * (from_x - to_x):.5f} {to_y + 0.3 * (from_y - to_y):.5f}"
        path += (f"M{start}" if k == 0 else f"A1.8 1.8 0 0 1 {start}") + f"L{end}"
        first = first or start
    return path + f"A1.8 1.8 0 0 1 {first}Z"


def wavy(x, y, number):
    """Returns a hundred lines around a point, no two of the same shape."""
    places = [(4 + 0.1 * math.sin(37.0 * k + number), 2 * math.pi * k / 100) for k in range(100)]
    return "M" + "L".join(f"{x + r * math.cos(t):.5f} {y + r * math.sin(t):.5f}" for r, t in places) + "Z"


def nest(contours, path_of):
    side = math.ceil(math.sqrt(contours))
    paths = "".join(f'<path fill="none" stroke="black" d="{path_of(10 * (i % side) + 5, 10 * (i // side) + 5, i)}"/>\n'
                    for i in range(contours))
    size = 10 * side
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}mm" height="{size}mm" '
            f'viewBox="0 0 {size} {size}">\n{paths}</svg>\n')


def loose_lines(squares):
    """Returns squares of four lines each, which do not touch each other. All first sides come
    first, then all second sides, and so on.
    """
    side = math.ceil(math.sqrt(squares))
    corners = ((1, 1), (9, 1), (9, 9), (1, 9))
    text = ["0\nSECTION\n2\nENTITIES\n"]
    for k in range(4):
        for i in range(squares):
            x, y = 10 * (i % side), 10 * (i // side)
            (a, b), (c, d) = corners[k], corners[(k + 1) % 4]
            text.append(f"0\nLINE\n8\n0\n10\n{x + a}\n20\n{y + b}\n11\n{x + c}\n21\n{y + d}\n")
    return "".join(text) + "0\nENDSEC\n0\nEOF\n"


def box(panels=6, fingers=10, size=100.0, depth=3.0):
    """Returns panels with fingers on all sides. Their corners are loops of a cubic curve, as box
    generators draw them.
    """
    paths = ""
    for number in range(panels):
        at = complex(20 + 120 * (number % 3), 20 + 120 * (number // 3))
        along, step = 1 + 0j, size / fingers
        corners = [at]
        for _ in range(4):
            for finger in range(fingers):
                out = along * (-1j if finger % 2 else 1j) * depth
                corners += [corners[-1] + along * step, corners[-1] + along * step + out]
            corners.pop()
            along *= 1j
        corners.pop()
        path = ""
        for i, corner in enumerate(corners):
            before, after = (corners[i + k] - corner for k in (-1, 1 - len(corners)))
            if abs(before.conjugate() * after).real < 1e-9 and abs((before / after).imag) < 1e-9:
                continue
            ends = corner + 0.1 * before / abs(before), corner + 0.1 * after / abs(after)
            path += "".join((f"{'L' if path else 'M'}{corner.real:.3f} {corner.imag:.3f}",
                             f"C{ends[1].real:.3f} {ends[1].imag:.3f} {ends[0].real:.3f} {ends[0].imag:.3f} "
                             f"{corner.real:.3f} {corner.imag:.3f}"))
        paths += f'<path fill="none" stroke="black" d="{path}Z"/>\n'
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="280mm" viewBox="0 0 400 280">\n'
            f"{paths}</svg>\n")


DRAWINGS = {
    "10 elements a contour": ("svg", lambda elements: nest(elements // 10, rounded), 1_000_000),
    "100 lines a contour": ("svg", lambda elements: nest(elements // 100, wavy), 1_000_000),
    "loose lines": ("dxf", lambda elements: loose_lines(elements // 4), 400_000),
}


def measured(*arguments):
    """Returns the processor seconds and the bytes of memory of one run."""
    child = os.fork()
    if child == 0:
        with open(os.devnull, "w", encoding="utf-8") as nothing:
            os.dup2(nothing.fileno(), 1)
            os.dup2(nothing.fileno(), 2)
        os.execv(arguments[0], [str(argument) for argument in arguments])
    _, status, usage = os.wait4(child, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        print(f"    status {os.waitstatus_to_exitcode(status)}: {' '.join(map(str, arguments))}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def main():
    kerfline = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        for name, (ending, text_of, most) in DRAWINGS.items():
            files = {}
            for elements in (most // 10, most):
                files[elements] = pathlib.Path(folder) / f"{elements}.{ending}"
                files[elements].write_text(text_of(elements))
            for command in ("drawing", "cut"):
                more = (*CUT, "-o", pathlib.Path(folder) / "out.nc") if command == "cut" else ()
                times = []
                for elements, file in files.items():
                    seconds, size = measured(kerfline, command, file, *more)
                    times.append(seconds)
                    print(f"{command}, {name}, {elements} elements: {1.0e6 * seconds / elements:.2f} us and "
                          f"{size / elements:.0f} bytes an element")
                print(f"{command}, {name}: {times[1] / times[0]:.1f} times as long for 10 times as many")
        file, program = pathlib.Path(folder) / "box.svg", pathlib.Path(folder) / "out.nc"
        file.write_text(box())
        plain, _ = measured(kerfline, "cut", file, *CUT, "-o", program)
        checked, _ = measured(kerfline, "cut", file, *CUT, "-o", program, "--check")
        print(f"cut, a box of six panels: {plain:.2f} s, {checked / plain:.1f} times as long with --check")


if __name__ == "__main__":
    main()
