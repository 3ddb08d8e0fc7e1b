"""Drawings of pockets, and calls of `kerfline pocket` whose programs the simulated machine accepts."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

KERFLINE = sys.argv.pop(1)
MILL = ("--feed", "1200", "--plunge-feed", "300")
MACHINE = [word for setting in ("$32=0", "$30=24000", "$100=320", "$101=320", "$102=320", "$110=5000", "$111=5000",
                                "$112=2000", "$120=400", "$121=400", "$122=250", "$130=200", "$131=200")
           for word in ("--set", setting)]


def run(*arguments, text=None):
    return subprocess.run([KERFLINE, *map(str, arguments)], input=text, capture_output=True, text=True,
                          check=False, env={"PATH": "/usr/bin"})


def svg(*shapes):
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="80mm" viewBox="0 0 100 80">'
            + "".join(shapes) + "</svg>")


TRAY = svg('<rect x="10" y="10" width="60" height="40"/>', '<circle cx="40" cy="30" r="8"/>')


class PocketTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "tray.nc"

    def drawing(self, text):
        path = self.folder / "tray.svg"
        path.write_text(text)
        return path

    def pocket(self, text, *options):
        return run("pocket", self.drawing(text), "-o", self.program, *options)

    def simulated(self, *more):
        report = self.folder / "sim.json"
        done = run("sim", self.program, *MACHINE, "--report", report, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(report.read_text())
