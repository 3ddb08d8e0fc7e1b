"""Plants failures in runs of toolchain/proof and checks that each makes the run fail and is named."""
import contextlib
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

from source_files import ROOT

sys.path.insert(0, str(ROOT / "toolchain/proof"))
import ctest_run  # noqa: E402
import memory  # noqa: E402
import run  # noqa: E402
import shell  # noqa: E402
import steps  # noqa: E402

REPORT = """<?xml version="1.0"?><testsuite>
<testcase name="good" time="0.5" status="run"/>
<testcase name="host-sim.uml_can" time="0.1" status="notrun"><system-out>no kernel</system-out></testcase>
{}</testsuite>
"""


def good(_tier: str) -> shell.Outcome:
    return shell.Outcome.of("good", True)


def bad(_tier: str) -> shell.Outcome:
    return shell.Outcome.of("bad", False)


class Commands(unittest.TestCase):
    def test_a_program_that_hangs_is_ended_and_has_failed(self):
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertFalse(shell.run("sleep", "600", seconds=0.2))
            self.assertFalse(shell.run("false", seconds=60))
            self.assertTrue(shell.run("true", seconds=60))


class Reports(unittest.TestCase):
    def outcome(self, more="", without="uml"):
        with tempfile.TemporaryDirectory() as folder, \
                mock.patch.dict(os.environ, {"KERFLINE_WITHOUT": without}), \
                contextlib.redirect_stdout(io.StringIO()):
            report = pathlib.Path(folder) / "ctest.xml"
            report.write_text(REPORT.format(more))
            return ctest_run.outcome_of(report, "release")

    def test_what_may_be_missing_is_neither_passed_nor_failed(self):
        outcome = self.outcome()
        self.assertEqual((1, []), (outcome.passed, outcome.failed))

    def test_a_skip_is_a_failure_with_its_reason(self):
        outcome = self.outcome(without="")
        self.assertEqual(["release: host-sim.uml_can (did not run: no kernel)"], outcome.failed)
        self.assertEqual(1, outcome.passed)

    def test_a_failure_and_a_disabled_test_are_failures(self):
        outcome = self.outcome('<testcase name="bad" status="fail"/>'
                               '<testcase name="off" status="disabled"/>')
        self.assertEqual(["release: bad", "release: off (did not run: disabled)"], outcome.failed)

    def test_an_unknown_gate_cannot_be_left_out(self):
        with self.assertRaisesRegex(SystemExit, "known are"):
            self.outcome(without="emulator")


class Selection(unittest.TestCase):
    def test_prove_leaves_out_what_it_has_a_larger_test_of(self):
        told = {"tests": [{"name": name, "command": ["true", name],
                           "properties": [{"name": "LABELS", "value": labels}]}
                          for name, labels in (("all", ["prove"]), ("changed", ["tidy", "test"]), ("both", []))]}
        with mock.patch.object(ctest_run, "output_of", lambda *_: json.dumps(told)), \
                mock.patch.object(ctest_run, "TestMemory") as forgets:
            forgets.return_value.notes.find.return_value = None
            self.assertEqual([1, 3], ctest_run.Remembered("release").to_run())


