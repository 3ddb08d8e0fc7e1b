#!/usr/bin/env python3
"""Tests the commands that the documents print. Those of walk-throughs are run; of all others,
every option must exist.

    documents_test.py KERFLINE REPOSITORY
"""

import glob
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import share_of  # noqa: E402

KERFLINE = ""
REPOSITORY = pathlib.Path()
# Every command of these pages is run in order, from the root of the repository.
WALK_THROUGHS = ("README.md", "docs/laser.md", "docs/sheet-metal.md", "docs/mill.md")
EXAMPLES = "host-sim/examples/"
# Options whose value is a file that the command reads.
INPUTS = ("--settings", "--db", "--post", "--recipe", "--program", "--read", "--measured", "--stock-surface",
          "--stock-target", "--tools", "--boundary", "--rules", "--layers", "--beams", "--probe-surface")
# These commands never end, or require another program at the other end of a link.
KEPT_RUNNING = ("serve", "send", "replay")


def blocks_of(page):
    """Returns the commands that begin with `kerfline`, for each block of commands of a page."""
    text = page.read_text(encoding="utf-8")
    for block in re.findall(r"```sh\n(.*?)```", text, re.DOTALL):
        lines = block.replace("\\\n", " ").splitlines()
        commands = [shlex.split(line, comments=True) for line in lines if line.startswith("kerfline ")]
        if commands:
            yield [command[1:] for command in commands]


def inputs_of(words):
    """Returns the files that a command reads: words that do not follow an option, and the values
    of INPUTS.
    """
    for before, word in zip(words, words[1:]):
        is_read = before in INPUTS or not before.startswith("-")
        if is_read and re.fullmatch(r"[\w./*-]+\.[a-z]+", word):
            yield word


def run(*words, **more):
    return subprocess.run([KERFLINE, *words], capture_output=True, text=True, check=False, timeout=300,
                          env={"PATH": "/usr/bin"}, **more)


class Documents(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "host-sim").symlink_to(REPOSITORY / "host-sim")

    def files_of(self, word):
        """Returns the files that match a pattern, as a shell does; the word itself if none does."""
        return sorted(glob.glob(word, root_dir=self.folder)) or [word]

    def run_here(self, page, words):
        words = [file for word in words for file in self.files_of(word)]
        done = run(*words, cwd=self.folder)
        self.assertEqual(done.returncode, 0, f"{page}: kerfline {shlex.join(words)}\n{done.stdout}{done.stderr}")
        return done

    def send(self, page, words):
        """Runs `send` with a simulated machine instead of the port that the page names."""
        port = self.folder / "tty"
        with subprocess.Popen([KERFLINE, "serve", "--pty", port, "--machine", "k40", "--speed", "50"],
                              stdout=subprocess.DEVNULL) as machine:
            self.addCleanup(machine.kill)
            until = time.monotonic() + 30
            while not port.is_symlink() and time.monotonic() < until:
                time.sleep(0.01)
            given = list(words)
            given[given.index("--port") + 1] = str(port)
            self.run_here(page, given)
            machine.terminate()

    def test_walk_throughs_run_as_they_are_printed(self):
        for page in WALK_THROUGHS:
            sent = 0
            commands = [command for block in blocks_of(REPOSITORY / page) for command in block]
            self.assertGreater(len(commands), 2, page)
            for words in commands:
                if words[0] == "send":
                    self.send(page, words)
                    sent += 1
                elif words[0] != "serve":
                    done = self.run_here(page, words)
                    self.assertNotIn("differ from those for which this program", done.stdout + done.stderr, page)
            self.assertEqual(sent, page in ("README.md", "docs/laser.md"), page)

    def test_examples_of_other_pages_run(self):
        """Runs the commands whose files exist: the project's examples, and the files that a page creates."""
        pages = sorted(page for page in (REPOSITORY / "docs").rglob("*.md")
                       if page.relative_to(REPOSITORY).as_posix() not in WALK_THROUGHS and
                       any(EXAMPLES in word for block in blocks_of(page) for words in block for word in words))
        self.assertGreater(len(pages), 5)
        ran = 0
        for page in share_of(pages, 4, "documents.pages"):
            for words in (command for block in blocks_of(page) for command in block):
                files = list(inputs_of(words))
                is_there = all("*" in file or (self.folder / file).is_file() for file in files)
                if words[0] in KEPT_RUNNING or not files or not is_there:
                    continue
                self.run_here(page.name, words)
                ran += 1
        self.assertGreater(ran, 3)

    def test_every_option_that_a_page_prints_exists(self):
        helps = {}
        for page in [REPOSITORY / "README.md", *sorted((REPOSITORY / "docs").rglob("*.md"))]:
            for words in (command for block in blocks_of(page) for command in block):
                names = [word for word in words[:2] if re.fullmatch(r"[a-z][a-z-]*", word)]
                if tuple(names) not in helps:
                    done = run(*names, "--help")
                    helps[tuple(names)] = done.stdout if done.returncode == 0 else run(names[0], "--help").stdout
                for word in words:
                    if option := re.match(r"--[a-z][a-z-]*", word):
                        self.assertRegex(helps[tuple(names)], rf"{option[0]}[ ,:\n]",
                                         f"{page.name}: kerfline {shlex.join(words)}")


if __name__ == "__main__":
    REPOSITORY = pathlib.Path(sys.argv.pop(2)).resolve()
    KERFLINE = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
