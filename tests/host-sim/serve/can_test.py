#!/usr/bin/python3
"""`kerfline serve --slcan` with python-can as its peer: a controller on a CAN bus. This test
assembles messages of ISO 15765-2 independently of the firmware.

    can_test.py KERFLINE
"""
import contextlib
import sys
import time

try:
    import can
except ImportError:
    print("skipped: python3-can is missing")
    sys.exit(77)

from served import BANNER, LASER, ServeTest, main

NODE = 0x23
TO, FROM, REALTIME = 0x500 + NODE, 0x480 + NODE, 0x200 + NODE
EMERGENCY, HEARTBEAT, HOST_HEARTBEAT, NETWORK = 0x080 + NODE, 0x700 + NODE, 0x77F, 0x000
START, STOP, RESET_COMMUNICATION = 0x01, 0x02, 0x82
LSS_TO, LSS_FROM = 0x7E5, 0x7E4


class Host:
    """A node that talks to the controller. It reads until the expected answer has come."""

    def __init__(self, address, beats=True):
        self.bus = can.Bus(interface="slcan", channel=address, sleep_after_open=0.1)
        self.beats, self.beaten = beats, 0.0
        self.text, self.frames, self.message, self.left, self.number = "", [], b"", 0, 0
        self.leave = None

    def send(self, identifier, *data):
        self.bus.send(can.Message(arbitration_id=identifier, data=bytes(data), is_extended_id=False))

    def hear(self, seconds=0.002):
        if self.beats and time.monotonic() > self.beaten + 0.02:
            self.beaten = time.monotonic()
            self.send(HOST_HEARTBEAT, 0x05)
        frame = self.bus.recv(seconds)
        if frame is None:
            return
        self.frames.append(frame)
        if frame.arbitration_id == FROM:
            self.take(frame.data)

    def take(self, data):
        kind, low = data[0] >> 4, data[0] & 15
        if kind == 0:
            self.text += data[1:1 + low].decode("latin-1")
        elif kind == 1:
            self.left = (low << 8 | data[1]) - 6
            self.message, self.number = bytes(data[2:8]), 1
            self.send(TO, 0x30, 0, 0)
        elif kind == 2:
            assert low == self.number, (low, self.number)
            self.number = (self.number + 1) & 15
            part = bytes(data[1:1 + min(7, self.left)])
            self.message += part
            self.left -= len(part)
            if self.left == 0:
                self.text += self.message.decode("latin-1")
        elif kind == 3:
            self.leave = (low, data[1])

    def say(self, text):
        data = text.encode()
        if len(data) < 8:
            return self.send(TO, len(data), *data)
        self.send(TO, 0x10 | len(data) >> 8, len(data) & 255, *data[:6])
        rest, number = data[6:], 1
        while rest:
            self.leave, end = None, time.monotonic() + 2
            while self.leave is None or self.leave[0] == 1:
                assert time.monotonic() < end, "no flow control"
                self.hear()
            assert self.leave[0] == 0, self.leave
            for _ in range(self.leave[1] or 10**6):
                if not rest:
                    break
                self.send(TO, 0x20 | number, *rest[:7])
                rest, number = rest[7:], number + 1 & 15
        return None

    def until(self, words, seconds=5.0):
        end = time.monotonic() + seconds
        while words not in self.text:
            if time.monotonic() > end:
                raise TimeoutError(f"{words!r} not in {self.text!r}")
            self.hear()
        place = self.text.index(words) + len(words)
        found, self.text = self.text[:place], self.text[place:]
        return found

    def until_frame(self, identifier, seconds=3.0):
        end = time.monotonic() + seconds
        while True:
            for frame in self.frames:
                if frame.arbitration_id == identifier:
                    self.frames.remove(frame)
                    return bytes(frame.data)
            if time.monotonic() > end:
                raise TimeoutError(f"no {identifier:#x}")
            self.hear()

    def pass_time(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.hear()

    def ask(self, line):
        self.say(line + "\n")
        return self.until("ok\r\n")

    def report(self):
        self.send(REALTIME, ord("?"))
        return self.until(">\r\n")


class Can(ServeTest):
    def open(self, *arguments, beats=True):
        # The bus is tested here. For $858, a host that sends only heartbeats would count as gone,
        # so $858 is off.
        served = self.serve("--slcan", self.link, "--node", NODE, *LASER, "--set", "$858=0",
                            *arguments)
        self.served = served
        self.assertEqual(served.ways["slcan"], f"{self.link} node {NODE}")
        host = Host(str(self.link), beats)
        self.addCleanup(self.leave, host)
        host.send(NETWORK, START, NODE)
        host.until(BANNER)
        return host

    @staticmethod
    def leave(host):
        with contextlib.suppress(can.CanError):  # Where the other end is gone already.
            host.bus.shutdown()

    def test_greets_and_answers(self):
        host = self.open()
        self.assertIn("[VER:1.1h", host.ask("$I"))
        self.assertIn("<Idle", host.report())
        self.assertEqual(host.ask("G21 G90 G0 X0 Y0 (a comment longer than a frame or two)"), "ok\r\n")
        self.assertIn(host.until_frame(HEARTBEAT), (b"\x00", b"\x05", b"\x7f"))

    def test_is_behind_a_port_as_well_for_one_host_after_another(self):
        served = self.serve("--slcan", "tcp:0", "--node", NODE)
        address = served.ways["slcan"].split()[0].removeprefix("tcp:")
        for _ in range(2):
            host = Host("socket://" + address)
            host.send(NETWORK, START, NODE)
            host.until(BANNER)
            self.assertIn("[VER:1.1h", host.ask("$I"))
            host.bus.shutdown()
            time.sleep(0.3)

    def test_a_master_finds_it_and_gives_it_a_number(self):
        """The frames follow CiA 305; the simulator's serial number is that of its node."""
        store = self.folder / "store"
        host = self.open("--store", store)

        def configure(command, *data):
            host.frames.clear()
            host.send(LSS_TO, command, *data, *[0] * (7 - len(data)))
            return host.until_frame(LSS_FROM)[:2]

        for command, number in (0x40, 0), (0x41, 0x4B657266), (0x42, 1):
            host.send(LSS_TO, command, *number.to_bytes(4, "little"), 0, 0, 0)
        self.assertEqual(configure(0x43, NODE), b"\x44\0")
        self.assertEqual(configure(0x11, 127), b"\x11\x01")
        self.assertEqual(configure(0x11, NODE + 1), b"\x11\0")
        self.assertEqual(configure(0x17), b"\x17\0")
        host.send(LSS_TO, 0x04, 0, 0, 0, 0, 0, 0, 0)
        self.assertIn("<Idle", host.report(), "its number is the old one")
        host.send(NETWORK, RESET_COMMUNICATION, NODE)
        host.frames.clear()
        self.assertEqual(host.until_frame(HEARTBEAT + 1), b"\0", "it begins as another")
        self.served.stop()
        served = self.serve("--slcan", self.link, "--store", store)
        self.assertEqual(served.ways["slcan"], f"{self.link} node {NODE + 1}", "it was stored")

    def test_drives_a_job(self):
        host = self.open("--speed", 20)
        for number in range(200):
            host.say(f"G91 G1 X0.1 Y{0.05 * (number % 3)} F3000\n")
        for _ in range(200):
            host.until("ok\r\n")
        end = time.monotonic() + 10
        while "<Idle" not in host.report():
            self.assertLess(time.monotonic(), end)
        self.assertIn("MPos:20.000,9.952,", host.report())

    def stop(self, *frame):
        host = self.open()
        host.ask("G91 M4 S500 G1 X100 F600")
        host.pass_time(0.3)
        self.assertIn("<Run", host.report())
        host.send(*frame)
        told = host.until_frame(EMERGENCY, 0.5)
        self.assertEqual((told[0], told[1], told[3]), (0x00, 0xFF, 24))
        host.until("ALARM:24\r\n")
        self.assertIn("<Alarm", host.report())

    def test_a_stop_of_the_network_leaves_an_alarm(self):
        self.stop(NETWORK, STOP, 0)

    def test_a_fail_safe_frame_leaves_an_alarm(self):
        self.stop(0x001)

    def test_a_hold_overtakes_an_unfinished_comment(self):
        host = self.open()
        host.ask("G91 G1 X100 F600")
        host.say("G1 X1 (not over")
        host.pass_time(0.2)
        host.send(REALTIME, ord("!"))
        host.pass_time(0.5)
        self.assertIn("<Hold", host.report())

    def test_a_host_that_falls_silent_is_a_sender_that_is_lost(self):
        host = self.open()
        host.ask("G91 M4 S500 G1 X100 F600")
        host.pass_time(0.3)
        time.sleep(0.5)
        host.frames.clear()
        told = host.until_frame(EMERGENCY)
        self.assertEqual((told[0], told[1]), (0x30, 0x81))
        host.pass_time(0.5)
        host.send(NETWORK, START, NODE)
        host.until(BANNER)
        first = host.report()
        self.assertIn("<Idle", first)
        host.pass_time(0.3)
        self.assertEqual(first.split("|")[1], host.report().split("|")[1], "it stands still")


if __name__ == "__main__":
    main()
