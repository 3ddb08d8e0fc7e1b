"""Tests clocks, resets, watchdog, memories and options, and that all runs are the same."""

import unittest

from emulator import STOPPED, Emulator, Files

POWER_ON, SOFTWARE, WATCHDOG = 0x0E, 0x14, 0x24  # RCC_CSR, bits 24 to 31.


class CoreTest(unittest.TestCase):
    def test_clock_tree_and_causes_of_reset(self):
        outcome = Emulator.run("clocks")
        said = outcome.said
        self.assertEqual([[POWER_ON], [SOFTWARE]], said["cause"])
        self.assertEqual([[0], [0]], said["forgotten_cause"])
        self.assertEqual([[0], [0]], said["without_clock"])
        self.assertEqual([[0xA800_0000]] * 2, said["with_clock"])
        good, count = said["ready"][0]
        self.assertEqual(1, good)
        # The crystal takes 2 ms and the PLL 200 us, counted at the inner oscillator's 16 MHz.
        self.assertAlmostEqual(16 * 2200, count, delta=50)
        self.assertIn("GPIOA: offset 0x0 without its clock",
                      [rest for _, rest in outcome.events("misuse")])

    def test_no_crystal(self):
        self.assertEqual(0, Emulator.run("clocks", "crystal_hz=0").said["ready"][0][0])

    def test_too_fast_for_the_chip_is_told(self):
        outcome = Emulator.run("clocks", "crystal_hz=16000000")
        told = [rest for _, rest in outcome.events("misuse", "RCC")]
        self.assertEqual({"RCC: core at 336000000 Hz", "RCC: APB1 above 42 MHz",
                          "RCC: APB2 above 84 MHz"}, set(told))

    def test_watchdog_bites_when_it_is_not_fed(self):
        for slow_hz in (32_000, 40_000):
            outcome = Emulator.run("watchdog", f"slow_hz={slow_hz}")
            self.assertEqual([[POWER_ON], [WATCHDOG]], outcome.said["cause"])
            self.assertEqual([[0xFFF]], outcome.said["protected"])
            self.assertEqual([[3]], outcome.said["updating"])
            fed, = (ns for ns, _ in outcome.events("pin", "PA0 1"))
            bitten, = (ns for ns, _ in outcome.events("watchdog"))
            self.assertAlmostEqual(256 * 4e9 / slow_hz, bitten - fed, delta=100)
            released = [ns for ns, _ in outcome.events("pin", "PA0 z")]
            self.assertEqual(bitten, released[-1])

    def test_memories_and_their_ends(self):
        outcome = Emulator.run("memory")
        said = outcome.said
        self.assertEqual([[1]] * 4, said["kept"])
        self.assertEqual([[1, 1]] * 3, said["beyond"])
        self.assertEqual(4, len(outcome.events("misuse", "beyond SRAM")))
        self.assertEqual([[1024]], said["flash_kb"])
        self.assertEqual([[0x413]], said["code"])
        self.assertEqual([[0, 0]] * 3, said["flash_end"])
        self.assertEqual(said["unique"], Emulator.run("memory").said["unique"])
        self.assertNotEqual(said["unique"], Emulator.run("memory", "seed=2").said["unique"])

    def test_the_flash_ends_where_the_chip_says(self):
        for kib, ends in ((512, [[0, 0], [0, 1], [1, 0]]), (256, [[0, 1], [1, 1], [1, 0]])):
            outcome = Emulator.run("memory", f"flash_kib={kib}")
            self.assertEqual([[kib]], outcome.said["flash_kb"])
            self.assertEqual(ends, outcome.said["flash_end"])
            self.assertTrue(outcome.events("misuse", "beyond flash"))

    def test_cycles_are_time_at_the_clock_of_the_core(self):
        said = Emulator.run("memory").said
        self.assertEqual([[0]], said["without_tracing"])
        (cycles, us), = said["cycles"]
        self.assertAlmostEqual(us, cycles / 168, delta=2)

    def test_a_bit_turns_over_when_it_should(self):
        outcome = Emulator.run("flip", "flip=2001F011:3:5000000", "flip=2001F012:0:9000000")
        self.assertEqual([[1 << 11]], outcome.said["flipped"])
        self.assertEqual([(5_000_000, "2001f011 3")], outcome.events("flip"))

    def test_a_word_changes_when_it_should(self):
        outcome = Emulator.run("flip", "store=2001F010:cafe0001:7000000")
        self.assertEqual([[0xCAFE0001]], outcome.said["flipped"])

    def test_stop(self):
        outcome = Emulator.run("watchdog", "stop_ns=1000000")
        self.assertEqual(STOPPED, outcome.status)
        self.assertEqual((1_000_000, "end", str(STOPPED)), outcome.trace[-1])

    def test_what_cannot_be_is_refused(self):
        empty = Files(self)("empty", "")
        wrong = Files(self)("wrong", "5 PA0 1\n4 PA0 0\n")
        for option in ("nonsense=1", "nonsense", "cut=-1", "cut_kind=half", "flip=20000000:8:1",
                       "flip=20000000:1", "store=20000002:0:1", "can_corrupt=101", "flash_kib=128",
                       "flash_kib=2048", "memories_only=yes", "usart7_in=x", "usart1_window=x",
                       f"usart1_in={empty}.not", f"can_in={empty}.not", f"pins={wrong}",
                       f"can_in={wrong}", "usart1_chardev=nobody", "trace="):
            outcome = Emulator.run("clocks", option)
            self.assertNotEqual(0, outcome.status, option)
            self.assertIn("machine: ", outcome.text, option)
        outcome = Emulator.run("clocks", machine="mps2-an386")
        self.assertNotEqual(0, outcome.status)
        self.assertIn("machine: needs -M netduinoplus2", outcome.text)

    def test_two_runs_are_the_same(self):
        text = Files(self)("text", b"some bytes\x04")
        for scenario, *options in (("watchdog",), ("periods",), ("usart", f"usart1_in={text}"),
                                   ("can_loop", "can_corrupt=20", "seed=5")):
            first, second = (Emulator.run(scenario, *options) for _ in range(2))
            self.assertEqual((first.trace, first.text), (second.trace, second.text))
        self.assertNotEqual(first.trace, Emulator.run("can_loop", "can_corrupt=20", "seed=6").trace)
