"""Shared by the tests of files: the call of each command, and a folder with its files.

The table COMMANDS contains the call of each command. The options are read from `--help`, so
that a new command, or a new option with a file, must be added here.
"""

import ctypes
import dataclasses
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import name_of, share_of  # noqa: E402

KERFLINE = [""]  # The program, as the tests are told.
# Leaks of the libraries behind --png; only a sanitized build reads this file.
SUPPRESSIONS = pathlib.Path(__file__).with_name("leaks.supp")
ENVIRONMENT = {"PATH": "/usr/bin:/bin", "LSAN_OPTIONS": f"suppressions={SUPPRESSIONS}"}
SEED = random.SystemRandom().randrange(1 << 32)

PROGRAM = "G21 G90\nM4 S500\nG1 X5 F1000\nG2 X10 I2.5\nM5\n"
PLATE = ('<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="40mm" viewBox="0 0 40 40">'
         '<rect id="part" x="5" y="5" width="30" height="20"/></svg>')
AROUND = PLATE.replace('x="5" y="5" width="30" height="20"', 'x="-5" y="25" width="20" height="20"')
CUTS = ("material,laser,gas_pressure_mpa,thickness_mm,power_w,speed_mm_min,kerf_top_mm,kerf_bottom_mm,"
        "dross_area_mm2,straightness_mm\n" +
        "".join(f"tin,a laser,0.1,1,{power},{speed},{0.4 + power / speed:.3f},0.4,0.1,0.001\n"
                for power in (40, 60) for speed in (400, 500, 600)))
TOOLS = "flat: diameter=6, feed=600\n"
GRID = "0 0 -3\n9 0 -3\n\n0 9 -3\n9 9 -3\n"
TETRAHEDRON = "solid t\n" + "".join(
    "facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {corner}\n" for corner in facet) + "endloop\nendfacet\n"
    for facet in (("0 0 0", "0 9 0", "9 0 0"), ("0 0 0", "9 0 0", "0 0 9"), ("0 0 0", "0 0 9", "0 9 0"),
                  ("9 0 0", "0 9 0", "0 0 9"))) + "endsolid t\n"
PASSES = ('{"passes": [{"power_w": 10, "feed_mm_min": 900, "depth_mm": 2},'
          ' {"power_w": 10, "feed_mm_min": 300, "depth_mm": 3}]}')
PROBED = ("(kerfline probe-grid 1)\n(x=0:9 columns=2)\n(y=0:9 rows=2)\n(depth=-5 touches=1 tip=2)\n"
          "M5\nM2\n")
ANSWERS = "<Idle|WCO:0,0,0>\n[PRB:0,0,-1:1]\n[PRB:9,0,-1:1]\n[PRB:9,9,-1:1]\n[PRB:0,9,-1:1]\n"
TIPS = "G43.4\n" + "G1 X1 A9 F60\nG1 X0 A0\n" * 9
TALK = "kerfline conversation 1\nprobe_plate -10\nend 1000000\n"


PROBLEM = ("NAME: four\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n"
           "1 0 0\n2 30 40\n3 30 0\n4 0 40\nEOF\n")


@dataclasses.dataclass
class Command:
    """A command. `call`: its arguments other than files; `inputs`: contents by option; `updates`:
    contents of the files that are read and rewritten.
    """
    call: tuple
    inputs: dict
    outputs: tuple = ()
    kept: dict = dataclasses.field(default_factory=dict)
    takes_stdin: bool = False
    updates: dict = dataclasses.field(default_factory=dict)
    empty_is_refused: tuple = ()  # Inputs, besides standard input, that must not be empty.


LIBRARY = ('<LightBurnLibrary><Material name="tin"><Entry><CutSetting type="Cut">'
           '<maxPower Value="9"/><speed Value="9"/></CutSetting></Entry></Material></LightBurnLibrary>')
STEEL = ("--material", "CSP 1N")
SETTINGS = "$110=1000\n"
RECIPE = '{"kerfline_recipe": 1, "tabs": 1}'
POST = "[format]\nblanks = yes\n"
# A BMP with a black and a white pixel. Texts of files are written as UTF-8, and these bytes are
# valid UTF-8.
PICTURE = ("BM" + "\0" * 8 + "\x36\0\0\0\x28\0\0\0\x02\0\0\0\x01\0\0\0\x01\0\x18\0" + "\0" * 24 +
           "\0\0\0\x7f\x7f\x7f\0\0")
