#!/usr/bin/env python3
"""Compares the firmware compiled for Cortex-M4F, run in an emulator, with that of the host.

    same_bits.py HOST_PROGRAM PLUGIN TARGET_ELF

Both run the complete firmware on the same program and print a digest of every edge with its tick,
which must be the same. Ends with 77 (skipped) if the image or the emulator is missing.
"""

import pathlib
import shutil
import subprocess
import sys

EMULATOR = "qemu-system-arm"
SKIPPED = 77


def run(command: list[str]) -> str:
    done = subprocess.run(command, capture_output=True, text=True, timeout=280, check=False)
    if done.returncode != 0:
        sys.exit(f"{command[0]} ended with {done.returncode}: {done.stdout}{done.stderr}")
    return (done.stdout + done.stderr).strip()  # Semihosting writes to the latter.


def main() -> int:
    host, plugin, image = sys.argv[1:4]
    if not pathlib.Path(image).exists() or not shutil.which(EMULATOR):
        print(f"skipped: needs {EMULATOR} and {image} (preset cortex-m4f)")
        return SKIPPED
    # -M netduinoplus2 is an STM32F405; without the plug-in's devices only core and memory are used.
    emulator = [EMULATOR, "-M", "netduinoplus2", "-display", "none", "-monitor", "none",
                "-serial", "none", "-plugin", f"{plugin},memories_only=on",
                "-semihosting-config", "enable=on,target=native",
                "-kernel", image]
    expected, got = run([host]), run(emulator)
    print(f"host    {expected}\ntarget  {got}   (hash of all edges, step pulses, answers)")
    return 0 if expected == got else 1


if __name__ == "__main__":
    sys.exit(main())
