"""Fails when a file that is or would be committed names a path of a build machine, holds a mark
that nobody owns or is too large, or when the top level holds what a newcomer would not expect.

usage: hygiene.py [root]
"""
import pathlib
import re
import sys
from typing import Iterator

from source_files import ROOT, project_files

# Written in pieces, so that this file does not find itself.
MACHINE_PATH = re.compile(r"(?<![\w.}])/(?:work|home|root|tmp/bash_job" + r"s)/")
MARK = re.compile(r"\b(?:TO" + "DO|FIX" + "ME|X" + r"XX)\b")
TOP_LEVEL = {"planner", "hal", "firmware", "host-sim", "tests", "toolchain", "CMakeLists.txt",
             "CMakePresets.json", "docs", "README.md", "ARCHITECTURE.md", "CHANGELOG.md",
             "LICENSE"}
LARGEST_BYTES = 2_000_000


def complaints(root: pathlib.Path) -> Iterator:
    for path in project_files(root):
        name = path.relative_to(root).as_posix()
        top = name.split("/")[0]
        if top not in TOP_LEVEL and not top.startswith("."):
            yield f"{name}: not one of the top level's folders and files"
        if path.stat().st_size > LARGEST_BYTES:
            yield f"{name}: {path.stat().st_size} bytes; generate it or fetch it"
        try:
            lines = path.read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError:
            continue
        for number, line in enumerate(lines, 1):
            if found := MACHINE_PATH.search(line):
                yield f"{name}:{number}: path of a build machine: {found[0]}"
            if found := MARK.search(line):
                yield f"{name}:{number}: {found[0]}: do it, or open an issue"


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT))
    print("\n".join(found) or "hygiene: clean")
    sys.exit(bool(found))
