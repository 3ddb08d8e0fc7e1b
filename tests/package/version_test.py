"""Tests the version that toolchain/version.cmake gives to programs and images.

usage: version_test.py CMAKE
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CMAKE = sys.argv[1]

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(kerfline VERSION 1.2.3 LANGUAGES CXX)
add_library(firmware STATIC planner/a.cpp planner/b.cpp)
target_include_directories(firmware PUBLIC ${PROJECT_SOURCE_DIR})
target_compile_features(firmware PUBLIC cxx_std_17)
set_target_properties(firmware PROPERTIES UNITY_BUILD ${UNITY})
include(toolchain/version.cmake)
kerfline_add_version(firmware)
add_executable(main main.cpp)
target_link_libraries(main PRIVATE firmware)
"""
MAIN = """#include <cstdio>
#include "firmware/protocol/identity.hpp"
int main() { std::puts(cnc::identity::version().data()); }
"""


class Scratch(unittest.TestCase):
    """A small project in a git work tree."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve() / "project"
        for name in ("describe_version", "write_version", "version"):
            self.write(f"toolchain/{name}.cmake", (ROOT / f"toolchain/{name}.cmake").read_text())
        self.write(".gitignore", "/build/\n")

    def write(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def git(self, *arguments, folder=None):
        return subprocess.run(
            ["git", "-C", folder or self.root, "-c", "user.name=a", "-c", "user.email=a@b.invalid",
             *arguments], check=True, capture_output=True, text=True).stdout.strip()

    def commit(self):
        """Returns the first seven digits of a new commit."""
        self.git("add", "--all")
        self.git("commit", "--allow-empty", "--message", "step")
        return self.git("rev-parse", "HEAD")[:7]


class DescribedVersion(Scratch):
    def version(self, folder=None):
        script = self.root / "build/describe.cmake"
        self.write("build/describe.cmake",
                   f"include({ROOT}/toolchain/describe_version.cmake)\n"
                   f"kerfline_describe_version(version {folder or self.root} 1.2.3)\n"
                   "message(${version})\n")
        run = subprocess.run([CMAKE, "-P", script], capture_output=True, text=True, check=True)
        return run.stderr.strip()

    def test_has_the_commit(self):
        self.git("init", "--quiet")
        self.assertEqual(self.version(), "1.2.3", "before the first commit")
        commit = self.commit()
        self.assertEqual(self.version(), f"1.2.3+{commit}")

    def test_is_dirty_as_long_as_the_tree_is_modified(self):
        self.git("init", "--quiet")
        self.write("README.md", "a")
        first = self.commit()
        self.write("README.md", "b")
        self.assertEqual(self.version(), f"1.2.3+{first}-dirty")
        self.git("add", "README.md")
        self.assertEqual(self.version(), f"1.2.3+{first}-dirty")
        second = self.commit()
        self.assertEqual(self.version(), f"1.2.3+{second}")

    def test_a_new_file_counts_where_the_build_takes_it_up(self):
        self.git("init", "--quiet")
        commit = self.commit()
        self.write("part.nc", "G0 X1")
        self.assertEqual(self.version(), f"1.2.3+{commit}")
        self.write("planner/new.cpp", "")
        self.assertEqual(self.version(), f"1.2.3+{commit}-dirty")

    def test_is_the_projects_alone_without_a_work_tree_of_its_own(self):
        self.assertEqual(self.version(), "1.2.3")
        self.git("init", "--quiet")
        self.commit()
        self.assertEqual(self.version(self.root / "toolchain"), "1.2.3", "a copy in another project")


class CompiledVersion(Scratch):
    def build(self):
        """Returns (sources that are compiled, version that the program prints)."""
        run = subprocess.run([CMAKE, "--build", self.root / "build", "--verbose"],
                             capture_output=True, text=True, check=True)
        program = subprocess.run([self.root / "build/main"], capture_output=True, text=True, check=True)
        sources = [pathlib.Path(name).name for name in re.findall(r" -c (\S+)", run.stdout)]
        return sources, program.stdout.strip()

    def check(self, unity):
        header = "firmware/protocol/identity.hpp"
        self.write(header, (ROOT / header).read_text())
        self.write("CMakeLists.txt", PROJECT)
        self.write("main.cpp", MAIN)
        self.write("planner/a.cpp", "int a() { return 1; }\n")
        self.write("planner/b.cpp", "int b() { return 2; }\n")
        self.git("init", "--quiet")
        first = self.commit()
        subprocess.run([CMAKE, "-S", self.root, "-B", self.root / "build", f"-DUNITY={unity}", "-GNinja"],
                       capture_output=True, check=True)
        self.assertEqual(self.build()[1], f"1.2.3+{first}")
        second = self.commit()
        self.assertEqual(self.build(), (["version.cpp"], f"1.2.3+{second}"))
        self.assertEqual(self.build()[0], [], "nothing is new")

    def test_a_commit_compiles_one_source(self):
        self.check("OFF")

    def test_a_commit_compiles_one_source_beside_united_ones(self):
        self.check("ON")


if __name__ == "__main__":
    if not shutil.which("git"):
        sys.exit("version_test: git is missing; install the package git")
    unittest.main(argv=sys.argv[:1])
