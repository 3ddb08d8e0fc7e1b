"""Shared by the tests of `kerfline cut`: drawings, calls, and the check that a call is refused."""

import pathlib
import subprocess
import tempfile
import unittest

KERFLINE = ""
PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80">
<path id="plate" d="M10 10H80A15 15 0 0 1 95 25V60H60V50A8 8 0 0 0 44 50V60H10Z"/>
<circle id="bore" cx="28" cy="30" r="9"/><circle id="screw" cx="80" cy="25" r="2.5"/>
<path id="mark" d="M20 55H30" stroke="red"/>
</svg>
"""
CURVES = """<svg xmlns="http://www.w3.org/2000/svg" width="90mm" height="60mm" viewBox="0 0 90 60">
<path id="leaf" d="M10 30C10 5 45 0 80 30C60 60 10 55 10 30Z"/>
<ellipse id="eye" cx="35" cy="30" rx="12" ry="7" transform="rotate(15 35 30)"/>
</svg>
"""
SHEET = '<svg width="200mm" height="200mm" viewBox="0 0 200 200">'
FINE_STEPS = ("--set", "$0=1", "--set", "$100=400", "--set", "$101=400")
STEEL = ("--material", "CSP 1N", "--thickness", "2")


def run(*arguments, text=None):
    return subprocess.run([KERFLINE, *map(str, arguments)], input=text, capture_output=True,
                          text=True, check=False, env={"PATH": "/usr/bin"})


class CutBench(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.plate = self.folder / "plate.svg"
        self.plate.write_text(PLATE)
        self.marks = ("--layer", "red: side=on, feed=5000")

    def cut(self, *more):
        return run("cut", self.plate, *STEEL, *self.marks, *more)

    def refused(self, *call, status=2):
        done = run("cut", *call)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr

    def drawn(self, name, content):
        file = self.folder / name
        file.write_text(content)
        return file
