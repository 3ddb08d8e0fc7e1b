"""Shared by the tests of `kerfline serve`: a running server, and a sender's end of a connection."""
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import share_of  # noqa: E402

BANNER = "Grbl 1.1h ['$' for help]\r\n"
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
    """A running server and the addresses that it printed."""

    def __init__(self, program, *arguments):
        self.process = subprocess.Popen(
            [program, "serve", *map(str, arguments)], stdout=subprocess.PIPE,
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


class ServeTest(unittest.TestCase):
    program = ""  # kerfline, as main() is told.

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.link = self.folder / "tty"

    def serve(self, *arguments):
        served = Served(self.program, *arguments)

        def end():
            if served.process.poll() is None:
                served.stop()
            for stream in served.streams:
                stream.close()
            served.process.stdout.close()
            served.process.stderr.close()
        self.addCleanup(end)
        return served


class Loader(unittest.TestLoader):
    """Loads about `in_test` tests of each class for toolchain/test.sh, a different choice with
    each commit.
    """

    def __init__(self, in_test):
        super().__init__()
        self.in_test = in_test

    def getTestCaseNames(self, testCaseClass):
        names = list(super().getTestCaseNames(testCaseClass))
        return share_of(names, self.in_test, testCaseClass.__name__)


def main(in_test=1000):
    """Runs the tests; `in_test` is the approximate number of tests of each class that
    toolchain/test.sh runs.
    """
    ServeTest.program = sys.argv.pop(1)
    unittest.main(testLoader=Loader(in_test))
