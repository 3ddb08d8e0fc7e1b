#!/usr/bin/env python3
"""Flips bits of memory while a laser job runs; the beam must never be lit without motion.

    test_flips.py PLUGIN kerfline_generic.elf [TEST...]

KERFLINE_TRIALS=10000 sets the number of flips (default 128), KERFLINE_SEED chooses them. Ends with
77 (skipped) if the emulator, the plug-in or the image is missing.
"""

import collections
import pathlib
import random
import re
import shutil
import struct
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chip import (BOOT_NS, CHIP_OPTIONS, MS, RAM, STOPPED, first_seed, in_parallel,  # noqa: E402
                  main, trials)

CHIP = None
# Fine steps and hard acceleration on all axes, because flips may move any of them: while the beam
# is lit in motion, steps are less than 1 ms apart.
SETTINGS = "$32=1\n$858=0\n" + "".join(
    f"${100 + axis}=1600\n${110 + axis}=6000\n${120 + axis}=5000\n" for axis in range(6))
FLIPS_IN_A_RUN = 32
APART_NS = 12 * MS
FIRST_NS = BOOT_NS + 15 * MS
MOST_LIT_NS = MS
MOST_APART_NS = 2000
RESTARTED = re.compile(r"\[MSG:(Restarted [^\]]*)\]")


def job() -> str:
    """Returns a job that is longer than any run. Each line stands alone, because after a restart
    the remaining lines run."""
    return "".join(f"G90G21M{3 + way // 4 % 2}S{400 + 50 * (way % 3)}"
                   f"G1X{way % 7 / 20}Y{way % 5 / 10}F1500\n" for way in range(600))


def at_the_same_times(steps: list, others: list) -> bool:
    """Returns whether two lists of steps agree, except that the emulator may take an interrupt
    slightly earlier or later."""
    return len(steps) == len(others) and all(
        abs(a - b) < MOST_APART_NS for a, b in zip(steps, others))


class FlipTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Stores the job's settings in the flash before the runs."""
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.flash = pathlib.Path(cls.folder.name, "flash")
        run = CHIP.run(SETTINGS, BOOT_NS + 100 * MS, *CHIP_OPTIONS, f"flash={cls.flash}")
        assert run.said.count("ok") == SETTINGS.count("\n"), run.said

    def run_job(self, name: str, *options: str, text: str = "", stop_ns: int = 0):
        copy = self.flash.with_name(f"flash{name}")
        shutil.copy(self.flash, copy)
        run = CHIP.run(text or job(), stop_ns or FIRST_NS + FLIPS_IN_A_RUN * APART_NS,
                       "usart1_window=1000", f"flash={copy}", *CHIP_OPTIONS, *options)
        copy.unlink()
        return run

    def test_the_beam_is_never_lit_without_motion(self):
        undisturbed = self.run_job("0")
        self.assertEqual(STOPPED, undisturbed.status, undisturbed.told)
        self.assertGreater(sum(end - begin for begin, end in undisturbed.lit()), 100 * MS)
        self.assertLess(undisturbed.lit_without_step()[0], MOST_LIT_NS)
        places = [range(CHIP.symbols["stack_bottom"], CHIP.symbols["stack_top"]),
                  range(CHIP.symbols["data_begin"], CHIP.symbols["bss_end"])]
        seed = first_seed(self)
        count, chosen = trials(64, in_proof=128), random.Random(seed)
        runs = [[(self.one_of(places, chosen), chosen.randrange(8), FIRST_NS + i * APART_NS
                  + chosen.randrange(APART_NS)) for i in range(min(FLIPS_IN_A_RUN, count - first))]
                for first in range(0, count, FLIPS_IN_A_RUN)]
        kinds, failed = collections.Counter(), []
        for start in range(0, len(runs), 16):  # Traces are large.
            part = list(enumerate(runs))[start:start + 16]
            outcomes = in_parallel(lambda numbered: self.judge(*numbered, undisturbed), part)
            for (_, flips), (what, lit) in zip(part, outcomes):
                kinds.update(what)
                if lit > MOST_LIT_NS:
                    failed.append((lit, flips))
        print(f"seed {seed}: {count} flips in {len(runs)} runs: {dict(kinds)}; "
              f"{len(failed)} times lit without motion for more than {MOST_LIT_NS / MS:.0f} ms")
        for lit, flips in failed:
            print(f"lit without motion for {lit / MS:.3f} ms: {flips}")
        self.assertFalse(failed)

    @staticmethod
    def one_of(places: list, chosen: random.Random) -> int:
        """Returns an address in one of the ranges; all ranges are equally likely."""
        at = chosen.randrange(sum(map(len, places)))
        for place in places:
            if at < len(place):
                return place[at]
            at -= len(place)
        raise AssertionError

    def judge(self, number: int, flips: list, undisturbed) -> tuple:
        """Returns the effects of a run's flips by kinds, and the time for which the beam was lit
        without motion. A flip in a waiting line may make its feed slow."""
        options = [f"flip={address:x}:{bit}:{ns}" for address, bit, ns in flips]
        run = self.run_job(f"-{number}", *options)
        self.assertEqual(STOPPED, run.status, run.told)
        kinds = collections.Counter()
        told = RESTARTED.findall(run.said)
        kinds.update(re.sub(r" at 0x\w+|\d+", "", text) for text in told)
        kinds["ALARM"] += len(re.findall(r"ALARM:", run.said))
        kinds["line refused"] += len(re.findall(r"error:", run.said))
        same = run.said == undisturbed.said and at_the_same_times(run.steps(), undisturbed.steps())
        kinds["runs the same to the last step" if same else "runs that differ"] += 1
        if run.lit_without_step()[0] > MOST_LIT_NS >= run.lit_without_motion()[0]:
            kinds["a slow motion"] += 1
        return kinds, run.lit_without_motion()[0]

    def test_settings_that_turn_over_are_found_within_a_second(self):
        begin, size = self.settings_place()
        seed = first_seed(self)
        chosen = random.Random(seed)
        flips = [(begin + chosen.randrange(size), chosen.randrange(8)) for _ in range(min(trials(8), 200))]
        each, first = 400 * MS, BOOT_NS + 60 * MS
        parts = [flips[at:at + 4] for at in range(0, len(flips), 4)]

        def one(numbered):
            number, part = numbered
            options = [f"flip={address:x}:{bit}:{first + i * each}"
                       for i, (address, bit) in enumerate(part)]
            return self.run_job(f"s{number}", *options, stop_ns=first + len(part) * each)
        longest = 0
        for part, run in zip(parts, in_parallel(one, enumerate(parts))):
            resets = run.resets()
            for i, flip in enumerate(part):
                at = first + i * each
                found = [ns - at for ns in resets if at <= ns < at + each]
                self.assertTrue(found, f"{flip} is not found")
                longest = max(longest, found[0])
            self.assertLess(run.lit_without_step()[0], MOST_LIT_NS)
        print(f"seed {seed}: {len(flips)} flips of settings, found after at most "
              f"{longest / MS:.0f} ms")

    def settings_place(self) -> tuple:
        """Returns the memory of all settings' values, found by their content: address and bytes."""
        listed = self.run_job("l", text="$$\n", stop_ns=BOOT_NS + 600 * MS).said
        values = [float(value) for value in re.findall(r"\$\d+=(\S+)", listed)]
        self.assertGreater(len(values), 100)
        wanted = struct.pack(f"<{len(values)}f", *values)
        memory = self.memory()
        place = memory.find(wanted)
        self.assertGreater(place, 0)
        self.assertEqual(place, memory.rfind(wanted))
        return RAM + place, len(wanted)

    def memory(self) -> bytes:
        """Returns all of RAM after some time of running."""
        path = pathlib.Path(self.folder.name, "memory")
        self.run_job("m", f"memory={path}", text="\n", stop_ns=BOOT_NS + 100 * MS)
        return path.read_bytes()


if __name__ == "__main__":
    main(globals(), "test_flips")
