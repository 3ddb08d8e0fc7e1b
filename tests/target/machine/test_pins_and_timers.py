"""Tests ports, and the timers' periods, pulses, compares, reloads and PWM."""

import unittest

from emulator import Emulator, Files

TIMER_HZ = 84e6
INSTRUCTION_NS = 1 << Emulator.shift
# Time from a timer's event to the handler's store to a pin: some instructions, and perhaps other
# handlers before.
LATENCY_NS = 100 * INSTRUCTION_NS


class PinsAndTimersTest(unittest.TestCase):
    def edges(self, outcome, pin: str) -> list:
        """Returns the times of edges, ns, from the first 0 on, at which the pin becomes an output."""
        return [ns for ns, _ in outcome.events("pin", pin + " ")][1:]

    def assert_periodic(self, edges, period_ns: float, count: int):
        self.assertEqual(count, len(edges))
        first = min(ns - turn * period_ns for turn, ns in enumerate(edges))
        for turn, ns in enumerate(edges):  # From the first, so that errors would add up.
            self.assertLess(ns - first - turn * period_ns, LATENCY_NS)

    def test_an_edge_is_traced_when_it_happens(self):
        outcome = Emulator.run("edges")
        edges, counts = self.edges(outcome, "PA0"), outcome.said["edge"]
        self.assertEqual((100, 100), (len(edges), len(counts)))
        starts = [ns - before * 1e9 / TIMER_HZ for ns, (before, _) in zip(edges, counts)]
        self.assertLess(max(starts) - min(starts), 1e9 / TIMER_HZ + 2 * INSTRUCTION_NS)
        for before, after in counts:
            self.assertLessEqual(0, after - before)

    def test_ways_to_drive_a_pin(self):
        outcome = Emulator.run("edges")
        for pin, course in (("PB5", "1"), ("PB6", "0"), ("PB7", "f")):
            self.assertEqual([f"{pin} {state}" for state in course],
                             [rest for _, rest in outcome.events("pin", pin + " ")])
        self.assertEqual([[1 << 5 | 1 << 4]], outcome.said["read_back"])  # B4 is pulled up.

    def test_inputs_follow_the_script_and_the_pull_up(self):
        script = Files(self)("pins", "3000000 PB0 1\n4000000 PB1 0\n5000000 PB1 z\n6000000 PB0 0\n")
        levels = Emulator.run("inputs", f"pins={script}").said["levels"]
        self.assertEqual([0b10, 0b11, 0b01, 0b11, 0b10], [level for level, _ in levels])
        for (_, before), (_, after) in zip(levels[1:], levels[2:]):
            self.assertAlmostEqual(1000, after - before, delta=1)

    def test_three_timers_keep_their_periods(self):
        outcome = Emulator.run("periods")
        for pin, period_ns in (("PA0", 840 / 84e6), ("PA1", 162 / 12e6), ("PA2", 1050 / 42e6)):
            self.assert_periodic(self.edges(outcome, pin)[:400], period_ns * 1e9, 400)

    def test_one_pulse_is_one(self):
        outcome = Emulator.run("one_pulse")
        self.assertEqual([[1], [1]], outcome.said["pulses"])
        self.assertEqual([[8, 0], [8, 0]], outcome.said["stopped"])
        edges = self.edges(outcome, "PA0")
        for begin, end, expected in ((0, 1, 100_000), (2, 3, 50_000)):
            self.assertAlmostEqual(expected, edges[end] - edges[begin], delta=LATENCY_NS)

    def test_compares_of_a_free_counter(self):
        outcome = Emulator.run("compare")
        self.assert_periodic(self.edges(outcome, "PA0"), 5000e9 / TIMER_HZ, 20)
        self.assertAlmostEqual(4 * 20_000 - 1, outcome.said["compared"][0][1], delta=30)

    def test_a_reload_that_was_passed_costs_the_whole_range(self):
        late, preloaded = Emulator.run("late_reload").said["overflow"]
        self.assertAlmostEqual(65_536 + 1000, late[1], delta=50)
        self.assertAlmostEqual(20_000, preloaded[1], delta=50)

    def test_pulse_widths_change_between_periods(self):
        outcome = Emulator.run("pwm")
        courses = outcome.events("pwm", "TIM1_CH1 ")
        self.assertEqual(["2100/8400 168000000", "0", "4200/8400 168000000", "1",
                          "2100/8400 168000000", "z"],
                         [rest.split(" ", 1)[1] for _, rest in courses])
        written = [ns for ns, rest in outcome.events("pin", "PA0 1")]
        changed = [ns for ns, _ in courses[1:5]]
        for before, after in zip(written, changed):
            self.assertTrue(0 < after - before <= 50_000 + INSTRUCTION_NS, (before, after))
        for before, after in zip(changed, changed[1:]):
            off = (after - before + 25_000) % 50_000 - 25_000
            self.assertLessEqual(abs(off), 2 * INSTRUCTION_NS)
