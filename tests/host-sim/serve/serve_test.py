#!/usr/bin/env python3
"""`kerfline serve` with senders, browsers and scripts as its users: over pty, TCP and WebSocket.

    serve_test.py KERFLINE
"""
import os
import pathlib
import resource
import signal
import subprocess
import time

from served import BANNER, LASER, ServeTest, main
from web_client import CLOSE, TEXT, WebSocket

REFUSAL = "[MSG:Another sender is connected]\r\n"


class Serve(ServeTest):
    def test_greets_over_the_pty_a_tenth_of_a_second_after_it_was_opened(self):
        served = self.serve("--pty", self.link)
        for _ in range(3):
            opened = time.monotonic()
            sender = served.pty()
            self.assertEqual(sender.until(BANNER), BANNER)
            self.assertGreaterEqual(time.monotonic() - opened, 0.1)
            self.assertIn("<Idle", self.answer_to_question(sender))
            sender.close()
            time.sleep(0.05)

    @staticmethod
    def answer_to_question(sender):
        sender.send(b"?")
        return sender.until(">\r\n")

    def test_answers_a_question_at_once(self):
        sender = self.serve("--tcp", 0).tcp()
        sender.until(BANNER)
        times = []
        for _ in range(30):
            time.sleep(0.01)
            asked = time.monotonic()
            self.answer_to_question(sender)
            times.append(time.monotonic() - asked)
        self.assertLess(sorted(times)[15], 0.02)

    def test_time_goes_as_fast_as_asked(self):
        for speed, wanted in ((1, 1.0), (10, 0.1)):
            sender = self.serve("--tcp", 0, "--speed", speed).tcp()
            sender.until(BANNER)
            begun = time.monotonic()
            sender.ask("G4 P1")
            taken = time.monotonic() - begun
            self.assertGreaterEqual(taken, wanted * 0.98)
            self.assertLess(taken, wanted + 0.5)

    def test_refuses_a_second_sender_whichever_way_it_comes(self):
        served = self.serve("--pty", self.link, "--tcp", 0, "--ws", 0)
        first = served.tcp()
        first.until(BANNER)
        second = served.tcp()
        self.assertEqual(second.until("\r\n"), REFUSAL)
        with self.assertRaises(EOFError):
            second.until("more")
        web = WebSocket(served.port("ws"))
        self.assertEqual(web.frame(), (TEXT, REFUSAL.encode()))
        self.assertEqual(web.frame(), (CLOSE, b"\x03\xf5"))
        web.close()
        port = served.pty()
        self.assertEqual(port.until("\r\n"), REFUSAL)
        with self.assertRaises((OSError, EOFError)):  # Hung up on.
            port.until("more")
        port.close()
        self.assertIn("<Idle", self.answer_to_question(first))
        first.close()
        time.sleep(0.4)
        port = served.pty()
        self.assertEqual(port.until(BANNER), BANNER)
        port.close()

    def test_stops_the_machine_when_the_sender_is_lost(self):
        served = self.serve("--tcp", 0, *LASER)
        sender = served.tcp()
        sender.until(BANNER)
        sender.ask("M3 S500")
        sender.ask("G1 X100 F1200")
        time.sleep(0.2)
        self.assertIn("<Run", self.answer_to_question(sender))
        sender.close()
        time.sleep(1.0)
        reports = []
        for _ in range(2):
            sender = served.tcp()
            sender.until(BANNER)
            reports.append(self.answer_to_question(sender))
            sender.close()
            time.sleep(0.4)
        self.assertIn("<Idle", reports[0])
        self.assertNotIn("MPos:0.000", reports[0])
        self.assertEqual(*[report.split("|")[1] for report in reports])

    def test_stops_the_machine_when_the_sender_is_lost_in_the_middle_of_a_comment(self):
        served = self.serve("--tcp", 0, *LASER)
        sender = served.tcp()
        sender.until(BANNER)
        sender.ask("M3 S500 G1 X100 F1200")
        sender.send(b"G1 X200 (to the end of")
        time.sleep(0.1)  # Less than $858 allows.
        sender.close()
        time.sleep(1.0)
        sender = served.tcp()
        sender.until(BANNER)
        report = self.answer_to_question(sender)
        self.assertIn("<Idle", report)
        self.assertLess(float(report.split("MPos:")[1].split(",")[0]), 30.0)

    def test_ends_on_signals_and_takes_its_link_along(self):
        for how in (signal.SIGTERM, signal.SIGINT):
            served = self.serve("--pty", self.link, "--ws", 0)
            self.assertTrue(self.link.is_symlink())
            self.assertEqual(served.stop(how)[0], 0)
            self.assertFalse(self.link.is_symlink())

    def test_costs_little_while_nothing_moves(self):
        served = self.serve("--pty", self.link, "--tcp", 0)
        sender = served.tcp()
        sender.until(BANNER)
        time.sleep(0.5)
        before = self.processor_seconds(served)
        time.sleep(2.0)
        self.assertLess(self.processor_seconds(served) - before, 0.2)

    @staticmethod
    def processor_seconds(served):
        fields = pathlib.Path(f"/proc/{served.process.pid}/stat").read_text().split()
        return (int(fields[13]) + int(fields[14])) / os.sysconf("SC_CLK_TCK")

    def test_what_is_stored_outlives_the_run(self):
        store = self.folder / "store"
        for value in ("1234.000", "1235.000"):
            served = self.serve("--tcp", 0, "--store", store)
            sender = served.tcp()
            sender.until(BANNER)
            if value == "1235.000":
                self.assertIn("$110=1234.000", sender.ask("$$"))
            sender.ask(f"$110={value}")
            served.stop()

    def test_records_what_replay_says_again(self):
        talk = self.folder / "talk"
        served = self.serve("--tcp", 0, "--record", talk, *LASER)
        sender = served.tcp()
        sender.until(BANNER)
        sender.ask("$$")
        sender.ask("G1 X5 F2000")
        for _ in range(5):
            self.answer_to_question(sender)
            time.sleep(0.02)
        sender.send(b"!")
        time.sleep(0.2)
        sender.send(b"~nonsense\n")
        sender.until("error:")
        sender.close()
        time.sleep(0.3)
        self.assertEqual(served.stop()[0], 0)
        self.assertEqual(self.replay("--times", talk).returncode, 0)
        text = talk.read_text()
        self.assertTrue(text.startswith("kerfline conversation 1\n"))
        self.assertIn("set $32=1\n", text)
        talk.write_text(text.replace("$100=", "$999=", 1))
        other = self.replay(talk)
        self.assertEqual(other.returncode, 1)
        self.assertRegex(other.stdout, r"talk:\d+: recorded `\$999=.*`, said `\$100=")
        self.assertEqual(self.replay("--update", talk).returncode, 0)
        self.assertEqual(talk.read_text(), text)
        talk.write_text("something else\n")
        self.assertEqual(self.replay(talk).returncode, 2)
        self.assertEqual(self.replay(self.folder / "missing").returncode, 2)

    def test_goes_on_without_a_record_or_a_trace_that_cannot_be_written(self):
        for option, size in (("--record", 4000), ("--trace", 300_000)):
            with self.subTest(option=option):
                name = self.folder / option[2:]
                served = self.serve("--tcp", 0, option, name, "--speed", 20, *LASER)
                resource.prlimit(served.process.pid, resource.RLIMIT_FSIZE, (size, size))
                sender = served.tcp()
                sender.until(BANNER)
                for _ in range(120 if option == "--record" else 3):  # More than fits.
                    sender.ask("$$") if option == "--record" else sender.ask("G91 G0 X99")
                sender.ask("G91 G1 X1 F6000")
                sender.ask("G4 P0")
                self.assertIn("<Idle", self.answer_to_question(sender), "the machine goes on")
                status, _, err = served.stop()
                self.assertEqual(status, 2)
                self.assertIn(f"{option}: cannot write {name}", err)
                self.assertEqual(err.count(option), 1, "once")
                self.assertEqual(os.listdir(self.folder), [])

    def test_takes_over_its_link_after_it_was_killed(self):
        for _ in range(2):
            served = self.serve("--pty", self.link)
            sender = served.pty()
            self.assertEqual(sender.until(BANNER), BANNER)
            sender.close()
            served.process.kill()
            served.process.wait()
            self.assertTrue(self.link.is_symlink())

    @staticmethod
    def replay(*arguments):
        return subprocess.run([ServeTest.program, "replay", *map(str, arguments)],
                              capture_output=True, text=True, check=False)

    def test_wrong_calls_end_with_status_2_and_say_why(self):
        served = self.serve("--tcp", 0, "--ws", 0)
        self.link.write_text("precious")
        calls = {
            (): "--pty",
            ("--tcp", "nonsense"): "nonsense",
            ("--tcp", served.port("tcp")): "in use",
            ("--ws", served.port("ws")): "in use",
            ("--pty", self.link): str(self.link),
            ("--tcp", "0", "--speed", "0"): "speed",
            ("--tcp", "0", "--set", "$110=x"): "$110=x",
            ("--tcp", "0", "--set", "$110=-1"): "$110",
            ("--tcp", "0", "--record", self.folder / "no" / "file"): "file",
        }
        for arguments, reason in calls.items():
            done = subprocess.run([self.program, "serve", *map(str, arguments)],
                                  capture_output=True, text=True, check=False, timeout=20)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(reason, done.stderr, arguments)
        self.assertEqual(self.link.read_text(), "precious")


if __name__ == "__main__":
    main()
