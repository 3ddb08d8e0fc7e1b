"""Runs the commands of the steps, and holds their results."""
import dataclasses
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass
class Outcome:
    """Number of passed tests, names of the failed tests, and seconds by test."""
    passed: int = 0
    failed: list = dataclasses.field(default_factory=list)
    seconds: dict = dataclasses.field(default_factory=dict)

    @classmethod
    def of(cls, name: str, good: bool) -> "Outcome":
        """Returns the outcome of a step that is a single test."""
        return cls(passed=1) if good else cls(failed=[name])

    def __add__(self, other: "Outcome") -> "Outcome":
        return Outcome(self.passed + other.passed, self.failed + other.failed,
                       self.seconds | other.seconds)


def run(*command: str, quiet: bool = False, log: pathlib.Path | None = None,
        seconds: float | None = None) -> bool:
    """Runs a command at the root of the tree. Returns whether it ended well and within `seconds`,
    if given.

    `quiet` and `log` show the output only after a failure; `log` receives it in any case. `seconds`
    limits commands without either of them.
    """
    print("+", *command, flush=True)
    if quiet or log:
        done = subprocess.run(command, cwd=ROOT, check=False, text=True, errors="replace",
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if log:
            log.write_text(done.stdout)
        if done.returncode or not (quiet or log):
            sys.stdout.write(done.stdout)
            sys.stdout.flush()
        return done.returncode == 0
    try:
        return subprocess.run(command, cwd=ROOT, check=False, timeout=seconds).returncode == 0
    except subprocess.TimeoutExpired:
        print(f"{command[0]} was ended after {seconds:g} s", flush=True)
        return False


def output_of(*command: str) -> str:
    """Returns standard output without its last line end. Raises CalledProcessError."""
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True,
                          text=True).stdout.rstrip("\n")
