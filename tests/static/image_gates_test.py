"""Plants code that must not be in an image, one kind at a time. The linker's assertions,
image_files.py or image_stack.py must find each."""
import contextlib
import io
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import image_stack
from source_files import ROOT

sys.path.insert(0, str(ROOT / "toolchain"))
import image_files  # noqa: E402  pylint: disable=wrong-import-position

COMPILER = "arm-none-eabi-g++"
SCRIPT = ROOT / "toolchain/stm32f405.ld"
FLAGS = """-std=c++20 -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -O2 -fno-exceptions
    -fno-rtti -fno-use-cxa-atexit -fno-unwind-tables -fno-asynchronous-unwind-tables -nostartfiles
    --specs=nano.specs --specs=nosys.specs -Wl,--gc-sections -Wl,--emit-relocs""".split()
PLACES = {"application_begin": 0x08000000, "application_end": 0x08100000, "stack_bytes": 8192}

PROGRAM = """
#include <cstddef>
volatile int sink = 5;  // Initial values, which every image has.
[[gnu::noipa]] int planted(int);
extern "C" {
[[gnu::noipa, gnu::used]] void start_up() { sink = planted(sink); }
void reset_entry() { start_up(); }
void step_interrupt() { sink = 1; }
void supply_interrupt() { sink = 2; }
void line_interrupt() { sink = 3; }
void clock_interrupt() { sink = 4; }
[[gnu::section(".vectors"), gnu::used]] void (*const vectors[])() = {
    reset_entry, step_interrupt, supply_interrupt, line_interrupt, clock_interrupt};
}
"""
RIGHT = "int planted(int n) { return n + 1; }"

# Message of the linker: source that causes it
LINKER = {
    "region `RAM' overflowed": "char big[129 * 1024];\nint planted(int n) { big[n] = 1; return big[n + 1]; }",
    "region `FLASH' overflowed":
        "const int big[264000] = {1, 2};\nint planted(int n) { return const_cast<const volatile int*>(big)[n]; }",
}
# Message of image_files.py: source that causes it
FILES = {
    "heap: malloc": "#include <cstdlib>\nint planted(int n) { return std::malloc(n) != nullptr; }",
    "heap: _Znwj": "int* volatile p;\nint planted(int n) { p = new int{n}; return *p; }",
    "printf: snprintf": "#include <cstdio>\n"
                        "int planted(int n) { char t[9]; return std::snprintf(t, 9, \"%d\", n) + t[0]; }",
    "double arithmetic: __aeabi_dmul": "int planted(int n) { double d = n; return d * d * 1.1 > 2.0; }",
    "the end of the program (use CNC_ASSERT): abort":
        "#include <cstdlib>\nint planted(int n) { if (n > 3) std::abort(); return n; }",
    "exceptions: __cxa_throw": "extern \"C\" [[gnu::noipa]] void __cxa_throw() { asm volatile(\"\"); }\n"
                  "int planted(int n) { __cxa_throw(); return n; }",
}
# Message of image_stack.py: source that causes it
STACK = {
    "the main loop may need": "int g(char*);\nint planted(int) { char t[5000]; return g(t); }\n"
                              "[[gnu::noipa]] int g(char* t) { return *t; }",
    "recursion: again > again": "[[gnu::noipa]] int again(int n) { return n ? again(n - 1) * 3 + again(n - 2) : 1; }\n"
                          "int planted(int n) { return again(n); }",
    "recursion: other > planted > other":
                          "[[gnu::noipa]] int planted(int n);\n"
                          "[[gnu::noipa]] int other(int n) { return planted(n - 1) + 1; }\n"
                          "int planted(int n) { return n ? other(n) * 3 : n; }",
    "size known only at run time": "[[gnu::noipa]] int g(void* t) { return *(char*)t; }\n"
                                   "int planted(int n) { return g(__builtin_alloca(n)) + n; }",
    "its address is taken: free_function": "[[gnu::noipa]] int free_function(int n) { return n; }\n"
        "int (*volatile way)(int) = free_function;\nint planted(int n) { return way(n) + 1; }",
    "step_interrupt may need": "int planted(int n) { return n; }\n",
    "bytes may be needed, and the stack has": "[[gnu::noipa]] int g(char* t) { return *t; }\n"
        "int planted(int) { char t[3900]; return g(t); }",
}


def link(folder: pathlib.Path, source: str, options=(), **places: int) -> tuple:
    """Returns (path of the image, messages of the linker)."""
    (folder / "a.cpp").write_text(PROGRAM + source, encoding="utf-8")
    elf = folder / "a.elf"
    symbols = [f"-Wl,--defsym={name}={place}" for name, place in {**PLACES, **places}.items()]
    run = subprocess.run([COMPILER, *FLAGS, *options, *symbols, f"-T{SCRIPT}", "-o", elf, folder / "a.cpp"],
                         capture_output=True, text=True, check=False)
    return elf, run.stderr


