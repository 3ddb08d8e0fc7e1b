"""Tests the image of a board with CAN as a node of a bus. Other nodes send what a script contains:
text, stops, a host that falls silent, and a master that assigns numbers.

    test_can.py PLUGIN kerfline_generic_can.elf
"""

import pathlib
import tempfile
import unittest

import chip
from chip import MS

NODE = 17
NETWORK, FAIL_SAFE, REALTIME, TEXT_TO, TEXT_FROM = 0x000, 0x001, 0x200, 0x500, 0x480
EMERGENCY, HEARTBEAT, HOST_HEARTBEAT, LSS_TO, LSS_FROM = 0x080, 0x700, 0x77F, 0x7E5, 0x7E4
START, STOP, RESET_COMMUNICATION = 0x01, 0x02, 0x82
BEGIN = 100 * MS  # Of talking: the image has started.
SET_UP = ["$32=1", "$858=0", "$120=2000", "$121=2000"]
STEP_PIN, BEAM_PIN, BEAM_TIMER = "PA0", "PA8", "TIM1_CH1"


class Script:
    """Frames of other nodes, with their start times."""

    def __init__(self, node: int = NODE):
        self.node, self.now, self.frames = node, BEGIN, []
        self.listens_from = None

    def wait(self, ms: float) -> "Script":
        self.now += int(ms * MS)
        return self

    def frame(self, identifier: int, *data: int) -> "Script":
        self.frames.append((self.now, f"{identifier:03X}#{bytes(data).hex().upper()}"))
        return self

    def line(self, text: str) -> "Script":
        """Sends a line in as many frames as it requires; the flow control arrives within two
        cycles."""
        data = (text + "\n").encode()
        if len(data) < 8:
            return self.frame(TEXT_TO + self.node, len(data), *data).wait(2)
        self.frame(TEXT_TO + self.node, 0x10 | len(data) >> 8, len(data) & 255, *data[:6]).wait(3)
        for number, at in enumerate(range(6, len(data), 7), 1):
            self.frame(TEXT_TO + self.node, 0x20 | number & 15, *data[at:at + 7])
            self.wait(0.5)
        return self.wait(2)

    def start(self) -> "Script":
        self.listens_from = self.now + MS
        return self.frame(NETWORK, START, self.node).wait(20)

    def lines(self, lines: list) -> "Script":
        for line in lines:
            self.line(line)
            self.wait(20 if line.startswith("$") else 2)  # The store is written at rest.
        return self

    def beats(self, until_ns: int) -> "Script":
        """Sends the host's heartbeat from the beginning on."""
        self.frames += [(at, f"{HOST_HEARTBEAT:03X}#05") for at in range(BEGIN, until_ns, 20 * MS)]
        return self

    def text(self, stop_ns: int) -> str:
        """Returns the script with a flow control every 2 ms, which permits any message that the
        node has begun."""
        leave = f"{TEXT_TO + self.node:03X}#300000"
        begin = stop_ns if self.listens_from is None else self.listens_from
        frames = sorted(self.frames + [(ns, leave) for ns in range(begin, stop_ns, 2 * MS)])
        return "".join(f"{ns} {frame}\n" for ns, frame in frames)


class Node:
    """Result of a run of the image, as seen from the bus and the pins."""

    def __init__(self, script: Script, stop_ns: int, folder: pathlib.Path, *options: str):
        frames = folder / "frames"
        frames.write_text(script.text(stop_ns))
        self.run = CHIP.run("", stop_ns, *chip.CHIP_OPTIONS, f"can_in={frames}", *options)
        self.sent = [(ns, *rest.split()[1].split("#")) for ns, source, rest in self.run.trace
                     if source == "can" and rest.startswith("tx ")]

    def payloads(self, identifier: int) -> list:
        return [(ns, bytes.fromhex(data)) for ns, name, data in self.sent
                if int(name, 16) == identifier]

    def said(self, node: int = NODE) -> str:
        text, left = b"", 0
        for _, data in self.payloads(TEXT_FROM + node):
            kind, low = data[0] >> 4, data[0] & 15
            if kind == 0:
                text += data[1:1 + low]
            elif kind == 1:
                left = (low << 8 | data[1]) - 6
                text += data[2:8]
            elif kind == 2:
                text += data[1:1 + min(7, left)]
                left -= min(7, left)
        return text.decode("latin-1")

    def steps(self) -> list:
        return self.run.times("pin", f"{STEP_PIN} 1")

    def lit(self) -> list:
        """Returns the times at which the beam's pulses began and ended."""
        return [(ns, rest.split()[1] not in ("0", "z")) for ns, source, rest in self.run.trace
                if source == "pwm" and rest.startswith(BEAM_TIMER + " ")]

    def dark_from(self) -> int:
        return next(ns for ns, lit in reversed(self.lit()) if not lit)


