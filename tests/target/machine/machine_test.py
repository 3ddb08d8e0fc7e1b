#!/usr/bin/env python3
"""Tests the emulated chip's peripherals against the reference manual.

    machine_test.py PLUGIN PROBE_ELF [TEST...]

Runs the scenarios of the probe image one after the other. Judges the lines that the image prints
through semihosting and the trace of the plug-in. Ends with 77 (skipped) if emulator, image or
plug-in is missing, or if the plug-in cannot be loaded.
"""

import pathlib
import re
import shutil
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from emulator import EMULATOR, Emulator  # noqa: E402
from test_can import CanTest  # noqa: E402,F401
from test_core import CoreTest  # noqa: E402,F401
from test_cycles import CyclesTest  # noqa: E402,F401
from test_flash import FlashTest  # noqa: E402,F401
from test_pins_and_timers import PinsAndTimersTest  # noqa: E402,F401
from test_serial import SerialTest  # noqa: E402,F401

SKIPPED = 77


def why_not(plugin: str, image: str) -> str:
    """Returns the reason why the plug-in cannot be tested here, or nothing."""
    if not shutil.which(EMULATOR):
        return f"needs {EMULATOR}"
    version = Emulator.version()
    if not version.startswith("7.2."):
        return f"{EMULATOR} is {version}; the plug-in is made for the internals of 7.2"
    for path, preset in ((plugin, "release"), (image, "cortex-m4f")):
        if not pathlib.Path(path).exists():
            return f"needs {path} (preset {preset})"
    Emulator.plugin, Emulator.image = plugin, image
    first = Emulator.run("clocks")
    # A missing C++ name is from this project, and no reason to skip.
    if re.search("undefined symbol: (?!_Z)|requires API version|made for|-plugin: invalid", first.text):
        return f"{EMULATOR} does not load the plug-in: {first.text.strip()}"
    return ""


if __name__ == "__main__":
    if reason := why_not(*sys.argv[1:3]):
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
