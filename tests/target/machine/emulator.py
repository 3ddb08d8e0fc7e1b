"""Runs an image in the emulator with the plug-in, and reads its output."""

import collections
import dataclasses
import pathlib
import subprocess
import tempfile

EMULATOR = "qemu-system-arm"
POWER_CUT, STOPPED = 90, 91


@dataclasses.dataclass
class Outcome:
    """Result of a run: `said` holds the image's lines by their first word, `trace` (ns, source,
    rest)."""
    status: int
    text: str
    output: bytes
    trace: list

    @property
    def said(self) -> dict:
        words = collections.defaultdict(list)
        for line in self.text.splitlines():
            name, *values = line.split(" ")
            if values and all(value.isdigit() for value in values):
                words[name].append([int(value) for value in values])
        return words

    def events(self, source: str, beginning: str = "") -> list:
        """Returns (ns, rest) of a source's events."""
        return [(ns, rest) for ns, who, rest in self.trace
                if who == source and rest.startswith(beginning)]


class Emulator:
    """Runs the emulator on the files under test. It has no other state."""
    plugin = image = ""
    shift = 2  # 4 ns an instruction.
    longest_ns = 2_000_000_000  # Of virtual time: an image that hangs ends, too.

    @staticmethod
    def version() -> str:
        first = subprocess.run([EMULATOR, "--version"], capture_output=True, text=True, check=True)
        return first.stdout.split("version ")[1].split()[0]

    @classmethod
    def run(cls, scenario: str, *options: str, machine: str = "netduinoplus2",
            extra: tuple = (), stdin: bytes = b"") -> Outcome:
        with tempfile.TemporaryDirectory() as folder:
            trace = pathlib.Path(folder, "trace")
            command = [
                EMULATOR, "-M", machine, "-display", "none", "-monitor", "none", "-serial", "none",
                "-icount", f"shift={cls.shift},sleep=off", *extra, "-semihosting-config",
                f"enable=on,target=native,arg=probe,arg={scenario}", "-kernel", cls.image,
                "-plugin", ",".join([cls.plugin, f"trace={trace}",
                                     f"stop_ns={cls.longest_ns}", *options])]
            done = subprocess.run(command, input=stdin, capture_output=True, timeout=60, check=False)
            text = done.stderr.decode()
            lines = trace.read_text().splitlines() if trace.exists() else []
        split = (line.split(" ", 2) for line in lines)
        return Outcome(done.returncode, text, done.stdout,
                       [(int(ns), source, rest) for ns, source, rest in split])


class Files:
    """Files for the plug-in's options, which exist during a test."""

    def __init__(self, test):
        folder = tempfile.TemporaryDirectory()
        test.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def __call__(self, name: str, content=None) -> pathlib.Path:
        path = self.folder / name
        if content is not None:
            path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path
