"""Tests `kerfline serve --can` and `kerfline send --can` on a CAN bus of a real kernel. User-Mode
Linux runs uml_guest.sh. This test checks the output of candump and isotpdump, the step traces
and the logs.

    uml_can_test.py KERFLINE HAL_TESTS EXAMPLES

The clock of this machine decides nothing but whether the test ends within MOST_SECONDS.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
MOST_SECONDS = 300
NODE, TO, FROM, EMERGENCY = 17, "511", "491", "091"
MILLISECOND = 1_000_000
SLOT = 10_000  # A pulse up, a pulse down, of 5 us each.
JOB = "sheet_8877.nc"
# The guest's kernel has less space for the registers of a process than this processor requires.
UNKNOWN_PROCESSOR = "ptrace set fp regs failed"
# An overloaded machine sends lines too late, which changes the plan.
SPEEDS = (10, 4)


def reason_to_skip():
    for command in ("linux.uml", "candump", "cansend", "isotpdump", "insmod", "ip"):
        if not shutil.which(command, path="/usr/bin:/bin:/usr/sbin:/sbin"):
            return f"{command} is missing"
    if not list(pathlib.Path("/usr/lib/uml/modules").glob("*/kernel/drivers/net/can/vcan.ko")):
        return "User-Mode Linux has no vcan module"
    return ""


def boot(folder, program, port_tests, examples, speed):
    """Runs the guest to its end; returns the text of its console."""
    command = ["linux.uml", "mem=256M", "root=/dev/root", "rootfstype=hostfs", "rootflags=/", "rw",
               "quiet", f"init={HERE / 'uml_guest.sh'}", "con=null", "con0=fd:0,fd:1",
               f"KERFLINE={program}", f"PORT_TESTS={port_tests}", f"EXAMPLES={examples}",
               f"RESULTS={folder}", f"SPEED={speed}"]
    ended = subprocess.run(["timeout", "-k", "5", str(MOST_SECONDS), *command], cwd=folder,
                           stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                           stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    return ended.stdout


def trace_rows(path):
    """Returns (time in ns, positions and duty) of each row."""
    rows = []
    for line in path.read_text().splitlines():
        if line[0].isdigit():
            time, _, rest = line.partition(",")
            rows.append((int(time), rest))
    return rows


def duty(row):
    return float(row[1].rpartition(",")[2])


def places(row):
    return row[1].rpartition(",")[0]


def times_of(path, kinds, words=""):
    """Returns the times at which these messages were exchanged, in the controller's ns."""
    return [int(line.split(" ", 2)[1]) for line in path.read_text().splitlines()
            if line[0] in kinds and words in line]


def frames_of(path):
    """Returns (identifier, bytes in hexadecimal) of each frame that candump recorded."""
    found = re.findall(r"vcan0\s+([0-9A-F]{3})\s+\[\d\]\s*((?:[0-9A-F]{2} ?)*)", path.read_text())
    return [(identifier, data.split()) for identifier, data in found]


def steps_of(rows):
    """Returns for each motor (time, new position, duty) of each of its steps."""
    steps, last = [[] for _ in range(6)], ["0"] * 6
    for time, rest in rows:
        *where, lit = rest.split(",")
        for motor, place in enumerate(where):
            if place != last[motor]:
                steps[motor].append((time, place, float(lit)))
        last = where
    return steps


def driven_alike(served, simulated):
    """Returns why two traces differ in their steps, or an empty string.

    Each motor must go through the same positions with the same duty. Times between steps may
    differ by a slot of $0, in which steps of several motors are sent together: a plan that was
    computed with other lines in the queue differs in its last bits. A machine at rest may wait
    a cycle longer for its next line.
    """
    for motor, (ones, others) in enumerate(zip(steps_of(served), steps_of(simulated))):
        if [step[1] for step in ones] != [step[1] for step in others]:
            return f"motor {motor} goes elsewhere: {len(ones)} steps, not {len(others)}"
        for number in range(1, len(ones)):
            one, other = (steps[number][0] - steps[number - 1][0] for steps in (ones, others))
            if other < MILLISECOND and abs(one - other) > SLOT:
                return f"motor {motor}, step {number}: {one} ns after the last one, not {other}"
            if abs(ones[number][2] - others[number][2]) > 0.001:
                return f"motor {motor}, step {number}: {ones[number]}, not {others[number]}"
    return ""


