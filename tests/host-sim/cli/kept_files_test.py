#!/usr/bin/env python3
"""Files that commands keep: the database of cuts and the store of a served controller.

    kept_files_test.py KERFLINE
"""

import os
import pathlib
import random
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

from files_bench import CUTS, ENVIRONMENT, KERFLINE, SEED, limit_files


class DataBase(unittest.TestCase):
    """The database of cuts: protection by SQLite, and by the commands."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.base = self.folder / "kerf.db"
        self.kerf("add", "-", "--db", self.base, text=CUTS)
        self.kerf("fit", "--material", "tin", "--db", self.base)

    def kerf(self, *words, text=None, status=0, **more):
        done = subprocess.run([KERFLINE[0], "kerf", *map(str, words)], input=text, text=True,
                              capture_output=True, check=False, env=ENVIRONMENT, **more)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    QUESTIONS = (("show",), ("show", "--material", "tin"), ("show", "--material", "tin", "--cuts"),
                 ("advise", "--material", "tin", "--thickness", 1), ("plot", "--material", "tin", "--thickness", 1))

    def test_questions_write_nothing(self):
        before = self.base.read_bytes(), self.base.stat().st_mtime_ns
        empty = self.folder / "empty.db"
        empty.touch()
        for question in self.QUESTIONS:
            more = ("--svg", self.folder / "out.svg") if question[0] == "plot" else ()
            self.kerf(*question, *more, "--db", self.base)
            done = self.kerf(*question, *more, "--db", empty, status=2)
            self.assertIn("not a data base of kerf knowledge", done.stderr)
        self.assertEqual((self.base.read_bytes(), self.base.stat().st_mtime_ns), before)
        self.assertEqual(empty.read_bytes(), b"")
        self.assertEqual({path.name for path in self.folder.iterdir()}, {"kerf.db", "empty.db", "out.svg"})

    def test_a_full_disk_changes_nothing(self):
        before = self.kerf("show", "--material", "tin", "--cuts", "--db", self.base).stdout
        more = CUTS.replace("tin", "zinc") * 40
        more = CUTS.splitlines(True)[0] + "".join(line for line in more.splitlines(True) if "zinc" in line)
        limit = self.base.stat().st_size + 100
        done = self.kerf("add", "-", "--db", self.base, text=more, status=2, preexec_fn=limit_files(limit))
        self.assertIn(str(self.base), done.stderr)
        self.assertEqual(self.kerf("show", "--material", "tin", "--cuts", "--db", self.base).stdout, before)
        fresh = self.folder / "fresh.db"
        self.kerf("add", "-", "--db", fresh, text=CUTS, status=2, preexec_fn=limit_files(100))
        self.assertFalse(fresh.exists())

    def test_what_a_killed_process_left_is_read_as_before(self):
        """A process that ended during a change left a journal that has to be rolled back."""
        before = self.kerf("show", "--material", "tin", "--db", self.base).stdout
        child = os.fork()
        if child == 0:
            connection = sqlite3.connect(self.base, isolation_level=None)
            connection.execute("PRAGMA cache_size = 1")
            connection.execute("PRAGMA cache_spill = 1")
            connection.execute("BEGIN IMMEDIATE")
            connection.execute("DELETE FROM record")
            for i in range(3000):
                connection.execute("INSERT INTO import (file, crc32, bytes) VALUES (?, ?, 1)", ("x" * 90, i))
            os.kill(os.getpid(), signal.SIGKILL)
        os.waitpid(child, 0)
        self.assertTrue(pathlib.Path(f"{self.base}-journal").exists())
        self.assertEqual(self.kerf("show", "--material", "tin", "--db", self.base).stdout, before)


class Store(unittest.TestCase):
    """Tests `serve --store`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.store = self.folder / "store"

    def serve(self, store=None, **more):
        link = self.folder / "tty"
        process = subprocess.Popen([KERFLINE[0], "serve", "--pty", str(link), "--store", str(store or self.store)],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT,
                                   **more)
        for line in process.stdout:
            if line == "ready\n":
                break
        self.addCleanup(self.stop, process)
        return process

    @staticmethod
    def stop(process):
        if process.poll() is None:
            process.terminate()
            process.communicate(timeout=20)
        process.stdout.close()
        process.stderr.close()

    def ask(self, words, until=("ok\r\n", "error:")):
        number = os.open(self.folder / "tty", os.O_RDWR | os.O_NOCTTY)
        try:
            time.sleep(0.3)  # A port that was opened resets the controller.
            os.write(number, words.encode() + b"\n")
            said = ""
            end = time.monotonic() + 10
            while not any(word in said.partition("help]")[2] for word in until) and time.monotonic() < end:
                said += os.read(number, 4096).decode()
            return said
        finally:
            os.close(number)

    def refused(self, store=None):
        done = subprocess.run([KERFLINE[0], "serve", "--tcp", "0", "--store", str(store or self.store)],
                              capture_output=True, text=True, timeout=20, check=False, env=ENVIRONMENT)
        self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)
        self.assertIn(str(store or self.store), done.stderr)
        return done.stderr

    def filled(self):
        process = self.serve()
        self.assertIn("ok", self.ask("$110=1234"))
        self.stop(process)
        return self.store.read_text()

    def test_any_cut_and_any_changed_byte_is_refused(self):
        whole = self.filled()
        for size in range(len(whole)):
            self.store.write_text(whole[:size])
            self.refused()
        choose = random.Random(SEED)
        for place in range(len(whole)):
            self.store.write_bytes((lambda data: data[:place] + bytes([data[place] ^ 1 << choose.randrange(8)]) +
                                    data[place + 1:])(whole.encode()))
            with self.subTest(place=place, seed=SEED):
                self.refused()
        self.store.write_text(whole)
        self.serve()
        self.assertIn("$110=1234", self.ask("$$"))

    def test_a_second_server_is_refused(self):
        self.serve()
        link = self.folder / "link"
        link.symlink_to("store")
        for name in (self.store, link):
            self.assertIn("another server uses it", self.refused(name))
        self.assertIn("ok", self.ask("$110=1234"))
        self.assertIn("another server uses it", self.refused())

    def test_a_link_stays_and_what_it_leads_to_is_kept(self):
        (self.folder / "far").mkdir()
        link = self.folder / "link"
        link.symlink_to("far/store")
        process = self.serve(link)
        self.assertIn("ok", self.ask("$110=1234"))
        self.stop(process)
        self.assertTrue(link.is_symlink())
        self.assertIn("kerfline store 2", (self.folder / "far" / "store").read_text())

    def test_a_full_disk_refuses_the_change_and_keeps_the_file(self):
        before = self.filled()
        self.serve(preexec_fn=limit_files(len(before) + 5))
        self.assertIn("error:", self.ask("$111=1234"))
        self.assertEqual(self.store.read_text(), before)
        self.assertEqual([path.name for path in self.folder.glob(".*")], [])


if __name__ == "__main__":
    KERFLINE[0] = sys.argv[1]
    print(f"seed {SEED}", file=sys.stderr)
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
