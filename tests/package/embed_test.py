#!/usr/bin/env python3
"""Builds planner/examples/embed in the three ways in which other projects can use the planner, and
checks its output.

    embed_test.py SOURCE_FOLDER BUILD_FOLDER

The planner of BUILD_FOLDER must be built; it is installed into a temporary folder.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, BUILD = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
STEPS_PER_MM = 80
LINES = ["G1 X10 Y5 F3000", "G2 X20 Y5 I5 J0", "G5 X30 Y0 I3 J3 P-3 Q3", "G0 Z2"]
END_MM = (30, 0, 2)


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


class EmbedExample(unittest.TestCase):
    printed = set()  # By all of them: the same, whoever compiles the planner, and how.

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.installed = cls.folder / "installed"
        run("cmake", "--install", BUILD, "--component", "planner", "--prefix", cls.installed)

    def built(self, name, *options):
        """Builds the example in a separate folder and returns its output."""
        options = [*options, "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0",
                   "-DCMAKE_UNITY_BUILD=ON"]
        if shutil.which("ninja"):
            options.append("-GNinja")
        if shutil.which("ccache"):
            options.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
        run("cmake", "-S", SOURCE / "planner/examples/embed", "-B", self.folder / name, *options)
        run("cmake", "--build", self.folder / name, "--target", "embed",
            "--parallel", os.cpu_count())
        return self.folder / name / "embed"

    def check(self, program):
        text = run(program, *LINES)
        self.printed.add(text)
        self.assertEqual(len(self.printed), 1)
        segments = [line.split() for line in text.splitlines()]
        self.assertGreater(len(segments), 100)
        for axis, end in enumerate(END_MM):
            self.assertEqual(sum(int(segment[1 + axis]) for segment in segments),
                             end * STEPS_PER_MM, "XYZ"[axis])
        seconds = [float(segment[0]) for segment in segments]
        self.assertTrue(all(0 < length <= 0.001 for length in seconds))
        self.assertTrue(0.5 < sum(seconds) < 3.0, sum(seconds))

    def check_refusals(self, program):
        refused = subprocess.run([program, "G1 X1"], capture_output=True, text=True, check=False)
        self.assertEqual(refused.returncode, 1, "no feed")
        self.assertIn("refused", refused.stderr)

    def test_installed(self):
        program = self.built("package", f"-DCMAKE_PREFIX_PATH={self.installed}")
        self.check(program)
        self.check_refusals(program)

    def test_the_planner_alone(self):
        self.check(self.built("planner", "-DKERFLINE_FROM=planner", f"-DKERFLINE={SOURCE}"))

    def test_the_project_fetched(self):
        program = self.built("fetch", "-DKERFLINE_FROM=fetch", f"-DKERFLINE={SOURCE}")
        self.check(program)
        left = [path.name for path in (self.folder / "fetch").rglob("*.a")]
        self.assertEqual(sorted(left), ["libkerfline_contract_handler.a", "libkerfline_planner.a"],
                         "the planner and nothing else")

    def test_every_header_is_installed(self):
        root = SOURCE / "planner"
        headers = {path.relative_to(root).as_posix() for path in root.rglob("*.hpp")}
        there = self.installed / "include/kerfline/planner"
        self.assertEqual(headers, {path.relative_to(there).as_posix()
                                   for path in there.rglob("*.hpp")})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