class UmlCanTest(unittest.TestCase):
    program = port_tests = examples = None

    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.keeper.cleanup)
        simulated = pathlib.Path(cls.keeper.name) / "simulated"
        subprocess.run([cls.program, "sim", cls.examples / JOB, "--settings",
                        cls.examples / "laser.settings", "--trace", simulated],
                       stdout=subprocess.DEVNULL, check=True)
        expected = trace_rows(simulated)
        for speed in SPEEDS:
            cls.folder = pathlib.Path(cls.keeper.name) / f"speed{speed}"
            cls.folder.mkdir()
            cls.console = boot(cls.folder, cls.program, cls.port_tests, cls.examples, speed)
            if UNKNOWN_PROCESSOR in cls.console:
                print("skipped: User-Mode Linux cannot keep all the state of this processor")
                sys.exit(77)
            if not (cls.folder / "done").exists():
                raise AssertionError(f"the guest did not come to its end: {cls.console[-2000:]}")
            cls.difference = driven_alike(trace_rows(cls.folder / "job.trace"), expected)
            if not cls.difference:
                break
            print(f"at {speed} times its speed: {cls.difference}", file=sys.stderr)

    def text(self, name):
        return (self.folder / name).read_text()

    def test_says_what_is_wrong_with_an_interface(self):
        lines = self.text("refused").splitlines()
        self.assertEqual(lines[1::2], ["2", "2", "2", "1"], lines)
        for line, words in zip(lines[::2], ("no such interface", "is no CAN bus", "is down",
                                            "node 17 is silent on vcan0")):
            self.assertIn(words, line)

    def test_the_port_keeps_its_contract(self):
        self.assertEqual(self.text("port_tests.exit"), "0\n", self.text("port_tests"))
        self.assertIn("[  PASSED  ] 4 tests", self.text("port_tests"))

    def test_a_job_is_driven_as_it_is_simulated(self):
        self.assertEqual(self.text("job.exit"), "0\n", self.text("job.err"))
        self.assertEqual(self.text("job.status"), "0\n", self.text("job.served"))
        self.assertEqual(self.difference, "")

    def test_isotpdump_decodes_every_frame(self):
        frames = [frame for frame in frames_of(self.folder / "job.candump")
                  if frame[0] in (TO, FROM)]
        lines = self.text("job.isotp").splitlines()
        self.assertGreater(len(frames), 3000)
        self.assertEqual(len(lines), len(frames))
        kinds = {"SF": 1, "FF": 2, "CF": 1}
        text = {TO: "", FROM: ""}
        for line, (identifier, data) in zip(lines, frames):
            found = re.search(rf"vcan0\s+{identifier}\s+\[{len(data)}\]\s+\[(SF|FF|CF|FC)\] (.*)$", line)
            self.assertIsNotNone(found, line)
            if found[1] != "FC":
                decoded = found[2].partition("data:")[2].split()
                self.assertEqual(decoded, data[kinds[found[1]]:], line)
                text[identifier] += bytes.fromhex("".join(decoded)).decode("latin-1")
        sent = [line.split(" > ", 1)[1] for line in self.text("job.sent").splitlines() if " > " in line]
        self.assertEqual(text[TO], "".join(f"{line}\n" for line in sent))
        self.assertEqual(text[FROM].count("ok\r\n"), len(sent))

    def test_a_stop_of_the_network_ends_all_within_a_millisecond(self):
        frames = frames_of(self.folder / "stop.candump")
        self.assertIn(("000", ["02", "00"]), frames)
        after = frames[frames.index(("000", ["02", "00"])):]
        emergencies = [data for identifier, data in after if identifier == EMERGENCY]
        self.assertEqual(emergencies[0][:4], ["00", "FF", "01", "18"])
        stops = times_of(self.folder / "stop.record", "!")
        self.assertEqual(len(stops), 1)
        rows = trace_rows(self.folder / "stop.trace")
        before = [row for row in rows if row[0] < stops[0]]
        self.assertGreater(before[-1][0], stops[0] - 20 * MILLISECOND, "it moves")
        end = [row for row in rows if row[0] <= stops[0] + MILLISECOND][-1]
        self.assertEqual(duty(end), 0.0)
        for row in rows:
            if row[0] > stops[0] + MILLISECOND:
                self.assertEqual((places(row), duty(row)), (places(end), 0.0))
        self.assertEqual(self.text("stop.exit"), "1\n")
        self.assertIn("ALARM:24", self.text("stop.err"))
        self.assertIn(" * node 17: alarm 24", self.text("stop.sent"))
        self.assertEqual(self.text("stop.status"), "0\n")

    def test_a_sender_or_a_bus_that_is_gone_darkens_the_beam(self):
        self.assertEqual(self.text("down.exit"), "1\n")
        self.assertIn("can vcan0 is gone", self.text("down.err"))
        self.assertEqual(self.text("again.exit"), "0\n", self.text("again.err"))
        lost = times_of(self.folder / "lost.record", ">^", "\\x84")
        self.assertEqual(len(lost), 3)  # Killed, down, and the one who was done.
        rows = trace_rows(self.folder / "lost.trace")
        resets = times_of(self.folder / "lost.record", ">^", "\\x18")
        for time in lost:
            begun = min([reset for reset in resets if reset > time] + [rows[-1][0]])
            lit = [row for row in rows if time + 2 * MILLISECOND < row[0] < begun and duty(row) > 0]
            self.assertEqual(lit, [])


if __name__ == "__main__":
    if missing := reason_to_skip():
        print(f"skipped: {missing}")
        sys.exit(77)
    UmlCanTest.examples = pathlib.Path(sys.argv.pop(3)).resolve()
    UmlCanTest.port_tests = pathlib.Path(sys.argv.pop(2)).resolve()
    UmlCanTest.program = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
