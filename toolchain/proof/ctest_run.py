"""Runs ctest and reads its JUnit report. A skipped test counts as failed."""
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import xml.etree.ElementTree as ElementTree

from memory import TestMemory
from shell import ROOT, Outcome, output_of

# Tests that may be missing on a machine, by the name in KERFLINE_WITHOUT; the README explains when.
MAY_BE_MISSING = {"uml": ("host-sim.uml_can",)}
PROGRESS_TESTS = 200  # A line is printed after so many tests.
REMEMBERED_TESTS = 800  # `prove` notes which have passed after so many tests.


def allowed_to_skip() -> set:
    names = os.environ.get("KERFLINE_WITHOUT", "").split()
    unknown = [name for name in names if name not in MAY_BE_MISSING]
    if unknown:
        raise SystemExit(f"KERFLINE_WITHOUT names {unknown}; known are {sorted(MAY_BE_MISSING)}")
    return {test for name in names for test in MAY_BE_MISSING[name]}


MARK = "base '"  # Printed by each test that draws random numbers, before the base of its seeds.


OF_TEST_ALONE = "test"  # Label of what `prove` has a larger test of.


def labels_of(test: dict) -> list:
    return next((prop["value"] for prop in test.get("properties", []) if prop["name"] == "LABELS"), [])


class Remembered:
    """The tests of a preset that `prove` leaves out: they passed before, and their files are
    unchanged."""

    def __init__(self, preset: str):
        self.memory = TestMemory(preset)
        told = json.loads(output_of("ctest", "--preset", preset, "--show-only=json-v1"))
        self.keys = {test["name"]: self.memory.key_of(test["name"], test.get("command", []))
                     for test in told["tests"]}
        self.left_out = {test["name"] for test in told["tests"] if OF_TEST_ALONE in labels_of(test)}
        self.list = ROOT / "build" / preset / "to_run.txt"

    def to_run(self) -> list:
        """Returns the numbers, from 1, of the tests that have to run."""
        return [number for number, (name, key) in enumerate(self.keys.items(), 1)
                if name not in self.left_out and not self.memory.notes.find(name, key)]

    def selection(self, numbers: list) -> list:
        """Returns the arguments with which ctest runs only the tests with these numbers."""
        self.list.write_text(",".join(map(str, (0, 0, 0, *numbers))), encoding="utf-8")
        return ["-I", str(self.list)]

    def note(self, report) -> None:
        for case in ElementTree.parse(report).getroot().iter("testcase"):
            name = case.get("name")
            if case.get("status") == "run":
                self.memory.notes.add(name, self.keys[name],
                                      random=MARK in (case.findtext("system-out") or ""))
        self.memory.notes.write()


def run_tests(preset: str, tier: str, most_trials: dict | None = None) -> Outcome:
    """Runs all tests of a preset that belong to the tier. Tests that `prove` remembers count as
    passed.

    `most_trials` bounds the random trials of each test, by tier.
    """
    environment = os.environ | {"KERFLINE_TIER": tier}
    if most_trials and tier in most_trials:
        environment.setdefault("KERFLINE_MOST_TRIALS", str(most_trials[tier]))
    if tier == "test":
        # Programs whose tests all belong to `prove` need not exist in `test`.
        return run_some(preset, environment, ["--label-exclude", "^prove$", "--exclude-regex",
                                              "_NOT_BUILT$"]).outcome
    remembered = Remembered(preset)
    numbers = remembered.to_run()
    before = len(remembered.keys) - len(remembered.left_out) - len(numbers)
    print(f"{before} tests of {preset} have passed before", flush=True)
    outcome = Outcome(passed=before)
    for begin in range(0, len(numbers), REMEMBERED_TESTS):
        some = run_some(preset, environment,
                        remembered.selection(numbers[begin:begin + REMEMBERED_TESTS]))
        outcome += some.outcome
        if some.report:
            remembered.note(some.report)
    return outcome


@dataclasses.dataclass(frozen=True)
class Some:
    """Result of one run of ctest, and its JUnit report, if it wrote one."""
    outcome: Outcome
    report: pathlib.Path | None = None


def run_some(preset: str, environment: dict, selection: list) -> Some:
    """Runs the tests that the arguments select. Repeats the failed tests alone, for the log."""
    report = ROOT / "build" / preset / "ctest.xml"
    report.unlink(missing_ok=True)
    # One process more than there are processors, because many tests wait for a clock or another
    # process. Tests that measure by the clock are RUN_SERIAL.
    follow(["ctest", "--preset", preset, f"-j{os.cpu_count() + 1}", "--output-on-failure",
            "--output-junit", str(report), "--test-output-size-passed", "65536", *selection],
           environment)
    if not report.is_file():
        return Some(Outcome(failed=[f"ctest of {preset} gave no result"]))
    outcome = outcome_of(report, preset)
    if outcome.failed:
        print(f"once more, alone: what failed of {preset}, but for clang-tidy", flush=True)
        # Selects by name: the numbers of --rerun-failed shift when tests are left out.
        subprocess.run(["ctest", "--preset", preset, "--tests-regex", any_of(outcome.failed),
                        "--output-on-failure", "--exclude-regex", r"^tidy\."],
                       cwd=ROOT, env=environment, check=False)
    return Some(outcome, report)


def any_of(failed: list) -> str:
    """Returns the regular expression that matches the failed tests, given as in `Outcome.failed`."""
    names = [name.partition(": ")[2].partition(" ")[0] for name in failed]
    return f"^({'|'.join(re.escape(name) for name in names)})$"


def follow(command: list, environment: dict) -> None:
    """Prints failures as they occur, and sometimes a line of progress."""
    print("+", *command, flush=True)
    with subprocess.Popen(command, cwd=ROOT, env=environment, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
        ended = 0
        for line in process.stdout:
            begins = line.lstrip().startswith("Start ")
            ends = " Test " in line and "sec" in line and "#" in line
            ended += ends
            if ends and line.rstrip().rpartition("sec")[0].find("Passed") >= 0:
                if ended % PROGRESS_TESTS == 0:
                    print(line.rstrip(), flush=True)
            elif not begins:
                print(line, end="", flush=True)


def outcome_of(report, preset: str) -> Outcome:
    """Returns the outcome in a JUnit report of ctest. Skipped, disabled and missing tests count as
    failed."""
    outcome = Outcome()
    may_skip = allowed_to_skip()
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        name, status = case.get("name"), case.get("status")
        outcome.seconds[f"{preset}: {name}"] = float(case.get("time", 0))
        if status == "run":
            outcome.passed += 1
        elif status == "notrun" and name in may_skip:
            print(f"not run, as KERFLINE_WITHOUT says: {name}")
        elif status == "fail":
            outcome.failed.append(f"{preset}: {name}")
        else:
            reason = (case.findtext("system-out") or "").strip().rpartition("\n")[2]
            outcome.failed.append(f"{preset}: {name} (did not run: {reason or status})")
    return outcome
