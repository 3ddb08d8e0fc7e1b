#!/usr/bin/env python3
"""Runs a long job of short lines over the emulated serial line at 1 Mbaud, from a sender that
counts characters. No byte may be lost, and 100 mm/s must be held.

    test_job.py PLUGIN kerfline_generic_1mbaud.elf [TEST...]

Ends with 77 (skipped) if the emulator, the plug-in or the image is missing.
"""

import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chip import BOOT_NS, CHIP_OPTIONS, MS, STOPPED, main  # noqa: E402

CHIP = None
LINES, LINE_MM, RADIUS_MM, FEED_MM_S = 2000, 0.1, 40.0, 100
STEPS_PER_MM = 80
WINDOW = 1024
SPAN_NS = 100 * MS  # A speed is told over it: 800 steps.


def circle() -> list:
    """Returns points on a circle, 0.1 mm apart, relative to the machine's position."""
    turn = 2 * math.asin(LINE_MM / 2 / RADIUS_MM)
    return [(RADIUS_MM - RADIUS_MM * math.cos(i * turn), RADIUS_MM * math.sin(i * turn))
            for i in range(1, LINES + 1)]


def places_of(run) -> list:
    """Returns the positions of both motors, in steps, after each step: (ns, x, y)."""
    axis_of, sign, at, places = {"PA0": 0, "PA1": 1}, [1, 1], [0, 0], []
    for ns, source, rest in run.trace:
        pin, _, level = rest.partition(" ")
        if source != "pin":
            continue
        if pin in ("PA4", "PA5"):
            sign[("PA4", "PA5").index(pin)] = -1 if level == "1" else 1
        elif pin in axis_of and level == "1":
            at[axis_of[pin]] += sign[axis_of[pin]]
            places.append((ns, *at))
    return places


def speeds_of(places: list, way: int) -> list:
    """Returns the speeds along the circle over successive spans, mm/s."""
    def angle(place):
        x, y = (steps / STEPS_PER_MM for steps in place[1:])
        return math.atan2(way * y, RADIUS_MM - x)

    speeds, start = [], places[0]
    for place in places:
        if place[0] - start[0] < SPAN_NS:
            continue
        turned = (angle(place) - angle(start)) % (2 * math.pi)
        speeds.append(RADIUS_MM * turned / (place[0] - start[0]) * 1e9)
        start = place
    return speeds


class JobTest(unittest.TestCase):
    def test_a_job_of_short_lines_keeps_its_speed(self):
        for way, mode in ((1, "M3"), (-1, "M4")):
            places = [(round(x, 3), round(way * y, 3)) for x, y in circle()]
            lines = [f"G1X{x}Y{y}\n" for x, y in places]
            set_up = f"$32=1\n$858=0\n$100={STEPS_PER_MM}\n$101={STEPS_PER_MM}\n{mode}S500F{60 * FEED_MM_S}\n"
            seconds = LINES * LINE_MM / FEED_MM_S
            run = CHIP.run(set_up + "".join(lines), BOOT_NS + int(1e9 * (seconds + 1.2)),
                           f"usart1_window={WINDOW}", *CHIP_OPTIONS)
            with self.subTest(mode=mode):
                self.judge(run, set_up, lines, (places[-1], way), seconds)

    def judge(self, run, set_up: str, lines: list, end_and_way: tuple, seconds: float):
        end, way = end_and_way
        self.assertEqual(STOPPED, run.status, run.told)
        self.assertEqual(LINES + set_up.count("\n"), run.said.count("ok\r\n"))
        for trouble in ("error:", "ALARM:", "Restarted"):
            self.assertNotIn(trouble, run.said)
        received = run.times("USART1", "rx ")
        self.assertEqual(len(set_up) + sum(map(len, lines)), len(received))
        self.assertEqual([], run.times("USART1", "overrun"))
        self.assertEqual(10_000, min(b - a for a, b in zip(received, received[1:])), "1 Mbaud")
        places = places_of(run)
        self.assertEqual([round(place * STEPS_PER_MM) for place in end], list(places[-1][1:]))
        self.assert_speed(run, places, way, seconds)

    def assert_speed(self, run, places: list, way: int, seconds: float):
        """Asserts that the beam is lit from the first step to the last without a gap, and that the
        speed is as requested between speeding up and stopping."""
        lit = [span for span in run.lit() if span[1] - span[0] > MS]
        first, last = places[0][0], places[-1][0]
        middle = [place for place in places if first + 300 * MS < place[0] < last - 300 * MS]
        speeds = speeds_of(middle, way)
        print(f"{LINES} lines in {(last - first) / 1e9:.3f} s, of {seconds:.3f} s at {FEED_MM_S} "
              f"mm/s throughout; lit in {len(lit)} spans; {min(speeds):.2f} to {max(speeds):.2f} "
              f"mm/s over each {SPAN_NS // MS} ms of {(middle[-1][0] - middle[0][0]) / 1e9:.2f} s")
        self.assertEqual(1, len(lit))
        self.assertGreater(min(speeds), 0.99 * FEED_MM_S)
        self.assertLess(max(speeds), 1.01 * FEED_MM_S)
        self.assertLess(max(b[0] - a[0] for a, b in zip(middle, middle[1:])), MS)


if __name__ == "__main__":
    main(globals(), "test_job")
