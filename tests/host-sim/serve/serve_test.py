#!/usr/bin/env python3
"""`kerfline serve` as senders, browsers and scripts meet it: over pty, TCP and WebSocket.

    serve_test.py KERFLINE
"""
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from web_client import CLOSE, TEXT, WebSocket, http, post, request

KERFLINE = ""
BANNER = "Grbl 1.1h ['$' for help]\r\n"
REFUSAL = "[MSG:Another sender is connected]\r\n"
LASER = ("--set", "$32=1", "--set", "$30=1000")


class Stream:
    """A sender's end of a pty or a TCP connection."""

    def __init__(self, number, close):
        os.set_blocking(number, False)
        self.number, self.text = number, ""
        self._close = close

    def close(self):
        if self._close:
            self._close()
        self._close = None

    def send(self, data):
        os.write(self.number, data)

    def until(self, words, seconds=5.0):
        end = time.monotonic() + seconds
        while words not in self.text:
            try:
                part = os.read(self.number, 4096)
                if not part:
                    raise EOFError(self.text)
                self.text += part.decode()
            except BlockingIOError:
                if time.monotonic() > end:
                    raise TimeoutError(f"{words!r} not in {self.text!r}") from None
                time.sleep(0.002)
        place = self.text.index(words) + len(words)
        found, self.text = self.text[:place], self.text[place:]
        return found

    def ask(self, line):
        self.send(line.encode() + b"\n")
        return self.until("ok\r\n")