class Runs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for module in (memory, run, shell):
            patch = mock.patch.object(module, "ROOT", self.root)
            patch.start()
            self.addCleanup(patch.stop)
        patch = mock.patch.object(memory, "PROVEN", self.root / "tests/proven")
        patch.start()
        self.addCleanup(patch.stop)
        memory.tree_key.cache_clear()
        (self.root / "tests").mkdir()
        (self.root / ".gitignore").write_text("build\n")
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-qm", "begin")

    def git(self, *words) -> str:
        return subprocess.run(["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b",
                               *words], check=True, capture_output=True, text=True).stdout.strip()

    def run_tier(self, tier, *chosen) -> tuple:
        """Runs a tier; returns (exit status, output)."""
        output = io.StringIO()
        with mock.patch.object(steps, "STEPS", chosen), contextlib.redirect_stdout(output), \
                mock.patch.object(steps, "environment", lambda: None), \
                mock.patch.object(sys, "argv", ["run.py", tier]):
            status = run.main()
        return status, output.getvalue()

    def test_a_run_ends_with_its_numbers(self):
        status, output = self.run_tier("test", steps.Step("one", good))
        self.assertTrue(output.endswith("1 passed, 0 failed\n"), output)
        self.assertEqual(0, status)

    def test_a_failed_step_fails_the_run_and_those_that_need_it(self):
        status, output = self.run_tier("test", steps.Step("one", bad),
                                       steps.Step("two", good, needs=("one",)),
                                       steps.Step("three", good))
        self.assertIn("failed: bad\n", output)
        self.assertIn("failed: two: did not run, needs one\n", output)
        self.assertTrue(output.endswith("1 passed, 2 failed\n"), output)
        self.assertEqual(1, status)

    def test_nothing_tested_is_a_failure(self):
        status, _ = self.run_tier("test", steps.Step("one", lambda tier: shell.Outcome()))
        self.assertEqual(1, status)

    def test_a_step_of_the_other_tier_does_not_run(self):
        status, _ = self.run_tier("test", steps.Step("one", good),
                                  steps.Step("two", bad, (steps.PROVE,)))
        self.assertEqual(0, status)

    def test_prove_goes_on_where_it_failed_and_names_the_commit(self):
        counts = {"one": 0}

        def counted(_tier: str) -> shell.Outcome:
            counts["one"] += 1
            return shell.Outcome.of("one", True)

        first = steps.Step("one", counted)
        self.assertEqual(1, self.run_tier("prove", first, steps.Step("two", bad))[0])
        self.assertFalse(memory.PROVEN.exists())
        status, output = self.run_tier("prove", first, steps.Step("two", good))
        self.assertEqual((0, 1), (status, counts["one"]))
        self.assertIn("passed before", output)
        self.assertEqual(self.git("rev-parse", "HEAD"), memory.proven_commit())

    def change(self, file: str) -> None:
        (self.root / file).parent.mkdir(parents=True, exist_ok=True)
        (self.root / file).write_text(f"{file} of {self.git('rev-parse', 'HEAD')}")
        self.git("add", ".")
        self.git("commit", "-qm", file)
        memory.tree_key.cache_clear()

    def test_a_step_stays_passed_when_rooms_change_on_which_it_does_not_depend(self):
        step = steps.Step("one", good, without=memory.ALL_ROOMS)
        other = steps.Step("two", bad)
        self.run_tier("prove", step, other)
        self.change("tests/planner/a.cpp")
        self.assertIn("passed before", self.run_tier("prove", step, other)[1])
        self.change("planner/a.cpp")
        self.assertNotIn("passed before", self.run_tier("prove", step, other)[1])

    def test_a_test_is_run_again_when_what_it_is_made_of_changes(self):
        commands = {"Path.Is": "build/planner_tests", "Line.Is": "build/firmware_tests",
                    "Trace.Is": "build/host_sim_tests", "host-sim.send": "send_test.py",
                    "tidy.all": "tidy.py", "simulation.digests": "/x/tests/simulation/digests.py"}

        def keys() -> dict:
            return {name: memory.TestMemory.key_of(name, ["python3", program, "--all"])
                    for name, program in commands.items()}

        def changed_by(file: str) -> set:
            before = keys()
            self.change(file)
            after = keys()
            return {name for name in commands if after[name] != before[name]}

        memory.tree_key.cache_clear()
        self.assertEqual({"Path.Is", "Line.Is", "tidy.all"}, changed_by("tests/planner/a.cpp"))
        self.assertEqual({"Line.Is", "tidy.all"}, changed_by("tests/firmware/a.cpp"))
        self.assertEqual({"simulation.digests", "tidy.all"},
                         changed_by("tests/simulation/digests.txt"))
        self.assertEqual(set(commands), changed_by("tests/host-sim/a.cpp"))
        self.assertEqual(set(commands), changed_by("planner/a.cpp"))

    def test_ctest_is_told_the_numbers_of_tests_that_have_not_passed(self):
        told = json.dumps({"tests": [{"name": name, "command": ["x"]} for name in "abc"]})
        (self.root / "build/release").mkdir(parents=True)
        memory.tree_key.cache_clear()
        with mock.patch.object(ctest_run, "output_of", lambda *_: told), \
                mock.patch.object(ctest_run, "ROOT", self.root):
            first = ctest_run.Remembered("release")
            self.assertEqual([1, 2, 3], first.to_run())
            report = self.root / "report.xml"
            report.write_text('<testsuite><testcase name="b" status="run"><system-out>seeds of base'
                              " 'x'</system-out></testcase><testcase name=\"c\" status=\"fail\"/>"
                              "</testsuite>")
            first.note(report)
            again = ctest_run.Remembered("release")
            self.assertEqual([1, 3], again.to_run())
            self.assertTrue(again.memory.notes.notes["b"]["random"])
            again.selection([1, 3])
            self.assertEqual("0,0,0,1,3", again.list.read_text())

    def test_tests_stay_passed_when_the_run_is_interrupted(self):
        told = json.dumps({"tests": [{"name": name, "command": ["x"]} for name in "abc"]})
        (self.root / "build/release").mkdir(parents=True)
        memory.tree_key.cache_clear()
        report = self.root / "report.xml"

        def some(_preset, _environment, _selection):
            if report.is_file():
                raise KeyboardInterrupt
            report.write_text('<testsuite><testcase name="a" status="run"/>'
                              '<testcase name="b" status="run"/></testsuite>')
            return ctest_run.Some(ctest_run.Outcome(passed=2), report)

        with mock.patch.object(ctest_run, "output_of", lambda *_: told), \
                mock.patch.object(ctest_run, "ROOT", self.root), \
                mock.patch.object(ctest_run, "REMEMBERED_TESTS", 2), \
                mock.patch.object(ctest_run, "run_some", some), \
                contextlib.redirect_stdout(io.StringIO()):
            with self.assertRaises(KeyboardInterrupt):
                ctest_run.run_tests("release", "prove")
            self.assertEqual([3], ctest_run.Remembered("release").to_run())

    def test_another_tree_is_proven_from_the_start(self):
        self.run_tier("prove", steps.Step("one", good))
        (self.root / "new").write_text("new")
        memory.tree_key.cache_clear()
        self.assertEqual(1, self.run_tier("prove", steps.Step("one", bad))[0])

    def test_a_tree_that_is_not_that_of_a_commit_is_not_proven(self):
        (self.root / "new").write_text("new")
        memory.tree_key.cache_clear()
        status, output = self.run_tier("prove", steps.Step("one", good))
        self.assertEqual(0, status)
        self.assertIn("tests/proven is not written", output)
        self.assertFalse(memory.PROVEN.exists())


if __name__ == "__main__":
    unittest.main()