class ImageGates(unittest.TestCase):
    def setUp(self):
        self.addCleanup((folder := tempfile.TemporaryDirectory()).cleanup)
        self.folder = pathlib.Path(folder.name)

    def stack_of(self, source: str, *options: str, **places: int) -> str:
        elf, said = link(self.folder, source, (), **places)
        self.assertTrue(elf.exists(), said)
        output = io.StringIO()
        with contextlib.redirect_stdout(output), mock.patch.object(sys, "argv", ["", str(elf), *options]):
            status = image_stack.main()
        self.assertEqual("stack: clean" not in output.getvalue(), bool(status))
        return output.getvalue()

    def test_a_right_image_links_and_is_clean(self):
        elf, said = link(self.folder, RIGHT)
        self.assertTrue(elf.exists(), said)
        self.assertIn("stack: clean", self.stack_of(RIGHT))

    def test_the_linker_refuses_each(self):
        for expected, source in LINKER.items():
            with self.subTest(expected):
                elf, said = link(self.folder, source)
                self.assertIn(expected, said)
                self.assertFalse(elf.exists())

    def test_the_linker_refuses_a_stack_beyond_the_core_coupled_memory(self):
        _, said = link(self.folder, RIGHT, stack_bytes=65536)
        self.assertIn("region `CCM' overflowed", said)

    def test_the_checksum_is_in_the_image_and_in_its_elf_file(self):
        self.files_of(RIGHT)
        elf = self.folder / "a.elf"
        image = image_files.binary_of(elf)
        at = image_files.symbols_of(elf)["image_header"] - PLACES["application_begin"]
        magic, length, checksum = struct.unpack_from("<III", image, at)
        self.assertEqual((image_files.HEADER_MAGIC, len(image)), (magic, length))
        self.assertEqual(image_files.checksum_of(image, at), checksum)
        for place in (0, at, len(image) - 1):
            changed = bytearray(image)
            changed[place] ^= 1
            self.assertNotEqual(checksum, image_files.checksum_of(bytes(changed), at))

    def files_of(self, source: str, *options: str) -> tuple:
        """Returns (status, messages of image_files.py, whether the image still exists)."""
        elf, said = link(self.folder, source, options)
        self.assertTrue(elf.exists(), said)
        output = io.StringIO()
        with contextlib.redirect_stdout(output), mock.patch.object(
                sys, "argv", ["", str(elf), hex(PLACES["application_begin"])]):
            status = image_files.main()
        return status, output.getvalue(), elf.exists()

    def test_a_board_s_caution_is_printed_and_is_not_in_the_image(self):
        text = '[[gnu::section(".caution"), gnu::used]] constexpr char caution[] = "Is it blue?";'
        status, said, _ = self.files_of(RIGHT + text)
        self.assertEqual(0, status)
        self.assertIn("  CAUTION: Is it blue?.\n", said)
        self.assertNotIn(b"Is it blue?", (self.folder / "a.bin").read_bytes())
        self.assertNotIn("CAUTION", self.files_of(RIGHT)[1])

    def test_nothing_is_made_of_an_image_with_any_of_these(self):
        self.assertEqual(self.files_of(RIGHT)[0::2], (0, True))
        for expected, source in FILES.items():
            with self.subTest(expected):
                status, said, exists = self.files_of(source, "-Wl,--defsym=end=0")
                self.assertIn(expected, said)
                self.assertTrue(status)
                self.assertFalse(exists)

    def test_each_use_of_the_stack_is_found(self):
        for expected, source in STACK.items():
            with self.subTest(expected):
                options = ["--interrupt", "100"] if "step_interrupt" in expected else []
                stack = 4096 if "at once" in expected or "stack has" in expected else 8192
                self.assertIn(expected, self.stack_of(source, *options, stack_bytes=stack))

    def test_a_number_that_looks_like_an_address_is_none(self):
        source = "[[gnu::noipa]] int like_it(int n) {{ return n; }}\nextern const unsigned number = {:#x};\n" \
            "int planted(int n) {{ return like_it(n) + int(*const_cast<const volatile unsigned*>(&number)); }}"
        elf, _ = link(self.folder, source.format(1))
        symbols = subprocess.run(["arm-none-eabi-nm", elf], capture_output=True, text=True, check=True).stdout
        address = int(next(row for row in symbols.splitlines() if "like_it" in row).split()[0], 16)
        self.assertNotIn("its address is taken", self.stack_of(source.format(address | 1)))

    def test_a_virtual_call_counts_as_its_deepest_function(self):
        source = """
struct A { virtual int small() = 0; };
[[gnu::noipa]] int g(char* t) { return *t; }
struct B final : A { int small() override { char t[1000]; return g(t); } };
B b;
A* volatile a = &b;
int planted(int) { return a->small(); }
void* __dso_handle;
"""
        said = self.stack_of(source)
        self.assertGreater(int(said.split()[0]), 1000)


if __name__ == "__main__":
    if not shutil.which(COMPILER):
        print("skipped: no", COMPILER)
        sys.exit(77)
    unittest.main()
