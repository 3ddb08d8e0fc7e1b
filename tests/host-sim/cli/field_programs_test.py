#!/usr/bin/env python3
"""Programs as users and their CAM software write them, with `check`, `sim` and `send`.

    field_programs_test.py KERFLINE

Each case is a kind of input that a controller of this kind once refused, misread or processed
without end.
"""

import contextlib
import dataclasses
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import name_of, share_of  # noqa: E402

KERFLINE = ""
LASER = ("--set", "$32=1", "--set", "$30=1000")
SECONDS = 60
SENT_IN_TEST = 8  # Of CASES; as many are sent to a controller in toolchain/test.sh.


@dataclasses.dataclass
class Case:
    """A program and the expected result: `said` and `unsaid` are patterns for the output of
    `check`; `status` is that of all three commands.
    """
    program: bytes
    said: tuple = ()
    unsaid: tuple = ()
    status: int = 0
    options: tuple = ()


LONG_COMMENT = b"( text='" + b"1234567890" * 29 + b"' )\nG1 X1 F500\n"

CASES = {
    "offset word of the plane's third axis": Case(
        b"G17 G90\nG21\nG0 X10 Y0\nG1 Z-1 F100\nG2 X0 Y-10 Z-1 I-10 J0 K0 F100\nM2\n",
        (r"X 0\.000 to 10\.000  Y -10\.000 to 0\.000",), ("warning",)),
    "full circle without end words": Case(
        b"%\nG00 Z0.5\nG00 X-4.5 Y0\nG01 Z-0.4 F50\nG02 I4.5\nG00 Z0.5\nM30\n%\n",
        (r"X -4\.500 to 4\.500  Y -4\.500 to 4\.500",), ("warning",)),
    "program number O": Case(b"O0001\nN1 G21\nN2 (6MM CRB 2FL 19 LOC)\nN4 T01 M06\nN5 S400 M03\nG1 X1 F500\n",
                             (r"X 0\.000 to 1\.000", "requires another tool"), ("M6 left out",),
                             options=LASER[2:]),
    "program number with a colon": Case(b":1001\nG0 X1\n", (r"X 0\.000 to 1\.000",), ("warning",)),
    "name after a percent sign": Case(b"%1001\nG0 X1\n% end\n", (r"X 0\.000 to 1\.000",), ("warning",)),
    "G49 beside a motion": Case(b"G0 G17 G40 G49 G90\nG49 G0 Z10\nG80 G0 Z5\n", (r"Z 0\.000 to 10\.000",),
                                ("warning",)),
    "comment longer than a line": Case(LONG_COMMENT, (r"X 0\.000 to 1\.000",), ("warning",)),
    "block delete": Case(b"G21 G90\n/G0 X5\nN10 /G0 X7\n", (r"1: lines that begin with / are skipped",
                                                            "no motion")),
    "block delete off": Case(b"G21 G90\n/G0 X5\nN10 /G0 X7\n", (r"X 0\.000 to 7\.000",), ("skipped",),
                             options=("--set", "$890=0")),
    "byte order mark": Case(b"\xef\xbb\xbfG21\nG1 X5 F500\n", (r"X 0\.000 to 5\.000", "byte order mark")),
    "no-break space": Case("G21\u00a0G90\nG1\u00a0X5 F500\n".encode(), (r"X 0\.000 to 5\.000", "U\\+00A0")),
    "control bytes": Case(b"G21\x1a\nG1 X5\x07 F500\n", (r"X 0\.000 to 5\.000",)),
    "right sums": Case(b"N1 G21*27\nN2 G1 X5 F500*52\nN3 G1 X0*99\n",
                       (r"X 0\.000 to 5\.000", "the checks of lines are correct, and are left out; 3 times")),
    "sums before comments": Case(b"N1 G21*27 ; mm\nN2 G1 X5 F500*52 ; go\n", (r"X 0\.000 to 5\.000",)),
    "wrong sums": Case(b"N1 G21*20\nN2 G1 X5 F500*1\n",
                       (r":1:7: the check does not match", r":2:14: the check does not match"), status=1),
    "a star that is no sum": Case(b"G21 G90 F600\nG0 Z5\nN10 G1 X[2*5]\nG1 Z-1\nG1 Y10\nM2\n",
                                  (r":3:8: parameters and expressions are not supported",), status=1),
    "lines after M2": Case(b"G21 G90\nG1 X10 F1000\nM2\nG1 X20 F1000\nM30\n",
                           (r"X 0\.000 to 10\.000", r":4: the program ended in line 3")),
    "light in a dwell under M3": Case(
        b"G21 G90\nM3 S500\nG1 X10 F1000\nG4 P0.5\nG1 X20\nM5\n",
        (r":4: the beam is off during this dwell",), options=LASER),
    "light in a dwell that is allowed": Case(
        b"G21 G90\nM3 S500\nG1 X10 F1000\nG4 P0.5\nG1 X20\nM5\n", (), ("warning",),
        options=(*LASER, "--set", "$870=60", "--set", "$871=600")),
    "S and F beyond the machine": Case(
        b"G21 G90\nM3 S5000\nG1 X10 F99999\nM5\n",
        (r":2: S5000 is above \$30=1000", r":3: F99999 is above \$110="), options=LASER),
    "turns without end": Case(b"G21 G90\nG2 X0 Y0 I10 P10000000 F1000\n", (r":2:14: P10000000 is greater",),
                              status=1),
    "a motion of years": Case(b"G21 G90\nG93\nG1 Y1 F.0000001\n", (r":3:\d+: .*30 days",), status=1),
    "leads of arcs beside a square": Case(
        b"G21 G90 F600\nG10 L1 P4 R3\nG0 X-10 Y-5\nG41 D4\nG1 X-10 Y5\nG3 X0 Y15 I0 J10\nG1 Y30\nX40\nY0\nX0\n"
        b"Y15\nG3 X-10 Y25 I-10 J0\nG40\nG1 X-20 Y25\nM2\n",
        (r"X -20\.000 to 43\.000  Y -5\.000 to 33\.000",), ("warning",)),
    "home one axis": Case(b"$HX\nG1 X1 F500\n", (r":1:\d+: ",), status=1, options=("--set", "$22=1")),
    "an O-word": Case(b"o100 sub\nG1 X1 F500\no100 endsub\n", (r":1:1: O-words are not supported",), status=1),
}


