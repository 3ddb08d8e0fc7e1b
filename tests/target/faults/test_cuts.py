#!/usr/bin/env python3
"""Cuts the power during flash operations of a script that saves data. After the next start all
acknowledged data must exist.

    test_cuts.py PLUGIN kerfline_generic_512.elf [TEST...]

Runs on a chip with 1 MiB of flash and on one with 512 KiB. KERFLINE_TRIALS=400 sets the number of
cuts on each (default 6), KERFLINE_SEED chooses their times. Ends with 77 (skipped) if the emulator,
the plug-in or the image is missing.
"""

import pathlib
import random
import re
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chip import MS, POWER_CUT, STOPPED, first_seed, in_parallel, main, trials  # noqa: E402

CHIP = None
ERASE_US = 20_000
KINDS = ("none", "whole", "torn")
FILLING = 216  # Start-up lines: with them a sector is nearly full.
BOOT_NS = 150 * MS  # A store that is full is read twice before the banner.
SCRIPT_NS = 1500 * MS  # The script's 60 lines, by an image that is compiled for size.
RECOVERED_NS = 900 * MS  # What a cut left is made whole before that.
WINDOW = "usart1_window=1"  # A line goes out when the one before is answered.
SETTINGS = (110, 111, 112, 120, 121, 122, 130, 131, 132)
LISTED = "$$\n$N\n$I\n$#\n"


def script(first: int, count: int) -> list:
    """Returns lines that save something, each with the text that is listed if it was kept."""
    lines = []
    for number in range(first, first + count):
        if number % 4 == 0:
            lines.append(start_up_line(number // 4 % 2, number))
        elif number % 4 == 1:
            lines.append((f"G10L2P{1 + number // 4 % 6}X{number / 8:.3f}",
                          f"[G{54 + number // 4 % 6}:", f"{number / 8:.3f}"))
        else:
            name = f"${SETTINGS[number % len(SETTINGS)]}="
            lines.append((f"{name}{100 + number}", name, f"{100 + number}.000"))
    return lines


def start_up_line(which: int, number: int) -> tuple:
    text = f"G90G94G17G21G40G49G54G61F{number + 1}.{number:04}S{number}.{number:04}N{number}"
    return f"$N{which}={text}", f"$N{which}=", text


def value_of(listed: str, name: str) -> str:
    """Returns the text after a name in a listing, which has the form of the script's values."""
    found = re.search(re.escape(name) + r"([^\r\n]*)", listed)
    return found[1] if found else ""


class CutTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.flash_kib = 1024

    def run_on(self, flash, text: str, stop_ns: int, *options: str, from_ns: int = BOOT_NS):
        return CHIP.run(text, stop_ns, WINDOW, f"flash={flash}", f"flash_kib={self.flash_kib}",
                        f"erase_us={ERASE_US}", *options,
                        from_ns=from_ns)

    def filled(self) -> tuple:
        """Returns a flash with a sector that is nearly full of saved data, and this data."""
        flash = self.folder / "filled"
        lines = script(0, 60) + [start_up_line(i % 2, 1000 + i) for i in range(FILLING)]
        run = self.run_on(flash, text_of(lines), BOOT_NS + 2200 * MS)
        self.assertEqual(len(lines), run.said.count("ok\r\n"), run.said[-400:])
        return flash, lines

    def test_what_was_acknowledged_is_there_after_any_cut(self):
        seed = first_seed(self)
        for self.flash_kib in (1024, 512):
            with self.subTest(flash_kib=self.flash_kib):
                self.assert_nothing_is_lost(seed)

    def assert_nothing_is_lost(self, seed: int):
        filled, before = self.filled()
        lines = script(60, 60)
        whole = self.folder / "whole"
        shutil.copy(filled, whole)
        run = self.run_on(whole, text_of(lines), BOOT_NS + SCRIPT_NS)
        self.assertEqual(len(lines), run.said.count("ok\r\n"), run.said[-400:])
        operations = len(run.times("flash"))
        self.assertGreater(len(run.times("flash", "erase")), 0, "the script compacts")
        count, chosen = trials(3, in_proof=6), random.Random(seed)
        erases = [i + 1 for i, (_, _, what) in
                  enumerate(event for event in run.trace if event[1] == "flash")
                  if what.startswith("erase")]
        cuts = [(at, kind) for at in erases for kind in KINDS][:count]
        while len(cuts) < count:
            cuts.append((chosen.randrange(1, operations + 1), chosen.choice(KINDS)))
        numbered = [(number, *cut) for number, cut in enumerate(cuts)]
        lost = [what for what in in_parallel(lambda cut: self.cut(filled, before, lines, *cut),
                                             numbered) if what]
        print(f"{self.flash_kib} KiB, seed {seed}: {count} cuts in {operations} operations, "
              f"of them {len(erases)} erasures: {len(lost)} with something lost")
        self.assertEqual([], lost)

    def cut(self, filled, before: list, lines: list, number: int, at: int, kind: str) -> str:
        """Returns a description of the data that is lost if power is cut in the given operation, or
        nothing."""
        flash = self.folder / f"cut{number}"
        shutil.copy(filled, flash)
        run = self.run_on(flash, text_of(lines), BOOT_NS + SCRIPT_NS, f"cut={at}",
                          f"cut_kind={kind}", f"seed={number + 1}")
        if run.status != POWER_CUT:
            return f"cut {at} {kind}: {run.status} {run.told}"
        kept = run.said.count("ok\r\n")
        after = self.run_on(flash, LISTED, RECOVERED_NS + 400 * MS, from_ns=RECOVERED_NS)
        flash.unlink()
        if after.status != STOPPED or after.said.count("ok\r\n") != 4:
            return f"cut {at} {kind}: does not start: {after.said[:300]}"
        if "damaged" in after.said or "Restarted" in after.said:
            return f"cut {at} {kind}: {after.said[:300]}"
        wanted = {name: [value] for _, name, value in before + lines[:kept]}
        # Data that was being saved may be kept or not: that of the next line, and a position, which
        # is saved immediately after its answer.
        open_lines = [at for at in (kept - 1, kept) if 0 <= at < len(lines)
                      and (at == kept or lines[at][1].startswith("[G"))]
        for at in open_lines:
            _, name, value = lines[at]
            wanted[name] = [*last_of(before + lines[:at], name), value]
        for name, values in wanted.items():
            if not any(value_of(after.said, name).startswith(value) for value in values):
                return f"cut {at} {kind}: {name} is {value_of(after.said, name)}, not {values}"
        return ""


def last_of(lines: list, name: str) -> list:
    return [value for _, other, value in lines if other == name][-1:]


def text_of(lines: list) -> str:
    return "".join(line + "\n" for line, _, _ in lines)


if __name__ == "__main__":
    main(globals(), "test_cuts")
