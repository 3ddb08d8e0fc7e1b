#!/usr/bin/env python3
"""`kerfline serve --ws` with browsers and other WebSocket senders.

    web_test.py KERFLINE
"""
import json
import re
import socket
import subprocess
import time

from served import BANNER, LASER, ServeTest, main
from web_client import CLOSE, TEXT, WebSocket, head, http, post, request


class Web(ServeTest):
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
        version = subprocess.run([self.program, "--version"], capture_output=True, text=True,
                                 check=True).stdout.strip()
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
            # The first news of the run may still contain the position where it begins.
            while time.monotonic() < end and not (
                    place == [0, 0, 0] and points > 1 and "Run" in states):
                news = json.loads(watcher.frame()[1])
                states.add(news["state"])
                place = news["mpos"]
                points = max(points, news["path"]["from"] + len(news["path"]["points"]) // 4)
            self.assertIn("Run", states)
            self.assertGreater(points, 1)
            self.assertEqual(news["sender"], "tcp")
            self.assertEqual(news["version"], version)
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
                                    ("/", {"origin": f"http://localhost:{port}"}, 403),
                                    ("/", {"origin": f"http://10.9.8.7:{port}"}, 403),
                                    ("/", {"origin": f"http://LOCALHOST:{port}",
                                           "host": f"LocalHost:{port}"}, 101)):
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
        self.assertEqual(outline, {"points": [101, 2, 0, 110, 2, 2, 120, 2, 0], "faults": []})
        outline = self.outline_of(served, b"G1 X5 F600\r\nG1 X6 Q\xff\r\nX9\r\n")
        self.assertEqual(outline["points"], [101, 2, 0, 105, 2, 1])
        self.assertEqual(outline["refused"]["line"], 2)
        self.assertEqual(outline["refused"]["number"], 2)
        self.assertEqual(outline["refused"]["reason"], "Q has no number")
        self.assertEqual(outline["faults"], ["line 2: Q has no number"])
        self.assertEqual(self.outline_of(served, b""), {"points": [101, 2, 0], "faults": []})
        sender.close()

    def outline_of(self, served, program):
        status, answer = post(served.port("ws"), "/outline", program)
        self.assertEqual(status, 200, answer)
        return json.loads(answer)

    def test_draws_no_more_than_64_mib_and_for_nobody_else(self):
        port = self.serve("--ws", 0).port("ws")
        large = 64 << 20
        status, answer = post(port, "/outline", b"", length=large + 1)
        self.assertEqual((status, answer), (413, b"The request is longer than 64 MiB."))
        # The server accepts the complete body. Reading ends at its first line, which makes this
        # fast.
        status, answer = post(port, "/outline", b"nonsense\n".ljust(large))
        self.assertEqual((status, json.loads(answer)["refused"]["line"]), (200, 1))
        self.assertEqual(http(port, "/outline")[0], 405)
        self.assertEqual(request(port, "/outline", method="POST",
                                 extra="Transfer-Encoding: chunked\r\n")[0], 411)
        self.assertEqual(post(port, "/outline", b"", origin="http://evil.example")[0], 403)
        self.assertEqual(post(port, "/outline", b"", host=f"evil.example:{port}")[0], 403)

    def test_answers_the_head_alone(self):
        port = self.serve("--ws", 0).port("ws")
        for path in ("/", "/app.js", "/picture.svg"):
            first, rest = head(port, path)
            self.assertIn(b" 200 ", first.split(b"\r\n")[0])
            length = int(re.search(rb"Content-Length: (\d+)", first)[1])
            self.assertEqual(length, len(http(port, path)[1].split(b"\r\n\r\n", 1)[1]))
            self.assertEqual(rest, b"")

    def test_hangs_up_on_frames_that_break_the_rules(self):
        served = self.serve("--ws", 0)
        for frame in (b"\x82\x01?", b"\xc2\x81\0\0\0\0?", b"\xa2\x81\0\0\0\0?", b"\x83\x80\0\0\0\0"):
            for path in ("/", "/observe", "/operate"):
                web = WebSocket(served.port("ws"), path)
                web.link.sendall(frame)
                opcode, data = web.frame()
                while opcode != CLOSE:
                    opcode, data = web.frame()
                self.assertEqual(data, b"\x03\xea", (frame, path))
                self.assertEqual(web.link.recv(1), b"")
                web.close()

    def test_silent_and_slow_connections_keep_nobody_waiting(self):
        port = self.serve("--ws", 0).port("ws")
        silent = [socket.create_connection(("127.0.0.1", port)) for _ in range(200)]
        for index, link in enumerate(silent):
            link.sendall(b"GET / HTTP/1.1\r\nX: "[:index % 20])
        slow = socket.create_connection(("127.0.0.1", port))
        slow.sendall(f"POST /outline HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n"
                     "Content-Length: 1000\r\n\r\nG1".encode())
        begun = time.monotonic()
        self.assertEqual(http(port)[0], 200)
        self.assertLess(time.monotonic() - begun, 2.0)
        for link in [*silent, slow]:
            link.close()

    def test_tells_a_watcher_more_than_there_may_be(self):
        port = self.serve("--ws", 0).port("ws")
        watchers = [WebSocket(port, "/observe") for _ in range(16)]
        for watcher in watchers:
            self.assertIn("state", json.loads(watcher.frame()[1]))
        more = WebSocket(port, "/observe")
        self.assertIn("Sixteen pages watch", json.loads(more.frame()[1])["refused"])
        self.assertEqual(more.frame(), (CLOSE, b"\x03\xf5"))
        watchers.pop().close()
        time.sleep(0.3)
        again = WebSocket(port, "/observe")
        self.assertIn("state", json.loads(again.frame()[1]))

    def order(self, served, what, page=None, accepted=()):
        """Orders the program that the server has, as a connected page or as none. Repeats the
        order while the program is being judged.
        """
        known = page and re.search(r"\[PAGE:(\w+)\]", page.said)
        status, answer = http(served.port("ws"), "/job")
        program = json.loads(answer.split(b"\r\n\r\n", 1)[1]) if status == 200 else {}
        body = json.dumps({"id": program.get("id", ""), "page": known[1] if known else "",
                           "accepted": list(accepted)}).encode()
        while True:
            status, answer = post(served.port("ws"), f"/job/{what}", body)
            answer = json.loads(answer)
            if not answer.get("again"):
                return status, answer
            time.sleep(0.02)

    def job(self, watcher):
        """Returns the job from the next news."""
        return json.loads(watcher.frame()[1])["job"]

    def until_job(self, watcher, state):
        end = time.monotonic() + 60
        while (job := self.job(watcher))["state"] != state:
            self.assertLess(time.monotonic(), end, job)
        return job

    def test_a_job_outlives_its_page_and_lets_nothing_but_realtime_bytes_in(self):
        served = self.serve("--ws", 0, "--tcp", 0, *LASER)
        port = served.port("ws")
        watcher = WebSocket(port, "/observe")
        self.assertEqual(http(port, "/job")[0], 404)
        self.assertIn("a program", self.order(served, "run")[1]["waits"])
        program = b"G91 M4 S300 F1200\nG1 X20\nG1 Y20\nG1 X-20\nM5\n"
        self.assertEqual(post(port, "/job?name=a%20b.nc", program)[0], 200)
        self.assertIn("take control", self.order(served, "run")[1]["waits"])
        page = WebSocket(port, "/operate")
        page.said = page.until(BANNER)
        self.assertEqual(self.order(served, "run", page), (200, {"runs": "a b.nc"}))
        self.until_job(watcher, "running")
        page.send(b"G10 L20 P0 X0\nG1 X99\n")
        for _ in range(2):
            page.until("only realtime commands act]\r\nerror:8\r\n")
        self.assertEqual(post(port, "/job?name=other.nc", b"G0 X1\n")[0], 409)
        self.assertEqual(self.order(served, "run")[0], 409)
        page.close()
        time.sleep(0.3)
        sender = served.tcp()
        self.assertEqual(sender.until("\r\n"), "[MSG:A job of the page runs]\r\n")
        page = WebSocket(port, "/operate")
        page.until("[MSG:A job of the page runs]\r\n")
        page.send(b"!")
        while json.loads(watcher.frame()[1])["state"] != "Hold":
            pass
        page.send(b"~")
        done = self.until_job(watcher, "done")
        self.assertEqual((done["name"], done["done"], done["count"]), ("a b.nc", 5, 5))
        self.assertEqual(json.loads(watcher.frame()[1])["mpos"], [0, 20, 0])

    def test_a_faulty_program_runs_when_its_faults_were_accepted_and_stops_at_them(self):
        served = self.serve("--ws", 0, *LASER)
        watcher = WebSocket(served.port("ws"), "/observe")
        page = WebSocket(served.port("ws"), "/operate")
        page.said = page.until(BANNER)
        program = b"G91 G1 X1 F600\nG7\nG1 X50\nG1 Y9999\n"
        post(served.port("ws"), "/job?name=f.nc", program)
        status, answer = self.order(served, "run", page)
        self.assertEqual(status, 409)
        self.assertEqual([fault.split(":")[0] for fault in answer["faults"]], ["line 4", "line 2"],
                         "the travel first")
        some = answer["faults"][:1]
        self.assertEqual(self.order(served, "run", page, some)[0], 409, "each of them")
        self.assertEqual(self.order(served, "run", page, answer["faults"])[0], 200)
        stopped = self.until_job(watcher, "stopped")
        self.assertIn("line 2: error:20", stopped["trouble"])
        self.assertEqual(stopped["line"], 3)
        while (news := json.loads(watcher.frame()[1]))["state"] != "Idle":
            pass
        self.assertLessEqual(news["mpos"][0], 1.0, "nothing behind the line is driven")
        self.assertEqual(news["mpos"][1], 0.0)


if __name__ == "__main__":
    main()
