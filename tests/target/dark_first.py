#!/usr/bin/env python3
"""Counts the instructions from reset until the beam's pin is driven low, in the emulator.

    dark_first.py PLUGIN kerfline_generic.elf=A8 kerfline_btt_skr_2.elf=B0 ...

Each image is given with the pin of its beam. Fails above 64 instructions, or if the pin is driven
before it is low. Ends with 77 (skipped) if an image or the emulator is missing.
"""
import pathlib
import subprocess
import sys
import tempfile

import emulator

MOST = 64
LONGEST_LOG = 2000


def instructions_until_dark(plugin: str, image: pathlib.Path, port: str, pin: int, folder: str) -> int:
    """Returns the number of the instruction that makes the pin a low output; 0 if none does, or if
    the pin was not low before."""
    words = [*emulator.command(plugin, image, pathlib.Path(folder)), "-serial", "none",
             "-d", "exec,nochain,unimp", "-singlestep"]
    low, count = False, 0
    with subprocess.Popen(words, stderr=subprocess.PIPE, text=True) as process:
        try:
            for _ in range(LONGEST_LOG):
                line = process.stderr.readline()
                count += line.startswith("Trace ")
                for written_port, register, value in emulator.pin_writes(line):
                    if written_port != port:
                        continue
                    if register == emulator.SET_RESET and value >> pin & 0x10001 != 0:
                        low = value >> pin & 1 == 0
                    if register == 0 and value >> 2 * pin & 3 != 0:
                        return count if low and value >> 2 * pin & 3 == 1 else 0
        finally:
            process.kill()
    return 0


def main() -> int:
    images = [argument.rpartition("=")[::2] for argument in sys.argv[2:]]
    if emulator.missing(sys.argv[1], *(image for image, _ in images)):
        return emulator.SKIPPED
    good = True
    for image, pin in images:
        with tempfile.TemporaryDirectory() as folder:
            count = instructions_until_dark(sys.argv[1], pathlib.Path(image), pin[0],
                                            int(pin[1:]), folder)
        print(f"{pathlib.Path(image).stem}: P{pin} is low after {count} instructions")
        good = good and 0 < count <= MOST
    return not good


if __name__ == "__main__":
    sys.exit(main())