class Served:
    """A running server and what it said about its ways in."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen(
            [KERFLINE, "serve", *map(str, arguments)], stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True)
        self.ways, self.streams = {}, []
        for line in self.process.stdout:
            kind, _, address = line.strip().partition(" ")
            if kind == "ready":
                break
            self.ways[kind] = address

    def port(self, kind):
        return int(self.ways[kind].rsplit(":", 1)[1])

    def tcp(self):
        link = socket.create_connection(("127.0.0.1", self.port("tcp")), timeout=5)
        return self.kept(Stream(link.fileno(), link.close))

    def pty(self):
        number = os.open(self.ways["pty"], os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        return self.kept(Stream(number, lambda: os.close(number)))

    def kept(self, stream):
        self.streams.append(stream)
        return stream

    def stop(self, how=signal.SIGTERM):
        self.process.send_signal(how)
        out, err = self.process.communicate(timeout=20)
        return self.process.returncode, out, err


class Serve(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.link = self.folder / "tty"

    def serve(self, *arguments):
        served = Served(*arguments)

        def end():
            if served.process.poll() is None:
                served.stop()
            for stream in served.streams:
                stream.close()
            served.process.stdout.close()
            served.process.stderr.close()
        self.addCleanup(end)
        return served

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
        time.sleep(0.4)
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

    def test_carries_a_sender_over_websocket_in_text_and_binary(self):
        served = self.serve("--ws", 0)
        sender = WebSocket(served.port("ws"))
        self.assertEqual(sender.until(BANNER), BANNER)
        sender.send(b"G0 X1\n", TEXT)
        sender.until("ok\r\n")
        sender.send(b"G0 X2\nG0 X3\n")
        sender.until("ok\r\n")
        sender.until("ok\r\n")
        sender.send("\x91?".encode(), TEXT)  # The former as UTF-8.
        self.assertIn("Ov:110,100,100", sender.until(">\r\n"))
        sender.close()

    def test_lets_any_number_watch(self):
        served = self.serve("--ws", 0, "--tcp", 0)
        watchers = [WebSocket(served.port("ws"), "/observe") for _ in range(3)]
        sender = served.tcp()
        sender.until(BANNER)
        sender.ask("M3 S100")
        sender.ask("G1 X4 Y3 F3000")
        sender.ask("G1 X0 Y0")
        sender.ask("G4 P0.2")
        for watcher in watchers:
            states, points, place = set(), 0, None
            end = time.monotonic() + 10
            while time.monotonic() < end and not (place == [0, 0, 0] and "Run" in states):
                news = json.loads(watcher.frame()[1])
                states.add(news["state"])
                place = news["mpos"]
                points = max(points, news["path"]["from"] + len(news["path"]["points"]) // 4)
            self.assertIn("Run", states)
            self.assertGreater(points, 1)
            self.assertEqual(news["sender"], "tcp")
            watcher.close()

    def test_serves_its_page_and_nobody_elses(self):
        served = self.serve("--ws", 0)
        port = served.port("ws")
        self.assertEqual(served.ways["page"], f"http://127.0.0.1:{port}/")
        status, page = http(port)
        self.assertEqual(status, 200)
        self.assertIn(b"<title>Kerfline</title>", page)
        self.assertNotIn(b"://", page.split(b"\r\n\r\n", 1)[1], "no request to elsewhere")
        for path in ("/app.js", "/style.css", "/icon.svg", "/picture.svg"):
            self.assertEqual(http(port, path)[0], 200, path)
        self.assertEqual(http(port, "/../etc/passwd")[0], 404)
        self.assertEqual(http(port, host=f"evil.example:{port}")[0], 403)
        self.assertEqual(http(port, origin="http://evil.example")[0], 403)
        for path, names, status in (("/", {"host": f"evil.example:{port}"}, 403),
                                    ("/observe", {"origin": "http://evil.example"}, 403),
                                    ("/", {"origin": f"http://localhost:{port}"}, 101)):
            web = WebSocket(port, path, **names)
            self.assertEqual(web.status, status, names)
            web.close()

    def test_draws_a_program_as_the_controller_would_read_it_now(self):
        served = self.serve("--ws", 0, "--tcp", 0, *LASER)
        sender = served.tcp()
        sender.until(BANNER)
        sender.ask("G10 L2 P1 X100")
        sender.ask("G0 X1 Y2")
        outline = self.outline_of(served, b"M4 S500\nG1 X10 F600\nG0 X20\n")
        self.assertEqual(outline, {"points": [101, 2, 0, 110, 2, 2, 120, 2, 0]})
        outline = self.outline_of(served, b"G1 X5 F600\r\nG1 X6 Q\xff\r\nX9\r\n")
        self.assertEqual(outline["points"], [101, 2, 0, 105, 2, 1])
        self.assertEqual(outline["refused"]["line"], 2)
        self.assertEqual(outline["refused"]["number"], 2)
        self.assertEqual(outline["refused"]["reason"], "Q has no number")
        self.assertEqual(self.outline_of(served, b""), {"points": [101, 2, 0]})
        sender.close()

    def outline_of(self, served, program):
        status, answer = post(served.port("ws"), "/outline", program)
        self.assertEqual(status, 200, answer)
        return json.loads(answer)

    def test_draws_no_more_than_64_mib_and_for_nobody_else(self):
        port = self.serve("--ws", 0).port("ws")
        large = 64 << 20
        status, answer = post(port, "/outline", b"", length=large + 1)
        self.assertEqual((status, answer), (413, b"A program of more than 64 MiB is not drawn."))
        program = b"G0X1\nX2\n".ljust(large, b"\n")
        self.assertEqual(post(port, "/outline", program)[0], 200)
        self.assertEqual(http(port, "/outline")[0], 405)
        self.assertEqual(request(port, "/outline", method="POST",
                                 extra="Transfer-Encoding: chunked\r\n")[0], 411)
        self.assertEqual(post(port, "/outline", b"", origin="http://evil.example")[0], 403)
        self.assertEqual(post(port, "/outline", b"", host=f"evil.example:{port}")[0], 403)

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

    @staticmethod
    def replay(*arguments):
        return subprocess.run([KERFLINE, "replay", *map(str, arguments)], capture_output=True,
                              text=True, check=False)

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
            done = subprocess.run([KERFLINE, "serve", *map(str, arguments)], capture_output=True,
                                  text=True, check=False, timeout=20)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(reason, done.stderr, arguments)
        self.assertEqual(self.link.read_text(), "precious")


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