COUPON = (*STEEL, "--thickness", "2", "--full-power", "2000", "--laser", "a")
COMMANDS = {
    "sim": Command(("--stock", "-1,-1,12,6,1", "--tool", "2", "--stock-cell", "0.5", "--stock-depth", "1"),
                   {"FILE": PROGRAM, "--settings": SETTINGS, "--stock-target": PLATE,
                    "--probe-surface": GRID},
                   ("--trace", "--vcd", "--report", "--svg", "--png", "--stock-png", "--stock-stl",
                    "--stock-ply", "--answers", "--knots"), takes_stdin=True,
                   empty_is_refused=("FILE", "--settings", "--probe-surface")),
    "check": Command((), {"FILE": PROGRAM, "--settings": SETTINGS, "--probe-surface": GRID}, takes_stdin=True,
                     empty_is_refused=("FILE", "--settings", "--probe-surface")),
    "serve": Command(("--tcp", "0"), {"--settings": SETTINGS, "--probe-surface": GRID}, ("--record", "--trace"),
                     {"--store": None, "--pty": None, "--slcan": None},
                     empty_is_refused=("--settings", "--probe-surface")),
    "replay": Command((), {"FILE": TALK}, takes_stdin=True, empty_is_refused=("FILE",)),
    "kerf add": Command((), {"CUTS.csv": CUTS}, (), {"--db": None}, takes_stdin=True,
                        empty_is_refused=("CUTS.csv",)),
    "kerf import": Command((), {"FILE.clb": LIBRARY}, (), {"--db": None}, takes_stdin=True,
                           empty_is_refused=("FILE.clb",)),
    "kerf test-grid": Command(("--material", "tin", "--thickness", "1", "--power", "20", "--feed", "300"),
                              {"--post": POST}, ("--out", "--form")),
    "kerf fit": Command(("--material", "tin"), {}, (), {"--db": CUTS}),
    "kerf show": Command(("--material", "tin", "--cuts"), {}, (), {"--db": CUTS}),
    "kerf advise": Command((*STEEL, "--thickness", "2"), {}, (), {"--db": CUTS}),
    "kerf plot": Command(STEEL, {}, ("--svg", "--png"), {"--db": CUTS}),
    "kerf calibrate": Command(COUPON, {}, ("--out",), {"--db": CUTS}),
    "kerf image": Command(STEEL, {}, ("--out",), {"--db": CUTS}),
    "offset": Command(("--distance", "1"), {"FILE": PLATE}, ("--output", "--svg", "--dxf"),
                      takes_stdin=True),
    "drawing": Command((), {"FILE": PLATE}, ("--svg",), takes_stdin=True),
    "cut": Command((*STEEL, "--thickness", "2"),
                   {"DRAWING": PLATE, "--layers": ": tabs=2\n", "--rules": "outer: tabs=3\n",
                    "--settings": SETTINGS, "--post": POST, "--recipe": RECIPE},
                   ("--output", "--svg", "--png", "--animation", "--job-sheet", "--report",
                    "--save-sheet", "--frame", "--save-recipe"),
                   {"--db": CUTS}, takes_stdin=True,
                   empty_is_refused=("--layers", "--rules", "--settings", "--recipe")),
    "engrave": Command(("--width", "20", "--power", "50%", "--feed", "3000", "--plain"),
                       {"IMAGE": PICTURE, "--settings": SETTINGS, "--post": POST},
                       ("--output", "--report", "--picture"), takes_stdin=True,
                       empty_is_refused=("IMAGE", "--settings")),
    "order": Command(("--steps", "10"), {"FILE": PROBLEM}, takes_stdin=True),
    "pocket": Command(("--tool", "6", "--depth", "2", "--feed", "600", "--plunge-feed", "200", "--entry", "plunge"),
                      {"FILE": PLATE, "--tools": TOOLS, "--post": POST},
                      ("--output", "--report", "--svg", "--holes"),
                      takes_stdin=True, empty_is_refused=("--tools",)),
    "surface": Command(("--tool", "ball:4", "--feed", "600", "--plunge-feed", "200", "--step", "3"),
                       {"FILE": GRID, "--boundary": AROUND, "--post": POST},
                       ("--output", "--report", "--mesh", "--patches"),
                       takes_stdin=True, empty_is_refused=("--boundary",)),
    "surface probe-grid": Command((), {"--read": ANSWERS, "--program": PROBED}, ("--output",),
                                  empty_is_refused=("--read", "--program")),
    "wall": Command(("--half-angle", "7"), {"FILE": TETRAHEDRON, "--at": "1 1 -2\n" * 9}, ("--output",),
                    takes_stdin=True, empty_is_refused=("--at",)),
    "wall carve": Command(("--half-angle", "7", "--cell", "0.5"),
                          {"FILE": TETRAHEDRON, "--beams": "1 1 -2 0 0 1\n" * 9, "--beside": "1 1 -1 0 0 1\n" * 9},
                          ("--output", "--carved"), takes_stdin=True,
                          empty_is_refused=("--beams", "--beside")),
    "wall taper": Command(("--half-angle", "7"), {"CUTS": "0 13\n" * 9}, takes_stdin=True,
                          empty_is_refused=("CUTS",)),
    "wall joints": Command(("--set", "$900=1"), {"FILE": TIPS, "--settings": "$901=0\n" * 9}, ("--output",),
                           takes_stdin=True, empty_is_refused=("FILE", "--settings")),
    "send": Command((), {"file": PROGRAM}, ("--log",), takes_stdin=True, empty_is_refused=("file",)),
}
# Further calls of a command, for options that exclude or require others.
FORM = Command((*COUPON, "--out", "/dev/null"), {}, ("--form",))
HEIGHTS = Command(("--tool", "ball:4"), {"FILE": GRID, "--at": "1 2\n" * 9}, ("--heights",), takes_stdin=True,
                  empty_is_refused=("--at",))
