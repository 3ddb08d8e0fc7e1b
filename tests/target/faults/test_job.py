#!/usr/bin/env python3
"""A long job of short lines over the emulated serial line at 1 Mbaud, from a sender that counts
characters: no byte is lost, and 100 mm/s are held.

    test_job.py PLUGIN kerfline_generic_1mbaud.elf [TEST...]

Ends with 77 (skipped) where the emulator, the plug-in or the image is missing.
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
BITS_OF_A_BYTE = 10


def circle() -> list:
    """Places on a circle, its chords 0.1 mm, from where the machine stands."""
    turn = 2 * math.asin(LINE_MM / 2 / RADIUS_MM)
    return [(RADIUS_MM - RADIUS_MM * math.cos(i * turn), RADIUS_MM * math.sin(i * turn))
            for i in range(1, LINES + 1)]


class JobTest(unittest.TestCase):
    def test_a_job_of_short_lines_keeps_its_speed(self):
        for way, mode in ((1, "M3"), (-1, "M4")):
            places = [(round(x, 3), round(way * y, 3)) for x, y in circle()]
            lines = [f"G1X{x}Y{y}\n" for x, y in places]
            set_up = f"$32=1\n$100={STEPS_PER_MM}\n$101={STEPS_PER_MM}\n{mode}S500F{60 * FEED_MM_S}\n"
            seconds = LINES * LINE_MM / FEED_MM_S
            run = CHIP.run(set_up + "".join(lines), BOOT_NS + int(1e9 * (seconds + 1.2)),
                           f"usart1_window={WINDOW}", *CHIP_OPTIONS)
            with self.subTest(mode=mode):
                self.judge(run, set_up, lines, places[-1], seconds)

    def judge(self, run, set_up: str, lines: list, end: tuple, seconds: float):
        self.assertEqual(STOPPED, run.status, run.told)
        self.assertEqual(LINES + set_up.count("\n"), run.said.count("ok\r\n"))
        for trouble in ("error:", "ALARM:", "Restarted"):
            self.assertNotIn(trouble, run.said)
        received = run.times("USART1", "rx ")
        self.assertEqual(len(set_up) + sum(map(len, lines)), len(received))
        self.assertEqual([], run.times("USART1", "overrun"))
        self.assertEqual(10_000, min(b - a for a, b in zip(received, received[1:])), "1 Mbaud")
        steps = {pin: 0 for pin in ("PA0", "PA1")}
        way = {"PA4": 1, "PA5": 1}
        for _, source, rest in run.trace:
            pin, _, level = rest.partition(" ")
            if source == "pin" and pin in way:
                way[pin] = -1 if level == "1" else 1
            if source == "pin" and pin in steps and level == "1":
                steps[pin] += way[{"PA0": "PA4", "PA1": "PA5"}[pin]]
        self.assertEqual([round(place * STEPS_PER_MM) for place in end], list(steps.values()))
        self.assert_speed(run, seconds)

    def assert_speed(self, run, seconds: float):
        """Lit from the first step to the last without a gap, and as fast as was asked for."""
        steps = run.steps()
        lit = [span for span in run.lit() if span[1] - span[0] > MS]
        took = (steps[-1] - steps[0]) / 1e9
        print(f"{LINES} lines in {took:.3f} s, of {seconds:.3f} s at {FEED_MM_S} mm/s throughout; "
              f"lit in {len(lit)} spans")
        self.assertEqual(1, len(lit))
        self.assertLess(took, 1.2 * seconds + 0.05)
        middle = [ns for ns in steps if steps[0] + 300 * MS < ns < steps[-1] - 300 * MS]
        self.assertLess(max(b - a for a, b in zip(middle, middle[1:])), MS)


if __name__ == "__main__":
    main(globals(), "test_job")
