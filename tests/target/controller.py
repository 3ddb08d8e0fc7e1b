#!/usr/bin/env python3
"""Tests the unchanged image of the controller in the emulator: it starts, answers, and ends well.

    controller.py PLUGIN build/cortex-m4f/images/kerfline_generic.elf

The emulator has only the slowest clock, and all its switches read as closed. The image must report
this and refuse motion, and otherwise work as usual. Ends with 77 (skipped) if the image or the
emulator is missing.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zlib

import emulator

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "faults"))
from plant import assemble  # noqa: E402

PLUGIN, IMAGE = "", pathlib.Path()
BANNER = r"Grbl 1\.1h \['\$' for help\]\r\n"
SCRATCH = 0x2001F000  # RAM behind all that the image uses.
# Generic board: power PA8, spindle enable PB1.
DARK = [("A", emulator.SET_RESET, 1 << 24), ("B", emulator.SET_RESET, 1 << 17)]


def symbol(name: str) -> int:
    listing = subprocess.run(["arm-none-eabi-nm", IMAGE], capture_output=True, text=True, check=True)
    return int(re.search(rf"^(\w+) \w {name}$", listing.stdout, re.MULTILINE)[1], 16)


class ControllerTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.chip = emulator.Emulator(PLUGIN, IMAGE, pathlib.Path(self.folder.name))
        self.addCleanup(self.chip.__exit__)
        self.greeting = self.chip.hear(r"\[MSG:Reset to continue\]\r\n")

    def ask(self, line: str) -> str:
        """Returns the complete answer to a line."""
        self.chip.say(line + "\n")
        return self.chip.hear(r"(^|\n)(ok|error:\d+)\r\n")

    def test_says_what_it_is_and_what_is_wrong(self):
        self.assertRegex(self.greeting, "^" + BANNER)
        self.assertIn("[MSG:The clock does not reach 168 MHz: nothing will move]", self.greeting)
        self.assertIn("ALARM:24", self.greeting)
        told = self.ask("$I+")
        self.assertIn("[FIRMWARE:Kerfline]", told)
        self.assertIn("[BOARD:Generic F405/F407]", told)
        binary = IMAGE.with_suffix(".bin").read_bytes()
        field = symbol("image_header") - symbol("image_begin") + 8
        checksum = zlib.crc32(binary[field + 4:], zlib.crc32(binary[:field]))
        self.assertIn(f"[IMAGE:{checksum:08x},{len(binary)}]", told)
        self.assertRegex(told, r"\[CLOCK:16 MHz,internal without PLL\]")
        used, size = map(int, re.search(r"\[STACK:(\d+),(\d+)\]", told).groups())
        self.assertTrue(500 < used < size, (used, size))

    def test_starts_from_a_loader_that_left_masks_and_another_stack(self):
        left = assemble(f"""
            movs r0, #0x10
            msr  basepri, r0
            ldr  r0, ={SCRATCH + 0x800:#x}
            msr  psp, r0
            movs r0, #2
            msr  control, r0
            isb
            cpsid f
            ldr  r0, ={symbol("reset_entry") | 1:#x}
            bx   r0
        """)
        left += bytes(-len(left) % 4)
        with self.chip.debugger() as debugger:
            for at in range(0, len(left), 4):
                debugger.set_word(SCRATCH + at, int.from_bytes(left[at:at + 4], "little"))
            debugger.go_to(SCRATCH)
        self.chip.hear(BANNER)
        self.assertIn("[FIRMWARE:Kerfline]", self.ask("$I+"))

    def test_answers_as_grbl(self):
        self.chip.say("?")
        self.assertRegex(self.chip.hear(r">\r\n"), r"<Alarm\|MPos:0\.000,0\.000,0\.000\|.*>")
        settings = self.ask("$$")
        self.assertIn("$110=12000.000\r\n", settings)
        self.assertGreater(settings.count("\n"), 100)
        self.assertTrue(self.ask("$J=G91X1F100").endswith("error:9\r\n"))
        self.assertTrue(self.ask("G1X1F100").endswith("error:9\r\n"))
        self.assertTrue(self.ask("$110=x").endswith("error:3\r\n"))

    def test_tells_of_a_flash_that_takes_nothing(self):
        """The bare emulator's flash stores nothing: a setting that could not be stored must not be
        acknowledged."""
        self.assertRegex(self.ask("$110=5000"), r"error:\d+\r\n$")

    def test_a_burst_loses_no_line(self):
        """Sends a burst as a sender that counts characters: up to the number of bytes that the
        controller reports as its capacity. The emulator's line has no limit of speed; more bytes
        would exceed the rate of any wire."""
        room = int(re.search(r"\[OPT:[^,]*,\d+,(\d+)\]", self.ask("$I"))[1])
        lines = [f"({number})\n" for number in range(300)]
        self.assertGreater(len("".join(lines)), room)
        under_way = []
        while lines or under_way:
            while lines and len("".join(under_way)) + len(lines[0]) <= room:
                under_way.append(lines.pop(0))
                self.chip.say(under_way[-1])
            self.assertTrue(self.chip.hear(r"(ok|error:\d+)\r\n").endswith("ok\r\n"))
            under_way.pop(0)

    def test_a_line_that_was_not_received_whole_is_refused(self):
        self.assertTrue(self.ask("$110=50\x7f00").endswith("error:3\r\n"))

    def restart_after(self, plant) -> str:
        """Returns the first output after a restart. The beam must have gone off before anything
        else."""
        before = len(emulator.pin_writes(self.chip.log()))
        with self.chip.debugger() as debugger:
            plant(debugger)
        said = self.chip.hear(BANNER) + self.chip.hear(r"\[MSG:[^\]]*\]\r\n")
        writes = emulator.pin_writes(self.chip.log())[before:]
        levels = [write for write in writes if write[1] == emulator.SET_RESET]
        self.assertEqual(DARK, levels[:2], "dark first")
        self.assertEqual(DARK, levels[2:4], "and dark again when it has restarted")
        return said

    def test_a_wrong_address_darkens_and_is_told(self):
        said = self.restart_after(lambda debugger: debugger.go_to(0x60000000))
        self.assertRegex(said, r"Restarted after a fault: exception [35] at 0x60000000")

    def test_a_stack_that_runs_over_darkens_and_is_told(self):
        def plant(debugger):
            debugger.set_register(emulator.SP, symbol("stack_bottom") + 8)
            debugger.go_to(symbol("_ZN3cnc12LineProtocol4pollEN3hal9TickCountE"))
        said = self.restart_after(plant)
        self.assertIn("Restarted after a fault: stack overflow", said)

    def test_a_failing_supply_darkens_and_is_told(self):
        pend, scratch = 0xE000E200, SCRATCH
        said = self.restart_after(lambda debugger: debugger.store(pend, 1 << 1, scratch))
        self.assertIn("Restarted after a fault: supply too low", said)

    def test_a_broken_contract_darkens_and_is_told(self):
        broken = symbol("_ZN3cnc15contract_failedEPKcS1_i")
        said = self.restart_after(lambda debugger: debugger.go_to(broken))
        self.assertIn("Restarted after a fault: broken contract", said)

    def test_an_interrupt_that_nobody_expects_darkens_and_is_told(self):
        # Requests a system call, which this program does not have, through ICSR like the other
        # interrupts.
        pend_system_call, scratch = 0xE000ED04, SCRATCH
        said = self.restart_after(
            lambda debugger: debugger.store(pend_system_call, 1 << 28, scratch))
        self.assertIn(f"exception 14 at 0x{scratch + 4:08x}", said)

    def test_the_way_into_the_boot_loader_is_taken(self):
        # The emulator has no boot loader: the jump to the address of ST's boot loader is a fault.
        self.assertIn("[MSG:Leaving for the boot loader]", self.ask("$DFU"))
        self.chip.hear(BANNER)
        said = self.chip.hear(r"\[MSG:[^\]]*\]")
        self.assertRegex(said, r"Restarted after a fault: exception [35] at 0x08")


if __name__ == "__main__":
    if emulator.missing(*sys.argv[1:3]):
        sys.exit(emulator.SKIPPED)
    PLUGIN, IMAGE = sys.argv.pop(1), pathlib.Path(sys.argv.pop(1))
    unittest.main()
