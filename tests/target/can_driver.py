#!/usr/bin/env python3
"""Tests the controller's CAN driver in the emulator, on a bus that is intact, corrupted or dead.

    can_driver.py PLUGIN IMAGE

The plug-in is the rest of the bus: it corrupts frames by a seed, counts errors, goes bus-off and
returns as ISO 11898-1 says. Ends with 77 (skipped) if the image or the emulator is missing.
"""
import collections
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from seeds import name_of, seeds_of, share_of  # noqa: E402

EMULATOR = "qemu-system-arm"
SKIPPED = 77
PLUGIN = IMAGE = ""
TO_ITSELF, TO_OTHERS, FIRST_ID = 5, 24, 0x300
ACTIVE, BUS_OFF = 0, 3
STATE, SENT_ERRORS, _, BUS_OFFS, LOST = range(5)


def frame(number: int) -> str:
    """Returns the image's frame of this number, as the plug-in writes it."""
    return f"{FIRST_ID + number:X}#" + bytes(number + at for at in range(number % 9)).hex().upper()


class Run:
    """One run. `said` holds the image's lines by their first word, `trace` the events of the bus."""

    def __init__(self, others: str = "", **options):
        with tempfile.TemporaryDirectory() as folder:
            trace, frames = pathlib.Path(folder, "trace"), pathlib.Path(folder, "others")
            frames.write_text(others)
            plugin = [str(PLUGIN), f"trace={trace}", f"can_in={frames}", "stop_ns=3000000000"]
            plugin += [f"{name}={value}" for name, value in options.items()]
            done = subprocess.run(
                [EMULATOR, "-M", "netduinoplus2", "-display", "none", "-monitor", "none",
                 "-serial", "none", "-icount", "shift=3,sleep=off", "-semihosting-config",
                 "enable=on,target=native", "-kernel", IMAGE, "-plugin", ",".join(plugin)],
                capture_output=True, text=True, timeout=120, check=False)
            events = [line.split(" ", 2) for line in trace.read_text().splitlines()]
        self.status, self.text = done.returncode, done.stderr
        self.said = collections.defaultdict(list)
        for name, *values in (line.split() for line in done.stderr.splitlines()):
            if all(len(value) == 8 for value in values):
                self.said[name].append([int(value, 16) for value in values])
        self.misuse = [rest for _, source, rest in events if source == "misuse"]
        self.bus = [rest.split() for _, source, rest in events if source == "can"]
        self.sent = [rest[1] for rest in self.bus if rest[0] == "tx"]

    def count(self, kind: str) -> int:
        return sum(rest[0] == kind for rest in self.bus)


class CanDriverTest(unittest.TestCase):
    def assert_whole(self, run: Run):
        self.assertEqual(0, run.status, run.text)
        self.assertEqual([], run.misuse)
        for step in ("ready", "alone", "silent", "speaks"):
            self.assertEqual([[1]], run.said[step], step)

    def test_all_frames_go_out_once_and_in_order(self):
        run = Run()
        self.assert_whole(run)
        self.assertEqual([frame(number) for number in range(TO_ITSELF)], run.sent[:TO_ITSELF])
        self.assertEqual([frame(number) for number in range(TO_OTHERS)], run.sent[TO_ITSELF:])
        heard = [[FIRST_ID + number, number % 9,
                  sum((number + at) << 8 * at for at in range(min(4, number % 9)))]
                 for number in range(TO_ITSELF)]
        self.assertEqual(heard, run.said["received"])
        self.assertEqual([[ACTIVE, 0, 0, 0, 0]] * 3, run.said["health"])

    def test_a_corrupted_bus_loses_doubles_and_reorders_nothing(self):
        seeds = seeds_of(self, 2)
        for percent in share_of([5, 10, 30], 1, name_of(self)):
            for seed in seeds:
                with self.subTest(percent=percent, seed=seed):
                    run = Run(can_corrupt=percent, seed=seed)
                    self.assert_whole(run)
                    self.assertEqual([frame(number) for number in range(TO_OTHERS)],
                                     run.sent[TO_ITSELF:])
                    self.assertEqual(run.count("bus-off"), run.said["health"][-1][BUS_OFFS])

    def test_others_are_heard_by_the_filters_silent_or_not(self):
        lines = []
        for at_ms in (12, 40):
            for index, one in enumerate(("2A5#01020304", "123#", "124#11", "001#AABB",
                                         "000002A5#01", "2B0#0102", "2AF#0807060504030201")):
                lines.append(f"{at_ms}{index:03}000 {one}\n")
        run = Run("".join(lines))
        self.assert_whole(run)
        self.assertEqual(14, run.count("rx"))
        heard = sorted(run.said["received"][TO_ITSELF:])
        wanted = [[0x2A5, 4, 0x04030201], [0x123, 0, 0], [0x001, 2, 0xBBAA], [0x2AF, 8, 0x05060708]]
        self.assertEqual(sorted(2 * wanted), heard)

    def test_a_dead_bus_is_left_and_found_again_and_each_time_is_counted(self):
        run = Run(can_corrupt=100)
        self.assert_whole(run)
        self.assertEqual([], run.sent)
        offs = run.said["health"][-1][BUS_OFFS]
        self.assertGreater(offs, 3)
        # One more bus-off may occur between the driver's last line and the end.
        self.assertIn(run.count("bus-off"), (offs, offs + 1))
        self.assertIn(run.count("recovered"), (run.count("bus-off") - 1, run.count("bus-off")))

    def test_a_silent_node_disturbs_nobody(self):
        run = Run(can_alone="on")
        self.assert_whole(run)
        self.assertEqual([ACTIVE, 0, 0, 0, 0], run.said["health"][1])
        self.assertEqual([0, 0], [run.said["health"][-1][BUS_OFFS], run.said["health"][-1][LOST]],
                         "alone is passive, not off")
        self.assertGreaterEqual(run.said["health"][-1][SENT_ERRORS], 128)


def can_run() -> bool:
    if not all(map(os.path.exists, (PLUGIN, IMAGE))) or not shutil.which(EMULATOR):
        return False
    told = subprocess.run([EMULATOR, "--version"], capture_output=True, text=True, check=True)
    return "version 7.2." in told.stdout


if __name__ == "__main__":
    PLUGIN, IMAGE = sys.argv[1:3]
    if not can_run():
        print(f"skipped: needs {EMULATOR} 7.2, {PLUGIN}, {IMAGE} (presets release, cortex-m4f)")
        sys.exit(SKIPPED)
    del sys.argv[1:3]
    unittest.main()
