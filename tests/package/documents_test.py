"""Tests the manual page with a strict reader, and the completions in zsh and fish.

usage: documents_test.py KERFLINE
"""
import os
import pathlib
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

import command_help

KERFLINE = sys.argv[1]
NEEDED = ("mandoc", "zsh", "fish")  # [prove] in toolchain/packages.txt.
PROMPT = "ready>"


def printed(*arguments) -> str:
    return subprocess.run([KERFLINE, *arguments], capture_output=True, text=True, check=True).stdout


class Document(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, text):
        (self.folder / name).write_text(text)
        return self.folder / name


class Manual(Document):
    def test_a_strict_reader_finds_nothing(self):
        page = self.write("kerfline.1", printed("manual"))
        run = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", page],
                             capture_output=True, text=True, check=False)
        # The date of a page is that of its version, which is given at its foot.
        findings = [line for line in run.stdout.splitlines() if "missing date" not in line]
        self.assertEqual(findings, [])

    def test_reads_as_the_help_does(self):
        page = self.write("kerfline.1", printed("manual"))
        shown = subprocess.run(["mandoc", "-T", "utf8", "-O", "width=200", page],
                               capture_output=True, text=True, check=True).stdout
        text = re.sub(r".\x08", "", shown)
        self.assertIn("kerfline cut part.dxf --material 'CSP 1N' --thickness 2", text)
        for path in command_help.all_commands(KERFLINE):
            self.assertIn(" ".join(["kerfline", *path]), text)


class Fish(Document):
    def complete(self, words):
        script = self.write("kerfline.fish", printed("completion", "fish"))
        done = subprocess.run(
            ["fish", "--no-config", "-c", f"source {script}; complete -C '{words}'"],
            capture_output=True, text=True, check=True, cwd=self.folder,
            env={"HOME": str(self.folder), "PATH": "/usr/bin:/bin"})
        self.assertEqual(done.stderr, "")
        return {line.split("\t")[0] for line in done.stdout.splitlines()}

    def test_completes_every_command_and_option(self):
        for path, (subcommands, options) in command_help.all_commands(KERFLINE).items():
            words = " ".join(["kerfline", *path])
            self.assertEqual(self.complete(f"{words} --"), {o for o in options if o.startswith("--")}, words)
            if subcommands:
                # Files are offered, too, if the command itself accepts one.
                files = {file.name for file in pathlib.Path(self.folder).iterdir()}
                self.assertEqual(self.complete(f"{words} ") - files, set(subcommands), words)

    def test_completes_values(self):
        self.assertEqual(self.complete("kerfline offset --fit "), {"fewest", "paper"})
        self.assertEqual(self.complete("kerfline completion "), {"bash", "fish", "zsh"})
        self.write("part.nc", "")
        self.assertEqual(self.complete("kerfline sim --settings par"), {"part.nc"})
        self.assertEqual(self.complete("kerfline sim --set par"), set())


class Zsh(Document):
    """Needs a terminal: zsh completes nowhere else."""

    def setUp(self):
        super().setUp()
        script = self.write("_kerfline", printed("completion", "zsh"))
        child, self.terminal = pty.fork()
        if child == 0:
            os.chdir(self.folder)
            os.execvpe("zsh", ["zsh", "-f"],
                       {"HOME": str(self.folder), "PATH": "/usr/bin:/bin", "TERM": "dumb",
                        "PS1": PROMPT, "COLUMNS": "300"})
        self.addCleanup(os.close, self.terminal)
        os.set_blocking(self.terminal, False)
        self.shown = ""
        self.read_to(PROMPT)
        loaded = self.say(f"fpath=({script.parent} $fpath); autoload -U compinit; compinit -u -D; "
                          "setopt no_beep no_always_last_prompt; print for-$_comps[kerfline]\n",
                          "for-_kerfline")
        self.assertNotIn("error", loaded)
        self.read_to(PROMPT)

    def read_to(self, words, seconds=20.0):
        """Returns the terminal's output up to the words; later output is left for the next call."""
        end = time.monotonic() + seconds
        while words not in self.shown:
            self.assertLess(time.monotonic(), end, f"{words!r} does not come: {self.shown!r}")
            try:
                self.shown += os.read(self.terminal, 65536).decode(errors="replace")
            except BlockingIOError:
                time.sleep(0.02)
        before, _, self.shown = self.shown.partition(words)
        return before

    def say(self, keys, words):
        os.write(self.terminal, keys.encode())
        return self.read_to(words)

    def complete(self, words, expected):
        """Types words and a tab, and expects that the line becomes `expected`."""
        self.say(f"{words}\t", expected)
        self.say("\x15print done-$((1 + 1))\n", "done-2")  # Nothing of this line is read as the next.
        self.read_to(PROMPT)

    def test_completes_every_command(self):
        for path in command_help.all_commands(KERFLINE):
            if path:
                words = " ".join(["kerfline", *path])
                self.complete(words, f"{words} ")

    def test_completes_options_and_values(self):
        self.complete("kerfline sim --tra", "kerfline sim --trace=")
        self.complete("kerfline kerf calibrate --spee", "kerfline kerf calibrate --speeds=")
        self.complete("kerfline offset --fit fe", "kerfline offset --fit fewest")
        self.write("part.nc", "")
        self.complete("kerfline sim par", "kerfline sim part.nc")
        self.complete("kerfline sim --settings par", "kerfline sim --settings part.nc")


if __name__ == "__main__":
    missing = [name for name in NEEDED if shutil.which(name) is None]
    if missing:
        sys.exit(f"documents_test: missing: {' '.join(missing)}; install [prove] of toolchain/packages.txt")
    unittest.main(argv=sys.argv[:1])
