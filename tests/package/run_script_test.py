"""Tests toolchain/run.sh with the built program: its arguments, its files and its output.

usage: run_script_test.py KERFLINE

The script is copied into a folder whose preset `run` copies the program instead of compiling it.
The test senders.readme proves that a clone compiles.
"""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
KERFLINE = pathlib.Path(sys.argv[1])

PROJECT = f"""cmake_minimum_required(VERSION 3.25)
project(kerfline LANGUAGES NONE)
add_custom_target(kerfline ALL COMMAND ${{CMAKE_COMMAND}} -E copy {KERFLINE} ${{PROJECT_BINARY_DIR}}/host-sim/kerfline)
"""
PRESETS = {"version": 6,
           "configurePresets": [{"name": "run", "generator": "Ninja", "binaryDir": "${sourceDir}/build/run"}],
           "buildPresets": [{"name": "run", "configurePreset": "run"}]}


class RunScript(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "CMakeLists.txt").write_text(PROJECT)
        (self.folder / "CMakePresets.json").write_text(json.dumps(PRESETS))
        self.make_examples()
        (self.folder / "toolchain").mkdir()
        for name in ("run.sh", "setup.sh", "packages.txt"):
            shutil.copy(ROOT / "toolchain" / name, self.folder / "toolchain")

    def make_examples(self):
        examples = self.folder / "host-sim/examples"
        examples.mkdir(parents=True)
        for name in ("circle_r20.nc", "laser.settings", "mill.settings"):
            shutil.copy(ROOT / "host-sim/examples" / name, examples)

    def run_script(self, *arguments):
        return subprocess.run([self.folder / "toolchain/run.sh", *arguments], cwd="/",
                              capture_output=True, text=True, check=False)

    def written(self):
        return {path.name for path in (self.folder / "out").glob("*")}

    def test_writes_picture_and_report(self):
        done = self.run_script("circle_r20")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.written(), {"circle_r20.png", "circle_r20.svg", "circle_r20.report.json"})
        self.assertIn("[1/1] circle_r20\n", done.stdout)
        self.assertRegex(done.stdout, r"circle_r20: done after \d+ s\n")

    def test_ends_with_what_to_open_and_to_try(self):
        *_, end = self.run_script("circle_r20").stdout.partition("Written to out/")
        self.assertRegex(end, r"\nOpen +out/circle_r20\.png ")
        self.assertIn("serve --ws 8080", end)
        self.assertIn("--traces circle_r20", end)

    def test_writes_traces_on_request(self):
        done = self.run_script("host-sim/examples/circle_r20.nc", "--traces")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("circle_r20.trace.csv", self.written())

    def test_says_how_far_it_is_without_a_terminal(self):
        lines = (f"G1 X{x % 7} Y{x % 11} F6000 S500\n" for x in range(500_000))  # It takes minutes.
        (self.folder / "host-sim/examples/long.nc").write_text("G21 G90 M4\n" + "".join(lines))
        with subprocess.Popen([self.folder / "toolchain/run.sh", "long"], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, start_new_session=True) as script:
            end = threading.Timer(60, os.killpg, (script.pid, signal.SIGTERM))
            end.start()
            told = script.stderr.readline()
            end.cancel()
            if script.poll() is None:
                os.killpg(script.pid, signal.SIGTERM)
        self.assertRegex(told, r"^host-sim/examples/long\.nc: \d+ % after \d+ s\n$")

    def test_refuses_what_it_does_not_know_at_once(self):
        for argument, remedy in (("--trace", "usage: "), ("bracelet", "the examples are: circle_r20\n"),
                                 (str(KERFLINE), f"kerfline sim '{KERFLINE}'")):
            done = self.run_script("circle_r20", argument)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(argument, done.stderr.split("\n")[0])
            self.assertIn(remedy, done.stderr)
        self.assertFalse((self.folder / "build").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
