#!/usr/bin/env python3
"""Tests the pins of a board with an enable for each motor driver: current before the first step,
directions before the steps, and axes that keep their current. Also tests that each button acts at
its pin.

    test_drivers.py PLUGIN kerfline_mks_robin_nano_v3_1.elf [TEST...]

Ends with 77 (skipped) if the emulator, the plug-in or the image is missing.
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chip import BOOT_NS, CHIP_OPTIONS, MS, STOPPED, main  # noqa: E402

CHIP = None
STEPS = {"X": "PE3", "Y": "PE0", "Z": "PB5"}
DIRECTIONS = {"X": "PE2", "Y": "PB9", "Z": "PB4"}
ENABLES = {"X": "PE4", "Y": "PE1", "Z": "PB8"}  # Low: on.
HOLD, START, RESET, DOOR = "PA13", "PE6", "PE12", "PA6"
FAST = "$858=0\n$120=2000\n$121=2000\n"
US = 1000


class DriversTest(unittest.TestCase):
    def drive(self, text: str, milliseconds: int, *options: str):
        run = CHIP.run(text, BOOT_NS + milliseconds * MS, *CHIP_OPTIONS, "flash_kib=512", *options)
        self.assertEqual(STOPPED, run.status, run.told)
        self.assertNotIn("error", run.said)
        self.assertEqual([], run.times("misuse"), run.told)
        return run

    def level(self, run, pin: str) -> str:
        return [rest.split()[1] for _, source, rest in run.trace
                if source == "pin" and rest.startswith(pin + " ")][-1]

    def from_enable_to_step(self, run) -> int:
        """Returns the time from current in X's motor to its first step, ns."""
        return run.times("pin", f"{STEPS['X']} 1")[0] - run.times("pin", f"{ENABLES['X']} 0")[0]

    def test_current_flows_before_the_first_step(self):
        self.assertGreater(self.from_enable_to_step(self.drive(FAST + "G1X1F3000\n", 150)), MS // 2)

    def test_drivers_that_are_slow_to_wake_have_their_time(self):
        waited = self.from_enable_to_step(self.drive(FAST + "$884=60\nG1X1F3000\n", 250))
        self.assertGreater(waited, 60 * MS)
        self.assertLess(waited, 65 * MS)

    def test_axes_that_are_kept_have_current_before_motion_and_at_rest(self):
        kept = FAST + "$1=10\n$37=4\n"
        for text in (kept, kept + "G1X1F3000\n"):
            with self.subTest(text=text):
                run = self.drive(text, 250)
                self.assertEqual("G1" in text, bool(run.times("pin", f"{STEPS['X']} 1")))
                self.assertEqual("G1" in text, bool(run.times("pin", f"{ENABLES['X']} 0")))
                self.assertEqual({"X": "1", "Y": "1", "Z": "0"},
                                 {axis: self.level(run, pin) for axis, pin in ENABLES.items()})

    def test_no_step_comes_within_5_us_of_a_change_of_direction(self):
        circles = "".join(f"G2X0Y0I{radius}F6000\n" for radius in (2, 3, 4))
        run = self.drive(FAST + circles, 1000)
        rising = {f"{pin} 1" for pin in STEPS.values()}
        turning = {pin for pin in DIRECTIONS.values()}
        changes, turned, least = 0, -10**9, 10**9
        for ns, source, rest in run.trace:
            if source == "pin" and rest.split()[0] in turning:
                turned = ns
                changes += 1
            elif source == "pin" and rest in rising:
                least = min(least, ns - turned)
        self.assertGreater(changes, 10)
        self.assertGreaterEqual(least, 5 * US)

    def test_usb_is_connected_and_nothing_drives_the_buttons(self):
        run = self.drive("", 20)
        self.assertEqual("0", self.level(run, "PA14"))
        self.assertEqual([], [pin for pin in (HOLD, START, RESET, DOOR)
                              if run.times("pin", f"{pin} 0") + run.times("pin", f"{pin} 1")])

    def test_each_button_acts(self):
        """Presses hold, start and door during a motion that takes longer than the test."""
        begin = BOOT_NS + 100 * MS
        presses = ((begin, HOLD), (begin + 150 * MS, START), (begin + 300 * MS, DOOR))
        with tempfile.TemporaryDirectory() as folder:
            pins = pathlib.Path(folder, "pins")
            pins.write_text("".join(f"{ns} {pin} 0\n{ns + 60 * MS} {pin} z\n" for ns, pin in presses))
            asked = "".join("?" + 20 * ("(" + 60 * "." + ")\n") for _ in range(6))  # Each 100 ms.
            run = self.drive(FAST + "G1X100F1200\n" + asked, 600, f"pins={pins}")
        states = [line.split("|")[0].strip("<") for line in run.said.splitlines() if line[:1] == "<"]
        self.assertTrue({"Hold:0", "Run"} <= set(states), states)
        self.assertTrue(any(state.startswith("Door") for state in states), states)
        self.assertLess(states.index("Hold:0"), len(states) - 1 - states[::-1].index("Run"), states)


if __name__ == "__main__":
    main(globals(), "test_drivers")
