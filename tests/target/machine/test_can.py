"""Tests CAN: lengths of frames, filters, error counters, bus-off and the ways out of it."""

import unittest

from emulator import Emulator, Files

BIT_NS = 2000
RECOVERY_BITS = 128 * 11
ACKNOWLEDGE_ERROR, RECESSIVE_ERROR = 3, 4


def bits_on_wire(identifier: int, data: bytes) -> int:
    """Returns the number of bits of a data frame with an identifier of 11 bits, including stuff
    bits and intermission."""
    bits = f"0{identifier:011b}000{len(data):04b}" + "".join(f"{byte:08b}" for byte in data)
    rest = int(bits, 2) << 15  # Long division by the generator of ISO 11898-1.
    for place in range(len(bits) + 14, 14, -1):
        if rest >> place & 1:
            rest ^= 0xC599 << (place - 15)
    bits += f"{rest:015b}"
    stuffed, run, last = 0, 0, ""
    for bit in bits:
        run, last = (run + 1 if bit == last else 1), bit
        if run == 5:
            stuffed, run, last = stuffed + 1, 1, "10"[int(bit)]
    return len(bits) + stuffed + 1 + 2 + 7 + 3


class CanTest(unittest.TestCase):
    def assert_counters(self, outcome):
        """Asserts that each error and each success changes the counters as the standard says."""
        sent = received = 0
        for _, rest in outcome.events("can"):
            kind, *values = rest.split()
            if kind == "error":
                code = int(values[0])
                if code == 1:
                    received += 1
                elif code != ACKNOWLEDGE_ERROR or sent <= 127:
                    sent += 8
                self.assertEqual(["tec", str(sent), "rec", str(received)], values[1:])
            elif kind == "tx":
                sent = max(0, sent - 1)
            elif kind == "rx":
                received = max(0, received - 1)
            elif kind == "recovered":
                sent = received = 0
        return sent, received

    def test_frames_take_their_bits(self):
        outcome = Emulator.run("can_loop")
        self.assertEqual([[1]], outcome.said["joined"])
        self.assertEqual([[50, 0]], outcome.said["received"])
        frames = [(ns, rest.split()[1].split("#")) for ns, rest in outcome.events("can", "tx")]
        self.assertEqual(50, len(frames))
        for (before, _), (after, (identifier, data)) in zip(frames, frames[1:]):
            wire_ns = bits_on_wire(int(identifier, 16), bytes.fromhex(data)) * BIT_NS
            self.assertTrue(0 <= after - before - wire_ns < 500, (identifier, after - before, wire_ns))

    def test_all_frames_arrive_though_some_are_corrupted(self):
        for percent in (5, 10, 30):
            outcome = Emulator.run("can_loop", f"can_corrupt={percent}", f"seed={percent}")
            self.assertEqual([[50, 0]], outcome.said["received"])
            errors = len(outcome.events("can", "error"))
            self.assertAlmostEqual(percent / 100, errors / (50 + errors), delta=0.12)
            self.assert_counters(outcome)

    def test_others_and_the_filter(self):
        others = Files(self)("others", "3000000 2A5#01020304\n3000000 2A6#01020304\n"
                             "4000000 000002A5#01020304\n5000000 2A5#0500\n5000001 2A5#\n"
                             "5000002 2A5#R4\n")
        for corrupt in (0, 30):
            sent = Files(self)("sent")
            outcome = Emulator.run("can_bus", f"can_in={others}", f"can_out={sent}",
                                   f"can_corrupt={corrupt}", "seed=3")
            self.assertEqual([[3]], [values[:1] for values in outcome.said["received"]])
            self.assertEqual(["300#00000000", "301#01000000", "302#02000000"],
                             [line.split()[1] for line in sent.read_text().splitlines()])
            self.assertEqual(6, len(outcome.events("can", "rx")))
            self.assertEqual([list(self.assert_counters(outcome))], outcome.said["counters"])
            self.assertEqual(corrupt > 0, len(outcome.events("can", "error 1")) > 0)

    def test_nobody_acknowledges(self):
        outcome = Emulator.run("can_off", "can_alone=on")
        self.assertEqual([[0, 128]], outcome.said["off"])
        self.assertEqual([[1, ACKNOWLEDGE_ERROR]], outcome.said["passive"])
        self.assert_counters(outcome)

    def test_bus_off_and_both_ways_back(self):
        outcome = Emulator.run("can_off", "can_corrupt=100")
        events = [rest for _, rest in outcome.events("can")]
        self.assertEqual(32, events.index("bus-off"))  # 32 errors of 8 each are 256.
        self.assertEqual([[1, 255]], outcome.said["off"])
        self.assertEqual([[1, RECESSIVE_ERROR]], outcome.said["passive"])
        self.assertEqual([[1]], outcome.said["interrupts"])
        self.assertEqual([[1]], outcome.said["still_off"])
        for us, counters in outcome.said["back_us"]:
            self.assertAlmostEqual(RECOVERY_BITS * BIT_NS / 1000, us, delta=2)
            self.assertEqual(0, counters)
        self.assertEqual(2, len(outcome.said["back_us"]))
        self.assert_counters(outcome)
