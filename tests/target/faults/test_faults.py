#!/usr/bin/env python3
"""Plants every fault in every state of the beam: it must be off within 64 instructions, and the
fault must be reported after the restart.

    test_faults.py PLUGIN kerfline_generic.elf [TEST...]

plant.py plants the faults into the running image. KERFLINE_TRIALS=99 tries all faults in all
states, fewer try some; KERFLINE_SEED chooses which. Ends with 77 (skipped) if the emulator, the
plug-in or the image is missing.
"""

import itertools
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chip import (BEAM_PIN, BOOT_NS, CHIP_OPTIONS, FLOOD_PIN, MS, STOPPED,  # noqa: E402
                  in_parallel, main, some_of)
from plant import in_function, in_main_loop  # noqa: E402

CHIP = None
MOST_INSTRUCTIONS = 64
AT_NS = BOOT_NS + 120 * MS
RESTARTED_NS = 60 * MS  # Time after a fault for the restart and its message at 115,200 baud.

# Fine steps and hard acceleration: while the beam is lit, steps are less than 1 ms apart.
FINE = "$32=1\n$858=0\n$100=1600\n$101=1600\n$120=5000\n$121=5000\n"
PAUSE = "(" + 60 * "." + ")\n"  # 5 ms of the wire.
STATES = {
    "M3 cutting": (FINE + "M3S600\nG1X20F1500\n", True),
    "M4 cutting": (FINE + "M4S600\nG1X20F1500\n", True),
    "rapid": (FINE + "M3S600\nG0X200\n", False),
    "hold": (FINE + "M3S600\nG1X20F1500\n" + 4 * PAUSE + "!", False),
    "dwell": (FINE + "M3S600\nG1X0.5F1500\nG4P2\n", False),
    "idle": (FINE + "M3S600\nG1X0.5F1500\n", False),
    "spindle at rest": ("$32=0\nM3S600\n", True),
}
TOLD = {
    "exception": "Restarted after a fault: exception ",
    "contract": "Restarted after a fault: broken contract",
    "stack": "Restarted after a fault: stack overflow",
    "supply": "Restarted after a fault: supply too low",
    "crystal": "Restarted after a fault: the crystal stopped",
}


