#!/usr/bin/env python3
"""Writes the example programs next to this file. With --check, verifies the committed programs instead.

Requires only Python 3 and host-sim/examples/data. The same input gives the same bytes.
"""
import argparse
import sys
from pathlib import Path

sys.dont_write_bytecode = True

from generator import bracket, checker, circle_r20, enclosure, pocket, relief, sheet  # noqa: E402

FOLDER = Path(__file__).resolve().parent
PROGRAMS = {
    "bracket.nc": (bracket.program, checker.Expected("laser.settings", arcs=600)),
    "circle_r20.nc": (circle_r20.program, checker.Expected("laser.settings", arcs=3)),
    "enclosure_lightburn.nc": (enclosure.program, checker.Expected("laser.settings", chords_allowed=True)),
    "pocket_fusion.nc": (pocket.program, checker.Expected("mill.settings", arcs=600)),
    "relief_inkscape.nc": (relief.program, checker.Expected("laser.settings", chords_allowed=True)),
    "sheet_8877.nc": (sheet.program, checker.Expected("laser.settings", arcs=200)),
}
DRAWINGS = {"cut/bracket.svg": bracket.drawing, "cut/sheet_8877.svg": sheet.drawing}


def write(name, text, check_only):
    """Writes a file, or compares it with the existing one. Returns the faults."""
    path = FOLDER / name
    if not check_only:
        path.write_bytes(text)
    return [] if path.read_bytes() == text else ["differs from what the generator writes"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare and verify the committed programs; write no file")
    check_only = parser.parse_args().check
    faults = 0
    for name, (program, expected) in PROGRAMS.items():
        text = program(FOLDER / "data").encode()
        found = write(name, text, check_only)
        summary, faults_in_program = checker.check((FOLDER / name).read_bytes().decode(), FOLDER, expected)
        found += faults_in_program
        print(f"{name:24} {summary}")
        for fault in found[:20]:
            print(f"{name}: {fault}", file=sys.stderr)
        faults += len(found)
    for name, drawing in DRAWINGS.items():
        for fault in write(name, drawing(FOLDER / "data").encode(), check_only):
            print(f"{name}: {fault}", file=sys.stderr)
            faults += 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
