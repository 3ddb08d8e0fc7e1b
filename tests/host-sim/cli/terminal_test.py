#!/usr/bin/env python3
"""Tests that no command outputs a control byte for the terminal, whichever input contained it.

    terminal_test.py KERFLINE

Names of files, programs, drawings, databases, recordings and answers of a controller are tried
with every command of the table in files_bench.py.
"""

import concurrent.futures
import contextlib
import json
import os
import pathlib
import pty
import re
import select
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest

from files_bench import (CALLS, COMMANDS, CUTS, ENVIRONMENT, KERFLINE, NO_FILES, PLATE, PROGRAM, Bench, Server,
                         some_calls)

# Colour, title, CSI of one byte, DEL, and a line that looks like a message of the program.
EVIL = b"\x1b[31mred\x1b]0;title\x07\x9b1m\x7f\xc2\x9b2J\r\nspoof: fine\b"
NAME = os.fsdecode(EVIL.replace(b"\x00", b""))
OBEYED = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")


def text_of(data):
    """Decodes bytes; those that are not UTF-8 become the characters that an 8-bit terminal shows."""
    return data.decode("utf-8", "surrogateescape").translate({0xDC00 + i: i for i in range(128, 256)})


def bad_text(name):
    """Returns a text for the file that `name` reads, in which every name that a message can quote
    contains control bytes.
    """
    evil = EVIL.decode("latin-1").replace("\n", "").replace("\r", "")
    return {
        "sim": f"G21\n(MSG,{evil})\nG1 X1 F100 {evil}\nG{evil}\n",
        "check": f"G21\n(MSG,{evil})\nG1 X1 F100 {evil}\nG{evil}\nS2000\nG1 X900\n",
        "send": f"(MSG,{evil})\nG1 X1 F100 {evil}\nG1 X1*99\n",
        "replay": f"kerfline conversation 1\n0 > {evil}\n1 < {evil}\nend 1000000\n",
        "kerf add": CUTS.replace("tin", f'"{evil}"'),
        "kerf calibrate": CUTS.replace("tin", f'"{evil}"'),
        "offset": f"0 0\n1 {evil}\n",
    }.get(name)


DXF = ("0\nSECTION\n2\nENTITIES\n"
       "0\nLWPOLYLINE\n8\n{0}\n90\n4\n70\n1\n10\n0\n20\n0\n10\n20\n20\n0\n10\n20\n20\n20\n10\n0\n20\n20\n"
       "0\nLINE\n8\n{0}\n10\n50\n20\n0\n11\n60\n21\n5\n0\nTEXT\n8\n{0}\n1\n{0}\n0\n{0}\n8\n{0}\n0\nENDSEC\n0\nEOF\n")
SVG = PLATE.replace('id="part"', 'id="part&#x9b;31m&#x7f;"').replace(
    "</svg>", '<path id="&#x9b;2J" d="M1 1L9 1"/><text>&#x9b;</text><foreign&#xb7; id="&#x9b;1m"/></svg>')
JSON = json.dumps({"name": "\x1b[31m", "items": [{"id": "\x1b[31m", "demand": 1, "shape": {
    "type": "\x1b[31m", "data": [[0, 0], [1, 0], [0, 1]]}}], "strip_height": 20})


