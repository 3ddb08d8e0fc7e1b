"""Plants code that must not run on the controller, one kind at a time, and checks that
cortex_gates.py finds it."""
import contextlib
import io
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import cortex_gates

COMPILER = "arm-none-eabi-g++"
FLAGS = """-std=c++20 -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2
    -ffunction-sections -fno-unwind-tables -fno-asynchronous-unwind-tables -fno-exceptions -fno-rtti
    -fno-math-errno -fcallgraph-info=su,da""".split()

# Message of the check: (source, flags with which the compiler accepts it)
PLANTED = {
    "heap: _Znwj": ("int* f() { return new int; }", []),
    "heap: _ZdlPvj": ("void f(int* p) { delete p; }", []),
    "heap: malloc": ("#include <cstdlib>\nvoid* f() { return std::malloc(8); }", []),
    "exceptions: __cxa_throw": ("void f() { throw 1; }", ["-fexceptions"]),
    "exceptions: _ZSt24__throw_out_of_range_fmt": (
        "#include <array>\nint f(std::array<int, 3>& a, int i) { return a.at(i); }", []),
    "run-time type information: _ZTI": (
        "struct A { virtual int f(); };\nint A::f() { return 1; }", ["-frtti"]),
    "double arithmetic: __aeabi_dmul": ("double f(double a) { return a * a; }", []),
    "double arithmetic: __aeabi_f2d": ("double f(float a) { return a; }", []),
    "double arithmetic: __aeabi_d2iz": ("int f(double a) { return static_cast<int>(a); }", []),
    "double arithmetic: __aeabi_f2lz": (
        "long long f(float a) { return static_cast<long long>(a); }", []),
    "printf: snprintf": (
        '#include <cstdio>\nint f(char* t, int n) { return std::snprintf(t, 9, "%d", n); }', []),
    "printf: _ZSt8to_chars": (
        "#include <charconv>\nchar* f(char* t, float a) { return std::to_chars(t, t + 9, a).ptr; }",
        []),
    "differs between machines: sinf": (
        "#include <cmath>\nfloat f(float a) { return std::sin(a); }", []),
    "differs between machines: atan2f": (
        "#include <cmath>\nfloat f(float a) { return std::atan2(a, a); }", []),
    "differs between machines: powf": (
        "#include <cmath>\nfloat f(float a) { return std::pow(a, a); }", []),
    "square root as a call": (
        "#include <cmath>\nfloat f(float a) { return std::sqrt(a); }", ["-fmath-errno"]),
    "atomics that are not lock-free": (
        "#include <atomic>\nlong long f(std::atomic<long long>& a) { return a.load(); }", []),
    "the end of the program": (
        "#include <optional>\nint f(std::optional<int> a) { return a.value(); }", []),
    "the end of the program (use CNC_ASSERT): abort in a.obj, from g(int)": (
        "#include <cstdlib>\n[[gnu::noinline]] inline int g(int n) { if (n) std::abort(); return n; }\n"
        "int f(int n) { return g(n); }", []),
    "stack: 20": (
        "void g(char*);\nvoid f() { char t[2000]; g(t); }", []),
    "stack: size known only at run time": (
        "void g(void*);\nvoid f(unsigned n) { g(__builtin_alloca(n)); }", []),
    "recursion: int f(int) > int g(int) > int f(int)": (
        "[[gnu::noipa]] int g(int);\n[[gnu::noipa]] int f(int n) { return g(n - 1) + 1; }\n"
        "int g(int n) { return n ? f(n - 1) * 3 : n; }", []),
    "state outside Application: counter, 4 bytes": ("int counter = 7;", []),
    "state outside Application: _ZZ1fvE5count": (
        "int f() { static int count = 0; return ++count; }", []),
    # GCC 12 drops the const of a constexpr variable whose template arguments it must deduce.
    "state outside Application: _ZL5table": (
        "#include <array>\nconstexpr std::array table{1, 2, 3};\n"
        "const int* f(int i) { return &table[i]; }", []),
}
RIGHT = """#include <array>
#include <cmath>
#include <cstdint>
#include <span>
struct Port { virtual int read() = 0; protected: ~Port() = default; };
float f(std::span<const float> a, Port& p, std::int64_t n) {
  return std::sqrt(a[0]) + static_cast<float>(n / p.read()) + std::floor(a[1]);
}
"""


class PlantedFaults(unittest.TestCase):
    def check(self, source, flags, without=()):
        """Returns (exit status, output) of the check of a build of this single source, without the
        flags `without`."""
        with tempfile.TemporaryDirectory() as folder:
            build = pathlib.Path(folder)
            (build / "CMakeFiles/kerfline_planner.dir").mkdir(parents=True)
            (build / "a.cpp").write_text(source, encoding="utf-8")
            chosen = [flag for flag in FLAGS if flag not in without]
            command = [COMPILER, *chosen, *flags, "-o", "CMakeFiles/kerfline_planner.dir/a.obj",
                       "-c", "a.cpp"]
            # A compiler cache does not keep call graphs.
            subprocess.run(command, cwd=build, check=True,
                           env=os.environ | {"CCACHE_DISABLE": "1"})
            (build / "compile_commands.json").write_text(
                json.dumps([{"directory": folder, "command": " ".join(command)}]))
            output = io.StringIO()
            with contextlib.redirect_stdout(output), mock.patch.object(sys, "argv", ["", folder]):
                status = cortex_gates.main()
            return status, output.getvalue()

    def test_right_source_is_clean(self):
        status, output = self.check(RIGHT, [])
        self.assertIn("controller: clean", output)
        self.assertEqual(0, status)

    def test_a_function_that_the_linker_drops_is_no_fault(self):
        """Builds a weak function as the compiler leaves it after it has inlined all calls."""
        status, output = self.check(
            "#include <cstdlib>\n[[gnu::weak]] void g() { std::abort(); }\n" + RIGHT, [])
        self.assertIn("controller: clean", output)
        self.assertEqual(0, status)

    def test_each_fault_is_found(self):
        for expected, (source, flags) in PLANTED.items():
            with self.subTest(expected):
                status, output = self.check(source, flags)
                self.assertIn(expected, output)
                self.assertTrue(status)

    def test_an_object_without_its_call_graph_is_a_fault(self):
        status, output = self.check(RIGHT, [], without=["-fcallgraph-info=su,da"])
        self.assertIn("no call graph: a.obj", output)
        self.assertTrue(status)

    def test_the_message_names_the_caller(self):
        _, output = self.check("#include <cmath>\nfloat turn(float a) { return std::cos(a); }", [])
        self.assertIn("from turn(float)", output)


if __name__ == "__main__":
    if not shutil.which(COMPILER):
        print("skipped: no", COMPILER)
        sys.exit(77)
    unittest.main()
