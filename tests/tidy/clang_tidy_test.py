"""Plants faults in a small source tree and checks that clang_tidy.py and the project's
configuration find them.

usage: clang_tidy_test.py CLANG_TIDY CLANG
"""
import argparse
import contextlib
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import clang_tidy

PROJECT = clang_tidy.ROOT
TOOLS = sys.argv[1:3]

CLEAN = """namespace cnc {
namespace {
constexpr int kSides = 4;
}  // namespace
int sides();
int sides() { return kSides; }
}  // namespace cnc
"""
FAULTS = {
    "readability-identifier-naming": "int BadName() { return 1; }\n",
    "readability-function-size": "int f(int n) {\n" + "  n += 1;\n" * 70 + "  return n;\n}\n",
    "misc-no-recursion": "int f(int n) { return n > 0 ? f(n - 1) : 0; }\n",
    "clang-analyzer-core.NullDereference": "int f() {\n  int* p = nullptr;\n  return *p;\n}\n",
    "bugprone-integer-division": "float f(int n) { return static_cast<float>(n / 2); }\n",
}


class PlantedFaults(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        self.build = self.root / "build"
        self.entries = []
        shutil.copy(PROJECT / ".clang-tidy", self.root)
        self.plant(self.root / "planner/clean.cpp", CLEAN)

    def plant(self, path, text):
        """Writes a file; a source also becomes part of the build."""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        if path.suffix == ".cpp":
            command = f"g++ -std=c++20 -I{self.root} -o a.o -c {path}"
            self.entries.append({"directory": str(self.root), "command": command, "file": str(path)})

    def check(self, changed=False):
        """Runs the check; returns (exit status, output)."""
        self.build.mkdir(exist_ok=True)
        (self.build / "compile_commands.json").write_text(json.dumps(self.entries))
        options = argparse.Namespace(tidy=TOOLS[0], clang=TOOLS[1], build=self.build, jobs=2, only="",
                                     changed=changed)
        output = io.StringIO()
        with contextlib.redirect_stdout(output), mock.patch.object(clang_tidy, "ROOT", self.root), \
                tempfile.TemporaryDirectory() as scratch:
            status = clang_tidy.run(options, scratch)
        return status, output.getvalue()

    def test_clean_source(self):
        status, output = self.check()
        self.assertIn("1 files in 1 groups, 0 findings", output)
        self.assertFalse(status)

    def test_a_header_that_another_compiler_precompiled_is_not_read(self):
        header = self.root / "pch.hxx"
        header.write_text("#include <vector>\n")
        header.with_suffix(".hxx.gch").write_bytes(b"of GCC")
        for entry in self.entries:
            entry["command"] = entry["command"].replace(" -o ", f" -Winvalid-pch -include {header} -o ")
        status, output = self.check()
        self.assertIn("1 files in 1 groups, 0 findings", output)
        self.assertFalse(status)

    def test_faults_are_found_in_the_company_of_others(self):
        for number, source in enumerate(FAULTS.values()):
            self.plant(self.root / f"planner/fault_{number}.cpp",
                       f"namespace n{number} {{\n{source}}}\n")
        status, output = self.check()
        for name in FAULTS:
            self.assertIn(name, output)
        self.assertIn("in 1 groups", output)
        self.assertTrue(status)

    def test_sources_that_do_not_compile_as_one_are_checked_apart(self):
        self.plant(self.root / "planner/also_clean.cpp", CLEAN.replace("sides()", "edges()"))
        status, output = self.check()
        self.assertIn("2 files in 2 groups, 0 findings", output)
        self.assertFalse(status)

    def test_sources_that_the_build_unites(self):
        self.plant(self.root / "planner/bad.cpp", "int BadName() { return 1; }\n")
        source = self.entries.pop()["file"]
        self.plant(self.build / "planner/Unity/unity_0_cxx.cpp", f'#include "{source}"\n')
        status, output = self.check()
        self.assertIn("2 files in 1 groups", output)
        self.assertIn("planner/bad.cpp:1:5", output)
        self.assertTrue(status)

    def test_header_that_no_source_includes(self):
        self.plant(self.root / "firmware/bad.hpp", "#pragma once\ninline int BadName() { return 1; }\n")
        self.plant(self.build / "headers_alone/firmware/bad.hpp.cpp", '#include "firmware/bad.hpp"\n')
        status, output = self.check()
        self.assertIn("firmware/bad.hpp:2:12", output)
        self.assertTrue(status)

    def commit(self):
        """Commits all planted files; returns the commit's name."""
        git = ("git", "-C", str(self.root), "-c", "user.name=a", "-c", "user.email=a@b")
        for words in (("init", "-q"), ("add", "."), ("commit", "-qm", "so far")):
            subprocess.run([*git, *words], check=True)
        return subprocess.run([*git, "rev-parse", "HEAD"], check=True, capture_output=True,
                              text=True).stdout.strip()

    def check_since(self, commit):
        with mock.patch.object(clang_tidy, "proven_commit", lambda: commit):
            return self.check(changed=True)

    def test_changed_files_only(self):
        self.plant(self.root / "planner/old.cpp", "int OldName() { return 1; }\n")
        self.plant(self.root / "planner/used.hpp", "#pragma once\nint sides();\n")
        self.plant(self.root / "planner/user.cpp", '#include "planner/used.hpp"\n')
        commit = self.commit()
        status, output = self.check_since(commit)
        self.assertIn("0 files in 0 groups", output)
        self.assertFalse(status)
        self.plant(self.root / "planner/new.cpp", "int NewName() { return 1; }\n")
        self.plant(self.root / "planner/used.hpp", "#pragma once\ninline int BadName() { return 1; }\n")
        status, output = self.check_since(commit)
        self.assertIn("planner/new.cpp:1:5", output)
        self.assertIn("planner/used.hpp:2:12", output)
        self.assertNotIn("old.cpp", output)
        self.assertTrue(status)

    def test_changes_of_comments_only(self):
        name, text = "planner/old.cpp", "// Old.\nint OldName() {\n  // One.\n  return 1;  // Two.\n}\n"
        self.plant(self.root / name, text)
        commit = self.commit()
        for same in (text.replace("Old.", "New.\n// And more."), text.replace("One", "Uno"),
                     text.replace("Two", "Due")):
            self.plant(self.root / name, same)
            self.assertIn("0 files in 0 groups", self.check_since(commit)[1])
        for other in (text.replace("// One.", "// One\n  // and a half."), text.replace("return 1", "return 2"),
                      text.replace("Two.", "Two. NOLINT"), text.replace("// Old", "// NOLINT")):
            self.plant(self.root / name, other)
            self.assertIn("1 files in 1 groups", self.check_since(commit)[1])

    def test_a_recorded_commit_counts_as_clean(self):
        self.plant(self.root / "planner/old.cpp", "int OldName() { return 1; }\n")
        proven = self.commit()
        self.plant(self.root / "planner/new.cpp", "int NewName() { return 1; }\n")
        (self.root / "tests/tidy").mkdir(parents=True)
        self.commit()
        with mock.patch.object(clang_tidy, "ROOT", self.root), contextlib.redirect_stdout(io.StringIO()):
            clang_tidy.record()
        _, output = self.check_since(proven)
        self.assertIn("0 files in 0 groups", output)

    def test_a_tree_with_changes_is_not_recorded(self):
        (self.root / "tests/tidy").mkdir(parents=True)
        self.commit()
        self.plant(self.root / "planner/new.cpp", CLEAN)
        output = io.StringIO()
        with mock.patch.object(clang_tidy, "ROOT", self.root), contextlib.redirect_stdout(output):
            clang_tidy.record()
        self.assertIn("is not written", output.getvalue())
        self.assertFalse((self.root / "tests/tidy/clean").exists())

    def test_all_files_where_the_proven_commit_is_unknown(self):
        self.plant(self.root / "planner/old.cpp", "int OldName() { return 1; }\n")
        status, output = self.check_since("")
        self.assertIn("planner/old.cpp:1:5", output)
        self.assertTrue(status)

    def test_source_that_does_not_compile(self):
        self.plant(self.root / "planner/broken.cpp", "int f() { return g(); }\n")
        status, output = self.check()
        self.assertIn("clang-diagnostic-error", output)
        self.assertTrue(status)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