class FaultTest(unittest.TestCase):
    def assert_state(self, run, lit: bool):
        """Asserts that the beam was on or off as the state requires at the fault, without which the
        test would prove nothing."""
        self.assertEqual(STOPPED, run.status, run.told)
        self.assertEqual(lit, any(begin < AT_NS <= end for begin, end in run.lit()), run.said)

    def assert_dark_from(self, run, ns: int, instructions: int):
        driven = [at for at in run.times("pin", f"{BEAM_PIN} 0") if at >= ns]
        self.assertTrue(driven, "never driven low")
        taken = (driven[0] - ns) // CHIP.instruction_ns
        self.assertLessEqual(taken, instructions)
        late = [span for span in run.lit() if span[1] > ns + instructions * CHIP.instruction_ns]
        self.assertEqual([], late)
        return taken

    def test_every_fault_in_every_state(self):
        cases = some_of(self, list(itertools.product(TOLD, STATES)), 10)

        def one(case):
            fault, state = case
            return CHIP.run(STATES[state][0], AT_NS + RESTARTED_NS, *CHIP_OPTIONS,
                            *in_main_loop(CHIP, fault, AT_NS))
        most = 0
        for (fault, state), run in zip(cases, in_parallel(one, cases)):
            with self.subTest(fault=fault, state=state):
                self.assert_state(run, STATES[state][1])
                marks = [ns for ns in run.times("pin", f"{FLOOD_PIN} 1") if ns >= AT_NS]
                self.assertTrue(marks, "the fault did not happen")
                most = max(most, self.assert_dark_from(run, marks[0], MOST_INSTRUCTIONS))
                self.assertIn(TOLD[fault], run.said)
        print(f"dark at most {most} instructions after {len(cases)} faults")

    def test_a_main_loop_that_hangs(self):
        """Segments that were cut before are driven, with the beam off at their end; then the
        watchdog resets the chip. A spindle turns until then."""
        states = some_of(self, list(STATES), 3)
        for state, run in zip(states, in_parallel(
                lambda state: CHIP.run(STATES[state][0], AT_NS + 220 * MS, *CHIP_OPTIONS,
                                       *in_main_loop(CHIP, "hang", AT_NS)), states)):
            with self.subTest(state=state):
                self.assert_state(run, STATES[state][1])
                bites = run.times("watchdog", "bites")
                self.assertEqual(1, len(bites))
                self.assert_dark_from(run, bites[0], MOST_INSTRUCTIONS)
                self.assertIn("Restarted by the watchdog", run.said)
                if state != "spindle at rest":
                    self.assertLess(run.lit_without_step()[0], MS)
                    self.assertTrue(all(end < AT_NS + 25 * MS for _, end in run.lit()))

    def test_a_step_interrupt_that_hangs(self):
        states = some_of(self, list(STATES), 3)
        for state, run in zip(states, in_parallel(
                lambda state: CHIP.run(STATES[state][0], AT_NS + 220 * MS, *CHIP_OPTIONS,
                                       *in_function(CHIP, "step_interrupt", AT_NS)), states)):
            with self.subTest(state=state):
                lit = STATES[state][1]
                self.assert_state(run, lit)
                if lit and state != "spindle at rest":
                    self.assertIn("Restarted after a fault: the beam was on at rest", run.said)
                    self.assertLess(run.resets()[0] - AT_NS, MS)
                    self.assertLess(run.lit_without_step()[0], MS)
                else:
                    self.assertEqual(1, len(run.times("watchdog", "bites")))

    def test_a_supply_below_the_brown_out_level(self):
        """The chip resets itself, which releases the pin; then the image drives it low."""
        states = some_of(self, list(STATES), 3)
        for state, run in zip(states, in_parallel(
                lambda state: CHIP.run(STATES[state][0], AT_NS + RESTARTED_NS, *CHIP_OPTIONS,
                                       f"brown_out_ns={AT_NS}"), states)):
            with self.subTest(state=state):
                self.assert_state(run, STATES[state][1])
                self.assertEqual(1, len(run.resets()))
                self.assert_dark_from(run, run.resets()[0], MOST_INSTRUCTIONS)
                self.assertIn("Restarted after the supply was too low", run.said)

    def test_an_image_that_changes_is_found(self):
        """A change is found when the check reads it: in the present round if that is still to come,
        else in the next."""
        nobody = 0x08000060  # The vector of an interrupt that is off.
        run = CHIP.run("", AT_NS + 1750 * MS, *CHIP_OPTIONS, f"flip={nobody:x}:5:{AT_NS}")
        self.assertEqual(1, len(run.resets()), run.said)
        print(f"found after {(run.resets()[0] - AT_NS) // MS} ms")
        self.assertIn("Restarted after a fault: the image changed in flash", run.said)
        self.assertIn("ALARM:24", run.said)

    def test_dark_wherever_speed_is_zero(self):
        """Includes holds, dwells, ends of motion and idle spans."""
        job = FINE + "M3S600\n" + "".join(
            f"G1X{x}Y1F1500\nG4P0.02\nG1X0Y0\n" + 2 * PAUSE + "!" + 8 * PAUSE + "~" + PAUSE
            for x in (1, 2, 3))
        run = CHIP.run(job, BOOT_NS + 600 * MS, *CHIP_OPTIONS)
        self.assertGreater(len(run.steps()), 1000)
        self.assertGreater(len(run.lit()), 3)
        self.assertLess(run.lit_without_step()[0], MS)


if __name__ == "__main__":
    main(globals(), "test_faults")