CONES = Command((), {"--cones": "0 0 0 0 0 1 0.9 5 1 0 1 0 1 1 0 0 3\n" * 9}, ("--output",),
                empty_is_refused=("--cones",))
LAYERED = Command(("--half-angle", "7", "--power", "10", "--feed", "600"), {"FILE": TETRAHEDRON, "--record": PASSES},
                  ("--output", "--beams", "--report"), takes_stdin=True, empty_is_refused=("--record",))
PICTURED = Command((*COMMANDS["surface"].call, "--picture-cell", "0.5"), {"FILE": GRID},
                   ("--picture-data", "--picture-offset", "--picture-patches", "--picture-paths",
                    "--picture-carved", "--picture-map"), takes_stdin=True)
COMPARED = Command(("--stock", "-1,-1,12,6,1", "--tool", "2", "--stock-cell", "0.5"),
                   {"FILE": PROGRAM, "--stock-surface": GRID}, ("--stock-map",), takes_stdin=True,
                   empty_is_refused=("FILE", "--stock-surface"))
SECTIONED = Command(("--half-angle", "7", "--cell", "0.5", "--section", "0,1,3,1"),
                    {"FILE": TETRAHEDRON, "--beams": "1 1 -2 0 0 1\n" * 9}, ("--picture-section",), takes_stdin=True,
                    empty_is_refused=("--beams",))
MEASURED = Command((), {"--measured": CUTS}, (), {"--db": None}, takes_stdin=True,
                   empty_is_refused=("--measured",))
FILLED_FORM = ('{"kerfline_test_grid": 1, "material": "tin", "kind": "fill", "measured_by": "Ada",'
               ' "measured_on": "2026-11-30", "squares": [{"power_percent": 20, "feed_mm_min": 300,'
               ' "result": "good"}]}')
READ_GRID = Command((), {"--measured": FILLED_FORM}, (), {"--db": None}, takes_stdin=True,
                    empty_is_refused=("--measured",))
UPDATE = Command(("--update",), {}, updates={"FILE": TALK}, empty_is_refused=("FILE",))
CALLS = [*COMMANDS.items(), ("kerf calibrate", FORM), ("kerf calibrate", MEASURED),
         ("kerf test-grid", READ_GRID), ("replay", UPDATE),
         ("surface", HEIGHTS), ("surface", PICTURED), ("sim", COMPARED), ("wall", CONES), ("wall", LAYERED),
         ("wall carve", SECTIONED)]
CALLS_IN_TEST = 4  # Of CALLS; as many as each of the long tests tries in toolchain/test.sh.
# Files of surfaces, which may be binary. Their reader reports a text in another encoding.
SURFACES = {"--probe-surface", "--stock-surface", "surface FILE", "wall FILE", "wall carve FILE"}
NO_FILES = {"completion", "manual", "kerf", ""}
# Devices: the tests of ports check how they are opened.
DEVICES = {("send", "--port"), ("send", "--slcan")}


def some_calls(test):
    """Returns the calls that one of the long tests runs."""
    return share_of(CALLS, CALLS_IN_TEST, name_of(test))


def help_of(words):
    return subprocess.run([KERFLINE[0], *words, "--help"], capture_output=True, text=True, check=True,
                          env=ENVIRONMENT).stdout