def run(*arguments):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
                          timeout=SECONDS)


class FieldPrograms(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = pathlib.Path(folder.name) / "part.nc"

    def each(self, judge, names=tuple(CASES)):
        for name in names:
            case = CASES[name]
            with self.subTest(name):
                self.file.write_bytes(case.program)
                judge(case)

    def test_check_says_all_that_matters(self):
        def judge(case):
            done = run("check", self.file, *case.options)
            said = done.stdout + done.stderr
            self.assertEqual(done.returncode, case.status, said)
            for pattern in case.said:
                self.assertRegex(said, pattern)
            for pattern in case.unsaid:
                self.assertNotRegex(said, pattern)
        self.each(judge)

    def test_sim_takes_what_check_takes(self):
        def judge(case):
            done = run("sim", self.file, *case.options)
            self.assertEqual(done.returncode, case.status, done.stdout + done.stderr)
        self.each(judge)

    def test_send_takes_what_check_takes(self):
        with serving() as address:
            def judge(case):
                if case.options:
                    return  # Of another machine.
                done = run("send", self.file, "--tcp", address)
                self.assertEqual(done.returncode, case.status, done.stdout + done.stderr)
            self.each(judge, share_of(list(CASES), SENT_IN_TEST, name_of(self)))


@contextlib.contextmanager
def serving():
    """Runs a controller faster than real time, and yields its address."""
    with subprocess.Popen([KERFLINE, "serve", "--tcp", "0", "--speed", "100"], stdout=subprocess.PIPE,
                          text=True) as server:
        try:
            yield next(found[1] for line in server.stdout
                       if (found := re.search(r"(127\.0\.0\.1:\d+)", line)))
        finally:
            server.terminate()


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