class Terminal(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def judge(self, out, err, *needed):
        for data in (out, err):
            text = text_of(data)
            found = OBEYED.search(text)
            self.assertIsNone(found, text[max(0, found.start() - 60):found.end() + 20] if found else "")
            self.assertNotRegex(text, r"(?m)^spoof")
        for words in needed:
            self.assertIn(words, text_of(out + err))

    def run_bench(self, bench, files=None):
        process = bench.start(bench.files if files is None else files)
        if bench.name == "serve":
            begun = time.monotonic()
            while process.poll() is None and time.monotonic() < begun + 0.5:
                time.sleep(0.05)
            process.terminate()
        return process.communicate(timeout=60)

    @contextlib.contextmanager
    def bench(self, name, command, **what):
        with tempfile.TemporaryDirectory() as folder, self.subTest(name, **what):
            yield Bench(pathlib.Path(folder), name, command, NAME)

    def test_names_of_files(self):
        """For every file of every command, the file is correct, missing, or a folder."""
        for name, command in some_calls(self):
            with self.bench(name, command) as bench:
                self.judge(*self.run_bench(bench))
            for option in (*command.inputs, *command.outputs, *command.kept):
                with self.bench(name, command, option=option) as bench:
                    for bad in (bench.folder / f"none{NAME}" / "file", bench.folder):
                        out, err = self.run_bench(bench, {**bench.files, option: bad})
                        self.judge(out, err)
                        self.assertNotEqual(err, b"")

    def test_words_of_the_call(self):
        for name in (*COMMANDS, *NO_FILES):
            for words in ((NAME,), (f"--{NAME}",), ("--set", NAME), ("--db", NAME), ("--material", NAME)):
                with self.subTest(name, words=words):
                    done = subprocess.run([KERFLINE[0], *name.split(), *words], stdin=subprocess.DEVNULL,
                                          capture_output=True, check=False, env=ENVIRONMENT, cwd=self.folder)
                    self.judge(done.stdout, done.stderr)
                    self.assertNotEqual(done.returncode, 0)

    def test_what_files_hold(self):
        for name, command in CALLS:
            positional = next((option for option in command.inputs if not option.startswith("-")), "--measured")
            if (text := bad_text(name)) is None or positional not in command.inputs:
                continue
            with self.bench(name, command) as bench:
                bench.files[positional].write_bytes(text.encode("latin-1"))
                out, err = self.run_bench(bench)
                self.judge(out, err)
                self.assertIn(b"\\x", out + err)

    def test_settings_and_layers(self):
        for name, command in CALLS:
            for option in {"--settings", "--layers"} & set(command.inputs):
                with self.bench(name, command, option=option) as bench:
                    bench.files[option].write_bytes(EVIL + b"=5\n" if option == "--settings" else EVIL)
                    out, err = self.run_bench(bench)
                    self.judge(out, err, "\\x")

    def test_drawings(self):
        """Control bytes are in layers, entities, identifiers and texts."""
        evil = EVIL.decode("latin-1").replace("\n", "").replace("\r", "")
        for suffix, content in (("dxf", DXF.format(evil).encode("latin-1")), ("svg", SVG.encode()),
                                ("json", JSON.encode())):
            drawing = self.folder / f"{NAME}.{suffix}"
            drawing.write_bytes(content)
            for words in (("drawing", drawing), ("drawing", drawing, "--json"), ("offset", drawing, "-d", "1"),
                          ("cut", drawing, "--material", "CSP 1N", "--thickness", "2", "--anyway"),
                          ("cut", drawing, "--material", "CSP 1N", "--thickness", "2", "--anyway", "--check",
                           "-o", self.folder / "out.nc"),
                          ("cut", drawing, "--material", "CSP 1N", "--thickness", "2", "--layer", "none: feed=1")):
                with self.subTest(suffix, words=words):
                    done = subprocess.run([KERFLINE[0], *map(str, words)], capture_output=True, check=False,
                                          env=ENVIRONMENT)
                    self.judge(done.stdout, done.stderr)
                    self.assertNotEqual(done.stdout + done.stderr, b"")

    def test_data_bases(self):
        """The name of the laser may be any text."""
        base = self.folder / f"{NAME}.db"
        evil = EVIL.decode("latin-1").replace("\n", "").replace("\r", "")
        material = ("--material", "tin", "--db", str(base))
        cuts = CUTS.replace("a laser", f'"{evil}"')
        for words in (("add", "-", "--db", str(base)), ("add", "-", "--db", str(base)), ("fit", *material),
                      ("fit", *material, "--laser", "b"), ("show", "--db", str(base)), ("show", *material),
                      ("show", *material, "--cuts"), ("advise", *material, "--thickness", "1"),
                      ("advise", *material, "--thickness", "1", "--power", "50", "--speed", "500"),
                      ("image", *material, "--out", str(self.folder / NAME))):
            with self.subTest(words=words):
                done = subprocess.run([KERFLINE[0], "kerf", *words], input=cuts.encode("latin-1"),
                                      capture_output=True, check=False, env=ENVIRONMENT)
                self.judge(done.stdout, done.stderr)
                self.assertNotEqual(done.stdout + done.stderr, b"")
        drawing = self.folder / "plate.svg"
        drawing.write_text(PLATE)
        done = subprocess.run([KERFLINE[0], "cut", drawing, *material, "--thickness", "1"], capture_output=True,
                              check=False, env=ENVIRONMENT)
        self.judge(done.stdout, done.stderr)

    def answer(self, listener, answers):
        """Runs a controller that sends `answers` to each line."""
        connection, _ = listener.accept()
        with connection:
            connection.sendall(b"\r\nGrblHAL 1.1f ['$' or '$HELP' for help]\r\n")
            for said in answers:
                if not connection.recv(4096):
                    return
                connection.sendall(said)
            with contextlib.suppress(OSError):
                while connection.recv(4096):
                    pass

    def send(self, job, said, *options, **more):
        listener = socket.create_server(("127.0.0.1", 0))
        thread = threading.Thread(target=self.answer, args=(listener, said), daemon=True)
        thread.start()
        words = [KERFLINE[0], "send", job, "--tcp", f"127.0.0.1:{listener.getsockname()[1]}", *options]
        process = subprocess.Popen(words, env=ENVIRONMENT, **{"stdout": subprocess.PIPE, "stdin": subprocess.DEVNULL,
                                                              "stderr": subprocess.PIPE, **more})
        return listener, thread, process

    def test_answers_of_a_controller(self):
        evil = EVIL.replace(b"\n", b"").replace(b"\r", b"")
        job = self.folder / "job.nc"
        job.write_text(PROGRAM)
        state = b"<Hold:0" + evil + b"|MPos:0,0,0|FS:0,0>\r\n"
        cases = ((state, b"[MSG:" + evil + b"]\r\nerror:" + evil + b"\r\n"), (state, b"ALARM:" + evil + b"\r\n"),
                 (b"error:20 " + evil + b"\r\n",), (b"ok\r\n" + state, evil + b"\r\n"))
        with concurrent.futures.ThreadPoolExecutor(len(cases)) as threads:  # Each waits some seconds for more.
            texts = threads.map(lambda said: self.said_of(job, said), cases)
        for said, (out, err) in zip(cases, texts):
            with self.subTest(said=said):
                self.judge(out, err)

    def said_of(self, job, said):
        """Returns the output of `send` when a controller sends only `said`, and the user stops."""
        listener, thread, process = self.send(str(job), said, "--stop-when-held")
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(timeout=3)
        process.send_signal(2)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(timeout=5)
        process.kill()
        texts = process.communicate()
        listener.close()
        thread.join(timeout=5)
        return texts

    def test_progress_on_a_terminal(self):
        """Only the progress bar moves the cursor."""
        job = self.folder / f"job{NAME}.nc"
        job.write_text("G21 G91\nM4 S500\n" + "G1 X1 F1000\nG1 X-1\n" * 20000)
        for words in (["check", str(job)], ["sim", str(job)]):
            with self.subTest(words=words):
                main, other = pty.openpty()
                process = subprocess.Popen([KERFLINE[0], *words], stdout=subprocess.DEVNULL, stderr=other,
                                           env=ENVIRONMENT)
                os.close(other)
                text = b""
                end = time.monotonic() + 3
                with contextlib.suppress(OSError):  # A command that has ended hangs up.
                    while time.monotonic() < end and process.poll() is None:
                        if select.select([main], [], [], 0.1)[0]:
                            text += os.read(main, 4096)
                process.terminate()
                process.communicate()
                os.close(main)
                bars = text.split(b"\r\x1b[K")
                self.assertGreater(len(bars), 2, text)
                for bar in bars:
                    self.judge(bar, b"")


if __name__ == "__main__":
    KERFLINE[0] = sys.argv[1]
    Server.start()
    try:
        unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
    finally:
        Server.stop()
