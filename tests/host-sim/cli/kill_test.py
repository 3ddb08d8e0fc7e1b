#!/usr/bin/env python3
"""Tests that a process that ends at any call that changes a file leaves the complete old file or
the complete new one.

    kill_test.py KERFLINE KILL_AT

KILL_AT is the library of kill_at.cpp. Every output, store, database and rewritten file of every
command is tested at every write, rename, removal and flush. A write that is hit is half done.
"""

import contextlib
import pathlib
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

from files_bench import CUTS, ENVIRONMENT, KERFLINE, Bench, Server, some_calls

LIBRARY = [""]
# Of long files, the first and the last calls are tested, and some between them.
MOST_CALLS = 40


def killing(folder, **more):
    return {**ENVIRONMENT, "LD_PRELOAD": LIBRARY[0], "KILL_FOLDER": str(folder), **more}


def chosen(count):
    """Returns the numbers of the calls at which a process is ended."""
    if count <= MOST_CALLS:
        return range(1, count + 1)
    half = MOST_CALLS // 2
    return [*range(1, half), *range(half, count - half, max(1, (count - MOST_CALLS) // 10)),
            *range(count - half, count + 1)]


class Killed(unittest.TestCase):
    @contextlib.contextmanager
    def bench(self, name, command, **what):
        with tempfile.TemporaryDirectory() as folder, self.subTest(name, **what):
            yield Bench(pathlib.Path(folder), name, command)

    def count_of(self, bench, files, counter):
        code, _, err = bench.run(files, env=killing(bench.folder, KILL_COUNT=str(counter)))
        self.assertEqual(code, 0, err)
        count = int(counter.read_text())
        self.assertGreaterEqual(count, 2, "a write and a rename at least")
        return count

    def test_outputs(self):
        for name, command in some_calls(self):
            for option in (*command.outputs, *command.updates):
                with self.bench(name, command, option=option) as bench, tempfile.TemporaryDirectory() as aside:
                    file = bench.files[option]
                    old = file.read_bytes()
                    wanted = bench.needed(option)
                    count = self.count_of(bench, wanted, pathlib.Path(aside) / "count")
                    new = file.read_bytes()
                    self.assertNotEqual(new, old)
                    news = 0
                    for call in chosen(count):
                        file.write_bytes(old)
                        code, _, err = bench.run(wanted, env=killing(bench.folder, KILL_AT=str(call)))
                        # Times in a log or a recording vary, and with them the number of calls.
                        timed = name in ("send", "serve")
                        self.assertTrue(code == -signal.SIGKILL or (timed and code == 0), (call, code, err))
                        found = file.read_bytes()
                        if timed:
                            self.assertTrue(found == old or self.is_whole(option, found, new), (call, found))
                        else:
                            self.assertIn(found, (old, new), call)
                        news += found != old
                        for left in bench.folder.glob(".*.part"):
                            left.unlink()
                    self.assertLess(news, 2 + MOST_CALLS // 4, "the last calls only find the new file")

    @staticmethod
    def is_whole(option, found, new):
        """Returns whether a file begins and ends like one that was written without interruption,
        and is about as long.
        """
        last = found.rstrip(b"\n").rsplit(b"\n", 1)[-1]
        of_new = new.rstrip(b"\n").rsplit(b"\n", 1)[-1]
        if option == "--trace":
            return found.startswith(new[:20]) and found.endswith(b"\n")
        if option == "--record":
            return found.startswith(new[:20]) and last.startswith(b"end ") and of_new.startswith(b"end ")
        return found.endswith(b"\n") and found.count(b"\n") >= new.count(b"\n") // 2

    def test_data_base(self):
        """Each change is stored completely or not at all, and the database is sound."""
        more = CUTS.replace("tin", "zinc")
        with tempfile.TemporaryDirectory() as place, tempfile.TemporaryDirectory() as aside:
            folder, counter = pathlib.Path(place), pathlib.Path(aside) / "count"
            base = folder / "kerf.db"

            def kerf(*words, text=None, env=None):
                return subprocess.run([KERFLINE[0], "kerf", *words, "--db", str(base)], input=text, text=True,
                                      capture_output=True, check=False, env=env or ENVIRONMENT)

            def state():
                """The product reads the database first, then SQLite itself."""
                shown = [kerf("show", "--material", material, "--cuts").stdout for material in ("tin", "zinc")]
                connection = sqlite3.connect(base)
                self.assertEqual(connection.execute("PRAGMA integrity_check").fetchone(), ("ok",))
                connection.close()
                return (*shown, kerf("show").stdout)

            self.assertEqual(kerf("add", "-", text=CUTS).returncode, 0)
            for words, text in ((("add", "-"), more), (("fit", "--material", "tin"), None)):
                before = {path.name: path.read_bytes() for path in folder.iterdir()}
                old = state()
                self.assertEqual(kerf(*words, text=text, env=killing(folder, KILL_COUNT=str(counter))).returncode, 0)
                new = state()
                self.assertNotEqual(old, new)
                count = int(counter.read_text())
                self.assertGreater(count, 5)
                for call in chosen(count):
                    with self.subTest(words=words, call=call):
                        for path in folder.iterdir():
                            path.unlink()
                        for name, content in before.items():
                            (folder / name).write_bytes(content)
                        done = kerf(*words, text=text, env=killing(folder, KILL_AT=str(call)))
                        self.assertEqual(done.returncode, -signal.SIGKILL, done.stderr)
                        self.assertIn(state(), (old, new))
                        again = kerf(*words, text=text)
                        self.assertIn(again.returncode, (0, 2), "a file that was added is not added twice")
                        self.assertEqual(state(), new)

    def serve(self, store, **kill):
        process = subprocess.Popen([KERFLINE[0], "serve", "--tcp", "0", "--store", str(store)], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                   env=killing(store.parent, **kill))
        port = 0
        for line in process.stdout:
            if line.startswith("tcp "):
                port = int(line.rsplit(":", 1)[1])
            if line == "ready\n":
                break
        return process, port

    @staticmethod
    def ask(port, line):
        """Returns the server's lines after a request, until it ends or acknowledges."""
        said = b""
        with socket.create_connection(("127.0.0.1", port), timeout=10) as connection:
            with contextlib.suppress(OSError):
                while b"help]" not in said:
                    said += connection.recv(4096) or b"help]"
                connection.sendall(line.encode() + b"\n")
                begun = time.monotonic()
                while b"ok\r\n" not in said and b"error:" not in said and time.monotonic() < begun + 10:
                    part = connection.recv(4096)
                    if not part:
                        break
                    said += part
        return said.decode("latin-1")

    def stop(self, process):
        if process.poll() is None:
            process.terminate()
        process.communicate(timeout=20)

    def test_store(self):
        """Acknowledged changes are kept; others are stored completely or not at all."""
        with tempfile.TemporaryDirectory() as place, tempfile.TemporaryDirectory() as aside:
            store, counter = pathlib.Path(place) / "store", pathlib.Path(aside) / "count"
            process, port = self.serve(store)
            self.assertIn("ok", self.ask(port, "$110=1111"))
            self.stop(process)
            old = store.read_bytes()
            process, port = self.serve(store, KILL_COUNT=str(counter))
            begun = int(counter.read_text()) if counter.exists() else 0
            self.assertIn("ok", self.ask(port, "$110=2222"))
            self.stop(process)
            count = int(counter.read_text())
            self.assertGreater(count, begun + 1)
            kept = 0
            for call in range(begun + 1, count + 1):
                with self.subTest(call=call):
                    store.write_bytes(old)
                    process, port = self.serve(store, KILL_AT=str(call))
                    said = self.ask(port, "$110=2222")
                    process.communicate(timeout=20)
                    self.assertEqual(process.returncode, -signal.SIGKILL)
                    process, port = self.serve(store)
                    now = self.ask(port, "$$")
                    self.stop(process)
                    changed = "$110=2222" in now
                    self.assertTrue(changed or "$110=1111" in now, now)
                    self.assertTrue(changed or "ok\r\n" not in said.partition("help]")[2], "an ok was a promise")
                    kept += changed
            self.assertLess(kept, count - begun, "a call before the rename leaves the old one")

    def test_store_that_is_created(self):
        """A first start that is ended at any call leaves no store, or one that the next start can use."""
        with tempfile.TemporaryDirectory() as place, tempfile.TemporaryDirectory() as aside:
            store, counter = pathlib.Path(place) / "store", pathlib.Path(aside) / "count"
            process, _ = self.serve(store, KILL_COUNT=str(counter))
            self.stop(process)
            for call in range(1, int(counter.read_text()) + 1):
                with self.subTest(call=call):
                    store.unlink(missing_ok=True)
                    process, _ = self.serve(store, KILL_AT=str(call))
                    process.communicate(timeout=20)
                    process, port = self.serve(store)
                    self.assertNotEqual(port, 0, "the next server starts")
                    self.stop(process)


if __name__ == "__main__":
    KERFLINE[0], LIBRARY[0] = sys.argv[1], sys.argv[2]
    Server.start()
    try:
        unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
    finally:
        Server.stop()
