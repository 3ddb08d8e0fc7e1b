"""`kerfline send` as a user runs it: over a pty and TCP of `kerfline serve`, killed, and through a
relay that damages bytes."""
import concurrent.futures
import os
import pathlib
import signal
import socket
import subprocess
import sys
import threading
import time
import unittest

from relays import Relay, Rewriter
from send_bench import SETTINGS, SendBench, served

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import seeds_of  # noqa: E402


class SendTest(SendBench):
    def test_sends_over_every_link_in_both_forms(self):
        server = self.serve("--pty", self.link, "--tcp", 0, "--speed", 20, *SETTINGS)
        job, far = self.square(20)
        for link in (("--port", self.link), ("--tcp", f"127.0.0.1:{server.port('tcp')}")):
            for form in ((), ("--checked",)):
                with self.subTest(link=link[0], form=form):
                    log = self.folder / "log"
                    status, out, err = self.send(job, *link, *form, "--log", log)
                    self.assertEqual((status, err), (0, ""))
                    self.assertIn("83 of 83 lines", out)
                    self.assertEqual(log.read_text().count(" < ok"), self.oks(83, form))
        self.check_x(server, 4 * far)

    @staticmethod
    def oks(lines, form):
        """Returns the number of `ok` for the lines of a job. They include an empty line, $I, $$,
        $# and $G for the requests before it, and an empty line and $I before the job itself.
        With checked lines, the requests are sent three times, and M110 is sent around each
        round and the job.
        """
        return lines + 5 + 2 + (2 * 5 + 8) * len(form)

    def test_sends_over_a_can_adapter(self):
        server = self.serve("--slcan", self.link, "--tcp", 0, "--speed", 20, *SETTINGS)
        job, far = self.square(20)
        log = self.folder / "log"
        for form in ((), ("--checked",)):
            with self.subTest(form=form):
                status, out, err = self.send(job, "--slcan", self.link, *form, "--log", log)
                self.assertEqual((status, err), (0, ""))
                self.assertIn("83 of 83 lines", out)
                self.assertEqual(log.read_text().count(" < ok"), self.oks(83, form))
        self.check_x(server, 2 * far)

    def test_tells_what_a_node_of_a_can_bus_tells(self):
        server = self.serve("--slcan", self.link, *SETTINGS)
        job = self.program_file(["G91 G1 X1 F6000", "G1 X2000"])
        log = self.folder / "log"
        status, _, err = self.send(job, "--slcan", self.link, "--node", 18, "--log", log)
        self.assertEqual(status, 1)
        self.assertIn("node 18 is silent on", err)
        process = self.start(job, "--slcan", self.link, "--log", log, "--accept-faults")
        time.sleep(2.0)
        server.stop(signal.SIGKILL)
        _, err = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 1)
        self.assertIn("is gone", err)

    def test_says_which_line_was_refused_and_stops(self):
        server = self.serve("--tcp", 0, *SETTINGS)
        job = self.program_file(["G91 G1 X1 F6000", "G99 (no such word)", "G1 X1"])
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        status, out, err = self.send(job, *where, "--accept-faults")
        self.assertEqual(status, 1)
        self.assertRegex(err, r"line 2: error:20: .*\. Leave the word out")
        status, out, err = self.send(
            job, *where, "--accept-faults", "--keep-going", "--checked")
        self.assertEqual(status, 1)
        self.assertIn("3 of 3 lines", out)
        self.assertIn("1 refused", out)

    def test_sends_nothing_of_a_program_with_faults_or_beyond_the_travel(self):
        server = self.serve("--tcp", 0, *SETTINGS, "--set", "$130=100")
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        for lines, words in (
                (["G91 G1 X1 F6000", "G99"], "job.nc:2:1: G99 is not supported"),
                (["G7"] * 135 + ["G0 X999"], "and 35 more lines that are refused"),
                (["G7"] * 135 + ["G0 X999"], "job.nc:136:4: X needs 999.000 mm of travel"),
                (["G5 I0 J500 P0 Q500 X1 Y0 F600", "G5 I900 J0 P-900 Q0 X2 Y0"], "X needs ")):
            status, _, err = self.send(self.program_file(lines), *where)
            self.assertEqual(status, 1)
            self.assertIn(words, err)
            self.assertIn("nothing was sent", err)
            self.assertIn("--accept-faults", err)
        self.check_x(server, 0.0)

    def test_says_that_a_controller_is_in_alarm_and_unlocks_it(self):
        server = self.serve("--tcp", 0, *SETTINGS, "--set", "$22=5")
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        job = self.program_file(["G91 G1 X2 F6000"])
        for form in ((), ("--checked",), ("--accept-faults",)):
            status, _, err = self.send(job, *where, *form)
            self.assertEqual(status, 1)
            self.assertIn("in alarm: home or unlock it first", err)
        self.check_x(server, 0.0)
        log = self.folder / "log"
        status, _, err = self.send(self.program_file(["$X"]), *where, "--log", log)
        self.assertEqual((status, err), (0, ""))
        self.assertIn("Caution: Unlocked", log.read_text())

    def test_starts_with_the_offsets_and_the_position_of_the_machine(self):
        server = self.serve("--tcp", 0, *SETTINGS, "--set", "$130=100")
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        job = self.program_file(["G90 G0 X60"])
        sender = server.tcp()
        sender.until(served.BANNER)
        sender.ask("G10 L2 P1 X-50")
        sender.ask("G0 X-45")
        sender.ask("G4 P0")  # Waits for standstill.
        sender.close()
        time.sleep(0.5)
        status, _, err = self.send(job, *where)
        self.assertEqual(status, 1)
        self.assertIn("X needs 105.000 mm of travel", err)

    def test_skips_lines_as_the_controller_does(self):
        for setting, far in ((1, 6.0), (0, 1.0)):
            server = self.serve("--tcp", 0, *SETTINGS, "--set", f"$890={setting}")
            job = self.program_file(["G91 F6000", "G1 X1", "/M2", "G1 X5"])
            status, _, err = self.send(job, "--tcp", f"127.0.0.1:{server.port('tcp')}")
            self.assertEqual(status, 0, err)
            self.assertEqual("ended in line 3" in err, setting == 0)
            self.check_x(server, far)

    def test_names_what_is_wrong_with_the_call(self):
        for arguments in (("x.nc",), ("x.nc", "--port", "a", "--tcp", "b:1"),
                          ("/no/file", "--port", "/dev/null"),
                          (self.program_file(["G4 P1"]), "--port", "/no/such/port"),
                          (self.program_file(["G4 P1"]), "--tcp", "nowhere"),
                          (self.program_file(["G4 P1"]), "--can", "nosuchcan0"),
                          (self.program_file(["G4 P1"]), "--slcan", "/no/such/port"),
                          (self.program_file(["G4 P1"]), "--slcan", "a", "--node", 127),
                          (self.program_file(["G1 X" + "0" * 240]), "--tcp", "localhost:9",
                           "--checked")):
            with self.subTest(arguments=arguments):
                status, _, err = self.send(*arguments)
                self.assertEqual(status, 2)
                self.assertNotEqual(err, "")

    def test_is_stopped_by_a_signal_at_standstill(self):
        server = self.serve("--tcp", 0, *SETTINGS)
        job = self.program_file(["G91 G1 X200 F1200 M4 S500"])
        process = self.start(job, "--tcp", f"127.0.0.1:{server.port('tcp')}")
        time.sleep(2.0)
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 1)
        self.assertIn("aborted", err)
        stream = server.tcp()
        stream.until(served.BANNER)
        stream.send(b"?")
        self.assertIn("<Idle|", stream.until(">"))

    def test_says_for_what_it_waits_where_nobody_sits_at_a_terminal(self):
        server = self.serve("--tcp", 0, *SETTINGS)
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        job = self.program_file(["G91 G1 X1 F6000", "M0", "G1 X1"])
        process = self.start(job, *where)
        words = process.stderr.readline()
        self.assertIn("waits before line ", words)
        self.assertIn("cycle start (`~`) goes on", words)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1)
        status, _, err = self.send(job, *where, "--stop-when-held")
        self.assertEqual(status, 1)
        self.assertIn("stopped instead of waiting: the machine waits before line ", err)

    def test_stopped_in_a_tool_change_leaves_nothing_to_go_on(self):
        server = self.serve("--tcp", 0, *SETTINGS)
        where = ("--tcp", f"127.0.0.1:{server.port('tcp')}")
        job = self.program_file(["G91 F6000", "M6 T1", "G20", "G91", "G1 X1"])
        begun = time.monotonic()
        status, _, err = self.send(job, *where, "--stop-when-held")
        self.assertEqual(status, 1)
        self.assertIn("a tool is to be changed", err)
        self.assertLess(time.monotonic() - begun, 8.0)
        process = self.start(job, *where)
        self.assertIn("a tool is to be changed", process.stderr.readline())
        process.send_signal(signal.SIGINT)
        begun = time.monotonic()
        process.communicate(timeout=60)
        self.assertLess(time.monotonic() - begun, 3.0)
        sender = server.tcp()
        sender.until(served.BANNER)
        sender.send(b"~?")
        self.assertIn("<Idle|", sender.until(">"))
        sender.close()
        time.sleep(0.5)
        self.check_x(server, 0.0)

    def test_shows_escape_sequences_in_names_instead_of_sending_them_to_the_terminal(self):
        status, _, err = self.send("/no/\x1b[31mfile", "--tcp", "localhost:9")
        self.assertEqual(status, 2)
        self.assertNotIn("\x1b", err)
        self.assertIn("\\x1B[31mfile", err)

    def test_is_told_when_the_link_goes(self):
        server = self.serve("--tcp", 0, *SETTINGS)
        job = self.program_file(["G91 G1 X200 F1200"])
        process = self.start(job, "--tcp", f"127.0.0.1:{server.port('tcp')}")
        time.sleep(1.5)
        server.stop(signal.SIGKILL)
        _, err = process.communicate(timeout=20)
        self.assertEqual(process.returncode, 1)
        self.assertIn("the link is gone", err)

    def test_repeats_what_a_relay_damages(self):
        job, far = self.square(300)
        for seed in seeds_of(self, 1):
            with self.subTest(seed=seed):
                server = self.serve("--tcp", 0, "--speed", 20, *SETTINGS, "--set", "$130=1000")
                relay = Relay(server.port("tcp"), one_in=600, seed=seed)
                status, _, err = self.send(job, "--tcp", f"127.0.0.1:{relay.port}", "--checked")
                self.assertEqual((status, err), (0, ""))
                self.assertGreater(relay.damaged, 20)
                self.check_x(server, far)

    def test_believes_no_answer_that_came_once(self):
        server = self.serve("--tcp", 0, "--speed", 20, *SETTINGS, "--set", "$130=1000")
        relay = Rewriter(server.port("tcp"), to_sender=[(b"$130=1000.000", b"$130=1.000"),
                                                        (b"[G54:0.000", b"[G54:900.000"),
                                                        (b"[G54:0.000", b"[G54:800.000")])
        job, far = self.square(3)
        status, out, err = self.send(job, "--tcp", f"127.0.0.1:{relay.port}", "--checked")
        self.assertEqual((status, err), (0, ""))
        self.assertEqual(relay.to_sender, [])
        self.check_x(server, far)

    def test_names_the_answers_that_never_agree(self):
        server = self.serve("--tcp", 0, *SETTINGS)
        relay = Rewriter(server.port("tcp"),
                         to_sender=[(b"$130=300.000", f"$130={n}.000".encode()) for n in range(30)])
        job, _ = self.square(1)
        status, _, err = self.send(job, "--tcp", f"127.0.0.1:{relay.port}", "--checked")
        self.assertEqual(status, 1)
        self.assertIn("nothing was sent", err)
        self.assertIn("to $130 differ", err)
        self.check_x(server, 0.0)

    def test_knows_a_controller_without_checked_lines(self):
        listener = socket.create_server(("127.0.0.1", 0))

        def grbl():
            link, _ = listener.accept()
            link.sendall(served.BANNER.encode())
            text = b""
            while byte := link.recv(1):
                if byte == b"?":
                    link.sendall(b"<Idle|MPos:0.000,0.000,0.000|FS:0,0>\r\n")
                elif byte != b"\n":
                    text += byte
                elif text == b"$I":
                    link.sendall(b"[VER:1.1h.20190825:]\r\n[OPT:V,15,128]\r\nok\r\n")
                    text = b""
                else:
                    link.sendall(b"error:20\r\n" if b"*" in text else b"ok\r\n")
                    text = b""

        threading.Thread(target=grbl, daemon=True).start()
        status, _, err = self.send(self.program_file(["G1 X1"]), "--checked", "--tcp",
                                   f"127.0.0.1:{listener.getsockname()[1]}")
        self.assertEqual(status, 1)
        self.assertIn("knows no checked lines", err)


if __name__ == "__main__":
    served.main(in_test=5)
