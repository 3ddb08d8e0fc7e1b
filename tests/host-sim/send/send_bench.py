"""Shared by the tests of `kerfline send`: programs to send, and a sender that is started and observed."""
import pathlib
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "serve"))
import served  # noqa: E402

SETTINGS = ("--set", "$32=1", "--set", "$120=5000", "--set", "$121=5000")


class SendBench(served.ServeTest):
    def program_file(self, lines):
        path = self.folder / "job.nc"
        path.write_text("".join(f"{line}\n" for line in lines))
        return path

    def square(self, times):
        """Returns a program that ends at a known position only if every line was executed once."""
        lines = ["(a square, and a step aside each time)", "G21 G91 F6000 M4 S500"]
        for _ in range(times):
            lines += ["G1 X3", "G1 Y2", "G1 X-2 ; back", "", "G1 Y-2"]
        return self.program_file(lines + ["M5", "M2"]), float(times)

    def start(self, *arguments):
        return subprocess.Popen([self.program, "send", *map(str, arguments)],
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                stdin=subprocess.DEVNULL, text=True)

    def send(self, *arguments):
        process = self.start(*arguments)
        out, err = process.communicate(timeout=100)
        return process.returncode, out, err

    def where(self, server):
        stream = server.tcp()
        stream.until(served.BANNER)
        stream.send(b"?")
        report = stream.until(">").split("MPos:")[1]
        stream.close()
        return [float(number) for number in report.split("|")[0].split(",")]

    def check_x(self, server, expected):
        deadline = time.monotonic() + 5
        while time.monotonic() < deadline:
            try:
                place = self.where(server)
                break
            except (EOFError, TimeoutError):
                time.sleep(0.2)
        self.assertAlmostEqual(place[0], expected, 3)
        self.assertAlmostEqual(place[1], 0.0, 3)

    def check_dark_when_killed(self, server, *where):
        log = self.folder / "log"
        process = self.start(self.program_file(["G91 G1 X200 F1200 M3 S500"]), *where, "--log", log)
        time.sleep(2.0)
        process.send_signal(signal.SIGKILL)
        process.communicate(timeout=20)
        self.assertFalse(log.exists())
        so_far = next(self.folder.glob(f".kerfline-{process.pid}-*.part"))
        self.assertIn("<Run|", so_far.read_text())
        time.sleep(1.0)
        before = self.where(server)
        time.sleep(1.0)
        self.assertEqual(self.where(server), before)
        self.assertGreater(before[0], 1.0)
        self.assertLess(before[0], 150.0)
        self.assertEqual(server.stop()[0], 0)
