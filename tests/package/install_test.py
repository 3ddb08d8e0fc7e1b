"""Installs the build into a folder and uses the installed files.

usage: install_test.py CMAKE BUILD_FOLDER
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import command_help

CMAKE, BUILD = sys.argv[1], pathlib.Path(sys.argv[2])
EXAMPLES = "share/doc/kerfline/examples"
FILES = {"bin/kerfline", "share/man/man1/kerfline.1",
         "share/bash-completion/completions/kerfline", "share/zsh/site-functions/_kerfline",
         "share/fish/vendor_completions.d/kerfline.fish",
         "share/doc/kerfline/LICENSE", "share/doc/kerfline/CHANGELOG.md",
         "share/doc/kerfline/docs/laser.md", "share/doc/kerfline/docs/reference/settings.md",
         f"{EXAMPLES}/bracket.nc", f"{EXAMPLES}/plate.svg", f"{EXAMPLES}/laser.settings",
         f"{EXAMPLES}/data/README.md"}
COMPLETE = r"""
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_kerfline && ((${#COMPREPLY[@]})) && printf '%s\n' "${COMPREPLY[@]}"
exit 0
"""


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", "/usr/local"], check=True,
                       capture_output=True, env={**os.environ, "DESTDIR": str(cls.folder)})
        cls.prefix = cls.folder / "usr/local"
        cls.kerfline = cls.prefix / "bin/kerfline"
        cls.commands = command_help.all_commands(cls.kerfline)

    def run_kerfline(self, *arguments):
        return subprocess.run([self.kerfline, *arguments], cwd=self.folder, capture_output=True,
                              text=True, check=True, env={"PATH": "/usr/bin"}).stdout

    def complete(self, *words):
        """Returns the completions that bash offers for the last word."""
        script = self.prefix / "share/bash-completion/completions/kerfline"
        done = subprocess.run(
            ["bash", "--norc", "-uc", COMPLETE, "bash", script, *words], cwd=self.folder,
            capture_output=True, text=True, check=True)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.split("\n")) - {""}

    def test_has_its_files(self):
        installed = {path.relative_to(self.prefix).as_posix()
                     for path in self.prefix.rglob("*") if path.is_file()}
        self.assertEqual(FILES - installed, set())
        self.assertEqual([name for name in installed if name.endswith(".py")], [])
        self.assertNotIn(f"{EXAMPLES}/generator", {str(path.parent) for path in map(pathlib.Path, installed)})

    def test_program_runs(self):
        built = subprocess.run([BUILD / "host-sim/kerfline", "--version"], capture_output=True, check=True)
        self.assertEqual(self.run_kerfline("--version"), built.stdout.decode())
        examples = self.prefix / EXAMPLES
        told = self.run_kerfline("sim", examples / "circle_r20.nc", "--settings",
                                 examples / "laser.settings", "--png", "circle.png")
        self.assertIn("circle_r20.nc", told)
        self.run_kerfline("cut", examples / "plate.svg", "--material", "CSP 1N", "--thickness", "2",
                          "-o", "plate.nc")
        self.run_kerfline("check", "plate.nc", "--settings", examples / "laser.settings")

    def test_there_are_commands(self):
        self.assertIn("cut", self.commands[()][0])
        self.assertIn("--trace", self.commands["sim",][1])
        self.assertIn(("kerf", "advise"), self.commands)

    def test_manual_has_every_command_and_option(self):
        page = (self.prefix / "share/man/man1/kerfline.1").read_text()
        version = self.run_kerfline("--version").strip()
        self.assertIn(f'"kerfline {version}"'.replace("-", r"\-"), page)
        sections = dict(part.split("\n", 1) for part in page.split("\n.SS ")[1:])
        for path, (_, options) in self.commands.items():
            heading = " ".join(["kerfline", *path]).replace("-", r"\-")
            section = sections[heading] if path else page
            for option in options:
                self.assertIn(r"\fB" + option.replace("-", r"\-") + r"\fR", section, path)

    def test_bash_completes_every_command_and_option(self):
        for path, (subcommands, options) in self.commands.items():
            self.assertEqual(self.complete("kerfline", *path, "-"), options, path)
            if subcommands:
                # Files are offered, too, if the command itself accepts one.
                files = {file.name for file in self.folder.iterdir()}
                self.assertEqual(self.complete("kerfline", *path, "") - files,
                                 options | set(subcommands), path)

    def test_bash_completes_values(self):
        (self.folder / "my part.nc").touch()
        self.assertEqual(self.complete("kerfline", "sim", "my"), {"my part.nc"})
        self.assertEqual(self.complete("kerfline", "sim", "--settings", "my"), {"my part.nc"})
        self.assertEqual(self.complete("kerfline", "sim", "--settings", "=", "my"), {"my part.nc"})
        self.assertEqual(self.complete("kerfline", "sim", "--settings", "="),
                         {path.name for path in self.folder.iterdir()})
        self.assertEqual(self.complete("kerfline", "sim", "--set", ""), set())
        self.assertEqual(self.complete("kerfline", "offset", "--fit", ""), {"fewest", "paper"})
        self.assertEqual(self.complete("kerfline", "kerf", "show", "--unit", "J"), {"J/mm"})
        self.assertEqual(self.complete("kerfline", "completion", "b"), {"bash"})
        self.assertEqual(self.complete("kerfline", "sim", "-o", "cut", "--sv"), {"--svg"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
