#!/usr/bin/env python3
"""Checks that the programs in the folder `cut` of the examples are those that the commands in
their README make of the drawings there.

    example_cuts_test.py KERFLINE EXAMPLES
"""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

KERFLINE = pathlib.Path(sys.argv[1]).resolve()
EXAMPLES = pathlib.Path(sys.argv[2]).resolve()
CUT = EXAMPLES / "cut"


def commands():
    """Returns the words of each `kerfline cut` in the README, by the name of the program that it writes."""
    text = (EXAMPLES / "README.md").read_text(encoding="utf-8").replace("\\\n", " ")
    found = [shlex.split(line)[1:] for line in re.findall(r"^kerfline cut .*$", text, re.MULTILINE)]
    return {words[words.index("-o") + 1]: words for words in found}


class ExampleCutsTest(unittest.TestCase):
    def test_every_program_has_its_command(self):
        self.assertEqual(set(commands()), {path.name for path in CUT.glob("*.nc")})
        self.assertGreaterEqual(len(commands()), 2)

    def test_the_programs_are_what_the_commands_write(self):
        with tempfile.TemporaryDirectory() as folder:
            work = pathlib.Path(folder) / "cut"
            work.mkdir()
            shutil.copy(EXAMPLES / "laser.settings", folder)
            for drawing in CUT.glob("*.svg"):
                shutil.copy(drawing, work)
            for program, words in commands().items():
                with self.subTest(program):
                    done = subprocess.run([KERFLINE, *words], cwd=work, capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertEqual((work / program).read_text(encoding="utf-8"),
                                     (CUT / program).read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
