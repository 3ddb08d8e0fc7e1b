"""Tests the serial port: times of bytes, overruns, wrong rates, a sender that waits, and a device."""

import random
import unittest

from emulator import Emulator, Files

DIVISOR, BUS_HZ = 729, 84e6
BYTE_NS = 10 * DIVISOR / BUS_HZ * 1e9
END = b"\x04"
# Sometimes the emulator calls an alarm some tens of instructions late.
LATE_NS = 400


def checksum(data: bytes) -> int:
    value = 0
    for byte in data:
        value = (value * 31 + byte) & 0xFFFF_FFFF
    return value


class SerialTest(unittest.TestCase):
    def setUp(self):
        self.files = Files(self)
        draw = random.Random(1)
        self.data = bytes(draw.choice(range(5, 256)) for _ in range(1000)) + END

    def spacings(self, outcome, way: str) -> set:
        times = [ns for ns, _ in outcome.events("USART1", way)]
        return {after - before for before, after in zip(times, times[1:])}

    def test_bytes_take_their_time_both_ways(self):
        sent = self.files("in", self.data)
        got = self.files("out")
        outcome = Emulator.run("usart", f"usart1_in={sent}", f"usart1_out={got}")
        self.assertEqual([[len(self.data), checksum(self.data)]], outcome.said["bytes"])
        self.assertEqual([[0, 0]], outcome.said["errors"])
        self.assertEqual(b"all of this goes out", got.read_bytes())
        for way in ("rx", "tx"):
            for spacing in self.spacings(outcome, way):
                self.assertAlmostEqual(BYTE_NS, spacing, delta=LATE_NS)

    def test_a_sender_that_begins_later(self):
        sent = self.files("in", self.data)
        outcome = Emulator.run("usart", f"usart1_in={sent}", "usart1_from_ns=50000000")
        self.assertAlmostEqual(50_000_000 + BYTE_NS, outcome.events("USART1", "rx")[0][0],
                               delta=LATE_NS)
        self.assertEqual([[len(self.data), checksum(self.data)]], outcome.said["bytes"])

    def test_a_sender_of_its_own_rate(self):
        sent = self.files("in", self.data)
        outcome = Emulator.run("usart", f"usart1_in={sent}", "usart1_baud=115200")
        self.assertEqual([[len(self.data), checksum(self.data)]], outcome.said["bytes"])
        for spacing in self.spacings(outcome, "rx"):
            self.assertAlmostEqual(10e9 / 115_200, spacing, delta=LATE_NS)
        wrong = Emulator.run("usart", f"usart1_in={sent}", "usart1_baud=57600").said
        self.assertEqual([[0, wrong["bytes"][0][0]]], wrong["errors"])  # Each byte is framed wrong.
        self.assertGreater(wrong["bytes"][0][0], 0)

    def test_answers_go_out_at_a_rate_of_their_own(self):
        sent, got = self.files("in", self.data), self.files("out")
        outcome = Emulator.run("usart", f"usart1_in={sent}", f"usart1_out={got}",
                               "usart1_answer_baud=57600")
        self.assertEqual([[len(self.data), checksum(self.data)]], outcome.said["bytes"])
        self.assertEqual([[0, 0]], outcome.said["errors"])
        self.assertEqual(b"all of this goes out", got.read_bytes())
        for way, wanted in ("rx", BYTE_NS), ("tx", 10e9 / 57_600):
            for spacing in self.spacings(outcome, way):
                self.assertAlmostEqual(wanted, spacing, delta=LATE_NS)

    def test_bytes_that_nobody_takes_are_lost(self):
        sent = self.files("in", self.data)
        outcome = Emulator.run("usart_late", f"usart1_in={sent}")
        received = len(outcome.events("USART1", "rx"))
        overruns = len(outcome.events("USART1", "overrun"))
        self.assertEqual([[30, 0]], outcome.said["errors"])
        self.assertEqual(30, outcome.said["bytes"][0][0])
        self.assertAlmostEqual(30e6 / BYTE_NS, received, delta=3)
        self.assertIn(received - overruns, (30, 31))

    def test_a_sender_that_counts_characters(self):
        lines = [b"G1 X%d\n" % (7 ** (i % 9)) for i in range(25)] + [END + b"\n"]
        sent, got = self.files("in", b"".join(lines)), self.files("out")
        window = 40
        outcome = Emulator.run("lines", f"usart1_in={sent}", f"usart1_out={got}",
                               f"usart1_window={window}")
        self.assertEqual([[0, 0]], outcome.said["errors"])
        self.assertEqual(b"ok\n" * 25 + b"bye\n", got.read_bytes())
        waiting = most = answered = 0
        for _, _, rest in outcome.trace:
            if rest.startswith("rx "):
                waiting += 1
                most = max(most, waiting)
            elif rest == "tx 0a" and answered < 25:
                waiting -= len(lines[answered])
                answered += 1
        self.assertTrue(window - 10 < most <= window, most)

    def test_a_device_at_the_other_end(self):
        lines = b"G0 X1\nG0 X2\n" + END
        # Without a set end: while the image waits for bytes, virtual time would jump to it.
        outcome = Emulator.run("lines", "usart1_chardev=link", "stop_ns=0", stdin=lines,
                               extra=("-chardev", "stdio,id=link,signal=off"))
        self.assertEqual(b"ok\nok\nbye\n", outcome.output)
        self.assertEqual([[len(lines), checksum(lines)]], outcome.said["bytes"])