class CanImageTest(unittest.TestCase):
    def node(self, script: Script, stop_ns: int, *options: str) -> Node:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        return Node(script, stop_ns, pathlib.Path(folder.name), *options)

    def test_greets_answers_and_drives(self):
        script = Script().start().line("$I").lines([*SET_UP, "G91 M4 S500", "G1 X2 F3000"])
        script.wait(10).frame(REALTIME + NODE, ord("?"))
        node = self.node(script, script.now + 300 * MS)
        self.assertEqual(node.payloads(HEARTBEAT + NODE)[0][1], b"\0", "it has begun")
        said = node.said()
        self.assertIn("Grbl 1.1h ['$' for help]", said)
        self.assertIn("[VER:1.1h", said)
        self.assertIn("<Run|", said)
        self.assertEqual(said.count("ok\r\n"), 1 + len(SET_UP) + 2, said)
        self.assertEqual(len(node.steps()), 2 * 250)

    def stopped(self, *frame: int):
        script = Script().start().lines([*SET_UP, "G91 M4 S500", "G1 X40 F3000"])
        script.wait(200).frame(*frame)
        stop_ns = script.now
        node = self.node(script.beats(stop_ns + 300 * MS), stop_ns + 300 * MS)
        self.assertTrue(any(at < stop_ns - MS for at in node.steps()))
        frame_ns = 300_000  # 130 bits at 500 kbit/s are less.
        # The limit: the frame, the cycle that sees it, and the cycle after it.
        self.assertLess(max(node.steps()), stop_ns + frame_ns + 2 * MS)
        self.assertLess(node.dark_from(), stop_ns + frame_ns + 2 * MS)
        told = [data for ns, data in node.payloads(EMERGENCY + NODE) if ns > stop_ns]
        self.assertEqual([(data[0], data[1], data[3]) for data in told], [(0, 0xFF, 24)])
        self.assertIn("ALARM:24", node.said())
        print(f"  last step {(max(node.steps()) - stop_ns) / 1e6:.2f} ms, dark "
              f"{(node.dark_from() - stop_ns) / 1e6:.2f} ms after the frame began")

    def test_a_stop_of_the_network_stops_it_dark(self):
        self.stopped(NETWORK, STOP, 0)

    def test_a_fail_safe_frame_stops_it_dark(self):
        self.stopped(FAIL_SAFE)

    def test_a_silent_host_is_a_sender_that_is_lost(self):
        script = Script().start().lines([*SET_UP, "G91 M4 S500", "G1 X40 F3000"]).wait(200)
        silent_ns = script.now
        node = self.node(script.beats(silent_ns), silent_ns + 500 * MS)
        self.assertLess(node.dark_from(), silent_ns + 100 * MS)
        self.assertGreater(node.dark_from(), silent_ns)
        told = [data for ns, data in node.payloads(EMERGENCY + NODE) if ns > silent_ns]
        self.assertEqual(told[0][:2], b"\x30\x81")

    def test_no_frame_is_lost_on_a_bus_that_corrupts_some(self):
        script = Script().start().lines([*SET_UP, "G91 M4 S500", *["G1 X0.1 F3000"] * 20])
        for percent in (0, 5, 30):
            with self.subTest(percent=percent):
                slow = Script()
                slow.frames = [(BEGIN + 4 * (ns - BEGIN), frame) for ns, frame in script.frames]
                slow.listens_from = script.listens_from
                node = self.node(slow, BEGIN + 4 * (script.now - BEGIN) + 300 * MS,
                                 f"can_corrupt={percent}", "seed=3")
                self.assertEqual(len(node.steps()), 500)

    def test_a_master_gives_it_a_number_that_is_stored(self):
        script = Script()
        for command in ((0x04, 1), (0x5A,), (0x5E,), (0x11, 0x22), (0x17,), (0x04, 0)):
            script.frame(LSS_TO, *command, *[0] * (8 - len(command))).wait(30)
        script.frame(NETWORK, RESET_COMMUNICATION, 0).wait(20)
        script.node = 0x22
        script.start().line("$859").wait(50)
        node = self.node(script, script.now + 100 * MS)
        answers = [data[:2] for _, data in node.payloads(LSS_FROM)]
        self.assertEqual(answers, [b"\x5A\0", bytes((0x5E, NODE)), b"\x11\0", b"\x17\0"])
        self.assertEqual(node.payloads(HEARTBEAT + 0x22)[0][1], b"\0")
        self.assertIn("$859=34", node.said(0x22))


CHIP: chip.Chip
if __name__ == "__main__":
    chip.main(globals(), "test_can.py")
