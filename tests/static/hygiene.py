"""Fails if a file of the project, committed or new, contains a path of a build machine or a mark
without an owner, or is too large, or if the top level contains an unexpected name.

usage: hygiene.py [root]
"""
import pathlib
import re
import sys
from typing import Iterator

from source_files import ROOT, project_files

# Written in pieces, so that the check does not find this file.
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
