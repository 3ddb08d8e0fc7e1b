#!/usr/bin/env python3
"""Counts instructions and modelled cycles of each stage on an emulated Cortex-M4F.

    instructions.py PLUGIN build/cortex-m4f/tests/target/instructions.elf [--record]

The job is 3,000 lines of 0.1 mm, along a curve and as pixels of a row; the result is the average
and the worst case of each stage. The counts are the same in every run. Fails if a count differs
from instructions.csv by more than 2 %. For cycles 5 % are allowed, for branches and misses 15 %,
because they depend on the addresses that the linker assigns. --record writes the counts to
instructions.csv. Ends with 77 (skipped) if the image or the emulator is missing.
"""

import argparse
import csv
import pathlib
import shutil
import subprocess
import sys

EMULATOR = "qemu-system-arm"
# Counts of other controllers on lines of 0.1 mm, measured separately in the same emulation, -O2.
PEERS = {
    "read and parse": "grblHAL 2,053 and 1,364 to read, grbl 1,027 and 968",
    "raster: the main loop in all, worst: a turn":
        "grblHAL 6,827 to read, parse and plan, and 629 for each segment",
    "look ahead over 100 blocks": "grblHAL 3,944 with the building, grbl 3,592 with 16 blocks",
    "cut a segment": "grblHAL 526, grbl 3,085",
    "step interrupt": "grblHAL 79, grbl 94, each tick",
}
SKIPPED = 77
RECORD = pathlib.Path(__file__).with_name("instructions.csv")
COUNTS = ("_cycles", "", "_loads", "_taken", "_divisions", "_misses")
FIGURES = ("average", "worst", "average_cycles", "worst_cycles", *("average" + what for what in COUNTS[2:]))
FIELDS = ("stage", "unit", *FIGURES)
WITHIN = 0.02
WITHIN_BY_PLACE = {"average_cycles": 0.05, "worst_cycles": 0.05,
                   "average_taken": 0.15, "average_misses": 0.15}


def read_record() -> dict:
    with RECORD.open(newline="") as file:
        return {row["stage"]: row for row in csv.DictReader(file)}


def write_record(found: dict):
    with RECORD.open("w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(found.values())


def complaints(found: dict) -> list:
    """Returns the counts that differ from the record, better or worse."""
    recorded = read_record()
    texts = [f"{stage}: measured or on record, but not both"
             for stage in sorted(found.keys() ^ recorded.keys())]
    for stage in found.keys() & recorded.keys():
        for figure in FIGURES:
            before, now = float(recorded[stage][figure]), float(found[stage][figure])
            within = WITHIN_BY_PLACE.get(figure, WITHIN)
            if abs(now - before) > max(within * before, 1.0):
                texts.append(f"{stage}: {figure} was {before:.0f}, is {now:.0f}")
    return texts


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("plugin")
    parser.add_argument("image")
    parser.add_argument("--record", action="store_true")
    options = parser.parse_args()
    image = options.image
    if not pathlib.Path(image).exists() or not shutil.which(EMULATOR):
        print(f"skipped: needs {EMULATOR} and {image} (preset cortex-m4f)")
        return SKIPPED
    # One nanosecond of the emulator's clock per instruction.
    command = [EMULATOR, "-M", "netduinoplus2", "-icount", "shift=0,sleep=off", "-display", "none",
               "-monitor", "none", "-serial", "none", "-plugin", f"{options.plugin},memories_only=on,cycles=on",
               "-semihosting-config", "enable=on,target=native", "-kernel", image]
    done = subprocess.run(command, capture_output=True, text=True, timeout=280, check=False)
    text = done.stdout + done.stderr  # Semihosting writes to the latter.
    rows = [line.split("|") for line in text.splitlines() if line.count("|") == 2 + 2 * len(COUNTS)]
    found = {}
    for what, unit, times, *counts in rows:
        stage = f"{what} per {unit}"  # One is given per line and per turn.
        figures = {"stage": stage, "unit": unit}
        for count, total, worst in zip(COUNTS, counts[::2], counts[1::2]):
            figures["average" + count] = round(int(total) / max(1, int(times)))
            figures["worst" + count] = int(worst)
        found[stage] = {field: figures[field] for field in FIELDS}
        print(f"{stage:<66}{figures['average']:7d} worst {figures['worst']:7d}, cycles"
              f" {figures['average_cycles']:7d} worst {figures['worst_cycles']:7d}; loads"
              f" {figures['average_loads']:6d}, taken {figures['average_taken']:5d}, divisions"
              f" {figures['average_divisions']:4d}, misses {figures['average_misses']:5d};"
              f" {int(times)} times  {PEERS.get(what, '')}".rstrip())
    if done.returncode != 0 or len(rows) < 9 or any(int(row[2]) == 0 for row in rows):
        print(f"{command[0]} ended with {done.returncode}: {text}")
        return 1
    if options.record:
        write_record(found)
        return 0
    texts = complaints(found)
    print("\n".join(texts) or "instructions: as recorded")
    if texts:
        print(f"a cost that is meant: {sys.argv[0]} {options.plugin} {image} --record, and commit {RECORD.name}")
    return bool(texts)


if __name__ == "__main__":
    sys.exit(main())