def file_options_in(text):
    """Returns the options whose value is a file, and the positionals that are not limited to a set
    of words.
    """
    found = set()
    for line in text.splitlines():
        if match := re.match(r" {2,4}(?:-\w,)?(--[\w-]+) (FILE|LINK|DEVICE)\b", line):
            found.add(match[1])
    _, _, positionals = text.partition("\nPositionals:\n")
    for line in positionals.split("\n\n")[0].splitlines():
        if (match := re.match(r"  ([\w.]+) (?!.*\{)", line)):
            found.add(match[1])
    return found


def commands_in(words=()):
    text = help_of(words)
    yield " ".join(words), text
    _, _, below = text.partition("\nSubcommands:\n")
    for name in re.findall(r"^  ([\w-]+) ", below.split("\n\n")[0], re.MULTILINE):
        yield from commands_in((*words, name))


class Bench:
    """A folder that contains all files of a command."""

    def __init__(self, folder, name, command, mark=""):
        """Creates the files; `mark` becomes a part of each file's name."""
        self.folder, self.name, self.command, self.mark = folder, name, command, mark
        self.files = {}
        for option, content in (*command.inputs.items(), *command.updates.items()):
            self.put(option, content)
        if name == "replay" and command.inputs:  # With what this controller says.
            subprocess.run([KERFLINE[0], "replay", self.files["FILE"], "--update"], check=True,
                           capture_output=True, env=ENVIRONMENT)
        for option in command.outputs:
            self.put(option, "previous\n" * 3)
        for option, content in command.kept.items():
            self.files[option] = self.path(option)
            if content is not None:
                add = [KERFLINE[0], "kerf", "add", "-", "--db", self.path(option)]
                subprocess.run(add, input=content, text=True, check=True, capture_output=True, env=ENVIRONMENT)
                fit = [KERFLINE[0], "kerf", "fit", "--material", "tin", "--db", self.path(option)]
                subprocess.run(fit, check=True, capture_output=True, env=ENVIRONMENT)

    def needed(self, *more):
        """Returns the required files without outputs and without those that a server creates, and
        with `more`.
        """
        made = {"--store", "--pty", "--slcan"}
        return {option: file for option, file in self.files.items()
                if option in more or option not in made.union(self.command.outputs)}

    def path(self, option):
        end = "svg" if option.startswith("--picture-") or option == "--stock-map" else "txt"
        return self.folder / f"file_of{option.replace('.', '_')}{self.mark}.{end}"

    def put(self, option, content):
        self.files[option] = self.path(option)
        self.files[option].write_text(content)

    def words(self, files):
        positionals = [str(file) for option, file in files.items() if not option.startswith("-")]
        named = [word for option, file in files.items() if option.startswith("-") for word in (option, str(file))]
        return [*self.name.split(), *positionals, *self.command.call, *named]

    def contents(self):
        """Returns the contents of every file in the folder; links are followed."""
        return {path.name: os.readlink(path) if path.is_symlink() else path.read_bytes()
                for path in self.folder.iterdir() if path.is_symlink() or path.is_file()}

    def start(self, files, **more):
        words = self.words(files)
        if self.name == "send":
            words += ["--tcp", f"127.0.0.1:{Server.port}"]
        options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE,
                   "env": ENVIRONMENT, "cwd": self.folder, **more}
        return subprocess.Popen([KERFLINE[0], *words], **options)

    def run(self, files=None, stop_when_ready=True, **more):
        """Returns (status, standard output, standard error). A server is stopped when it is ready."""
        process = self.start(self.files if files is None else files, **more)
        out = b""
        if self.name == "serve" and stop_when_ready and process.stdout:
            for line in process.stdout:
                out += line
                if line == b"ready\n":
                    process.send_signal(signal.SIGTERM)
        rest, err = process.communicate(timeout=60)
        return process.returncode, (out + (rest or b"")).decode("utf-8", "replace"), (err or b"").decode()


class Server:
    """A simulated machine to which `send` can send."""
    port, process = 0, None

    @classmethod
    def start(cls):
        cls.process = subprocess.Popen([KERFLINE[0], "serve", "--tcp", "0", "--speed", "50"], text=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=ENVIRONMENT)
        cls.port = int(cls.process.stdout.readline().rsplit(":", 1)[1])

    @classmethod
    def stop(cls):
        cls.process.terminate()
        cls.process.communicate(timeout=20)


def limit_files(size):
    """For preexec_fn: makes writing beyond `size` bytes of a file fail, as on a full disk."""
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


def obey_modes():
    """For preexec_fn: makes files without read permission unreadable for root, too."""
    drop_capability = 24
    overrides = (1, 2)  # Of permissions, and of those to read and search.
    if os.geteuid() == 0:
        for capability in overrides:
            ctypes.CDLL(None).prctl(drop_capability, capability, 0, 0, 0)
