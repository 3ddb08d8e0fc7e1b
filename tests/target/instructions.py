#!/usr/bin/env python3
"""Instructions of each stage on an emulated Cortex-M4F; counts, not cycles.

    instructions.py build/cortex-m4f/tests/target/instructions.elf

3,000 lines of 0.1 mm, along a curve and as pixels of a row: average and worst case of each
stage. The counts are the same at every run. Ends with 77 (skipped) where the image or the
emulator is missing.
"""

import pathlib
import shutil
import subprocess
import sys

EMULATOR = "qemu-system-arm"
# Others on lines of 0.1 mm, measured elsewhere in the same emulation, -O2.
PEERS = {
    "read and parse": "grblHAL 2,053 and 1,364 to read, grbl 1,027 and 968",
    "raster: the main loop in all, worst: a turn":
        "grblHAL 6,827 to read, parse and plan, and 629 for each segment",
    "look ahead over 100 blocks": "grblHAL 3,944 with the building, grbl 3,592 with 16 blocks",
    "cut a segment": "grblHAL 526, grbl 3,085",
    "step interrupt": "grblHAL 79, grbl 94, each tick",
}
SKIPPED = 77


def main() -> int:
    image = sys.argv[1]
    if not pathlib.Path(image).exists() or not shutil.which(EMULATOR):
        print(f"skipped: needs {EMULATOR} and {image} (preset cortex-m4f)")
        return SKIPPED
    # One nanosecond of the emulator's clock per instruction.
    command = [EMULATOR, "-M", "netduinoplus2", "-icount", "shift=0,sleep=off", "-display", "none",
               "-monitor", "none", "-serial", "none",
               "-semihosting-config", "enable=on,target=native", "-kernel", image]
    done = subprocess.run(command, capture_output=True, text=True, timeout=280, check=False)
    text = done.stdout + done.stderr  # Semihosting writes to the latter.
    rows = [line.split("|") for line in text.splitlines() if line.count("|") == 4]
    for what, unit, times, total, worst in rows:
        average = int(total) / max(1, int(times))
        print(f"{what:<56}{average:8.0f} per {unit:<9} worst {int(worst):7d} {int(times):8d} times"
              f"  {PEERS.get(what, '')}".rstrip())
    if done.returncode != 0 or len(rows) < 9 or any(int(row[2]) == 0 for row in rows):
        print(f"{command[0]} ended with {done.returncode}: {text}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
